#include "common/chapter/listing.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "common/chapter/numbers.hpp"
#include "common/graphics/palette.hpp"

namespace timestep {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t k_columns = 88;

/// `lead`, then the text's words, wrapped at 88 columns and indented.
std::string wrapped(const std::string& lead, std::size_t indent,
                    const std::string& text) {
  std::string result = lead;
  std::size_t used = lead.size(), begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::size_t length = end - begin;
    if (used + 1 + length > k_columns && used > indent) {
      result += fmt::format("\n{:{}}", "", indent);
      used = indent;
    }
    result += fmt::format(" {}", text.substr(begin, length));
    used += 1 + length;
    begin = end + 1;
  }
  return result + "\n";
}

template <typename T>
std::size_t name_column(const std::vector<T>& things) {
  std::size_t longest = 0;
  for (const T& thing : things) longest = std::max(longest, thing.name.size());
  return longest;
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? plain_text(value) : plain_text(value) + " " + unit;
}

std::string parameter_text(const Parameter& parameter) {
  return fmt::format("{} ({}{} to {})  {}", with_unit(parameter.value, parameter.unit),
                     parameter.integer ? "whole, " : "", plain_text(parameter.minimum),
                     plain_text(parameter.maximum), parameter.help);
}

std::string preset_text(const Preset& preset) {
  std::vector<std::string> values;
  for (const auto& [parameter, value] : preset.values) {
    values.push_back(parameter + "=" + plain_text(value));
  }
  return fmt::format("{}. Source: {}", fmt::join(values, " "), preset.source);
}

template <typename T, typename Describe>
std::string section(const char* heading, const std::vector<T>& things,
                    Describe describe) {
  if (things.empty()) return "";
  std::string text = fmt::format("  {}\n", heading);
  const std::size_t column = name_column(things);
  for (const T& thing : things) {
    const std::string lead = fmt::format("    {:<{}}", thing.name, column);
    text += wrapped(lead, column + 4, describe(thing));
  }
  return text;
}

const char* mesh_text(const Scene& scene) {
  if (!scene.takes_mesh) return "";
  return scene.fixes_winding ? ", takes --mesh and --fix-winding" : ", takes --mesh";
}

std::string scene_text(const Scene& scene) {
  std::string text = "\n" + wrapped(scene.name + ":", 1, scene.summary);
  text += fmt::format("  dt {}, duration {} s{}\n", step_text(scene.dt), scene.duration,
                      mesh_text(scene));
  const auto drawn = fmt::format("{}", fmt::join(scene.default_methods, ", "));
  text += wrapped("  by default drawn with", 3, drawn);
  text += section("methods", scene.methods, [](const Method& m) { return m.summary; });
  text +=
      section("parameters: default (valid range)", scene.parameters, parameter_text);
  text += section("presets", scene.presets, preset_text);
  return text;
}

std::string job_text(const FileJob& job) {
  return "\n" + wrapped(fmt::format("--{} FILE:", job.option), 1, job.summary)
         + section("methods", job.methods, [](const Method& m) { return m.summary; });
}

Json method_json(const Method& method) {
  return {{"name", method.name},
          {"summary", method.summary},
          {"color", to_hex(method.style.color)},
          {"marker", name(method.style.marker)},
          {"dash", name(method.style.dash)}};
}

Json parameter_json(const Parameter& parameter) {
  return {{"name", parameter.name},       {"unit", parameter.unit},
          {"help", parameter.help},       {"default", parameter.value},
          {"minimum", parameter.minimum}, {"maximum", parameter.maximum},
          {"integer", parameter.integer}};
}

Json preset_json(const Preset& preset) {
  return {{"name", preset.name}, {"source", preset.source}, {"values", preset.values}};
}

template <typename T, typename Describe>
Json array_of(const std::vector<T>& things, Describe describe) {
  Json array = Json::array();
  for (const T& thing : things) array.push_back(describe(thing));
  return array;
}

Json scene_json(const Scene& scene) {
  return {{"name", scene.name},
          {"summary", scene.summary},
          {"dt", scene.dt},
          {"duration", scene.duration},
          {"takes_mesh", scene.takes_mesh},
          {"fixes_winding", scene.fixes_winding},
          {"chart_metric", scene.chart_metric},
          {"default_methods", scene.default_methods},
          {"methods", array_of(scene.methods, method_json)},
          {"parameters", array_of(scene.parameters, parameter_json)},
          {"presets", array_of(scene.presets, preset_json)}};
}

Json job_json(const FileJob& job) {
  return {{"option", job.option},
          {"summary", job.summary},
          {"methods", array_of(job.methods, method_json)}};
}

}  // namespace

std::string list_text(const Chapter& chapter) {
  std::string text = fmt::format("{}: {}\n", chapter.name, chapter.title);
  for (const Scene& scene : chapter.double_precision) text += scene_text(scene);
  for (const FileJob& job : chapter.file_jobs) text += job_text(job);
  return text;
}

std::string list_json(const Chapter& chapter) {
  const Json json{{"chapter", chapter.name},
                  {"title", chapter.title},
                  {"scenes", array_of(chapter.double_precision, scene_json)},
                  {"file_jobs", array_of(chapter.file_jobs, job_json)}};
  return json.dump(2) + "\n";
}

}  // namespace timestep
