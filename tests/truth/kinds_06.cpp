// The kinds of chapters 5 and 6 about ways out of a penetration and about impulses,
// computed through the code in common/physics.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "common/graphics/input_error.hpp"
#include "common/physics/exact_sliding.hpp"
#include "common/physics/world.hpp"
#include "tests/truth/inputs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Json;
using truth::Kind;

Json json(const Vec3& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

Vec3 vec3(const Json& inputs, const char* name) {
  return Vec3(truth::vector(inputs, name));
}

// --- A body in the ground, without gravity

const PenetrationMethod& method_of(const Json& inputs) {
  const std::string mode = inputs.at("mode");
  if (mode == "velocity") return *find_penetration_method("baumgarte");
  if (mode == "split_impulse") return *find_penetration_method("split_impulse");
  if (mode == "position_projection")
    return *find_penetration_method("linear_projection");
  throw truth::NotCovered("mode: " + mode);
}

Json baumgarte_resting(const Json& inputs) {
  const PenetrationMethod& method = method_of(inputs);
  const PenetrationSettings settings{.iterations = 1,
                                     .slop = Real(truth::not_negative(inputs, "slop")),
                                     .beta = Real(truth::not_negative(inputs, "beta"))};
  const Real dt = Real(truth::positive(inputs, "dt"));
  std::array<RigidBody, 2> bodies{};
  bodies[1].inverse_mass = 1;
  PointContact contact{};
  contact.b = 1;
  contact.normal = {0, 1, 0};
  contact.depth = Real(truth::number(inputs, "penetration0"));
  PenetrationRoom room;
  for (long long i = 0; i < truth::steps(inputs); ++i) {
    method.step(bodies, std::span(&contact, 1), settings, dt, room);
    contact.depth -= dt * bodies[1].velocity.y;
  }
  return {{"penetration", double(contact.depth)},
          {"velocity", double(bodies[1].velocity.y)}};
}

// --- Soft contacts

Json soft_contact_coefficients(const Json& inputs) {
  const Real hertz = Real(truth::positive(inputs, "hertz"));
  const Real damping_ratio = Real(truth::not_negative(inputs, "damping_ratio"));
  const Real h = Real(truth::positive(inputs, "dt"));
  const Real mass = Real(truth::positive(inputs, "effective_mass"));
  const SoftCoefficients soft = soft_contact(hertz, damping_ratio, h);
  const SpringDamper spring = spring_damper(hertz, damping_ratio, mass);
  const ErpCfm mixing = erp_cfm(spring, h);
  return {{"stiffness", double(spring.stiffness)},
          {"damping", double(spring.damping)},
          {"omega", std::sqrt(double(spring.stiffness) / double(mass))},
          {"bias_rate", double(soft.bias_rate)},
          {"mass_scale", double(soft.mass_scale)},
          {"impulse_scale", double(soft.impulse_scale)},
          {"gamma", double(mixing.cfm / h)},
          {"erp", double(mixing.erp)},
          {"cfm", double(mixing.cfm)}};
}

// --- Sweeps over a stack

std::vector<Real> masses_of(const Json& inputs, std::size_t n) {
  const Json& mass = inputs.at("mass");
  if (!mass.is_array()) return std::vector(n, Real(truth::positive(inputs, "mass")));
  std::vector<Real> masses;
  for (const Json& each : mass)
    masses.push_back(Real(truth::positive({{"mass", each}}, "mass")));
  if (masses.size() != n) throw InputError("mass: must be one, or n of them");
  return masses;
}

// The ground, and blocks that only move
std::vector<RigidBody> stack_of(const std::vector<Real>& masses) {
  std::vector<RigidBody> bodies(1);
  for (const Real mass : masses) bodies.emplace_back().inverse_mass = 1 / mass;
  return bodies;
}

std::vector<PointContact> contacts_of(std::size_t n, bool upwards) {
  std::vector<PointContact> contacts;
  for (std::uint32_t i = 0; i < n; ++i) {
    PointContact& contact = contacts.emplace_back();
    contact.a = upwards ? i : std::uint32_t(n) - 1 - i;
    contact.b = contact.a + 1;
    contact.normal = {0, 1, 0};
  }
  return contacts;
}

Json pgs_stack(const Json& inputs) {
  const auto n = std::size_t(truth::steps(inputs));
  const std::vector<Real> masses = masses_of(inputs, n);
  const Real dt = Real(truth::positive(inputs, "dt"));
  const Real g = Real(truth::positive(inputs, "g"));
  const auto sweeps = int(truth::positive(inputs, "iterations"));
  SolverRoom room;
  prepare(stack_of(masses), contacts_of(n, inputs.at("order") == "up"),
          {.gravity = {0, -g, 0}}, room);
  accelerate(room.bodies, dt);
  for (int i = 0; i < sweeps; ++i) sweep(room, false);

  std::vector<double> impulses(n), velocities;
  for (const ContactRow& row : room.rows) impulses[row.a] = double(row.normal_impulse);
  for (std::size_t i = 0; i < n; ++i)
    velocities.push_back(double(room.bodies[i + 1].velocity.y));
  const std::vector<double> exact = exact::resting_impulses(
      std::vector<double>(masses.begin(), masses.end()), double(g), double(dt));
  return {{"impulses", impulses},
          {"velocities", velocities},
          {"impulses_exact", exact},
          {"floor_impulse_relative_error", impulses[0] / exact[0] - 1},
          {"asymptotic_factor_equal_mass", exact::sweep_factor(int(n))}};
}

// --- The impact of two bodies

RigidBody body_of(const Json& inputs) {
  RigidBody body;
  body.position = vec3(inputs, "position");
  body.velocity = vec3(inputs, "velocity");
  const Json& q = inputs.at("q");
  if (!q.is_array() || q.size() != 4) throw InputError("q: must be four numbers");
  std::array<double, 4> part{};
  for (std::size_t i = 0; i < 4; ++i) part[i] = truth::number({{"q", q[i]}}, "q");
  body.orientation =
      glm::normalize(Quat(Real(part[0]), Real(part[1]), Real(part[2]), Real(part[3])));
  body.angular_velocity = vec3(inputs, "omega");
  if (inputs.at("mass").is_null()) return body;
  body.inverse_mass = 1 / Real(truth::positive(inputs, "mass"));
  body.inverse_inertia = Vec3(1) / vec3(inputs, "inertia");
  return body;
}

std::string mode_of(const std::string& law, const Impact& impact, const Vec3& J) {
  if (law == "frictionless") return law;
  const Real j_n = glm::dot(J, impact.normal);
  const Real j_t = glm::length(J - j_n * impact.normal);
  return j_t < impact.friction * j_n * (1 - Real(1e-5)) ? "stick" : "slide";
}

Json two_body_impulse(const Json& inputs) {
  const std::string name = inputs.at("law");
  const ImpactLaw* law = find_impact_law(name);
  if (law == nullptr) throw truth::NotCovered("law: " + name);
  RigidBody a = body_of(inputs.at("A")), b = body_of(inputs.at("B"));
  const Impact impact{.point = vec3(inputs, "point"),
                      .normal = glm::normalize(vec3(inputs, "normal")),
                      .restitution = Real(truth::not_negative(inputs, "restitution")),
                      .friction = Real(truth::not_negative(inputs, "mu"))};

  const Vec3 before = relative_velocity(a, b, impact.point);
  const double energy = kinetic_energy(a) + kinetic_energy(b);
  const Vec3 J = law->impulse(a, b, impact);
  apply_impulse(a, b, impact.point, J);
  const Vec3 after = relative_velocity(a, b, impact.point);
  const Real parting = glm::dot(after, impact.normal);

  Vec3 momentum(0);
  for (const RigidBody& body : {a, b})
    if (body.inverse_mass > 0) momentum += body.velocity / body.inverse_mass;
  return {
      {"impulse_on_B", json(J)},
      {"normal_impulse", double(glm::dot(J, impact.normal))},
      {"mode", mode_of(name, impact, J)},
      {"vA", json(a.velocity)},
      {"wA", json(a.angular_velocity)},
      {"vB", json(b.velocity)},
      {"wB", json(b.angular_velocity)},
      {"relative_normal_velocity_before", double(glm::dot(before, impact.normal))},
      {"relative_normal_velocity_after", double(parting)},
      {"tangential_speed_after", double(glm::length(after - parting * impact.normal))},
      {"kinetic_energy_before", energy},
      {"kinetic_energy_after", kinetic_energy(a) + kinetic_energy(b)},
      {"momentum_after", json(momentum)},
      {"angular_momentum_after_about_origin",
       json(angular_momentum_about(a, glm::dvec3(0))
            + angular_momentum_about(b, glm::dvec3(0)))}};
}

}  // namespace

std::span<const Kind> truth_kinds_06() {
  static constexpr std::array<Kind, 4> kinds{{
      {"baumgarte_resting", baumgarte_resting},
      {"soft_contact_coefficients", soft_contact_coefficients},
      {"pgs_stack", pgs_stack},
      {"two_body_impulse", two_body_impulse},
  }};
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
