// A break: one ball into a rack that is its own mirror image, on a table with cushions.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

// A table of nine feet, balls of pool [m], [kg]. World frame: x along the table, from
// its middle, y up from the cloth
constexpr double k_length = 2.54, k_width = 1.27, k_radius = 0.028575, k_mass = 0.17;
constexpr double k_rail = 0.06;
constexpr Color k_wood{0.50F, 0.36F, 0.26F, 1}, k_cloth{0.35F, 0.60F, 0.47F, 1};

class Billiards : public WorldRun {
 public:
  explicit Billiards(const Setup& setup);
  void draw_reference(DrawList& list) const override;

 private:
  void add_table();
  BodyHandle add_ball(const std::string& name, const glm::dvec2& at,
                      const Color& color);
  void add_rack();
  void after_step() override;
  std::vector<Metric> own_metrics() const override;
  double asymmetry() const;
  double balls_off() const;

  BodyHandle cue_{};
  // Those that start as mirror images; a ball on the line is its own
  std::vector<std::pair<BodyHandle, BodyHandle>> mirrored_;
  double energy_ = 0, worst_asymmetry_ = 0;
};

Billiards::Billiards(const Setup& setup)
    : WorldRun(setup, {.lanes_apart = {0, 0, -2.0F}, .trails = true}) {
  add_table();
  cue_ = add_ball("cue ball", {-k_length / 4, parameter("aside")}, k_paper);
  body_of(world(), cue_).velocity.x = Real(parameter("speed"));
  mirrored_.emplace_back(cue_, cue_);
  add_rack();
}

// The cloth and four cushions. Friction at a contact is the geometric mean of both
void Billiards::add_table() {
  const double mu = parameter("friction");
  Collider cloth = floor_collider(mu, 0);
  cloth.rolling_friction = Real(parameter("rolling"));
  add("cloth", RigidBody{}, cloth, k_cloth);
  for (const double side : {-1.0, 1.0}) {
    const glm::dvec3 along(k_length + 4 * k_radius, 2 * k_rail, k_rail);
    const glm::dvec3 across(k_rail, 2 * k_rail, k_width);
    const double z = side * (k_width + k_rail) / 2, x = side * (k_length + k_rail) / 2;
    RigidBody rail, end;
    rail.position = Vec3(0, 0, Real(z));
    end.position = Vec3(Real(x), 0, 0);
    add("rail", rail, box_collider(along, mu, 0), k_wood);
    add("end", end, box_collider(across, mu, 0), k_wood);
  }
}

BodyHandle Billiards::add_ball(const std::string& name, const glm::dvec2& at,
                               const Color& color) {
  return add(name, ball_body(k_mass, k_radius, {at.x, k_radius, at.y}),
             ball_collider(k_radius, parameter("friction"), parameter("restitution")),
             color);
}

// Rows across the table, each as far behind the one before as balls that touch are
void Billiards::add_rack() {
  const double apart = 2 * k_radius + parameter("gap");
  for (int row = 0; row < static_cast<int>(parameter("rows")); ++row) {
    std::vector<BodyHandle> balls;
    for (int i = 0; i <= row; ++i) {
      const glm::dvec2 at(k_length / 4 + row * apart * std::sqrt(0.75),
                          apart * (i - row / 2.0));
      const auto turn = static_cast<std::size_t>(row + 2 * i);
      balls.push_back(add_ball(fmt::format("ball {}", row * (row + 1) / 2 + i + 1), at,
                               body_color(turn % 3)));
    }
    for (std::size_t i = 0; 2 * i <= balls.size() - 1; ++i)
      mirrored_.emplace_back(balls[i], balls[balls.size() - 1 - i]);
  }
}

// [m] How far a ball is at most from where its mirror image should be
double Billiards::asymmetry() const {
  double most = 0;
  for (const auto& [left, right] : mirrored_) {
    const glm::dvec3 a = place(body_of(world(), left));
    const glm::dvec3 b = place(body_of(world(), right));
    most = std::max(most, glm::distance(a, glm::dvec3(b.x, b.y, -b.z)));
  }
  return most;
}

// How many balls are neither on the cloth nor above it
double Billiards::balls_off() const {
  int count = 0;
  for (const RigidBody& body : world().bodies) {
    if (body.inverse_mass == 0) continue;
    const glm::dvec3 at = place(body);
    if (std::abs(at.x) > k_length / 2 || std::abs(at.z) > k_width / 2 || at.y < 0)
      ++count;
  }
  return count;
}

void Billiards::after_step() {
  if (steps() == 0) energy_ = kinetic_energy_of(world());
  worst_asymmetry_ = std::max(worst_asymmetry_, asymmetry());
}

std::vector<Metric> Billiards::own_metrics() const {
  return {{"asymmetry", "m", asymmetry()},
          {"asymmetry_max", "m", worst_asymmetry_},
          {"balls_off", "", balls_off()},
          {"energy_left", "", kinetic_energy_of(world()) / energy_},
          {"momentum_along", "kg m/s", momentum_of(world()).x},
          {"momentum_across", "kg m/s", momentum_of(world()).z}};
}

void Billiards::draw_reference(DrawList& list) const {
  glm::mat4 cloth(1);
  cloth[0].x = static_cast<float>(k_length / 2);
  cloth[1].y = 0.01F;
  cloth[2].z = static_cast<float>(k_width / 2);
  cloth[3].y = -0.01F;
  list.shapes.push_back({ShapeKind::box, cloth, k_cloth});
  list.ground_height = -0.3F;
}

}  // namespace

Scene billiards_scene() {
  return {
      .name = "billiards",
      .summary =
          "a break on a table with cushions, which mirrors itself if all is well",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = with_settings(
          {{"rows", "", "of the rack: 5 are fifteen balls", 5, 1, 20, true},
           {"gap", "m", "between the balls of the rack", 2e-4, 0, 0.01},
           {"speed", "m/s", "of the cue ball", 5, 0.01, 100},
           {"aside", "m", "of the cue ball, off the rack's middle", 0, -0.5, 0.5},
           {"friction", "", "of balls, cloth and cushions", 0.2, 0, 100},
           {"rolling", "m", "rolling friction of the cloth", 3e-4, 0, 0.01},
           {"restitution", "", "of the balls, and at the cushions", 0.95, 0, 1}}),
      .dt = 1.0 / 240,
      .duration = 2,
      .camera = {.target = {0, 0, 0}, .distance = 2.4F, .yaw = 0, .pitch = 1.1F},
      .chart_metric = "asymmetry",
      .chart_logarithmic = true,
      .start = [](const Setup& setup) { return std::make_unique<Billiards>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
