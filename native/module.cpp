// The native module: arrays in, arrays out. Shapes are checked here, meaning in Python.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <vector>

#include "run_batch.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using plategait::Batch;

namespace {

template <class T>
using Array = nb::ndarray<const T, nb::c_contig, nb::device::cpu>;
template <class T>
using Output = nb::ndarray<T, nb::c_contig, nb::device::cpu>;

template <class A>
auto pointer(const A& array, std::size_t size, const char* name) {
  if (array.size() != size)
    throw nb::value_error((std::string(name) + " has " + std::to_string(array.size()) + " numbers, not " + std::to_string(size)).c_str());
  return array.data();
}

/// Run one batch at the precision of `samples`. Raises KeyboardInterrupt (or what `progress` raises) midway.
template <class T>
void advance(Array<int> line_start, Array<int> line_nodes, int n_axial_lines, Array<int> cells, Array<double> rest,
             Array<double> mobility, std::vector<bool> features, Array<double> parameters, Array<int> term_dof, Array<double> terms,
             Array<double> table, Array<std::int64_t> steps, Array<std::int64_t> stride, Array<std::int64_t> thinning,
             Array<double> x0, Array<double> v0, Output<T> samples, Output<float> snapshots, Output<double> x1,
             Output<double> v1, Output<std::int64_t> steps_done, const std::string& level, int threads, nb::object progress) {
  const std::size_t n_nodes = mobility.size(), n_runs = steps.size(), n_terms = term_dof.size();
  if (n_nodes == 0 || n_runs == 0) throw nb::value_error("an empty batch");
  const std::size_t n_lines = line_start.size() - 1, vectors = n_runs * n_nodes * 3;
  for (std::size_t j = 0; j < line_nodes.size(); j++)
    if (line_nodes.data()[j] < 0 || static_cast<std::size_t>(line_nodes.data()[j]) >= n_nodes) throw nb::value_error("line_nodes out of range");
  for (std::size_t j = 0; j < cells.size(); j++)
    if (cells.data()[j] < 0 || static_cast<std::size_t>(cells.data()[j]) >= n_nodes) throw nb::value_error("cells out of range");
  for (std::size_t j = 0; j < n_terms; j++)
    if (term_dof.data()[j] < 0 || term_dof.data()[j] >= plategait::DEGREES_OF_FREEDOM) throw nb::value_error("term_dof out of range");
  for (std::size_t j = 0; j < n_runs; j++)
    if (stride.data()[j] < 1) throw nb::value_error("stride below 1");
  if (static_cast<std::size_t>(line_start.data()[n_lines]) != line_nodes.size()) throw nb::value_error("line_start does not cover line_nodes");
  const std::size_t n_knots = table.size() / (12 * n_runs);
  Batch<T> batch{};
  batch.topology = {static_cast<int>(n_nodes), static_cast<int>(n_lines), n_axial_lines, static_cast<int>(cells.size() / 4),
                    line_start.data(), line_nodes.data(), cells.data(), pointer(rest, 2 * n_nodes, "rest"), mobility.data(), {features.at(0), features.at(1), features.at(2), features.at(3)}};
  batch.n_runs = static_cast<std::int64_t>(n_runs);
  batch.parameters = pointer(parameters, plategait::N_PARAMETERS * n_runs, "parameters");
  batch.n_terms = static_cast<int>(n_terms);
  batch.term_dof = term_dof.data();
  batch.terms = pointer(terms, 3 * n_terms * n_runs, "terms");
  batch.n_knots = static_cast<int>(n_knots);
  batch.table = pointer(table, 12 * n_knots * n_runs, "table");
  batch.steps = steps.data();
  batch.stride = pointer(stride, n_runs, "stride");
  batch.thinning = pointer(thinning, n_runs, "thinning");
  batch.x0 = pointer(x0, vectors, "x0");
  batch.v0 = pointer(v0, vectors, "v0");
  batch.max_samples = static_cast<std::int64_t>(samples.size() / (n_runs * plategait::N_CHANNELS));
  batch.max_snapshots = static_cast<std::int64_t>(snapshots.size() / vectors);
  batch.samples = samples.data();
  batch.snapshots = snapshots.data();
  batch.x1 = pointer(x1, vectors, "x1");
  batch.v1 = pointer(v1, vectors, "v1");
  batch.steps_done = pointer(steps_done, n_runs, "steps_done");

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
  const bool finished = plategait::run_batch(batch, level, threads, poll);
  nb::gil_scoped_acquire acquire;
  if (!finished) throw nb::python_error();
}

template <class T, class Module>
void define_advance(Module& module, const char* name) {
  module.def(name, &advance<T>, "line_start"_a, "line_nodes"_a, "n_axial_lines"_a, "cells"_a, "rest"_a, "mobility"_a, "features"_a,
             "parameters"_a, "term_dof"_a, "terms"_a, "table"_a, "steps"_a, "stride"_a, "thinning"_a, "x0"_a, "v0"_a, "samples"_a,
             "snapshots"_a, "x1"_a, "v1"_a, "steps_done"_a, "level"_a, "threads"_a, "progress"_a.none());
}

}  // namespace

NB_MODULE(_native, module) {
  module.doc() = "The core: advances batches of sheets on vibrating plates, side by side in SIMD lanes.";
  define_advance<float>(module, "advance_float32");
  define_advance<double>(module, "advance_float64");
  module.def("available_levels", &plategait::available_levels, "Instruction sets this processor can run, best first.");
  module.attr("PARAMETERS") = nb::cast(std::vector<std::string>(std::begin(plategait::parameter_names), std::end(plategait::parameter_names)));
  module.attr("CHANNELS") = nb::cast(std::vector<std::string>(std::begin(plategait::channel_names), std::end(plategait::channel_names)));
}
