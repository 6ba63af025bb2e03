#include "study/problem.hpp"

#include <algorithm>
#include <set>

#include "common/chapter/names.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep::study {

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all = [] {
    std::vector<Problem> joined;
    for (const auto& part :
         {particle_problems(), verlet_problems(), rotation_problems(),
          contact_problems(), impact_problems(), stack_problems()})
      joined.insert(joined.end(), part.begin(), part.end());
    return joined;
  }();
  return all;
}

std::vector<const Problem*> chosen_problems(std::span<const std::string> names) {
  std::set<std::string> known;
  for (const Problem& problem : problems()) known.insert({problem.name, problem.scene});
  for (const std::string& name : names)
    if (!known.contains(name))
      throw InputError(unknown_name(
          "scene", name, std::vector<std::string>(known.begin(), known.end())));

  std::vector<const Problem*> chosen;
  for (const Problem& problem : problems()) {
    const auto is_meant = [&](const std::string& name) {
      return name == problem.name || name == problem.scene;
    };
    if (names.empty() || std::ranges::any_of(names, is_meant))
      chosen.push_back(&problem);
  }
  return chosen;
}

std::vector<double> halved(double longest, int count) {
  std::vector<double> steps;
  for (double dt = longest; count > 0; dt /= 2, --count) steps.push_back(dt);
  return steps;
}

}  // namespace timestep::study
