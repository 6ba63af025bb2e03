/// @file
/// Where the results of a run go: a file, or standard output.
#pragma once

#include <filesystem>
#include <string>

#include "common/chapter/options.hpp"
#include "common/chapter/outputs.hpp"

namespace timestep {

/// The folder of `--out`, or out/ and the chapter's name.
std::filesystem::path output_folder(const Chapter& chapter, const Options& options);

/// The file of `--results`, or results.json in the folder; meaningless if it is `-`.
std::filesystem::path results_place(const Chapter& chapter, const Options& options);

/// Where to write the results until all is complete; empty if they are to be printed.
/// Throws InputError as `Outputs::stage` does.
std::filesystem::path stage_results(Outputs& outputs, const Chapter& chapter,
                                    const Options& options);

/// Writes the results or, without a place, prints them. Throws InputError if that does
/// not work to the end.
void write_results(const std::filesystem::path& place, const Options& options,
                   const std::string& json);

}  // namespace timestep
