// The forces of this package's laws, for a MuJoCo that integrates: joints, contact and friction of every node, by the
// headers that the core is made of, as a callback that MuJoCo's batch may call from any of its threads.
#include <mujoco/mujoco.h>

#include <cstring>
#include <vector>

#include "step.hpp"

namespace {

using namespace plategait;

Topology topology{};
const double *parameters, *terms;  // [run][N_PARAMETERS]; [run][stroke, angle, frequency, ramp]

PlatePose<double> pose_at(const double* term, double time, double height) {
  const int layer_terms[2] = {0, 2}, term_dof[2] = {0, 3};
  const Term<double> sines[2] = {{term[0], term[2], 0.0}, {-term[1], term[2], 0.0}};
  Layer<double> layer{};
  layer.duration = term[3];
  return plate_pose(move_plate(Trajectory<double>{1, layer_terms, term_dof, sines, &layer, nullptr}, time), height);
}

}  // namespace

extern "C" void configure(int n_nodes, int n_lines, int n_axial_lines, const int* line_start, const int* line_nodes,
                          const double* run_parameters, const double* run_terms) {
  topology = {n_nodes, n_lines, n_axial_lines, 0, line_start, line_nodes, nullptr, nullptr, nullptr, {}};
  parameters = run_parameters;
  terms = run_terms;
}

// Nodes are bodies on three slides from the origin, in order: qpos are their positions. Which run it is stands in
// userdata.
extern "C" void add_forces(const mjModel*, mjData* d) {
  thread_local std::vector<double> forces;
  forces.resize(3 * topology.n_nodes);
  const int run = static_cast<int>(d->userdata[0]);
  const double* parameter = parameters + run * N_PARAMETERS;
  const State<double> s = {{d->qpos, 1}, {d->qvel, 1}, {forces.data(), 1}, {nullptr, 1}, {nullptr, 1}};
  Tally<double> tally{};
  pull_joints(s, topology, parameter, tally);

  const double dt = parameter[TIME_STEP], inverse_mass = 1 / parameter[NODE_MASS];
  const PlatePose<double> plate = pose_at(terms + 4 * run, d->time, parameter[PLATE_HEIGHT]);
  const PlatePose<double> next = pose_at(terms + 4 * run, d->time + 0.5 * dt, parameter[PLATE_HEIGHT]);
  const Surface<double> surface = surface_of(parameter);
  for (int k = 0; k < topology.n_nodes; k++) {
    const Vec3<double> r = s.x.get(k) - plate.origin;
    Vec3<double> pull = inverse_mass * s.f.get(k);
    pull.z -= parameter[GRAVITY];
    const Touch<double> touch = touch_plate(surface, topology.features, {s.v.get(k), pull, inverse_mass},
                                            ground_at(plate, next, r), -dot(r, plate.normal), 1.0);
    s.f.add(k, touch.normal * plate.normal - touch.drag);
  }
  for (int i = 0; i < 3 * topology.n_nodes; i++) d->qfrc_passive[i] += forces[i];
}
