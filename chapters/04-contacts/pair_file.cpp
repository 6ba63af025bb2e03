#include "chapters/04-contacts/pair_file.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/chapter/json_file.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {
namespace {

using Json = nlohmann::json;

// A value of the file, and the way to it from the case's inputs
struct Field {
  const Json& value;
  std::string name;
};

[[noreturn]] void refuse(const Field& field, const char* what) {
  throw InputError(fmt::format("{}: {}", field.name, what));
}

bool has(const Field& object, const char* name) {
  return object.value.contains(name);
}

Field member(const Field& object, const char* name) {
  if (!object.value.is_object()) refuse(object, "must be an object");
  const std::string full = object.name + "." + name;
  if (!has(object, name)) throw InputError(full + ": is missing");
  return {object.value.at(name), full};
}

Field element(const Field& list, std::size_t i) {
  return {list.value[i], fmt::format("{}[{}]", list.name, i)};
}

double length(const Field& field) {
  if (!field.value.is_number()) refuse(field, "must be a number");
  const auto value = field.value.get<double>();
  if (value < 0) refuse(field, "must not be negative");
  return value;
}

bool is_numbers(const Json& list, std::size_t count) {
  return list.is_array() && list.size() == count
         && std::ranges::all_of(list, [](const Json& x) { return x.is_number(); });
}

glm::dvec3 vector(const Field& field) {
  const Json& v = field.value;
  if (!is_numbers(v, 3)) refuse(field, "must be three numbers");
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

std::string word(const Field& field) {
  if (!field.value.is_string()) refuse(field, "must be a string");
  return field.value.get<std::string>();
}

glm::dquat rotation(const Field& shape) {
  constexpr double k_tolerance = 1e-6;  // as floats are printed
  if (!has(shape, "R")) return {1, 0, 0, 0};
  const Field field = member(shape, "R");
  if (!is_numbers(field.value, 9)) refuse(field, "must be nine numbers");
  glm::dmat3 R;
  for (int i = 0; i < 9; ++i)
    R[i % 3][i / 3] = field.value[std::size_t(i)].get<double>();

  const glm::dmat3 off = R * glm::transpose(R) - glm::dmat3(1);
  double largest = 0;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(off[i / 3][i % 3]));
  if (!(largest <= k_tolerance && glm::determinant(R) > 0))
    refuse(field, "is no rotation");
  return glm::normalize(glm::quat_cast(R));
}

Pose pose_of(const glm::dvec3& position, const glm::dquat& orientation) {
  return {Vec3(position), Quat(orientation)};
}

// About the first point: what they have in common costs no digits then
PlacedShape polyhedron(const Field& list) {
  if (!list.value.is_array()) refuse(list, "must be a list of points");
  if (list.value.empty()) refuse(list, "must have at least one point");
  PlacedShape placed;
  const glm::dvec3 first = vector(element(list, 0));
  for (std::size_t i = 0; i < list.value.size(); ++i)
    placed.points.emplace_back(vector(element(list, i)) - first);
  placed.pose = pose_of(first, {1, 0, 0, 0});

  HullShape view = hull_shape(placed.points);
  HullResult result = convex_hull(placed.points);
  if (result.fault.empty()) {
    placed.hull = std::make_unique<const ConvexHull>(std::move(result.hull));
    view.hull = placed.hull.get();
    view.volume = placed.hull->volume;
  }
  placed.shape = view;
  return placed;
}

void check_index(const Field& field, double count) {
  const double n = field.value.is_number() ? field.value.get<double>() : -1;
  if (!(n >= 0 && n < count) || n != std::floor(n))
    refuse(field, "must be the index of a vertex");
}

// The hull has its own faces; those of the file are looked at, but not used
void check_faces(const Field& faces, std::size_t vertices) {
  if (!faces.value.is_array()) refuse(faces, "must be a list of faces");
  for (std::size_t f = 0; f < faces.value.size(); ++f) {
    const Field face = element(faces, f);
    if (!face.value.is_array() || face.value.size() < 3)
      refuse(face, "must be three indices or more");
    for (std::size_t i = 0; i < face.value.size(); ++i)
      check_index(element(face, i), double(vertices));
  }
}

PlacedShape read_polyhedron(const Field& shape) {
  const Field vertices = member(shape, "vertices");
  PlacedShape placed = polyhedron(vertices);
  if (has(shape, "faces")) check_faces(member(shape, "faces"), vertices.value.size());
  if (has(shape, "dimension")) {
    const Field field = member(shape, "dimension");
    if (!field.value.is_number_unsigned() || field.value.get<unsigned>() > 3)
      refuse(field, "must be 0, 1, 2 or 3");
  }
  return placed;
}

// What turns z to the axis
glm::dquat axis_turn(const Field& field) {
  const std::string axis = word(field);
  const double half = std::sqrt(0.5);
  if (axis == "x") return {half, 0, half, 0};
  if (axis == "y") return {half, -half, 0, 0};
  if (axis == "z") return {1, 0, 0, 0};
  refuse(field, "must be x, y or z");
}

PlacedShape read_shape(const Field& shape) {
  const Field field = member(shape, "type");
  const std::string type = word(field);
  const auto size = [&](const char* name) { return length(member(shape, name)); };
  const auto point = [&](const char* name) { return vector(member(shape, name)); };

  if (type == "hull" || type == "triangle") return polyhedron(member(shape, "points"));
  if (type == "capsule") return placed_capsule(point("p"), point("q"), size("r"));
  if (type == "point") return {Sphere{0}, pose_of(point("t"), {1, 0, 0, 0}), {}, {}};
  if (type == "sphere")
    return {Sphere{Real(size("r"))}, pose_of(point("t"), {1, 0, 0, 0}), {}, {}};
  if (type == "box") {
    const glm::dvec3 full = point("size");
    for (std::size_t i = 0; i < 3; ++i) length(element(member(shape, "size"), i));
    return {Box{Vec3(full / 2.0)}, pose_of(point("t"), rotation(shape)), {}, {}};
  }
  if (type == "cylinder") {
    const glm::dquat turn = rotation(shape) * axis_turn(member(shape, "axis"));
    const Cylinder cylinder{Real(size("r")), Real(size("h"))};
    return {cylinder, pose_of(point("t"), turn), {}, {}};
  }
  refuse(field, "must be box, sphere, cylinder, capsule, hull, triangle or point");
}

std::string id_of(const Json& test, std::size_t index) {
  const bool named = test.is_object() && test.contains("id") && test["id"].is_string();
  return named ? test["id"].get<std::string>() : fmt::format("number {}", index + 1);
}

PairCase read_case(const Json& test) {
  const Field whole{test, "case"};
  const std::string id = word(member(whole, "id"));
  const std::string kind = word(member(whole, "kind"));
  return {id, read_pair(kind, member(whole, "inputs").value)};
}

}  // namespace

