// A batch of runs as plain arrays, and the pieces that share its work out.
#pragma once

#include <atomic>
#include <cstdint>

#include "parameters.hpp"
#include "step.hpp"

namespace plategait {

/// Inputs and outputs of a batch. Arrays are C-ordered, double or int64 unless said; sizes in brackets.
template <class T>
struct Batch {
  Topology topology;
  std::int64_t n_runs;
  const double* parameters;  // [N_PARAMETERS][n_runs]
  int n_terms;
  const int* term_dof;             // [n_terms]
  const double* terms;             // [n_terms][amplitude, frequency, phase][n_runs]
  const double* knots;             // [all knots of all tables][12], shared by the runs; null without tables
  const std::int64_t* first_knot;  // [n_runs] where the table of each run begins
  const std::int64_t* n_knots;     // [n_runs] 2 or more
  const std::int64_t* steps;       // [n_runs] steps to take
  const std::int64_t* stride;      // [n_runs] steps between samples
  const std::int64_t* thinning;    // [n_runs] samples between snapshots, 0 for none
  const double *x0, *v0;           // [n_runs][n_nodes][3]
  std::int64_t max_samples, max_snapshots;
  T* samples;                // [n_runs][max_samples][N_CHANNELS]
  float* snapshots;          // [n_runs][max_snapshots][n_nodes][3], world frame
  double *x1, *v1;           // [n_runs][n_nodes][3]
  std::int64_t* steps_done;  // [n_runs], fewer than asked where a run diverged
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
