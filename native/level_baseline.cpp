#include "block.hpp"

namespace plategait {
template void advance_block<Baseline, float>(const Batch<float>&, std::int64_t, Progress&);
template void advance_block<Baseline, double>(const Batch<double>&, std::int64_t, Progress&);
}  // namespace plategait
