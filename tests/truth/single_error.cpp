#include "tests/truth/single_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>

#include "common/physics/schemes.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Json;
using truth::Place;

using Vector = std::vector<double>;

constexpr double k_u = 0x1p-24;  // unit round-off of single precision

double length(std::span<const double> x) {
  return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0));
}

// x and v after each other
Vector joined(const State& state) {
  Vector y = state.x;
  y.insert(y.end(), state.v.begin(), state.v.end());
  return y;
}

void part(const Vector& y, State& state) {
  const auto half = y.begin() + static_cast<std::ptrdiff_t>(y.size() / 2);
  state.x.assign(y.begin(), half);
  state.v.assign(half, y.end());
}

Vector acceleration(const Run& run, State state) {
  run.acceleration(state.x, state.v, 0, state.a);
  return state.a;
}

Vector after_a_step(const Run& run, const State& state) {
  Integration now = begin(run.scheme, run.acceleration, state, run.dt);
  advance(now);
  return joined(read(now));
}

// df_i / dy_j by differences over small shares of what a step moves
template <class Function>
Matrix derivative(const Run& run, const Function& f, const State& state) {
  const double h = std::abs(run.dt);
  const double x = length(state.x) + h * length(state.v);
  const double v = length(state.v) + h * length(acceleration(run, state));
  const Vector y = joined(state);
  const Vector here = f(run, state);
  Matrix columns;
  for (std::size_t j = 0; j < y.size(); ++j) {
    const double size = j < y.size() / 2 ? x : v;
    Vector moved = y;
    moved[j] += 1e-7 * (size > 0 ? size : 1);
    State there = state;
    part(moved, there);
    Vector& column = columns.emplace_back(f(run, there));
    for (std::size_t i = 0; i < column.size(); ++i)
      column[i] = (column[i] - here[i]) / (moved[j] - y[j]);
  }
  return columns;
}

double norm(std::span<const Vector> columns) {
  double sum = 0;
  for (const Vector& column : columns) sum += std::pow(length(column), 2);
  return std::sqrt(sum);
}

// How many roundings a step makes, as it is written
struct Roundings {
  double sums;     // additions to x, or to v, of which each rounds the whole
  double terms;    // what a term of the change passes on its way into the sum
  double factors;  // kicks, drifts or stages, of which each makes terms (1 + z)-fold
};

Roundings roundings(const Scheme& scheme) {
  // Three times a drift and two half-kicks
  if (scheme.name.starts_with("yoshida4")) return {6, 48, 9};

  // Sums of six terms; the products of its weights stay below those of (1 + z)^10
  if (scheme.name == "dopri5") return {2, 96, 10};

  // A solver may stop at corrections of 64 u
  if (scheme.evaluations == 0) return {4, 96, 3};

  // Up to 6 roundings in an acceleration, 4 of parameters, 6 in sums and products
  return {3, 16.0 * scheme.evaluations, std::max(3.0, 1.0 * scheme.evaluations)};
}

}  // namespace

void carry(const Matrix& D, Matrix& C, Matrix& room) {
  const std::size_t n = C.size();
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      room[j][i] = 0;
      for (std::size_t k = 0; k < n; ++k) room[j][i] += D[k][i] * C[j][k];
    }
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      C[j][i] = 0;
      for (std::size_t k = 0; k < n; ++k) C[j][i] += room[k][i] * D[k][j];
    }
}

Matrix cholesky(Matrix C) {
  const std::size_t n = C.size();
  Matrix L;
  for (std::size_t k = 0; k < n; ++k) {
    const double root = std::sqrt(std::max(C[k][k], 0.0));
    Vector& column = L.emplace_back(n);
    for (std::size_t i = k; i < n && root > 0; ++i) column[i] = C[k][i] / root;
    for (std::size_t j = k; j < n; ++j)
      for (std::size_t i = k; i < n; ++i) C[j][i] -= column[i] * column[j];
  }
  return L;
}

Followed::Followed(const Rounded& rounded) : rounded_(rounded) {
  Run& run = rounded_.run;
  now_ = read(begin(run.scheme, run.acceleration, run.start, run.dt));

  // Störmer goes on from any two places as if it had been started well
  if (run.scheme.name == "stormer_verlet_naive_start")
    run.scheme = *find_scheme("stormer_verlet");
  const Vector y = joined(now_);
  change_ = after_a_step(run, now_);
  for (std::size_t i = 0; i < y.size(); ++i) change_[i] -= y[i];
  sum_.assign(y.size(), Vector(y.size()));
  half_ = sum_;
  look();
  add_rounding();
}

