// A thrown mesh: its centre of mass flies chapter 1's parabola, all else tumbles.
#include <algorithm>
#include <cmath>

#include "chapters/03-rigid-bodies/parts.hpp"
#include "chapters/03-rigid-bodies/solid_mesh.hpp"
#include "common/chapter/trail.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/exact_free_top.hpp"
#include "common/physics/rigid_body.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {
namespace {

class ThrownWrench : public BodyRun {
 public:
  explicit ThrownWrench(const Setup& setup);

  std::vector<std::string> notices() const override { return solid_.notices; }
  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;
  CameraPose camera(const CameraPose& usual) const override;

 private:
  void advance() override;
  double mass() const { return static_cast<double>(solid_.properties.mass); }
  glm::dvec3 moments() const { return glm::dvec3(solid_.moments); }
  exact::Turning turning() const { return wide(rotation_of(body_)); }
  double energy() const;
  exact::Motion exact_motion(double t) const;
  glm::vec3 tip(const glm::dvec3& at, const glm::dquat& q) const;

  SolidMesh solid_;
  RigidBody body_;
  exact::Motion throw_;
  exact::Turning start_;
  glm::dvec3 furthest_;  ///< from the centre of mass, of the mesh's points
  double start_energy_, worst_attitude_ = 0, worst_momentum_ = 0;
  Trail centre_, tip_;
  std::vector<glm::mat4> past_;  ///< where the mesh was at even intervals
};

glm::dvec3 furthest_point(const MeshData& mesh) {
  glm::vec3 furthest(0);
  for (const glm::vec3& p : mesh.positions)
    if (glm::length(p) > glm::length(furthest)) furthest = p;
  return furthest;
}

// The middle of a throw that lands as high as it starts is above the origin
exact::Motion throw_of(const Setup& setup) {
  const auto& p = setup.parameters;
  const double up = p.at("speed") * std::sin(p.at("angle"));
  const double along = p.at("speed") * std::cos(p.at("angle"));
  const double flight = p.at("gravity") > 0 ? 2 * up / p.at("gravity") : 0;
  return {{-along * std::max(flight, 0.0) / 2, 0, 0}, {along, up, 0}};
}

ThrownWrench::ThrownWrench(const Setup& setup)
    : BodyRun(setup),
      solid_(load_solid(setup.mesh.empty() ? "wrench.obj" : setup.mesh,
                        parameter("density"), setup.fix_winding)),
      throw_(throw_of(setup)),
      furthest_(furthest_point(*solid_.mesh)) {
  const glm::dvec3 spin{parameter("spin_x"), parameter("spin_y"), parameter("spin_z")};
  body_.position = Vec3(throw_.x);
  body_.velocity = Vec3(throw_.v);
  body_.orientation = solid_.file_from_body;  // the file's frame is the world's
  body_.angular_velocity = Vec3(spin);
  body_.inverse_mass = 1 / solid_.properties.mass;
  body_.inverse_inertia = Vec3(1) / solid_.moments;
  start_ = turning();
  start_energy_ = energy();
}

void ThrownWrench::advance() {
  const Vec3 g(0, -Real(parameter("gravity")), 0);
  add_force(body_, weight(1 / body_.inverse_mass, g));
  integrate(body_, method().step, Real(setup().dt));
}

exact::Motion ThrownWrench::exact_motion(double t) const {
  return exact::constant_acceleration(throw_, {0, -parameter("gravity"), 0}, t);
}

double ThrownWrench::energy() const {
  const glm::dvec3 v(body_.velocity);
  const double height = static_cast<double>(body_.position.y);
  return exact::rotational_energy(turning(), moments())
         + mass() * (glm::dot(v, v) / 2 + parameter("gravity") * height);
}

void ThrownWrench::observe() {
  const exact::Turning exact = exact::free_top(moments(), start_, time());
  const glm::dvec3 L0 = exact::angular_momentum(start_, moments());
  worst_attitude_ =
      std::max(worst_attitude_, exact::angle_between(exact.q, turning().q));
  worst_momentum_ =
      std::max(worst_momentum_,
               glm::distance(exact::angular_momentum(turning(), moments()), L0));
  const double interval = setup().duration / 7;
  if (time() >= static_cast<double>(past_.size()) * interval)
    past_.push_back(placed(picture(glm::dvec3(body_.position)), turning().q));
  centre_.add(picture(glm::dvec3(body_.position)));
  tip_.add(tip(glm::dvec3(body_.position), turning().q));
}

std::vector<BodyState> ThrownWrench::bodies() const {
  return {{.name = "mesh",
           .position = glm::dvec3(body_.position),
           .velocity = glm::dvec3(body_.velocity),
           .orientation = glm::dquat(body_.orientation),
           .angular_velocity = glm::dvec3(body_.angular_velocity)}};
}

std::vector<Metric> ThrownWrench::metrics() const {
  const exact::Turning exact = exact::free_top(moments(), start_, time());
  const double L0 = glm::length(exact::angular_momentum(start_, moments()));
  return {
      {"attitude_error", "rad", exact::angle_between(exact.q, turning().q)},
      {"attitude_error_max", "rad", worst_attitude_},
      {"position_error", "m",
       glm::distance(glm::dvec3(body_.position), exact_motion(time()).x)},
      {"energy_error", "J", energy() - start_energy_},
      {"momentum_error_max", "", L0 > 0 ? worst_momentum_ / L0 : worst_momentum_},
      {"mass", "kg", mass()},
      {"i1", "kg m²", moments().x},
      {"i2", "kg m²", moments().y},
      {"i3", "kg m²", moments().z},
  };
}

glm::vec3 ThrownWrench::tip(const glm::dvec3& at, const glm::dquat& q) const {
  return glm::vec3(at + q * furthest_);
}

void ThrownWrench::draw(DrawList& list) const {
  const glm::vec3 at = picture(glm::dvec3(body_.position));
  const Color& color = setup().style.color;
  for (const glm::mat4& pose : past_)
    list.meshes.push_back(
        {.mesh = solid_.mesh, .world_from_mesh = pose, .color = k_body});
  list.meshes.push_back({.mesh = solid_.mesh,
                         .world_from_mesh = placed(at, turning().q),
                         .color = color});
  list.lines.push_back(
      {.points = tip_.points(), .color = color, .width = 1.5F, .fade = true});
  list.lines.push_back({.points = centre_.points(), .color = color, .width = 3});
  list.markers.push_back({.position = at, .style = setup().style, .size = 12});
}

void ThrownWrench::draw_reference(DrawList& list) const {
  // Chapter 1's parabola, and where the tip should have gone
  constexpr int k_pieces = 240;
  std::vector<glm::vec3> parabola, loops;
  for (int i = 0; i <= k_pieces; ++i) {
    const double t = setup().duration * i / k_pieces;
    const glm::dvec3 at = exact_motion(t).x;
    parabola.push_back(picture(at));
    loops.push_back(tip(at, exact::free_top(moments(), start_, t).q));
  }
  list.lines.push_back(
      {.points = parabola, .color = k_ink, .width = 2, .dash = Dash::dashed});
  list.lines.push_back(
      {.points = loops, .color = k_muted, .width = 1.5F, .dash = Dash::dotted});
  list.legend.push_back({reference_style(), "exact"});
  list.ground_height.reset();
}

// Near enough to see the mesh, far enough to see the throw
CameraPose ThrownWrench::camera(const CameraPose& usual) const {
  CameraPose pose = usual;
  const glm::dvec3 v = throw_.v;
  const double gravity = parameter("gravity");
  const double height = gravity > 0 ? v.y * v.y / (2 * gravity) : 0;
  const double size = 2 * glm::length(furthest_);
  pose.target = {0, static_cast<float>(height / 2), 0};
  const double wide = std::max(-2 * throw_.x.x, 1.5 * height) + 2 * size;
  pose.distance = static_cast<float>(std::clamp(0.95 * wide, 0.3, 1e4));
  return pose;
}

}  // namespace

