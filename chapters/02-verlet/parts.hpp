/// @file
/// What the scenes of chapter 2 share, and each of them.
#pragma once

#include <initializer_list>
#include <memory>
#include <string_view>
#include <vector>

#include "common/chapter/scene.hpp"
#include "common/physics/scheme.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_02 {

Scene oscillator_scene();
Scene damped_oscillator_scene();
Scene stiff_spring_scene();
Scene pendulum_scene();
Scene orbit_scene();
Scene double_pendulum_scene();
Scene rope_scene();

/// Dormand and Prince's method with a step that it chooses itself, as a scene offers
/// it.
inline constexpr std::string_view k_adaptive = "dormand_prince";

/// Methods by name as a scene offers them; each looks the same in every scene.
std::vector<Method> choices(std::initializer_list<std::string_view> names);

/// Every scheme for forces without velocity, and the adaptive method.
std::vector<Method> all_choices();

/// The parameter that the adaptive method follows.
Parameter tolerance_parameter();

/// A simulation that moves one state by one scheme, or by the adaptive method.
class SchemeRun : public Simulation {
 public:
  void step() override;
  long long evaluations() const override { return evaluations_; }
  long long body_count() const override { return 1; }

 protected:
  /// `time_lapse`: seconds of the system in a second of the scene.
  SchemeRun(const Setup& setup, const Acceleration& acceleration, const State& start,
            double time_lapse = 1);

  const Setup& setup() const { return setup_; }
  bool is_adaptive() const { return setup_.method == k_adaptive; }
  const Scheme& scheme() const { return integration_.scheme; }
  Integration& integration() { return integration_; }

  /// Seconds of the system since the start, and in a step.
  double time() const { return static_cast<double>(integration_.steps) * dt_; }
  double dt() const { return dt_; }

  /// x and v now, whatever the scheme keeps; and what it keeps.
  State now() const { return read(integration_); }
  const State& kept() const { return integration_.state; }

 private:
  Setup setup_;
  double dt_;
  std::shared_ptr<long long> calls_ = std::make_shared<long long>(0);
  Integration integration_;
  long long evaluations_ = 0;
};

/// Vectors of a picture and of a file from those of the physics.
inline glm::vec3 picture(const glm::dvec3& v) {
  return glm::vec3(v);
}
inline glm::dvec3 wide(const Vec3& v) {
  return glm::dvec3(v);
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_02