PlacedShape placed_capsule(const glm::dvec3& p, const glm::dvec3& q, double radius) {
  // Which end is up does not matter, so the axis is never turned by more than 90°
  const double height = glm::distance(p, q);
  glm::dvec3 d = height > 0 ? (q - p) / height : glm::dvec3(0, 0, 1);
  if (d.z < 0) d = -d;
  const glm::dquat turn = glm::normalize(glm::dquat(1 + d.z, -d.y, d.x, 0));
  return {Capsule{Real(radius), Real(height)}, pose_of((p + q) / 2.0, turn), {}, {}};
}

PlacedPair read_pair(const std::string& kind, const nlohmann::json& inputs) {
  const Field both{inputs, "inputs"};
  if (kind == "convex_pair")
    return {read_polyhedron(member(both, "A")), read_polyhedron(member(both, "B"))};
  if (kind == "shape_pair")
    return {read_shape(member(both, "A")), read_shape(member(both, "B"))};
  throw InputError("case.kind: must be convex_pair or shape_pair");
}

std::vector<PairCase> read_pair_file(const std::filesystem::path& file) {
  const Json document = load_json(file);
  const auto refuse_file = [&](const std::string& what) {
    throw InputError(fmt::format("{}: {}", file.string(), what));
  };
  if (!document.is_object() || !document.contains("cases")
      || !document["cases"].is_array())
    refuse_file("is no file of pairs: it has no list of cases");
  if (document["cases"].empty()) refuse_file("there are no cases");

  std::vector<PairCase> cases;
  std::set<std::string> ids;
  for (const Json& test : document["cases"]) {
    try {
      cases.push_back(read_case(test));
      if (!ids.insert(cases.back().id).second)
        throw InputError("another case has this id, too");
    } catch (const InputError& error) {
      refuse_file(fmt::format("case {}: {}", id_of(test, cases.size()), error.what()));
    }
  }
  return cases;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
