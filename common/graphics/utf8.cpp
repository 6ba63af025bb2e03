#include <string>

#include "common/graphics/font.hpp"

namespace timestep {

std::u32string decode_utf8(std::string_view text) {
  constexpr char32_t k_broken = 0xFFFD;
  std::u32string letters;
  for (std::size_t i = 0; i < text.size();) {
    // The first byte says how many follow, each with six bits
    const auto first = static_cast<unsigned char>(text[i++]);
    const int more = first < 0x80   ? 0
                     : first < 0xC0 ? -1
                     : first < 0xE0 ? 1
                     : first < 0xF0 ? 2
                     : first < 0xF8 ? 3
                                    : -1;
    char32_t letter = more <= 0 ? first : first & (0x3FU >> more);
    bool whole = more >= 0;
    for (int k = 0; k < more && whole; ++k) {
      whole = i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
      if (whole)
        letter = (letter << 6U) | (static_cast<unsigned char>(text[i++]) & 0x3FU);
    }
    letters.push_back(whole ? letter : k_broken);
  }
  return letters;
}

}  // namespace timestep
