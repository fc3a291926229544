// The sheet as a run holds it: topology, state, tallies; and its joints, pulled along the lattice's straight lines.
#pragma once

#include "laws.hpp"
#include "parameters.hpp"

namespace plategait {

/// Phases that a batch may do without, because no run in it has what they are for. A lane that does not need a phase
/// gets the same bits with and without it.
struct Features {
  bool torsion, smooth_friction, plate_edge, contact_ramp;
};

/// The lattice's topology: the same for every run of a batch.
///
/// Lines are the maximal straight chains of neighbouring nodes; the first `n_axial_lines` run along the grid and
/// bend, the others run along its diagonals and carry the in-plane shear. Cells list corners 00, 10, 01, 11.
struct Topology {
  int n_nodes, n_lines, n_axial_lines, n_cells;
  const int* line_start;  // n_lines + 1
  const int* line_nodes;
  const int* cells;        // n_cells x 4
  const double* rest;      // n_nodes x 2, in pitches, about the centroid
  const double* mobility;  // n_nodes: 1 free, 0 held where it is
  Features features;
};

/// Node vectors of one pack, [node][axis].
template <class R>
struct Nodes {
  R* data;
  int stride;  // between successive numbers: 1 in a pack, the number of runs on a GPU
  PLATEGAIT_HD Vec3<R> get(int k) const {
    return {data[3 * k * stride], data[(3 * k + 1) * stride], data[(3 * k + 2) * stride]};
  }
  PLATEGAIT_HD void set(int k, Vec3<R> a) const {
    data[3 * k * stride] = a.x;
    data[(3 * k + 1) * stride] = a.y;
    data[(3 * k + 2) * stride] = a.z;
  }
  PLATEGAIT_HD void add(int k, Vec3<R> a) const { set(k, get(k) + a); }
};

template <class R>
struct State {
  Nodes<R> x, v, f;
  // What the edge of a finite plate remembers of each node, and its force on it in this step (edge.hpp); not there
  // where no plate ends.
  Nodes<R> edge, held;
};

/// What the step adds up for the observables since the last sample: N_TALLIES numbers.
template <class R>
struct Tally {
  R left, right, none, nodes;                             // steps touched by; airborne; node-steps in contact
  R joint_loss, contact_work, friction_loss, plate_work;  // J
  R centre_y;                                             // m, where the legs part: last step's mean, plate frame
};
constexpr int N_TALLIES = 9;

/// Axial joints of stiffness k_c, and bending ones, of one straight line of nodes. Walks it once, carrying the edge
/// behind.
template <bool Bends, class R>
PLATEGAIT_HD void pull_line(const State<R>& s, const int* nodes, int n, const R* parameter, R k_c, R rest_length,
                            R& power) {
  const R inverse_pitch = number<R>(1) / parameter[PITCH];
  const R c_c = implicit_damping(parameter[AXIAL_DAMPING], parameter[TIME_STEP] / parameter[NODE_MASS]);
  const R k_b = parameter[BENDING_STIFFNESS], c_b = parameter[BENDING_DAMPING];
  const Vec3<R> zero = {number<R>(0), number<R>(0), number<R>(0)};
  Vec3<R> x = s.x.get(nodes[0]), v = s.v.get(nodes[0]);
  Vec3<R> force_behind = zero, force_here = zero, turning = zero;
  Edge<R> edge = {};
  for (int i = 0; i + 1 < n; i++) {
    const Vec3<R> x_next = s.x.get(nodes[i + 1]), v_next = s.v.get(nodes[i + 1]);
    const Edge<R> next = edge_between(x, v, x_next, v_next);
    const Vec3<R> pull = axial_tension(next, rest_length, k_c, c_c, power) * next.along;
    Vec3<R> force_next = zero - pull;
    force_here = force_here + pull;
    if constexpr (Bends) {
      const Vec3<R> turning_next = turning_rate(next);
      if (i > 0) {
        const Vec3<R> moment = bending_moment(edge, next, turning, turning_next, k_b, c_b, inverse_pitch, power);
        const Vec3<R> far = couple_force(next, moment), near = couple_force(edge, moment);
        force_next = force_next + far;
        force_behind = force_behind + near;
        force_here = force_here - far - near;
      }
      turning = turning_next;
      if (i > 0) s.f.add(nodes[i - 1], force_behind);
      force_behind = force_here;
      force_here = force_next;
      edge = next;
    } else {
      s.f.add(nodes[i], force_here);
      force_here = force_next;
    }
    x = x_next;
    v = v_next;
  }
  if constexpr (Bends)
    if (n > 1) s.f.add(nodes[n - 2], force_behind);
  s.f.add(nodes[n - 1], force_here);
}

/// Stiffness of the diagonals, N/m: they carry the in-plane shear.
template <class R>
PLATEGAIT_HD R diagonal_stiffness(const R* parameter) {
  return parameter[SHEAR_RATIO] * parameter[AXIAL_STIFFNESS];
}

template <class R>
PLATEGAIT_HD void twist_cells(const State<R>& s, const Topology& topology, const R* parameter, R& power) {
  const R inverse_pitch = number<R>(1) / parameter[PITCH];
  for (int c = 0; c < topology.n_cells; c++) {
    const int* k = topology.cells + 4 * c;
    const Vec3<R> warp = (s.x.get(k[0]) - s.x.get(k[1])) - (s.x.get(k[2]) - s.x.get(k[3]));
    const Vec3<R> rate = (s.v.get(k[0]) - s.v.get(k[1])) - (s.v.get(k[2]) - s.v.get(k[3]));
    const Vec3<R> force =
        torsion_force(warp, rate, inverse_pitch, parameter[TORSION_STIFFNESS], parameter[TORSION_DAMPING], power);
    s.f.add(k[0], force);
    s.f.set(k[1], s.f.get(k[1]) - force);
    s.f.set(k[2], s.f.get(k[2]) - force);
    s.f.add(k[3], force);
  }
}

template <class R>
PLATEGAIT_HD void pull_joints(const State<R>& s, const Topology& topology, const R* parameter, Tally<R>& tally) {
  const R zero = number<R>(0);
  for (int k = 0; k < topology.n_nodes; k++) s.f.set(k, {zero, zero, zero});
  R power = zero;
  const R pitch = parameter[PITCH], diagonal = number<R>(1.4142135623730951) * pitch;
  const R k_c = parameter[AXIAL_STIFFNESS], k_diagonal = diagonal_stiffness(parameter);
  for (int i = 0; i < topology.n_axial_lines; i++)
    pull_line<true>(s, topology.line_nodes + topology.line_start[i],
                    topology.line_start[i + 1] - topology.line_start[i], parameter, k_c, pitch, power);
  for (int i = topology.n_axial_lines; i < topology.n_lines; i++)
    pull_line<false>(s, topology.line_nodes + topology.line_start[i],
                     topology.line_start[i + 1] - topology.line_start[i], parameter, k_diagonal, diagonal, power);
  if (topology.features.torsion) twist_cells(s, topology, parameter, power);
  tally.joint_loss += power * parameter[TIME_STEP];
}

}  // namespace plategait
