#include "common/physics/compound.hpp"

#include <algorithm>
#include <limits>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

constexpr Real k_infinity = std::numeric_limits<Real>::infinity();

// World from part
Pose composed(const Pose& body, const Pose& part) {
  return {point_in_world(body, part.position), body.orientation * part.orientation};
}

// No more than the signed distance of what is in the boxes: to part these along an axis
// parts those
Real gap(const Bounds& a, const Bounds& b) {
  const Vec3 gaps = glm::max(b.low - a.high, a.low - b.high);
  return std::max({gaps.x, gaps.y, gaps.z});
}

// A part of A and one of B, with their poses from A's position: there it costs no
// digits to be far away
struct PartPair {
  std::uint32_t a, b;
  Pose pose_a, pose_b;
};

// All pairs whose boxes are no further apart than `limit` is at that time
template <class Visit>
void for_each_near_pair(Compound a, const Pose& pose_a, Compound b, const Pose& pose_b,
                        const Real& limit, const Visit& visit) {
  const Pose here{Vec3(0), pose_a.orientation};
  const Pose there{pose_b.position - pose_a.position, pose_b.orientation};
  const Bounds all_b = bounds(b, there);
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    const Pose of_a = composed(here, a[i].pose);
    const Bounds bounds_a = bounds(a[i].shape, of_a);
    if (gap(bounds_a, all_b) > limit) continue;
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      const Pose of_b = composed(there, b[j].pose);
      if (gap(bounds_a, bounds(b[j].shape, of_b)) > limit) continue;
      visit(PartPair{i, j, of_a, of_b});
    }
  }
}

}  // namespace

std::vector<CompoundPart> compound_parts(const Decomposition& decomposition) {
  std::vector<CompoundPart> parts;
  for (const ConvexHull& hull : decomposition.parts)
    parts.push_back({hull_shape(hull)});
  return parts;
}

Bounds bounds(Compound compound, const Pose& pose) {
  Bounds all{Vec3(k_infinity), Vec3(-k_infinity)};
  for (const CompoundPart& part : compound) {
    const Bounds one = bounds(part.shape, composed(pose, part.pose));
    all = {glm::min(all.low, one.low), glm::max(all.high, one.high)};
  }
  return all;
}

Real volume(Compound compound) {
  Real sum = 0;
  for (const CompoundPart& part : compound) sum += volume(part.shape);
  return sum;
}

PartSeparation separation(Compound a, const Pose& pose_a, Compound b,
                          const Pose& pose_b) {
  PartSeparation least{.separation = {.reason = Reason::no_answer}};
  Real limit = k_infinity;
  int iterations = 0;
  for_each_near_pair(a, pose_a, b, pose_b, limit, [&](const PartPair& pair) {
    const Separation s =
        separation(a[pair.a].shape, pair.pose_a, b[pair.b].shape, pair.pose_b);
    iterations += s.iterations;
    const Real distance = s.reason == Reason::out_of_range ? -k_infinity : s.distance;
    if (!(distance < limit)) return;
    limit = distance;
    least = {s, pair.a, pair.b};
  });
  least.separation.iterations = iterations;
  least.separation.on_a += pose_a.position;
  least.separation.on_b += pose_a.position;
  return least;
}

std::size_t contact_manifolds(Compound a, const Pose& pose_a, Compound b,
                              const Pose& pose_b, Real margin,
                              std::span<PartContact> contacts) {
  std::size_t count = 0;
  for_each_near_pair(a, pose_a, b, pose_b, margin, [&](const PartPair& pair) {
    const Shape &shape_a = a[pair.a].shape, &shape_b = b[pair.b].shape;
    Separation s = separation(shape_a, pair.pose_a, shape_b, pair.pose_b);
    if (s.reason == Reason::out_of_range || s.reason == Reason::unbounded) return;
    Manifold manifold =
        contact_manifold(shape_a, pair.pose_a, shape_b, pair.pose_b, s, margin);
    if (manifold.count == 0 || count++ >= contacts.size()) return;

    // Back from A's position
    s.on_a += pose_a.position;
    s.on_b += pose_a.position;
    for (std::size_t i = 0; i < std::size_t(manifold.count); ++i)
      manifold.points[i].position += pose_a.position;
    contacts[count - 1] = {{s, pair.a, pair.b}, manifold};
  });
  return count;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
