#include "common/chapter/filmstrip.hpp"

#include <algorithm>
#include <cstddef>

namespace timestep {

Image side_by_side(std::span<const Image> images) {
  constexpr int k_gap = 4;
  if (images.empty()) return {};
  const int width = images.front().width, height = images.front().height;
  const int count = static_cast<int>(images.size());
  Image strip{
      .width = count * width + (count - 1) * k_gap, .height = height, .rgba = {}};
  strip.rgba.assign(static_cast<std::size_t>(strip.width * strip.height) * 4, 255);

  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const Image& image = images[static_cast<std::size_t>(i)];
    for (std::ptrdiff_t y = 0; y < height; ++y) {
      std::copy_n(image.rgba.begin() + y * width * 4, width * 4,
                  strip.rgba.begin() + (y * strip.width + i * (width + k_gap)) * 4);
    }
  }
  return strip;
}

}  // namespace timestep
