#include "common/physics/lcp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/physics/impulse.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using Vec = glm::dvec3;

// [m/s] Contacts that may close as they like ask for less than this
constexpr double k_any = 1e6;

// Contacts give way by this share, so that no two of them are the same
constexpr double k_give = 1e-8;

// --- Lemke's method

// w - M z - z0 = q as rows of a table: the columns of w, of z, of z0, and q
struct Tableau {
  std::size_t m, columns;
  std::vector<double> table;
  std::vector<std::size_t> basis;  // of each row, the column that is its unknown

  double& at(std::size_t row, std::size_t column) {
    return table[row * columns + column];
  }
};

Tableau tableau_of(const LinearComplementarity& problem) {
  const std::size_t m = problem.q.size();
  Tableau t{m, 2 * m + 2, std::vector<double>(m * (2 * m + 2)), {}};
  const double size = -*std::ranges::min_element(problem.q);
  for (std::size_t i = 0; i < m; ++i) {
    t.basis.push_back(i);
    t.at(i, i) = 1;
    for (std::size_t k = 0; k < m; ++k) t.at(i, m + k) = -problem.M[i * m + k];
    t.at(i, 2 * m) = -1;

    // Uneven crumbs, so that no two rows tie and no pivot comes twice
    constexpr double k_crumb = 1e-12, k_golden = 0.6180339887498949;
    const double uneven = 1 + std::fmod(double(i + 1) * k_golden, 1.0);
    t.at(i, 2 * m + 1) = problem.q[i] + k_crumb * size * uneven;
  }
  return t;
}

void pivot(Tableau& t, std::size_t row, std::size_t column) {
  const double scale = 1 / t.at(row, column);
  for (std::size_t k = 0; k < t.columns; ++k) t.at(row, k) *= scale;
  for (std::size_t i = 0; i < t.m; ++i) {
    const double factor = t.at(i, column);
    if (i == row || factor == 0) continue;
    for (std::size_t k = 0; k < t.columns; ++k) t.at(i, k) -= factor * t.at(row, k);
  }
  t.basis[row] = column;
}

// The row that is the first to reach 0 as the column's unknown grows, m if none does:
// of those that do so together, up to rounding, the one with the largest pivot. z0's
// row, if it is among them, ends the search
std::size_t leaving_row(Tableau& t, std::size_t column) {
  constexpr double k_least_pivot = 1e-10, k_together = 1e-9;
  const std::size_t q = t.columns - 1, z0 = q - 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < t.m; ++i)
    if (t.at(i, column) > k_least_pivot)
      least = std::min(least, t.at(i, q) / t.at(i, column));
  std::size_t best = t.m;
  for (std::size_t i = 0; i < t.m; ++i) {
    const double p = t.at(i, column);
    if (p <= k_least_pivot || t.at(i, q) / p > least + k_together * std::abs(least))
      continue;
    if (t.basis[i] == z0) return i;
    if (best == t.m || p > t.at(best, column)) best = i;
  }
  return best;
}

// Whether z solves the problem, up to a share of the largest |q| below 0
bool solves(const LinearComplementarity& problem, std::span<const double> z) {
  constexpr double k_share = 1e-6;
  const double slack = -k_share * *std::ranges::min_element(problem.q);
  for (std::size_t i = 0; i < z.size(); ++i) {
    double w = problem.q[i];
    for (std::size_t k = 0; k < z.size(); ++k) w += problem.M[i * z.size() + k] * z[k];
    if (!(w >= -slack && z[i] >= 0) || (z[i] > 0 && w > slack)) return false;
  }
  return true;
}

// --- The contacts' problem

// A unit vector of a row along which an impulse may act
struct Ray {
  const ContactRow* row;
  Vec along;
};

Vec friction_direction(const ContactRow& row, int i) {
  const Mat3 basis = contact_basis(row.normal);
  const double angle = 2 * std::numbers::pi * i / k_friction_directions;
  return std::cos(angle) * Vec(basis[1]) + std::sin(angle) * Vec(basis[2]);
}

std::vector<Ray> rays_of(const SolverRoom& room) {
  std::vector<Ray> rays;
  for (const ContactRow& row : room.rows) rays.push_back({&row, Vec(row.normal)});
  for (const ContactRow& row : room.rows)
    for (int i = 0; i < k_friction_directions; ++i)
      rays.push_back({&row, friction_direction(row, i)});
  return rays;
}

