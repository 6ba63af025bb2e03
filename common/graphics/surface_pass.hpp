/// @file
/// Draws shapes and meshes, lit, many of a kind in one call.
#pragma once

#include <span>
#include <vector>

#include "common/graphics/frame.hpp"
#include "common/graphics/resource_manager.hpp"

namespace timestep {

/// The draw list's shapes and mesh instances. `prepare` comes first, once a frame.
class SurfacePass {
 public:
  explicit SurfacePass(ResourceManager& resources);

  void prepare(const DrawList& list);

  /// Draws what is opaque into the shadow map that is bound.
  void draw_shadows(const Frame& frame) const;

  /// Draws what is opaque, or what is not.
  void draw(const Frame& frame, bool opaque) const;

 private:
  struct Instance {
    glm::mat4 world_from_mesh;
    Color color;
  };
  /// One mesh and a range of the instances, all opaque or none.
  struct Group {
    const Mesh* mesh;
    std::size_t first;
    int count;
    bool opaque;
    float pattern;
  };

  void add_group(const Mesh& mesh, bool opaque, float pattern, std::size_t first);
  void draw_group(const Group& group) const;

  ResourceManager& resources_;
  const Shader& shader_;
  const Shader& shadow_shader_;
  std::vector<Mesh> unit_meshes_;
  BufferHandle instances_;
  std::vector<Instance> uploaded_;
  std::vector<Group> groups_;
};

}  // namespace timestep
