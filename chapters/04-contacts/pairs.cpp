// All pairs of shapes in a grid, in motion, with what a method finds between them.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "chapters/04-contacts/judgement.hpp"
#include "chapters/04-contacts/pair_grid.hpp"
#include "chapters/04-contacts/parts.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {
namespace {

using double_precision::chapter_04::Reference;

using specimens::GridPair;

constexpr int k_columns = 7;

// One pair of the grid, and what was found last
struct Cell {
  GridPair pair;
  Specimen a, b;
  Reference reference;
  Separation answer{};
  Manifold manifold{};

  explicit Cell(const GridPair& like)
      : pair(like), a(like.a), b(like.b), reference(like.a, like.b) {}
};

class Pairs : public Simulation {
 public:
  explicit Pairs(const Setup& setup);

  void step() override;
  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return evaluations_; }
  long long body_count() const override {
    return static_cast<long long>(cells_.size());
  }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  Placement place_of_b(const Cell& cell) const;
  glm::vec3 middle(const Cell& cell) const;
  bool takes(const Cell& cell) const {
    return method_.takes(cell.a.shape, cell.b.shape);
  }
  bool in_contact(const Cell& cell) const;
  void ask();

  Setup setup_;
  PairMethod method_;
  std::vector<std::unique_ptr<Cell>> cells_;
  long long steps_ = 0, evaluations_ = 0;
  Judgement worst_;
};

Pairs::Pairs(const Setup& setup) : setup_(setup), method_(method_named(setup.method)) {
  for (const GridPair& pair : specimens::grid_pairs(setup.parameters.at("common") != 0))
    cells_.push_back(std::make_unique<Cell>(pair));
  ask();
}

Placement Pairs::place_of_b(const Cell& cell) const {
  const double t = static_cast<double>(steps_) * setup_.dt;
  return specimens::place_of_b(
      cell.pair, {setup_.parameters.at("near"), setup_.parameters.at("swing")}, t);
}

void Pairs::ask() {
  for (const auto& cell : cells_) {
    if (!takes(*cell)) continue;
    const Pose a = pose_of(place_of_a(cell->pair)), b = pose_of(place_of_b(*cell));
    cell->answer = method_.query(cell->a.shape, a, cell->b.shape, b);
    cell->manifold = contact_manifold(cell->a.shape, a, cell->b.shape, b, cell->answer);
    evaluations_ += cell->answer.iterations;
  }
}

void Pairs::step() {
  ++steps_;
  ask();
}

void Pairs::observe() {
  for (const auto& cell : cells_) {
    if (!takes(*cell)) continue;
    const Placement a = place_of_a(cell->pair), b = place_of_b(*cell);
    judge(worst_, cell->answer, {cell->a.shape, pose_of(a), cell->b.shape, pose_of(b)},
          cell->reference.at(a, b), cell->pair.a.size);
  }
}

bool Pairs::in_contact(const Cell& cell) const {
  return takes(cell) && cell.answer.reason != Reason::no_answer
         && contact_of(cell.answer) != Contact::separated;
}

std::vector<BodyState> Pairs::bodies() const {
  std::vector<BodyState> states;
  for (const auto& cell : cells_) {
    const Placement b = place_of_b(*cell);
    const auto name = [](const Description& like) {
      return std::string(k_kind_names[static_cast<std::size_t>(like.kind)]);
    };
    states.push_back({.name = name(cell->pair.a) + "/" + name(cell->pair.b),
                      .position = b.position,
                      .orientation = b.orientation});
  }
  return states;
}

std::vector<Metric> Pairs::metrics() const {
  double contacts = 0, points = 0, taken = 0, deepest = 0;
  for (const auto& cell : cells_) {
    taken += takes(*cell) ? 1 : 0;
    if (!in_contact(*cell)) continue;
    contacts += 1;
    points += cell->manifold.count;
    deepest = std::max(deepest, -static_cast<double>(cell->answer.distance));
  }
  std::vector<Metric> metrics{{"pairs_in_contact", "", contacts},
                              {"pairs_taken", "", taken},
                              {"pairs", "", static_cast<double>(cells_.size())},
                              {"contact_points", "", points},
                              {"deepest", "m", deepest}};
  add_metrics(metrics, worst_);
  return metrics;
}

// Of the cell, in rows from the top left
glm::vec3 Pairs::middle(const Cell& cell) const {
  const int column = cell.pair.index % k_columns, row = cell.pair.index / k_columns;
  constexpr int k_middle = k_columns / 2;
  return {1.75F * static_cast<float>(column - k_middle),
          3.1F - 1.6F * static_cast<float>(row), 0};
}

void Pairs::draw(DrawList& list) const {
  for (const auto& cell : cells_) {
    if (in_contact(*cell))
      draw_manifold(list, cell->manifold, setup_.style.color, 0.4F, middle(*cell));
  }
}

void Pairs::draw_reference(DrawList& list) const {
  for (const auto& cell : cells_) {
    const auto show = [&](const Specimen& specimen, const Placement& place,
                          const Color& color) {
      const glm::vec3 at = middle(*cell) + glm::vec3(place.position);
      draw_specimen(list, specimen, placed(at, place.orientation), color);
    };
    show(cell->a, place_of_a(cell->pair), k_color_a);
    show(cell->b, place_of_b(*cell), with_alpha(k_color_b, 0.5F));
  }
  list.ground_height.reset();
}

}  // namespace

Scene pairs_scene() {
  return {
      .name = "pairs",
      .summary = "every pair of shapes, in and out of contact: points and normals",
      .methods = all_choices(),
      .default_methods = {"gjk_epa"},
      .parameters = {{"near", "m", "least distance of the centres", 0.1, 0, 2},
                     {"swing", "m", "and how much farther they go", 0.8, 0, 10},
                     {"common", "", "1: only shapes that most libraries have", 0, 0, 1,
                      true}},
      .dt = 1.0 / 60,
      .duration = 4,
      .camera = {.target = {0, 0.4F, 0}, .distance = 13, .yaw = 0, .pitch = 0.08F},
      .start = [](const Setup& setup) { return std::make_unique<Pairs>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
