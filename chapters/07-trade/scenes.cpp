// Each trade as a scene: its choices are the methods, side by side.
#include "chapters/07-trade/scenes.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "chapters/07-trade/trade_run.hpp"
#include "common/chapter/numbers.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_07 {
namespace {

// "rk4, 50 steps a frame, stiffness = 1e+06"
std::string summary_of(const Option& option) {
  const int n = option.steps_per_frame;
  std::string text =
      fmt::format("{}, {} {} a frame", option.method, n, n == 1 ? "step" : "steps");
  for (const auto& [name, value] : option.settings)
    text += fmt::format(", {} = {}", name, plain_text(value));
  return text;
}

std::vector<Method> methods_of(const Trade& trade) {
  std::vector<Method> all;
  for (const Option& option : trade.options)
    all.push_back(
        {option.name, summary_of(option), method_style(static_cast<int>(all.size()))});
  return all;
}

// Those of the earlier scene that are offered here, as the trade sets them
std::vector<Parameter> parameters_of(const Trade& trade, const Scene& earlier) {
  std::vector<Parameter> all;
  for (Parameter p : earlier.parameters) {
    if (std::ranges::find(trade.parameters, p.name) == trade.parameters.end()) continue;
    const auto set = trade.settings.find(p.name);
    if (set != trade.settings.end()) p.value = set->second;
    all.push_back(p);
  }
  return all;
}

Scene scene_of(const Trade& trade) {
  const Scene earlier = earlier_scene(trade);
  const std::vector<Method> methods = methods_of(trade);
  std::vector<std::string> names;
  for (const Method& method : methods) names.push_back(method.name);
  return {
      .name = trade.name,
      .summary = trade.summary,
      .methods = methods,
      .default_methods = names,
      .parameters = parameters_of(trade, earlier),
      .dt = trade.frame,
      .duration = trade.duration,
      .camera = earlier.camera,
      .chart_metric = "error_over_limit",
      .chart_logarithmic = true,
      .start =
          [&trade](const Setup& setup) {
            return std::make_unique<TradeRun>(trade, setup);
          },
  };
}

}  // namespace

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (const Trade& trade : trades()) all.push_back(scene_of(trade));
  return all;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_07
