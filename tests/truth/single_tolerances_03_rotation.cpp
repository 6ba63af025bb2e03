// What single precision may cost in the fields of turning bodies: see
// rotation_error.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/truth/inputs.hpp"
#include "tests/truth/rotation_error.hpp"
#include "tests/truth/rotation_fields.hpp"

namespace timestep::truth {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

struct Reached {
  Place at;
  Ellipsoid error;
};

// First order says nothing of an orientation that may be any
bool may_be_any(const Ellipsoid& error) {
  double square = 0;
  for (const Place& by : error)
    square += std::inner_product(by.x.begin(), by.x.end(), by.x.begin(), 0.0);
  return square > 1;
}

Reached followed(const RotationRun& run) {
  FollowedRotation now(run);
  for (long long i = 0; i < run.n; ++i) now.step();
  return {now.at(), now.error()};
}

template <class Fields>
Json at_the_end(const Json& inputs, const RotationRun& run, const Fields& fields) {
  const auto [at, error] = followed(run);
  return spread([&](const Place& place) { return fields(inputs, place); }, at, error);
}

double spread_of_energy(const Json& inputs, const FollowedRotation& run) {
  const auto ratio = [&](const Place& at) -> Json {
    return {{"it", energy_ratio(inputs, at)}};
  };
  return spread(ratio, run.at(), run.error())["it"].get<double>();
}

Json rotation_steps(const Json& inputs) {
  const RotationRun run = rotation_run(inputs);
  FollowedRotation now(run);
  double worst = spread_of_energy(inputs, now);
  for (long long i = 0; i < run.n; ++i) {
    now.step();
    worst = std::max(worst, spread_of_energy(inputs, now));
  }
  const auto fields = [&](const Place& at) { return rotation_fields(inputs, at); };
  Json tolerance = spread(fields, now.at(), now.error());
  tolerance["energy_relative_error_max"] = worst;
  return tolerance;
}

Json rotation_order(const Json& inputs) {
  const std::vector<long long> n = ladder(inputs);
  std::vector<double> uncertain, share, order;
  for (const long long steps : n) {
    const auto [at, error] = followed(rotation_order_run(inputs, steps));
    const auto angle = [&](const Place& place) -> Json {
      return {{"it", attitude_error(inputs, place)}};
    };
    const double off = spread(angle, at, error)["it"].get<double>();
    uncertain.push_back(may_be_any(error) ? k_infinity : off);

    // By how much the logarithm may fall; of an error that may as well be 0, by
    // anything
    const double left = 1 - uncertain.back() / attitude_error(inputs, at);
    share.push_back(left > 0 ? -std::log(left) : k_infinity);
  }
  for (std::size_t i = 1; i < n.size(); ++i)
    order.push_back((share[i - 1] + share[i])
                    / std::abs(std::log(double(n[i]) / double(n[i - 1]))));
  return {{"attitude_errors", uncertain}, {"observed_order", order}};
}

// Between which steps the energy may have come to a share of the start's: as far apart
// as a single run and the exact one may be in doing so
class Crossing {
 public:
  explicit Crossing(double share) : share_(share) {}

  void look(double step, double ratio, double uncertain) {
    const double beyond = share_ > 1 ? ratio - share_ : share_ - ratio;
    if (earliest_ < 0 && beyond >= -uncertain) earliest_ = step;
    if (latest_ < 0 && beyond >= uncertain) latest_ = step;
  }
  double apart() const { return latest_ < 0 ? 0 : latest_ - earliest_; }

 private:
  double share_, earliest_ = -1, latest_ = -1;
};

Json gyro_steps(const Json& inputs) {
  const RotationRun run = gyro_run(inputs);
  FollowedRotation now(run);
  Crossing doubled(2), halved(0.5);
  for (long long i = 1; i <= run.n; ++i) {
    now.step();
    const double ratio = energy_ratio(inputs, now.at());
    const double uncertain = spread_of_energy(inputs, now);
    doubled.look(double(i), ratio, uncertain);
    halved.look(double(i), ratio, uncertain);
  }
  const auto fields = [&](const Place& at) { return gyro_fields(inputs, at); };
  Json tolerance = spread(fields, now.at(), now.error());
  tolerance["first_step_with_double_energy"] = doubled.apart();
  tolerance["first_step_with_half_energy"] = halved.apart();
  return tolerance;
}

Json listing3_error(const Json& inputs) {
  return at_the_end(inputs, listing3_run(inputs), listing3_fields);
}

Json quaternion_drift(const Json& inputs) {
  RotationRun run = quaternion_drift_run(inputs);
  Json tolerance = at_the_end(inputs, run, quaternion_drift_fields);
  run.n = 1;
  tolerance.update(at_the_end(inputs, run, turned_by_steps));
  return tolerance;
}

}  // namespace

std::span<const Kind> single_tolerances_03_rotation() {
  static constexpr std::array<Kind, 5> all{{
      {"rotation_steps", rotation_steps},
      {"rotation_order", rotation_order},
      {"gyro_steps", gyro_steps},
      {"listing3_error", listing3_error},
      {"quaternion_drift", quaternion_drift},
  }};
  return all;
}

}  // namespace timestep::truth
