#include "bench/simbench.hpp"

#include "common/physics/exact_rolling.hpp"

namespace timestep::world_bench {
namespace {

using States = std::span<const State>;

// Squared error of the plate's velocity and, in the mean, of the balls' [m²/s²]
double rolling_error(const glm::dvec3& along, double t, States states) {
  const auto exact = exact::accelerations({.box_mass = k_plate_mass,
                                           .ball_mass = 1,
                                           .balls = k_balls_on_plate,
                                           .force = k_pull,
                                           .mu = k_floor_friction,
                                           .g = 9.81});
  const auto squared = [](const glm::dvec3& v) { return glm::dot(v, v); };
  double of_balls = 0;
  for (const State& ball : states.subspan(2))
    of_balls += squared(ball.velocity - t * exact.ball * along);
  return squared(states[1].velocity - t * exact.box * along)
         + of_balls / k_balls_on_plate;
}

SimbenchScene rolling_scene(const std::string& name, const glm::dvec3& along) {
  return {.name = name,
          .scene = rolling(along),
          .duration = 4,
          .settings = {{.dt = 1e-3, .iterations = 10},
                       {.dt = 1e-3, .iterations = 30},
                       {.dt = 1e-3, .iterations = 100},
                       {.dt = 1e-3, .iterations = 300}},
          .is_by_iterations = true,
          .error = [=](double t, States s) { return rolling_error(along, t, s); }};
}

// Squared error of the energy [J²]
SimbenchScene with_energy(const std::string& name, const Scene& scene, double duration,
                          const std::vector<Settings>& settings) {
  std::vector<State> start;
  for (const Body& body : scene.bodies)
    start.push_back({body.position, body.orientation, body.velocity, {}});
  const double at_start = energy(scene, start);
  const auto error = [=](double, States states) {
    const double change = energy(scene, states) - at_start;
    return change * change;
  };
  return {name, scene, duration, settings, false, error};
}

std::vector<Settings> steps_from(double shortest) {
  std::vector<Settings> all;
  for (const double dt : {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1})
    if (dt >= shortest) all.push_back({.dt = dt});
  return all;
}

}  // namespace

std::vector<SimbenchScene> simbench_scenes(bool is_quick) {
  const glm::dvec3 diagonal = glm::normalize(glm::dvec3(0.5, 0, 0.866));
  const Scene at_rest = six_cubed(0.101, 0);
  const auto overlap = [=](double, States states) {
    return overlaps(at_rest, states).sum_of_squares;
  };
  std::vector<SimbenchScene> all{
      rolling_scene("rolling", {0, 0, 1}),
      rolling_scene("rolling_diagonal", diagonal),
      with_energy("bouncing", bouncing(), 20, steps_from(1e-4)),
      {"666", at_rest, 10, steps_from(1e-3), false, overlap},
      with_energy("elastic_666", six_cubed(1.101, 1), 10, steps_from(1e-3))};
  for (SimbenchScene& scene : all) {
    if (!is_quick) continue;
    scene.duration /= 50;
    for (Settings& settings : scene.settings) settings.dt = 0.01;
    scene.settings.resize(1);
  }
  return all;
}

}  // namespace timestep::world_bench
