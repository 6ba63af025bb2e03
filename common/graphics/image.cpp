#include "common/graphics/image.hpp"

#include <fstream>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "common/graphics/input_error.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_FAILURE_USERMSG
#include <stb_image.h>
#ifndef __clang_analyzer__  // it would look into the library and find what is not there
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#endif
#include <stb_image_write.h>

namespace timestep {
namespace {

// Nobody looks at a picture larger than this; a broken header may claim it
constexpr int k_largest_side = 16384;

/// The picture without alpha, which a viewer would take for transparency.
std::vector<std::uint8_t> opaque_bytes(const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    rgb.insert(rgb.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
  }
  return rgb;
}

/// Whether all of the picture got into the file.
bool encode_png(const Image& image, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  const auto append = [](void* stream, void* bytes, int count) {
    static_cast<std::ofstream*>(stream)->write(static_cast<const char*>(bytes), count);
  };
  const std::vector<std::uint8_t> rgb = opaque_bytes(image);
  const bool encoded = stbi_write_png_to_func(append, &out, image.width, image.height,
                                              3, rgb.data(), image.width * 3)
                       != 0;
  out.close();
  return encoded && out;
}

}  // namespace

Image load_image(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    throw InputError(fmt::format("image {}: there is no such file", file.string()));
  }

  // Look at the header first, so that a broken one does not ask for all the memory
  Image image;
  int channels = 0;
  const std::string name = file.string();
  const bool known =
      stbi_info(name.c_str(), &image.width, &image.height, &channels) != 0;
  if (known && (image.width > k_largest_side || image.height > k_largest_side)) {
    throw InputError(
        fmt::format("image {}: more than {} pixels a side", name, k_largest_side));
  }

  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load(name.c_str(), &image.width, &image.height, &channels, 4),
      stbi_image_free);
  if (!pixels) {
    throw InputError(fmt::format("image {}: {}", name, stbi_failure_reason()));
  }
  const auto size = static_cast<std::size_t>(image.width)
                    * static_cast<std::size_t>(image.height) * 4;
  image.rgba.assign(pixels.get(), pixels.get() + size);
  return image;
}

void write_png(const Image& image, const std::filesystem::path& file) {
  const auto possible = [](int side) { return side >= 1 && side <= k_largest_side; };
  if (!possible(image.width) || !possible(image.height)) {
    throw InputError(fmt::format("image {}: {} by {} pixels; sides from 1 to {} fit",
                                 file.string(), image.width, image.height,
                                 k_largest_side));
  }

  const std::filesystem::path temporary = file.string() + ".part";
  const bool written = encode_png(image, temporary);
  std::error_code error;
  if (written) std::filesystem::rename(temporary, file, error);
  if (!written || error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw InputError(fmt::format("image {}: cannot be written", file.string()));
  }
}

}  // namespace timestep
