#include "common/chapter/results.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "common/chapter/numbers.hpp"

namespace timestep {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  if (!std::isfinite(value)) return exact_text(value);
  return value;
}

Json vector(const glm::dvec3& v) {
  return {number(v.x), number(v.y), number(v.z)};
}

Json quaternion(const glm::dquat& q) {
  return {number(q.w), number(q.x), number(q.y), number(q.z)};
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

std::string method_names(const Plan& plan) {
  std::vector<std::string> names;
  for (const Setup& setup : plan.setups) names.push_back(setup.method);
  return fmt::format("{}", fmt::join(names, ","));
}

Json parameters_json(const Plan& plan) {
  Json json = Json::object();
  for (const Parameter& parameter : plan.scene->parameters) {
    const double value = plan.setups.at(0).parameters.at(parameter.name);
    json[parameter.name] =
        parameter.integer ? Json(static_cast<long long>(value)) : number(value);
  }
  return json;
}

Json body_json(const BodyState& body, const std::string& prefix) {
  Json json{{"name", prefix + body.name},
            {"position", vector(body.position)},
            {"velocity", vector(body.velocity)}};
  if (body.orientation) json["orientation"] = quaternion(*body.orientation);
  if (body.angular_velocity) json["angular_velocity"] = vector(*body.angular_velocity);
  return json;
}

void add_state(Json& state, const Lane& lane, const std::string& prefix) {
  for (const BodyState& body : lane.bodies) state.push_back(body_json(body, prefix));
}

void add_metrics(Json& metrics, const Lane& lane, const std::string& prefix) {
  for (const Metric& metric : lane.metrics) {
    metrics[prefix + metric.name] = {{"value", number(metric.value)},
                                     {"unit", metric.unit}};
  }
}

void add_failure(Json& failed, const Lane& lane, const std::string& prefix) {
  if (!lane.failure) return;
  failed[prefix + "step"] = lane.failure->step;
  failed[prefix + "time"] = number(lane.failure->time);
  failed[prefix + "what"] = lane.failure->what;
}

/// Work done by one lane or several.
struct Cost {
  long long evaluations = 0, steps = 0;
  double wall_seconds = 0, body_steps = 0;
};

Cost cost_of(const Lane& lane) {
  const double bodies = static_cast<double>(lane.simulation->body_count());
  return {.evaluations = lane.simulation->evaluations(),
          .steps = lane.steps,
          .wall_seconds = lane.wall_seconds,
          .body_steps = bodies * static_cast<double>(lane.steps)};
}

void add_cost(Json& json, const Cost& cost, const std::string& prefix) {
  const double nanoseconds =
      cost.body_steps > 0 ? 1e9 * cost.wall_seconds / cost.body_steps : 0;
  json[prefix + "force_evaluations"] = cost.evaluations;
  json[prefix + "steps"] = cost.steps;
  json[prefix + "wall_seconds"] = number(cost.wall_seconds);
  json[prefix + "nanoseconds_per_body_step"] = number(nanoseconds);
}

Json cost_json(std::span<const Lane> lanes) {
  Cost sum;
  for (const Lane& lane : lanes) {
    const Cost cost = cost_of(lane);
    sum.evaluations += cost.evaluations;
    sum.steps += cost.steps;
    sum.wall_seconds += cost.wall_seconds;
    sum.body_steps += cost.body_steps;
  }

  Json json = Json::object();
  add_cost(json, sum, "");
  if (lanes.size() < 2) return json;
  for (const Lane& lane : lanes)
    add_cost(json, cost_of(lane), lane_prefix(lanes, lane));
  return json;
}

}  // namespace

std::string lane_prefix(std::span<const Lane> lanes, const Lane& lane) {
  return lanes.size() > 1 ? lane.setup->method + "/" : "";
}

std::string results_json(const Plan& plan, std::span<const Lane> lanes) {
  Json state = Json::array(), metrics = Json::object(), failed = Json::object();
  for (const Lane& lane : lanes) {
    const std::string prefix = lane_prefix(lanes, lane);
    add_state(state, lane, prefix);
    add_metrics(metrics, lane, prefix);
    add_failure(failed, lane, prefix);
  }

  Json json;
  json["chapter"] = plan.chapter->name;
  json["scene"] = plan.scene->name;
  json["method"] = method_names(plan);
  json["precision"] = name(plan.precision);
  json["preset"] = text_or_null(plan.preset);
  json["mesh"] = text_or_null(plan.mesh.string());
  json["fix_winding"] = plan.fix_winding;
  json["dt"] = plan.dt;
  json["duration"] = plan.duration;
  json["steps"] = plan.steps;
  json["time"] = plan.time(plan.steps);
  json["parameters"] = parameters_json(plan);
  json["state"] = std::move(state);
  json["metrics"] = std::move(metrics);
  const std::vector<std::string> said = notices(lanes);
  if (!said.empty()) json["notices"] = said;
  if (!failed.empty()) json["failed"] = std::move(failed);
  json["cost"] = cost_json(lanes);

  // Invalid UTF-8, as a file's name may hold, is replaced rather than thrown at
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace timestep
