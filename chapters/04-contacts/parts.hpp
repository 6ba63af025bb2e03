/// @file
/// What the scenes of chapter 4 share, and each of them.
#pragma once

#include <span>

#include "chapters/04-contacts/specimen.hpp"
#include "common/chapter/scene.hpp"
#include "common/physics/manifold.hpp"
#include "common/physics/pair_query.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {

Scene step_by_step_scene();
Scene pairs_scene();
Scene mesh_scene();
Scene sweep_scene();

/// Every method of `pair_methods`, as a scene offers it, and the one of that name.
std::vector<Method> all_choices();
const PairMethod& method_named(const std::string& name);

/// The pose that a placement rounds to.
Pose pose_of(const Placement& placement);

// Pictures. Coordinates are those of the physics, y up.

inline constexpr Color k_color_a{0.36F, 0.62F, 0.80F, 1};
inline constexpr Color k_color_b{0.93F, 0.69F, 0.36F, 1};

Color with_alpha(const Color& color, float alpha);

inline glm::vec3 picture(const Vec3& v) {
  return glm::vec3(v);
}

/// Triangles with a flat look.
std::shared_ptr<const MeshData> flat_mesh(std::span<const Vec3> vertices,
                                          std::span<const Triangle> triangles);

/// A hull's faces, and its edges as lines.
std::shared_ptr<const MeshData> hull_mesh(const ConvexHull& hull);
void draw_edges(DrawList& list, const ConvexHull& hull,
                const glm::mat4& world_from_hull, const Color& color);

/// World from body, the body `scale` times as large.
glm::mat4 placed(const glm::vec3& at, const glm::dquat& q, float scale = 1);

void draw_specimen(DrawList& list, const Specimen& specimen,
                   const glm::mat4& world_from_body, const Color& color);

/// Contact points with their chords and the normal.
void draw_manifold(DrawList& list, const Manifold& manifold, const Color& color,
                   float arrow, const glm::vec3& shift = glm::vec3(0));

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
