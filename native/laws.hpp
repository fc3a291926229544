// The laws of the sheet: one function per law, on numbers of any kind (see scalar.hpp, lanes.hpp).
// SI units throughout, except where (3.1) counts depth in millimetres.
#pragma once

#include "scalar.hpp"

namespace plategait {

template <class R>
struct Vec3 {
  R x, y, z;
  PLATEGAIT_HD friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  PLATEGAIT_HD friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  PLATEGAIT_HD friend Vec3 operator*(R s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class R>
PLATEGAIT_HD R dot(Vec3<R> a, Vec3<R> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class R>
PLATEGAIT_HD Vec3<R> cross(Vec3<R> a, Vec3<R> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Number constant of the element type of R.
template <class R>
PLATEGAIT_HD R number(double value) {
  return R(static_cast<Element<R>>(value));
}

// ---------------------------------------------------------------------------------------------- joints

/// A straight piece of the lattice between two neighbouring nodes.
template <class R>
struct Edge {
  Vec3<R> along;                     // from the first node to the second, m
  Vec3<R> rate;                      // d(along)/dt, m/s
  R squared_length, inverse_length;  // m^2, 1/m
};

template <class R>
PLATEGAIT_HD Edge<R> edge_between(Vec3<R> x0, Vec3<R> v0, Vec3<R> x1, Vec3<R> v1) {
  const Vec3<R> along = x1 - x0;
  const R squared = dot(along, along);
  return {along, v1 - v0, squared, reciprocal_sqrt(squared)};
}

/// Angular velocity of an edge (no spin about itself), rad/s.
template <class R>
PLATEGAIT_HD Vec3<R> turning_rate(Edge<R> e) {
  return (e.inverse_length * e.inverse_length) * cross(e.along, e.rate);
}

/// Coefficient of an axial damper that is linearly implicit over the step for its own pair of nodes, N s/m.
///
/// Its force is then that of the rate at which the pair ends the step, were no other joint there.
template <class R>
PLATEGAIT_HD R implicit_damping(R c_c, R step_over_mass) {
  return c_c / (number<R>(1) + number<R>(2) * step_over_mass * c_c);
}

/// Axial Kelvin–Voigt joint (section 3.2.2): tension per unit of `along`, N/m. Adds the power it dissipates.
template <class R>
PLATEGAIT_HD R axial_tension(Edge<R> e, R rest_length, R k_c, R c_c, R& loss) {
  const R stretching = dot(e.rate, e.along) * e.inverse_length;
  const R damping = c_c * stretching;
  loss += damping * stretching;
  return k_c * (number<R>(1) - rest_length * e.inverse_length) + damping * e.inverse_length;
}

/// θ / (2 sin(θ/2)) from C = cos(θ/2) in [0, 1], i.e. acos(C)/√(1−C²).
///
/// Analytic on the whole range (its nearest singularity is C = −1), hence one short polynomial: Chebyshev
/// interpolation at degree 9, relative error 1.3e-8, so a joint may fold right over.
template <class R>
PLATEGAIT_HD R half_angle_ratio(R C) {
  const R d = number<R>(1) - C;
  R p = number<R>(0.0111628242261987703);
  p = p * d + number<R>(-0.0325916887339972212);
  p = p * d + number<R>(0.0509757584757763827);
  p = p * d + number<R>(-0.0335529977913274927);
  p = p * d + number<R>(0.0300591759709965667);
  p = p * d + number<R>(0.0201634898051668869);
  p = p * d + number<R>(0.0579778015137750395);
  p = p * d + number<R>(0.133266572255008853);
  p = p * d + number<R>(0.333335381433911068);
  return p * d + number<R>(0.999999989734687395);
}

/// Angle between two successive edges, through C = cos(θ/2).
template <class R>
struct BendAngle {
  R inverse_half_cosine;
  R ratio;  // θ / (2 sin(θ/2))
};

template <class R>
PLATEGAIT_HD BendAngle<R> bend_angle(Edge<R> first, Edge<R> second) {
  const R cosine = dot(first.along, second.along) * first.inverse_length * second.inverse_length;
  // Kept off θ = π, where the axis of the moment is not defined.
  const R C2 = larger(number<R>(0.5) + number<R>(0.5) * cosine, number<R>(1e-6));
  const R inverse = reciprocal_sqrt(C2);
  return {inverse, half_angle_ratio(smaller(C2 * inverse, number<R>(1)))};
}

/// Bending energy ½ k_b θ² of one joint, J. From the cross product, which small angles do not cancel in.
template <class R>
PLATEGAIT_HD R bending_energy(Edge<R> first, Edge<R> second, R k_b) {
  const BendAngle<R> a = bend_angle(first, second);
  const Vec3<R> sine = (first.inverse_length * second.inverse_length) * cross(first.along, second.along);
  const R angle_over_sine = a.ratio * a.inverse_half_cosine;
  return number<R>(0.5) * k_b * angle_over_sine * angle_over_sine * dot(sine, sine);
}

/// Bending Kelvin–Voigt joint (section 3.2.2): moment of the first edge on the second, against the angle and
/// its rate, true at large angles, N m. Adds the power it dissipates.
///
/// Both parts act about the joint's own axis, first × second, which is square to both edges: so the joint makes no
/// net moment, and a bent sheet that turns as a whole loses nothing.
template <class R>
PLATEGAIT_HD Vec3<R> bending_moment(Edge<R> first, Edge<R> second, Vec3<R> first_turning, Vec3<R> second_turning, R k_b,
                                    R c_b, R inverse_pitch, R& loss) {
  const BendAngle<R> a = bend_angle(first, second);
  const Vec3<R> sine = (first.inverse_length * second.inverse_length) * cross(first.along, second.along);
  // Rate of the angle, over sin θ. The floor is the square of an angle far below single precision's resolution.
  const R inverse_sine = reciprocal_sqrt(dot(sine, sine) + number<R>(1e-16));
  const R rate = dot(second_turning - first_turning, sine) * inverse_sine;
  // An edge that an impact has squeezed turns ever more easily, and an explicit damper would drive it: below half its
  // length the damper is held to what it does there.
  const R shorter = smaller(first.squared_length, second.squared_length);
  const R damping = c_b * rate * smaller(number<R>(4) * inverse_pitch * inverse_pitch * shorter, number<R>(1));
  loss += damping * rate;
  // θ/sin θ = ratio / cos(θ/2).
  return (k_b * a.ratio * a.inverse_half_cosine + damping * inverse_sine) * sine;
}

/// Force couple on the far end of an edge that carries the moment M against turning.
template <class R>
PLATEGAIT_HD Vec3<R> couple_force(Edge<R> e, Vec3<R> moment) {
  return (e.inverse_length * e.inverse_length) * cross(e.along, moment);
}

/// Torsion Kelvin–Voigt joints of one square cell, as the force on its first and fourth corner (the other two
/// take the opposite), N.
///
/// The warp s = x1 − x2 − x3 + x4 of a cell is twist × pitch, and its four edges share two joints' worth of
/// torsion, hence the energy ½ (2 k_t/l²) s². Central in s, so it carries no net force and no net moment.
template <class R>
PLATEGAIT_HD Vec3<R> torsion_force(Vec3<R> warp, Vec3<R> warp_rate, R inverse_pitch, R k_t, R c_t, R& loss) {
  const R scale = number<R>(2) * inverse_pitch * inverse_pitch;
  const R growth = dot(warp, warp_rate) / (dot(warp, warp) + number<R>(1e-20));
  const R damping = scale * c_t * growth;
  loss += damping * growth * dot(warp, warp);
  return (number<R>(0) - (scale * k_t + damping)) * warp;
}

template <class R>
PLATEGAIT_HD R torsion_energy(Vec3<R> warp, R inverse_pitch, R k_t) {
  return k_t * inverse_pitch * inverse_pitch * dot(warp, warp);
}

// --------------------------------------------------------------------------------------------- contact

/// Elastic part of the contact force (3.1), k a^2.2 with the depth a ≥ 0 in m and k in N/mm^2.2, and its slope.
template <class R>
struct ContactSpring {
  R force;      // N
  R stiffness;  // N/m
};

template <class R>
PLATEGAIT_HD ContactSpring<R> contact_spring(R depth, R k_contact) {
  const R mm = number<R>(1000) * depth;
  const R root = fifth_root(mm);
  return {k_contact * mm * mm * root, number<R>(2200) * k_contact * mm * root};
}

/// Energy stored at that depth, J.
template <class R>
PLATEGAIT_HD R contact_energy(R depth, R k_contact) {
  return contact_spring(depth, k_contact).force * depth * number<R>(1 / 3.2);
}

/// Contact damping that rises by a cubic step over a depth of 1/inverse_ramp, N s/m.
template <class R>
PLATEGAIT_HD R contact_damping(R depth, R c_contact, R inverse_ramp) {
  const R s = smaller(depth * inverse_ramp, number<R>(1));
  return c_contact * s * s * (number<R>(3) - number<R>(2) * s);
}

/// Normal force of (3.1), never adhesive, N: spring and damper taken linearly implicit over the step.
///
/// `separating` is the node's speed off the plate and `other` the acceleration that all other forces give it
/// that way. Solving with the speed at the end of the step is what lets the step be near 1e-4 s.
template <class R>
PLATEGAIT_HD R normal_force(R depth, R separating, R other, R inverse_mass, R time_step, R k_contact, R damping) {
  const R zero = number<R>(0);
  const ContactSpring<R> spring = contact_spring(larger(depth, zero), k_contact);
  const R resistance = damping + spring.stiffness * time_step;
  const R force = (spring.force - resistance * (separating + time_step * other)) /
                  (number<R>(1) + time_step * inverse_mass * resistance);
  return select(depth > zero, larger(force, zero), zero);
}

// -------------------------------------------------------------------------------------------- friction

/// Slip speed that friction by (3.2) takes away, m/s: μ_s below V, μ_k at V and above.
///
/// `impulse` is the normal one over the step, per mass. A landing's is large enough to carry the slip past V within
/// the step: what is left of the impulse then counts with μ_s.
template <class R>
PLATEGAIT_HD R slip_lost(R slip, R impulse, R mu_s, R mu_k, R inverse_mu_k, R V) {
  const R above = larger(slip - V, number<R>(0)), kinetic = mu_k * impulse;
  const R rest = larger(impulse - above * inverse_mu_k, number<R>(0));
  return select(kinetic < above, kinetic, above + mu_s * rest);
}

/// Smooth law of the source's solver: 0 → μ_s over V_s = 1/inverse_rise, μ_s → μ_k over V_d − V_s = 1/inverse_fall,
/// by cubic steps.
template <class R>
PLATEGAIT_HD R smooth_friction_coefficient(R slip, R mu_s, R mu_k, R V_s, R inverse_rise, R inverse_fall) {
  const R rise = smaller(slip * inverse_rise, number<R>(1));
  const R fall = smaller(larger((slip - V_s) * inverse_fall, number<R>(0)), number<R>(1));
  return mu_s * rise * rise * (number<R>(3) - number<R>(2) * rise) +
         (mu_k - mu_s) * fall * fall * (number<R>(3) - number<R>(2) * fall);
}

}  // namespace plategait
