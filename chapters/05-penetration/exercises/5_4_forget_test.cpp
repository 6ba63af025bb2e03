// Beads in a row: what they are to be apart by is known, and no speed may change.
#include "chapters/05-penetration/exercises/5_4_forget.hpp"

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

constexpr Real k_beta = 0.2, k_slop = 0.01, k_dt = 1.0 / 60;
constexpr int k_sweeps = 2000;  // far more than six beads need

// Six beads of 1 m, each 0.2 m in the next; the masses are all different
std::vector<Bead> row(Real speed) {
  std::vector<Bead> beads;
  for (int i = 0; i < 6; ++i) beads.push_back({0.8 * i, speed, 1.0 / (1 + i), 0.5});
  return beads;
}

Real centre(const std::vector<Bead>& beads) {
  Real sum = 0, mass = 0;
  for (const Bead& bead : beads) {
    sum += bead.x / bead.inverse_mass;
    mass += 1 / bead.inverse_mass;
  }
  return sum / mass;
}

}  // namespace

TEST_CASE("beads at rest come apart by their share, and stay at rest") {
  std::vector<Bead> beads = row(0);
  step_beads(beads, k_beta, k_slop, k_dt, k_sweeps);
  const Real left = k_slop + 0.8 * (0.2 - k_slop);
  for (std::size_t i = 0; i + 1 < beads.size(); ++i)
    expect(fmt::format("depth [m] after a step, of beads {} and {}", i, i + 1),
           depth_of(beads, i), left, 1e-12);
  for (std::size_t i = 0; i < beads.size(); ++i)
    expect(fmt::format("speed [m/s] of bead {}, which was at rest", i), beads[i].v, 0,
           0);
}

TEST_CASE("in the end the slop is left, and the centre of mass has not moved") {
  std::vector<Bead> beads = row(0);
  const Real before = centre(beads);
  for (int k = 0; k < 200; ++k) step_beads(beads, k_beta, k_slop, k_dt, 200);

  // 0.8^200 is nothing; 200 steps of some roundings of 4 m
  for (std::size_t i = 0; i + 1 < beads.size(); ++i)
    expect("depth [m] in the end", depth_of(beads, i), k_slop, 1e-12);
  expect("centre of mass [m]", centre(beads), before, 200 * 8 * 4 * k_u);
}

TEST_CASE("beads that fly together keep their speed") {
  std::vector<Bead> flying = row(3), resting = row(0);
  step_beads(flying, k_beta, k_slop, k_dt, k_sweeps);
  step_beads(resting, k_beta, k_slop, k_dt, k_sweeps);
  for (std::size_t i = 0; i < flying.size(); ++i) {
    expect("speed [m/s] of a bead that flew at 3 m/s", flying[i].v, 3, 0);
    expect("how far [m] it is ahead of one that did not fly",
           flying[i].x - resting[i].x, 3 * k_dt, 1e-14);
  }
}

TEST_CASE("a wall stays, beads across a gap stay") {
  std::vector<Bead> beads{{0, 0, 0, 0.5}, {0.9, 0, 1, 0.5}, {5, 0, 1, 0.5}};
  step_beads(beads, k_beta, k_slop, k_dt, k_sweeps);
  expect("place [m] of the wall", beads[0].x, 0, 0);
  expect("place [m] of the bead in the wall", beads[1].x, 0.9 + 0.2 * 0.09, 1e-14);
  expect("place [m] of the bead far away", beads[2].x, 5, 0);
}
