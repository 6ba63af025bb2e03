#include "common/chapter/json_file.hpp"

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

using Json = nlohmann::json;
using Event = Json::parse_event_t;

/// Looks at the document while it is read.
class Checks {
 public:
  /// Keeps lists in lists in lists from exhausting the stack of those who walk them.
  bool operator()(int depth, Event event, const Json& parsed) {
    constexpr int k_deepest = 32;
    if (depth > k_deepest) throw InputError(fmt::format("deeper than {}", k_deepest));
    if (event == Event::object_start) names_.emplace_back();
    if (event == Event::object_end) names_.pop_back();
    if (event == Event::key && !names_.back().insert(parsed).second)
      throw InputError(fmt::format("{} is named twice", parsed.dump(-1, ' ', true)));
    return true;
  }

 private:
  std::vector<std::set<std::string>> names_;  // in each open object
};

/// The library's words without its own name and, since it may be of any length and no
/// text at all, without what it read last.
std::string explain(const std::exception& error) {
  constexpr std::size_t k_longest = 200;
  std::string text = error.what();
  if (text.starts_with("[json")) text.erase(0, text.find(']') + 2);
  text = text.substr(0, text.find("; last read"));
  if (text.size() > k_longest) text = text.substr(0, k_longest) + "…";
  return text;
}

}  // namespace

nlohmann::json load_json(const std::filesystem::path& file) {
  std::error_code ignored;
  std::ifstream in;
  if (std::filesystem::is_regular_file(file, ignored)) in.open(file);
  if (!in.is_open())
    throw InputError(fmt::format("{}: is not a file that can be read", file.string()));
  Checks checks;
  try {
    return Json::parse(in, [&](int depth, Event event, Json& parsed) {
      return checks(depth, event, parsed);
    });
  } catch (const std::exception& error) {
    throw InputError(
        fmt::format("{}: not a JSON file: {}", file.string(), explain(error)));
  }
}

}  // namespace timestep
