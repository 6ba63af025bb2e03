/// @file
/// The answer to a pair of a file, as it is written to files.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "chapters/04-contacts/pair_file.hpp"
#include "common/physics/pair_query.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {

/// {`state`: separated, touching or penetrating; `signed_distance` [m]; `normal`, from
/// A to B; `witness_A`, `witness_B` [m]; `error` [m]; `contacts`, the manifold:
/// `position` [m] and `depth` [m] of each; `iterations`; `reason`}. Where the method
/// has no answer, all but the last two are null.
nlohmann::ordered_json answer_to(const PlacedPair& pair, const PairMethod& method);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