// What a unit impulse along `from` on one of a body changes of its velocity along `to`
double response(const SolverBody& body, const Vec& arm_from, const Vec& from,
                const Vec& arm_to, const Vec& to) {
  const Vec turn = glm::dmat3(body.inverse_inertia) * glm::cross(arm_from, from);
  return double(body.inverse_mass) * glm::dot(from, to)
         + glm::dot(glm::cross(turn, arm_to), to);
}

double response(const SolverRoom& room, const Ray& from, const Ray& to) {
  double sum = 0;
  for (const bool first : {true, false}) {
    for (const bool second : {true, false}) {
      const std::uint32_t body = first ? from.row->a : from.row->b;
      if (body != (second ? to.row->a : to.row->b)) continue;
      const Vec arm_from(first ? from.row->arm_a : from.row->arm_b);
      const Vec arm_to(second ? to.row->arm_a : to.row->arm_b);
      const double answer =
          response(room.bodies[body], arm_from, from.along, arm_to, to.along);
      sum += first == second ? answer : -answer;
    }
  }
  return sum;
}

double speed_along(const SolverRoom& room, const Ray& ray) {
  const SolverBody &a = room.bodies[ray.row->a], &b = room.bodies[ray.row->b];
  const Vec v = Vec(b.velocity) - Vec(a.velocity)
                + glm::cross(Vec(b.angular_velocity), Vec(ray.row->arm_b))
                - glm::cross(Vec(a.angular_velocity), Vec(ray.row->arm_a));
  return glm::dot(v, ray.along);
}

}  // namespace

std::vector<double> lemke(const LinearComplementarity& problem, int limit) {
  const std::size_t m = problem.q.size(), z0 = 2 * m;
  std::vector<double> z(m, 0);
  if (m == 0 || *std::ranges::min_element(problem.q) >= 0) return z;

  // z0 lifts all rows above 0; the lowest one leaves
  Tableau t = tableau_of(problem);
  std::size_t row = 0;
  for (std::size_t i = 1; i < m; ++i)
    if (t.at(i, z0 + 1) < t.at(row, z0 + 1)) row = i;
  std::size_t entering = z0;
  for (int k = 0; k < limit; ++k) {
    const std::size_t left = t.basis[row];
    pivot(t, row, entering);
    if (left == z0) {
      for (std::size_t i = 0; i < m; ++i)
        if (t.basis[i] >= m) z[t.basis[i] - m] = std::max(t.at(i, z0 + 1), 0.0);
      return solves(problem, z) ? z : std::vector<double>();
    }

    // The partner of what left comes in
    entering = left < m ? left + m : left - m;
    row = leaving_row(t, entering);
    if (row == m) return {};
  }
  return {};
}

LinearComplementarity contact_problem(const SolverRoom& room) {
  const std::vector<Ray> rays = rays_of(room);
  const std::size_t contacts = room.rows.size(), m = rays.size() + contacts;
  LinearComplementarity problem{std::vector<double>(m * m), std::vector<double>(m)};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t k = 0; k < rays.size(); ++k)
      problem.M[i * m + k] = response(room, rays[k], rays[i]);
    problem.M[i * m + i] *= 1 + k_give;
    problem.q[i] = speed_along(room, rays[i]);
    if (i < contacts) problem.q[i] -= std::max(double(rays[i].row->target), -k_any);
  }

  // Of each contact: friction impulses add up to no more than friction allows, and the
  // slip's size is the unknown that goes with it
  for (std::size_t i = 0; i < contacts; ++i) {
    const std::size_t slip = rays.size() + i;
    problem.M[slip * m + i] = double(room.rows[i].friction);
    for (std::size_t d = 0; d < k_friction_directions; ++d) {
      const std::size_t ray = contacts + i * k_friction_directions + d;
      problem.M[slip * m + ray] = -1;
      problem.M[ray * m + slip] = 1;
    }
  }
  return problem;
}

bool solve_directly(SolverRoom& room) {
  const LinearComplementarity problem = contact_problem(room);
  const std::size_t contacts = room.rows.size();
  const std::vector<double> z = lemke(problem, 50 * int(problem.q.size()) + 50);
  room.solved += static_cast<long long>(contacts);
  if (z.size() != problem.q.size()) return false;
  for (std::size_t i = 0; i < contacts; ++i) {
    ContactRow& row = room.rows[i];
    Vec friction(0);
    for (int d = 0; d < k_friction_directions; ++d)
      friction += z[contacts + i * k_friction_directions + std::size_t(d)]
                  * friction_direction(row, d);
    row.normal_impulse = Real(z[i]);
    row.tangent_impulse = Vec3(friction);
  }
  warm_start(room);
  return true;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
