/// @file
/// Who is asked about the pairs of chapter 4's truth files, and what they answer.
#pragma once

#include <limits>

#include "chapters/04-contacts/pair_file.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {

/// Of a pair; `distance` [m] is NaN where there is none.
struct PeerAnswer {
  double distance = std::numeric_limits<double>::quiet_NaN();
  bool is_bound = false;  ///< of shapes that are apart, it says no more than that
  bool has_end = true;    ///< false: it was stopped from outside
};

struct Peer {
  const char* name;
  PeerAnswer (*ask)(const chapter_04::PlacedPair& pair);
  bool (*takes)(const chapter_04::PlacedPair& pair) = nullptr;  ///< null: any
};

/// FCL's signed distance, with a tolerance at which most comes of it.
PeerAnswer ask_fcl(const chapter_04::PlacedPair& pair);

/// Bullet's GJK pair detector with its EPA and no margins.
PeerAnswer ask_bullet(const chapter_04::PlacedPair& pair);

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
