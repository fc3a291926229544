// The host/device marker: the only macro of the core, so that nvcc, NVRTC and a host compiler read the same laws.
#pragma once

#if defined(__CUDACC__)
#define PLATEGAIT_HD __host__ __device__ __forceinline__
#else
#define PLATEGAIT_HD inline __attribute__((always_inline))
#endif
