#include "chapters/04-contacts/reference.hpp"

#if defined(TIMESTEP_DOUBLE)

#include "chapters/04-contacts/parts.hpp"

namespace timestep::double_precision::chapter_04 {

struct Reference::Pair {
  Specimen a, b;
};

Reference::Reference(const Description& a, const Description& b)
    : pair_(new Pair{Specimen(a), Specimen(b)}) {}
Reference::~Reference() = default;

KnownSeparation Reference::at(const Placement& a, const Placement& b) const {
  const Pose pose_a = pose_of(a), pose_b = pose_of(b);
  const auto ask = [&](const char* method) {
    return method_named(method).query(pair_->a.shape, pose_a, pair_->b.shape, pose_b);
  };
  const auto takes = [&](const char* method) {
    return method_named(method).takes(pair_->a.shape, pair_->b.shape);
  };
  Separation s = ask(takes("closed_form") ? "closed_form" : "gjk_epa");
  if (s.distance < 0 && takes("sat")) s = ask("sat");
  return {s.distance, s.normal};
}

}  // namespace timestep::double_precision::chapter_04

#endif
