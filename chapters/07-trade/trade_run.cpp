#include "chapters/07-trade/trade_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "chapters/02-verlet/scenes.hpp"
#include "chapters/06-impulses/scenes.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_07 {
namespace {

// Of a list whose elements have names; the table of choices must not name another
const auto& named(const auto& list, const std::string& name) {
  const auto found =
      std::ranges::find_if(list, [&](const auto& each) { return each.name == name; });
  if (found == list.end())
    throw std::logic_error(fmt::format("the choices name {}, which is not", name));
  return *found;
}

std::vector<Scene> scenes_of(const std::string& chapter) {
  if (chapter == "02-verlet") return chapter_02::scenes();
  if (chapter == "06-impulses") return chapter_06::scenes();
  throw std::logic_error(fmt::format("no scenes of {} are linked", chapter));
}

}  // namespace

Scene earlier_scene(const Trade& trade) {
  return named(scenes_of(trade.chapter), trade.earlier);
}

Setup earlier_setup(const Trade& trade, const Scene& earlier, const Setup& setup) {
  const Option& option = named(trade.options, setup.method);
  Setup inner = setup;
  inner.method = named(earlier.methods, option.method).name;
  inner.dt = setup.dt / option.steps_per_frame;

  inner.parameters.clear();
  for (const Parameter& p : earlier.parameters) inner.parameters[p.name] = p.value;
  for (const Settings* settings :
       {&trade.settings, &option.settings, &setup.parameters})
    for (const auto& [name, value] : *settings) inner.parameters.at(name) = value;
  return inner;
}

TradeRun::TradeRun(const Trade& trade, const Setup& setup)
    : trade_(trade),
      steps_per_frame_(named(trade.options, setup.method).steps_per_frame) {
  const Scene earlier = earlier_scene(trade);
  run_ = earlier.start(earlier_setup(trade, earlier, setup));
}

void TradeRun::step() {
  for (int i = 0; i < steps_per_frame_; ++i) run_->step();
}

std::vector<Metric> TradeRun::metrics() const {
  const std::vector<Metric> earlier = run_->metrics();
  double share = 0;
  for (const Wish& wish : trade_.wishes)
    share = std::max(share, std::abs(named(earlier, wish.metric).value) / wish.limit);

  std::vector<Metric> all{
      {"error_over_limit", "", share},
      {"steps_per_frame", "", static_cast<double>(steps_per_frame_)}};
  all.insert(all.end(), earlier.begin(), earlier.end());
  return all;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_07
