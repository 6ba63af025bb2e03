/// @file
/// An earlier chapter's simulation, run as one of the choices says.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "chapters/07-trade/choices.hpp"
#include "common/chapter/scene.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_07 {

/// The earlier scene that a trade is about. Throws std::logic_error if there is none.
Scene earlier_scene(const Trade& trade);

/// What the earlier scene is started with, for a choice of this chapter's scene: its
/// own defaults, then the trade's settings, the choice's, and the user's parameters.
Setup earlier_setup(const Trade& trade, const Scene& earlier, const Setup& setup);

/// Steps an earlier simulation several times in a frame, and passes on what it says.
/// It is observed once a frame, as a player sees it, so a metric that is the most so
/// far is the most of all frames.
class TradeRun : public Simulation {
 public:
  /// The trade must outlive the run.
  TradeRun(const Trade& trade, const Setup& setup);

  std::vector<std::string> notices() const override { return run_->notices(); }
  void step() override;
  void observe() override { run_->observe(); }
  std::vector<BodyState> bodies() const override { return run_->bodies(); }

  /// `error_over_limit`, which is below 1 where every wish is met, `steps_per_frame`,
  /// then the earlier scene's.
  std::vector<Metric> metrics() const override;

  long long evaluations() const override { return run_->evaluations(); }
  long long body_count() const override { return run_->body_count(); }
  void draw(DrawList& list) const override { run_->draw(list); }
  CameraPose camera(const CameraPose& usual) const override {
    return run_->camera(usual);
  }
  void draw_reference(DrawList& list) const override { run_->draw_reference(list); }

 private:
  const Trade& trade_;
  int steps_per_frame_;
  std::unique_ptr<Simulation> run_;
};

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_07
