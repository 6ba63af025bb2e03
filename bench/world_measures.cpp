#include "bench/world_measures.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <limits>

#include "common/physics/primitives.hpp"
#include "common/physics/sat.hpp"

namespace timestep::world_bench {
namespace {

constexpr double k_no_number = std::numeric_limits<double>::quiet_NaN();

// Moments of inertia [kg m²] about the body's axes
glm::dvec3 moments(const Body& body) {
  if (body.solid.radius > 0)
    return glm::dvec3(0.4 * body.mass * body.solid.radius * body.solid.radius);
  const glm::dvec3 h = body.solid.half_extents, s = h * h;
  return body.mass / 3 * glm::dvec3(s.y + s.z, s.z + s.x, s.x + s.y);
}

// [m] From the centre to the point that is farthest from it
double reach(const Solid& solid) {
  return solid.radius > 0 ? solid.radius : glm::length(solid.half_extents);
}

Shape shape_of(const Solid& solid) {
  if (solid.radius > 0) return Sphere{solid.radius};
  return Box{solid.half_extents};
}

// [m] Negative: they overlap
double distance(const Solid& a, const State& at_a, const Solid& b, const State& at_b) {
  const Pose pose_a{at_a.position, at_a.orientation};
  const Pose pose_b{at_b.position, at_b.orientation};
  if (a.radius == 0 && b.radius == 0)
    return sat(Box{a.half_extents}, pose_a, Box{b.half_extents}, pose_b)
        .separation.distance;
  return closed_form(shape_of(a), pose_a, shape_of(b), pose_b)->distance;
}

double cpu_seconds() {
  return double(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

double energy(const Scene& scene, std::span<const State> states) {
  double sum = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Body& body = scene.bodies[i];
    const State& now = states[i];
    const glm::dvec3 v = now.velocity;
    const glm::dvec3 omega = glm::conjugate(now.orientation) * now.angular_velocity;
    sum += body.mass * (glm::dot(v, v) / 2 - glm::dot(scene.gravity, now.position));
    sum += glm::dot(omega, moments(body) * omega) / 2;
  }
  return sum;
}

Overlaps overlaps(const Scene& scene, std::span<const State> states) {
  Overlaps found;
  for (std::size_t j = 0; j < states.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const Body &a = scene.bodies[i], &b = scene.bodies[j];
      const glm::dvec3 across = states[j].position - states[i].position;
      const double near = reach(a.solid) + reach(b.solid);
      if (glm::dot(across, across) > near * near || a.mass + b.mass == 0) continue;
      const double depth = -distance(a.solid, states[i], b.solid, states[j]);
      if (depth <= 0) continue;
      found.worst = std::max(found.worst, depth);
      found.sum_of_squares += depth * depth;
    }
  return found;
}

Outcome mean_over_time(
    const Engine& engine, const Scene& scene, const Settings& settings, double duration,
    const std::function<double(double t, std::span<const State>)>& measure) {
  const auto steps = std::lround(duration / settings.dt);
  const auto stride = std::max(1L, std::lround(0.01 / settings.dt));
  double sum = 0, seconds = 0;
  long asked = 0, done = 0;
  try {
    const Simulation simulation = engine.make(scene, settings);
    while (done < steps) {
      const double start = cpu_seconds();
      const long next = std::min(steps, done + stride);
      for (; done < next; ++done) simulation.step();
      seconds += cpu_seconds() - start;
      sum += measure(double(done) * settings.dt, simulation.states());
      ++asked;
    }
  } catch (const std::exception&) {
    return {k_no_number, seconds};
  }
  const double mean = sum / double(asked);
  return {std::isfinite(mean) ? mean : k_no_number, seconds};
}

}  // namespace timestep::world_bench
