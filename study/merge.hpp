/// @file
/// From journals to tables: however the work was shared out, the same bytes.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "study/cell.hpp"
#include "study/record.hpp"

namespace timestep::study {

/// Which part of the study is merged, and whether all of it must be there.
struct Wanted {
  std::vector<Cell> cells;
  bool times = true;     ///< every cell that did not fail has its time
  bool partial = false;  ///< what is missing is left out
};

/// The journals (*.jsonl) of folders and files, by name. Throws InputError for a place
/// that is neither, and if there is none at all.
std::vector<std::filesystem::path> journals_of(
    std::span<const std::filesystem::path> places);

/// The wanted records in the order of the cells; after those of a problem, its peers'
/// by key. Throws InputError if something is missing, if there is none at all, or if
/// two records of a cell differ in more than their times.
std::vector<Record> merge(std::span<const std::filesystem::path> journals,
                          const Wanted& wanted);

/// A head and a line a record. The last three columns are the measured times.
std::string csv_text(std::span<const Record> records);

/// An array with a record a line.
std::string json_text(std::span<const Record> records);

/// The fronts of all problems in the records, each as a table in Markdown: over time,
/// or over evaluations where no times were taken.
std::string front_text(std::span<const Record> records);

/// Writes study.csv, study.json and front.md into the folder: all or none. Throws
/// InputError if that cannot be.
void write_tables(std::span<const Record> records, const std::filesystem::path& folder);

}  // namespace timestep::study
