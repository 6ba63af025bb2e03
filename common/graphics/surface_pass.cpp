#include "common/graphics/surface_pass.hpp"

#include <array>

#include "common/graphics/primitives.hpp"

namespace timestep {
namespace {

constexpr std::array k_kinds{ShapeKind::sphere, ShapeKind::box, ShapeKind::cylinder,
                             ShapeKind::cone};

bool is_opaque(const Color& color) {
  return color.a >= 0.999F;
}

bool is_round(ShapeKind kind) {
  return kind != ShapeKind::box;
}

}  // namespace

SurfacePass::SurfacePass(ResourceManager& resources)
    : resources_(resources),
      shader_(resources.load_shader("surface.vert", "surface.frag")),
      shadow_shader_(resources.load_shader("surface.vert", "shadow.frag")) {
  for (const ShapeKind kind : k_kinds) unit_meshes_.emplace_back(unit_mesh(kind));
}

void SurfacePass::prepare(const DrawList& list) {
  uploaded_.clear();
  groups_.clear();
  for (const bool opaque : {true, false}) {
    for (std::size_t k = 0; k < k_kinds.size(); ++k) {
      const std::size_t first = uploaded_.size();
      for (const ShapeInstance& shape : list.shapes) {
        if (shape.kind != k_kinds[k] || is_opaque(shape.color) != opaque) continue;
        uploaded_.push_back({shape.world_from_shape, shape.color});
      }
      add_group(unit_meshes_[k], opaque, is_round(k_kinds[k]) ? 1 : 0, first);
    }
  }
  for (const MeshInstance& instance : list.meshes) {
    const std::size_t first = uploaded_.size();
    uploaded_.push_back({instance.world_from_mesh, instance.color});
    add_group(resources_.mesh(instance.mesh), is_opaque(instance.color), 0, first);
  }

  glBindBuffer(GL_ARRAY_BUFFER, instances_.id());
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(uploaded_.size() * sizeof(Instance)),
               uploaded_.data(), GL_STREAM_DRAW);
}

void SurfacePass::add_group(const Mesh& mesh, bool opaque, float pattern,
                            std::size_t first) {
  const auto count = static_cast<int>(uploaded_.size() - first);
  if (count > 0) groups_.push_back({&mesh, first, count, opaque, pattern});
}

void SurfacePass::draw_group(const Group& group) const {
  // The mesh's own attributes are in place; these are the instances'
  glBindVertexArray(group.mesh->vertex_array());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.id());
  for (GLuint i = 0; i < 5; ++i) {
    const std::size_t offset = group.first * sizeof(Instance) + i * sizeof(glm::vec4);
    glEnableVertexAttribArray(3 + i);
    glVertexAttribPointer(3 + i, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),

                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(3 + i, 1);
  }
  group.mesh->draw_instanced(group.count);
}

void SurfacePass::draw_shadows(const Frame& frame) const {
  shadow_shader_.set("clip_from_world", frame.light.clip_from_world);
  for (const Group& group : groups_) {
    if (group.opaque) draw_group(group);
  }
}

void SurfacePass::draw(const Frame& frame, bool opaque) const {
  set_lighting(shader_, frame);
  for (const Group& group : groups_) {
    if (group.opaque != opaque) continue;
    shader_.set("pattern", group.pattern);
    draw_group(group);
  }
}

}  // namespace timestep
