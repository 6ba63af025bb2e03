/// @file
/// The small graphs in the picture's lower right corner.
#pragma once

#include "common/graphics/sheet.hpp"

namespace timestep {

/// Adds the charts, the last one lowest. A series whose name is not in the legend is
/// named in the chart.
void add_charts(const DrawList& list, Sheet& sheet, const Frame& frame);

}  // namespace timestep
