#include "chapters/03-rigid-bodies/parts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {

std::vector<Method> all_choices() {
  std::vector<Method> all;
  for (const RotationMethod& method : rotation_methods())
    all.push_back({std::string(method.name), std::string(method.summary),
                   method_style(static_cast<int>(all.size()))});
  return all;
}

BodyRun::BodyRun(const Setup& setup)
    : setup_(setup), method_(*find_rotation_method(setup.method)) {}

void BodyRun::step() {
  try {
    advance();
  } catch (const Unsolved& unsolved) {
    throw StepFailure(unsolved.what());
  }
  ++steps_;
}

TopRun::TopRun(const Setup& setup, const glm::dvec3& moments,
               const exact::Turning& start, const Torque& torque)
    : BodyRun(setup),
      moments_(moments),
      torque_(torque),
      rotation_{Quat(start.q), Vec3(start.omega)} {}

void TopRun::advance() {
  method().step(rotation_, Vec3(moments_), torque_, Real(time()), Real(setup().dt));
}

exact::Turning TopRun::now() const {
  return wide(rotation_);
}

exact::Turning wide(const Rotation& r) {
  return {glm::dquat(r.q), glm::dvec3(r.omega)};
}

glm::dvec3 moments_of(const Setup& setup) {
  const glm::dvec3 I{setup.parameters.at("i1"), setup.parameters.at("i2"),
                     setup.parameters.at("i3")};

  // Every bit of mass adds as much to two of the moments together as to the third, or
  // more; what a moment may round is let pass
  const double largest = std::max({I.x, I.y, I.z});
  if (2 * largest > (I.x + I.y + I.z) * (1 + 1e-12))
    throw InputError(
        fmt::format("--set i1={:g} i2={:g} i3={:g}: no body has these moments, the "
                    "largest exceeds the sum of the others",
                    I.x, I.y, I.z));
  return I;
}

glm::mat4 placed(const glm::vec3& at, const glm::dquat& q) {
  glm::mat4 world_from_body = glm::mat4_cast(glm::quat(q));
  world_from_body[3] = glm::vec4(at, 1);
  return world_from_body;
}

namespace {

// Rows and columns of a grid for so many bodies: up to three in a row, then a square
struct Grid {
  std::size_t columns, rows;
};

Grid grid_for(std::size_t bodies) {
  const double side = std::ceil(std::sqrt(static_cast<double>(bodies)));
  const std::size_t columns = bodies <= 3 ? bodies : static_cast<std::size_t>(side);
  return {columns, (bodies + columns - 1) / columns};
}

glm::vec3 place(const Setup& setup, std::size_t index, float apart) {
  const auto [columns, rows] = grid_for(setup.lanes + 1);
  const auto about_middle = [](std::size_t i, std::size_t n) {
    return static_cast<float>(i) - static_cast<float>(n - 1) / 2;
  };
  return {apart * about_middle(index % columns, columns),
          -apart * about_middle(index / columns, rows), 0};
}

}  // namespace

glm::vec3 place_of_exact(const Setup& setup, float apart) {
  return place(setup, 0, apart);
}

glm::vec3 place_of_lane(const Setup& setup, float apart) {
  return place(setup, setup.lane + 1, apart);
}

CameraPose camera_for_lanes(const CameraPose& usual, const Setup& setup, float apart) {
  const auto [columns, rows] = grid_for(setup.lanes + 1);
  const float across = static_cast<float>(
      std::max(1.1 * static_cast<double>(rows), static_cast<double>(columns) / 1.3));
  CameraPose pose = usual;
  pose.distance = apart * across / (2 * std::tan(usual.vertical_fov / 2));
  return pose;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
