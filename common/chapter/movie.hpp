/// @file
/// A movie, made by piping pictures into ffmpeg.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <glm/glm.hpp>
#include <sys/types.h>

#include "common/graphics/image.hpp"

namespace timestep {

/// The full path of a program found in PATH; none if it is not there.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// An ffmpeg in the making of an H.264 movie. It is started without a shell and always
/// waited for.
class Movie {
 public:
  /// Starts `ffmpeg`, which will write `file` with pictures of `size` pixels, `fps` a
  /// second; odd sizes are padded by a pixel, as the format wants.
  Movie(const std::filesystem::path& ffmpeg, const std::filesystem::path& file,
        glm::ivec2 size, int fps);
  ~Movie();
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;

  /// Adds a picture; does nothing once ffmpeg has given up.
  void add(const Image& image);

  /// Ends the movie and waits for ffmpeg. What went wrong, in a few words; none if the
  /// movie is complete.
  std::optional<std::string> finish();

 private:
  std::filesystem::path file_;
  pid_t process_ = -1;
  int pipe_ = -1;
  bool broken_ = false;
};

}  // namespace timestep
