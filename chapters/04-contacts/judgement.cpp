#include "chapters/04-contacts/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {
namespace {

// How far along a direction a shape reaches from its place [m]
double reach_along(const Shape& shape, const Pose& pose, const Vec3& direction) {
  const Vec3 d = direction_in_body(pose, direction);
  const Vec3 p = std::visit(
      [&](const auto& s) {
        if constexpr (std::is_same_v<std::decay_t<decltype(s)>, HalfSpace>)
          return s.offset * s.normal;
        else
          return support(s, d);
      },
      shape);
  return static_cast<double>(glm::dot(d, p));
}

// The overlap along any normal bounds the depth from above: a fault of the depth, or of
// the normal, shows without the right answer
void judge_by_itself(Judgement& worst, const Separation& s, const PosedPair& pair) {
  const glm::dvec3 n(s.normal), apart = glm::dvec3(s.on_b) - glm::dvec3(s.on_a);
  const glm::dvec3 between =
      glm::dvec3(pair.pose_b.position) - glm::dvec3(pair.pose_a.position);
  const double overlap = reach_along(pair.a, pair.pose_a, s.normal)
                         + reach_along(pair.b, pair.pose_b, -s.normal)
                         - glm::dot(between, n);
  const double distance = static_cast<double>(s.distance);
  worst.overlap_fault = std::max(worst.overlap_fault, std::abs(overlap + distance));
  const glm::dvec3 off = apart - distance * n;
  worst.witness_fault = std::max(worst.witness_fault, std::hypot(off.x, off.y, off.z));
}

}  // namespace

void judge(Judgement& worst, const Separation& answer, const PosedPair& pair,
           const double_precision::chapter_04::KnownSeparation& known, double reach) {
  if (answer.reason == Reason::no_answer || answer.reason == Reason::out_of_range) {
    ++worst.unanswered;
    return;
  }
  const double sure = 64 * double(std::numeric_limits<Real>::epsilon()) * reach;
  const Contact state = contact_of(answer);
  const bool denied = (known.distance > sure && state == Contact::penetrating)
                      || (known.distance < -sure && state == Contact::separated);
  worst.wrong_states += denied ? 1 : 0;
  if (answer.reason == Reason::lower_bound) return;
  const double off = std::abs(static_cast<double>(answer.distance) - known.distance);
  double& error = known.distance < 0 ? worst.depth_error : worst.distance_error;
  error = std::max(error, off);
  judge_by_itself(worst, answer, pair);
}

void add_metrics(std::vector<Metric>& metrics, const Judgement& worst) {
  metrics.push_back({"distance_error_max", "m", worst.distance_error});
  metrics.push_back({"depth_error_max", "m", worst.depth_error});
  metrics.push_back({"overlap_fault_max", "m", worst.overlap_fault});
  metrics.push_back({"witness_fault_max", "m", worst.witness_fault});
  metrics.push_back({"wrong_states", "", static_cast<double>(worst.wrong_states)});
  metrics.push_back({"unanswered", "", static_cast<double>(worst.unanswered)});
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
