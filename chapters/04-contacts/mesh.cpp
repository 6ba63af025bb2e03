// A concave mesh as one hull, as its own convex parts, or cut into parts; a ball
// passes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "chapters/04-contacts/concave_mesh.hpp"
#include "chapters/04-contacts/parts.hpp"
#include "common/chapter/numbers.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/compound.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {
namespace {

class MeshRun : public Simulation {
 public:
  explicit MeshRun(const Setup& setup);

  void step() override;
  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return evaluations_; }
  long long body_count() const override { return 1; }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;
  CameraPose camera(const CameraPose& usual) const override;

 private:
  double parameter(const char* name) const { return setup_.parameters.at(name); }
  double size() const;
  double radius() const { return parameter("radius") * size(); }
  glm::dvec3 place() const;
  void ask();
  float scale() const { return static_cast<float>(1 / size()); }
  float apart() const {
    return 0.45F + 2 * scale() * static_cast<float>(mesh_.half_extents.x);
  }
  glm::vec3 middle() const;
  glm::vec3 in_picture(const Vec3& p) const { return middle() + scale() * picture(p); }

  Setup setup_;
  ConcaveMesh mesh_;
  std::vector<ConvexHull> parts_;
  std::vector<CompoundPart> compound_;  ///< of these
  std::vector<std::shared_ptr<const MeshData>> part_meshes_;
  double parts_volume_ = 0, hull_volume_ = 0;

  std::vector<PartContact> contacts_;
  double distance_ = 0, mesh_distance_ = 0, early_ = 0;
  long long contact_steps_ = 0, mesh_contact_steps_ = 0, false_contacts_ = 0,
            missed_contacts_ = 0;
  long long steps_ = 0, evaluations_ = 0;
};

std::vector<ConvexHull> parts_of(const ConcaveMesh& mesh, const Setup& setup) {
  if (setup.method == "authored") return hulls_of_pieces(mesh);
  DecompositionSettings settings;
  settings.parts =
      setup.method == "hull" ? 1 : static_cast<int>(setup.parameters.at("parts"));
  settings.cuts_per_axis = static_cast<int>(setup.parameters.at("cuts"));
  settings.least_gain = Real(setup.parameters.at("gain"));
  return decompose(mesh.vertices, mesh.triangles, settings).parts;
}

// A hull's faces a little outside of it, as the mesh may have the same
std::shared_ptr<const MeshData> shell(const ConvexHull& hull, double outside) {
  MeshData mesh = *hull_mesh(hull);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.positions[i] += static_cast<float>(outside) * mesh.normals[i];
  return std::make_shared<const MeshData>(std::move(mesh));
}

MeshRun::MeshRun(const Setup& setup)
    : setup_(setup),
      mesh_(load_concave(setup.mesh.empty() ? "bunny.obj" : setup.mesh)),
      parts_(parts_of(mesh_, setup)) {
  for (const ConvexHull& part : parts_) {
    compound_.push_back({hull_shape(part)});
    part_meshes_.push_back(shell(part, size() / 400));
    parts_volume_ += static_cast<double>(part.volume);
  }
  hull_volume_ = static_cast<double>(convex_hull(mesh_.vertices).hull.volume);
  ask();
}

double MeshRun::size() const {
  const glm::dvec3 h(mesh_.half_extents);
  return 2 * std::max({h.x, h.y, h.z});
}

// Along x through the whole mesh, at a height and depth given in its half extents
glm::dvec3 MeshRun::place() const {
  const double share =
      std::min(static_cast<double>(steps_) * setup_.dt / setup_.duration, 1.0);
  const glm::dvec3 h(mesh_.half_extents);
  const double end = h.x + 2 * radius();
  return {end * (2 * share - 1), parameter("height") * h.y, parameter("depth") * h.z};
}

// (4.30)
void MeshRun::ask() {
  const Pose at{Vec3(place()), {1, 0, 0, 0}};
  const CompoundPart ball{Sphere{Real(radius())}};
  const Separation nearest = separation(compound_, {}, {&ball, 1}, at).separation;
  distance_ = static_cast<double>(nearest.distance);
  evaluations_ += nearest.iterations;
  contacts_.resize(compound_.size());
  contacts_.resize(contact_manifolds(compound_, {}, {&ball, 1}, at, 0, contacts_));
}

void MeshRun::step() {
  ++steps_;
  ask();
}

void MeshRun::observe() {
  mesh_distance_ = distance_to_mesh(mesh_, Vec3(place())) - radius();
  const bool touches = mesh_distance_ <= 0, says = !contacts_.empty();
  contact_steps_ += says ? 1 : 0;
  mesh_contact_steps_ += touches ? 1 : 0;
  false_contacts_ += says && !touches ? 1 : 0;

  // Beside the mesh by less than rounding is neither missed nor found
  const double sure = 64 * double(std::numeric_limits<Real>::epsilon()) * size();
  missed_contacts_ += !says && mesh_distance_ < -sure ? 1 : 0;
  if (!touches) early_ = std::max(early_, mesh_distance_ - distance_);
}

