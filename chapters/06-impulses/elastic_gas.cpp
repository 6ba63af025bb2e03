// Balls in a box that lose nothing: their energy stays, their speeds spread.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/chapter/random.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

constexpr double k_side = 2, k_mass = 1, k_speed = 1;  // [m], [kg], [m/s]

// The picture of the speeds stands beside the box: so many bars, up to so fast
constexpr std::size_t k_bars = 12;
constexpr double k_fastest = 2.4;  // [m/s]
constexpr double k_densest = 1.5;  // [s/m] that the graph shows
constexpr float k_graph_width = 2, k_graph_height = 2;

class ElasticGas : public WorldRun {
 public:
  explicit ElasticGas(const Setup& setup);
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  void add_walls();
  void add_balls();
  void after_step() override;
  std::vector<Metric> own_metrics() const override;
  std::vector<double> speeds() const;
  double speed_spread() const;

  std::size_t count_;
  double energy_ = 0, energy_error_ = 0, worst_energy_error_ = 0;
};

ElasticGas::ElasticGas(const Setup& setup)
    : WorldRun(setup, {.lanes_apart = {0, -3.0F, 0}}),
      count_(static_cast<std::size_t>(parameter("balls"))) {
  add_walls();
  add_balls();
}

void ElasticGas::add_walls() {
  for (const int side : {-1, 1}) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      Vec3 inward(0);
      inward[axis] = Real(-side);
      RigidBody wall;
      wall.position = Real(-k_side / 2) * inward;
      Collider collider = floor_collider(0, 0);
      collider.shape = HalfSpace{inward, 0};
      add("wall", wall, collider, k_body);
    }
  }
}

// On a grid, all equally fast, each in a direction of its own
void ElasticGas::add_balls() {
  const double radius = parameter("radius");
  const int rows =
      static_cast<int>(std::ceil(std::cbrt(static_cast<double>(count_)) - 1e-9));
  const double apart = k_side / rows;
  if (2 * radius >= apart)
    throw InputError(
        fmt::format("--set balls={} radius={:g}: they do not fit", count_, radius));
  Random random(static_cast<std::uint64_t>(parameter("seed")));
  for (std::size_t i = 0; i < count_; ++i) {
    const int n = static_cast<int>(i);
    const glm::dvec3 cell(n % rows, n / rows % rows, n / rows / rows);
    RigidBody body =
        ball_body(k_mass, radius, apart * (cell + 0.5) - glm::dvec3(k_side / 2));
    const double z = random.uniform(-1, 1);
    const double turn = random.uniform(0, 2 * std::numbers::pi);
    const double across = std::sqrt(1 - z * z);
    body.velocity =
        Vec3(k_speed * glm::dvec3(across * std::cos(turn), across * std::sin(turn), z));
    add(fmt::format("ball {}", i + 1), body,
        ball_collider(radius, parameter("friction"), parameter("restitution")),
        body_color(0));
  }
}

std::vector<double> ElasticGas::speeds() const {
  std::vector<double> all;
  for (const RigidBody& body : world().bodies)
    if (body.inverse_mass > 0) all.push_back(glm::length(glm::dvec3(body.velocity)));
  return all;
}

// Mean of the fourth powers, over the square of the mean of the squares: 1 if all are
// equally fast
double ElasticGas::speed_spread() const {
  double squares = 0, fourths = 0;
  for (const double v : speeds()) {
    squares += v * v;
    fourths += v * v * v * v;
  }
  return fourths * static_cast<double>(count_) / (squares * squares);
}

void ElasticGas::after_step() {
  const double energy = energy_of(world());
  if (steps() == 0) energy_ = energy;
  energy_error_ = std::abs(energy - energy_) / energy_;
  worst_energy_error_ = std::max(worst_energy_error_, energy_error_);
}

