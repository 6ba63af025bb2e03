// A hundred thousand droplets in linear drag: the throughput scene. Every droplet's
// exact place is known, so speed and error are measured on the same run.
#include <algorithm>
#include <cmath>

#include "chapters/01-particles/emitter.hpp"
#include "chapters/01-particles/parts.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/forces.hpp"
#include "common/physics/particle.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_01 {
namespace {

class Fountain : public Simulation {
 public:
  explicit Fountain(const Setup& setup);

  void step() override {
    const Real t = Real(time());
    method_.step(droplets_, acceleration_, t, Real(setup_.dt));
    ++steps_;
    emit_until(time());
  }

  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return steps_ * method_.evaluations; }
  long long body_count() const override {
    return static_cast<long long>(starts_.size());
  }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;
  CameraPose camera(const CameraPose& usual) const override;

 private:
  double time() const { return static_cast<double>(steps_) * setup_.dt; }
  double interval() const { return lifetime_ / static_cast<double>(starts_.size()); }
  void emit_until(double t);
  exact::Motion exact_of(std::size_t i) const;

  Setup setup_;
  NamedIntegrator method_;
  Acceleration acceleration_;
  double drag_rate_, lifetime_;
  glm::dvec3 g_;
  std::shared_ptr<MeshData> mesh_;
  std::vector<exact::Motion> starts_;  // of each droplet, where it leaves its jet
  std::vector<double> births_;         // when it last left it [s]
  State droplets_;
  long long born_ = 0;  // droplet number j leaves at (j - n + 1) intervals
  long long steps_ = 0;
};

Fountain::Fountain(const Setup& setup)
    : setup_(setup),
      method_(euler_method(setup.method)),
      drag_rate_(setup.parameters.at("drag_rate")),
      lifetime_(setup.parameters.at("lifetime")),
      g_(0, -setup.parameters.at("gravity"), 0) {
  if (lifetime_ < setup.dt)
    throw InputError("lifetime: a droplet must live for at least one step dt");
  const auto n = static_cast<std::size_t>(setup.parameters.at("particles"));
  const double speed = setup.parameters.at("speed");
  if (!setup.mesh.empty()) {
    mesh_ = std::make_shared<MeshData>(stand_on_ground(load_mesh(setup.mesh)));
    starts_ = emit_from_mesh(n, speed / 5, *mesh_);
  } else {
    starts_ = emit_from_jets(n, speed, setup.parameters.at("lean"));
  }

  // The fountain has been running for a lifetime: every droplet is in the air
  droplets_ = particles(n);
  births_.resize(n);
  emit_until(0);

  // (1.1), (1.6), (1.8) with everything divided by the mass, the same for all
  acceleration_ = [g = Vec3(g_), b = Real(drag_rate_)](auto, auto v, Real, auto a) {
    const std::size_t count = v.size() / 3;
    for (std::size_t i = 0; i < count; ++i) put(a, i, g + linear_drag(b, at(v, i)));
  };
}

// Droplets take turns: number j takes the place of number j - n, whose life has ended.
// It starts between two steps, so it is put where it exactly is by now.
void Fountain::emit_until(double t) {
  const auto n = static_cast<long long>(starts_.size());
  for (; static_cast<double>(born_ - n + 1) * interval() <= t; ++born_) {
    const auto i = static_cast<std::size_t>(born_ % n);
    births_[i] = static_cast<double>(born_ - n + 1) * interval();
    const auto [x, v] = exact::linear_drag(starts_[i], g_, drag_rate_, t - births_[i]);
    put(droplets_.x, i, Vec3(x));
    put(droplets_.v, i, Vec3(v));
  }
}

exact::Motion Fountain::exact_of(std::size_t i) const {
  return exact::linear_drag(starts_[i], g_, drag_rate_, time() - births_[i]);
}

std::vector<BodyState> Fountain::bodies() const {
  std::vector<BodyState> all(starts_.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {.name = "droplet-" + std::to_string(i),
              .position = wide(at(droplets_.x, i)),
              .velocity = wide(at(droplets_.v, i))};
  return all;
}

std::vector<Metric> Fountain::metrics() const {
  double sum = 0;
  double largest = 0;
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    const double error = glm::distance(wide(at(droplets_.x, i)), exact_of(i).x);
    sum += error * error;
    largest = std::max(largest, error);
  }

  // NaN compares false and would hide behind the maximum, but not behind the sum
  const double rms = std::sqrt(sum / static_cast<double>(starts_.size()));
  return {{"position_error_rms", "m", rms}, {"position_error_max", "m", largest}};
}

void Fountain::draw(DrawList& list) const {
  constexpr Color k_foam{0.88F, 0.95F, 1, 1};
  constexpr Color k_water{0.02F, 0.33F, 0.66F, 1};
  const Color fast = setup_.lane == 0 ? k_water : setup_.style.color;
  const auto fastest =
      static_cast<float>(std::max(setup_.parameters.at("speed"), 1e-9));
  list.balls.reserve(list.balls.size() + starts_.size());
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    const auto speed = static_cast<float>(glm::length(at(droplets_.v, i)));
    const Color color = glm::mix(k_foam, fast, std::min(speed / fastest, 1.0F));
    const glm::vec3 x = picture(wide(at(droplets_.x, i)));
    if (x.y > 0) list.balls.push_back({x, 0.012F, color});
  }
}

void Fountain::draw_reference(DrawList& list) const {
  if (mesh_) {
    list.meshes.push_back({.mesh = mesh_, .color = k_body});
    return;
  }
  // The basin that the jets stand in
  const glm::mat4 basin = glm::scale(glm::mat4(1), glm::vec3(0.42F, 0.05F, 0.42F));
  list.shapes.push_back({ShapeKind::cylinder, basin, k_body});
}

CameraPose Fountain::camera(const CameraPose& usual) const {
  if (!mesh_) return usual;
  CameraPose closer = usual;
  closer.target.y = 0.8F;
  closer.distance *= 0.7F;
  return closer;
}

}  // namespace

Scene fountain_scene() {
  return {
      .name = "fountain",
      .summary = "100,000 droplets, or your own mesh as the source: throughput",
      .methods = euler_choices(),
      .default_methods = {"semi_implicit_euler"},
      .parameters = {{"particles", "", "in the air", 100'000, 1, 1'000'000, true},
                     {"speed", "m/s", "at the start; a fifth of it from a mesh", 9, 0,
                      1e3},
                     {"lean", "rad", "of the outer jets", 0.3, 0, 1.5},
                     {"gravity", "m/s²", "downwards", 9.81, 0, 1e3},
                     {"drag_rate", "1/s", "c/m in F = -c v", 0.4, 0, 1e6},
                     {"lifetime", "s", "of a droplet", 1.6, 1e-3, 1e3}},
      .takes_mesh = true,
      .duration = 3,
      .camera = {.target = {0, 1.75F, 0},
                 .distance = 7.5F,
                 .yaw = 0.3F,
                 .pitch = 0.14F},
      .start = [](const Setup& setup) { return std::make_unique<Fountain>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_01
