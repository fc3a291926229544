// The native module: arrays in, arrays out. Shapes and ranges are checked here, so that no call can reach outside an
// array; meaning is checked in Python.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <string>
#include <vector>

#include "run_batch.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using plategait::Batch;
using plategait::Topology;

namespace {

template <class T>
using Array = nb::ndarray<const T, nb::c_contig, nb::device::cpu>;
template <class T>
using Output = nb::ndarray<T, nb::c_contig, nb::device::cpu>;

// Node vectors are addressed by an int.
constexpr std::size_t MOST_NODES = INT_MAX / 9;
// Steps of a run and between its samples: sums of two stay within the type, and within what a double counts.
constexpr std::int64_t LONGEST = std::int64_t{1} << 52;

[[noreturn]] void refuse(const std::string& what) { throw nb::value_error(what.c_str()); }

template <class A>
auto sized(const A& array, std::size_t size, const char* name) {
  if (array.size() != size)
    refuse(std::string(name) + " has " + std::to_string(array.size()) + " numbers, not " + std::to_string(size));
  return array.data();
}

/// Rows of `row` numbers each that an array holds.
template <class A>
std::size_t rows_of(const A& array, std::size_t row, const char* name) {
  if (array.size() % row != 0) refuse(std::string(name) + " is no multiple of " + std::to_string(row) + " numbers");
  return array.size() / row;
}

/// Numbers that all lie in [low, high).
template <class A>
auto within(const A& array, std::int64_t low, std::int64_t high, const char* name) {
  for (std::size_t j = 0; j < array.size(); j++)
    if (array.data()[j] < low || array.data()[j] >= high) refuse(std::string(name) + " out of range");
  return array.data();
}

const double* finite(const Array<double>& array, const char* name) {
  for (std::size_t j = 0; j < array.size(); j++)
    if (!std::isfinite(array.data()[j])) refuse(std::string(name) + " not finite");
  return array.data();
}

/// A parameter that the core divides by.
void check_positive(const double* parameters, int which, std::size_t n_runs) {
  for (std::size_t j = 0; j < n_runs; j++)
    if (!(parameters[static_cast<std::size_t>(which) * n_runs + j] > 0))
      refuse(std::string(plategait::parameter_names[which]) + " not above 0");
}

Topology topology_of(const Array<int>& line_start, const Array<int>& line_nodes, int n_axial_lines,
                     const Array<int>& cells, const Array<double>& rest, const Array<double>& mobility,
                     const std::vector<bool>& features) {
  const std::size_t n_nodes = mobility.size();
  if (n_nodes == 0 || n_nodes > MOST_NODES) refuse("no nodes, or too many");
  if (line_start.size() == 0 || line_start.size() > INT_MAX || line_nodes.size() > INT_MAX)
    refuse("line_start is empty, or too long");
  const int n_lines = static_cast<int>(line_start.size() - 1), last = static_cast<int>(line_nodes.size());
  const int* start = line_start.data();
  if (start[0] != 0 || start[n_lines] != last) refuse("line_start does not cover line_nodes");
  for (int i = 0; i < n_lines; i++)
    if (start[i] >= start[i + 1]) refuse("line_start does not rise");
  if (n_axial_lines < 0 || n_axial_lines > n_lines) refuse("n_axial_lines out of range");
  const std::size_t n_cells = rows_of(cells, 4, "cells");
  if (cells.size() > INT_MAX) refuse("too many cells");
  if (features.size() != 4) refuse("features has " + std::to_string(features.size()) + " entries, not 4");
  const auto nodes = static_cast<std::int64_t>(n_nodes);
  sized(rest, 2 * n_nodes, "rest");
  return {static_cast<int>(n_nodes),
          n_lines,
          n_axial_lines,
          static_cast<int>(n_cells),
          start,
          within(line_nodes, 0, nodes, "line_nodes"),
          within(cells, 0, nodes, "cells"),
          finite(rest, "rest"),
          finite(mobility, "mobility"),
          {features[0], features[1], features[2], features[3]}};
}

/// A table that begins before the run's clock, with knots apart: what is looked up lies in it.
template <class T>
void check_table_time(const Batch<T>& batch, std::size_t layer, std::size_t run) {
  const auto n = static_cast<std::size_t>(batch.n_runs);
  const double* numbers = batch.layers + layer * plategait::N_LAYER_NUMBERS * n + run;
  if (!(numbers[plategait::TABLE_STEP * n] > 0)) refuse("table_step not above 0");
  const double now = static_cast<double>(batch.clock[run * plategait::N_CLOCKS + plategait::TAKEN]) *
                     batch.parameters[plategait::TIME_STEP * n + run];
  if (!(numbers[plategait::TABLE_BEGIN * n] <= now)) refuse("table_begin after now");
}

/// Put the plate's course into the batch: its layers, their terms, and where among the shared knots each has its table.
template <class T>
void share_course(Batch<T>& batch, const Array<int>& layer_terms, const Array<int>& term_dof,
                  const Array<double>& terms, const Array<double>& layers, const Array<double>& knots,
                  const Array<std::int64_t>& first_knot, const Array<std::int64_t>& n_knots) {
  const auto n_runs = static_cast<std::size_t>(batch.n_runs);
  const std::size_t n_terms = term_dof.size(), rows = rows_of(knots, 12, "knots");
  if (layer_terms.size() < 2 || layer_terms.size() > INT_MAX) refuse("no layers, or too many");
  if (n_terms > INT_MAX / 3) refuse("too many terms");
  const std::size_t n_layers = layer_terms.size() - 1;
  const int* begins = within(layer_terms, 0, static_cast<std::int64_t>(n_terms) + 1, "layer_terms");
  if (begins[0] != 0 || begins[n_layers] != static_cast<int>(n_terms)) refuse("layer_terms does not cover terms");
  if (!std::is_sorted(begins, begins + n_layers + 1)) refuse("layer_terms falls");
  sized(terms, 3 * n_terms * n_runs, "terms");
  sized(layers, n_layers * plategait::N_LAYER_NUMBERS * n_runs, "layers");
  batch.n_layers = static_cast<int>(n_layers);
  batch.n_terms = static_cast<int>(n_terms);
  batch.layer_terms = begins;
  batch.term_dof = within(term_dof, 0, plategait::DEGREES_OF_FREEDOM, "term_dof");
  batch.terms = finite(terms, "terms");
  batch.layers = finite(layers, "layers");
  if (rows == 0) return;
  const std::size_t tables = n_layers * n_runs, most = std::min<std::size_t>(rows, INT_MAX);
  sized(first_knot, tables, "first_knot");
  sized(n_knots, tables, "n_knots");
  within(first_knot, 0, static_cast<std::int64_t>(most), "first_knot");
  within(n_knots, 2, static_cast<std::int64_t>(most) + 1, "n_knots");
  for (std::size_t j = 0; j < tables; j++)
    if (first_knot.data()[j] + n_knots.data()[j] > static_cast<std::int64_t>(most))
      refuse("n_knots past the end of knots");
  for (std::size_t i = 0; i < n_layers; i++)
    for (std::size_t j = 0; j < n_runs; j++) check_table_time(batch, i, j);
  batch.knots = finite(knots, "knots");
  batch.first_knot = first_knot.data();
  batch.n_knots = n_knots.data();
}

void check_target(const std::string& level, int threads) {
  if (threads < 1) refuse("threads below 1");
  const std::vector<std::string> levels = plategait::available_levels();
  if (std::find(levels.begin(), levels.end(), level) == levels.end()) refuse("level unknown, or not of this processor");
}

template <class T>
bool run_while_wanted(const Batch<T>& batch, const std::string& level, int threads, const nb::object& progress) {
  bool failed = false;
  nb::gil_scoped_release release;
  const auto poll = [&](std::int64_t done) {
    nb::gil_scoped_acquire acquire;
    if (!failed && PyErr_CheckSignals() != 0) failed = true;
    if (!failed && !progress.is_none()) {
      PyObject* answer = PyObject_CallFunction(progress.ptr(), "L", static_cast<long long>(done));
      failed = answer == nullptr;
      Py_XDECREF(answer);
    }
    return !failed;
  };
  return plategait::run_batch(batch, level, threads, poll);
}

/// Clocks that count up, and no further than the type.
void check_clock(const std::int64_t* clock, const std::int64_t* steps, std::size_t n_runs) {
  for (std::size_t j = 0; j < n_runs; j++, clock += plategait::N_CLOCKS) {
    const std::int64_t taken = clock[plategait::TAKEN], seen = clock[plategait::SEEN], due = clock[plategait::DUE];
    if (seen > taken || due < taken || (taken > 0 && due == taken))
      refuse("clock: a sample is not due when it should be");
    if (taken + steps[j] > LONGEST) refuse("steps past the longest run");
  }
}

/// Nodes of runs that begin, finite: what a run under way has come to is its own.
void check_start(const double* vectors, std::size_t per_run, const std::int64_t* clock, std::size_t n_runs,
                 const char* name) {
  for (std::size_t j = 0; j < n_runs; j++)
    for (std::size_t k = 0; k < per_run && clock[j * plategait::N_CLOCKS + plategait::TAKEN] == 0; k++)
      if (!std::isfinite(vectors[j * per_run + k])) refuse(std::string(name) + " not finite");
}

/// Advance one batch at the precision of `samples`, from where x, v, edge, tally and clock say that it is, to where
/// they then say. Raises KeyboardInterrupt (or what `progress` raises) midway, ValueError for arrays that do not belong
/// together, MemoryError where the core finds no memory.
template <class T>
void advance(Array<int> line_start, Array<int> line_nodes, int n_axial_lines, Array<int> cells, Array<double> rest,
             Array<double> mobility, std::vector<bool> features, Array<double> parameters, Array<int> layer_terms,
             Array<int> term_dof, Array<double> terms, Array<double> layers, Array<double> knots,
             Array<std::int64_t> first_knot, Array<std::int64_t> n_knots, Array<std::int64_t> steps,
             Array<std::int64_t> stride, Array<std::int64_t> thinning, Output<double> x, Output<double> v,
             Output<double> edge, Output<double> tally, Output<std::int64_t> clock, Output<T> samples,
             Output<float> snapshots, Output<T> last, const std::string& level, int threads, nb::object progress) {
  Batch<T> batch{};
  batch.topology = topology_of(line_start, line_nodes, n_axial_lines, cells, rest, mobility, features);
  const std::size_t n_runs = steps.size(), per_run = mobility.size() * 3, vectors = n_runs * per_run;
  if (n_runs == 0) refuse("no runs");
  sized(parameters, plategait::N_PARAMETERS * n_runs, "parameters");
  sized(stride, n_runs, "stride");
  sized(thinning, n_runs, "thinning");
  batch.n_runs = static_cast<std::int64_t>(n_runs);
  batch.parameters = finite(parameters, "parameters");
  check_positive(batch.parameters, plategait::TIME_STEP, n_runs);
  batch.steps = within(steps, 0, LONGEST, "steps");
  batch.stride = within(stride, 1, LONGEST, "stride");
  batch.thinning = within(thinning, 0, INT64_MAX, "thinning");
  batch.x = sized(x, vectors, "x");
  batch.v = sized(v, vectors, "v");
  batch.edge = sized(edge, batch.topology.features.plate_edge ? vectors : 0, "edge");
  batch.tally = sized(tally, n_runs * plategait::N_TALLIES, "tally");
  sized(clock, n_runs * plategait::N_CLOCKS, "clock");
  batch.clock = const_cast<std::int64_t*>(within(clock, 0, 2 * LONGEST, "clock"));
  check_clock(batch.clock, batch.steps, n_runs);
  check_start(batch.x, per_run, batch.clock, n_runs, "x");
  check_start(batch.v, per_run, batch.clock, n_runs, "v");
  share_course(batch, layer_terms, term_dof, terms, layers, knots, first_knot, n_knots);
  batch.max_samples = static_cast<std::int64_t>(rows_of(samples, n_runs * plategait::N_CHANNELS, "samples"));
  batch.max_snapshots = static_cast<std::int64_t>(rows_of(snapshots, vectors, "snapshots"));
  batch.samples = samples.data();
  batch.snapshots = snapshots.data();
  batch.last = sized(last, n_runs * plategait::N_CHANNELS, "last");
  check_target(level, threads);
  if (!run_while_wanted(batch, level, threads, progress)) throw nb::python_error();
}

template <class T, class Module>
void define_advance(Module& module, const char* name) {
  // An output of another type or layout would be filled in a copy, and lost: it is refused.
  module.def(name, &advance<T>, "line_start"_a, "line_nodes"_a, "n_axial_lines"_a, "cells"_a, "rest"_a, "mobility"_a,
             "features"_a, "parameters"_a, "layer_terms"_a, "term_dof"_a, "terms"_a, "layers"_a, "knots"_a,
             "first_knot"_a, "n_knots"_a, "steps"_a, "stride"_a, "thinning"_a, "x"_a.noconvert(), "v"_a.noconvert(),
             "edge"_a.noconvert(), "tally"_a.noconvert(), "clock"_a.noconvert(), "samples"_a.noconvert(),
             "snapshots"_a.noconvert(), "last"_a.noconvert(), "level"_a, "threads"_a, "progress"_a.none());
}

}  // namespace

NB_MODULE(_native, module) {
  module.doc() = "The core: advances batches of sheets on vibrating plates, side by side in SIMD lanes.";
  define_advance<float>(module, "advance_float32");
  define_advance<double>(module, "advance_float64");
  module.def("available_levels", &plategait::available_levels, "Instruction sets this processor can run, best first.");
  module.attr("PARAMETERS") =
      nb::cast(std::vector<std::string>(std::begin(plategait::parameter_names), std::end(plategait::parameter_names)));
  module.attr("LAYER") =
      nb::cast(std::vector<std::string>(std::begin(plategait::layer_names), std::end(plategait::layer_names)));
  module.attr("N_TALLIES") = plategait::N_TALLIES;
  module.attr("N_CLOCKS") = static_cast<int>(plategait::N_CLOCKS);
  module.attr("CHANNELS") =
      nb::cast(std::vector<std::string>(std::begin(plategait::channel_names), std::end(plategait::channel_names)));
}
