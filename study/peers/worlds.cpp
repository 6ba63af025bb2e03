// Chapter 6's problems in other libraries' worlds: bodies stand as the scene has them,
// and the scene's metric is taken of where they get.
#include "bench/worlds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/physics/exact_bounce.hpp"
#include "common/physics/exact_cue_ball.hpp"
#include "common/physics/exact_sliding.hpp"
#include "study/peers/peers.hpp"

namespace timestep::study {
namespace {

using world_bench::Body;
using world_bench::Engine;
using world_bench::State;
using Parameters = std::map<std::string, double>;
using States = std::span<const State>;

constexpr double k_no_number = std::numeric_limits<double>::quiet_NaN();

/// A scene of bodies, those that move last, and the error of all states at a time.
struct Contest {
  world_bench::Scene scene;
  std::function<double(double t, States states)> error;
};

// The bodies that the scene's own simulation starts with, all of one kind
std::vector<Body> bodies_of(const PeerSetup& setup, const Body& like) {
  Setup own{.method = setup.scene->methods.front().name,
            .style = {},
            .dt = setup.dt,
            .duration = setup.problem->duration,
            .parameters = setup.parameters,
            .mesh = {}};
  std::vector<Body> bodies;
  for (const BodyState& state : setup.scene->start(own)->bodies()) {
    bodies.push_back(like);
    bodies.back().position = state.position;
    bodies.back().orientation = state.orientation.value_or(glm::dquat(1, 0, 0, 0));
    bodies.back().velocity = state.velocity;
  }
  return bodies;
}

// A held box, whose top is where the scenes have a half-space
Body floor(double friction, double restitution) {
  return {.solid = {.half_extents = {200, 1, 200}},
          .position = {0, -1, 0},
          .friction = friction,
          .restitution = restitution};
}

Body ball(double mass, double radius, double friction, double restitution) {
  return {.solid = {.radius = radius},
          .mass = mass,
          .friction = friction,
          .restitution = restitution};
}

Contest with_bodies(std::vector<Body> held, const std::vector<Body>& moving,
                    double gravity) {
  held.insert(held.end(), moving.begin(), moving.end());
  return {.scene = {std::move(held), {0, -gravity, 0}}, .error = {}};
}

// A floor of its own below each ball, since the pair's restitution is theirs
Contest bounce(const PeerSetup& setup) {
  const Parameters& p = setup.parameters;
  const double radius = p.at("radius"), gravity = p.at("gravity");
  std::vector<Body> held, balls = bodies_of(setup, ball(1, radius, 0.5, 0));
  std::vector<exact::BouncingBall> exact;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double share = balls.size() > 1 ? double(i) / double(balls.size() - 1) : 1;
    balls[i].restitution = std::lerp(p.at("lowest"), p.at("highest"), share);
    exact.push_back({p.at("height"), balls[i].restitution, gravity});
    held.push_back(floor(0.5, balls[i].restitution));
    held.back().solid.half_extents.x = 1.2 * radius;
    held.back().position.x = balls[i].position.x;
  }
  Contest contest = with_bodies(held, balls, gravity);
  contest.error = [=](double t, States states) {
    double worst = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const double height = states[exact.size() + i].position.y - radius;
      worst = std::max(worst, std::abs(height - exact::bouncing_ball(exact[i], t).x));
    }
    return worst;
  };
  return contest;
}

// Boxes in place of the half-spaces that are the walls, 2 m apart
Contest elastic_gas(const PeerSetup& setup) {
  const Parameters& p = setup.parameters;
  const double e = p.at("restitution");
  std::vector<Body> walls;
  for (glm::length_t axis = 0; axis < 3; ++axis)
    for (const double side : {-2.0, 2.0}) {
      Body wall{
          .solid = {.half_extents = glm::dvec3(3)}, .friction = 0, .restitution = e};
      wall.position[axis] = side;
      wall.solid.half_extents[axis] = 1;
      walls.push_back(wall);
    }
  Contest contest =
      with_bodies(walls, bodies_of(setup, ball(1, p.at("radius"), p.at("friction"), e)),
                  p.at("gravity"));
  contest.error = [scene = contest.scene](double, States states) {
    std::vector<State> start;
    for (const Body& body : scene.bodies)
      start.push_back({body.position, body.orientation, body.velocity, {}});
    const double before = energy(scene, start);
    return std::abs(energy(scene, states) - before) / before;
  };
  return contest;
}

Contest ramp(const PeerSetup& setup) {
  const Parameters& p = setup.parameters;
  const double angle = p.at("angle"), mu = p.at("friction"), g = p.at("gravity");
  const glm::dvec2 along(std::cos(angle), -std::sin(angle));
  const Body block{
      .solid = {.half_extents = {0.3, 0.075, 0.3}}, .mass = 1, .friction = mu};
  const std::vector<Body> blocks = bodies_of(setup, block);
  Body slope = floor(mu, 0);
  slope.orientation = blocks.front().orientation;
  slope.position = slope.orientation * slope.position;
  Contest contest = with_bodies({slope}, blocks, g);
  const glm::dvec2 v0 =
      p.at("speed")
      * glm::dvec2(std::cos(p.at("direction")), std::sin(p.at("direction")));
  contest.error = [=](double t, States states) {
    const glm::dvec3 x = states.back().position;
    const glm::dvec2 way(glm::dot(glm::dvec2(x), along), x.z);
    return glm::distance(way, exact::across_incline({angle, mu, mu, g}, v0, t).x);
  };
  return contest;
}

