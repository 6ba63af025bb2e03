/// @file
/// A mesh file as a rigid body: checked, weighed, and turned to its principal axes.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "common/graphics/mesh_data.hpp"
#include "common/physics/mass_properties.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {

/// The body's frame has its origin in the centre of mass and its axes along the
/// principal axes, the least moment first.
struct SolidMesh {
  std::shared_ptr<const MeshData> mesh;  ///< in the body's frame [m]
  MassProperties properties;             ///< in the file's frame
  Vec3 moments;                          ///< about the body's axes [kg m²]
  Quat file_from_body;                   ///< of length one
  std::vector<std::string> notices;      ///< what was mended: a line each
};

/// Reads a mesh that fills a solid of even density [kg/m³]; a file that is not there is
/// looked for among the assets' meshes. With `fix_winding`, one that is inside out is
/// turned. Throws InputError, in one line that names the file and the fault, as
/// `load_mesh` does, for any `mesh_fault`, and for a body so small, large or thin that
/// its moments leave the range of Real.
SolidMesh load_solid(const std::filesystem::path& file, double density,
                     bool fix_winding);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
