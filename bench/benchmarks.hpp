/// @file
/// What is measured. Every function adds its benchmarks, by names that bench_table.py
/// reads: particles/METHOD/FORM/PRECISION/COUNT, kepler/METHOD/FORM,
/// bandwidth/KERNEL/PRECISION/COUNT/VECTORS, rotation/METHOD/PRECISION/COUNT,
/// top/METHOD/PRECISION, contacts/PAIRS/QUESTION/METHOD/PRECISION and
/// growth/QUESTION/METHOD/VERTICES.
#pragma once

#include "common/physics/precision.hpp"

namespace timestep {
namespace single_precision::bench {
void add_particles();
void add_rotation();
void add_contacts_of_ours();
}  // namespace single_precision::bench
namespace double_precision::bench {
void add_particles();
void add_kepler();
void add_kepler_with_odeint();
void add_kepler_with_gsl();
void add_rotation();
void add_rotation_with_bullet();
void add_rotation_with_ode();
void add_contacts_of_ours();
void add_contacts_of_libccd();
void add_contacts_of_fcl();
void add_contacts_of_bullet();
void add_growth();
}  // namespace double_precision::bench
}  // namespace timestep
