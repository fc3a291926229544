#include "block.hpp"

namespace plategait {
template void advance_block<Avx2, float>(const Batch<float>&, std::int64_t, Progress&);
template void advance_block<Avx2, double>(const Batch<double>&, std::int64_t, Progress&);
}  // namespace plategait
