// Chapter 4's answers to the pairs, and how their time grows with the size of hulls.
#include "bench/contacts.hpp"

#include <limits>

#include "common/physics/epa.hpp"
#include "common/physics/manifold.hpp"
#include "common/physics/primitives.hpp"
#include "common/physics/sat.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

using namespace contact_bench;

constexpr bool k_single = std::numeric_limits<Real>::digits == 24;

struct PlacedPair {
  std::size_t a, b;
  Pose pose_a, pose_b, moved_b;
};

// All that a query may ask for, made beforehand. What refers to what stays in place
struct Bodies {
  std::vector<ConvexHull> hulls;
  std::vector<Shape> shapes;
  std::vector<Convex> convexes;
  std::vector<PlacedPair> pairs;

  Bodies(std::span<const SolidPair> solid_pairs, std::span<const Solid> solids) {
    for (const Solid& solid : solids) {
      const std::vector<Vec3> points(solid.vertices.begin(), solid.vertices.end());
      hulls.push_back(points.empty() ? ConvexHull{} : convex_hull(points).hull);
    }
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const Solid& solid = solids[i];
      if (solid.radius > 0)
        shapes.emplace_back(Sphere{Real(solid.radius)});
      else if (solid.vertices.empty())
        shapes.emplace_back(Box{Vec3(solid.half_extents)});
      else
        shapes.emplace_back(hull_shape(hulls[i]));
    }
    for (const Shape& shape : shapes) convexes.push_back(convex(shape));
    for (const auto& [a, b, place_a, place_b, moved_b, distance] : solid_pairs)
      pairs.push_back({a, b, pose(place_a), pose(place_b), pose(moved_b)});
  }
  Bodies(const Bodies&) = delete;
  Bodies& operator=(const Bodies&) = delete;

  static Pose pose(const Place& place) {
    return {Vec3(place.position), Quat(place.orientation)};
  }
  const Sphere& sphere(std::size_t i) const { return std::get<Sphere>(shapes[i]); }
  const Box& box(std::size_t i) const { return std::get<Box>(shapes[i]); }
};

// query(bodies, pair) gives the signed distance
template <class Query>
struct Ours {
  Bodies bodies;
  Query query;

  double ask(std::size_t i) const { return double(query(bodies, bodies.pairs[i])); }
};

// Every query begins where the pair's last one ended, B having moved there or back
struct Warm {
  struct Last {
    GjkCache cache;
    bool has_moved = false;
  };
  Bodies bodies;
  std::vector<Last> last{bodies.pairs.size()};

  Warm(std::span<const SolidPair> pairs, std::span<const Solid> solids)
      : bodies(pairs, solids) {
    for (std::size_t i = 0; i < last.size(); ++i) ask(i);
  }
  double ask(std::size_t i) {
    const PlacedPair& pair = bodies.pairs[i];
    Last& it = last[i];
    it.has_moved = !it.has_moved;
    return double(separation(bodies.convexes[pair.a], pair.pose_a,
                             bodies.convexes[pair.b],
                             it.has_moved ? pair.moved_b : pair.pose_b, &it.cache)
                      .distance);
  }
};

const std::string k_precision = k_single ? "/single" : "/double";

template <class Query>
void add(const NamedSet& set, Question question, const std::string& name,
         const Query& query) {
  add_contacts(set, question, name + k_precision,
               [=](std::span<const SolidPair> pairs, std::span<const Solid> solids) {
                 return Ours<Query>{{pairs, solids}, query};
               });
}

void add_warm(const NamedSet& set) {
  add_contacts(set, Question::distance, "gjk_epa_warm" + k_precision,
               [](std::span<const SolidPair> pairs, std::span<const Solid> solids) {
                 return Warm(pairs, solids);
               });
}

// --- Ways to answer

const auto k_intersect = [](const Bodies& bodies, const PlacedPair& p) {
  return intersect(bodies.convexes[p.a], p.pose_a, bodies.convexes[p.b], p.pose_b)
             ? Real(-1)
             : Real(1);
};

const auto k_gjk_epa = [](const Bodies& bodies, const PlacedPair& p) {
  return separation(bodies.convexes[p.a], p.pose_a, bodies.convexes[p.b], p.pose_b)
      .distance;
};

const auto k_closed_form = [](const Bodies& bodies, const PlacedPair& p) {
  return sphere_box(bodies.sphere(p.a), p.pose_a, bodies.box(p.b), p.pose_b).distance;
};

const auto k_sat_boxes = [](const Bodies& bodies, const PlacedPair& p) {
  return sat(bodies.box(p.a), p.pose_a, bodies.box(p.b), p.pose_b).separation.distance;
};

