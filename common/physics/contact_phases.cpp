#include "common/physics/contact_phases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// [m/s] A parting speed that no contact misses
constexpr Real k_any_speed = std::numeric_limits<Real>::max();

Real gap_now(const ContactRow& row, const SolverBody& a, const SolverBody& b) {
  const Vec3 parted = b.moved + glm::cross(b.turned, row.arm_b) - a.moved
                      - glm::cross(a.turned, row.arm_a);
  return row.gap + glm::dot(row.normal, parted);
}

// (6.4) What gravity alone makes of rest within a substep is no impact
Real slowest_bounce(const SolverSettings& settings, Real h) {
  return std::max(settings.restitution_threshold, h * glm::length(settings.gravity));
}

// A pair in free flight within a substep: when it closes, and how fast it then is
struct Closing {
  bool closes;
  Real time, speed;  // [s], [m/s]
};

Closing closing_of(Real gap, Real v, Real acceleration, Real h) {
  if (gap <= 0) return {v < 0, 0, -v};
  if (gap + h * (v + h / 2 * acceleration) > 0) return {false, h, 0};
  const Real speed = std::sqrt(std::max(v * v - 2 * acceleration * gap, Real(0)));
  return {true, std::min(2 * gap / (speed - v), h), speed};
}

// When the impulse of a landing acts, all in all: what stops the fall at once, what
// then carries it evenly over the time that is left
Real landing_time(const Closing& closing, Real acceleration, Real h) {
  const Real left = h - closing.time, carried = left * std::max(-acceleration, Real(0));
  const Real all = closing.speed + carried;
  return all > 0 ? closing.time + carried / all * left / 2 : closing.time;
}

// (6.4) What a row does that closes within the substep: it parts again, if it would not
// be back before the substep is over; else it stays
void arrive(ContactRow& row, const Closing& closing, Real acceleration,
            const SolverSettings& settings, Real h) {
  const Real parting = row.restitution * closing.speed, left = h - closing.time;
  const bool bounces = closing.speed > slowest_bounce(settings, h)
                       && parting + left / 2 * acceleration > 0;
  row.phase = bounces ? ContactPhase::bouncing : ContactPhase::landing;
  row.target = 0;
  row.time = bounces ? closing.time : landing_time(closing, acceleration, h);
}

Real normal_speed(const ContactRow& row, const SolverBody& a, const SolverBody& b) {
  return glm::dot(row.normal, velocity_between(row, a, b));
}

Real normal_acceleration(const ContactRow& row, const SolverBody& a,
                         const SolverBody& b) {
  return glm::dot(row.normal, b.acceleration - a.acceleration);
}

// (6.4) All bodies as they will be when they bounce, in a substep that has come to
// `now` [s]. Then each row asks for what its restitution makes of its speed there
void prepare_bounces(SolverRoom& room, Real now, const auto& parting) {
  for (const ContactRow& row : room.rows)
    if (row.phase == ContactPhase::bouncing)
      turn_ahead(room, row, row.time - now, room.time + row.time);
  update_masses(room);
  for (ContactRow& row : room.rows)
    if (row.phase == ContactPhase::bouncing)
      row.target = parting(row, room.bodies[row.a], room.bodies[row.b]);
}

// (6.4) Its speed at the end of a substep at whose start it is `gap` apart
Real parting_after(const ContactRow& row, const SolverBody& a, const SolverBody& b,
                   Real h) {
  const Real gap = std::max(gap_now(row, a, b), Real(0)), v = normal_speed(row, a, b);
  const Real acceleration = normal_acceleration(row, a, b);
  const Real speed = std::sqrt(std::max(v * v - 2 * acceleration * gap, Real(0)));
  return row.restitution * speed + (h - row.time) * acceleration;
}