Scene thrown_wrench_scene() {
  return {
      .name = "thrown-wrench",
      .summary = "a thrown wrench, or your own mesh: a parabola, and a tumble",
      .methods = all_choices(),
      .default_methods = {"splitting"},
      .parameters =
          {{"speed", "m/s", "at the start", 3.2, 0, 1e3},
           {"angle", "rad", "of the throw, from the horizontal", 1.25, -1.58, 1.58},
           {"spin_x", "rad/s", "at the start, along the throw", 4, -1e4, 1e4},
           {"spin_y", "rad/s", "at the start, about the vertical", 8, -1e4, 1e4},
           {"spin_z", "rad/s", "at the start, sideways", -9, -1e4, 1e4},
           {"gravity", "m/s²", "downwards", 9.81, 0, 1e3},
           {"density", "kg/m³", "of what the mesh is made of", 7850, 1e-3, 1e6}},
      .takes_mesh = true,
      .fixes_winding = true,
      .dt = 1.0 / 120,
      .duration = 0.62,
      .camera = {.target = {0, 0.4F, 0}, .distance = 2, .yaw = 0, .pitch = 0.08F},
      .chart_metric = "attitude_error",
      .chart_logarithmic = true,
      .start = [](const Setup& setup) { return std::make_unique<ThrownWrench>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
