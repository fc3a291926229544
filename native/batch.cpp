// Shares the blocks of a batch out over the cores, at the best instruction set that this processor has.
#include "batch.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
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
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    levels.push_back("avx512");
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) levels.push_back("avx2");
#endif
  levels.push_back("baseline");
  return levels;
}

template <class T>
bool run_batch(const Batch<T>& batch, const std::string& level, int threads, const std::function<bool(std::int64_t)>& poll) {
  const Core<T> core = core_of<T>(level);
  const std::int64_t n_blocks = (batch.n_runs + core.lanes - 1) / core.lanes;
  Progress progress;
  std::atomic<std::int64_t> next{0};
  std::atomic<int> busy{0};
  std::mutex mutex;
  std::condition_variable idle;
  const auto work = [&] {
    for (std::int64_t block; (block = next.fetch_add(1)) < n_blocks && !progress.cancelled.load();)
      core.advance(batch, block * core.lanes, progress);
    const std::lock_guard<std::mutex> lock(mutex);
    if (--busy == 0) idle.notify_one();
  };
  const int n_threads = static_cast<int>(threads < n_blocks ? threads : n_blocks);
  std::vector<std::thread> pool;
  busy = n_threads;
  for (int i = 0; i < n_threads; i++) pool.emplace_back(work);
  {
    std::unique_lock<std::mutex> lock(mutex);
    while (busy > 0) {
      idle.wait_for(lock, std::chrono::milliseconds(50), [&] { return busy == 0; });
      lock.unlock();
      if (!poll(progress.steps.load())) progress.cancelled = true;
      lock.lock();
    }
  }
  for (std::thread& thread : pool) thread.join();
  return !progress.cancelled;
}

template bool run_batch<float>(const Batch<float>&, const std::string&, int, const std::function<bool(std::int64_t)>&);
template bool run_batch<double>(const Batch<double>&, const std::string&, int, const std::function<bool(std::int64_t)>&);

}  // namespace plategait
