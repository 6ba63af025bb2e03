/// @file
/// What the answers are measured against: the best that is known of a pair, in double
/// whatever the run's precision. Compiled in the double build alone, called from both.
#pragma once

#include <memory>

#include "chapters/04-contacts/description.hpp"
#include "common/physics/precision.hpp"

namespace timestep::double_precision::chapter_04 {

struct KnownSeparation {
  double distance;    ///< [m] signed
  glm::dvec3 normal;  ///< from A to B; one of them where several serve
};

/// Two bodies of which it answers any placements.
class Reference {
 public:
  Reference(const specimens::Description& a, const specimens::Description& b);
  ~Reference();

  /// By the closed form where there is one; else by separating axes where polyhedra
  /// overlap; else by GJK and EPA.
  KnownSeparation at(const specimens::Placement& a,
                     const specimens::Placement& b) const;

 private:
  struct Pair;
  std::unique_ptr<Pair> pair_;
};

}  // namespace timestep::double_precision::chapter_04
