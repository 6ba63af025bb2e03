/// @file
/// What the scenes of chapter 5 share, and each of them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "chapters/05-penetration/overlap.hpp"
#include "common/chapter/scene.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {

Scene overlap_recovery_scene();
Scene feather_and_ball_scene();
Scene tilted_plank_scene();
Scene corner_scene();

/// Every way out, as a scene offers it, and their names.
std::vector<Method> all_choices();
std::vector<std::string> all_names();

/// Parameters that all scenes have, with defaults as the scene needs them.
struct Defaults {
  int iterations;
  double slop;     ///< [m]
  double gravity;  ///< [m/s²]
};
std::vector<Parameter> with_settings(std::vector<Parameter> own,
                                     const Defaults& defaults);

/// A place that a body should come to.
struct Place {
  glm::dvec3 position{0};
  glm::dquat orientation{1, 0, 0, 0};
};

/// Bodies that start inside of each other, and one way out.
class OverlapRun : public Simulation {
 public:
  void step() final;
  void observe() final;
  std::vector<BodyState> bodies() const final;
  std::vector<Metric> metrics() const final;
  long long evaluations() const final { return solved_; }
  long long body_count() const final { return static_cast<long long>(moving_.size()); }
  void draw(DrawList& list) const override;
  CameraPose camera(const CameraPose& usual) const override;

 protected:
  /// Lanes stand so far apart in the picture, in sizes, so many in a row. The method's
  /// symbol is at `mark`.
  struct Lanes {
    glm::vec2 apart;
    std::size_t columns;
    glm::vec3 mark;
  };
  OverlapRun(const Setup& setup, const Lanes& lanes);

  /// Adds a body of even density, with the place that is right for it.
  void add_body(const char* name, RigidBody body, const Shape& shape,
                const Place& right);

  /// Adds what stays where it is.
  void add_wall(const Vec3& normal, double offset);

  /// What the scene keeps track of, and measures, besides.
  virtual void watch() {}
  virtual void add_metrics(std::vector<Metric>&) const {}

  double parameter(const char* name) const { return setup_.parameters.at(name); }
  double size() const { return parameter("size"); }
  double origin() const { return parameter("origin"); }
  const RigidBody& body(std::size_t moving) const {
    return overlap_.bodies[moving_[moving].body];
  }
  const Place& start_of(std::size_t moving) const { return moving_[moving].start; }

  /// Where the physics' [m] is in the picture, whose unit is the scene's size.
  glm::vec3 picture(const glm::dvec3& p) const;
  const Style& style() const { return setup_.style; }

 private:
  struct Moving {
    std::string name;
    std::size_t body;
    Place start, right;
  };
  double off_place(const glm::dvec3& across) const;
  double off_angle() const;
  std::size_t columns() const { return std::min(lanes_.columns, setup_.lanes); }
  void draw_shape(DrawList& list, const Moving& moving) const;

  Setup setup_;
  Lanes lanes_;
  PenetrationStep way_out_;
  Overlap overlap_;
  std::vector<Moving> moving_;
  long long solved_ = 0;
  bool is_observed_ = false;
  double penetration_ = 0, penetration_start_ = 0, energy_start_ = 0;
  double kinetic_max_ = 0, speed_max_ = 0;
};

/// A solid of this shape, a ball or a box, at rest.
RigidBody solid(double mass, const Shape& shape, const Place& place);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
