// pair-peers FILE…: asks everyone about the pairs of truth files, in double, and
// prints how many each answers wrongly, not at all, or without end, as JSON. A question
// is put in a process of its own: some crash over one, and some do not come back.
#include "bench/pair_peers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/chapter/json_file.hpp"
#include "common/physics/pair_query.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

using Json = nlohmann::ordered_json;
using chapter_04::PairCase;
using chapter_04::PlacedPair;
using chapter_04::PlacedShape;

constexpr rlim_t k_seconds = 2;  // of one processor

template <std::size_t index>
PeerAnswer ask_method(const PlacedPair& pair) {
  const auto& [a, b] = pair;
  const Separation s = pair_methods()[index].query(a.shape, a.pose, b.shape, b.pose);
  if (s.reason == Reason::no_answer || s.reason == Reason::out_of_range) return {};
  const bool stopped = pair_methods()[index].name.starts_with("libccd")
                       && s.reason == Reason::iteration_limit;
  return {s.distance, s.reason == Reason::lower_bound, !stopped};
}

template <std::size_t index>
bool method_takes(const PlacedPair& pair) {
  return pair_methods()[index].takes(pair.a.shape, pair.b.shape);
}

std::vector<Peer> peers() {
  std::vector<Peer> all{{"gjk_epa", ask_method<0>, method_takes<0>},
                        {"sat", ask_method<2>, method_takes<2>},
                        {"libccd_epa", ask_method<3>, method_takes<3>},
                        {"libccd_mpr", ask_method<4>, method_takes<4>}};
#if defined(TIMESTEP_FCL)
  all.push_back({"FCL", ask_fcl});
#endif
#if defined(TIMESTEP_BULLET)
  all.push_back({"Bullet", ask_bullet});
#endif
  return all;
}

// Nothing comes back of a child that crashes, or is stopped
PeerAnswer ask_apart(const Peer& peer, const PlacedPair& pair) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{k_seconds, k_seconds};
    setrlimit(RLIMIT_CPU, &limit);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    const PeerAnswer answer = peer.ask(pair);
    const bool written = write(ends[1], &answer, sizeof answer) == sizeof answer;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  PeerAnswer answer;
  const bool answered = read(ends[0], &answer, sizeof answer) == sizeof answer;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!answered) answer = {};
  if (WIFSIGNALED(status))
    answer.has_end = WTERMSIG(status) != SIGKILL && WTERMSIG(status) != SIGXCPU;
  return answer;
}

struct Tally {
  int asked = 0, off_6 = 0, off_9 = 0, wrong_side = 0, no_answer = 0, no_end = 0;
};

// [m] How far its points are from each other, at most
double size_of(const PlacedPair& pair, double distance) {
  const auto reach = [](const PlacedShape& placed) {
    const Convex body = convex(placed.shape);
    return body.reach + body.radius;
  };
  return 2 * (reach(pair.a) + reach(pair.b)) + std::abs(distance);
}

// Where only a bound is given it is off if it is on the wrong side
void count(Tally& tally, const PeerAnswer& answer, double distance, double size) {
  ++tally.asked;
  if (!answer.has_end) return void(++tally.no_end);
  if (!std::isfinite(answer.distance)) return void(++tally.no_answer);
  const bool is_right_bound = answer.is_bound && distance > 0;
  const double off = is_right_bound ? 0 : std::abs(answer.distance - distance) / size;
  tally.off_6 += off > 1e-6;
  tally.off_9 += off > 1e-9;
  const bool is_other_side = (answer.distance > 0) != (distance > 0);
  tally.wrong_side += is_other_side && std::abs(distance) > 1e-10 * size;
}

double expected_distance(const Json& test) {
  const Json& expected = test.at("expected");
  if (expected.contains("signed_distance")) return expected.at("signed_distance");
  return std::sqrt(expected.at("signed_distance_squared").get<double>());
}

Tally ask_all(const Peer& peer, const std::vector<PairCase>& cases,
              const Json& document) {
  Tally tally;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const PlacedPair& pair = cases[i].pair;
    if (peer.takes != nullptr && !peer.takes(pair)) continue;
    const double distance = expected_distance(document.at("cases")[i]);
    count(tally, ask_apart(peer, pair), distance, size_of(pair, distance));
  }
  return tally;
}

Json run(const std::filesystem::path& file) {
  const Json document = load_json(file);
  const std::vector<PairCase> cases = chapter_04::read_pair_file(file);
  Json counted;
  for (const Peer& peer : peers()) {
    const Tally t = ask_all(peer, cases, document);
    const std::string name =
        fmt::format("pairs/{}/{}", file.stem().string(), peer.name);
    counted[name] = {{"asked", t.asked},         {"off_6", t.off_6},
                     {"off_9", t.off_9},         {"wrong_side", t.wrong_side},
                     {"no_answer", t.no_answer}, {"no_end", t.no_end}};
  }
  return counted;
}

}  // namespace
}  // namespace timestep::inline TIMESTEP_PRECISION::bench

int main(int argc, char** argv) {
  nlohmann::ordered_json counted;
  try {
    for (int i = 1; i < argc; ++i) counted.update(timestep::bench::run(argv[i]));
    fmt::print("{}\n", counted.dump(1));
  } catch (const std::exception& error) {
    fmt::print(stderr, "pair-peers: {}\n", error.what());
    return 2;
  }
}
