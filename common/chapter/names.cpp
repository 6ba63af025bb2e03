#include "common/chapter/names.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace timestep {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before_last, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), 0);

  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});

      const bool swapped =
          i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = std::exchange(last, row);
  }
  return last[b.size()];
}

std::vector<std::string> nearest_names(std::string_view wrong,
                                       std::span<const std::string> names) {
  const int limit = std::max(2, static_cast<int>(wrong.size()) / 3);
  std::vector<std::pair<int, std::string>> near;
  for (const std::string& name : names) {
    const bool contained = wrong.size() > 2 && name.find(wrong) != std::string::npos;
    const int distance = contained ? 1 : edit_distance(wrong, name);
    if (distance <= limit && distance < static_cast<int>(name.size())) {
      near.emplace_back(distance, name);
    }
  }

  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  near.resize(std::min<std::size_t>(near.size(), 3));
  std::vector<std::string> result;
  for (const auto& [distance, name] : near) result.push_back(name);
  return result;
}

std::string unknown_name(std::string_view kind, std::string_view wrong,
                         std::span<const std::string> names) {
  const std::vector<std::string> near = nearest_names(wrong, names);
  if (!near.empty()) {
    return fmt::format("unknown {} \"{}\"; did you mean {}?", kind, wrong,
                       fmt::join(near, " or "));
  }
  if (names.empty())
    return fmt::format("unknown {} \"{}\"; there is none", kind, wrong);
  return fmt::format("unknown {} \"{}\"; choose from {}", kind, wrong,
                     fmt::join(names, ", "));
}

}  // namespace timestep
