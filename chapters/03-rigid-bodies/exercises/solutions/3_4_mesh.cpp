// The fourth corner may be anywhere, so it is put on the body: numbers as small as the
// body is, instead of as large as its distance. From the origin the moments of a body d
// metres away are differences of numbers d² times its mass, and in double a kilometre
// costs six of the sixteen digits, a thousand kilometres twelve.
#include "chapters/03-rigid-bodies/exercises/3_4_mesh.hpp"

namespace timestep {

Real signed_volume(const Vec3& a, const Vec3& b, const Vec3& c) {
  return glm::dot(a, glm::cross(b, c)) / 6;
}

MassProperties solid(Real density, std::span<const Vec3> vertices,
                     std::span<const Triangle> triangles) {
  // (3.10) Integrals of 1, r and r r^T, with r from the first vertex
  const Vec3 corner = vertices.front();
  Real volume = 0;
  Vec3 first(0);
  Mat3 second(0);
  for (const auto& [i, j, k] : triangles) {
    const Vec3 a = vertices[i] - corner;
    const Vec3 b = vertices[j] - corner;
    const Vec3 c = vertices[k] - corner;
    const Vec3 s = a + b + c;
    const Real V = signed_volume(a, b, c);
    volume += V;
    first += V / 4 * s;
    second += V / 20
              * (glm::outerProduct(a, a) + glm::outerProduct(b, b)
                 + glm::outerProduct(c, c) + glm::outerProduct(s, s));
  }

  // (3.6), (3.9) To the centre of mass; (3.7) the tensor from r r^T
  const Vec3 centre = first / volume;
  second -= volume * glm::outerProduct(centre, centre);
  const Real trace = second[0][0] + second[1][1] + second[2][2];
  return {density * volume, corner + centre, density * (trace * Mat3(1) - second)};
}

}  // namespace timestep