std::vector<BodyState> MeshRun::bodies() const {
  return {{.name = "mesh", .orientation = glm::dquat(1, 0, 0, 0)},
          {.name = "ball", .position = place()}};
}

std::vector<Metric> MeshRun::metrics() const {
  std::size_t vertices = 0, faces = 0;
  for (const ConvexHull& part : parts_) {
    vertices += part.vertices.size();
    faces += part.planes.size();
  }
  const double volume = static_cast<double>(mesh_.volume);
  return {{"distance", "m", distance_},
          {"distance_mesh", "m", mesh_distance_},
          {"parts", "", static_cast<double>(parts_.size())},
          {"vertices", "", static_cast<double>(vertices)},
          {"faces", "", static_cast<double>(faces)},
          {"mesh_volume", "m³", volume},
          {"hull_volume", "m³", hull_volume_},
          {"parts_volume", "m³", parts_volume_},
          {"excess", "", parts_volume_ / volume - 1},
          {"early_max", "m", early_},
          {"contact_steps", "", static_cast<double>(contact_steps_)},
          {"mesh_contact_steps", "", static_cast<double>(mesh_contact_steps_)},
          {"false_contacts", "", static_cast<double>(false_contacts_)},
          {"missed_contacts", "", static_cast<double>(missed_contacts_)},
          {"contact_points", "", static_cast<double>(contacts_.size())},
          {"support_points", "", static_cast<double>(evaluations_)}};
}

// Methods stand side by side; a mesh is 1 m long in the picture, whatever its size
glm::vec3 MeshRun::middle() const {
  const double lane = static_cast<double>(setup_.lane);
  const double last = static_cast<double>(setup_.lanes - 1);
  return {apart() * static_cast<float>(lane - last / 2), 0, 0};
}

void MeshRun::draw(DrawList& list) const {
  const glm::mat4 place_of_mesh = placed(middle(), {1, 0, 0, 0}, scale());
  list.meshes.push_back({mesh_.shown, place_of_mesh, k_body});
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Color color = parts_.size() == 1 ? setup_.style.color
                                           : method_style(static_cast<int>(i)).color;
    list.meshes.push_back({part_meshes_[i], place_of_mesh, with_alpha(color, 0.45F)});
    if (parts_.size() > 1 || parts_[i].vertices.size() < 100)
      draw_edges(list, parts_[i], place_of_mesh, with_alpha(k_ink, 0.35F));
  }
  const glm::vec3 ball = in_picture(Vec3(place()));
  list.balls.push_back({ball, scale() * static_cast<float>(radius()),
                        contacts_.empty() ? k_color_b : k_force});
  for (const auto& [_, contact] : contacts_) {
    const glm::vec3 a = in_picture(on_a(contact, contact.points[0]));
    list.arrows.push_back({.from = a,
                           .to = a + 0.25F * picture(contact.normal),
                           .color = k_normal,
                           .width = 4});
  }
  list.labels.push_back(
      {middle() + glm::vec3(-0.25F, -0.72F, 0),
       fmt::format("{} part{}, {} x volume", parts_.size(),
                   parts_.size() == 1 ? "" : "s",
                   short_text(parts_volume_ / static_cast<double>(mesh_.volume))),
       k_ink});
}

void MeshRun::draw_reference(DrawList& list) const {
  list.ground_height.reset();
}

CameraPose MeshRun::camera(const CameraPose& usual) const {
  CameraPose pose = usual;
  pose.distance = 1 + apart() * static_cast<float>(setup_.lanes);
  return pose;
}

}  // namespace

Scene mesh_scene() {
  return {
      .name = "mesh",
      .summary =
          "a concave mesh, or your own: its hull, or convex parts; a ball passes",
      .methods = {{"hull", "the hull of the whole mesh", method_style(0)},
                  {"authored", "the hull of each connected piece of the file",
                   method_style(1)},
                  {"decomposition", "the mesh cut into parts along the axes",
                   method_style(2)}},
      .default_methods = {"hull", "decomposition"},
      .parameters =
          {{"radius", "", "of the ball, in lengths of the mesh", 0.07, 1e-3, 10},
           {"height", "", "of its path, in half heights of the mesh", 0.4, -3, 3},
           {"depth", "", "towards the viewer, in half depths of the mesh", 0, -3, 3},
           {"parts", "", "of the decomposition, at most", 16, 1, 64, true},
           {"cuts", "", "across each axis of a part that are tried", 7, 1, 31, true},
           {"gain", "", "that a cut must save, in volumes of the hull", 0.01, 0, 1}},
      .takes_mesh = true,
      .dt = 1.0 / 60,
      .duration = 3,
      .camera = {.target = {0, -0.1F, 0}, .distance = 4, .yaw = 0.15F, .pitch = 0.2F},
      .chart_metric = "distance",
      .start = [](const Setup& setup) { return std::make_unique<MeshRun>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