void Followed::look() {
  const std::size_t d = now_.x.size();
  derivative_ = derivative(rounded_.run, after_a_step, now_);
  const Matrix slopes = derivative(rounded_.run, acceleration, now_);
  const std::span<const Vector> all = slopes;
  slope_ = {norm(all.first(d)), norm(all.last(d))};
}

// What a step may round x and v by, in units of u
Followed::Both Followed::rounding() const {
  const double x = length(now_.x);
  const double v = length(now_.v);
  const double a = length(now_.a);
  const double h = std::abs(rounded_.run.dt);
  if (!(std::max({x, v, a}) <= k_u * std::numeric_limits<float>::max()))
    throw truth::NotCovered("beyond the range of single precision");

  // The sums round x and v. The terms of the change are h v, h² a and h a, and a feels
  // the rounding of the place where it is taken
  const auto [sums, terms, factors] = roundings(rounded_.run.scheme);
  const double growth = std::pow(1 + h * (std::sqrt(slope_.x) + slope_.v), factors);
  const double change = terms * growth * h * (a + slope_.x * x + slope_.v * v);
  if (rounded_.in_frame) return {h * change, change};
  Both r{sums * x + terms * growth * h * (v + h * a), sums * v + change};

  // Störmer's velocity is a difference of places; a solver adds its own tolerance
  if (rounded_.run.scheme.name.starts_with("stormer")) r.v += r.x / h;
  r.x += rounded_.solver_error * std::max(x, 1.0);
  r.v += rounded_.solver_error * std::max(v, 1.0);
  return r;
}

// The rounding of the start, or of a step: the larger one of its ends
void Followed::add_rounding() {
  const std::size_t d = now_.x.size();
  rounded_.run.acceleration(now_.x, now_.v, 0, now_.a);
  const Both here = rounding();
  for (std::size_t i = 0; i < d; ++i) {
    sum_[i][i] += std::pow(std::max(here.x, before_.x), 2);
    sum_[d + i][d + i] += std::pow(std::max(here.v, before_.v), 2);
  }
  roundings_ += static_cast<double>(2 * d);
  before_ = here;
}

void Followed::step() {
  carry(derivative_, sum_, half_);
  if (!rounded_.linear) {
    part(after_a_step(rounded_.run, now_), now_);
    look();
  } else {
    // Of an affine map the next change is D times this one
    const std::size_t n = change_.size();
    room_.assign(n, 0);
    for (std::size_t j = 0; j < n; ++j) {
      (j < n / 2 ? now_.x[j] : now_.v[j - n / 2]) += change_[j];
      for (std::size_t i = 0; i < n; ++i) room_[i] += derivative_[j][i] * change_[j];
    }
    std::swap(change_, room_);
  }
  add_rounding();
}

Place Followed::at() const {
  return place_of(now_);
}

Ellipsoid Followed::error() const {
  Ellipsoid columns;
  for (Vector& column : cholesky(sum_)) {
    for (double& c : column) c *= k_u * std::sqrt(roundings_);
    State parts;
    part(column, parts);
    columns.push_back(place_of(parts));
  }
  return columns;
}

Json spread(const std::function<Json(const Place&)>& fields, const Place& at,
            const Ellipsoid& error) {
  const auto moved = [&](double share, const Place& by) {
    Place place = at;
    for (std::size_t i = 0; i < at.x.size(); ++i) place.x[i] += share * by.x[i];
    for (std::size_t i = 0; i < at.v.size(); ++i) place.v[i] += share * by.v[i];
    return fields(place).flatten();
  };
  const Json here = fields(at).flatten();
  std::map<std::string, double> sum;
  for (const Place& by : error) {
    const Json below = moved(-1, by);
    const Json above = moved(1, by);

    // The larger change of both directions; where there is no number, it has no bound
    const auto change = [](const Json& from, const Json& to) {
      const double d = to.get<double>() - from.get<double>();
      return std::isnan(d) ? std::numeric_limits<double>::infinity() : std::abs(d);
    };
    for (const auto& [name, value] : here.items())
      sum[name] +=
          std::max(change(value, below.at(name)), change(value, above.at(name)));
  }
  return Json(sum).unflatten();
}

}  // namespace timestep::inline TIMESTEP_PRECISION
