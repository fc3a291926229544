// What a sample of a run holds: the state functions that the observables are made of.
#pragma once

#include "step.hpp"

namespace plategait {

template <class R>
PLATEGAIT_HD void record_joints(const State<R>& s, const Topology& topology, const R* parameter, R* channel) {
  const R zero = number<R>(0), half = number<R>(0.5);
  const R pitch = parameter[PITCH], k_b = parameter[BENDING_STIFFNESS];
  const R k_c = parameter[AXIAL_STIFFNESS], k_diagonal = diagonal_stiffness(parameter);
  R axial = zero, bending = zero;
  int n_bends = 0;
  for (int i = 0; i < topology.n_lines; i++) {
    const bool bends = i < topology.n_axial_lines;
    const R rest = bends ? pitch : number<R>(1.4142135623730951) * pitch, stiffness = bends ? k_c : k_diagonal;
    Edge<R> before = {};
    for (int j = topology.line_start[i]; j + 1 < topology.line_start[i + 1]; j++) {
      const int a = topology.line_nodes[j], b = topology.line_nodes[j + 1];
      const Edge<R> edge = edge_between(s.x.get(a), s.v.get(a), s.x.get(b), s.v.get(b));
      const R stretch = dot(edge.along, edge.along) * edge.inverse_length - rest;
      // The tension per unit of edge is k (1 − L0/L): k counts per metre of stretch.
      axial += half * stiffness * stretch * stretch;
      if (bends && j > topology.line_start[i]) {
        bending += bending_energy(before, edge, number<R>(1));
        n_bends++;
      }
      before = edge;
    }
  }
  const R inverse_pitch = number<R>(1) / pitch;
  R twist = zero;
  Vec3<R> area = {zero, zero, zero};
  for (int c = 0; c < topology.n_cells; c++) {
    const int* k = topology.cells + 4 * c;
    const Vec3<R> x0 = s.x.get(k[0]), x1 = s.x.get(k[1]), x2 = s.x.get(k[2]), x3 = s.x.get(k[3]);
    area = area + half * cross(x3 - x0, x2 - x1);
    twist += torsion_energy((x0 - x1) - (x2 - x3), inverse_pitch, parameter[TORSION_STIFFNESS]);
  }
  const R per_area =
      topology.n_cells ? inverse_pitch * inverse_pitch * number<R>(1.0 / (topology.n_cells + 1e-30)) : zero;
  channel[AREA_X] = per_area * area.x;
  channel[AREA_Y] = per_area * area.y;
  channel[AREA_Z] = per_area * area.z;
  channel[AXIAL_ENERGY] = axial;
  channel[BENDING_ENERGY] = k_b * bending;
  channel[TORSION_ENERGY] = twist;
  const R mean_square = number<R>(n_bends ? 2.0 / n_bends : 0.0) * bending;
  channel[BEND_RMS] = mean_square * reciprocal_sqrt(mean_square + number<R>(1e-30));
}

template <class R>
PLATEGAIT_HD void record_nodes(const State<R>& s, const Topology& topology, const R* parameter,
                               const PlatePose<R>& plate, R* channel) {
  const R zero = number<R>(0), half = number<R>(0.5), mass = parameter[NODE_MASS], pitch = parameter[PITCH];
  Vec3<R> sum = {zero, zero, zero};
  R spin_cross = zero, spin_dot = zero, kinetic = zero, height = zero, stored = zero;
  R low = number<R>(1e30), high = number<R>(-1e30);
  for (int k = 0; k < topology.n_nodes; k++) {
    const Vec3<R> x = s.x.get(k), v = s.v.get(k), r = x - plate.origin;
    const Vec3<R> p = {dot(r, plate.ex), dot(r, plate.ey), dot(r, plate.normal)};
    const R X0 = number<R>(topology.rest[2 * k]) * pitch, Y0 = number<R>(topology.rest[2 * k + 1]) * pitch;
    sum = sum + p;
    spin_cross += X0 * p.y - Y0 * p.x;
    spin_dot += X0 * p.x + Y0 * p.y;
    kinetic += dot(v, v);
    height += x.z;
    low = smaller(low, p.z);
    high = larger(high, p.z);
    R reach = zero - p.z;
    if (topology.features.plate_edge) reach = reach_of(recall(s, k), reach);
    stored += contact_energy(larger(reach, zero), parameter[CONTACT_STIFFNESS]);
  }
  if (topology.features.plate_edge) stored += edge_energy(s, topology, parameter, plate);
  const R share = number<R>(1.0 / topology.n_nodes);
  channel[CENTRE_X] = share * sum.x;
  channel[CENTRE_Y] = share * sum.y;
  channel[CENTRE_Z] = share * sum.z;
  channel[SPIN_CROSS] = spin_cross;
  channel[SPIN_DOT] = spin_dot;
  channel[HEIGHT_LOW] = low;
  channel[HEIGHT_HIGH] = high;
  channel[KINETIC_ENERGY] = half * mass * kinetic;
  channel[GRAVITY_ENERGY] = mass * parameter[GRAVITY] * height;
  channel[CONTACT_ENERGY] = stored;
}

/// One sample: state functions now, tallies over the `steps` since the sample before (then cleared).
template <class R>
PLATEGAIT_HD void record_sample(const State<R>& s, const Topology& topology, const R* parameter,
                                const Trajectory<R>& trajectory, Wide<R> time, R steps, Tally<R>& tally, R* channel) {
  const PlateMotion<R> motion = move_plate(trajectory, time);
  const PlatePose<R> plate = plate_pose(motion, parameter[PLATE_HEIGHT]);
  record_joints(s, topology, parameter, channel);
  record_nodes(s, topology, parameter, plate, channel);
  const Vec3<R> area = {channel[AREA_X], channel[AREA_Y], channel[AREA_Z]};
  channel[AREA_X] = dot(area, plate.ex);
  channel[AREA_Y] = dot(area, plate.ey);
  channel[AREA_Z] = dot(area, plate.normal);
  const R share = number<R>(1) / steps;
  channel[TIME] = narrow_to(time, R());
  channel[LEFT_CONTACT] = share * tally.left;
  channel[RIGHT_CONTACT] = share * tally.right;
  channel[FLIGHT] = share * tally.none;
  channel[CONTACT] = share * tally.nodes * number<R>(1.0 / topology.n_nodes);
  channel[JOINT_LOSS] = tally.joint_loss;
  channel[CONTACT_WORK] = tally.contact_work;
  channel[FRICTION_LOSS] = tally.friction_loss;
  channel[PLATE_WORK] = tally.plate_work;
  for (int d = 0; d < DEGREES_OF_FREEDOM; d++) channel[PLATE_X + d] = narrow_to(motion.position[d], R());
}

}  // namespace plategait
