/// @file
/// Chapter 4's grid of pairs as another library gets it, in double.
#pragma once

#include <functional>

#include "chapters/04-contacts/specimen.hpp"
#include "common/physics/pose.hpp"
#include "study/peers/peers.hpp"

namespace timestep::study {

/// The signed distance [m] of two shapes where they stand; NaN if there is no answer.
/// Of shapes that are apart it need not be more than not negative.
using AskPair = std::function<double(const Pose& a, const Pose& b)>;

/// What a library makes of two bodies of the grid; empty if it has no such shape.
using PreparePair = std::function<AskPair(const chapter_04::Specimen& a,
                                          const chapter_04::Specimen& b)>;

/// Of the problem's metrics it knows depth_error_max; null for another problem, and if
/// the library lacks a shape of it: less work would not compare.
std::unique_ptr<PeerRun> start_pairs(const PeerSetup& setup,
                                     const PreparePair& prepare);

}  // namespace timestep::study
