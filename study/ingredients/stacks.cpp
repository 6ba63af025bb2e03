#include <cmath>

#include "study/ingredients/contacts.hpp"
#include "study/ingredients/worlds.hpp"

namespace timestep::inline TIMESTEP_PRECISION::ingredients {
namespace {

using study::Comparison;
using study::Model;

// Boxes of 1 m and 1 kg, `gap` [m] apart, with the ground as body 0
World column(int boxes, double gap, double restitution) {
  const Collider wood{.friction = Real(0.5), .restitution = Real(restitution)};
  World world = ground(wood);
  for (int i = 0; i < boxes; ++i)
    add_box(world, 1, glm::dvec3(1), {0, 0.5 + gap + i * (1 + gap), 0}, wood);
  return world;
}

// [m] How far the top is below where rigid boxes carry it
double sinking(const World& world, double) {
  const double rigid = double(world.bodies.size()) - 1.5;
  return std::abs(double(world.bodies.back().position.y) - rigid);
}

// [m/s] Of the fastest centre
double restlessness(const World& world, double) {
  double most = 0;
  for (const RigidBody& body : world.bodies)
    most = std::max(most, double(glm::length(body.velocity)));
  return most;
}

// [m] How far the top is from where rigid boxes carry it
double straying(const World& world, double) {
  const Real rigid = Real(world.bodies.size()) - Real(1.5);
  return double(glm::distance(world.bodies.back().position, Vec3(0, rigid, 0)));
}

// --- a step with less ----------------------------------------------------------------

// Contacts that are not there any more carry nothing over
void step_cold(World& world) {
  world.contacts.clear();
  step(world, Real(k_dt));
}

// Of each pair of colliders the deepest point, the first in a tie
void keep_deepest(std::vector<PointContact>& contacts) {
  std::size_t kept = 0;
  for (const PointContact& contact : contacts) {
    PointContact* last = kept > 0 ? &contacts[kept - 1] : nullptr;
    const bool is_same = last != nullptr && last->collider_a == contact.collider_a
                         && last->collider_b == contact.collider_b;
    if (!is_same)
      contacts[kept++] = contact;
    else if (contact.depth > last->depth)
      *last = contact;
  }
  contacts.resize(kept);
}

// World's step, with one point or with all of each manifold
void step_by_points(World& world, bool keeps_all) {
  std::swap(world.contacts, world.contacts_before);
  find_contacts(world.bodies, world.colliders, world.margin,
                glm::length(world.settings.gravity), Real(k_dt), world.search,
                world.contacts);
  if (!keeps_all) keep_deepest(world.contacts);
  hold_still(world.bodies, world.settings.static_speed, world.contacts);
  carry_impulses(world.contacts_before, world.margin, world.contacts);
  world.solver->advance({.bodies = world.bodies,
                         .contacts = world.contacts,
                         .settings = world.settings,
                         .out_of_penetration = *world.out_of_penetration,
                         .penetration = world.penetration,
                         .impact_law = *world.impact_law,
                         .dt = Real(k_dt),
                         .room = world.room,
                         .penetration_room = world.penetration_room});
}

Model by_points(const std::string& name, const World& world, const ErrorOf& error,
                bool keeps_all) {
  const auto move = [=](World& now) { step_by_points(now, keeps_all); };
  return {name, [=] { return moving(world, error, move); }};
}

// --- the rows ------------------------------------------------------------------------

Comparison threshold() {
  World without = column(1, 0.1, 0.8), with = without;
  with.settings.restitution_threshold = Real(0.5);
  return {.ingredient = "restitution threshold",
          .scene = "box with e = 0.8, let go at 10 cm",
          .matters = true,
          .metric = "speed",
          .unit = "m/s",
          .exact = "rest",
          .steps = 60,
          .with = {"0.5 m/s", [=] { return moving(with, restlessness); }},
          .without = {"0", [=] { return moving(without, restlessness); }}};
}

std::vector<Comparison> manifolds() {
  const World boxes = column(10, 0, 0);
  const Collider cloth{.friction = Real(0.5)};
  World ball = ground(cloth);
  add_ball(ball, 1, 0.5, {0, 0.5, 0}, cloth);
  return {{.ingredient = "four-point manifold",
           .scene = "column of 10 boxes",
           .matters = true,
           .metric = "place of the top",
           .unit = "m",
           .exact = "rest",
           .steps = 120,
           .bodies = 10,
           .with = by_points("four points", boxes, straying, true),
           .without = by_points("the deepest", boxes, straying, false)},
          {.ingredient = "four-point manifold",
           .scene = "ball at rest",
           .matters = false,
           .metric = "place",
           .unit = "m",
           .exact = "rest",
           .steps = 120,
           .with = by_points("four points", ball, straying, true),
           .without = by_points("the deepest", ball, straying, false)}};
}

Comparison warm_start(const std::string& scene, bool matters, int boxes) {
  World world = column(boxes, 0, 0);
  world.solver = find_solver("sequential_impulses");
  return {.ingredient = "warm start",
          .scene = scene,
          .matters = matters,
          .metric = "sinking of the top",
          .unit = "m",
          .exact = "rigid boxes",
          .steps = 240,
          .bodies = boxes,
          .with = {"last impulses", [=] { return moving(world, sinking); }},
          .without = {"none", [=] { return moving(world, sinking, step_cold); }}};
}

Comparison substeps() {
  const World with = column(10, 0, 0);
  World without = with;
  without.settings.substeps = 1;
  return {.ingredient = "sub-steps",
          .scene = "column of 10 boxes",
          .matters = true,
          .metric = "sinking of the top",
          .unit = "m",
          .exact = "rigid boxes",
          .steps = 120,
          .bodies = 10,
          .with = {"4", [=] { return moving(with, sinking); }},
          .without = {"1", [=] { return moving(without, sinking); }}};
}

}  // namespace

std::vector<Comparison> stack_comparisons() {
  std::vector<Comparison> all = manifolds();
  all.push_back(threshold());
  all.push_back(warm_start("column of 10 boxes", true, 10));
  all.push_back(warm_start("box at rest", false, 1));
  all.push_back(substeps());
  return all;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::ingredients
