/// @file
/// What is measured. Every function adds its benchmarks, by names that bench_table.py
/// reads: particles/METHOD/FORM/PRECISION/COUNT, kepler/METHOD/FORM,
/// bandwidth/KERNEL/PRECISION/COUNT/VECTORS, rotation/METHOD/PRECISION/COUNT and
/// top/METHOD/PRECISION.
#pragma once

#include "common/physics/precision.hpp"

namespace timestep {
namespace single_precision::bench {
void add_particles();
void add_rotation();
}  // namespace single_precision::bench
namespace double_precision::bench {
void add_particles();
void add_kepler();
void add_kepler_with_odeint();
void add_kepler_with_gsl();
void add_rotation();
void add_rotation_with_bullet();
void add_rotation_with_ode();
}  // namespace double_precision::bench
}  // namespace timestep
