// The kinds of chapter 1, computed through the code in common/physics.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "common/graphics/input_error.hpp"
#include "common/physics/euler.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/forces.hpp"
#include "common/physics/particle.hpp"
#include "common/physics/rounding.hpp"
#include "tests/truth/kind.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Computed;
using truth::Json;
using truth::Kind;
using truth::NotCovered;
using truth::OtherPrecision;

constexpr double k_u = 0x1p-24;  // unit round-off of single precision

double number(const Json& inputs, const char* name) {
  const Json& value = inputs.at(name);
  if (!value.is_number()) throw InputError(fmt::format("{}: must be a number", name));
  return value.get<double>();
}

glm::dvec3 vector(const Json& inputs, const char* name) {
  const Json& v = inputs.at(name);
  const auto is_number = [](const Json& part) { return part.is_number(); };
  if (!v.is_array() || v.size() != 3 || !std::ranges::all_of(v, is_number))
    throw InputError(fmt::format("{}: must be three numbers", name));
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

// The number of steps, which all the time and memory of a case depend on.
long long steps(const Json& inputs) {
  constexpr double k_most = 1e8;
  const double n = number(inputs, "n");
  if (!(n >= 0 && n <= k_most) || n != std::floor(n))
    throw InputError(fmt::format("n: must be a whole number from 0 to {:g}", k_most));
  return static_cast<long long>(n);
}

Json json(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

// The truth files call modified Euler by the order of its Taylor series.
Integrator method(const Json& inputs) {
  std::string name = inputs.at("method").get<std::string>();
  if (name == "taylor2") name = "modified_euler";
  const auto methods = euler_methods();
  const auto found = std::ranges::find(methods, name, &NamedIntegrator::name);
  if (found == methods.end()) throw NotCovered("method " + name);
  return found->step;
}

void run(Integrator step, State& state, const Acceleration& acceleration, double dt,
         long long n) {
  for (long long i = 0; i < n; ++i)
    step(state, acceleration, Real(static_cast<double>(i) * dt), Real(dt));
}

Computed constant_acceleration_steps(const Json& inputs) {
  const exact::Motion start{vector(inputs, "x0"), vector(inputs, "v0")};
  const glm::dvec3 a = vector(inputs, "a");
  const double dt = number(inputs, "dt");
  const auto n = steps(inputs);
  State state = particles(1);
  put(state.x, 0, Vec3(start.x));
  put(state.v, 0, Vec3(start.v));
  run(
      method(inputs), state,
      [g = Vec3(a)](auto, auto, Real, auto out) { put(out, 0, g); }, dt, n);

  const double t = dt * static_cast<double>(n);
  const exact::Motion e = exact::constant_acceleration(start, a, t);
  const glm::dvec3 x(at(state.x, 0));
  const glm::dvec3 v(at(state.v, 0));

  // Single: n additions round v by u V each; those errors move x for up to t, and n
  // additions round x by u X each. The inputs' own rounding adds a few units to n.
  const double largest_v = glm::length(start.v) + glm::length(a) * t;
  const double largest_x = glm::length(start.x) + largest_v * t;
  const double steps = static_cast<double>(n) + 4;
  const double error_v = k_u * steps * largest_v;
  const double error_x = k_u * steps * largest_x + t * error_v;
  return {{{"x", json(x)},
           {"v", json(v)},
           {"x_exact", json(e.x)},
           {"x_error", json(x - e.x)}},
          {{"x", error_x}, {"v", error_v}, {"x_error", error_x}}};
}

Computed linear_drag_projectile(const Json& inputs) {
  const double m = number(inputs, "m");
  const double c = number(inputs, "c");
  const glm::dvec3 g = vector(inputs, "g");
  const exact::Motion end = exact::linear_drag(
      {vector(inputs, "x0"), vector(inputs, "v0")}, g, c / m, number(inputs, "t"));
  return {
      {{"x", json(end.x)}, {"v", json(end.v)}, {"terminal_velocity", json(m * g / c)}},
      {}};
}

Computed quadratic_drag_fall(const Json& inputs) {
  const double m = number(inputs, "m");
  const double k = number(inputs, "k");
  const double g = number(inputs, "g");
  const exact::Motion end = exact::quadratic_drag(
      {glm::dvec3(0), glm::dvec3(0)}, {0, -g, 0}, k / m, number(inputs, "t"));
  return {{{"fall_distance", -end.x.y},
           {"speed", -end.v.y},
           {"terminal_speed", std::sqrt(m * g / k)}},
          {}};
}

using Matrix = std::array<double, 4>;  // row by row, on (x, v / omega)

Matrix product(const Matrix& a, const Matrix& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3],
          a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
}

double norm(const Matrix& m) {
  return std::hypot(std::hypot(m[0], m[1]), std::hypot(m[2], m[3]));
}

State oscillator_state(double x, double v) {
  return {.x = {Real(x)}, .v = {Real(v)}, .a = {Real(0)}};
}

// One step of a method on x'' = -x, as the matrix that it is.
Matrix step_matrix(Integrator step, double z) {
  const Acceleration spring_of_one = [](auto x, auto, Real, auto a) { a[0] = -x[0]; };
  State position = oscillator_state(1, 0);
  State velocity = oscillator_state(0, 1);
  step(position, spring_of_one, 0, Real(z));
  step(velocity, spring_of_one, 0, Real(z));
  return {position.x[0], velocity.x[0], position.v[0], velocity.v[0]};
}

struct SpectralRadius {
  double value, single_error;
};

// Largest |eigenvalue| of the step. Single: trace and determinant are off by a few u
// times the entries' size; a pair close together feels that through the root of the
// discriminant.
SpectralRadius spectral_radius(const Matrix& m) {
  const double half_trace = (m[0] + m[3]) / 2;
  const double determinant = m[0] * m[3] - m[1] * m[2];
  const std::complex<double> root =
      std::sqrt(std::complex<double>(half_trace * half_trace - determinant));
  const double value =
      std::max(std::abs(half_trace + root), std::abs(half_trace - root));
  const double size = 1 + norm(m) * norm(m);
  return {value, 4 * k_u * size * (1 + 1 / std::max(std::abs(root), std::sqrt(k_u)))};
}

// First-order bound on what rounding does to n steps: every step k makes an error of a
// few u times the state's size (six roundings, those of dt, k and 1/m among them, and
// products up to z²), which the remaining steps carry on as M^(n-k). In units of x;
// times omega for v.
double single_error(const Matrix& m, double z, double x0, double v0, long long n) {
  std::vector<double> carried(static_cast<std::size_t>(n) + 1);
  Matrix power{1, 0, 0, 1};
  for (double& c : carried) {
    c = norm(power);
    power = product(power, m);
  }

  double x = x0;
  double v = v0;
  double bound = carried.back() * std::hypot(x0, v0);
  for (long long k = 0; k < n; ++k) {
    bound +=
        6 * (1 + z * z) * std::hypot(x, v) * carried[static_cast<std::size_t>(n - k)];
    const double x_old = x;
    x = m[0] * x_old + m[1] * v;
    v = m[2] * x_old + m[3] * v;
  }
  return k_u * bound;
}

Computed oscillator_steps(const Json& inputs) {
  const double m = number(inputs, "m");
  const double k = number(inputs, "k");
  const double x0 = number(inputs, "x0");
  const double v0 = number(inputs, "v0");
  const double dt = number(inputs, "dt");
  const auto n = steps(inputs);
  const Integrator step = method(inputs);
  const double omega = std::sqrt(k / m);

  State state = oscillator_state(x0, v0);
  run(
      step, state,
      [k = Real(k), inverse_mass = Real(1 / m)](auto x, auto, Real, auto a) {
        a[0] = -k * x[0] * inverse_mass;
      },
      dt, n);
  const double x = state.x[0];
  const double v = state.v[0];
  const double z = omega * dt;
  const Matrix matrix = step_matrix(step, z);
  const double error = single_error(matrix, z, x0, v0 / omega, n);
  if (std::numeric_limits<Real>::digits == 24
      && error * std::max(1.0, omega) > k_u * std::numeric_limits<float>::max())
    throw NotCovered("beyond the range of single precision");

  const auto e = exact::oscillator({x0, v0}, omega, 0, dt * static_cast<double>(n));

  const auto radius = spectral_radius(matrix);
  const double error_v = omega * error;
  const double error_energy =
      (m * (std::abs(v) + error_v) * error_v + k * (std::abs(x) + error) * error);
  return {{{"x", x},
           {"v", v},
           {"E", (m * v * v + k * x * x) / 2},
           {"E0", (m * v0 * v0 + k * x0 * x0) / 2},
           {"x_exact", e.x},
           {"v_exact", e.v},
           {"spectral_radius", radius.value}},
          {{"x", error},
           {"v", error_v},
           {"E", error_energy},
           {"spectral_radius", radius.single_error}}};
}

Computed growth_factor(const Json& inputs) {
  const auto [radius, error] =
      spectral_radius(step_matrix(method(inputs), number(inputs, "omega_dt")));
  return {{{"spectral_radius", radius},
           {"energy_factor_per_step_asymptotic", radius * radius}},
          {{"spectral_radius", error},
           {"energy_factor_per_step_asymptotic", 3 * radius * error}}};
}

// Kinds that name their own precision are answered by the library of that precision
// alone.
void only_in(const Json& inputs) {
  const bool single = std::numeric_limits<Real>::digits == 24;
  if ((inputs.at("precision") == "float32") != single)
    throw OtherPrecision("precision");
}

// A number as an unevaluated sum of two doubles, 106 bits: for expected values that are
// differences of nearly equal numbers and yet are to be met bit by bit.
struct Pair {
  double high, low;
};

Pair product(const Pair& a, double b) {
  const double high = a.high * b;
  return {high, std::fma(a.high, b, -high) + a.low * b};
}

Pair difference(double a, const Pair& b) {
  const double high = a - b.high;
  const double b_back = a - high;
  return {high, (a - (high + b_back)) + (b_back - b.high) - b.low};
}

double quotient(const Pair& a, const Pair& b) {
  const double q = (a.high + a.low) / b.high;
  const double rest = std::fma(-q, b.high, a.high) + (a.low - q * b.low);
  return q + rest / b.high;
}

Computed time_accumulation(const Json& inputs) {
  only_in(inputs);
  const double dt = number(inputs, "dt");
  const auto n = steps(inputs);
  const double t = accumulated_time(Real(dt), n);
  const Pair ideal = product({dt, 0}, static_cast<double>(n));
  return {{{"t", t},
           {"ideal", ideal.high},
           {"relative_error", quotient(difference(t, ideal), ideal)},
           {"dt_in_precision", Real(dt)}},
          {}};
}

Computed float_spacing(const Json& inputs) {
  only_in(inputs);
  return {{{"ulp", spacing(Real(number(inputs, "value")))}}, {}};
}

Computed free_fall_float32(const Json& inputs) {
  if (std::numeric_limits<Real>::digits != 24) throw OtherPrecision("single only");
  const double y0 = number(inputs, "y0");
  const double g = number(inputs, "g");
  const double dt = number(inputs, "dt");
  const auto n = steps(inputs);
  State state{.x = {Real(y0)}, .v = {0}, .a = {0}};
  run(
      semi_implicit_euler, state, [g](auto, auto, Real, auto a) { a[0] = -Real(g); },
      dt, n);

  // (1.4) summed up: y0 - g dt² n (n + 1) / 2
  const auto steps = static_cast<double>(n);
  const Pair fallen =
      product(product(product({dt, 0}, dt), g), steps * (steps + 1) / 2);
  const Pair y = difference(y0, fallen);
  const Pair lost = difference(state.x[0], y);
  return {{{"y_float32", state.x[0]},
           {"y_exact_arithmetic", y.high + y.low},
           {"lost_metres", lost.high + lost.low}},
          {}};
}

}  // namespace

std::span<const Kind> truth_kinds_01() {
  static constexpr std::array<Kind, 8> kinds{{
      {"constant_acceleration_steps", constant_acceleration_steps},
      {"linear_drag_projectile", linear_drag_projectile},
      {"quadratic_drag_fall", quadratic_drag_fall},
      {"oscillator_steps", oscillator_steps},
      {"growth_factor", growth_factor},
      {"time_accumulation", time_accumulation},
      {"float_spacing", float_spacing},
      {"free_fall_float32", free_fall_float32},
  }};
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