const auto k_sat_hulls = [](const Bodies& bodies, const PlacedPair& p) {
  return sat(bodies.hulls[p.a], p.pose_a, bodies.hulls[p.b], p.pose_b)
      .separation.distance;
};

Real manifold_between(const auto& a, const auto& b, const PlacedPair& p,
                      const Separation& s) {
  Manifold manifold = contact_manifold(a, p.pose_a, b, p.pose_b, s);
  benchmark::DoNotOptimize(manifold);
  return manifold.count > 0 ? s.distance : Real(k_no_answer);
}

const auto k_manifold_of_sphere = [](const Bodies& bodies, const PlacedPair& p) {
  const Sphere& a = bodies.sphere(p.a);
  const Box& b = bodies.box(p.b);
  return manifold_between(a, b, p, sphere_box(a, p.pose_a, b, p.pose_b));
};

const auto k_manifold_of_boxes = [](const Bodies& bodies, const PlacedPair& p) {
  const Box &a = bodies.box(p.a), &b = bodies.box(p.b);
  return manifold_between(a, b, p, sat(a, p.pose_a, b, p.pose_b).separation);
};

const auto k_manifold_of_hulls = [](const Bodies& bodies, const PlacedPair& p) {
  return manifold_between(
      bodies.hulls[p.a], bodies.hulls[p.b], p,
      separation(bodies.convexes[p.a], p.pose_a, bodies.convexes[p.b], p.pose_b));
};

const auto k_manifold_by_sat = [](const Bodies& bodies, const PlacedPair& p) {
  const ConvexHull &a = bodies.hulls[p.a], &b = bodies.hulls[p.b];
  return manifold_between(a, b, p, sat(a, p.pose_a, b, p.pose_b).separation);
};

void add_gjk_epa(const NamedSet& set) {
  add(set, Question::boolean, "gjk_epa", k_intersect);
  add(set, Question::distance, "gjk_epa", k_gjk_epa);
  add_warm(set);
  add(set, Question::depth, "gjk_epa", k_gjk_epa);
}

// --- Growth

// Adds growth/QUESTION/METHOD/VERTICES: the time of an answer; of the separating axis
// test also how many pairs of edges it looks at
template <class Query>
void add_growth(Question question, const std::string& name, std::size_t vertices,
                const Query& query) {
  const std::string what = std::string("growth/") + name_of(question) + "/" + name;
  const auto measure = [=](benchmark::State& run) {
    const PairSet set = few_pairs_of_hulls(vertices);
    const Bodies bodies(asked(set, question), set.solids);
    for ([[maybe_unused]] auto _ : run)
      for (const PlacedPair& pair : bodies.pairs)
        benchmark::DoNotOptimize(query(bodies, pair));
    const PlacedPair& first = bodies.pairs[0];
    const ConvexHull &a = bodies.hulls[first.a], &b = bodies.hulls[first.b];
    if (name == "sat")
      run.counters["edge_pairs"] =
          double(sat(a, first.pose_a, b, first.pose_b).edge_pairs);
    run.SetItemsProcessed(run.iterations()
                          * static_cast<long long>(bodies.pairs.size()));
  };
  benchmark::RegisterBenchmark((what + "/" + std::to_string(vertices)).c_str(),
                               measure);
}

}  // namespace

void add_contacts_of_ours() {
  add(k_sphere_box, Question::boolean, "closed_form", k_closed_form);
  add(k_sphere_box, Question::distance, "closed_form", k_closed_form);
  add(k_sphere_box, Question::depth, "closed_form", k_closed_form);
  add(k_sphere_box, Question::manifold, "closed_form", k_manifold_of_sphere);
  add(k_box_box, Question::boolean, "sat", k_sat_boxes);
  add(k_box_box, Question::depth, "sat", k_sat_boxes);
  add(k_box_box, Question::manifold, "sat", k_manifold_of_boxes);
  add(k_hull32, Question::depth, "sat", k_sat_hulls);
  add(k_hull32, Question::manifold, "sat", k_manifold_by_sat);
  for (const NamedSet& set : {k_sphere_box, k_box_box, k_hull32, k_hull1000})
    add_gjk_epa(set);
  add(k_hull32, Question::manifold, "gjk_epa", k_manifold_of_hulls);
  add(k_hull1000, Question::manifold, "gjk_epa", k_manifold_of_hulls);
}

void add_growth() {
  for (std::size_t n = 8; n <= 4096; n *= 2) {
    add_growth(Question::distance, "gjk_epa", n, k_gjk_epa);
    add_growth(Question::depth, "gjk_epa", n, k_gjk_epa);
    if (n <= 512) add_growth(Question::depth, "sat", n, k_sat_hulls);
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
