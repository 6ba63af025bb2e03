/// @file
/// What is known of a cell, as one line of JSON.
#pragma once

#include <limits>
#include <map>
#include <string>

#include "study/measure.hpp"

namespace timestep::study {

inline constexpr double k_not_measured = std::numeric_limits<double>::quiet_NaN();

/// The result of a cell, or of a peer that was given the same task.
struct Record {
  std::string key, problem, chapter, scene, metric;
  double frame = 0, duration = 0;  ///< [s]
  std::string method, precision;
  double dt = 0;                             ///< [s]
  std::map<std::string, double> settings{};  ///< other than the scene's defaults
  double error = 0;                          ///< [unit]; NaN if it failed
  std::string unit;
  long long evaluations = 0, steps = 0, bodies = 0;
  std::string failed;                    ///< words; empty if it did not
  double us_per_frame = k_not_measured;  ///< [µs]
  double spread = k_not_measured;  ///< range between the quartiles over the median
  int repeats = 0;                 ///< timed runs; 0: not timed
  bool peer = false;               ///< another library's
};

/// A record without times.
Record record_of(const Cell& cell, const ErrorResult& result);

/// The record with what `measure_time` found.
Record timed(Record record, const TimeResult& time);

/// Whether it has no time yet and can have one.
bool wants_time(const Record& record);

/// Whether both say the same of everything but time, bit for bit.
bool same_but_time(const Record& a, const Record& b);

/// Whether the record is what this cell gives: of the same scene, metric, duration,
/// frame and settings, and of as many steps unless it failed.
bool belongs_to(const Record& record, const Cell& cell);

/// One line without its end. Doubles read back to the same bits; what is not finite
/// stands as "nan", "inf", "-inf".
std::string to_line(const Record& record);

/// Reads such a line. Throws std::exception with words if it is not one.
Record from_line(const std::string& line);

/// Force evaluations or contact solves in a frame of the scene.
double evaluations_per_frame(const Record& record, double frame);

}  // namespace timestep::study
