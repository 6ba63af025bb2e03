/// @file
/// Pictures in ordinary memory, read through stb and written as PNG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace timestep {

/// Rows from the top, four bytes a pixel: red, green, blue (sRGB), alpha.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Reads a PNG, JPEG or another format that stb_image knows. Throws InputError if the
/// file is missing, a folder, or not a readable image.
Image load_image(const std::filesystem::path& file);

/// Writes a PNG without its alpha, of 1 to 16384 pixels a side. The file appears
/// complete or not at all: it is written beside its place under a temporary name, then
/// renamed. Throws InputError if it cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

}  // namespace timestep
