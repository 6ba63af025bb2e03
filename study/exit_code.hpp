/// @file
/// How every program of the study ends.
#pragma once

#include <functional>
#include <string>
#include <type_traits>

namespace timestep::study {

/// What a study says after Ctrl+C.
inline constexpr const char* k_goes_on =
    "interrupted; what is done is kept, and the same command goes on";

/// The code that `work` returns, or 1 if it failed, 2 for wrong input, 130 after
/// Ctrl+C, each with one line on standard error.
int code_of(const std::string& program, const std::function<int()>& work,
            const std::string& interrupted);

/// The same of work that returns a code or, for 0, nothing.
int exit_code_of(const std::string& program, const auto& work,
                 const std::string& interrupted = "interrupted") {
  if constexpr (std::is_void_v<decltype(work())>)
    return code_of(
        program, [&] { return work(), 0; }, interrupted);
  else
    return code_of(program, work, interrupted);
}

}  // namespace timestep::study
