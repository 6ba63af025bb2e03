#include "study/tune_settings.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "common/chapter/numbers.hpp"
#include "common/physics/impulse.hpp"
#include "common/physics/penetration.hpp"
#include "study/tune.hpp"

namespace timestep::study {
namespace {

using Lines = std::vector<std::string>;

int whole(const Cell& cell, const std::string& name) {
  return static_cast<int>(setting(cell, name));
}

// How a frame of `frame` [s] is spent in steps; what is no whole step waits
Lines code_of_frames(const Cell& cell) {
  const std::string step = "semi_implicit_euler(state, acceleration, t, ";
  Lines lines{"#include \"common/physics/euler.hpp\""};
  if (cell.method == "variable") {
    lines.push_back(step + "frame);  // every frame");
  } else if (cell.method == "semi_fixed") {
    lines.insert(lines.begin(), "#include <cmath>");
    lines.push_back(fmt::format("const Real pieces = std::ceil(frame / Real({}));",
                                exact_text(setting(cell, "max_step"))));
    lines.push_back("for (int i = 0; i < int(pieces); ++i)  // every frame");
    lines.push_back("  " + step + "frame / pieces);");
  } else {
    lines.push_back("waiting += frame;  // every frame");
    lines.push_back("for (; waiting >= dt; waiting -= dt)");
    lines.push_back("  " + step + "dt);");
  }
  return lines;
}

Lines code_of_particles(const Cell& cell) {
  if (cell.problem->scene == "clock")
    return {cell.method == "add" ? "t += dt;  // every step"
                                 : "t = Real(steps * double(dt));  // every step"};
  if (cell.problem->scene == "frame-drops") return code_of_frames(cell);
  return {"#include \"common/physics/euler.hpp\"",
          fmt::format("{}(state, acceleration, t, dt);  // every step", cell.method)};
}

Lines code_of_systems(const Cell& cell) {
  if (cell.method == "distance_constraints")
    return {"#include \"common/physics/distance_constraint.hpp\"",
            "// every step, after the particles moved by themselves",
            fmt::format("satisfy(rods, inverse_mass, {}, state.x);",
                        whole(cell, "iterations"))};
  if (cell.method == "dormand_prince")
    return {"#include \"common/physics/dormand_prince.hpp\"",
            fmt::format("const Tolerance tolerance{{{0}, {0}}};",
                        exact_text(setting(cell, "tolerance"))),
            "dormand_prince(state, acceleration, t, t + dt, tolerance);"};
  return {"#include \"common/physics/schemes.hpp\"",
          fmt::format("Integration run = begin(*find_scheme(\"{}\"), acceleration, "
                      "state, dt);",
                      cell.method),
          "advance(run);  // every step"};
}

Lines code_of_bodies(const Cell& cell) {
  return {"#include \"common/physics/rotations.hpp\"",
          fmt::format("const RotationMethod& method = *find_rotation_method(\"{}\");",
                      cell.method),
          "method.step(rotation, inertia, torque, t, dt);  // every step"};
}

Lines code_of_pairs(const Cell& cell) {
  return {"#include <algorithm>", "#include \"common/physics/pair_query.hpp\"",
          fmt::format("const PairMethod& method = *std::ranges::find(pair_methods(), "
                      "\"{}\", &PairMethod::name);",
                      cell.method),
          "const Separation found = method.query(a, pose_a, b, pose_b);"};
}

Lines code_of_penetration(const Cell& cell) {
  if (cell.method == "equal_shares")
    return {"// a method of the chapter's scene alone, to show why masses matter"};
  Lines lines{"#include \"common/physics/penetration.hpp\"",
              "PenetrationSettings settings;",
              fmt::format("settings.iterations = {};", whole(cell, "iterations"))};
  for (const char* name : {"epsilon", "slop", "beta"})
    lines.push_back(
        fmt::format("settings.{} = Real({});", name, exact_text(setting(cell, name))));
  lines.push_back(fmt::format(
      "find_penetration_method(\"{}\")->step(bodies, contacts, settings, dt, room);",
      cell.method));
  return lines;
}

// Chapter 6's scenes have methods and laws by their numbers
template <class Table>
std::string_view name_in(const Table& table, const Cell& cell, const char* parameter) {
  return table[static_cast<std::size_t>(whole(cell, parameter))].name;
}

Lines code_of_worlds(const Cell& cell) {
  Lines lines{"#include \"common/physics/world.hpp\"", "World world;",
              fmt::format("world.solver = find_solver(\"{}\");", cell.method)};
  const int iterations = whole(cell, "iterations");
  if (cell.method == "substeps") {
    lines.push_back(
        fmt::format("world.settings.substeps = {};", whole(cell, "substeps")));
  } else if (cell.method == "worst_first") {
    lines.push_back(
        fmt::format("world.settings.contacts_at_most = {};", 100 * iterations));
    lines.push_back(fmt::format("world.impact_law = find_impact_law(\"{}\");",
                                name_in(impact_laws(), cell, "law")));
  } else {
    lines.push_back(fmt::format("world.settings.iterations = {};", iterations));
  }
  if (cell.method != "substeps")
    lines.push_back(
        fmt::format("world.out_of_penetration = find_penetration_method(\"{}\");",
                    name_in(penetration_methods(), cell, "way_out")));
  lines.push_back("step(world, dt);  // every step");
  return lines;
}

}  // namespace

std::string command_of(const Cell& cell) {
  const Problem& problem = *cell.problem;
  std::string text = fmt::format(
      "build/release/bin/{} --scene {} --method {} --precision {} --dt {} "
      "--duration {}",
      problem.chapter, problem.scene, cell.method, cell.precision, exact_text(cell.dt),
      exact_text(problem.duration));
  for (const auto& [name, value] : cell.settings)
    text += fmt::format(" --set {}={}", name, exact_text(value));
  return text + " --headless --results -";
}

std::vector<std::string> code_of(const Cell& cell) {
  using Code = Lines (*)(const Cell&);
  constexpr std::array<Code, 6> k_code{code_of_particles,   code_of_systems,
                                       code_of_bodies,      code_of_pairs,
                                       code_of_penetration, code_of_worlds};
  const std::size_t chapter = std::stoul(cell.problem->chapter.substr(0, 2));
  Lines code = k_code.at(chapter - 1)(cell);
  const auto first = std::stable_partition(
      code.begin(), code.end(),
      [](const std::string& line) { return line.starts_with("#include"); });
  code.insert(first, {"using namespace timestep;",
                      fmt::format("const Real dt({});", exact_text(cell.dt))});
  code.insert(
      code.begin(),
      fmt::format("// -DTIMESTEP_{}, with the library physics_{}",
                  cell.precision == "single" ? "SINGLE" : "DOUBLE", cell.precision));
  return code;
}

}  // namespace timestep::study
