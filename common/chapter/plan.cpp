#include "common/chapter/plan.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/chapter/names.hpp"
#include "common/chapter/numbers.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

using Names = std::vector<std::string>;

template <typename T>
Names names_of(const std::vector<T>& things) {
  Names names;
  for (const T& thing : things) names.push_back(thing.name);
  return names;
}

/// The thing of that name; throws InputError with the nearest names if there is none.
template <typename T>
const T& find_named(const std::vector<T>& things, const std::string& wanted,
                    const std::string& kind) {
  const auto found = std::find_if(things.begin(), things.end(),
                                  [&](const T& thing) { return thing.name == wanted; });
  if (found == things.end()) {
    throw InputError(unknown_name(kind, wanted, names_of(things)));
  }
  return *found;
}

Names choose_methods(const Scene& scene, const Names& asked) {
  const Names all = names_of(scene.methods);
  if (asked == Names{"all"}) return all;
  if (asked.empty()) {
    return scene.default_methods.empty() ? Names{all.at(0)} : scene.default_methods;
  }

  Names chosen;
  for (const std::string& method : asked) {
    if (method.empty()) throw InputError("--method: an empty name between the commas");
    find_named(scene.methods, method, "method of scene " + scene.name);
    if (std::find(chosen.begin(), chosen.end(), method) != chosen.end()) {
      throw InputError(fmt::format("--method: {} is named twice", method));
    }
    chosen.push_back(method);
  }
  return chosen;
}

double parse_seconds(const char* option, const std::string& text) {
  const std::optional<double> value = parse_number(text);
  if (!value || *value <= 0) {
    throw InputError(
        fmt::format("{} {}: must be a finite number of seconds greater than 0, such as "
                    "0.01 or 1/60",
                    option, text.empty() ? "\"\"" : text));
  }
  return *value;
}

void choose_step(Plan& plan, const Choice& choice) {
  plan.duration = choice.duration ? parse_seconds("--duration", *choice.duration)
                                  : plan.scene->duration;
  plan.dt = choice.dt ? parse_seconds("--dt", *choice.dt) : plan.scene->dt;

  const std::string dt = plain_text(plan.dt), duration = plain_text(plan.duration);
  if (plan.dt > plan.duration) {
    throw InputError(
        fmt::format("--dt {} s does not fit in a duration of {} s; choose dt "
                    "from above 0 to {} s",
                    dt, duration, duration));
  }
  const double steps = plan.duration / plan.dt;
  if (steps > k_max_steps) {
    throw InputError(fmt::format(
        "--dt {} s over {} s makes {:.3g} steps, and {:.0e} are "
        "the limit; choose dt from {:.3g} to {} s",
        dt, duration, steps, k_max_steps, plan.duration / k_max_steps, duration));
  }
  // The billionth forgives the rounding of the division, as in 5 s of 1/60 s
  plan.steps = static_cast<long long>(std::floor(steps * (1 + 1e-9)));
}

double parse_setting(const Parameter& parameter, const std::string& text) {
  const std::optional<double> value = parse_number(text);
  const bool whole = value && std::floor(*value) == *value;
  const bool fits = value && *value >= parameter.minimum && *value <= parameter.maximum;
  if (!fits || (parameter.integer && !whole)) {
    throw InputError(
        fmt::format("--set {}={}: must be a {} from {} to {}{}{}", parameter.name, text,
                    parameter.integer ? "whole number" : "number",
                    plain_text(parameter.minimum), plain_text(parameter.maximum),
                    parameter.unit.empty() ? "" : " ", parameter.unit));
  }
  return *value;
}

std::map<std::string, double> choose_parameters(const Scene& scene,
                                                const Choice& choice) {
  std::map<std::string, double> values;
  for (const Parameter& parameter : scene.parameters) {
    values[parameter.name] = parameter.value;
  }
  if (choice.preset) {
    const std::string kind = "preset of scene " + scene.name;
    const Preset& preset = find_named(scene.presets, *choice.preset, kind);
    for (const auto& [parameter, value] : preset.values) values[parameter] = value;
  }
  std::set<std::string> already;
  for (const auto& [wanted, text] : choice.settings) {
    const std::string kind = "parameter of scene " + scene.name;
    const Parameter& parameter = find_named(scene.parameters, wanted, kind);
    values[parameter.name] = parse_setting(parameter, text);
    if (!already.insert(wanted).second) {
      throw InputError(fmt::format("--set {}: is given more than once", wanted));
    }
  }
  return values;
}

std::filesystem::path choose_mesh(const Scene& scene, const Choice& choice) {
  if (!choice.mesh) return {};
  if (!scene.takes_mesh) {
    throw InputError(fmt::format("--mesh {}: scene {} takes no mesh",
                                 choice.mesh->string(), scene.name));
  }
  if (choice.mesh->empty()) throw InputError("--mesh: the file's name is empty");
  return *choice.mesh;
}

bool choose_fix_winding(const Scene& scene, const Choice& choice) {
  if (!choice.fix_winding) return false;
  if (!scene.fixes_winding) {
    throw InputError(
        fmt::format("--fix-winding: scene {} takes no solid mesh", scene.name));
  }
  if (!choice.mesh) throw InputError("--fix-winding: there is no --mesh to turn");
  return true;
}

}  // namespace

const char* name(Precision precision) {
  return precision == Precision::single_bits ? "single" : "double";
}

Precision parse_precision(const std::string& text) {
  const Names names{"single", "double"};
  if (text == names[0]) return Precision::single_bits;
  if (text == names[1]) return Precision::double_bits;
  throw InputError(unknown_name("precision", text, names));
}

const std::vector<Scene>& scenes_of(const Chapter& chapter, Precision precision) {
  return precision == Precision::single_bits ? chapter.single_precision
                                             : chapter.double_precision;
}

Plan make_plan(const Chapter& chapter, const Choice& choice) {
  Plan plan;
  plan.chapter = &chapter;
  plan.precision = parse_precision(choice.precision);
  const std::vector<Scene>& scenes = scenes_of(chapter, plan.precision);
  plan.scene =
      choice.scene ? &find_named(scenes, *choice.scene, "scene") : &scenes.at(0);
  const Scene& scene = *plan.scene;

  const Names methods = choose_methods(scene, choice.methods);
  choose_step(plan, choice);
  plan.preset = choice.preset.value_or("");
  plan.mesh = choose_mesh(scene, choice);
  plan.fix_winding = choose_fix_winding(scene, choice);
  const std::map<std::string, double> parameters = choose_parameters(scene, choice);

  for (const std::string& method : methods) {
    const Style style = find_named(scene.methods, method, "method").style;
    plan.setups.push_back({.method = method,
                           .style = style,
                           .lane = plan.setups.size(),
                           .lanes = methods.size(),
                           .dt = plan.dt,
                           .duration = plan.duration,
                           .parameters = parameters,
                           .mesh = plan.mesh,
                           .fix_winding = plan.fix_winding});
  }
  return plan;
}

}  // namespace timestep
