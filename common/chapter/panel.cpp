#include "common/chapter/panel.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "common/chapter/numbers.hpp"

namespace timestep {
namespace {

const Scene& scene_of(const Controls& controls) {
  const auto& scenes = scenes_of(*controls.chapter, controls.precision);
  for (const Scene& scene : scenes) {
    if (scene.name == controls.scene) return scene;
  }
  return scenes.at(0);
}

void tooltip(const std::string& text) {
  if (!text.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
}

/// Goes over to another scene with all its defaults.
void choose_scene(Controls& controls, const std::string& scene) {
  const Choice choice{.scene = scene, .precision = name(controls.precision)};
  const Controls fresh = controls_for(make_plan(*controls.chapter, choice));
  const double speed = controls.speed;
  controls = fresh;
  controls.speed = speed;
}

bool draw_scene_box(Controls& controls) {
  bool changed = false;
  if (ImGui::BeginCombo("scene", controls.scene.c_str())) {
    for (const Scene& scene : scenes_of(*controls.chapter, controls.precision)) {
      const bool chosen = scene.name == controls.scene;
      if (ImGui::Selectable(scene.name.c_str(), chosen) && !chosen) {
        choose_scene(controls, scene.name);
        changed = true;
      }
      tooltip(scene.summary);
    }
    ImGui::EndCombo();
  }
  ImGui::TextWrapped("%s", scene_of(controls).summary.c_str());
  return changed;
}

bool draw_methods(Controls& controls) {
  bool changed = false;
  for (const Method& method : scene_of(controls).methods) {
    const Color& c = method.style.color;
    bool on = controls.methods.contains(method.name);
    ImGui::PushStyleColor(ImGuiCol_CheckMark, ImVec4(c.r, c.g, c.b, 1));
    if (ImGui::Checkbox(method.name.c_str(), &on)) {
      if (on) controls.methods.insert(method.name);
      if (!on && controls.methods.size() > 1) controls.methods.erase(method.name);
      changed = true;
    }
    ImGui::PopStyleColor();
    tooltip(method.summary);
  }
  return changed;
}

bool draw_number(const std::string& label, double& value, double minimum,
                 double maximum, const std::string& unit, bool integer = false) {
  // A range of many sizes needs a logarithmic scale; the unit may hold a percent sign
  const bool wide = minimum > 0 && maximum / minimum > 100;
  std::string format = integer ? "%.0f" : "%.5g";
  if (!unit.empty()) format += " ";
  for (const char c : unit) format += c == '%' ? "%%" : std::string(1, c);

  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_AlwaysClamp
      | (wide ? ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat : 0);
  const double before = value;
  const bool moved = ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, &value,
                                         &minimum, &maximum, format.c_str(), flags);
  if (integer) value = std::round(value);
  return moved && value != before;
}

bool draw_step(Controls& controls) {
  int bits = controls.precision == Precision::double_bits ? 1 : 0;
  bool changed = ImGui::RadioButton("single", &bits, 0);
  ImGui::SameLine();
  changed |= ImGui::RadioButton("double precision", &bits, 1);
  controls.precision = bits == 1 ? Precision::double_bits : Precision::single_bits;

  constexpr double k_smallest_dt = 1e-5;
  changed |= draw_number("dt", controls.dt, k_smallest_dt, controls.duration, "s");
  const double standard = scene_of(controls).duration;
  changed |=
      draw_number("duration", controls.duration, standard / 10, standard * 10, "s");
  controls.dt = std::min(controls.dt, controls.duration);
  return changed;
}

void choose_preset(Controls& controls, const Preset& preset) {
  for (const Parameter& parameter : scene_of(controls).parameters) {
    controls.parameters[parameter.name] = parameter.value;
  }
  for (const auto& [parameter, value] : preset.values) {
    controls.parameters[parameter] = value;
  }
  controls.preset = preset.name;
}

bool draw_presets(Controls& controls) {
  const Scene& scene = scene_of(controls);
  if (scene.presets.empty()) return false;
  bool changed = false;
  const char* const shown = controls.preset.empty() ? "none" : controls.preset.c_str();
  if (ImGui::BeginCombo("preset", shown)) {
    for (const Preset& preset : scene.presets) {
      if (ImGui::Selectable(preset.name.c_str(), preset.name == controls.preset)) {
        choose_preset(controls, preset);
        changed = true;
      }
      tooltip(preset.source);
    }
    ImGui::EndCombo();
  }
  return changed;
}

bool draw_parameters(Controls& controls) {
  bool changed = false;
  for (const Parameter& parameter : scene_of(controls).parameters) {
    changed |= draw_number(parameter.name, controls.parameters[parameter.name],
                           parameter.minimum, parameter.maximum, parameter.unit,
                           parameter.integer);
    tooltip(parameter.help);
  }
  return changed;
}

Wishes draw_transport(Controls& controls, const Session& session) {
  Wishes wishes;
  wishes.pause = ImGui::Button(session.ended()   ? "again"
                               : controls.paused ? "run"
                                                 : "pause");
  tooltip("space");
  ImGui::SameLine();
  wishes.back = ImGui::Button("back");
  tooltip("the , key");
  ImGui::SameLine();
  wishes.step = ImGui::Button("step");
  tooltip("the . key");
  ImGui::SameLine();
  wishes.restart = ImGui::Button("reset");
  tooltip("R");
  ImGui::SameLine();
  ImGui::Text("t = %.2f s%s", session.time(), session.ended() ? " (end)" : "");
  draw_number("speed", controls.speed, 0.01, 10, "x");
  if (session.dropped() > 0) ImGui::Text("%.2f s dropped: too slow", session.dropped());
  return wishes;
}

void draw_metrics(Controls& controls, Session& session) {
  if (session.lanes().empty()) return;
  const std::vector<Metric>& metrics = session.lanes().front().metrics;
  if (ImGui::BeginCombo("graph", controls.metric.c_str())) {
    for (const Metric& metric : metrics) {
      const bool chosen = metric.name == controls.metric;
      if (ImGui::Selectable(metric.name.c_str(), chosen)) controls.metric = metric.name;
    }
    ImGui::EndCombo();
  }

  for (const Lane& lane : session.lanes()) {
    const Color& c = lane.setup->style.color;
    ImGui::TextColored(ImVec4(c.r, c.g, c.b, 1), "%s", lane.setup->method.c_str());
    if (lane.failure) ImGui::TextWrapped("%s", lane.failure->what.c_str());
    for (const Metric& metric : lane.metrics) {
      ImGui::Text("  %s %s %s", metric.name.c_str(), short_text(metric.value).c_str(),
                  metric.unit.c_str());
    }
  }
}

}  // namespace

Controls controls_for(const Plan& plan) {
  Controls controls{.chapter = plan.chapter,
                    .precision = plan.precision,
                    .scene = plan.scene->name,
                    .preset = plan.preset,
                    .dt = plan.dt,
                    .duration = plan.duration,
                    .parameters = plan.setups.at(0).parameters,
                    .mesh = plan.mesh,
                    .fix_winding = plan.fix_winding,
                    .metric = plan.scene->chart_metric};
  for (const Setup& setup : plan.setups) controls.methods.insert(setup.method);
  return controls;
}

Choice choice_of(const Controls& controls) {
  Choice choice{.scene = controls.scene,
                .precision = name(controls.precision),
                .dt = exact_text(controls.dt),
                .duration = exact_text(controls.duration)};
  for (const Method& method : scene_of(controls).methods) {
    if (controls.methods.contains(method.name)) choice.methods.push_back(method.name);
  }
  for (const auto& [parameter, value] : controls.parameters) {
    choice.settings.emplace_back(parameter, exact_text(value));
  }
  if (!controls.preset.empty()) choice.preset = controls.preset;
  if (!controls.mesh.empty()) choice.mesh = controls.mesh;
  choice.fix_winding = controls.fix_winding;
  return choice;
}

Wishes draw_panel(Controls& controls, Session& session) {
  const float line = ImGui::GetFontSize(), top = 9 * line;
  const float room = std::max(ImGui::GetIO().DisplaySize.y - top, 5 * line);
  ImGui::SetNextWindowPos(ImVec2(0.5F * line, top), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(30 * line, room));
  ImGui::Begin(controls.chapter->title.c_str(), nullptr,
               ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PushItemWidth(12 * line);
  ImGui::PushTextWrapPos(20 * line);

  Wishes wishes = draw_transport(controls, session);
  if (!session.error().empty()) ImGui::TextWrapped("%s", session.error().c_str());
  for (const std::string& notice : notices(session.lanes()))
    ImGui::TextWrapped("%s", notice.c_str());
  ImGui::Separator();
  wishes.restart |= draw_scene_box(controls);
  wishes.restart |= draw_methods(controls);
  wishes.restart |= draw_step(controls);
  ImGui::Separator();
  wishes.restart |= draw_presets(controls);
  wishes.restart |= draw_parameters(controls);
  ImGui::Separator();
  draw_metrics(controls, session);
  ImGui::PopTextWrapPos();
  ImGui::PopItemWidth();
  ImGui::End();
  return wishes;
}

}  // namespace timestep
