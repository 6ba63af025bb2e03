#include "common/graphics/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace timestep {
namespace {

constexpr std::array<Style, 8> k_methods{{
    {{0.000F, 0.447F, 0.698F, 1}, MarkerShape::circle, Dash::solid},
    {{0.835F, 0.369F, 0.000F, 1}, MarkerShape::square, Dash::solid},
    {{0.000F, 0.560F, 0.420F, 1}, MarkerShape::triangle, Dash::dashed},
    {{0.780F, 0.400F, 0.600F, 1}, MarkerShape::diamond, Dash::dashed},
    {{0.870F, 0.590F, 0.000F, 1}, MarkerShape::star, Dash::solid},
    {{0.240F, 0.630F, 0.860F, 1}, MarkerShape::ring, Dash::dotted},
    {{0.380F, 0.270F, 0.560F, 1}, MarkerShape::cross, Dash::dashed},
    {{0.480F, 0.410F, 0.130F, 1}, MarkerShape::plus, Dash::dotted},
}};

int byte_of(float channel) {
  return static_cast<int>(std::lround(std::clamp(channel, 0.0F, 1.0F) * 255));
}

}  // namespace

Style method_style(int index) {
  // Later turns keep the colours; their markers move on by three, their dashes by one
  constexpr int k_count = static_cast<int>(k_methods.size());
  constexpr int k_turns = 4;
  const int wrapped =
      (index % (k_turns * k_count) + k_turns * k_count) % (k_turns * k_count);
  const int turn = wrapped / k_count;
  const auto at = [](int i) { return static_cast<std::size_t>(i % k_count); };
  const auto dash =
      static_cast<Dash>((static_cast<int>(k_methods[at(wrapped)].dash) + turn) % 3);
  return {k_methods[at(wrapped)].color, k_methods[at(wrapped + 3 * turn)].marker, dash};
}

Style reference_style() {
  return {k_ink, MarkerShape::plus, Dash::dashed};
}

std::string to_hex(const Color& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", byte_of(color.r), byte_of(color.g),
                     byte_of(color.b));
}

const char* name(MarkerShape shape) {
  switch (shape) {
    case MarkerShape::circle:
      return "circle";
    case MarkerShape::square:
      return "square";
    case MarkerShape::triangle:
      return "triangle";
    case MarkerShape::diamond:
      return "diamond";
    case MarkerShape::cross:
      return "cross";
    case MarkerShape::plus:
      return "plus";
    case MarkerShape::star:
      return "star";
    case MarkerShape::ring:
      return "ring";
  }
  return "circle";
}

const char* name(Dash dash) {
  switch (dash) {
    case Dash::solid:
      return "solid";
    case Dash::dashed:
      return "dashed";
    case Dash::dotted:
      return "dotted";
  }
  return "solid";
}

}  // namespace timestep
