// Chapters 4 and 5: pairs of shapes, and overlaps that have to go.
#include "study/problem.hpp"

namespace timestep::study {
namespace {

// Every step asks for every pair: dt only says how often
Problem pair_problem(const char* name, const char* scene, const char* metric) {
  return {.name = name,
          .chapter = "04-contacts",
          .scene = scene,
          .metric = metric,
          .exact = "closed form, or all features tried in double",
          .frame = 1.0 / 60,  // one step: one query of all pairs
          .duration = 4,
          .dts = {1.0 / 60}};
}

Problem sweep_problem(const char* name, double a, double b) {
  Problem problem = pair_problem(name, "sweep", "relative_error_max");
  problem.settings = {{"a", a}, {"b", b}};
  return problem;
}

Problem overlap_problem(const char* scene, const char* exact, double duration) {
  return {.name = scene,
          .chapter = "05-penetration",
          .scene = scene,
          .metric = "position_error",
          .exact = exact,
          .duration = duration,
          .dts = {1.0 / 30, 1.0 / 60, 1.0 / 120},
          .axes = {{"iterations", {1, 4, 10, 40, 160}}}};
}

}  // namespace

std::vector<Problem> contact_problems() {
  constexpr double k_sphere = 0, k_box = 1, k_cylinder = 4, k_cone = 5, k_hull = 7;
  std::vector<Problem> all{
      pair_problem("pairs", "pairs", "depth_error_max"),
      sweep_problem("sweep-spheres", k_sphere, k_sphere),
      sweep_problem("sweep-box-sphere", k_box, k_sphere),
      sweep_problem("sweep-boxes", k_box, k_box),
      sweep_problem("sweep-cylinder-cone", k_cylinder, k_cone),
      sweep_problem("sweep-hulls", k_hull, k_hull),
      overlap_problem("overlap-recovery", "boxes that only rise, in order", 2),
      overlap_problem("feather-and-ball", "least motion, weighted with mass", 0.5),
      overlap_problem("tilted-plank", "least motion, weighted with mass", 0.5),
      overlap_problem("corner", "least motion, weighted with mass", 0.5)};
  // Of one contact worst_first is done in one iteration
  for (Problem* one : {&all[7], &all[8]})
    one->axes.front().methods = {"linear_projection", "baumgarte", "split_impulse",
                                 "ngs"};
  all.push_back(pair_problem("mesh", "mesh", "early_max"));
  all.back().exact = "the mesh's own triangles";
  all.back().duration = 3;
  all.back().axes = {{"parts", {2, 4, 8}, {"decomposition"}}};
  // Shapes for which FCL answers too; our other methods do for fewer
  all[0].settings = {{"common", 1}};
  all[0].methods = {"gjk_epa", "libccd_epa", "libccd_mpr"};
  all[3].quick = true;
  all[8].quick = true;
  return all;
}

}  // namespace timestep::study
