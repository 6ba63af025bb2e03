/// @file
/// A simulation of a world of bodies: what all scenes of chapter 6 are.
#pragma once

#include <string>
#include <vector>

#include "chapters/06-impulses/parts.hpp"
#include "common/chapter/trail.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {

/// How a scene's worlds look. Lengths in m of the picture.
struct View {
  float scale = 1;                ///< [m/m] of the picture to the world
  glm::vec3 lanes_apart{0};       ///< between the worlds of methods side by side
  float force = 0;                ///< [m/N] length of the arrows of contact forces
  float impulse = 0;              ///< [m/(N s)] of what impacts do to bodies
  float normal = 0;               ///< length of the contact normals
  bool trails = false;            ///< of the centres of mass
  bool rings = false;             ///< around balls, to see them turn
  bool contacts_as_dots = false;  ///< where bodies touch
};

/// One method's world. A scene derives from it, adds bodies in its constructor, and
/// says what it measures.
class WorldRun : public Simulation {
 public:
  void step() final;
  void observe() final;
  std::vector<BodyState> bodies() const final;
  std::vector<Metric> metrics() const final;
  long long evaluations() const final {
    return world_.room.solved + world_.penetration_room.solved;
  }
  long long body_count() const final;
  void draw(DrawList& list) const override;
  CameraPose camera(const CameraPose& usual) const override;

 protected:
  WorldRun(const Setup& setup, const View& view);

  /// A body of the world, at the origin's distance. Throws InputError for what the
  /// world refuses. Static bodies are no part of bodies(); half-spaces are not drawn.
  BodyHandle add(const std::string& name, RigidBody body, const Collider& collider,
                 const Color& color);

  /// What is measured, the headline first, before what every world has: energy, the
  /// most of it that came from nothing, momentum, penetration, the fastest point.
  virtual std::vector<Metric> own_metrics() const = 0;

  /// Forces that act in the coming step, which is the steps()-th.
  virtual void before_step() {}

  /// Whether those put energy in, which then is not gained from nothing.
  virtual bool is_driven() const { return false; }

  /// At the start and after every step.
  virtual void after_step() {}

  const Setup& setup() const { return setup_; }
  double parameter(const char* name) const { return setup_.parameters.at(name); }
  World& world() { return world_; }
  const World& world() const { return world_; }
  long long steps() const { return steps_; }
  double time() const { return static_cast<double>(steps_) * setup_.dt; }

  /// What the impulses of the world's contacts acted for: a step or a substep [s].
  double impulse_time() const;

  /// [m/s] No point of a body is faster than this.
  double fastest() const;

  /// World frame without the origin's distance [m].
  glm::dvec3 place(const RigidBody& body) const;

  /// Where that is in this method's picture.
  glm::vec3 picture(const glm::dvec3& place) const;

 private:
  struct Seen {
    std::string name;
    std::uint32_t body;
    Shape shape;
    float reach;  // [m] of its farthest point from the centre of mass
    Color color;
    Trail trail{};
    glm::dvec3 free_velocity{0};  // [m/s] after a step without contacts
    glm::dvec3 impulse{0};        // [N s] of all impacts in the last step with some
    double hit_at = -1;           // [s] at its end
  };

  void foresee();
  void note_impacts();
  void draw_body(DrawList& list, const Seen& seen) const;
  void draw_contacts(DrawList& list) const;

  Setup setup_;
  View view_;
  World world_;
  glm::dvec3 origin_;
  std::vector<Seen> seen_;
  long long steps_ = 0;

  // Looked at after each step, as things then are
  ContactSearch search_;
  std::vector<PointContact> touching_;
  double penetration_ = 0, worst_penetration_ = 0;
  double lowest_energy_ = 0, energy_gained_ = 0;
};

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
