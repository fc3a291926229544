// One time step of one run (or of a pack of runs side by side), as named phases.
//
//   1. move the plate        (4.1), (4.2), or any Fourier series or sampled trajectory
//   2. pull the joints       along the lattice's straight lines, then its cells
//   3. meet the plate        gravity, contact (3.1), friction (3.2); new velocity, then new position
//
// Semi-implicit Euler: positions move with the velocities just found; the contact is linearly implicit.
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
  const int* line_start;    // n_lines + 1
  const int* line_nodes;
  const int* cells;         // n_cells x 4
  const double* rest;       // n_nodes x 2, in pitches, about the centroid
  const double* mobility;   // n_nodes: 1 free, 0 held where it is
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
};

/// One sine of the plate motion: amplitude (m or rad), frequency (Hz), phase (turns).
template <class R>
struct Term {
  R amplitude;
  Wide<R> frequency, phase;
};

/// The plate's trajectory: sines, each on one degree of freedom, and optionally a table of knots
/// (position, speed) every TABLE_STEP, joined by cubic Hermite pieces. Past its last knot the plate stays there.
template <class R>
struct Trajectory {
  int n_terms;
  const int* term_dof;   // degree of freedom of each term, the same for every run
  const Term<R>* terms;
  const double* knots;   // [knot][dof][position, speed] of all tables, shared by all runs; null where there is none
  Wide<R> first_knot, last_knot;  // of the run's own table: its first among all knots, its last among its own
};

/// What the step adds up for the observables since the last sample.
template <class R>
struct Tally {
  R left, right, none, nodes;                            // steps touched by; airborne; node-steps in contact
  R joint_loss, contact_work, friction_loss, plate_work; // J
  R centre_y;                                            // m, where the legs part: last step's mean, plate frame
};

// ------------------------------------------------------------------------------------------ 1. the plate

template <class R>
PLATEGAIT_HD PlateMotion<R> move_plate(const Trajectory<R>& trajectory, const R* parameter, Wide<R> time) {
  const R t = narrow_to(time, R());
  PlateMotion<R> motion;
  R level, rate;
  smooth_start(t, parameter[RAMP_DURATION], level, rate);
  for (int d = 0; d < DEGREES_OF_FREEDOM; d++) motion.position[d] = motion.speed[d] = number<R>(0);
  for (int j = 0; j < trajectory.n_terms; j++) {
    const Term<R>& term = trajectory.terms[j];
    const int d = trajectory.term_dof[j];
    const Wide<R> phase = time * term.frequency + term.phase;
    const SineCosine<R> wave = sine_cosine(narrow_to(phase - floor_of(phase), R()));
    motion.position[d] += term.amplitude * wave.sine;
    motion.speed[d] += term.amplitude * narrow_to(term.frequency, R()) * number<R>(6.283185307179586) * wave.cosine;
  }
  if (trajectory.knots) {
    const R step = parameter[TABLE_STEP];
    const Wide<R> knot = smaller(time / widen(step), trajectory.last_knot);
    const Wide<R> behind = smaller(floor_of(knot), trajectory.last_knot - Wide<R>(1.0));
    const Index<R> row = index_of(trajectory.first_knot + behind);
    const R s = narrow_to(knot - behind, R());
    const R one = number<R>(1), two = number<R>(2), three = number<R>(3), rest = one - s;
    for (int d = 0; d < DEGREES_OF_FREEDOM; d++) {
      const R p0 = look_up(trajectory.knots, row, 12, 2 * d, R()), v0 = look_up(trajectory.knots, row, 12, 2 * d + 1, R()) * step;
      const R p1 = look_up(trajectory.knots, row, 12, 2 * d + 12, R()), v1 = look_up(trajectory.knots, row, 12, 2 * d + 13, R()) * step;
      motion.position[d] += (one + two * s) * rest * rest * p0 + s * rest * rest * v0 + s * s * (three - two * s) * p1 -
                            s * s * rest * v1;
      motion.speed[d] += (number<R>(6) * s * rest * (p1 - p0) + rest * (one - three * s) * v0 + s * (three * s - two) * v1) / step;
    }
  }
  for (int d = 0; d < DEGREES_OF_FREEDOM; d++) {
    motion.speed[d] = level * motion.speed[d] + rate * motion.position[d];
    motion.position[d] = level * motion.position[d];
  }
  return motion;
}

// ----------------------------------------------------------------------------------------- 2. the joints

