/// @file
/// The cheapest setting of a problem that is right enough, or the most accurate one
/// that is cheap enough. Source: chapter 7.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "study/cell.hpp"
#include "study/measure.hpp"

namespace timestep::study {

/// An error at most, in the metric's unit; or a cost at most, in microseconds a frame.
struct Wish {
  enum class Kind { error, budget };
  Kind kind = Kind::error;
  double value = 0;
};

/// What measures a cell, so that a search can be tested without any simulation.
struct Meter {
  std::function<ErrorResult(const Cell&)> error;
  std::function<TimeResult(const Cell&)> time;
};

/// A cell beside the chosen one: a step 3 % shorter or longer, another start.
struct Probe {
  std::string what;  ///< "dt x 0.97", "seed = 2", "speed x 1.01"
  Cell cell;
  double error = 0;
};

/// A setting that was looked at.
struct Trial {
  Cell cell;
  double cost = 0;    ///< [us] a frame, from the time of another step of this setting
  TimeResult time{};  ///< of this very cell, if it came so far
  double error = std::numeric_limits<double>::infinity();  ///< infinite: it failed
  double worst = error;                                    ///< of it and its probes
  std::vector<Probe> probes;  ///< those that were taken: none after one that fails
  std::string refused;        ///< why; empty if it serves
};

/// What a search comes to.
struct Outcome {
  bool met = false;
  Trial best;                   ///< the answer, or what came nearest to the wish
  std::vector<Trial> tried;     ///< the cheapest first
  std::vector<Probe> fresh;     ///< starts that had no part in the choice of an answer
  std::size_t left_out = 0;     ///< cells of which one run would have taken too long
  std::size_t not_reached = 0;  ///< cells still ahead when the time was over
};

/// How long a search may take.
struct Patience {
  double longest_run = 3;  ///< [s] of a single run, as far as its cost tells
  std::function<bool()> is_over = [] { return false; };  ///< try no more
};

/// Looks through `cells` of one problem, which differ in method, precision, settings
/// and step. Cost is taken as one over the step. For an error, cells are tried from the
/// cheapest on until one serves, that is, meets the wish together with its probes; then
/// steps between those of `cells` are tried, of this setting and of all others, down to
/// where they would be dearer. For a budget, of each setting the shortest affordable
/// step and two longer ones are tried, the least worst error wins. What is chosen
/// because its probes are good is better there than elsewhere: while there is time, the
/// answer is run from fresh starts too, which change it no more. `progress` gets the
/// share done. Throws InputError if there is no time to try any cell.
Outcome tune(const std::vector<Cell>& cells, const Wish& wish, const Meter& meter,
             const Patience& patience, const std::function<void(double)>& progress);

/// What a parameter of the scene is in a cell: set by it, by its problem, or the
/// default. Throws std::out_of_range if the scene has none of that name.
double setting(const Cell& cell, const std::string& name);

/// Cells beside one: 3 % to either side of its step; other starts of its scene: the
/// next eight seeds, or a number of the start 1 % to either side; and fresh starts:
/// eight seeds more, or half a percent to either side. A number at the end of its range
/// goes one and a half times as far to the other side.
std::vector<Probe> neighbours(const Cell& cell);
std::vector<Probe> other_starts(const Cell& cell);
std::vector<Probe> fresh_starts(const Cell& cell);

/// How many of the fresh starts err no more than was wished for, or, for a budget, than
/// the worst of the answer's probes.
std::size_t held(const Outcome& outcome, const Wish& wish);

}  // namespace timestep::study
