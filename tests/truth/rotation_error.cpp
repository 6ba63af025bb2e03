#include "tests/truth/rotation_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Place;

constexpr double k_u = 0x1p-24;    // unit round-off of single precision
constexpr std::size_t k_size = 7;  // numbers of q and omega

std::vector<double> joined(const Rotation& r) {
  return {r.q.w, r.q.x, r.q.y, r.q.z, r.omega.x, r.omega.y, r.omega.z};
}

Place parted(const std::vector<double>& y) {
  return {{y.begin(), y.begin() + 4}, {y.begin() + 4, y.end()}};
}

std::vector<double> after_a_step(const RotationRun& run, Rotation r) {
  advance(run, r);
  return joined(r);
}

// dy_i / dy_j of a step, by differences
Matrix derivative(const RotationRun& run, const Rotation& r) {
  const std::vector<double> y = joined(r);
  const std::vector<double> here = after_a_step(run, r);
  const double omega = glm::length(r.omega);
  Matrix columns;
  for (std::size_t j = 0; j < k_size; ++j) {
    const double size = j < 4 ? 1 : omega;
    std::vector<double> moved = y;
    moved[j] += 1e-7 * (size > 0 ? size : 1);
    auto& column = columns.emplace_back(after_a_step(run, rotation_of(parted(moved))));
    for (std::size_t i = 0; i < k_size; ++i)
      column[i] = (column[i] - here[i]) / (moved[j] - y[j]);
  }
  return columns;
}

// How many roundings a step makes, as it is written
struct Roundings {
  double wholes;  // of all of q, and of omega
  double terms;   // what an angle or a gyroscopic term passes on its way into the sum
  double stages;  // looks at the rates, of which each makes terms (1 + y)-fold
};

Roundings roundings(const RotationMethod& method) {
  // Five turns by angles of together up to sqrt(3) |omega| dt
  if (method.name == "splitting") return {20, 21, 1};

  // A turn rounds q as product, sum and in its normalisation, L as product, sum and
  // quotient. A term passes up to 12: 4 of parameters, 3 of an angle's length and sine,
  // 5 products. The weights of several looks add up to 1; a solver looks three times
  const bool solves = method.name == "lie_midpoint"
                      || method.name == "discrete_moser_veselov"
                      || method.name.starts_with("implicit");
  return {4, 12, solves ? 3.0 : std::max(1, method.order)};
}

}  // namespace

FollowedRotation::FollowedRotation(const RotationRun& run)
    : run_(run), now_(run.start), sum_(k_size, std::vector<double>(k_size)) {
  half_ = sum_;
  add_rounding();
}

// What a step may round q and omega by, in units of u
FollowedRotation::Rounding FollowedRotation::rounding() const {
  const double omega = glm::length(now_.omega);
  const double L = glm::length(run_.I * now_.omega);
  if (!(std::max(omega, L) * std::max(omega, 1.0)
        <= k_u * std::numeric_limits<float>::max()))
    throw truth::NotCovered("beyond the range of single precision");

  // A turn adds cross products of the angle and L, and of the angle and those; so does
  // the gyroscopic term. Their terms are rounded one by one
  const double h = std::abs(run_.dt);
  const glm::dvec3 w = glm::abs(now_.omega);
  const auto cross_terms = [&](const glm::dvec3& a) {
    return h
           * glm::dvec3(w.y * a.z + w.z * a.y, w.z * a.x + w.x * a.z,
                        w.x * a.y + w.y * a.x);
  };
  const glm::dvec3 once = cross_terms(run_.I * w);
  const glm::dvec3 change = (once + cross_terms(once)) / run_.I;

  // Within a step the rates may change by the share y, and so may the roundings' terms
  const double y = h * L / std::min({run_.I.x, run_.I.y, run_.I.z});
  const auto [wholes, terms, stages] = roundings(run_.method);
  const double share = terms * std::pow(1 + y, stages);
  if (run_.method.order == 0) return {wholes + terms * h * omega, wholes * w};
  return {wholes + share * h * omega, wholes * w + share * change};
}

// The rounding of the start, or of a step: the larger one of its ends
void FollowedRotation::add_rounding() {
  const Rounding here = rounding();
  for (std::size_t i = 0; i < 4; ++i)
    sum_[i][i] += std::pow(std::max(here.q, before_.q), 2);
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(4 + i);
    sum_[at][at] += std::pow(std::max(here.omega[i], before_.omega[i]), 2);
  }
  roundings_ += k_size;
  before_ = here;

  double all = 0;
  for (std::size_t i = 0; i < k_size; ++i) all += sum_[i][i];
  if (!std::isfinite(all)) throw truth::NotCovered("roundings grow beyond bounds");
}

void FollowedRotation::step() {
  carry(derivative(run_, now_), sum_, half_);
  advance(run_, now_);
  add_rounding();
}

Place FollowedRotation::at() const {
  return place_of(now_);
}

Ellipsoid FollowedRotation::error() const {
  Ellipsoid columns;
  for (std::vector<double>& column : cholesky(sum_)) {
    for (double& c : column) c *= k_u * std::sqrt(roundings_);
    columns.push_back(parted(column));
  }
  return columns;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
