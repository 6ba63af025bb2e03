#include "chapters/03-rigid-bodies/free_top.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "common/graphics/palette.hpp"
#include "common/physics/exact_free_top.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {
namespace {

constexpr float k_apart = 3.8F;  // of two bodies, in units of the larger half of one
constexpr float k_arrow = 1.7F;  // length of an arrow

// a / b, and a where b is 0
double relative(double a, double b) {
  return b > 0 ? a / b : a;
}

// Half the sides of a box with these moments, the longest 1
glm::vec3 box_of(const glm::dvec3& I) {
  const double sum = I.x + I.y + I.z;
  const glm::dvec3 squares = glm::max(sum - 2.0 * I, 1e-3 * sum);
  const glm::dvec3 sides = glm::sqrt(squares);
  return glm::vec3(sides / std::max({sides.x, sides.y, sides.z}));
}

// A box with one end painted, and its principal axes 1, 2, 3
void draw_body(DrawList& list, const glm::vec3& at, const glm::dquat& q,
               const glm::vec3& half, const Color& color) {
  const glm::mat4 world_from_body = placed(at, q);
  list.shapes.push_back({ShapeKind::box, glm::scale(world_from_body, half), k_body});

  // The paint: a slab that just covers the end of the longest side
  const int longest = half.x == 1 ? 0 : half.y == 1 ? 1 : 2;
  glm::vec3 to_end(0), slab = half * 1.01F;
  to_end[longest] = 0.86F;
  slab[longest] = 0.15F;
  list.shapes.push_back({ShapeKind::box,
                         glm::scale(glm::translate(world_from_body, to_end), slab),
                         color});

  const std::array<Color, 3> colors{k_force, k_normal, k_velocity};
  for (int i = 0; i < 3; ++i) {
    glm::vec3 axis(0);
    axis[i] = half[i] + 0.35F;
    const glm::vec3 tip(world_from_body * glm::vec4(axis, 1));
    list.lines.push_back({.points = {at, tip},
                          .color = colors[static_cast<std::size_t>(i)],
                          .width = 2});
  }
}

void draw_arrow(DrawList& list, const glm::vec3& at, const glm::vec3& along,
                const Color& color, const char* name) {
  list.arrows.push_back({.from = at, .to = at + along, .color = color});
  list.labels.push_back({at + along * 1.08F, name, color});
}

}  // namespace

void FreeTop::Tracked::set(double value) {
  now = value;
  largest = std::max(largest, std::abs(value));
}

FreeTop::FreeTop(const Setup& setup, const glm::dvec3& moments,
                 const exact::Turning& start)
    : TopRun(setup, moments, start, [](const Quat&, Real) { return Vec3(0); }),
      start_(start),
      exact_(start) {}

void FreeTop::observe() {
  const exact::Turning top = now();
  exact_ = exact::free_top(moments(), start_, time());

  // Relative to the start, where there was something
  const glm::dvec3 L = exact::angular_momentum(top, moments());
  const glm::dvec3 L0 = exact::angular_momentum(start_, moments());
  const double E0 = exact::rotational_energy(start_, moments());
  attitude_.set(exact::angle_between(exact_.q, top.q));
  energy_.set(relative(exact::rotational_energy(top, moments()) - E0, E0));
  momentum_.set(relative(glm::distance(L, L0), glm::length(L0)));
  momentum_length_.set(relative(glm::length(L) - glm::length(L0), glm::length(L0)));
  momentum_direction_.set(exact::angle_between(L, L0));

  norm_.set(glm::length(top.q) - 1);

  const auto scale = k_arrow / relative(glm::length(start_.omega), 1);
  herpolhode_.add(picture(top.q * top.omega * scale));
  polhode_.add(picture(top.omega * scale));
}

std::vector<BodyState> FreeTop::bodies() const {
  const exact::Turning top = now();
  return {{.name = "top", .orientation = top.q, .angular_velocity = top.q * top.omega}};
}

std::vector<Metric> FreeTop::metrics() const {
  return {
      {"attitude_error", "rad", attitude_.now},
      {"attitude_error_max", "rad", attitude_.largest},
      {"energy_error", "", energy_.now},
      {"energy_error_max", "", energy_.largest},
      {"momentum_error", "", momentum_.now},
      {"momentum_error_max", "", momentum_.largest},
      {"momentum_length_error_max", "", momentum_length_.largest},
      {"momentum_direction_error", "rad", momentum_direction_.now},
      {"momentum_direction_error_max", "rad", momentum_direction_.largest},
      {"norm_error_max", "", norm_.largest},
      {"omega_dt", "rad", glm::length(start_.omega) * setup().dt},
  };
}

void FreeTop::draw(DrawList& list) const {
  const exact::Turning top = now();
  const glm::vec3 at = place_of_lane(setup(), k_apart);
  const Color& color = setup().style.color;
  draw_body(list, at, top.q, box_of(moments()), color);

  // Where the tip of omega has been: the herpolhode in the world, the polhode on the
  // body
  std::vector<glm::vec3> herpolhode = herpolhode_.points();
  for (glm::vec3& p : herpolhode) p += at;
  list.lines.push_back({.points = herpolhode, .color = color, .fade = true});
  std::vector<glm::vec3> polhode = polhode_.points();
  for (glm::vec3& p : polhode) p = at + glm::quat(top.q) * p;
  list.lines.push_back(
      {.points = polhode, .color = color, .width = 1.5F, .dash = Dash::dotted});

  // L should stand still, omega should not
  const glm::dvec3 L = exact::angular_momentum(top, moments());
  if (glm::length(L) > 0)
    draw_arrow(list, at, k_arrow * picture(glm::normalize(L)), k_ink, "L");
  if (!herpolhode.empty()) draw_arrow(list, at, herpolhode.back() - at, color, "ω");
}

void FreeTop::draw_reference(DrawList& list) const {
  const glm::vec3 at = place_of_exact(setup(), k_apart);
  draw_body(list, at, exact_.q, box_of(moments()), k_muted);
  const glm::dvec3 L = exact::angular_momentum(start_, moments());
  if (glm::length(L) > 0)
    draw_arrow(list, at, k_arrow * picture(glm::normalize(L)), k_ink, "L");
  list.labels.push_back({at - glm::vec3(0.4F, 1.5F, 0), "exact", k_ink});
  list.ground_height.reset();
}

CameraPose FreeTop::camera(const CameraPose& usual) const {
  return camera_for_lanes(usual, setup(), k_apart);
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