/// Axial and bending joints of one straight line of nodes. Walks it once, carrying the edge behind.
template <bool Bends, class R>
PLATEGAIT_HD void pull_line(const State<R>& s, const int* nodes, int n, const R* parameter, R rest_length,
                            R& power) {
  const R k_c = parameter[AXIAL_STIFFNESS], c_c = parameter[AXIAL_DAMPING];
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
        const Vec3<R> moment = bending_moment(edge, next, turning, turning_next, k_b, c_b, power);
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

template <class R>
PLATEGAIT_HD void twist_cells(const State<R>& s, const Topology& topology, const R* parameter, R& power) {
  const R inverse_pitch = number<R>(1) / parameter[PITCH];
  for (int c = 0; c < topology.n_cells; c++) {
    const int* k = topology.cells + 4 * c;
    const Vec3<R> warp = (s.x.get(k[0]) - s.x.get(k[1])) - (s.x.get(k[2]) - s.x.get(k[3]));
    const Vec3<R> rate = (s.v.get(k[0]) - s.v.get(k[1])) - (s.v.get(k[2]) - s.v.get(k[3]));
    const Vec3<R> force = torsion_force(warp, rate, inverse_pitch, parameter[TORSION_STIFFNESS], parameter[TORSION_DAMPING], power);
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
  for (int i = 0; i < topology.n_axial_lines; i++)
    pull_line<true>(s, topology.line_nodes + topology.line_start[i], topology.line_start[i + 1] - topology.line_start[i],
                    parameter, pitch, power);
  for (int i = topology.n_axial_lines; i < topology.n_lines; i++)
    pull_line<false>(s, topology.line_nodes + topology.line_start[i], topology.line_start[i + 1] - topology.line_start[i],
                     parameter, diagonal, power);
  if (topology.features.torsion) twist_cells(s, topology, parameter, power);
  tally.joint_loss += power * parameter[TIME_STEP];
}

// ------------------------------------------------------------------------------------------ 3. the plate

template <class R>
PLATEGAIT_HD void meet_plate(const State<R>& s, const Topology& topology, const R* parameter, const PlatePose<R>& plate,
                             Tally<R>& tally) {
  const R zero = number<R>(0), one = number<R>(1), half = number<R>(0.5);
  const R dt = parameter[TIME_STEP], mass = parameter[NODE_MASS], inverse_mass = one / mass;
  const R mu_s = parameter[STATIC_FRICTION], mu_k = parameter[KINETIC_FRICTION], V = parameter[STATIC_SPEED];
  const Mask<R> smooth = parameter[SMOOTH_FRICTION] > half;
  const R inverse_rise = one / V, inverse_fall = one / (parameter[KINETIC_SPEED] - V);
  const R ramp = parameter[CONTACT_RAMP], inverse_ramp = one / larger(ramp, number<R>(1e-12)), mass_rate = mass / dt;
  const R half_length = parameter[PLATE_HALF_LENGTH], half_width = parameter[PLATE_HALF_WIDTH];
  const R weight = mass * parameter[GRAVITY];
  R left = zero, right = zero, touching = zero, sum_y = zero;
  R contact_work = zero, friction_loss = zero, plate_work = zero;
  for (int k = 0; k < topology.n_nodes; k++) {
    const Vec3<R> v = s.v.get(k), r = s.x.get(k) - plate.origin;
    Vec3<R> other = s.f.get(k);
    other.z = other.z - weight;
    const R depth = zero - dot(r, plate.normal);
    const R across = dot(r, plate.ey);
    R reach = depth;
    if (topology.features.plate_edge) {
      const R along = dot(r, plate.ex);
      const Mask<R> over_plate = (along < half_length) & (zero - along < half_length) & (across < half_width) &
                                 (zero - across < half_width);
      reach = select(over_plate, depth, number<R>(-1));
    }
    const Vec3<R> plate_velocity = plate.velocity + cross(plate.turning, r);
    const Vec3<R> u = v - plate_velocity;
    const R separating = dot(u, plate.normal), other_normal = inverse_mass * dot(other, plate.normal);
    R damping = parameter[CONTACT_DAMPING];
    if (topology.features.contact_ramp)
      damping = select(ramp > zero, contact_damping(larger(reach, zero), damping, inverse_ramp), damping);
    const R force = normal_force(reach, separating, other_normal, inverse_mass, dt, parameter[CONTACT_STIFFNESS], damping);

    // Slip that the step would end with were there no friction; friction may stop it, never reverse it.
    const Vec3<R> free = u + (dt * inverse_mass) * other;
    const Vec3<R> slip = free - dot(free, plate.normal) * plate.normal;
    const R slip_squared = dot(slip, slip) + number<R>(1e-20);
    const R inverse_slip = reciprocal_sqrt(slip_squared), speed = slip_squared * inverse_slip;
    R mu = friction_coefficient(speed, mu_s, mu_k, V);
    if (topology.features.smooth_friction)
      mu = select(smooth, smooth_friction_coefficient(speed, mu_s, mu_k, V, inverse_rise, inverse_fall), mu);
    const R drag = smaller(mu * force, mass_rate * speed) * inverse_slip;

    const Vec3<R> from_plate = force * plate.normal - drag * slip;
    const R free_mass = number<R>(topology.mobility[k]) * inverse_mass;
    const Vec3<R> gain = (dt * free_mass) * (other + from_plate);
    const Vec3<R> v_new = v + gain, u_mid = u + half * gain;
    s.v.set(k, v_new);
    s.x.add(k, number<R>(topology.mobility[k]) * (dt * v_new));

    const R touches = select(force > zero, one, zero);
    const Mask<R> on_left = across > tally.centre_y;
    left = larger(left, select(on_left, touches, zero));
    right = larger(right, select(on_left, zero, touches));
    touching += touches;
    sum_y += across;
    contact_work -= force * dot(u_mid, plate.normal);
    friction_loss += drag * dot(slip, u_mid);
    plate_work += dot(from_plate, plate_velocity);
  }
  tally.left += left;
  tally.right += right;
  tally.none += one - larger(left, right);
  tally.nodes += touching;
  tally.centre_y = sum_y * number<R>(1.0 / topology.n_nodes);
  tally.contact_work += dt * contact_work;
  tally.friction_loss += dt * friction_loss;
  tally.plate_work += dt * plate_work;
}

template <class R>
PLATEGAIT_HD PlateMotion<R> advance_one_step(const State<R>& state, const Topology& topology, const R* parameter,
                                             const Trajectory<R>& trajectory, Wide<R> time, Tally<R>& tally) {
  const PlateMotion<R> motion = move_plate(trajectory, parameter, time);
  pull_joints(state, topology, parameter, tally);
  meet_plate(state, topology, parameter, plate_pose(motion, parameter[PLATE_HEIGHT]), tally);
  return motion;
}

}  // namespace plategait
