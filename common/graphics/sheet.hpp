/// @file
/// Flat drawing on top of the picture. Places in pixels from the top left corner.
#pragma once

#include "common/graphics/line_batch.hpp"
#include "common/graphics/symbol_batch.hpp"
#include "common/graphics/text_batch.hpp"

namespace timestep {

/// Panels below lines, lines below markers, markers below text.
struct Sheet {
  explicit Sheet(ResourceManager& resources)
      : panels(resources), lines(resources), markers(resources), text(resources) {}

  void clear() {
    panels.clear();
    lines.clear();
    markers.clear();
    text.clear();
  }

  void draw(const Frame& frame) {
    panels.draw(frame);
    lines.draw(frame);
    markers.draw(frame);
    text.draw(frame);
  }

  SymbolBatch panels;
  LineBatch lines;
  SymbolBatch markers;
  TextBatch text;
};

}  // namespace timestep
