#include "study/peers/peers.hpp"

namespace timestep::study {

std::vector<Peer> peers() {
  std::vector<Peer> all;
  [[maybe_unused]] const auto add = [&](const std::vector<Peer>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
#if defined(TIMESTEP_HAS_ODEINT)
  add(peers_of_odeint());
#endif
#if defined(TIMESTEP_HAS_GSL)
  add(peers_of_gsl());
#endif
#if defined(TIMESTEP_HAS_FCL)
  add(peers_of_fcl());
#endif
#if defined(TIMESTEP_HAS_WORLDS)
  add(peers_of_worlds());
#endif
  return all;
}

}  // namespace timestep::study
