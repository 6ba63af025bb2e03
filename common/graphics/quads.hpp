/// @file
/// Very many flat squares, or points, in one draw: lines, symbols, letters and balls
/// are all made so.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>

#include "common/graphics/gl_handle.hpp"

namespace timestep {

/// What is drawn for each item: a square, whose corner is attribute 0, from -1 to 1 in
/// both directions, or a point, whose size the shader sets.
enum class ItemForm { square, point };

/// A list of items, plain structs of floats, on the graphics card.
class Quads {
 public:
  /// `floats` numbers of the item from byte `offset` on become attribute `index`. An
  /// offset beyond the item reads the next one.
  struct Attribute {
    GLuint index;
    GLint floats;
    std::size_t offset;
  };

  Quads(std::size_t item_size, std::initializer_list<Attribute> attributes,
        ItemForm form = ItemForm::square);

  /// Copies the items to the graphics card.
  template <class Item>
  void upload(std::span<const Item> items) {
    upload_bytes(std::as_bytes(items));
  }

  /// Draws the first `count` items with the shader that is bound.
  void draw(std::size_t count) const;

 private:
  void upload_bytes(std::span<const std::byte> bytes);

  ItemForm form_;
  VertexArrayHandle array_;
  BufferHandle corners_, items_;
};

}  // namespace timestep
