/// @file
/// What a query of two convex shapes answers: how far apart they are, or how deep in
/// each other, along which normal, and where. Source: chapter 4.
#pragma once

#include "common/physics/real.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Why a query ended.
enum class Reason {
  converged,        ///< upper and lower bound of the distance met
  flat,             ///< their Minkowski difference has no volume: the depth is exact
  no_progress,      ///< rounding forbids any better; the bounds have not met
  iteration_limit,  ///< the best so far
  unbounded,        ///< two half-spaces that overlap: no depth is finite
  lower_bound,      ///< apart by at least this: no more was asked, or can be told
  no_answer,        ///< not a pair for this way to ask, or it broke off: distance 0
  out_of_range,     ///< input that is not finite, or too large for its differences
};

/// "converged", "flat", …
constexpr const char* name_of(Reason reason) {
  switch (reason) {
    case Reason::converged:
      return "converged";
    case Reason::flat:
      return "flat";
    case Reason::no_progress:
      return "no_progress";
    case Reason::iteration_limit:
      return "iteration_limit";
    case Reason::unbounded:
      return "unbounded";
    case Reason::lower_bound:
      return "lower_bound";
    case Reason::no_answer:
      return "no_answer";
    case Reason::out_of_range:
      return "out_of_range";
  }
  return "";
}

enum class Contact { separated, touching, penetrating };

/// (4.1) The signed distance of two shapes and what goes with it. Moving B by -distance
/// along the normal makes them just touch. Where several normals serve (ties), it is
/// one of them. The witness points are some pair that is so far apart up to the error:
/// next to parallel faces, and across a gap, quite different pairs are.
struct Separation {
  Real distance = 0;      ///< [m] negative: penetration_depth = -distance
  Vec3 normal{0, 0, 1};   ///< unit, from A to B
  Vec3 on_a{0}, on_b{0};  ///< witness points [m], world: on_b - on_a = distance normal
  int iterations = 0;     ///< support points asked for
  Reason reason = Reason::converged;
  Real error = 0;  ///< [m] rounding may have moved the distance by this
};

/// Whether the distance tells the shapes apart from touching, given its error.
inline Contact contact_of(const Separation& s) {
  if (s.distance > s.error) return Contact::separated;
  return s.distance < -s.error ? Contact::penetrating : Contact::touching;
}

/// The same pair asked for the other way round.
inline Separation swapped(const Separation& s) {
  Separation other = s;
  other.normal = -s.normal;
  other.on_a = s.on_b;
  other.on_b = s.on_a;
  return other;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
