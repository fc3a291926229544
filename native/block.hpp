// Advances one block of runs, a lane each, from start to end. Included by the level_*.cpp files only, and kept
// free of library templates: their code would be shared between files compiled for different processors.
#pragma once

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>

#include "batch.hpp"
#include "lanes.hpp"
#include "record.hpp"

namespace plategait {

/// There is no memory for a block: an exception, or a trap where there are none (a browser's module).
[[noreturn]] inline void no_memory() {
#if defined(__cpp_exceptions)
  throw std::bad_alloc();
#else
  __builtin_trap();
#endif
}

/// Aligned scratch memory of one block.
template <class R>
struct Scratch {
  R* data;
  explicit Scratch(std::size_t n)
      : data(static_cast<R*>(
            std::aligned_alloc(alignof(R) < 64 ? 64 : alignof(R), (n * sizeof(R) + 127) / 128 * 128 + 128))) {
    if (!data) no_memory();
    std::memset(static_cast<void*>(data), 0, n * sizeof(R));
  }
  ~Scratch() { std::free(data); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

/// Flush tiny numbers to zero while a block runs: a sheet at rest would otherwise crawl through denormals.
struct FlushDenormals {
#if defined(__SSE__)
  unsigned saved = _mm_getcsr();
  FlushDenormals() { _mm_setcsr(saved | 0x8040u); }
  ~FlushDenormals() { _mm_setcsr(saved); }
#endif
};

constexpr std::int64_t NODE_STEPS_BETWEEN_LOOKS = 20'000;

template <class Level, class T>
struct Block {
  static constexpr int W = lanes_of<Level, T>;
  using R = Lanes<T, W, Level>;
  using D = Lanes<double, W, Level>;

  const Batch<T>& batch;
  const std::int64_t first;
  const int used;  // lanes that carry a run; the others repeat the first and are thrown away
  const int n_nodes;
  Scratch<R> nodes, edge;
  Scratch<Term<R>> terms;
  Scratch<Layer<R>> layers;
  R parameter[N_PARAMETERS];
  D time_step, begun, time;
  Tally<R> tally{};
  State<R> state;
  Trajectory<R> trajectory;
  // Steps of this advance: taken, to take, when the last sample was taken and when the next one is.
  std::int64_t taken = 0, steps[W], seen[W], due[W];
  std::int64_t sampled[W], written[W], pictured[W];  // samples since the start and in this advance; snapshots
  bool running[W];

  Block(const Batch<T>& b, std::int64_t start)
      : batch(b),
        first(start),
        used(static_cast<int>(b.n_runs - start < W ? b.n_runs - start : W)),
        n_nodes(b.topology.n_nodes),
        nodes(9 * static_cast<std::size_t>(n_nodes)),
        edge(b.topology.features.plate_edge ? 6 * static_cast<std::size_t>(n_nodes) : 0),
        terms(static_cast<std::size_t>(b.n_terms)),
        layers(static_cast<std::size_t>(b.n_layers)),
        state{{nodes.data, 1},
              {nodes.data + 3 * n_nodes, 1},
              {nodes.data + 6 * n_nodes, 1},
              {edge.data, 1},
              {edge.data + 3 * n_nodes, 1}},
        trajectory{b.n_layers, b.layer_terms, b.term_dof, terms.data, layers.data, b.knots} {
    for (int q = 0; q < W; q++) load_run(q);
    lay_down(state, batch.topology, parameter, trajectory);
    for (int q = 0; q < W; q++) load_edge(q);
  }

  std::int64_t run_of(int q) const { return first + (q < used ? q : 0); }

  void load_run(int q) {
    const std::int64_t run = run_of(q), n = batch.n_runs;
    for (int p = 0; p < N_PARAMETERS; p++) parameter[p].v[q] = static_cast<T>(batch.parameters[p * n + run]);
    time_step.v[q] = batch.parameters[TIME_STEP * n + run];
    for (int j = 0; j < batch.n_terms; j++) {
      terms.data[j].amplitude.v[q] = static_cast<T>(batch.terms[(3 * j) * n + run]);
      terms.data[j].frequency.v[q] = batch.terms[(3 * j + 1) * n + run];
      terms.data[j].phase.v[q] = batch.terms[(3 * j + 2) * n + run];
    }
    for (int i = 0; i < batch.n_layers; i++) load_layer(i, q);
    for (int j = 0; j < 3 * n_nodes; j++) {
      state.x.data[j].v[q] = static_cast<T>(batch.x[run * 3 * n_nodes + j]);
      state.v.data[j].v[q] = static_cast<T>(batch.v[run * 3 * n_nodes + j]);
    }
    load_clock(q);
  }

  void load_layer(int i, int q) {
    const std::int64_t run = run_of(q), n = batch.n_runs;
    const double* numbers = batch.layers + i * N_LAYER_NUMBERS * n + run;
    Layer<R>& layer = layers.data[i];
    layer.begin.v[q] = numbers[BEGIN * n];
    layer.duration.v[q] = static_cast<T>(numbers[DURATION * n]);
    layer.table_begin.v[q] = numbers[TABLE_BEGIN * n];
    layer.table_step.v[q] = static_cast<T>(numbers[TABLE_STEP * n]);
    for (int d = 0; d < DEGREES_OF_FREEDOM; d++) layer.offset[d].v[q] = numbers[(OFFSET + d) * n];
    layer.first_knot.v[q] = batch.knots ? static_cast<double>(batch.first_knot[i * n + run]) : 0.0;
    layer.last_knot.v[q] = batch.knots ? static_cast<double>(batch.n_knots[i * n + run] - 1) : 1.0;
  }

  void load_clock(int q) {
    const std::int64_t run = run_of(q), *clock = batch.clock + run * N_CLOCKS;
    begun.v[q] = static_cast<double>(clock[TAKEN]);
    time.v[q] = time_step.v[q] * begun.v[q];
    seen[q] = clock[SEEN] - clock[TAKEN];
    due[q] = clock[DUE] - clock[TAKEN];
    sampled[q] = clock[SAMPLED];
    written[q] = pictured[q] = 0;
    steps[q] = batch.steps[run];
    running[q] = q < used && steps[q] > 0;
    for (int j = 0; j < N_TALLIES; j++) tallies()[j].v[q] = static_cast<T>(batch.tally[run * N_TALLIES + j]);
  }

  /// What the edge remembers of a sheet that is under way; of one that is laid down now it has just been told.
  void load_edge(int q) {
    const std::int64_t run = run_of(q);
    if (!batch.topology.features.plate_edge || batch.clock[run * N_CLOCKS + TAKEN] == 0) return;
    for (int j = 0; j < 3 * n_nodes; j++) edge.data[j].v[q] = static_cast<T>(batch.edge[run * 3 * n_nodes + j]);
  }

  R* tallies() { return &tally.left; }

  bool any_running() const {
    for (int q = 0; q < used; q++)
      if (running[q]) return true;
    return false;
  }

  std::int64_t next_stop() const {
    std::int64_t stop = -1;
    for (int q = 0; q < used; q++) {
      if (!running[q]) continue;
      const std::int64_t own = due[q] < steps[q] ? due[q] : steps[q];
      if (stop < 0 || own < stop) stop = own;
    }
    return stop;
  }

  /// The run of lane q ends here: keep its state, and what it shows now.
  void finish(int q, const R* channel) {
    running[q] = false;
    const std::int64_t run = run_of(q);
    for (int j = 0; j < 3 * n_nodes; j++) {
      batch.x[run * 3 * n_nodes + j] = static_cast<double>(state.x.data[j].v[q]);
      batch.v[run * 3 * n_nodes + j] = static_cast<double>(state.v.data[j].v[q]);
      if (batch.topology.features.plate_edge)
        batch.edge[run * 3 * n_nodes + j] = static_cast<double>(edge.data[j].v[q]);
    }
    for (int j = 0; j < N_TALLIES; j++) batch.tally[run * N_TALLIES + j] = static_cast<double>(tallies()[j].v[q]);
    for (int c = 0; c < N_CHANNELS; c++) batch.last[run * N_CHANNELS + c] = channel[c].v[q];
    std::int64_t* clock = batch.clock + run * N_CLOCKS;
    clock[SEEN] = clock[TAKEN] + seen[q];
    clock[DUE] = clock[TAKEN] + due[q];
    clock[TAKEN] += taken;
    clock[SAMPLED] = sampled[q];
  }

  void picture(int q) {
    const std::int64_t run = run_of(q);
    if (batch.thinning[run] <= 0 || (sampled[q] - 1) % batch.thinning[run] != 0 || pictured[q] >= batch.max_snapshots)
      return;
    float* out = batch.snapshots + (run * batch.max_snapshots + pictured[q]++) * 3 * n_nodes;
    for (int j = 0; j < 3 * n_nodes; j++) out[j] = static_cast<float>(state.x.data[j].v[q]);
  }

  /// Sample every lane that is due, and end those that are done or no longer finite.
  void sample() {
    R window;
    for (int q = 0; q < W; q++) window.v[q] = static_cast<T>(taken > seen[q] ? taken - seen[q] : 1);
    R channel[N_CHANNELS];
    record_sample(state, batch.topology, parameter, trajectory, time, window, tally, channel);
    for (int q = 0; q < used; q++) {
      if (!running[q]) continue;
      if (taken == due[q]) {
        const std::int64_t run = run_of(q);
        if (written[q] < batch.max_samples) {
          T* out = batch.samples + (run * batch.max_samples + written[q]) * N_CHANNELS;
          for (int c = 0; c < N_CHANNELS; c++) out[c] = channel[c].v[q];
        }
        written[q]++;
        sampled[q]++;
        picture(q);
        seen[q] = taken;
        due[q] = taken + batch.stride[run];
        clear_tally(q);
        // A sheet that moves faster than 1 km/s has diverged, whatever its numbers say later.
        const T speed2 = channel[KINETIC_ENERGY].v[q] / (T(0.5) * parameter[NODE_MASS].v[q] * n_nodes);
        if (!(speed2 < T(1e6))) finish(q, channel);
      }
      if (running[q] && taken == steps[q]) finish(q, channel);
    }
  }

  void clear_tally(int q) {
    R* const sums[] = {&tally.left,       &tally.right,        &tally.none,          &tally.nodes,
                       &tally.joint_loss, &tally.contact_work, &tally.friction_loss, &tally.plate_work};
    for (R* sum : sums) sum->v[q] = 0;
  }

  /// Time of the step that comes next.
  void look_at_clock() { time = time_step * (begun + D(static_cast<double>(taken))); }

  void run(Progress& progress) {
    [[maybe_unused]] const FlushDenormals guard;
    while (any_running()) {
      const std::int64_t stop = next_stop();
      while (taken < stop) {
        if (progress.cancelled.load(std::memory_order_relaxed)) return;
        advance_to(stop - taken > steps_between_looks() ? taken + steps_between_looks() : stop, progress);
      }
      look_at_clock();
      sample();
    }
  }

  /// Steps of about a millisecond: so often it is asked whether to go on, however far apart the samples.
  std::int64_t steps_between_looks() const {
    return n_nodes < NODE_STEPS_BETWEEN_LOOKS ? NODE_STEPS_BETWEEN_LOOKS / n_nodes : 1;
  }

  void advance_to(std::int64_t end, Progress& progress) {
    const std::int64_t from = taken;
    for (; taken < end; taken++) {
      look_at_clock();
      advance_one_step(state, batch.topology, parameter, trajectory, time, tally);
    }
    progress.steps.fetch_add((taken - from) * used, std::memory_order_relaxed);
  }
};

template <class Level, class T>
void advance_block(const Batch<T>& batch, std::int64_t first, Progress& progress) {
  Block<Level, T>(batch, first).run(progress);
}

}  // namespace plategait
