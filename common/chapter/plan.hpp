/// @file
/// From what the user asked for to what will be done: every name looked up, every
/// number checked, the defaults filled in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/chapter/scene.hpp"

namespace timestep {

enum class Precision { single_bits, double_bits };

/// "single" or "double".
const char* name(Precision precision);

/// Throws InputError for any other word.
Precision parse_precision(const std::string& text);

/// What the user asked for, as typed. The same for the command line and the panel.
struct Choice {
  std::optional<std::string> scene{};  ///< none: the first one
  std::vector<std::string>
      methods{};  ///< none: the scene's default; `all` stands alone
  std::string precision = "double";
  std::optional<std::string> dt{}, duration{};  ///< [s]; none: the scene's default
  std::optional<std::string> preset{};
  std::vector<std::pair<std::string, std::string>> settings{};  ///< win over the preset
  std::optional<std::filesystem::path> mesh{};
  bool fix_winding = false;
};

/// What will be simulated. Points into the chapter, which must outlive it.
struct Plan {
  const Chapter* chapter = nullptr;
  const Scene* scene = nullptr;
  Precision precision = Precision::double_bits;
  std::vector<Setup> setups;   ///< one a method, equal but for method and style
  double dt = 0;               ///< step [s]
  double duration = 0;         ///< asked for [s]
  long long steps = 0;         ///< as many whole steps as fit in the duration
  std::string preset;          ///< empty if none
  std::filesystem::path mesh;  ///< empty if none
  bool fix_winding = false;    ///< turn a mesh that is inside out

  /// Simulated time after so many steps [s]: a product, so that no error adds up.
  double time(long long step) const { return static_cast<double>(step) * dt; }
};

/// A run of more steps than this is taken for a slip of the keyboard.
inline constexpr double k_max_steps = 1e9;

/// Throws InputError, in one line that names the option, the value and what would be
/// valid, for an unknown scene, method, precision, parameter or preset; a step,
/// duration or parameter that is not a number or out of range; a mesh, or its winding,
/// that the scene does not take.
Plan make_plan(const Chapter& chapter, const Choice& choice);

/// The scenes of one precision.
const std::vector<Scene>& scenes_of(const Chapter& chapter, Precision precision);

}  // namespace timestep
