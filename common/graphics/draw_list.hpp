/// @file
/// What there is to see, as plain data: no OpenGL, no files, no physics. A scene fills
/// a draw list, a renderer shows it; another viewer could take the same list. Positions
/// and sizes in metres, world frame, y up; colours are sRGB with alpha, 0 to 1; widths
/// and marker sizes in pixels of a picture 720 pixels high, scaled with it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "common/graphics/mesh_data.hpp"

namespace timestep {

using Color = glm::vec4;

enum class MarkerShape { circle, square, triangle, diamond, cross, plus, star, ring };
enum class Dash { solid, dashed, dotted };

/// How one method looks in every picture and plot: told apart by shape and by colour.
struct Style {
  Color color{0.5F, 0.5F, 0.5F, 1};
  MarkerShape marker = MarkerShape::circle;
  Dash dash = Dash::solid;
};

/// Unit shapes, centred on the origin: sphere of radius 1, box from -1 to 1, cylinder
/// and cone of radius 1 along y from -1 to 1 (the cone's tip at +1).
enum class ShapeKind { sphere, box, cylinder, cone };

/// A unit shape at a transform.
struct ShapeInstance {
  ShapeKind kind = ShapeKind::sphere;
  glm::mat4 world_from_shape{1};
  Color color{0.8F, 0.8F, 0.8F, 1};
};

/// A triangle mesh at a transform. The data is shared, never copied.
struct MeshInstance {
  std::shared_ptr<const MeshData> mesh;
  glm::mat4 world_from_mesh{1};
  Color color{0.8F, 0.8F, 0.8F, 1};
};

/// One of very many balls, drawn instanced.
struct Ball {
  glm::vec3 center{0};
  float radius = 1;
  Color color{0.8F, 0.8F, 0.8F, 1};
};

/// A line through points; `fade` lets its old end (the first point) fade out, as a
/// trail.
struct Polyline {
  std::vector<glm::vec3> points;
  Color color{0, 0, 0, 1};
  float width = 2;
  Dash dash = Dash::solid;
  bool fade = false;
};

struct Arrow {
  glm::vec3 from{0}, to{0};
  Color color{0, 0, 0, 1};
  float width = 4;
};

/// A flat symbol that always faces the viewer.
struct Marker {
  glm::vec3 position{0};
  Style style;
  float size = 12;
};

/// A word at a place in the scene; drawn beside the point, always readable.
struct Label {
  glm::vec3 position{0};
  std::string text;
  Color color{0, 0, 0, 1};
};

/// One line of the legend: the style's line and marker, then the text.
struct LegendEntry {
  Style style;
  std::string text;
};

struct ChartSeries {
  std::string name;
  Style style;
  std::vector<glm::dvec2> points;
};

enum class Side { left, right };

/// A small graph in a lower corner of the picture.
struct Chart {
  std::string title, x_label, y_label;
  bool logarithmic_y = false;
  std::vector<ChartSeries> series;
};

/// A look from a point on a sphere around a target; angles in radians.
struct CameraPose {
  glm::vec3 target{0, 1, 0};
  float distance = 8;
  float yaw = 0;              ///< about +y; 0 looks along -z, with +x to the right
  float pitch = 0.25F;        ///< above the horizon
  float vertical_fov = 0.7F;  ///< full angle

  bool operator==(const CameraPose&) const = default;
};

struct DrawList {
  std::string title;                 ///< top left, large
  std::vector<std::string> caption;  ///< below the title, small
  std::vector<ShapeInstance> shapes;
  std::vector<MeshInstance> meshes;
  std::vector<Ball> balls;
  std::vector<Polyline> lines;
  std::vector<Arrow> arrows;
  std::vector<Marker> markers;
  std::vector<Label> labels;
  std::vector<LegendEntry> legend;
  std::vector<Chart> charts;
  Side chart_side = Side::right;              ///< of the picture's lower edge
  std::optional<float> ground_height = 0.0F;  ///< the grid's plane; none if empty
};

}  // namespace timestep
