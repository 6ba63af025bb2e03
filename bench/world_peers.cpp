// world-peers [--quick] PART…: what becomes of scenes in every library, as JSON. Parts
// are stacks, accuracy and simbench.
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/simbench.hpp"
#include "bench/worlds.hpp"
#include "common/physics/exact_sliding.hpp"

namespace timestep::world_bench {
namespace {

using Json = nlohmann::ordered_json;
using States = std::span<const State>;

constexpr double k_no_number = std::numeric_limits<double>::quiet_NaN();
constexpr int k_steps_a_second = 60;

// Those with an ERP once more without it, as METHOD_no_erp/PRECISION
std::vector<Engine> engines_and_without_erp() {
  std::vector<Engine> all;
  for (const Engine& engine : engines()) {
    all.push_back(engine);
    if (!engine.has_erp) continue;
    Engine without = engine;
    without.name.insert(without.name.find('/'), "_no_erp");
    without.make = [make = engine.make](const Scene& scene, Settings settings) {
      settings.erp = 0;
      return make(scene, settings);
    };
    all.push_back(without);
  }
  return all;
}

// [m] How far bodies got, at most and in the mean
struct Ways {
  double longest = 0, mean = 0;
};
Ways ways(States from, States to) {
  Ways found;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double way = glm::distance(from[i].position, to[i].position);
    found.longest = std::max(found.longest, way);
    found.mean += way / double(from.size());
  }
  return found;
}

// Ten seconds of a pile, or a minute of what should stand: that is, no body is half its
// size from its start
Json run_stack(const Engine& engine, const std::string& name, const Scene& scene,
               double scale) {
  const bool is_pile = name == "pile";
  const auto steps_to = [&](double t) { return std::lround(scale * t * 60); };
  const Simulation simulation = engine.make(scene, {});
  const std::vector<State> start = simulation.states();
  std::vector<State> a_second_before;
  Json found;
  double worst = 0;
  for (long i = 1; i <= steps_to(is_pile ? 10 : 60); ++i) {
    simulation.step();
    if (i % 10 == 0 && i <= steps_to(10))
      worst = std::max(worst, overlaps(scene, simulation.states()).worst);
    if (i == steps_to(9)) a_second_before = simulation.states();
    if (i != steps_to(10)) continue;
    const std::vector<State> now = simulation.states();
    found["worst_depth"] = worst;
    found["energy_change"] = energy(scene, now) / energy(scene, start) - 1;
    found["drift"] = is_pile
                         ? ways(a_second_before, now).mean
                         : glm::distance(now.back().position, start.back().position);
  }
  if (!is_pile)
    found["stands"] = ways(start, simulation.states()).longest < 0.5 ? 1 : 0;
  return found;
}

Json stacks(double scale) {
  Json all;
  const std::vector<std::pair<std::string, Scene>> scenes{
      {"column", column()}, {"pyramid", pyramid()}, {"pile", pile()}};
  for (const auto& [name, scene] : scenes)
    for (const Engine& engine : engines()) {
      if (engine.is_for_few && name != "column") continue;
      Json& found = all[fmt::format("stacks/{}/{}", name, engine.name)];
      try {
        found = run_stack(engine, name, scene, scale);
      } catch (const std::exception&) {
        found = {{"stands", 0}};
      }
    }
  return all;
}

// What `measure` says of the end of a scene
double at_end(const Engine& engine, const Scene& scene, double dt, double duration,
              const std::function<double(States start, States end)>& measure) {
  try {
    const Simulation simulation = engine.make(scene, {.dt = dt});
    const std::vector<State> start = simulation.states();
    for (long i = std::lround(duration / dt); i > 0; --i) simulation.step();
    return measure(start, simulation.states());
  } catch (const std::exception&) {
    return k_no_number;
  }
}

double energy_change(const Engine& engine, const Scene& scene, double dt,
                     double duration) {
  return at_end(engine, scene, dt, duration, [&](States start, States end) {
    return energy(scene, end) / energy(scene, start) - 1;
  });
}

double stop_error(const Engine& engine, double scale) {
  const exact::Stop exact =
      exact::cone_stop({k_block_speed, 0}, k_block_friction, 9.81);
  return at_end(engine, sliding_block(), 1.0 / k_steps_a_second, scale * 3,
                [&](States, States end) { return end[1].position.x / exact.x.x - 1; });
}

Json accuracy(double scale) {
  Json all;
  const double dt = 1.0 / k_steps_a_second, duration = scale * 10;
  for (const Engine& engine : engines_and_without_erp()) {
    Json& found = all["accuracy/" + engine.name];
    found["ball_energy"] = energy_change(engine, bouncing_ball(), dt, duration);
    found["stop_error"] = stop_error(engine, scale);
    found["gas_energy_1_ms"] = energy_change(engine, elastic_gas(), 1e-3, duration);
    found["gas_energy_60_Hz"] = energy_change(engine, elastic_gas(), dt, duration);
  }
  return all;
}

void run_simbench(const SimbenchScene& one, const Engine& engine, Json& all) {
  for (const Settings& settings : one.settings) {
    const Outcome outcome =
        mean_over_time(engine, one.scene, settings, one.duration, one.error);
    const std::string varied = one.is_by_iterations
                                   ? fmt::format("{}", settings.iterations)
                                   : fmt::format("{:g}", settings.dt);
    all[fmt::format("simbench/{}/{}/{}", one.name, engine.name, varied)] = {
        {"error", outcome.mean}, {"seconds", outcome.seconds}};
  }
}

Json simbench(bool is_quick) {
  Json all;
  for (const SimbenchScene& one : simbench_scenes(is_quick))
    for (const Engine& engine : engines_and_without_erp())
      if (!engine.is_for_few) run_simbench(one, engine, all);
  return all;
}

}  // namespace
}  // namespace timestep::world_bench

int main(int argc, char** argv) {
  bool is_quick = false;
  nlohmann::ordered_json found = nlohmann::ordered_json::object();
  for (int i = 1; i < argc; ++i) {
    const std::string_view word(argv[i]);
    const double scale = is_quick ? 0.02 : 1;
    if (word == "--quick") {
      is_quick = true;
    } else if (word == "stacks") {
      found.update(timestep::world_bench::stacks(scale));
    } else if (word == "accuracy") {
      found.update(timestep::world_bench::accuracy(scale));
    } else if (word == "simbench") {
      found.update(timestep::world_bench::simbench(is_quick));
    } else {
      fmt::print(stderr, "world-peers: no part '{}' (stacks, accuracy, simbench)\n",
                 word);
      return 2;
    }
  }
  fmt::print("{}\n", found.dump(1));
}
