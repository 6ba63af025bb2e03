// Chapter 6: worlds of bodies that bounce, rub and stand on each other.
#include "study/problem.hpp"

namespace timestep::study {
namespace {

// What each method's accuracy is bought with; few contacts never need a second round of
// worst_first, which is a hundred impacts
std::vector<Axis> effort() {
  return {{"iterations", {1, 4, 10, 40}, {"sequential_impulses"}},
          {"substeps", {1, 2, 4, 8, 16}, {"substeps"}}};
}

Problem world_problem(const char* scene, const char* metric, const char* exact,
                      double duration, double longest) {
  return {.name = scene,
          .chapter = "06-impulses",
          .scene = scene,
          .metric = metric,
          .exact = exact,
          .duration = duration,
          .dts = halved(longest, 5),
          .axes = effort()};
}

// Too many contacts for Lemke's method
void leave_out_lcp(Problem& problem) {
  problem.methods = {"worst_first", "sequential_impulses", "substeps"};
}

// A sweep of worst_first over many contacts takes seconds
void leave_out_costly(Problem& problem) {
  leave_out_lcp(problem);
  problem.axes.push_back({"iterations", {1, 10}, {"worst_first"}});
}

}  // namespace

std::vector<Problem> impact_problems() {
  constexpr double k_step = 1.0 / 15;
  std::vector<Problem> all{
      world_problem("two-blocks", "energy_gained", "no energy comes from nowhere", 4,
                    k_step),
      world_problem("bounce", "height_error_max", "closed form", 2, k_step),
      world_problem("cradle", "pairwise_error", "impacts one after the other", 3,
                    k_step),
      world_problem("billiards", "asymmetry_max", "symmetry", 2, k_step / 4),
      world_problem("elastic-gas", "energy_error_max", "conserved energy", 1,
                    k_step / 4),
      world_problem("ramp", "way_error_max", "Coulomb's law", 1.8, k_step),
      world_problem("slide-to-roll", "velocity_error_max", "closed form", 1, k_step),
      world_problem("rod", "rate_error_max", "conserved energy of a falling rod", 1,
                    k_step / 4),
      world_problem("rocking-block", "next_tilt", "Housner's impacts", 3, k_step / 4)};
  all[1].quick = true;
  all[4].settings = {{"balls", 60}, {"gravity", 9.81}};
  leave_out_lcp(all[4]);
  all[8].known = "next_tilt_exact";
  return all;
}

std::vector<Problem> stack_problems() {
  constexpr double k_step = 1.0 / 30;
  const char* const still = "boxes that stay where they are";
  std::vector<Problem> all{
      world_problem("stack", "drift_max", still, 3, k_step),
      world_problem("mass-ratio", "drift_max", still, 3, k_step),
      world_problem("pyramid", "drift_max", still, 2, k_step),
      world_problem("pile", "penetration", "bodies that do not overlap", 4, k_step)};
  for (Problem& problem : all) problem.dts.pop_back();
  all[0].quick = true;
  all[2].settings = {{"base", 10}};
  all[3].settings = {{"n", 30}};
  leave_out_lcp(all[0]);
  for (int i : {0, 1})
    all[i].axes.push_back({"iterations", {1, 4, 10, 40}, {"worst_first"}});
  leave_out_costly(all[2]);
  leave_out_costly(all[3]);
  return all;
}

}  // namespace timestep::study
