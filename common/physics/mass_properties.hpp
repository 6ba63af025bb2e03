/// @file
/// How mass is spread over a rigid body: its sum, its centre, and its inertia tensor.
/// Of primitive shapes, of bodies put together from parts, and along the principal
/// axes. Source: chapter 3.
#pragma once

#include <span>

#include "common/physics/quaternion.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (3.6), (3.7) In the frame in which the shape is given. Sizes are not negative; a
/// shape of negative mass is a hole, to be `combined` with what it is cut from.
struct MassProperties {
  Real mass;            ///< [kg]
  Vec3 centre_of_mass;  ///< [m]
  Mat3 inertia;         ///< about the centre of mass [kg m²]
};

// (3.8) Shapes of even density about the origin, their axis along z. Lengths in m.

MassProperties solid_box(Real mass, const Vec3& size);
MassProperties solid_sphere(Real mass, Real radius);
MassProperties spherical_shell(Real mass, Real radius);
MassProperties solid_ellipsoid(Real mass, const Vec3& semi_axes);
MassProperties solid_cylinder(Real mass, Real radius, Real height);
MassProperties hollow_cylinder(Real mass, Real inner, Real outer, Real height);

/// `height` is that of the cylinder between the two half balls.
MassProperties solid_capsule(Real mass, Real radius, Real height);

/// Its base is at z = 0, its tip at z = height.
MassProperties solid_cone(Real mass, Real radius, Real height);

/// `major` is the radius of the circle that the centre of the tube follows, `minor`
/// that of the tube.
MassProperties solid_torus(Real mass, Real major, Real minor);

MassProperties thin_rod(Real mass, Real length);

/// Over four vertices, wherever they are.
MassProperties solid_tetrahedron(Real mass, const Vec3& a, const Vec3& b, const Vec3& c,
                                 const Vec3& d);

// Volumes of the same shapes [m³]

Real box_volume(const Vec3& size);
Real sphere_volume(Real radius);
Real ellipsoid_volume(const Vec3& semi_axes);
Real cylinder_volume(Real radius, Real height);
Real hollow_cylinder_volume(Real inner, Real outer, Real height);
Real capsule_volume(Real radius, Real height);
Real cone_volume(Real radius, Real height);
Real torus_volume(Real major, Real minor);

/// Not negative, in whichever order the vertices come.
Real tetrahedron_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The same body turned about the origin, then shifted [m].
MassProperties moved(const MassProperties& body, const Quat& rotation,
                     const Vec3& translation);

/// (3.9) The inertia tensor about another point of the body's frame, along the same
/// axes.
Mat3 inertia_about(const MassProperties& body, const Vec3& point);

/// One body from parts that are given in one frame; their masses must not add up to 0.
MassProperties combined(std::span<const MassProperties> parts);

/// (3.11) I = A diag(moments) A^T.
struct PrincipalAxes {
  Vec3 moments;  ///< ascending [kg m²]
  Mat3 A;        ///< its columns are the axes, right-handed: takes vectors from them
};

/// By Jacobi's rotations, which need nothing of the tensor but symmetry: equal moments,
/// zeros and needles are no special cases. Moments are right to a few roundings of the
/// largest. Axes of equal moments are any that fit.
PrincipalAxes principal_axes(const Mat3& inertia);

/// Whether some body has this tensor: finite, symmetric, no moment negative, none above
/// the sum of the other two; each up to 16 roundings of the largest.
bool is_inertia(const Mat3& inertia);

}  // namespace timestep::inline TIMESTEP_PRECISION
