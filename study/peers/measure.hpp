/// @file
/// Runs a peer as the study runs a cell: for its error, and in a pass of its own for
/// its time.
#pragma once

#include "study/cell.hpp"
#include "study/peers/peers.hpp"
#include "study/record.hpp"

namespace timestep::study {

/// What a peer is asked: cells with the peer in place of the method, at the problem's
/// steps and, if it iterates, its numbers of iterations. None for a problem that it has
/// no answer to.
std::vector<Cell> cells_of(const Peer& peer, const Problem& problem, bool quick);

/// The same bits at every call, as far as the library gives them.
ErrorResult measure_error(const Peer& peer, const Cell& cell);

/// As `time_of` times it.
TimeResult measure_time(const Peer& peer, const Cell& cell, int least_repeats);

}  // namespace timestep::study
