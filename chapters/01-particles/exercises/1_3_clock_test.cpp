// Against the sum of the same frames in double, whose own error is far below the
// tolerance. Compensated summation is within 2 u of the sum: two roundings, however
// many frames.
#include "chapters/01-particles/exercises/1_3_clock.hpp"

#include <limits>
#include <string_view>
#include <vector>

#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<float>::epsilon() / 2;

// Lets the frames pass again and again, n in all
void compare(std::string_view what, const std::vector<float>& frames, int n) {
  Clock clock;
  double right = 0;
  for (int i = 0; i < n; ++i) {
    const float frame = frames[static_cast<std::size_t>(i) % frames.size()];
    tick(clock, frame);
    right += frame;
  }
  expect(fmt::format("the clock [s] after {}", what), clock.time, right,
         2 * k_u * right);
}

}  // namespace

TEST_CASE("a single frame") {
  compare("one frame of 1/60 s", {1.0F / 60}, 1);
}

TEST_CASE("an hour at 60 Hz") {
  compare("an hour of frames of 1/60 s", {1.0F / 60}, 216'000);
}

TEST_CASE("frames of all lengths") {
  compare("300,000 frames between 7 ms and 250 ms",
          {1.0F / 144, 1.0F / 60, 0.25F, 0.0171F, 1.0F / 30}, 300'000);
}
