/// @file
/// Files of pairs, answered: the program's `--pairs FILE`, in both precisions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/chapter/scene.hpp"
#include "common/physics/precision.hpp"

namespace timestep {
namespace single_precision::chapter_04 {

/// What a method of `pair_methods` answers to each case of a file, as JSON: `chapter`,
/// `pairs` (the file), `method`, `precision`, and `cases`, of each its `id` and what
/// `answer_to` says. Throws InputError as `read_pair_file` does, Interrupted after
/// Ctrl+C.
std::string answer_pairs(const std::filesystem::path& file, const std::string& method);

}  // namespace single_precision::chapter_04
namespace double_precision::chapter_04 {

std::string answer_pairs(const std::filesystem::path& file, const std::string& method);

/// Its methods, by the names and in the order of `pair_methods`.
std::vector<Method> all_choices();

}  // namespace double_precision::chapter_04
}  // namespace timestep
