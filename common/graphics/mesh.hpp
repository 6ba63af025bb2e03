/// @file
/// A triangle mesh on the graphics card.
#pragma once

#include "common/graphics/gl_handle.hpp"
#include "common/graphics/mesh_data.hpp"

namespace timestep {

/// Vertex attributes: 0 position, 1 normal, 2 texture coordinates. A mesh without
/// normals gets smooth ones, weighted by area. Attributes from 3 on are free for
/// instances.
class Mesh {
 public:
  explicit Mesh(const MeshData& data);

  void draw() const;

  /// Draws `count` instances; the caller has bound what the shader reads for each.
  void draw_instanced(int count) const;

  /// For attaching instance attributes.
  GLuint vertex_array() const { return array_.id(); }

 private:
  VertexArrayHandle array_;
  BufferHandle vertices_, indices_;
  GLsizei index_count_;
};

}  // namespace timestep
