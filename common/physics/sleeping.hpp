/// @file
/// Bodies that have come to rest are left alone until something disturbs them. Off by
/// default. Source: chapter 6.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/physics/contact.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// When bodies sleep.
struct SleepSettings {
  bool is_on = false;
  Real speed = Real(0.02);  ///< [m/s] slower is rest, if the turn is as well
  Real turn = Real(0.02);   ///< [rad/s]
  Real time = Real(0.5);    ///< [s] of rest, until bodies that touch sleep together
};

/// Who sleeps. One entry for each body of the world.
struct Sleepers {
  std::vector<Real> rest;             ///< [s] since the body last moved
  std::vector<std::uint32_t> island;  ///< the same for those that fell asleep together
  std::vector<std::uint8_t> asleep;
  std::vector<RigidBody> held;  ///< what a sleeping body is while a step takes it for
                                ///< a static one
};

/// Wakes all. What wakes starts from no impulses.
void wake(Sleepers& sleepers);

/// (6.16) Before a step: sleeping bodies stand as if nothing could move them, but for
/// those that a force acts on or that were given a velocity: they wake.
void hold_sleepers(std::span<RigidBody> bodies, Sleepers& sleepers);

/// (6.16) Wakes all that fell asleep with a body that something touches that moves.
/// Returns whether there is any: its contacts are not in the list then.
bool wake_touched(std::span<RigidBody> bodies, std::span<const PointContact> contacts,
                  const SleepSettings& settings, Sleepers& sleepers);

/// (6.16) After a step of dt [s]: sleeping bodies are as they were before it, and those
/// that touch and have all been at rest for long fall asleep.
void fall_asleep(std::span<RigidBody> bodies, std::span<const PointContact> contacts,
                 const SleepSettings& settings, Real dt, Sleepers& sleepers);

}  // namespace timestep::inline TIMESTEP_PRECISION
