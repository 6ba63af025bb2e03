/// @file
/// Elliptic integrals and functions, in double and to a few units of round-off.
/// Source: NIST Handbook of Mathematical Functions (2010), chapters 19 and 22; Carlson,
/// Numerical computation of real or complex elliptic integrals (1995).
#pragma once

namespace timestep::exact {

/// Carlson's symmetric integral of the first kind; at most one argument is 0.
double carlson_rf(double x, double y, double z);

/// R_C(x, y) = R_F(x, y, y), x >= 0 and y > 0.
double carlson_rc(double x, double y);

/// Carlson's symmetric integral of the third kind, p >= 0 (infinite at 0); at most one
/// of the others is 0.
double carlson_rj(double x, double y, double z, double p);

/// Jacobi's functions of one argument: sn, cn of the amplitude, and dn² = 1 - m sn².
struct Jacobi {
  double sn, cn, dn;
};

/// Integrals and functions of the parameter m = 1 - m1, 0 <= m <= 1. Both are given, so
/// that close to either end nothing is lost.
struct Elliptic {
  double m, m1;

  /// K, a quarter of the period of sn; infinite at m = 1.
  double quarter() const;

  /// The integral of the first kind up to every phi [rad].
  double first_kind(double phi) const;

  /// am(w) [rad], its inverse.
  double am(double w) const;

  /// sn, cn, dn of every w; of beyond 350 as of 350 at m = 1, where they go to 1, 0, 0.
  Jacobi jacobi(double w) const;

  /// Parts of the integral of the third kind with n = 1 - n1 <= 1: of sn² / (1 - n sn²)
  /// and of cn² / (1 - n sn²) from 0 to w. Pi(n) is w + n times the first. None of them
  /// cancels.
  double sine_part(double n1, double w) const;
  double cosine_part(double n1, double w) const;
};

/// Those of the sum of two arguments. What starts close to the end of a quarter keeps
/// all digits of how close: an amplitude could not hold them.
Jacobi sum(const Jacobi& a, const Jacobi& b, double m);

}  // namespace timestep::exact
