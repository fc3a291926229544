// What a run shows of itself between two steps, for whoever draws it: what each node gets from the plate, and the plate
// from all of them.
#pragma once

#include "step.hpp"

namespace plategait {

/// Numbers of each node: the plate's push along its normal, N, and its friction along the plate's x and y, N.
constexpr int NODE_NUMBERS = 3;
/// Numbers of the plate: the sheet's force on it, N, and torque about the middle of its surface, N m, in its own frame.
constexpr int PLATE_NUMBERS = 6;

/// Forces of the step that comes next, from the laws that it would go by. Writes `s.f`, which every step writes anew.
template <class R>
PLATEGAIT_HD void show_forces(const State<R>& s, const Topology& topology, const R* parameter,
                              const Trajectory<R>& trajectory, Wide<R> time, R* nodes, R* plate_gets) {
  const R height = parameter[PLATE_HEIGHT];
  const Wide<R> middle = time + number<Wide<R>>(0.5) * widen(parameter[TIME_STEP]);
  const PlatePose<R> plate = plate_pose(move_plate(trajectory, time), height);
  const PlatePose<R> next = plate_pose(move_plate(trajectory, middle), height);
  const Surface<R> surface = surface_of(parameter);
  const R zero = number<R>(0);
  Tally<R> ignored{};
  pull_joints(s, topology, parameter, ignored);
  const bool held = topology.features.plate_edge && see_edge(s, topology, parameter, plate);
  if (held) {
    R left = zero, right = zero;
    meet_edge(s, topology, parameter, surface, plate, next, ignored, left, right);
  }
  Vec3<R> force = {zero, zero, zero}, torque = force;
  for (int k = 0; k < topology.n_nodes; k++) {
    const Met<R> met = meet_node(s, topology, parameter, surface, plate, next, k);
    Vec3<R> on_node = met.touch.normal * plate.normal - met.touch.drag;
    if (held) on_node = on_node + s.held.get(k);
    force = force - on_node;
    torque = torque - cross(met.r, on_node);
    nodes[NODE_NUMBERS * k] = met.touch.normal;
    nodes[NODE_NUMBERS * k + 1] = zero - dot(met.touch.drag, plate.ex);
    nodes[NODE_NUMBERS * k + 2] = zero - dot(met.touch.drag, plate.ey);
  }
  const Vec3<R> axes[] = {plate.ex, plate.ey, plate.normal};
  for (int d = 0; d < 3; d++) {
    plate_gets[d] = dot(force, axes[d]);
    plate_gets[3 + d] = dot(torque, axes[d]);
  }
}

}  // namespace plategait
