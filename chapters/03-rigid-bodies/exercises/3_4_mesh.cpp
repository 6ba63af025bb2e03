// Below, a triangle's tetrahedron is always positive, and the body is taken for points
// of mass in its vertices. Of a box about the origin, only the moments are wrong then.
//
// Hints: with signs, tetrahedra may stick out of the body, since what is counted too
// much is taken away again. Each has its mean corner as centre: (a + b + c)/4, the
// origin being the fourth corner. The integral of r r^T over it is
//   V/20 (a a^T + b b^T + c c^T + s s^T), s = a + b + c.
// Add up V, V s/4 and these matrices, shift the last to the centre of mass (what does
// the shift take from it?), and only then make it the tensor (3.7), where |r|² is the
// trace of r r^T. `glm::outerProduct(a, b)` is a b^T.
//
// Far from the origin all three sums are large and almost cancel. Who says that the
// origin is the right fourth corner?
#include "chapters/03-rigid-bodies/exercises/3_4_mesh.hpp"

#include <cmath>

namespace timestep {

Real signed_volume(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::abs(glm::dot(a, glm::cross(b, c))) / 6;
}

MassProperties solid(Real density, std::span<const Vec3> vertices,
                     std::span<const Triangle> triangles) {
  MassProperties body{0, Vec3(0), Mat3(0)};
  for (const auto& [i, j, k] : triangles)
    body.mass += density * signed_volume(vertices[i], vertices[j], vertices[k]);

  const Real share = Real(1) / Real(vertices.size());
  for (const Vec3& r : vertices) body.centre_of_mass += share * r;
  for (const Vec3& r : vertices) {
    const Vec3 d = r - body.centre_of_mass;
    body.inertia +=
        body.mass * share * (glm::dot(d, d) * Mat3(1) - glm::outerProduct(d, d));
  }
  return body;
}

}  // namespace timestep
