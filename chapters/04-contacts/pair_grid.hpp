/// @file
/// The grid of pairs: which shapes stand against each other, and how they move. Plain
/// numbers, of which the scene and other libraries make the same bodies.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "chapters/04-contacts/description.hpp"

namespace timestep::specimens {

/// Two bodies; the index decides how they turn and where they stand in the picture.
struct GridPair {
  Description a, b;
  int index;

  bool has_plane() const { return a.kind == k_half_space; }
};

/// How far B's centre is from A's: from `near` [m] to `swing` [m] farther.
struct Swing {
  double near, swing;
};

/// Every two of eight kinds, half-spaces first. With `common_only` those kinds alone
/// that most libraries have: sphere, box, capsule, cylinder and hull.
inline std::vector<GridPair> grid_pairs(bool common_only) {
  constexpr std::array k_kinds{0, 1, 2, 3, 4, 5, 7, k_half_space};
  constexpr std::array k_common{0, 1, 3, 4, 7};
  constexpr double k_size = 0.34;  // [m] half a body's width
  const auto is_common = [&](int kind) {
    return std::ranges::count(k_common, kind) > 0;
  };
  std::vector<GridPair> pairs;
  int index = -1;
  for (std::size_t i = 0; i + 1 < k_kinds.size(); ++i) {
    for (std::size_t j = i; j < k_kinds.size(); ++j) {
      ++index;
      const int kind = k_kinds[i], other = k_kinds[j];
      if (common_only && !(is_common(kind) && is_common(other))) continue;
      const Description one{kind, k_size, 1}, two{other, k_size, 1};
      const bool has_plane = other == k_half_space;
      pairs.push_back({has_plane ? two : one, has_plane ? one : two, index});
    }
  }
  return pairs;
}

/// A stays where it is.
inline Placement place_of_a(const GridPair& pair) {
  if (pair.has_plane()) return {};
  return {{0, 0, 0}, glm::angleAxis(0.3 + 0.5 * pair.index, glm::dvec3(0.6, 0.8, 0))};
}

/// In and out along a direction of its own, turning about another; t in seconds.
inline Placement place_of_b(const GridPair& pair, const Swing& swing, double t) {
  constexpr double k_period = 4;  // [s]
  const double turn = 0.7 * pair.index;
  const double part = 1 - std::cos(2 * std::numbers::pi * t / k_period + turn);
  const double reach = swing.near + swing.swing * part / 2;
  const glm::dvec3 way = pair.has_plane()
                             ? glm::dvec3(0, 1, 0)
                             : glm::dvec3(std::cos(turn), std::sin(turn), 0);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, std::sin(turn), std::cos(turn)));
  return {reach * way, glm::angleAxis(turn + 0.8 * t, axis)};
}

}  // namespace timestep::specimens
