/// @file
/// The study itself: first all errors, then all times, each written down at once.
#pragma once

#include <memory>
#include <string>

#include "study/exit_code.hpp"
#include "study/journal.hpp"
#include "study/options.hpp"

namespace timestep::study {

/// The shard's journal, which knows what all others in `options.out` have. Throws
/// InputError if one of them cannot be used.
std::unique_ptr<Journal> open_journal(const Options& options);

/// Computes what the shard has to and the journal does not know yet. Throws InputError
/// if the journal is of another study, Interrupted after Ctrl+C.
void compute(const Options& options, Journal& journal);

/// Merges the journals of `options.merge`, or of `options.out` without one, into the
/// tables of `options.out`. Throws InputError.
void merge_and_write(const Options& options);

/// What `--list` prints, for readers or as JSON.
std::string listing(const Options& options);

}  // namespace timestep::study
