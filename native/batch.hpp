// A batch of runs as plain arrays, and the pieces that share its work out.
#pragma once

#include <atomic>
#include <cstdint>

#include "parameters.hpp"
#include "step.hpp"

namespace plategait {

/// A batch of runs: what they are, what is kept of them from one advance to the next, and what an advance records.
/// Arrays are C-ordered, double or int64 unless said; sizes in brackets.
template <class T>
struct Batch {
  Topology topology;
  std::int64_t n_runs;
  const double* parameters;  // [N_PARAMETERS][n_runs]
  int n_layers, n_terms;
  const int* layer_terms;          // [n_layers + 1]
  const int* term_dof;             // [n_terms]
  const double* terms;             // [n_terms][amplitude, frequency, phase][n_runs]
  const double* layers;            // [n_layers][N_LAYER_NUMBERS][n_runs]
  const double* knots;             // [all knots of all tables][12], shared by the runs; null without tables
  const std::int64_t* first_knot;  // [n_layers][n_runs] where each table begins
  const std::int64_t* n_knots;     // [n_layers][n_runs] 2 or more
  const std::int64_t* steps;       // [n_runs] steps to take
  const std::int64_t* stride;      // [n_runs] steps between samples
  const std::int64_t* thinning;    // [n_runs] samples between snapshots, 0 for none
  // Kept: read, and left as they are at the end. Fewer steps are taken than asked where a run diverged.
  double *x, *v, *edge;  // [n_runs][n_nodes][3]; the edge's only where a plate ends
  double* tally;         // [n_runs][N_TALLIES]
  std::int64_t* clock;   // [n_runs][N_CLOCKS]
  std::int64_t max_samples, max_snapshots;
  T* samples;        // [n_runs][max_samples][N_CHANNELS]
  float* snapshots;  // [n_runs][max_snapshots][n_nodes][3], world frame
  T* last;           // [n_runs][N_CHANNELS], at the end
};

/// Shared by all threads of a call.
struct Progress {
  std::atomic<bool> cancelled{false};
  std::atomic<std::int64_t> steps{0};  // run-steps done
};

/// Advance the block of runs that begins at `first`. One specialisation per instruction set, each compiled in a
/// translation unit of its own. Throws std::bad_alloc where there is no memory for the block.
template <class Level, class T>
void advance_block(const Batch<T>& batch, std::int64_t first, Progress& progress);

template <class Level, class T>
constexpr int lanes_of = Level::bytes / static_cast<int>(sizeof(T));

}  // namespace plategait
