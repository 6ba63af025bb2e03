#include "common/physics/pair_query.hpp"

#include <array>
#include <cmath>

#include "common/physics/epa.hpp"
#include "common/physics/libccd_query.hpp"
#include "common/physics/primitives.hpp"
#include "common/physics/sat.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

bool takes_all(const Shape&, const Shape&) {
  return true;
}

Separation by_closed_form(const Shape& a, const Pose& pose_a, const Shape& b,
                          const Pose& pose_b) {
  return closed_form(a, pose_a, b, pose_b)
      .value_or(Separation{.reason = Reason::no_answer});
}

bool has_closed_form(const Shape& a, const Shape& b) {
  return closed_form(a, {}, b, {}).has_value();
}

const ConvexHull* hull_of(const Shape& shape) {
  const auto* view = std::get_if<HullShape>(&shape);
  return view == nullptr ? nullptr : view->hull;
}

bool sat_takes(const Shape& a, const Shape& b) {
  if (std::holds_alternative<Box>(a)) return std::holds_alternative<Box>(b);
  return hull_of(a) != nullptr && hull_of(b) != nullptr;
}

// The distance of separated shapes is that of the best axis, not theirs
Separation by_sat(const Shape& a, const Pose& pose_a, const Shape& b,
                  const Pose& pose_b) {
  if (!sat_takes(a, b)) return {.reason = Reason::no_answer};
  const ConvexHull *hull_a = hull_of(a), *hull_b = hull_of(b);
  Separation s =
      hull_a != nullptr
          ? sat(*hull_a, pose_a, *hull_b, pose_b).separation
          : sat(std::get<Box>(a), pose_a, std::get<Box>(b), pose_b).separation;
  if (!std::isfinite(s.distance + s.error)) return {.reason = Reason::out_of_range};
  if (s.distance > 0) s.reason = Reason::lower_bound;
  return s;
}

constexpr std::array k_methods{
    PairMethod{"gjk_epa", "distance by GJK, depth by EPA: any pair", separation,
               takes_all},
    PairMethod{"closed_form",
               "formulas: spheres, capsules, half-spaces and some others",
               by_closed_form, has_closed_form},
    PairMethod{"sat", "separating axes: two boxes, or two hulls with faces", by_sat,
               sat_takes},
    PairMethod{"libccd_epa", "libccd's GJK and EPA: no distance, no half-space",
               libccd_epa, libccd_takes},
    PairMethod{"libccd_mpr", "libccd's MPR: no distance, no half-space", libccd_mpr,
               libccd_takes}};

}  // namespace

Separation separation(const Shape& a, const Pose& pose_a, const Shape& b,
                      const Pose& pose_b) {
  if (const auto* plane = std::get_if<HalfSpace>(&b))
    return any_half_space(a, pose_a, *plane, pose_b);
  if (const auto* plane = std::get_if<HalfSpace>(&a))
    return swapped(any_half_space(b, pose_b, *plane, pose_a));
  return separation(convex(a), pose_a, convex(b), pose_b);
}

std::span<const PairMethod> pair_methods() {
  return k_methods;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