// (6.13) What a row asks for in the substep
void look_ahead(ContactRow& row, const SolverBody& a, const SolverBody& b,
                const SolverSettings& settings, const SoftCoefficients& soft, Real h) {
  const Real gap = gap_now(row, a, b);
  row.time = h / 2;
  row.soft = {};
  if (gap > 0 || row.restitution > 0) {
    const Real v = normal_speed(row, a, b);
    const Real acceleration = normal_acceleration(row, a, b);
    const Closing closing = closing_of(gap, v, acceleration, h);
    if (closing.closes) {
      arrive(row, closing, acceleration, settings, h);
      if (gap > 0 || row.phase == ContactPhase::bouncing) return;
      row.time = h / 2;
    } else if (gap > 0) {
      row.phase = ContactPhase::apart;
      row.target = row.restitution > 0 ? -k_any_speed : -gap / h;
      return;
    }
  }
  row.phase = ContactPhase::lasting;
  row.soft = soft;
  row.target = std::min(-soft.bias_rate * gap, settings.push_speed);
}

// (6.13) Displaces bodies by what an impulse in the middle of the substep does not do
void correct_for_time(const ContactRow& row, SolverBody& a, SolverBody& b, Real h) {
  const Vec3 moment = (h / 2 - row.time) * impulse_of(row);
  a.moved -= a.inverse_mass * moment;
  b.moved += b.inverse_mass * moment;
  a.turned -= a.inverse_inertia * glm::cross(row.arm_a, moment);
  b.turned += b.inverse_inertia * glm::cross(row.arm_b, moment);
}

}  // namespace

bool look_ahead(SolverRoom& room, const SolverSettings& settings,
                const SoftCoefficients& soft, Real h) {
  bool bounces = false;
  for (ContactRow& row : room.rows) {
    // What bounced before has nothing left to start from
    if (row.phase == ContactPhase::bouncing) {
      row.normal_impulse = 0;
      row.tangent_impulse = Vec3(0);
    }
    look_ahead(row, room.bodies[row.a], room.bodies[row.b], settings, soft, h);
    bounces = bounces || row.phase == ContactPhase::bouncing;
  }
  if (bounces)
    prepare_bounces(room, 0, [&](const ContactRow& row, const auto& a, const auto& b) {
      return parting_after(row, a, b, h);
    });
  return bounces;
}

bool bounce_on(SolverRoom& room, const SolverSettings& settings, Real h) {
  bool bounces = false;
  for (ContactRow& row : room.rows) {
    SolverBody &a = room.bodies[row.a], &b = room.bodies[row.b];
    if (row.phase == ContactPhase::bouncing) {
      correct_for_time(row, a, b, h);
      row.normal_impulse = 0;
      row.tangent_impulse = Vec3(0);
      row.phase = ContactPhase::apart;
      row.target = -k_any_speed;
    }
    if (row.phase != ContactPhase::apart || row.restitution == 0) continue;

    // It is the middle of the substep: whether this closes in the other half
    const Real closing = -normal_speed(row, a, b);
    const Real gap = std::max(gap_now(row, a, b), Real(0));
    if (closing <= slowest_bounce(settings, h) || gap >= h / 2 * closing) continue;
    row.phase = ContactPhase::bouncing;
    row.time = h / 2 + gap / closing;
    bounces = true;
  }
  if (bounces)
    prepare_bounces(room, h / 2,
                    [](const ContactRow& row, const auto& a, const auto& b) {
                      return -row.restitution * normal_speed(row, a, b);
                    });
  return bounces;
}

void relax(std::span<ContactRow> rows) {
  for (ContactRow& row : rows) {
    if (row.phase != ContactPhase::lasting) continue;
    row.soft = {};
    row.target = 0;
  }
}

void correct_for_time(SolverRoom& room, Real h) {
  for (const ContactRow& row : room.rows) {
    if (row.phase != ContactPhase::bouncing && row.phase != ContactPhase::landing)
      continue;
    correct_for_time(row, room.bodies[row.a], room.bodies[row.b], h);
  }
  room.time += h;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
