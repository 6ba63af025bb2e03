// Google Benchmark's own command line over stacks/SCENE/METHOD/PRECISION: the mean time
// of a step in a scene's first five seconds. With --quick in front, in its first tenth.
#include <algorithm>
#include <string_view>

#include <benchmark/benchmark.h>

#include "bench/worlds.hpp"

namespace timestep::world_bench {
namespace {

void add(const std::string& scene_name, const Scene& scene, int steps) {
  for (const Engine& engine : engines()) {
    if (engine.is_for_few && scene_name != "column") continue;
    const auto measure = [=](benchmark::State& run) {
      for ([[maybe_unused]] auto _ : run) {
        run.PauseTiming();
        const Simulation simulation = engine.make(scene, {});
        run.ResumeTiming();
        for (int i = 0; i < steps; ++i) simulation.step();
      }
      run.SetItemsProcessed(run.iterations() * steps);
    };
    benchmark::RegisterBenchmark(("stacks/" + scene_name + "/" + engine.name).c_str(),
                                 measure);
  }
}

}  // namespace
}  // namespace timestep::world_bench

int main(int argc, char** argv) {
  const bool is_quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  const int steps = is_quick ? 6 : 300;
  if (is_quick) std::rotate(argv + 1, argv + 2, argv + argc);
  argc -= is_quick;
  using namespace timestep::world_bench;
  add("column", column(), steps);
  add("pyramid", pyramid(), steps);
  add("pile", pile(), steps);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