// Any direction of the vector of all velocities is as likely: a point on a sphere in 3n
// dimensions
std::vector<Metric> ElasticGas::own_metrics() const {
  const double n = static_cast<double>(count_);
  return {{"energy_error", "", energy_error_},
          {"energy_error_max", "", worst_energy_error_},
          {"speed_spread", "", speed_spread()},
          {"speed_spread_exact", "", 5 * n / (3 * n + 2)}};
}

// Where a share of balls per m/s stands in the graph
glm::vec3 in_graph(double speed, double density) {
  return {1.4F + k_graph_width * static_cast<float>(speed / k_fastest),
          -1 + k_graph_height * static_cast<float>(density / k_densest), 0};
}

void ElasticGas::draw(DrawList& list) const {
  WorldRun::draw(list);
  std::array<double, k_bars> bars{};
  const double width = k_fastest / k_bars;
  for (const double v : speeds())
    bars[std::min(static_cast<std::size_t>(v / width), k_bars - 1)] +=
        1 / (width * static_cast<double>(count_));
  for (std::size_t i = 0; i < k_bars; ++i) {
    const glm::vec3 low = in_graph(static_cast<double>(i) * width, 0);
    const glm::vec3 high =
        in_graph((static_cast<double>(i) + 0.9) * width, std::min(bars[i], k_densest));
    glm::mat4 bar(1);
    bar[0].x = (high.x - low.x) / 2;
    bar[1].y = std::max(high.y - low.y, 0.002F) / 2;
    bar[2].z = 0.02F;
    bar[3] = glm::vec4((low + high) / 2.0F, 1);
    list.shapes.push_back({ShapeKind::box, bar, setup().style.color});
  }
}

// The box, and the distribution of Maxwell
void ElasticGas::draw_reference(DrawList& list) const {
  const float h = static_cast<float>(k_side / 2);
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    for (const float a : {-h, h}) {
      for (const float b : {-h, h}) {
        glm::vec3 from(0), to(0);
        from[axis] = -h;
        to[axis] = h;
        from[(axis + 1) % 3] = to[(axis + 1) % 3] = a;
        from[(axis + 2) % 3] = to[(axis + 2) % 3] = b;
        list.lines.push_back({.points = {from, to}, .color = k_muted, .width = 2});
      }
    }
  }
  std::vector<glm::vec3> curve;
  const double variance = k_speed * k_speed / 3;  // of each coordinate
  for (int i = 0; i <= 60; ++i) {
    const double v = k_fastest * i / 60;
    curve.push_back(
        in_graph(v, std::sqrt(2 / std::numbers::pi) * v * v / std::pow(variance, 1.5)
                        * std::exp(-v * v / (2 * variance))));
  }
  list.lines.push_back({.points = curve, .color = k_ink, .width = 3});
  list.lines.push_back(
      {.points = {in_graph(0, 0), in_graph(k_fastest, 0)}, .color = k_ink, .width = 2});
  list.labels.push_back({in_graph(0.3 * k_fastest, -0.14), "speed", k_ink});
  list.legend.push_back({reference_style(), "Maxwell"});
  list.ground_height.reset();
}

}  // namespace

Scene elastic_gas_scene() {
  return {
      .name = "elastic-gas",
      .summary = "balls in a box that lose no energy, and how their speeds spread",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = with_settings(
          {{"balls", "", "how many", 125, 2, 8000, true},
           {"radius", "m", "of the balls, in a box of 2 m", 0.08, 1e-6, 0.5},
           {"restitution", "", "of the balls, and at the walls", 1, 0, 1},
           {"friction", "", "of the balls among each other", 0, 0, 100},
           {"seed", "", "of the directions at the start", 1, 0, 1e9, true}},
          0),
      .dt = 0.001,
      .duration = 6,
      .camera = {.target = {1.15F, -0.05F, 0},
                 .distance = 4.4F,
                 .yaw = 0.2F,
                 .pitch = 0.15F},
      .chart_metric = "energy_error",
      .start = [](const Setup& setup) { return std::make_unique<ElasticGas>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
