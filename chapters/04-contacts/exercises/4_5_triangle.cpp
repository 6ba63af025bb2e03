// Below are the normal equations: with e = b - a and f = c - a, the s and t for which
// a + s e + t f is closest to p, cut to the triangle. Two things are wrong with it.
//
// First, cutting s and t is not the way to the closest point of an edge. Second, the
// determinant e.e f.f - (e.f)² is the square of twice the area: of a triangle with the
// sides 1 and a height of 1e-8 it is 1e-16, the difference of two numbers close to
// 1. All its digits are rounding's.
//
// Hints: the closest point is in the face, or on one of the three edges. The closest
// point of a segment is a matter of one division and one clamp. The face: (4.12),
// (4.13) and simplex.cpp. And whatever a face's answer was worth: of four candidates,
// each of them in the triangle, the closest wins. How do you make sure that a candidate
// is in the triangle, if rounding made it?
#include "chapters/04-contacts/exercises/4_5_triangle.hpp"

#include <algorithm>

namespace timestep {

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 e = b - a, f = c - a, d = p - a;
  const Real ee = glm::dot(e, e), ef = glm::dot(e, f), ff = glm::dot(f, f);
  const Real determinant = ee * ff - ef * ef;
  const Real s = (ff * glm::dot(e, d) - ef * glm::dot(f, d)) / determinant;
  const Real t = (ee * glm::dot(f, d) - ef * glm::dot(e, d)) / determinant;
  return a + std::clamp(s, Real(0), Real(1)) * e + std::clamp(t, Real(0), Real(1)) * f;
}

}  // namespace timestep
