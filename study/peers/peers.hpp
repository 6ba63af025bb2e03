/// @file
/// Other libraries on problems of the study. Each measures itself as the scene does, so
/// that its numbers belong in the same diagram. Source: chapter 7.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/chapter/scene.hpp"
#include "study/problem.hpp"

namespace timestep::study {

/// A problem at a step, with every parameter of its scene.
struct PeerSetup {
  const Problem* problem = nullptr;
  const Scene* scene = nullptr;
  double dt = 0;  ///< [s]
  std::map<std::string, double> parameters;
  int iterations = 0;  ///< of the library's solver; 0: its own default
};

/// A library's run of it.
class PeerRun {
 public:
  virtual ~PeerRun() = default;

  /// Advances by dt. This alone is timed. Throws if the library gives up.
  virtual void step() = 0;

  /// Called at the start and after every step, outside of the timing.
  virtual void observe() = 0;

  /// The problem's metric, of what was observed so far.
  virtual double error() const = 0;

  virtual long long evaluations() const = 0;  ///< 0 where a library counts none
  virtual long long bodies() const = 0;
};

/// A method of a library.
struct Peer {
  std::string method, precision;
  bool iterates = false;  ///< it heeds the setup's iterations

  /// Null for a problem that it has no answer to.
  std::function<std::unique_ptr<PeerRun>(const PeerSetup& setup)> start;
};

std::vector<Peer> peers_of_odeint();
std::vector<Peer> peers_of_gsl();
std::vector<Peer> peers_of_fcl();

/// Bullet and ODE, in the precision that this program is linked with.
std::vector<Peer> peers_of_worlds();

/// Our own methods, set up as the libraries are, to check what those are measured by.
std::vector<Peer> own_worlds();
std::vector<Peer> own_pairs();

/// All that this program has.
std::vector<Peer> peers();

}  // namespace timestep::study
