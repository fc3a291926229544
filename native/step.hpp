// One time step of one run (or of a pack of runs side by side), as named phases.
//
//   1. move the plate        (4.1), (4.2), or any Fourier series or sampled trajectory
//   2. pull the joints       along the lattice's straight lines, then its cells
//   3. meet the plate        gravity, contact (3.1), friction (3.2), at its edge and on it; new velocity, new position
//
// Semi-implicit Euler: positions are those of the step's time, velocities those of half a step before and after. The
// contact and the axial dampers are linearly implicit.
#pragma once

#include "edge.hpp"

namespace plategait {

/// A node beside the plate: where it is from the plate's origin, what moves it, the plate there, and what they do to
/// each other.
template <class R>
struct Met {
  Vec3<R> r;
  Point<R> point;
  Ground<R> ground;
  Touch<R> touch;
};

template <class R>
PLATEGAIT_HD Met<R> meet_node(const State<R>& s, const Topology& topology, const R* parameter,
                              const Surface<R>& surface, const PlatePose<R>& plate, const PlatePose<R>& next, int k) {
  const R zero = number<R>(0), one = number<R>(1), inverse_mass = one / parameter[NODE_MASS];
  const Vec3<R> r = s.x.get(k) - plate.origin;
  Vec3<R> pull = inverse_mass * s.f.get(k);
  pull.z = pull.z - parameter[GRAVITY];
  const Point<R> point = {s.v.get(k), pull, inverse_mass};
  const Ground<R> ground = ground_at(plate, next, r);
  R reach = zero - dot(r, plate.normal);
  if (topology.features.plate_edge) reach = reach_of(recall(s, k), reach);
  return {r, point, ground, touch_plate(surface, topology.features, point, ground, reach, one)};
}

template <class R>
PLATEGAIT_HD void meet_plate(const State<R>& s, const Topology& topology, const R* parameter, const PlatePose<R>& plate,
                             const PlatePose<R>& next, Tally<R>& tally) {
  const R zero = number<R>(0), one = number<R>(1);
  const Surface<R> surface = surface_of(parameter);
  const R dt = parameter[TIME_STEP], inverse_mass = one / parameter[NODE_MASS];
  R left = zero, right = zero, touching = zero, sum_y = zero;
  const bool held = topology.features.plate_edge && see_edge(s, topology, parameter, plate);
  if (held) meet_edge(s, topology, parameter, surface, plate, next, tally, left, right);
  Tally<R> work{};
  for (int k = 0; k < topology.n_nodes; k++) {
    const Met<R> met = meet_node(s, topology, parameter, surface, plate, next, k);
    const Vec3<R> r = met.r, pull = met.point.acceleration;
    const Point<R>& point = met.point;
    const Ground<R>& ground = met.ground;
    const Touch<R>& touch = met.touch;
    const Vec3<R> from_plate = touch.normal * plate.normal - touch.drag;
    const R mobility = number<R>(topology.mobility[k]);
    const Vec3<R> v_new = point.velocity + (mobility * dt) * (pull + inverse_mass * from_plate);
    s.v.set(k, v_new);
    s.x.add(k, (mobility * dt) * v_new);

    const R across = dot(r, plate.ey), touches = select(touch.normal > zero, one, zero);
    const Mask<R> on_left = across > tally.centre_y;
    left = larger(left, select(on_left, touches, zero));
    right = larger(right, select(on_left, zero, touches));
    touching += touches;
    sum_y += across;
    tally_touch(touch, point, ground, dt, work);
    if (held) work.contact_work -= work_by_later(s, k, from_plate, dt, inverse_mass);
  }
  tally.left += left;
  tally.right += right;
  tally.none += one - larger(left, right);
  tally.nodes += touching;
  tally.centre_y = sum_y * number<R>(1.0 / topology.n_nodes);
  tally.contact_work += work.contact_work;
  tally.friction_loss += work.friction_loss;
  tally.plate_work += work.plate_work;
}

/// Before the first step: what the edge remembers of a sheet that was laid there.
template <class R>
PLATEGAIT_HD void lay_down(const State<R>& state, const Topology& topology, const R* parameter,
                           const Trajectory<R>& trajectory) {
  if (!topology.features.plate_edge) return;
  const PlatePose<R> plate = plate_pose(move_plate(trajectory, number<Wide<R>>(0)), parameter[PLATE_HEIGHT]);
  if (see_edge(state, topology, parameter, plate)) lay_across_edge(state, topology, parameter, plate);
}

template <class R>
PLATEGAIT_HD void advance_one_step(const State<R>& state, const Topology& topology, const R* parameter,
                                   const Trajectory<R>& trajectory, Wide<R> time, Tally<R>& tally) {
  const R height = parameter[PLATE_HEIGHT];
  const Wide<R> next = time + number<Wide<R>>(0.5) * widen(parameter[TIME_STEP]);
  pull_joints(state, topology, parameter, tally);
  meet_plate(state, topology, parameter, plate_pose(move_plate(trajectory, time), height),
             plate_pose(move_plate(trajectory, next), height), tally);
}

}  // namespace plategait
