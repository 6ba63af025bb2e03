// The pairs by Bullet: its GJK with its EPA, without margins; its detector for boxes;
// and what it clips two hulls' faces with. In the precision that it was built with.
#include <memory>

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPolyhedralContactClipping.h>
#include <btBulletCollisionCommon.h>

#include "bench/contacts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

using namespace contact_bench;

btVector3 bullet_vector(const glm::dvec3& v) {
  return {btScalar(v.x), btScalar(v.y), btScalar(v.z)};
}

btTransform bullet_transform(const Place& place) {
  const glm::dquat& q = place.orientation;
  return btTransform(
      btQuaternion(btScalar(q.x), btScalar(q.y), btScalar(q.z), btScalar(q.w)),
      bullet_vector(place.position));
}

// A ball is all margin; the other shapes get none
std::unique_ptr<btConvexShape> bullet_shape(const Solid& solid) {
  if (solid.radius > 0) return std::make_unique<btSphereShape>(btScalar(solid.radius));
  if (solid.vertices.empty()) {
    auto box = std::make_unique<btBoxShape>(bullet_vector(solid.half_extents));
    box->setMargin(0);
    return box;
  }
  auto hull = std::make_unique<btConvexHullShape>();
  for (const glm::dvec3& v : solid.vertices) hull->addPoint(bullet_vector(v), false);
  hull->recalcLocalAabb();
  hull->setMargin(0);
  hull->initializePolyhedralFeatures();
  return hull;
}

// The deepest point that a detector reports
struct Deepest : btDiscreteCollisionDetectorInterface::Result {
  int count = 0;
  btScalar distance = btScalar(BT_LARGE_FLOAT);
  btVector3 normal{0, 0, 0};  // from B to A

  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal_on_b, const btVector3&,
                       btScalar depth) override {
    ++count;
    if (depth >= distance) return;
    distance = depth;
    normal = normal_on_b;
  }
  double answer() const { return count > 0 ? double(distance) : k_no_answer; }
};

using Input = btDiscreteCollisionDetectorInterface::ClosestPointInput;

struct Pair {
  const btConvexShape *a, *b;
  Input input;
};

struct Bullet {
  std::vector<std::unique_ptr<btConvexShape>> shapes;
  std::vector<Pair> pairs;
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver epa;

  Bullet(std::span<const SolidPair> solid_pairs, std::span<const Solid> solids) {
    for (const Solid& solid : solids) shapes.push_back(bullet_shape(solid));
    for (const SolidPair& p : solid_pairs) {
      Input input;
      input.m_transformA = bullet_transform(p.place_a);
      input.m_transformB = bullet_transform(p.place_b);
      pairs.push_back({shapes[p.a].get(), shapes[p.b].get(), input});
    }
  }

  Deepest detect(const Pair& pair) {
    Deepest deepest;
    btGjkPairDetector detector(pair.a, pair.b, &simplex, &epa);
    detector.getClosestPoints(pair.input, deepest, nullptr);
    return deepest;
  }
};

struct Any {
  Bullet bullet;

  double ask(std::size_t i) { return bullet.detect(bullet.pairs[i]).answer(); }
};

struct Boxes {
  Bullet bullet;

  double ask(std::size_t i) const {
    const auto& [a, b, input] = bullet.pairs[i];
    Deepest deepest;
    btBoxBoxDetector detector(static_cast<const btBoxShape*>(a),
                              static_cast<const btBoxShape*>(b));
    detector.getClosestPoints(input, deepest, nullptr);
    return deepest.count > 0 ? double(deepest.distance) : 1;
  }
};

const btConvexPolyhedron& polyhedron(const btConvexShape* shape) {
  return *static_cast<const btPolyhedralConvexShape*>(shape)->getConvexPolyhedron();
}

struct ClippedHulls {
  Bullet bullet;
  btVertexArray clipped{}, spare{};

  double ask(std::size_t i) {
    const auto& [a, b, input] = bullet.pairs[i];
    const Deepest found = bullet.detect(bullet.pairs[i]);
    Deepest points;
    btPolyhedralContactClipping::clipHullAgainstHull(
        found.normal, polyhedron(a), polyhedron(b), input.m_transformA,
        input.m_transformB, btScalar(-BT_LARGE_FLOAT), 0, clipped, spare, points);
    benchmark::DoNotOptimize(points);
    return found.answer();
  }
};

template <class Library>
void add(const NamedSet& set, Question question, const std::string& name) {
  const std::string precision = sizeof(btScalar) == 4 ? "/single" : "/double";
  add_contacts(set, question, name + precision,
               [](std::span<const SolidPair> pairs, std::span<const Solid> solids) {
                 return Library{{pairs, solids}};
               });
}

}  // namespace

void add_contacts_of_bullet() {
  for (const NamedSet& set : {k_sphere_box, k_box_box, k_hull32, k_hull1000})
    for (const Question q : {Question::boolean, Question::distance, Question::depth})
      add<Any>(set, q, "Bullet");
  for (const Question q : {Question::boolean, Question::depth, Question::manifold})
    add<Boxes>(k_box_box, q, "Bullet_boxes");
  add<ClippedHulls>(k_hull32, Question::manifold, "Bullet");
  add<ClippedHulls>(k_hull1000, Question::manifold, "Bullet");
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
