// Shares the blocks of a batch out over the cores, at the best instruction set that this processor has.
#include "batch.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "lanes.hpp"
#include "run_batch.hpp"

namespace plategait {

namespace {

template <class T>
struct Core {
  void (*advance)(const Batch<T>&, std::int64_t, Progress&);
  int lanes;
};

template <class Level, class T>
Core<T> core_for() {
  return {&advance_block<Level, T>, lanes_of<Level, T>};
}

template <class T>
Core<T> core_of(const std::string& level) {
#if defined(__x86_64__)
  if (level == "avx512") return core_for<Avx512, T>();
  if (level == "avx2") return core_for<Avx2, T>();
#endif
  if (level == "baseline") return core_for<Baseline, T>();
  throw std::invalid_argument("unknown instruction set '" + level + "'");
}

}  // namespace

std::vector<std::string> available_levels() {
  std::vector<std::string> levels;
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw"))
    levels.push_back("avx512");
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) levels.push_back("avx2");
#endif
  levels.push_back("baseline");
  return levels;
}

template <class T>
bool run_batch(const Batch<T>& batch, const std::string& level, int threads,
               const std::function<bool(std::int64_t)>& poll) {
  const Core<T> core = core_of<T>(level);
  const std::int64_t n_blocks = (batch.n_runs + core.lanes - 1) / core.lanes;
  Progress progress;
  std::atomic<std::int64_t> next{0};
  std::mutex mutex;
  std::condition_variable idle;
  std::exception_ptr failure;
  int busy = 0;
  const auto work = [&] {
    try {
      for (std::int64_t block; !progress.cancelled && (block = next.fetch_add(1)) < n_blocks;)
        core.advance(batch, block * core.lanes, progress);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
      progress.cancelled = true;
    }
    const std::lock_guard<std::mutex> lock(mutex);
    if (--busy == 0) idle.notify_one();
  };
  const int n_threads = static_cast<int>(threads < n_blocks ? threads : n_blocks);
  std::vector<std::jthread> pool;  // joined at the end of this function, however it ends
  pool.reserve(static_cast<std::size_t>(n_threads));
  std::unique_lock<std::mutex> lock(mutex);
  while (static_cast<int>(pool.size()) < n_threads) {
    try {
      pool.emplace_back(work);
      busy++;
    } catch (const std::exception&) {  // those that could be started do the work of all
      if (pool.empty()) throw std::bad_alloc();
      break;
    }
  }
  while (busy > 0) {
    idle.wait_for(lock, std::chrono::milliseconds(50), [&] { return busy == 0; });
    lock.unlock();
    if (!poll(progress.steps.load())) progress.cancelled = true;
    lock.lock();
  }
  if (failure) std::rethrow_exception(failure);
  return !progress.cancelled;
}

template bool run_batch<float>(const Batch<float>&, const std::string&, int, const std::function<bool(std::int64_t)>&);
template bool run_batch<double>(const Batch<double>&, const std::string&, int,
                                const std::function<bool(std::int64_t)>&);

}  // namespace plategait
