/// @file
/// The bodies of description.hpp as shapes.
#pragma once

#include <memory>
#include <vector>

#include "chapters/04-contacts/description.hpp"
#include "common/graphics/mesh_data.hpp"
#include "common/physics/convex_hull.hpp"
#include "common/physics/shapes.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {

using specimens::Description;
using specimens::k_half_space;
using specimens::k_kind_help;
using specimens::k_kind_names;
using specimens::k_tetrahedron;
using specimens::k_triangle;
using specimens::Placement;

/// A shape with all that it refers to. Stays where it is.
struct Specimen {
  explicit Specimen(const Description& description);
  Specimen(const Specimen&) = delete;
  Specimen& operator=(const Specimen&) = delete;

  Shape shape;
  std::vector<Vec3> vertices;            ///< of polyhedra and polygons
  ConvexHull hull;                       ///< of polyhedra
  std::shared_ptr<const MeshData> mesh;  ///< of what is no unit shape
};

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
