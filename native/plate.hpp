// How the plate moves: sines and sampled trajectories on six degrees of freedom, and the pose they make.
#pragma once

#include "laws.hpp"
#include "parameters.hpp"

namespace plategait {

template <class R>
struct SineCosine {
  R sine, cosine;
};

/// sin and cos of 2π·turns, for turns within ±1. Series on the eighth turn nearest zero.
template <class R>
PLATEGAIT_HD SineCosine<R> sine_cosine(R turns) {
  // Fold to [−¼, ¼]: half a turn further, both change sign.
  const R half = number<R>(0.5), quarter = number<R>(0.25), one = number<R>(1), zero = number<R>(0);
  const R side = select(turns < zero, number<R>(-1), one);
  R t = side * turns;
  t = select(t > half, t - one, t);  // [−½, ½], odd reflection kept by `side`
  const Mask<R> beyond = select(t < zero, zero - t, t) > quarter;
  t = select(beyond, t - select(t < zero, number<R>(-0.5), half), t);
  const R flip = select(beyond, number<R>(-1), one);
  const R y = number<R>(6.283185307179586) * t, y2 = y * y;
  R s = number<R>(-1.0 / 121645100408832000.0);
  s = s * y2 + number<R>(1.0 / 355687428096000.0);
  s = s * y2 + number<R>(-1.0 / 1307674368000.0);
  s = s * y2 + number<R>(1.0 / 6227020800.0);
  s = s * y2 + number<R>(-1.0 / 39916800.0);
  s = s * y2 + number<R>(1.0 / 362880.0);
  s = s * y2 + number<R>(-1.0 / 5040.0);
  s = s * y2 + number<R>(1.0 / 120.0);
  s = s * y2 + number<R>(-1.0 / 6.0);
  s = s * y2 + one;
  R c = number<R>(1.0 / 2432902008176640000.0);
  c = c * y2 + number<R>(-1.0 / 6402373705728000.0);
  c = c * y2 + number<R>(1.0 / 20922789888000.0);
  c = c * y2 + number<R>(-1.0 / 87178291200.0);
  c = c * y2 + number<R>(1.0 / 479001600.0);
  c = c * y2 + number<R>(-1.0 / 3628800.0);
  c = c * y2 + number<R>(1.0 / 40320.0);
  c = c * y2 + number<R>(-1.0 / 720.0);
  c = c * y2 + number<R>(1.0 / 24.0);
  c = c * y2 + number<R>(-0.5);
  c = c * y2 + one;
  return {side * flip * s * y, flip * c};
}

/// Where the plate is and how it moves: three translations, three successive rotations about x, y, z.
///
/// Positions are wide: a turntable's angle grows without end, and what counts of it is what is left of whole turns.
template <class R>
struct PlateMotion {
  Wide<R> position[6];  // m, rad
  R speed[6];           // m/s, rad/s
};

/// Pose of the plate: its axes as seen in the world, and its velocity.
template <class R>
struct PlatePose {
  Vec3<R> origin, ex, ey, normal;  // m; unit vectors along the bar, across it, and up
  Vec3<R> velocity, turning;       // m/s, rad/s
};

/// Smooth start: a quintic from 0 to 1 over `duration`, with its rate; all at once where there is no duration.
template <class R>
PLATEGAIT_HD void smooth_start(R time, R duration, R& level, R& rate) {
  const R shortest = number<R>(1e-12), inverse = number<R>(1) / (duration + shortest);
  const R s = select(duration > shortest, smaller(time * inverse, number<R>(1)), number<R>(1)), rest = number<R>(1) - s;
  level = s * s * s * (number<R>(10) - number<R>(15) * s + number<R>(6) * s * s);
  rate = number<R>(30) * s * s * rest * rest * inverse;
}

/// sin and cos of any angle, folded to the nearest half turn while it is still wide.
template <class R>
PLATEGAIT_HD SineCosine<R> sine_cosine_of_angle(Wide<R> angle) {
  const Wide<R> turns = number<Wide<R>>(0.15915494309189535) * angle;
  return sine_cosine(narrow_to(turns - floor_of(turns + number<Wide<R>>(0.5)), R()));
}

/// Pose from the six degrees of freedom, rotation R = Rx(Θx) Ry(Θy) Rz(Θz) about a point `height` below the surface.
/// The surface at rest is z = 0.
template <class R>
PLATEGAIT_HD PlatePose<R> plate_pose(const PlateMotion<R>& m, R height) {
  const R zero = number<R>(0);
  const SineCosine<R> a = sine_cosine_of_angle<R>(m.position[3]), b = sine_cosine_of_angle<R>(m.position[4]),
                      g = sine_cosine_of_angle<R>(m.position[5]);
  const Vec3<R> ex = {b.cosine * g.cosine, a.cosine * g.sine + a.sine * b.sine * g.cosine,
                      a.sine * g.sine - a.cosine * b.sine * g.cosine};
  const Vec3<R> ey = {zero - b.cosine * g.sine, a.cosine * g.cosine - a.sine * b.sine * g.sine,
                      a.sine * g.cosine + a.cosine * b.sine * g.sine};
  const Vec3<R> normal = {b.sine, zero - a.sine * b.cosine, a.cosine * b.cosine};
  const Vec3<R> turning = {m.speed[3] + m.speed[5] * normal.x, m.speed[4] * a.cosine + m.speed[5] * normal.y,
                           m.speed[4] * a.sine + m.speed[5] * normal.z};
  const Vec3<R> arm = height * normal;
  const Vec3<R> origin = {narrow_to(m.position[0], R()) + arm.x, narrow_to(m.position[1], R()) + arm.y,
                          narrow_to(m.position[2], R()) + arm.z - height};
  const Vec3<R> velocity = {m.speed[0], m.speed[1], m.speed[2]};
  return {origin, ex, ey, normal, velocity + cross(turning, arm), turning};
}

/// One sine of the plate motion: amplitude (m or rad), frequency (Hz), phase (turns).
template <class R>
struct Term {
  R amplitude;
  Wide<R> frequency, phase;
};

/// One motion of the plate, and how the plate goes over to it: a layer of its course.
///
/// The motion is an offset, sines, each on one degree of freedom, and optionally a table of knots (position, speed)
/// every `table_step`, joined by cubic Hermite pieces. Past its last knot the plate stays there.
template <class R>
struct Layer {
  Wide<R> begin;  // s
  R duration;     // s
  Wide<R> table_begin;
  R table_step;
  Wide<R> offset[DEGREES_OF_FREEDOM];
  Wide<R> first_knot, last_knot;  // of its own table: the first among all knots, the last among its own
};

/// The plate's course: it stands where the first layer holds it, and goes over from each layer to the next.
template <class R>
struct Trajectory {
  int n_layers;
  const int* layer_terms;  // [n_layers + 1] where the terms of each layer begin
  const int* term_dof;     // degree of freedom of each term; these three are the same for every run
  const Term<R>* terms;
  const Layer<R>* layers;
  const double* knots;  // [knot][dof][position, speed] of all tables, shared by all runs; null where there is none
};

/// Add the sampled part of a motion.
template <class R>
PLATEGAIT_HD void follow_table(const double* knots, const Layer<R>& layer, Wide<R> time, PlateMotion<R>& motion) {
  const R step = layer.table_step;
  const Wide<R> knot = smaller((time - layer.table_begin) / widen(step), layer.last_knot);
  const Wide<R> behind = smaller(floor_of(knot), layer.last_knot - Wide<R>(1.0));
  const Index<R> row = index_of(layer.first_knot + behind);
  const R s = narrow_to(knot - behind, R());
  const R one = number<R>(1), three = number<R>(3), rest = one - s, rise = s * s * (three - number<R>(2) * s);
  for (int d = 0; d < DEGREES_OF_FREEDOM; d++) {
    const Wide<R> p0 = look_up(knots, row, 12, 2 * d, Wide<R>());
    const Wide<R> p1 = look_up(knots, row, 12, 2 * d + 12, Wide<R>());
    const R v0 = look_up(knots, row, 12, 2 * d + 1, R()) * step;
    const R v1 = look_up(knots, row, 12, 2 * d + 13, R()) * step;
    const R way = narrow_to(p1 - p0, R());
    motion.position[d] += p0 + widen(rise * way + s * rest * (rest * v0 - s * v1));
    motion.speed[d] +=
        (number<R>(6) * s * rest * way + rest * (one - three * s) * v0 + s * (three * s - number<R>(2)) * v1) / step;
  }
}

/// The motion of one layer by itself.
template <class R>
PLATEGAIT_HD PlateMotion<R> motion_of_layer(const Trajectory<R>& trajectory, int which, Wide<R> time) {
  const Layer<R>& layer = trajectory.layers[which];
  PlateMotion<R> motion;
  for (int d = 0; d < DEGREES_OF_FREEDOM; d++) {
    motion.position[d] = layer.offset[d];
    motion.speed[d] = number<R>(0);
  }
  for (int j = trajectory.layer_terms[which]; j < trajectory.layer_terms[which + 1]; j++) {
    const Term<R>& term = trajectory.terms[j];
    const int d = trajectory.term_dof[j];
    const Wide<R> phase = time * term.frequency + term.phase;
    const SineCosine<R> wave = sine_cosine(narrow_to(phase - floor_of(phase), R()));
    motion.position[d] += widen(term.amplitude * wave.sine);
    motion.speed[d] += term.amplitude * narrow_to(term.frequency, R()) * number<R>(6.283185307179586) * wave.cosine;
  }
  if (trajectory.knots) follow_table(trajectory.knots, layer, time, motion);
  return motion;
}

/// Go over from what the plate did before to the motion of a layer: position, speed and acceleration are continuous.
/// Exact where it has gone over, so that layers beneath may then be left out.
template <class R>
PLATEGAIT_HD void go_over(const Layer<R>& layer, const PlateMotion<R>& to, Wide<R> time, PlateMotion<R>& motion) {
  R level, rate;
  smooth_start(narrow_to(time - layer.begin, R()), layer.duration, level, rate);
  const Wide<R> share = widen(level), rest = number<Wide<R>>(1) - share;
  const R rest_now = number<R>(1) - level;
  for (int d = 0; d < DEGREES_OF_FREEDOM; d++) {
    const R way = narrow_to(to.position[d] - motion.position[d], R());
    motion.speed[d] = level * to.speed[d] + rate * way + rest_now * motion.speed[d];
    motion.position[d] = share * to.position[d] + rest * motion.position[d];
  }
}

template <class R>
PLATEGAIT_HD PlateMotion<R> move_plate(const Trajectory<R>& trajectory, Wide<R> time) {
  PlateMotion<R> motion;
  for (int d = 0; d < DEGREES_OF_FREEDOM; d++) {
    motion.position[d] = trajectory.layers[0].offset[d];
    motion.speed[d] = number<R>(0);
  }
  for (int i = 0; i < trajectory.n_layers; i++)
    go_over(trajectory.layers[i], motion_of_layer(trajectory, i, time), time, motion);
  return motion;
}

}  // namespace plategait
