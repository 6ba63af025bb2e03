/// @file
/// What a run looks like: the scene of every method drawn over each other, and the
/// words and the graph around it.
#pragma once

#include <span>

#include "common/chapter/metric_log.hpp"
#include "common/chapter/runner.hpp"
#include "common/graphics/draw_list.hpp"

namespace timestep {

/// Each method's drawing, and the reference of the first one. A method that failed is
/// not drawn, nor is anything farther from the origin than a float can show well (1e9
/// m).
DrawList draw_scene(std::span<const Lane> lanes);

/// Adds title, caption (time, step, precision, each method's headline metric), legend,
/// and the graph of `metric` unless it is empty.
void add_words(DrawList& list, const Plan& plan, std::span<const Lane> lanes,
               double time);
void add_chart(DrawList& list, const MetricLog& log, const std::string& metric,
               bool logarithmic);

}  // namespace timestep
