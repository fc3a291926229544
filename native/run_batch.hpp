// The core's door for module.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "batch.hpp"

namespace plategait {

/// Instruction sets this processor and build can run, best first.
std::vector<std::string> available_levels();

/// Run a batch. `poll` is called from this thread about every 50 ms with the run-steps done so far; when it
/// returns false the batch stops. Returns whether it ran to the end. Throws std::bad_alloc where there is no memory for
/// a block, or for a single thread; where only some of the threads can be started, those do the work.
template <class T>
bool run_batch(const Batch<T>& batch, const std::string& level, int threads,
               const std::function<bool(std::int64_t)>& poll);

}  // namespace plategait
