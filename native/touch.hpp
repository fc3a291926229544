// What a point of the sheet that touches the plate gets from it: contact (3.1) and friction (3.2) over one step.
#pragma once

#include "plate.hpp"
#include "sheet.hpp"

namespace plategait {

/// Laws of one run's contact and friction, ready for use.
template <class R>
struct Surface {
  R time_step, stiffness, damping, ramp, inverse_ramp;
  R mu_s, mu_k, inverse_mu_k, V, inverse_rise, inverse_fall;
  Mask<R> smooth;
};

template <class R>
PLATEGAIT_HD Surface<R> surface_of(const R* parameter) {
  const R one = number<R>(1), ramp = parameter[CONTACT_RAMP], V = parameter[STATIC_SPEED];
  return {parameter[TIME_STEP],
          parameter[CONTACT_STIFFNESS],
          parameter[CONTACT_DAMPING],
          ramp,
          one / larger(ramp, number<R>(1e-12)),
          parameter[STATIC_FRICTION],
          parameter[KINETIC_FRICTION],
          one / larger(parameter[KINETIC_FRICTION], number<R>(1e-20)),
          V,
          one / V,
          one / (parameter[KINETIC_SPEED] - V),
          parameter[SMOOTH_FRICTION] > number<R>(0.5)};
}

/// A point of the sheet beside the plate, with what moves it over the step but for the plate.
template <class R>
struct Point {
  Vec3<R> velocity;      // m/s
  Vec3<R> acceleration;  // by all other forces, m/s^2
  R inverse_mass;        // that a force at the point feels, 1/kg
};

/// The plate where a point is: its velocity at the step's middle, where forces act, and at its end, half a step later.
template <class R>
struct Ground {
  Vec3<R> normal, now, next;
};

template <class R>
PLATEGAIT_HD Ground<R> ground_at(const PlatePose<R>& plate, const PlatePose<R>& next, Vec3<R> r) {
  return {plate.normal, plate.velocity + cross(plate.turning, r), next.velocity + cross(next.turning, r)};
}

template <class R>
struct Touch {
  R normal;      // N
  Vec3<R> drag;  // against the slip, N
};

/// Force of the plate on a point `reach` below where it starts to touch, with `share` of a node's contact.
///
/// Velocities are known half a step before the forces act and wanted half a step after: so the slip that friction acts
/// against is the one midway, and what it may stop is the slip at the end.
template <class R>
PLATEGAIT_HD Touch<R> touch_plate(const Surface<R>& surface, const Features& features, const Point<R>& point,
                                  const Ground<R>& ground, R reach, R share) {
  const R zero = number<R>(0), half = number<R>(0.5), dt = surface.time_step;
  R damping = surface.damping;
  if (features.contact_ramp)
    damping = select(surface.ramp > zero, contact_damping(larger(reach, zero), damping, surface.inverse_ramp), damping);
  const Vec3<R> u = point.velocity - ground.next;
  const R force = normal_force(reach, dot(u, ground.normal), dot(point.acceleration, ground.normal), point.inverse_mass,
                               dt, share * surface.stiffness, share * damping);

  const Vec3<R> end = u + dt * point.acceleration;
  const Vec3<R> mid = point.velocity - ground.now + (half * dt) * point.acceleration;
  const Vec3<R> end_slip = end - dot(end, ground.normal) * ground.normal;
  const Vec3<R> mid_slip = mid - dot(mid, ground.normal) * ground.normal;
  const R end_squared = dot(end_slip, end_slip), mid_squared = dot(mid_slip, mid_slip) + number<R>(1e-20);
  const R inverse_speed = reciprocal_sqrt(mid_squared), speed = mid_squared * inverse_speed;
  const R impulse = dt * point.inverse_mass * force;
  R lost = slip_lost(speed, impulse, surface.mu_s, surface.mu_k, surface.inverse_mu_k, surface.V);
  if (features.smooth_friction) {
    const R mu = smooth_friction_coefficient(speed, surface.mu_s, surface.mu_k, surface.V, surface.inverse_rise,
                                             surface.inverse_fall);
    lost = select(surface.smooth, mu * impulse, lost);
  }
  const R per_speed = number<R>(1) / (dt * point.inverse_mass);
  const Mask<R> stops = lost * lost > end_squared;
  // Where the slip turns within the step, no more than turns it round: friction never drives.
  const R turned = smaller(lost, number<R>(2) * speed);
  const R along_end = select(stops, per_speed, zero);
  const R along_mid = select(stops, zero, per_speed * turned * inverse_speed);
  return {force, along_end * end_slip + along_mid * mid_slip};
}

/// Work of a touch over the step, J, by the velocity midway that it leads to.
template <class R>
PLATEGAIT_HD void tally_touch(const Touch<R>& touch, const Point<R>& point, const Ground<R>& ground, R dt,
                              Tally<R>& tally) {
  const Vec3<R> force = touch.normal * ground.normal - touch.drag;
  const Vec3<R> u =
      point.velocity + (number<R>(0.5) * dt) * (point.acceleration + point.inverse_mass * force) - ground.now;
  tally.contact_work -= dt * touch.normal * dot(u, ground.normal);
  tally.friction_loss += dt * dot(touch.drag, u);
  tally.plate_work += dt * dot(force, ground.now);
}

}  // namespace plategait
