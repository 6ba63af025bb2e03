/// @file
/// What is measured. Every function adds its benchmarks, by names that bench_table.py
/// reads: particles/METHOD/FORM/PRECISION/COUNT, kepler/METHOD/FORM and
/// bandwidth/KERNEL/PRECISION/COUNT/VECTORS.
#pragma once

#include "common/physics/precision.hpp"

namespace timestep {
namespace single_precision::bench {
void add_particles();
}
namespace double_precision::bench {
void add_particles();
void add_kepler();
void add_kepler_with_odeint();
void add_kepler_with_gsl();
}  // namespace double_precision::bench
}  // namespace timestep
