/// @file
/// The command line that every chapter's executable understands.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "common/chapter/plan.hpp"

namespace timestep {

/// What to do with a run. `automatic` is a window where there is a display, else
/// pictures written off-screen.
enum class Mode { automatic, window, offscreen, headless };

/// The command line as plain data. What it asks to simulate is not yet checked.
struct Options {
  Mode mode = Mode::automatic;
  bool list = false, json = false;
  Choice choice;
  std::optional<std::filesystem::path> out;  ///< folder; none: out/NN-name
  std::optional<std::string> results;        ///< file, or `-` for standard output
  std::optional<int> frames;                 ///< evenly spaced pictures
  bool movie = true;
  glm::ivec2 size{1280, 720};         ///< of a picture or the window [pixels]
  int fps = 30;                       ///< of the movie [1/s]
  std::optional<int> window_frames;   ///< the window closes by itself after these
  const FileJob* job = nullptr;       ///< do this instead, if there is one
  std::filesystem::path job_file;     ///< with this file
  std::optional<std::string> answer;  ///< print this and end: --help, --version
};

/// Reads the command line, on which each of the jobs, which must outlive the options,
/// is an option. Throws InputError, in one line, for an unknown option (with the
/// nearest ones), a missing or malformed value, or options that contradict each other.
Options parse_options(const std::string& program, int argc, const char* const* argv,
                      std::span<const FileJob> jobs = {});

}  // namespace timestep
