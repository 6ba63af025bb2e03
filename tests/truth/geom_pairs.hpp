/// @file
/// The shapes of chapter 4's truth cases.
#pragma once

#include "chapters/04-contacts/pair_file.hpp"
#include "tests/truth/kind.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// A and B of a case of one of `k_pair_kinds`, in the order in which its normal points.
chapter_04::PlacedPair pair_of(const std::string& kind, const truth::Json& inputs);

}  // namespace timestep::inline TIMESTEP_PRECISION
