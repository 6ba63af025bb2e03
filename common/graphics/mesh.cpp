#include "common/graphics/mesh.hpp"

namespace timestep {
namespace {

struct Vertex {
  glm::vec3 position, normal;
  glm::vec2 texture_coordinates;
};

/// Each vertex's normal as the mean of its triangles', weighted by their areas.
std::vector<glm::vec3> smooth_normals(const MeshData& data) {
  std::vector<glm::vec3> normals(data.positions.size(), glm::vec3(0));
  for (const auto& [a, b, c] : data.triangles) {
    const glm::vec3 p = data.positions[a];
    const glm::vec3 doubled = glm::cross(data.positions[b] - p, data.positions[c] - p);
    for (const std::uint32_t corner : {a, b, c}) normals[corner] += doubled;
  }
  for (glm::vec3& n : normals) {
    const float length = glm::length(n);
    n = length > 0 ? n / length : glm::vec3(0, 1, 0);
  }
  return normals;
}

std::vector<Vertex> interleave(const MeshData& data) {
  const std::vector<glm::vec3> normals =
      data.normals.empty() ? smooth_normals(data) : data.normals;
  std::vector<Vertex> vertices(data.positions.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i] = {data.positions[i], normals[i], glm::vec2(0)};
    if (!data.texture_coordinates.empty()) {
      vertices[i].texture_coordinates = data.texture_coordinates[i];
    }
  }
  return vertices;
}

void attribute(GLuint index, GLint size, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(Vertex),

                        reinterpret_cast<const void*>(offset));
}

}  // namespace

Mesh::Mesh(const MeshData& data)
    : index_count_(static_cast<GLsizei>(data.triangles.size() * 3)) {
  const std::vector<Vertex> vertices = interleave(data);
  glBindVertexArray(array_.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
               vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(data.triangles.size() * 3 * sizeof(GLuint)),
               data.triangles.data(), GL_STATIC_DRAW);
  attribute(0, 3, offsetof(Vertex, position));
  attribute(1, 3, offsetof(Vertex, normal));
  attribute(2, 2, offsetof(Vertex, texture_coordinates));
  glBindVertexArray(0);
}

void Mesh::draw() const {
  glBindVertexArray(array_.id());
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void Mesh::draw_instanced(int count) const {
  glBindVertexArray(array_.id());
  glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr, count);
}

}  // namespace timestep
