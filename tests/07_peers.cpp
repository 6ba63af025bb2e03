// Other libraries are measured by what the chapters' scenes measure: our own methods,
// set up as a library is, give the scene's own number.
#include <algorithm>
#include <cmath>

#include "study/peers/measure.hpp"
#include "tests/catch.hpp"

using namespace timestep::study;

namespace {

const Problem& problem_named(const std::string& name) {
  return *chosen_problems({&name, 1}).front();
}

const Peer& peer_named(const std::vector<Peer>& all, const std::string& method) {
  const auto found = std::ranges::find(all, method, &Peer::method);
  REQUIRE(found != all.end());
  return *found;
}

Cell cell_of(const Problem& problem, const std::string& method, double dt) {
  return {&problem, method, "double", dt, problem.settings};
}

// The errors of one step: the peer's and the scene's own
struct Errors {
  double peer, own;
};
Errors errors(const std::vector<Peer>& all, const std::string& peer,
              const std::string& method, const std::string& problem, double dt) {
  const Problem& of = problem_named(problem);
  const Cell asked = cell_of(of, peer, dt);
  const ErrorResult found = measure_error(peer_named(all, peer), asked);
  const ErrorResult own = measure_error(cell_of(of, method, dt));
  CHECK(found.unit == own.unit);
  CHECK(found.steps == own.steps);
  CHECK(found.bodies == own.bodies);
  return {found.error, own.error};
}

}  // namespace

// A box in place of the floor's half-space, and a slope that is turned: the same
// contact points but for rounding, which impacts and friction do not amplify here
TEST_CASE("our own worlds give the scenes' numbers") {
  for (const char* problem : {"bounce", "slide-to-roll", "elastic-gas"}) {
    const double dt = problem_named(problem).dts.at(3);
    const auto [peer, own] = errors(own_worlds(), "substeps", "substeps", problem, dt);
    INFO(problem);
    CHECK(peer == Approx(own).epsilon(1e-6).margin(1e-9));
  }
}

// Which points of two faces are kept is a matter of rounding: what boxes err is as
// small, and no more can be asked
TEST_CASE("our own boxes err as the scenes' do") {
  for (const char* problem : {"ramp", "stack", "pyramid"}) {
    const double dt = problem_named(problem).dts.at(2);
    const auto [peer, own] = errors(own_worlds(), "substeps", "substeps", problem, dt);
    INFO(problem << ": " << peer << " and " << own);
    CHECK(peer < 2 * own);
    CHECK(peer > own / 2);
  }
}

TEST_CASE("our own pairs give the scene's number, bit for bit") {
  const auto [peer, own] = errors(own_pairs(), "gjk_epa", "gjk_epa", "pairs", 1.0 / 60);
  CHECK(peer == own);
}

// The same formulas: only rounding differs, 1e-16 in each of some thousand steps, which
// ten orbits let grow to no more than 1e-11
TEST_CASE("a library's integrators err as ours do") {
  for (const char* problem : {"oscillator", "orbit"})
    for (const auto& [theirs, ours] :
         {std::pair{"odeint velocity_verlet", "velocity_verlet"},
          std::pair{"odeint rk4", "rk4"}, std::pair{"odeint dopri5", "dopri5"}}) {
      const std::vector<Peer> all = peers();
      if (std::ranges::count(all, theirs, &Peer::method) == 0) continue;
      const double dt = problem_named(problem).dts.at(4);
      const auto [peer, own] = errors(all, theirs, ours, problem, dt);
      INFO(problem << ", " << theirs);
      CHECK(peer == Approx(own).epsilon(1e-9).margin(1e-11));
    }
}

TEST_CASE(
    "a peer is asked at the problem's steps, and at its iterations if it has some") {
  const std::vector<Peer> worlds = own_worlds();
  const Problem& stack = problem_named("stack");
  const std::vector<Cell> cells = cells_of(worlds.front(), stack, false);
  CHECK(cells.size() == stack.dts.size() * stack.axes.front().values.size());
  CHECK(cells_of(worlds.front(), problem_named("orbit"), false).empty());
  CHECK(cells_of(own_pairs().front(), problem_named("pairs"), false).size() == 1);
}
