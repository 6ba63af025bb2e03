/// @file
/// Pairs of solids as every library gets them, with the signed distance that each has.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace timestep::contact_bench {

/// A ball, a box or the hull of points: what is not empty. In m.
struct Solid {
  double radius = 0;
  glm::dvec3 half_extents{0};
  std::vector<glm::dvec3> vertices{};
};

struct Place {
  glm::dvec3 position{0};
  glm::dquat orientation{1, 0, 0, 0};
};

/// Two solids. `moved_b` is where B is a sixtieth of a second later.
struct SolidPair {
  std::size_t a, b;
  Place place_a, place_b, moved_b;
  double distance;  ///< [m] negative: the depth
};

/// Solids about 1 m in size. Half of the pairs overlap: those come first.
struct PairSet {
  std::vector<Solid> solids;
  std::vector<SolidPair> pairs;
};

// A thousand of each half. Each set is made when it is first asked for.
const PairSet& sphere_box_pairs();
const PairSet& box_box_pairs();
const PairSet& hull32_pairs();
const PairSet& hull1000_pairs();

/// The same by name.
struct NamedSet {
  const char* name;
  const PairSet& (*pairs)();
};
inline constexpr NamedSet k_sphere_box{"sphere_box", sphere_box_pairs};
inline constexpr NamedSet k_box_box{"box_box", box_box_pairs};
inline constexpr NamedSet k_hull32{"hull32", hull32_pairs};
inline constexpr NamedSet k_hull1000{"hull1000", hull1000_pairs};

/// Eight overlapping and eight separated pairs of hulls of so many vertices; which they
/// are is GJK's word.
PairSet few_pairs_of_hulls(std::size_t vertices);

}  // namespace timestep::contact_bench
