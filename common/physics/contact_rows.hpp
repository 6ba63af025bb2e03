/// @file
/// Contacts and bodies as the solvers see them: what does not change while they
/// iterate, close together in memory. Source: chapter 6; E. Catto, Iterative dynamics
/// with temporal coherence, GDC 2005, and Solver2D, 2024.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/physics/contact.hpp"
#include "common/physics/soft_contact.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// How velocities and positions of a world are computed. Metres, kilograms, seconds.
struct SolverSettings {
  Vec3 gravity{0, Real(-9.81), 0};     ///< [m/s²]
  int substeps = 4;                    ///< of `substeps`, in a step
  int iterations = 10;                 ///< sweeps of `sequential_impulses`
  int impact_iterations = 16;          ///< sweeps more, where something bounces
  int impact_rounds = 8;               ///< of bounces that lead to others, at most
  int contacts_at_most = 1000;         ///< of `worst_first`; columns of ten need more
  Real velocity_epsilon = Real(1e-4);  ///< [m/s] `worst_first` leaves less than this
  Real contact_frequency = Real(0.2);  ///< of soft contacts, per frequency of substeps
  Real damping_ratio = 5;              ///< of soft contacts: 1 is critical
  Real push_speed = 3;                 ///< [m/s] at most, out of a penetration
  Real restitution_threshold = 0;      ///< [m/s] slower impacts do not bounce
  Real static_speed = Real(0.01);      ///< [m/s] slower slip is held by static friction
  bool use_pyramid = false;            ///< friction in a square, not in a circle
};

/// A body while a step is solved.
struct SolverBody {
  Vec3 velocity, angular_velocity;
  Real inverse_mass;
  Mat3 inverse_inertia;  ///< world, see Attitude
  Vec3 moved{0};         ///< [m] since the start of the step
  Vec3 turned{0};        ///< [rad] since the start of the step, small
  Vec3 acceleration{0}, angular_acceleration{0};    ///< by forces and gravity
  Vec3 free_velocity{0}, free_angular_velocity{0};  ///< without this substep's impulses
};

/// What a contact does within a substep.
enum class ContactPhase {
  apart,     ///< may close if others push: it must not get any deeper than the gap
  lasting,   ///< touches from the start
  landing,   ///< closes within it, and stays
  bouncing,  ///< closes within it, and parts again
};

/// A contact while a step is solved.
struct ContactRow {
  std::uint32_t a, b;
  Vec3 normal, arm_a, arm_b;  ///< [m] from the centres of mass to the point
  Real normal_mass = 0;       ///< [kg] effective, along the normal
  Real tangent_mass = 0;      ///< [kg] the least along the surface
  Real friction;
  Real target = 0;  ///< [m/s] parting speed that is asked for
  SoftCoefficients soft{};
  Real normal_impulse = 0;  ///< [N s] accumulated
  Vec3 tangent_impulse{0};
  Real gap;  ///< [m] at the start of the step
  Real restitution;
  Real time = 0;  ///< [s] in the substep when its impulse acts
  ContactPhase phase = ContactPhase::lasting;
};

/// A row whose normal impulse also resists rolling.
struct RollingRow {
  std::uint32_t row;
  Real arm;         ///< [m] the torque is up to this times the normal force
  Vec3 impulse{0};  ///< [N m s] accumulated, on B
};

/// (6.1) Velocity [m/s] of B's point less that of A's.
inline Vec3 velocity_between(const ContactRow& row, const SolverBody& a,
                             const SolverBody& b) {
  return b.velocity + glm::cross(b.angular_velocity, row.arm_b) - a.velocity
         - glm::cross(a.angular_velocity, row.arm_a);
}

/// What a row has been given so far [N s], on B.
inline Vec3 impulse_of(const ContactRow& row) {
  return row.normal_impulse * row.normal + row.tangent_impulse;
}

/// How a body stood when the inertia that it is solved with was last looked up.
struct Attitude {
  Quat orientation;      ///< world from body
  Vec3 inverse_inertia;  ///< [1/(kg m²)] of the principal moments, body frame
  Vec3 turned{0};        ///< [rad] `turned` of the solver's body then
  Real time = 0;         ///< [s] since the start of the step
};

/// Room for a step, kept between steps.
struct SolverRoom {
  std::vector<SolverBody> bodies;
  std::vector<Attitude> attitudes;  ///< of the bodies
  Real time = 0;                    ///< [s] since the start of the step
  std::vector<ContactRow> rows;
  std::vector<RollingRow> rolling;
  std::vector<Real> closing;  ///< [m/s] of each contact: for `worst_first`
  long long solved = 0;       ///< how often an impulse was computed for a contact
};

/// Bodies and rows of a step, from where things are now.
void prepare(std::span<const RigidBody> bodies, std::span<const PointContact> contacts,
             const SolverSettings& settings, SolverRoom& room);

/// Looks up the inertia of a row's bodies anew, for where they will be `ahead` [s] from
/// where they have turned to, at `time` [s] since the start of the step. Their angular
/// momentum stays. So an impact in the middle of a step keeps the energy.
void turn_ahead(SolverRoom& room, const ContactRow& row, Real ahead, Real time);

/// (6.2) Effective masses of all rows whose bodies that has changed.
void update_masses(SolverRoom& room);

/// Forces and gravity for h [s].
void accelerate(std::span<SolverBody> bodies, Real h);

/// (6.11) All rows start from the impulses that they had, but for rolling friction.
void warm_start(SolverRoom& room);

/// (6.11) Both in a substep after another one with the same impulses, which then do to
/// each body what they did in that.
void accelerate_again(std::span<SolverBody> bodies, Real h);

/// (6.11) One sweep: each row in turn asks for what its accumulated impulse lacks.
/// Normal impulses never pull; friction stays in its cone. Then what resists rolling.
void sweep(SolverRoom& room, bool use_pyramid);

/// Half a substep's way at the present velocities.
void move(std::span<SolverBody> bodies, Real half_h);

/// Moves and turns bodies at their velocities for dt [s]. Their angular momentum stays:
/// what gyroscopic torque does is done here, to second order.
void move_bodies(std::span<RigidBody> bodies, Real dt);

/// Moves the bodies themselves, keeping the angular momentum that the rows gave them,
/// and gives the contacts their impulses.
void finish(const SolverRoom& room, Real dt, std::span<RigidBody> bodies,
            std::span<PointContact> contacts);

}  // namespace timestep::inline TIMESTEP_PRECISION
