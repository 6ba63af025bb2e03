# Which chapter introduces which file of common/physics, in the order of the chapters.
# tests/include_rule.py reads this list: a chapter, and every file that it introduces, may
# include only what it or an earlier chapter introduced. The last one chooses among what
# there is and introduces nothing.
#
# Each row: chapter, then concepts; a concept X is the file X.hpp and, if there is one, X.cpp.
# What is exact is always double: it is compiled once.
set(timestep_manifest
  "01-particles: precision real integrator euler particle forces rounding exact"
  "02-verlet: scheme verlet runge_kutta implicit yoshida verlet_drag schemes
    dormand_prince systems distance_constraint stability swarm exact_elliptic
    exact_orbit exact_pendulum"
  "03-rigid-bodies: quaternion mass_properties mesh_mass rotation gyroscopic
    rotation_momentum rotor_splitting rotation_runge_kutta rotations rigid_body exact_top
    exact_free_top exact_heavy_top exact_cue_ball"
  "04-contacts: pose separation shapes minkowski simplex polytope gjk epa primitives
    side_of_plane quickhull convex_hull sat manifold decomposition
    libccd_query pair_query compound"
  "05-penetration: contact penetration"
  "06-impulses: impulse soft_contact contact_rows contact_phases sleeping solvers
    worst_first lcp world exact_bounce exact_impact exact_sliding exact_rolling exact_tipping"
  "07-trade:"
)
