#include "chapters/02-verlet/parts.hpp"

#include <algorithm>

#include "common/graphics/palette.hpp"
#include "common/physics/dormand_prince.hpp"
#include "common/physics/schemes.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_02 {
namespace {

// Schemes in the chapter's order, then those for drag, then what is no scheme: a
// method's place decides how it looks
std::vector<Method> every_choice() {
  std::vector<Method> all;
  const auto add = [&](std::string_view name, std::string_view summary) {
    all.push_back({std::string(name), std::string(summary),
                   method_style(static_cast<int>(all.size()))});
  };
  for (const Scheme& scheme : schemes()) add(scheme.name, scheme.summary);
  for (const Scheme& scheme : drag_schemes()) add(scheme.name, scheme.summary);
  add(k_adaptive, "chooses its own step for a tolerance");
  add("distance_constraints", "Störmer-Verlet, then links set to their lengths");
  return all;
}

// The adaptive method has no scheme of its own; the state is all that it keeps
Scheme scheme_of(const std::string& method) {
  if (const Scheme* found = find_scheme(method)) return *found;
  return {
      .name = k_adaptive, .summary = "", .step = nullptr, .evaluations = 0, .order = 5};
}

Acceleration counted(const Acceleration& acceleration,
                     const std::shared_ptr<long long>& calls) {
  return [acceleration, calls](auto x, auto v, Real t, auto a) {
    ++*calls;
    acceleration(x, v, t, a);
  };
}

}  // namespace

std::vector<Method> choices(std::initializer_list<std::string_view> names) {
  const std::vector<Method> all = every_choice();
  std::vector<Method> chosen;
  for (const std::string_view name : names)
    chosen.push_back(*std::ranges::find(all, name, &Method::name));
  return chosen;
}

std::vector<Method> all_choices() {
  std::vector<Method> all = every_choice();
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(schemes().size());
  all.erase(first, first + static_cast<std::ptrdiff_t>(drag_schemes().size()));
  all.pop_back();  // for ropes alone
  return all;
}

Parameter tolerance_parameter() {
  return {"tolerance", "",    "of a step of dormand_prince, relative and absolute",
          1e-9,        1e-14, 0.1};
}

SchemeRun::SchemeRun(const Setup& setup, const Acceleration& acceleration,
                     const State& start, double time_lapse)
    : setup_(setup),
      dt_(setup.dt * time_lapse),
      integration_(begin(scheme_of(setup.method), counted(acceleration, calls_), start,
                         Real(dt_))) {}

void SchemeRun::step() {
  const long long before = *calls_;
  if (is_adaptive()) {
    const Real tolerance = Real(setup_.parameters.at("tolerance"));
    dormand_prince(integration_.state, integration_.acceleration, Real(time()),
                   Real(time() + dt_), {tolerance, tolerance});
    ++integration_.steps;
  } else {
    advance(integration_);
  }
  evaluations_ += *calls_ - before;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_02
