/// @file
/// How right a method's answers about pairs of shapes are.
#pragma once

#include "chapters/04-contacts/reference.hpp"
#include "common/chapter/scene.hpp"
#include "common/physics/pair_query.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {

/// Two shapes in the world.
struct PosedPair {
  const Shape& a;
  Pose pose_a;
  const Shape& b;
  Pose pose_b;
};

/// The worst of the answers so far.
struct Judgement {
  double distance_error = 0;   ///< [m] while the shapes were apart
  double depth_error = 0;      ///< [m] while they overlapped
  double overlap_fault = 0;    ///< [m] from the overlap along its normal to its depth
  double witness_fault = 0;    ///< [m] from its points to its distance along its normal
  long long wrong_states = 0;  ///< apart or overlapping, beyond doubt, and denied
  long long unanswered = 0;
};

/// Takes in one answer about shapes whose coordinates reach so far [m]. Where the
/// method says that it did not look for the distance, only the state counts. States
/// within 64 epsilon of that reach from touching are in doubt: so much may rounded
/// coordinates, turned and added, move the surfaces.
void judge(Judgement& worst, const Separation& answer, const PosedPair& pair,
           const double_precision::chapter_04::KnownSeparation& known, double reach);

/// The judgement's numbers as metrics.
void add_metrics(std::vector<Metric>& metrics, const Judgement& worst);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
