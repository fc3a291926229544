// What a run may differ in from its neighbours: every number of the model, in SI units.
#pragma once

namespace plategait {

/// Order of the rows that the batch is packed in. `parameter_names` below is the same list, for Python.
enum Parameter : int {
  PITCH,              // m
  NODE_MASS,          // kg
  AXIAL_STIFFNESS,    // k_c, N/m
  AXIAL_DAMPING,      // c_c, N s/m
  SHEAR_RATIO,        // stiffness of the diagonals over k_c
  BENDING_STIFFNESS,  // k_b, N m/rad
  BENDING_DAMPING,    // c_b, N m s/rad
  TORSION_STIFFNESS,  // k_t, N m/rad
  TORSION_DAMPING,    // c_t, N m s/rad
  CONTACT_STIFFNESS,  // k_contact of one node, N/mm^2.2: the depth of (3.1) counts in mm
  CONTACT_DAMPING,    // c_contact of one node, N s/m
  CONTACT_RAMP,       // depth over which the contact damping rises to its full value, m (0: at once)
  STATIC_FRICTION,    // mu_s
  KINETIC_FRICTION,   // mu_k
  STATIC_SPEED,       // V, m/s
  KINETIC_SPEED,      // V_d of the smooth law, m/s
  SMOOTH_FRICTION,    // 1: the smooth law; 0: the law of (3.2)
  GRAVITY,            // m/s^2
  PLATE_HALF_LENGTH,  // m, along the bar
  PLATE_HALF_WIDTH,   // m, across the bar
  PLATE_HEIGHT,       // m, of the plate's surface above the axis that it turns about
  TIME_STEP,          // s
  N_PARAMETERS
};

// clang-format off: the lists that follow are grouped by meaning.
constexpr const char* parameter_names[N_PARAMETERS] = {
    "pitch", "node_mass", "axial_stiffness", "axial_damping", "shear_ratio", "bending_stiffness",
    "bending_damping", "torsion_stiffness", "torsion_damping", "contact_stiffness", "contact_damping", "contact_ramp",
    "static_friction", "kinetic_friction", "static_speed", "kinetic_speed", "smooth_friction", "gravity",
    "plate_half_length", "plate_half_width", "plate_height", "time_step"};

/// What is recorded at each sample. The sums and fractions cover the steps since the sample before.
enum Channel : int {
  TIME,                          // s
  CENTRE_X, CENTRE_Y, CENTRE_Z,  // m, centre of mass in the plate frame
  SPIN_CROSS, SPIN_DOT,          // m^2, sums X0 × p and X0 · p: their angle is the best-fit rotation
  AREA_X, AREA_Y, AREA_Z,        // area vector in the plate frame over the area at rest
  LEFT_CONTACT, RIGHT_CONTACT,   // fraction of the steps at which that leg touches
  FLIGHT,                        // fraction of the steps at which nothing touches
  CONTACT,                       // mean fraction of the nodes that touch
  BEND_RMS,                      // rad, root-mean-square angle of the bending joints
  HEIGHT_LOW, HEIGHT_HIGH,       // m, lowest and highest node above the plate
  KINETIC_ENERGY, GRAVITY_ENERGY, AXIAL_ENERGY, BENDING_ENERGY, TORSION_ENERGY, CONTACT_ENERGY,  // J
  JOINT_LOSS, CONTACT_WORK, FRICTION_LOSS, PLATE_WORK,                                           // J
  PLATE_X, PLATE_Y, PLATE_Z, PLATE_RX, PLATE_RY, PLATE_RZ,                                       // m, rad
  N_CHANNELS
};

constexpr const char* channel_names[N_CHANNELS] = {
    "time", "centre_x", "centre_y", "centre_z", "spin_cross", "spin_dot", "area_x", "area_y", "area_z",
    "left_contact", "right_contact", "flight", "contact", "bend_rms", "height_low", "height_high",
    "kinetic_energy", "gravity_energy", "axial_energy", "bending_energy", "torsion_energy", "contact_energy",
    "joint_loss", "contact_work", "friction_loss", "plate_work",
    "plate_x", "plate_y", "plate_z", "plate_rx", "plate_ry", "plate_rz"};

constexpr int DEGREES_OF_FREEDOM = 6;

/// What a layer of the plate's course is told by: one motion that the plate goes over to (plate.hpp).
enum LayerNumber : int {
  BEGIN, DURATION,          // s, when the plate begins to go over to it, and how long it takes
  TABLE_BEGIN, TABLE_STEP,  // s, when its table of knots begins, and the time between them
  OFFSET,                   // m or rad, where it holds the plate: one for each degree of freedom
  N_LAYER_NUMBERS = OFFSET + DEGREES_OF_FREEDOM
};

constexpr const char* layer_names[N_LAYER_NUMBERS] = {
    "begin", "duration", "table_begin", "table_step",
    "offset_x", "offset_y", "offset_z", "offset_rx", "offset_ry", "offset_rz"};
// clang-format on

/// What is kept of a run's clock from one advance to the next, in steps since its start.
enum Clock : int {
  TAKEN,    // steps taken
  SEEN,     // when the last sample was taken
  DUE,      // when the next one is
  SAMPLED,  // samples taken
  N_CLOCKS
};

}  // namespace plategait
