#include "study/journal.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "common/graphics/input_error.hpp"

namespace timestep::study {
namespace {

namespace fs = std::filesystem;

InputError trouble(const fs::path& file, const std::string& what) {
  return InputError(fmt::format("{}: {}", file.string(), what));
}

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw trouble(file, "cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The records of the whole lines of a text, and how many bytes those take.
std::vector<Record> parse(const fs::path& file, const std::string& text,
                          std::size_t& whole) {
  std::vector<Record> records;
  whole = 0;
  for (std::size_t end = 0; (end = text.find('\n', whole)) != std::string::npos;
       whole = end + 1) {
    try {
      records.push_back(from_line(text.substr(whole, end - whole)));
    } catch (const std::exception&) {
      throw trouble(
          file, fmt::format("line {} is no record of the study", records.size() + 1));
    }
  }
  return records;
}

/// Opens the file for this process alone.
int open_alone(const fs::path& file) {
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  const int descriptor =
      open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0)
    throw trouble(file, fmt::format("cannot be written: {}", std::strerror(errno)));
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    const bool in_use = errno == EWOULDBLOCK;
    close(descriptor);
    throw trouble(file, in_use ? "another study is writing to it" : "cannot be locked");
  }
  return descriptor;
}

}  // namespace

Journal::Journal(const fs::path& file) : file_(file), descriptor_(open_alone(file)) {
  try {
    std::size_t whole = 0;
    for (Record& record : parse(file, contents(file), whole))
      records_[record.key] = std::move(record);
    if (ftruncate(descriptor_, static_cast<off_t>(whole)) != 0)
      throw trouble(file, "its torn last line cannot be cut off");
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

Journal::~Journal() {
  close(descriptor_);
}

void Journal::append(const Record& record) {
  const std::string line = to_line(record) + "\n";
  const auto length = static_cast<ssize_t>(line.size());
  if (write(descriptor_, line.data(), line.size()) != length || fsync(descriptor_) != 0)
    throw trouble(file_, fmt::format("cannot be written: {}", std::strerror(errno)));
  records_[record.key] = record;
}

void Journal::know(const std::vector<Record>& others) {
  for (const Record& record : others) {
    const Record* own = find(record.key);
    if (own == nullptr || (own->repeats == 0 && record.repeats > 0))
      records_[record.key] = record;
  }
}

const Record* Journal::find(const std::string& key) const {
  const auto found = records_.find(key);
  return found == records_.end() ? nullptr : &found->second;
}

std::vector<Record> read_journal(const fs::path& file) {
  std::size_t whole = 0;
  return parse(file, contents(file), whole);
}

}  // namespace timestep::study
