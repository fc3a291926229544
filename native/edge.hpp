// The edge of a finite plate. It carries the sheet between its nodes, and what is beneath the plate stays beneath.
//
// Each node has a memory. `sunk` is the depth at which the plate's surface would have to lie for it to touch: zero for
// a sheet that lies on the plate or hangs over its edge; a node that comes in from beside the plate brings its whole
// depth along, and so finds nothing to stand on. And since a contact deepens little by little, what is found deep at
// once was never on the plate.
#pragma once

#include "touch.hpp"

namespace plategait {

/// Deeper than this a node is beneath the plate, not on it, m: some ten times what a landing presses in.
constexpr double BENEATH = 1e-3;
/// A contact deepens by less than this in a step, m: 1 m/s times the largest step. A piece of the sheet that passes the
/// edge no deeper hangs over it.
constexpr double DEEPENS = 1e-4;

/// A node as the plate sees it.
template <class R>
struct Above {
  R along, across, depth;
  Mask<R> over;  // within the plate's outline
};

template <class R>
PLATEGAIT_HD Above<R> above_plate(Vec3<R> x, const PlatePose<R>& plate, const R* parameter) {
  const R zero = number<R>(0), length = parameter[PLATE_HALF_LENGTH], width = parameter[PLATE_HALF_WIDTH];
  const Vec3<R> r = x - plate.origin;
  const R along = dot(r, plate.ex), across = dot(r, plate.ey);
  return {along, across, zero - dot(r, plate.normal),
          (along < length) & (zero - along < length) & (across < width) & (zero - across < width)};
}

/// What the edge remembers of a node: `sunk`, m, and how the plate carries it now and carried it the step before:
/// by −(1 + reach) where it is over the plate, by 1 + reach where a neighbour on the plate holds it beyond the edge,
/// else 0.
template <class R>
struct Memory {
  R sunk, before, now;
};

template <class R>
PLATEGAIT_HD Memory<R> recall(const State<R>& s, int k) {
  const Vec3<R> m = s.edge.get(k);
  return {m.x, m.y, m.z};
}

template <class R>
PLATEGAIT_HD void remember(const State<R>& s, int k, const Memory<R>& m) {
  s.edge.set(k, {m.sunk, m.before, m.now});
}

/// Depth that a contact may have by now, m, from how deep it was a step before.
template <class R>
PLATEGAIT_HD R deepest(R carried_before) {
  const R size = larger(carried_before, number<R>(0) - carried_before);
  return larger(size - number<R>(1), number<R>(0)) + number<R>(DEEPENS);
}

/// Depth of a node below where it touches, m; negative where nothing carries it.
template <class R>
PLATEGAIT_HD R reach_of(const Memory<R>& memory, R depth) {
  const Mask<R> carried = (memory.now < number<R>(-0.5)) & (memory.sunk < number<R>(BENEATH));
  return select(carried, depth - memory.sunk, number<R>(-1));
}

/// How a straight piece of the lattice passes one pair of edges, from its node over the plate to the one beyond.
template <class R>
struct Passage {
  R share;    // of the way, beyond 1 where it does not pass
  R outward;  // signed distance covered along the axis, m
};

template <class R>
PLATEGAIT_HD Passage<R> passage(R inner, R outer, R half_size) {
  const R zero = number<R>(0), outward = outer - inner, limit = select(outward < zero, zero - half_size, half_size);
  const Mask<R> passes = (outer > half_size) | (zero - outer > half_size);
  return {select(passes, (limit - inner) / select(passes, outward, number<R>(1)), number<R>(2)), outward};
}

/// Where a straight piece of the lattice crosses the plate's edge.
template <class R>
struct Crossing {
  Mask<R> there, first_over;  // whether it does; whether its first node is the one over the plate
  R near, far;                // weights of its first and second node at the crossing
  R share;                    // part of the piece that lies on the plate
  R depth;                    // below the plate's corner, square to the piece, m
  Vec3<R> normal;             // of the piece where it bends over the corner: its force moves the plate as it is moved
};

template <class R>
PLATEGAIT_HD Crossing<R> edge_crossing(const Above<R>& a, const Above<R>& b, const PlatePose<R>& plate,
                                       const R* parameter) {
  const R zero = number<R>(0), one = number<R>(1);
  const Mask<R> first = a.over & !b.over, second = b.over & !a.over;
  const Passage<R> along =
      passage(select(first, a.along, b.along), select(first, b.along, a.along), parameter[PLATE_HALF_LENGTH]);
  const Passage<R> across =
      passage(select(first, a.across, b.across), select(first, b.across, a.across), parameter[PLATE_HALF_WIDTH]);
  const R share = larger(smaller(smaller(along.share, across.share), one), zero);
  const R far = select(first, share, one - share), near = one - far;
  const R depth = near * a.depth + far * b.depth, sinks = select(first, b.depth - a.depth, a.depth - b.depth);
  const Mask<R> ends = along.share < across.share;
  const R outward = select(ends, along.outward, across.outward);
  // A piece that falls off beyond the edge leans on the corner: its slope, with the sign of the axis it crosses.
  const R slope = larger(sinks, zero) * outward / (outward * outward + number<R>(1e-20));
  const R level = reciprocal_sqrt(one + slope * slope);
  const Vec3<R> lean = slope * Vec3<R>{select(ends, plate.ex.x, plate.ey.x), select(ends, plate.ex.y, plate.ey.y),
                                       select(ends, plate.ex.z, plate.ey.z)};
  return {first | second, first, near, far, share, level * depth, level * (plate.normal + lean)};
}

/// Depth of a crossing below where it touches, m; negative where nothing carries it.
template <class R>
PLATEGAIT_HD R reach_of(const Crossing<R>& c, const Memory<R>& a, const Memory<R>& b) {
  const R reach = c.depth - (c.near * a.sunk + c.far * b.sunk), beneath = number<R>(BENEATH);
  const Mask<R> deepened = reach < deepest(select(c.first_over, b.before, a.before));
  return select(c.there & deepened & (a.sunk < beneath) & (b.sunk < beneath), reach, number<R>(-1));
}

/// Renew the memory of every node. Returns whether any is beyond the plate's edge, in any lane.
template <class R>
PLATEGAIT_HD bool see_edge(const State<R>& s, const Topology& topology, const R* parameter, const PlatePose<R>& plate) {
  const R zero = number<R>(0), one = number<R>(1), half = number<R>(0.5), beneath = number<R>(BENEATH);
  bool beyond = false;
  for (int k = 0; k < topology.n_nodes; k++) {
    const Above<R> node = above_plate(s.x.get(k), plate, parameter);
    const Memory<R> m = recall(s, k);
    const R depth = larger(node.depth, zero);
    // Beneath the plate, or beside it and not carried the step before, a node brings its depth along; so it does, but
    // for what it was held by, where it comes in over the plate.
    const R lost = select(node.over, m.sunk, select((m.now < half) & (zero - m.now < half), beneath, zero));
    const R entered = select(node.over & (m.now > zero - half), depth - deepest(m.now), zero);
    const R sunk = select(lost < beneath, larger(smaller(m.sunk, depth), entered), depth);
    remember(s, k, {sunk, m.now, select(node.over, zero - one - (depth - smaller(sunk, depth)), zero)});
    beyond = beyond | any_of(!node.over);
  }
  return beyond;
}

/// A piece that crosses the edge from a node on the plate holds the one beyond; one that passes the edge above the
/// surface hangs over it, wherever it was before.
template <class R>
PLATEGAIT_HD void hold_beyond(const Crossing<R>& c, Memory<R>& a, Memory<R>& b) {
  const R zero = number<R>(0), one = number<R>(1), beneath = number<R>(BENEATH);
  const Mask<R> over = c.there & (c.depth < number<R>(DEEPENS));
  b.sunk = select(over & c.first_over & (a.sunk < beneath), zero, b.sunk);
  a.sunk = select(over & !c.first_over & (b.sunk < beneath), zero, a.sunk);
  const R reach = reach_of(c, a, b);
  const R held = select(over | (reach > zero), one + larger(reach, zero), zero);
  b.now = select(c.there & c.first_over & (a.sunk < beneath), larger(b.now, held), b.now);
  a.now = select(c.there & !c.first_over & (b.sunk < beneath), larger(a.now, held), a.now);
}

/// Work that a node's share of the edge's force does because of what pushes the node after it in the same step, J: the
/// velocity that a force's own work is reckoned by knows only what came before.
template <class R>
PLATEGAIT_HD R work_by_later(const State<R>& s, int k, Vec3<R> later, R dt, R inverse_mass) {
  return number<R>(0.5) * dt * dt * inverse_mass * dot(s.held.get(k), later);
}

/// Add a force of the edge to a node.
template <class R>
PLATEGAIT_HD void hold_node(const State<R>& s, int k, Vec3<R> force, R dt, R inverse_mass, Tally<R>& tally) {
  tally.contact_work -= work_by_later(s, k, force, dt, inverse_mass);
  s.f.add(k, force);
  s.held.add(k, force);
}

/// Visit the pieces of the lattice that cross the edge in any lane: with their nodes, a and b, as the plate sees them.
template <class R, class Visit>
PLATEGAIT_HD void at_crossings(const State<R>& s, const Topology& topology, const R* parameter,
                               const PlatePose<R>& plate, Visit visit) {
  for (int i = 0; i < topology.n_axial_lines; i++) {
    Above<R> a, b = above_plate(s.x.get(topology.line_nodes[topology.line_start[i]]), plate, parameter);
    for (int j = topology.line_start[i]; j + 1 < topology.line_start[i + 1]; j++) {
      a = b;
      b = above_plate(s.x.get(topology.line_nodes[j + 1]), plate, parameter);
      const Crossing<R> c = edge_crossing(a, b, plate, parameter);
      if (any_of(c.there)) visit(c, topology.line_nodes[j], topology.line_nodes[j + 1], a, b);
    }
  }
}

/// The edge carries the pieces of the lattice that cross it: forces on their nodes, and which legs touch.
template <class R>
PLATEGAIT_HD void meet_edge(const State<R>& s, const Topology& topology, const R* parameter, const Surface<R>& surface,
                            const PlatePose<R>& plate, const PlatePose<R>& next, Tally<R>& tally, R& left, R& right) {
  const R zero = number<R>(0), one = number<R>(1), inverse_mass = one / parameter[NODE_MASS], dt = surface.time_step;
  for (int k = 0; k < topology.n_nodes; k++) s.held.set(k, {zero, zero, zero});
  const auto carry = [&](const Crossing<R>& c, int ka, int kb, const Above<R>& a, const Above<R>& b) {
    Memory<R> ma = recall(s, ka), mb = recall(s, kb);
    hold_beyond(c, ma, mb);
    remember(s, ka, ma);
    remember(s, kb, mb);

    const Vec3<R> r = c.near * s.x.get(ka) + c.far * s.x.get(kb) - plate.origin;
    Vec3<R> pull = inverse_mass * (c.near * s.f.get(ka) + c.far * s.f.get(kb));
    pull.z = pull.z - parameter[GRAVITY];
    const Point<R> point = {c.near * s.v.get(ka) + c.far * s.v.get(kb), pull,
                            (c.near * c.near + c.far * c.far) * inverse_mass};
    Ground<R> ground = ground_at(plate, next, r);
    ground.normal = c.normal;
    const Touch<R> touch = touch_plate(surface, topology.features, point, ground, reach_of(c, ma, mb), c.share);
    const Vec3<R> force = touch.normal * c.normal - touch.drag;
    tally_touch(touch, point, ground, dt, tally);
    hold_node(s, ka, c.near * force, dt, inverse_mass, tally);
    hold_node(s, kb, c.far * force, dt, inverse_mass, tally);

    const R touches = select(touch.normal > zero, one, zero);
    const Mask<R> on_left = c.near * a.across + c.far * b.across > tally.centre_y;
    left = larger(left, select(on_left, touches, zero));
    right = larger(right, select(on_left, zero, touches));
  };
  at_crossings(s, topology, parameter, plate, carry);
}

/// Before the first step: a sheet that is laid across the edge hangs over it.
template <class R>
PLATEGAIT_HD void lay_across_edge(const State<R>& s, const Topology& topology, const R* parameter,
                                  const PlatePose<R>& plate) {
  const auto hang = [&](const Crossing<R>& c, int ka, int kb, const Above<R>&, const Above<R>&) {
    Memory<R> a = recall(s, ka), b = recall(s, kb);
    hold_beyond(c, a, b);
    remember(s, ka, a);
    remember(s, kb, b);
  };
  at_crossings(s, topology, parameter, plate, hang);
}

/// Energy that the contact along the edge stores, J.
template <class R>
PLATEGAIT_HD R edge_energy(const State<R>& s, const Topology& topology, const R* parameter, const PlatePose<R>& plate) {
  R stored = number<R>(0);
  const auto store = [&](const Crossing<R>& c, int ka, int kb, const Above<R>&, const Above<R>&) {
    const R reach = larger(reach_of(c, recall(s, ka), recall(s, kb)), number<R>(0));
    stored += contact_energy(reach, c.share * parameter[CONTACT_STIFFNESS]);
  };
  at_crossings(s, topology, parameter, plate, store);
  return stored;
}

}  // namespace plategait
