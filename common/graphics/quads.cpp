#include "common/graphics/quads.hpp"

#include <array>

namespace timestep {

Quads::Quads(std::size_t item_size, std::initializer_list<Attribute> attributes,
             ItemForm form)
    : form_(form) {
  constexpr std::array<float, 8> corners{-1, -1, 1, -1, -1, 1, 1, 1};
  glBindVertexArray(array_.id());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
  glBufferData(GL_ARRAY_BUFFER, sizeof(corners), corners.data(), GL_STATIC_DRAW);
  if (form == ItemForm::square) glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);

  glBindBuffer(GL_ARRAY_BUFFER, items_.id());
  for (const auto& [index, floats, offset] : attributes) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, floats, GL_FLOAT, GL_FALSE,
                          static_cast<GLsizei>(item_size),

                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(index, form == ItemForm::square ? 1 : 0);
  }
  glBindVertexArray(0);
}

void Quads::upload_bytes(std::span<const std::byte> bytes) {
  glBindBuffer(GL_ARRAY_BUFFER, items_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
               GL_STREAM_DRAW);
}

void Quads::draw(std::size_t count) const {
  if (count == 0) return;
  glBindVertexArray(array_.id());
  if (form_ == ItemForm::square) {
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
  } else {
    glEnable(GL_PROGRAM_POINT_SIZE);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
  }
}

}  // namespace timestep
