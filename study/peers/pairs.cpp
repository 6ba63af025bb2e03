#include "study/peers/pairs.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/04-contacts/pair_grid.hpp"
#include "chapters/04-contacts/reference.hpp"
#include "common/physics/pair_query.hpp"

namespace timestep::study {
namespace {

using chapter_04::Placement;
using chapter_04::Reference;
using chapter_04::Specimen;
using specimens::GridPair;

struct AskedPair {
  GridPair like;
  std::unique_ptr<Specimen> a, b;
  std::unique_ptr<Reference> reference;
  AskPair ask;
  double answer = 0;
};

Pose pose_of(const Placement& placement) {
  return {placement.position, placement.orientation};
}

// As the library sees them; none if it refuses any
std::vector<AskedPair> prepared(const PeerSetup& setup, const PreparePair& prepare) {
  std::vector<AskedPair> all;
  for (const GridPair& like :
       specimens::grid_pairs(setup.parameters.at("common") != 0)) {
    AskedPair pair{like,
                   std::make_unique<Specimen>(like.a),
                   std::make_unique<Specimen>(like.b),
                   std::make_unique<Reference>(like.a, like.b),
                   {}};
    pair.ask = prepare(*pair.a, *pair.b);
    if (!pair.ask) return {};
    all.push_back(std::move(pair));
  }
  return all;
}

class PairsPeer : public PeerRun {
 public:
  PairsPeer(const PeerSetup& setup, std::vector<AskedPair> pairs)
      : dt_(setup.dt),
        swing_{setup.parameters.at("near"), setup.parameters.at("swing")},
        pairs_(std::move(pairs)) {
    ask();
  }

  void step() override {
    ++steps_;
    ask();
  }
  void observe() override {
    for (const AskedPair& pair : pairs_) {
      const double known =
          pair.reference->at(place_of_a(pair.like), place_of_b(pair)).distance;
      if (known < 0) error_ = std::max(error_, std::abs(pair.answer - known));
      if (std::isnan(pair.answer)) error_ = pair.answer;
    }
  }
  double error() const override { return error_; }
  long long evaluations() const override { return 0; }
  long long bodies() const override { return static_cast<long long>(pairs_.size()); }

 private:
  Placement place_of_b(const AskedPair& pair) const {
    return specimens::place_of_b(pair.like, swing_, static_cast<double>(steps_) * dt_);
  }
  void ask() {
    for (AskedPair& pair : pairs_)
      pair.answer = pair.ask(pose_of(place_of_a(pair.like)), pose_of(place_of_b(pair)));
  }

  double dt_;  // [s]
  specimens::Swing swing_;
  std::vector<AskedPair> pairs_;
  long long steps_ = 0;
  double error_ = 0;
};

}  // namespace

std::unique_ptr<PeerRun> start_pairs(const PeerSetup& setup,
                                     const PreparePair& prepare) {
  const Problem& problem = *setup.problem;
  if (problem.scene != "pairs" || problem.metric != "depth_error_max") return nullptr;
  std::vector<AskedPair> pairs = prepared(setup, prepare);
  if (pairs.empty()) return nullptr;
  return std::make_unique<PairsPeer>(setup, std::move(pairs));
}

std::vector<Peer> own_pairs() {
  const PreparePair prepare = [](const Specimen& a, const Specimen& b) -> AskPair {
    return [&a, &b](const Pose& pose_a, const Pose& pose_b) {
      return separation(a.shape, pose_a, b.shape, pose_b).distance;
    };
  };
  return {{.method = "gjk_epa", .precision = "double", .start = [=](const auto& setup) {
             return start_pairs(setup, prepare);
           }}};
}

}  // namespace timestep::study
