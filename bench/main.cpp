// Google Benchmark's own command line, over what benchmarks.hpp adds. The file that it
// writes says which compiler and which libraries were at work.
#include <benchmark/benchmark.h>

#include "bench/benchmarks.hpp"

#if defined(TIMESTEP_HAS_ODEINT)
#include <boost/version.hpp>
#endif
#if defined(TIMESTEP_HAS_GSL)
#include <gsl/gsl_version.h>
#endif

int main(int argc, char** argv) {
  timestep::single_precision::bench::add_particles();
  timestep::double_precision::bench::add_particles();
  timestep::double_precision::bench::add_kepler();
  benchmark::AddCustomContext("compiler", TIMESTEP_COMPILER);
#if defined(TIMESTEP_HAS_ODEINT)
  timestep::double_precision::bench::add_kepler_with_odeint();
  benchmark::AddCustomContext("Odeint", "Boost " BOOST_LIB_VERSION);
#endif
#if defined(TIMESTEP_HAS_GSL)
  timestep::double_precision::bench::add_kepler_with_gsl();
  benchmark::AddCustomContext("GSL", GSL_VERSION);
#endif
  timestep::single_precision::bench::add_rotation();
  timestep::double_precision::bench::add_rotation();
#if defined(TIMESTEP_BULLET)
  timestep::double_precision::bench::add_rotation_with_bullet();
  benchmark::AddCustomContext("Bullet", TIMESTEP_BULLET);
#endif
#if defined(TIMESTEP_ODE)
  timestep::double_precision::bench::add_rotation_with_ode();
  benchmark::AddCustomContext("ODE", TIMESTEP_ODE);
#endif

  timestep::single_precision::bench::add_contacts_of_ours();
  timestep::double_precision::bench::add_contacts_of_ours();
  timestep::double_precision::bench::add_contacts_of_libccd();
#if defined(TIMESTEP_FCL)
  timestep::double_precision::bench::add_contacts_of_fcl();
  benchmark::AddCustomContext("FCL", TIMESTEP_FCL);
#endif
#if defined(TIMESTEP_BULLET)
  timestep::double_precision::bench::add_contacts_of_bullet();
#endif
  timestep::double_precision::bench::add_growth();

  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
