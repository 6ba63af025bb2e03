/// @file
/// What single precision may do to a run, bounded by a run in double: to first order,
/// and without knowing how the single run went.
#pragma once

#include <functional>

#include "tests/truth/runs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// A run and how its rounding is bounded.
struct Rounded {
  Run run;
  bool linear;            ///< the step is the same affine map everywhere
  bool in_frame = false;  ///< as fine_end_of runs it
  double solver_error{};  ///< a step's, in units of u and of max(|x|, 1)
};

/// Where single precision may be: within an ellipsoid about a place, of which these are
/// conjugate half-diameters. So it stays known that errors along an orbit are large and
/// that those of what the orbit keeps are small.
using Ellipsoid = std::vector<truth::Place>;

/// A matrix, column by column.
using Matrix = std::vector<std::vector<double>>;

/// C becomes D C D'; `room` is another matrix of its size.
void carry(const Matrix& D, Matrix& C, Matrix& room);

/// L, a column after the other: L L' = C. What rounding leaves below 0 is 0.
Matrix cholesky(Matrix C);

/// A run in double, followed step by step, and where the same run in single precision
/// may be. Throws truth::NotCovered where that leaves the range of a float.
///
/// To first order an error e becomes D e + r in a step: D the derivative of the step, r
/// the rounding in it. All that is kept is C, the sum of D...D r² D'...D' over all
/// steps so far. By Cauchy and Schwarz |g e| <= sqrt(number of roundings g C g') for
/// every g, whatever the signs of the roundings: e is in the ellipsoid of the columns
/// of L, where C = L L'.
class Followed {
 public:
  explicit Followed(const Rounded& rounded);

  void step();
  truth::Place at() const;
  Ellipsoid error() const;

 private:
  using Vector = std::vector<double>;

  // A number for x and one for v
  struct Both {
    double x, v;
  };

  void look();
  void add_rounding();
  Both rounding() const;

  Rounded rounded_;
  State now_;
  Vector change_, room_;  // of a linear run: what the next step adds to x, v
  Matrix derivative_, sum_, half_;
  Both slope_{};   // the rates at which the acceleration changes with x and with v
  Both before_{};  // rounding at the start of the step
  double roundings_ = 0;
};

/// How far the numbers in `fields` may be off while its argument is in the ellipsoid:
/// the changes along its half-diameters, added up. In the shape of the fields.
truth::Json spread(const std::function<truth::Json(const truth::Place&)>& fields,
                   const truth::Place& at, const Ellipsoid& error);

}  // namespace timestep::inline TIMESTEP_PRECISION
