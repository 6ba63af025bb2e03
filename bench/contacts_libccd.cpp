// The pairs by libccd, with the tolerances that it comes with. It has no shapes of its
// own: it gets the support functions of chapter 4, which climb from where they last
// were.
#include <ccd/ccd.h>

#include "bench/contacts.hpp"
#include "common/physics/convex_hull.hpp"
#include "common/physics/minkowski.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

using namespace contact_bench;

struct Body {
  const Convex* convex;
  Pose pose;
  mutable std::uint32_t hint = 0;
};

ccd_vec3_t to_ccd(const Vec3& v) {
  return {{ccd_real_t(v.x), ccd_real_t(v.y), ccd_real_t(v.z)}};
}

void support_of(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Body& body = *static_cast<const Body*>(object);
  const auto& [shape, core_support, radius, reach] = *body.convex;
  const Vec3 d(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3 far = core_support(shape, direction_in_body(body.pose, d), body.hint);
  *point = to_ccd(point_in_world(body.pose, far) + radius * unit_or_zero(d));
}

void centre_of(const void* object, ccd_vec3_t* centre) {
  *centre = to_ccd(static_cast<const Body*>(object)->pose.position);
}

struct Pair {
  Body a, b;
};

struct Libccd {
  std::vector<ConvexHull> hulls;
  std::vector<Shape> shapes;
  std::vector<Convex> convexes;
  std::vector<Pair> pairs;
  ccd_t ccd{};

  Libccd(std::span<const SolidPair> solid_pairs, std::span<const Solid> solids) {
    for (const Solid& solid : solids)
      hulls.push_back(solid.vertices.empty() ? ConvexHull{}
                                             : convex_hull(solid.vertices).hull);
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const Solid& solid = solids[i];
      if (solid.radius > 0)
        shapes.emplace_back(Sphere{solid.radius});
      else if (solid.vertices.empty())
        shapes.emplace_back(Box{solid.half_extents});
      else
        shapes.emplace_back(hull_shape(hulls[i]));
    }
    for (const Shape& shape : shapes) convexes.push_back(convex(shape));
    for (const SolidPair& p : solid_pairs)
      pairs.push_back({{&convexes[p.a], {p.place_a.position, p.place_a.orientation}},
                       {&convexes[p.b], {p.place_b.position, p.place_b.orientation}}});
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = support_of;
    ccd.center1 = ccd.center2 = centre_of;
    ccd.max_iterations = 500;  // without a limit EPA may not end
  }
  Libccd(const Libccd&) = delete;
  Libccd& operator=(const Libccd&) = delete;
};

using Meets = int (*)(const void*, const void*, const ccd_t*);
using Penetrates = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*,
                           ccd_vec3_t*, ccd_vec3_t*);

struct Boolean {
  Libccd libccd;
  Meets meets;

  double ask(std::size_t i) const {
    const auto& [a, b] = libccd.pairs[i];
    return meets(&a, &b, &libccd.ccd) != 0 ? -1 : 1;
  }
};

struct Depth {
  Libccd libccd;
  Penetrates penetrates;

  double ask(std::size_t i) const {
    const auto& [a, b] = libccd.pairs[i];
    ccd_real_t depth = 0;
    ccd_vec3_t direction, position;
    const int status = penetrates(&a, &b, &libccd.ccd, &depth, &direction, &position);
    return status == 0 ? -double(depth) : k_no_answer;
  }
};

void add(const NamedSet& set, const std::string& name, Meets meets,
         Penetrates penetrates) {
  add_contacts(set, Question::boolean, name,
               [=](std::span<const SolidPair> pairs, std::span<const Solid> solids) {
                 return Boolean{{pairs, solids}, meets};
               });
  add_contacts(set, Question::depth, name,
               [=](std::span<const SolidPair> pairs, std::span<const Solid> solids) {
                 return Depth{{pairs, solids}, penetrates};
               });
}

}  // namespace

void add_contacts_of_libccd() {
  for (const NamedSet& set : {k_sphere_box, k_box_box, k_hull32, k_hull1000}) {
    add(set, "libccd_epa/double", ccdGJKIntersect, ccdGJKPenetration);
    add(set, "libccd_mpr/double", ccdMPRIntersect, ccdMPRPenetration);
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