// The closed form has z upwards. A start with a spin is left out
Contest slide_to_roll(const PeerSetup& setup) {
  const Parameters& p = setup.parameters;
  const double mu = p.at("friction"), radius = p.at("radius"), g = p.at("gravity");
  Contest contest =
      with_bodies({floor(mu, 0)}, bodies_of(setup, ball(1, radius, mu, 0)), g);
  const exact::Ball like{.mass = 1, .radius = radius, .k = 0.4, .mu = mu, .g = g};
  const exact::BallMotion start{{}, {p.at("speed"), 0, 0}, {}};
  contest.error = [=](double t, States states) {
    const glm::dvec3 v = exact::slide_then_roll(like, start, t).v;
    return glm::distance(states.back().velocity, glm::dvec3(v.x, v.z, -v.y));
  };
  return contest;
}

// Boxes of one size that ought to stay: how far any moves aside
Contest standing(const PeerSetup& setup) {
  const Parameters& p = setup.parameters;
  const double size = p.at("size"), mu = p.at("friction");
  const Body box{.solid = {.half_extents = glm::dvec3(size / 2)},
                 .mass = size * size * size,
                 .friction = mu};
  Contest contest = with_bodies({floor(mu, 0)}, bodies_of(setup, box), p.at("gravity"));
  contest.error = [scene = contest.scene, size](double, States states) {
    double drift = 0;
    for (std::size_t i = 1; i < states.size(); ++i) {
      const glm::dvec3 way = states[i].position - scene.bodies[i].position;
      drift = std::max(drift, std::hypot(way.x, way.z));
    }
    return drift / size;
  };
  return contest;
}

// Nothing for a problem that the libraries do not get
std::optional<Contest> contest_of(const PeerSetup& setup) {
  const Problem& problem = *setup.problem;
  const auto is = [&](const char* scene, const char* metric) {
    return problem.scene == scene && problem.metric == metric;
  };
  if (is("bounce", "height_error_max")) return bounce(setup);
  if (is("elastic-gas", "energy_error_max")) return elastic_gas(setup);
  if (is("ramp", "way_error_max")) return ramp(setup);
  if (is("slide-to-roll", "velocity_error_max")) return slide_to_roll(setup);
  for (const char* scene : {"stack", "pyramid"})
    if (is(scene, "drift_max")) return standing(setup);
  return std::nullopt;
}

class WorldPeer : public PeerRun {
 public:
  WorldPeer(const Engine& engine, Contest contest, const PeerSetup& setup)
      : contest_(std::move(contest)),
        dt_(setup.dt),
        simulation_(engine.make(contest_.scene,
                                {.dt = setup.dt, .iterations = setup.iterations})) {}

  void step() override {
    simulation_.step();
    ++steps_;
  }
  void observe() override {
    const std::vector<State> states = simulation_.states();
    const bool is_finite = std::ranges::all_of(states, [](const State& state) {
      return std::isfinite(glm::length(state.position) + glm::length(state.velocity));
    });
    const double now = contest_.error(static_cast<double>(steps_) * dt_, states);
    error_ = is_finite ? std::max(error_, now) : k_no_number;
  }
  double error() const override { return error_; }
  long long evaluations() const override { return 0; }
  long long bodies() const override {
    return std::ranges::count_if(contest_.scene.bodies,
                                 [](const Body& body) { return body.mass > 0; });
  }

 private:
  Contest contest_;
  double dt_;
  world_bench::Simulation simulation_;
  long long steps_ = 0;
  double error_ = 0;
};

std::vector<Peer> peers_of(const std::vector<Engine>& engines) {
  std::vector<Peer> all;
  for (const Engine& engine : engines) {
    const std::size_t slash = engine.name.find('/');
    std::string name = engine.name.substr(0, slash);
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    all.push_back(
        {.method = name,
         .precision = engine.name.substr(slash + 1),
         .iterates = true,
         .start = [engine](const PeerSetup& setup) -> std::unique_ptr<PeerRun> {
           std::optional<Contest> contest = contest_of(setup);
           if (!contest) return nullptr;
           return std::make_unique<WorldPeer>(engine, std::move(*contest), setup);
         }});
  }
  return all;
}

bool is_own(const Engine& engine) {
  return !engine.name.starts_with("Bullet") && !engine.name.starts_with("ODE");
}

}  // namespace

// ODE's slow stepper explodes under pyramids, and is left out
std::vector<Peer> peers_of_worlds() {
  std::vector<Engine> engines = world_bench::engines();
  std::erase_if(engines, [](const Engine& engine) {
    return is_own(engine) || engine.name.starts_with("ODE_world");
  });
  return peers_of(engines);
}

std::vector<Peer> own_worlds() {
  std::vector<Engine> engines = world_bench::engines();
  std::erase_if(engines, [](const Engine& engine) { return !is_own(engine); });
  return peers_of(engines);
}

}  // namespace timestep::study
