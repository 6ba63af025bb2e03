/// @file
/// One set of colours and shapes for pictures and plots alike. The hues are those of
/// Okabe and Ito (2008), which readers of every colour vision can tell apart, darkened
/// where needed to stand out on a light ground; shape and dash repeat what the colour
/// says.
#pragma once

#include <string>

#include "common/graphics/draw_list.hpp"

namespace timestep {

inline constexpr Color k_ink{0.13F, 0.15F, 0.18F, 1};       ///< text, exact solutions
inline constexpr Color k_muted{0.42F, 0.46F, 0.51F, 1};     ///< axes, captions
inline constexpr Color k_paper{0.985F, 0.988F, 0.992F, 1};  ///< panels, halos
inline constexpr Color k_body{0.80F, 0.82F, 0.84F, 1};      ///< bodies without a method
inline constexpr Color k_force{0.78F, 0.22F, 0.16F, 1};     ///< force arrows
inline constexpr Color k_velocity{0.05F, 0.42F, 0.66F, 1};  ///< velocity arrows
inline constexpr Color k_normal{0.00F, 0.52F, 0.40F, 1};    ///< contact normals

/// How the method of this index looks. The first eight differ in colour and in marker;
/// those up to 32 in the pair of both; then they repeat.
Style method_style(int index);

/// How the exact or reference solution looks: ink, dashed, a plus.
Style reference_style();

/// "#rrggbb"; alpha is left out.
std::string to_hex(const Color& color);

/// "circle", "square", …: as written to results.json, for plots.
const char* name(MarkerShape shape);

/// "solid", "dashed", "dotted".
const char* name(Dash dash);

}  // namespace timestep
