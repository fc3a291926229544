// The core's door for a browser: a WebAssembly module without imports, told of a batch by a table of addresses.
//
// Whoever calls lays the arrays of `Batch` into the module's memory, each where `plategait_allocate` says, and their
// addresses and sizes into a table of 32-bit words in the order of `Word`. Nothing is checked here: the page's own
// `engine/batch.js` is the only caller.
#include <cstdint>
#include <cstdlib>

#include "block.hpp"
#include "shown.hpp"

namespace plategait {
namespace {

/// Places in the table of a batch.
enum Word : int {
  N_NODES,
  N_LINES,
  N_AXIAL_LINES,
  N_CELLS,
  N_RUNS,
  N_LAYERS,
  N_TERMS,
  MAX_SAMPLES,
  MAX_SNAPSHOTS,  // counts
  HAS_TORSION,
  HAS_SMOOTH_FRICTION,
  HAS_PLATE_EDGE,
  HAS_CONTACT_RAMP,  // 0 or 1
  LINE_START,
  LINE_NODES,
  CELLS,
  REST,
  MOBILITY,  // addresses
  PARAMETERS,
  LAYER_TERMS,
  TERM_DOF,
  TERMS,
  LAYERS,
  KNOTS,
  FIRST_KNOT,
  N_KNOTS,
  STEPS,
  STRIDE,
  THINNING,
  X,
  V,
  EDGE,
  TALLY,
  CLOCK,
  SAMPLES,
  SNAPSHOTS,
  LAST,
  N_WORDS
};

constexpr const char* word_names[N_WORDS] = {"n_nodes",
                                             "n_lines",
                                             "n_axial_lines",
                                             "n_cells",
                                             "n_runs",
                                             "n_layers",
                                             "n_terms",
                                             "max_samples",
                                             "max_snapshots",
                                             "has_torsion",
                                             "has_smooth_friction",
                                             "has_plate_edge",
                                             "has_contact_ramp",
                                             "line_start",
                                             "line_nodes",
                                             "cells",
                                             "rest",
                                             "mobility",
                                             "parameters",
                                             "layer_terms",
                                             "term_dof",
                                             "terms",
                                             "layers",
                                             "knots",
                                             "first_knot",
                                             "n_knots",
                                             "steps",
                                             "stride",
                                             "thinning",
                                             "x",
                                             "v",
                                             "edge",
                                             "tally",
                                             "clock",
                                             "samples",
                                             "snapshots",
                                             "last"};

template <class T>
T* at(const std::int32_t* table, Word word) {
  return reinterpret_cast<T*>(static_cast<std::uintptr_t>(static_cast<std::uint32_t>(table[word])));
}

Batch<float> batch_of(const std::int32_t* t) {
  Batch<float> batch{};
  batch.topology = {
      t[N_NODES],
      t[N_LINES],
      t[N_AXIAL_LINES],
      t[N_CELLS],
      at<const int>(t, LINE_START),
      at<const int>(t, LINE_NODES),
      at<const int>(t, CELLS),
      at<const double>(t, REST),
      at<const double>(t, MOBILITY),
      {t[HAS_TORSION] != 0, t[HAS_SMOOTH_FRICTION] != 0, t[HAS_PLATE_EDGE] != 0, t[HAS_CONTACT_RAMP] != 0}};
  batch.n_runs = t[N_RUNS];
  batch.parameters = at<const double>(t, PARAMETERS);
  batch.n_layers = t[N_LAYERS];
  batch.n_terms = t[N_TERMS];
  batch.layer_terms = at<const int>(t, LAYER_TERMS);
  batch.term_dof = at<const int>(t, TERM_DOF);
  batch.terms = at<const double>(t, TERMS);
  batch.layers = at<const double>(t, LAYERS);
  batch.knots = at<const double>(t, KNOTS);
  batch.first_knot = at<const std::int64_t>(t, FIRST_KNOT);
  batch.n_knots = at<const std::int64_t>(t, N_KNOTS);
  batch.steps = at<const std::int64_t>(t, STEPS);
  batch.stride = at<const std::int64_t>(t, STRIDE);
  batch.thinning = at<const std::int64_t>(t, THINNING);
  batch.x = at<double>(t, X);
  batch.v = at<double>(t, V);
  batch.edge = at<double>(t, EDGE);
  batch.tally = at<double>(t, TALLY);
  batch.clock = at<std::int64_t>(t, CLOCK);
  batch.max_samples = t[MAX_SAMPLES];
  batch.max_snapshots = t[MAX_SNAPSHOTS];
  batch.samples = at<float>(t, SAMPLES);
  batch.snapshots = at<float>(t, SNAPSHOTS);
  batch.last = at<float>(t, LAST);
  return batch;
}

/// Names one after the other into `text`, each with a line's end; how long they are. Without `text` only the latter.
template <int N>
int write_names(const char* const (&names)[N], char* text) {
  int length = 0;
  for (const char* name : names) {
    for (; *name; name++, length++)
      if (text) text[length] = *name;
    if (text) text[length] = '\n';
    length++;
  }
  return length;
}

}  // namespace
}  // namespace plategait

using namespace plategait;  // NOLINT: what follows is the module's own face

extern "C" {

/// Memory for arrays, at an address that any of them may begin at; 0 where there is none.
void* plategait_allocate(std::uint32_t bytes) { return std::aligned_alloc(16, (bytes + 31u) / 16u * 16u); }

void plategait_release(void* memory) { std::free(memory); }

/// Names of the table's words (0), parameters (1), layers' numbers (2) and channels (3).
int plategait_names(int which, char* text) {
  switch (which) {
    case 0:
      return write_names(word_names, text);
    case 1:
      return write_names(parameter_names, text);
    case 2:
      return write_names(layer_names, text);
    default:
      return write_names(channel_names, text);
  }
}

/// How many tallies (0) and clocks (1) are kept of a run, and lanes (2) advance side by side.
int plategait_count(int which) {
  return which == 0 ? N_TALLIES : which == 1 ? static_cast<int>(N_CLOCKS) : lanes_of<Baseline, float>;
}

/// Advance every run of a batch, as the native core's `run_batch` does.
void plategait_advance(const std::int32_t* table) {
  const Batch<float> batch = batch_of(table);
  Progress progress;
  for (std::int64_t first = 0; first < batch.n_runs; first += lanes_of<Baseline, float>)
    advance_block<Baseline, float>(batch, first, progress);
}

/// What the first run's nodes get from its plate now, [n_nodes][NODE_NUMBERS], and the plate from them,
/// [PLATE_NUMBERS].
void plategait_show(const std::int32_t* table, float* nodes, float* plate) {
  const Batch<float> batch = batch_of(table);
  Block<Baseline, float> block(batch, 0);
  block.look_at_clock();
  using R = Block<Baseline, float>::R;
  const int n = NODE_NUMBERS * block.n_nodes;
  Scratch<R> of_nodes(static_cast<std::size_t>(n));
  R of_plate[PLATE_NUMBERS];
  show_forces(block.state, batch.topology, block.parameter, block.trajectory, block.time, of_nodes.data, of_plate);
  for (int j = 0; j < n; j++) nodes[j] = of_nodes.data[j].v[0];
  for (int j = 0; j < PLATE_NUMBERS; j++) plate[j] = of_plate[j].v[0];
}
}
