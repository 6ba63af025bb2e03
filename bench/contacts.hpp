/// @file
/// How the answers of any library to chapter 4's pairs are timed and judged.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string>

#include <benchmark/benchmark.h>

#include "bench/contact_pairs.hpp"
#include "common/physics/precision.hpp"

namespace timestep::contact_bench {

/// What is asked of a pair, and of which pairs: whether any of them meet; the distance
/// of those that do not; the depth of those that do, or all of their contact points.
enum class Question { boolean, distance, depth, manifold };

constexpr const char* name_of(Question question) {
  switch (question) {
    case Question::boolean:
      return "boolean";
    case Question::distance:
      return "distance";
    case Question::depth:
      return "depth";
    case Question::manifold:
      return "manifold";
  }
  return "";
}

/// The answer of a library that finds none.
inline constexpr double k_no_answer = std::numeric_limits<double>::quiet_NaN();

inline std::span<const SolidPair> asked(const PairSet& set, Question question) {
  const std::span<const SolidPair> all = set.pairs;
  const std::size_t half = all.size() / 2;
  if (question == Question::boolean) return all;
  return question == Question::distance ? all.subspan(half) : all.first(half);
}

/// Relative to the distance or depth: 1 where there is no answer, or one that is worth
/// none. Of a boolean the answer is any number with the distance's sign.
inline double error_of(Question question, double answer, double distance) {
  if (question == Question::boolean)
    return std::isfinite(answer) && (answer < 0) == (distance < 0) ? 0 : 1;
  const double error = std::abs(answer - distance) / std::abs(distance);
  return error < 1 ? error : 1;
}

/// Adds contacts/SET/QUESTION/NAME: the time of an answer, how many of a thousand are
/// wrong (by more than 1 %), the mean error and the worst. `prepare` takes pairs and
/// solids; ask(i) of what it returns gives the signed distance [m] of pair i.
void add_contacts(const NamedSet& set, Question question, const std::string& name,
                  const auto& prepare) {
  const auto measure = [=](benchmark::State& run) {
    const std::span<const SolidPair> pairs = asked(set.pairs(), question);
    auto library = prepare(pairs, set.pairs().solids);
    double wrong = 0, sum = 0, worst = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double error = error_of(question, library.ask(i), pairs[i].distance);
      wrong += error > 0.01;
      sum += error;
      worst = std::max(worst, error);
    }
    const double count = double(pairs.size());
    run.counters["wrong"] = 1000 * wrong / count;
    run.counters["error"] = sum / count;
    run.counters["worst_error"] = worst;
    for ([[maybe_unused]] auto _ : run)
      for (std::size_t i = 0; i < pairs.size(); ++i)
        benchmark::DoNotOptimize(library.ask(i));
    run.SetItemsProcessed(run.iterations() * static_cast<long long>(pairs.size()));
  };
  const std::string what = std::string("contacts/") + set.name + "/";
  benchmark::RegisterBenchmark((what + name_of(question) + "/" + name).c_str(),
                               measure);
}

}  // namespace timestep::contact_bench
