/// @file
/// What a program says while it works: results on standard output, remarks on standard
/// error.
#pragma once

#include <chrono>
#include <string>

namespace timestep {

/// Takes the places of standard input, output and error if the caller closed them: a
/// file that is opened later would get them, and what is meant for them. Using them
/// still fails.
void keep_standard_streams();

/// Prints to standard output. Throws InputError if nobody can take it.
void print_out(const std::string& text);

/// One line on standard error, after the program's name: a control character that a
/// name in it may hold becomes a question mark. Nothing happens if nobody can take it.
void print_note(const std::string& program, const std::string& text);

/// Shows the share done on standard error, if that is a terminal, once a run takes
/// longer than a second; wiped off at the end.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The share done, from 0 to 1.
  void show(double share);

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  bool terminal_ = false;
  int shown_ = -1;  // percent; nothing yet
};

}  // namespace timestep
