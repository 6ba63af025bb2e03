/// @file
/// A thing in the scene: a model at a transform.
#pragma once

#include "common/graphics/model.hpp"

namespace timestep {

/// Ties a model, which the resource manager owns, to a place. What moves it is not our
/// concern here: a simulation writes `world_from_object` before each frame.
struct Object {
  const Model* model = nullptr;
  glm::mat4 world_from_object{1};

  void draw() const {
    if (model != nullptr) model->draw(world_from_object);
  }
};

}  // namespace timestep
