/// @file
/// The words on a picture: title, caption, legend and the labels of things.
#pragma once

#include "common/graphics/sheet.hpp"

namespace timestep {

/// Title and caption, from the top left corner down.
void add_title(const DrawList& list, Sheet& sheet, const Frame& frame);

/// The legend's panel in the top right corner.
void add_legend(const std::vector<LegendEntry>& legend, Sheet& sheet,
                const Frame& frame);

/// Each label beside its place, where it covers no other label if it can.
void add_labels(const std::vector<Label>& labels, Sheet& sheet, const Frame& frame);

/// A style's line with its marker on it, from `left` on, as legends show it.
void add_sample(const Style& style, glm::vec2 left, float length, Sheet& sheet,
                const Frame& frame);

}  // namespace timestep
