// A pack of numbers that advance side by side in one SIMD register: one lane, one run.
//
// Same vocabulary as scalar.hpp. Every operation acts on each lane alone, so a run gives the same bits
// whichever runs are its neighbours. The tag `Level` names the instruction set and keeps the code of each
// translation unit apart from the others'.
#pragma once

#include <cstdint>

#include "scalar.hpp"
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace plategait {

struct Baseline {
  static constexpr int bytes = 16;
};
struct Avx2 {
  static constexpr int bytes = 32;
};
struct Avx512 {
  static constexpr int bytes = 64;
};

template <class T, int W>
struct Vector {
  typedef T type __attribute__((vector_size(sizeof(T) * W)));
};

template <class T>
struct IntegerLike;
template <>
struct IntegerLike<float> {
  using type = std::int32_t;
};
template <>
struct IntegerLike<double> {
  using type = std::int64_t;
};

template <class T, int W, class Level>
struct Lanes;

template <class T, int W, class Level>
struct LaneMask {
  using Integer = typename IntegerLike<T>::type;
  using V = typename Vector<Integer, W>::type;
  V v;
  PLATEGAIT_HD friend LaneMask operator&(LaneMask a, LaneMask b) { return {a.v & b.v}; }
  PLATEGAIT_HD friend LaneMask operator|(LaneMask a, LaneMask b) { return {a.v | b.v}; }
  PLATEGAIT_HD friend LaneMask operator!(LaneMask a) { return {~a.v}; }
};

template <int W, class Level>
struct LaneIndex {
  using V = typename Vector<std::int32_t, W>::type;
  V v;
};

template <class T, int W, class Level>
struct Lanes {
  using V = typename Vector<T, W>::type;
  using M = LaneMask<T, W, Level>;
  V v;

  Lanes() = default;
  PLATEGAIT_HD Lanes(V vector) : v(vector) {}
  PLATEGAIT_HD Lanes(T scalar) : v(scalar - V{}) {}

  PLATEGAIT_HD friend Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
  PLATEGAIT_HD friend Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
  PLATEGAIT_HD friend Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
  PLATEGAIT_HD friend Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
  PLATEGAIT_HD friend Lanes operator-(Lanes a) { return -a.v; }
  PLATEGAIT_HD Lanes& operator+=(Lanes b) {
    v += b.v;
    return *this;
  }
  PLATEGAIT_HD Lanes& operator-=(Lanes b) {
    v -= b.v;
    return *this;
  }
  PLATEGAIT_HD friend M operator<(Lanes a, Lanes b) { return {a.v < b.v}; }
  PLATEGAIT_HD friend M operator>(Lanes a, Lanes b) { return {a.v > b.v}; }
};

template <class T, int W, class Level>
struct Traits<Lanes<T, W, Level>> {
  using Element = T;
  using Mask = LaneMask<T, W, Level>;
  using Index = LaneIndex<W, Level>;
  using Wide = Lanes<double, W, Level>;
};

template <class T, int W, class L>
PLATEGAIT_HD Lanes<T, W, L> select(LaneMask<T, W, L> m, Lanes<T, W, L> yes, Lanes<T, W, L> no) {
  return m.v ? yes.v : no.v;
}
/// Whether a condition holds in any lane.
template <class T, int W, class L>
PLATEGAIT_HD bool any_of(LaneMask<T, W, L> m) {
  typename LaneMask<T, W, L>::Integer any = 0;
  for (int q = 0; q < W; q++) any |= m.v[q];
  return any != 0;
}
template <class T, int W, class L>
PLATEGAIT_HD Lanes<T, W, L> smaller(Lanes<T, W, L> a, Lanes<T, W, L> b) {
  return a.v < b.v ? a.v : b.v;
}
template <class T, int W, class L>
PLATEGAIT_HD Lanes<T, W, L> larger(Lanes<T, W, L> a, Lanes<T, W, L> b) {
  return a.v > b.v ? a.v : b.v;
}

/// Hardware estimate of 1/√a, refined by one Newton step to float accuracy (2 units in the last place).
template <int W, class Level>
PLATEGAIT_HD Lanes<float, W, Level> reciprocal_sqrt(Lanes<float, W, Level> a) {
  using R = Lanes<float, W, Level>;
  R y;
#if defined(__AVX512F__)
  // Under a full mask, as gcc's plain form reads an undefined register and warns of it.
  if constexpr (W == 16) y.v = (typename R::V)_mm512_maskz_rsqrt14_ps(__mmask16(-1), (__m512)a.v);
#elif defined(__AVX__)
  if constexpr (W == 8) y.v = (typename R::V)_mm256_rsqrt_ps((__m256)a.v);
#elif defined(__SSE__)
  if constexpr (W == 4) y.v = (typename R::V)_mm_rsqrt_ps((__m128)a.v);
#elif defined(__wasm_simd128__)
  y.v = 1.0f / __builtin_elementwise_sqrt(a.v);  // no estimate there: rounded as it should be, and refined for nothing
#else
  for (int q = 0; q < W; q++) y.v[q] = 1.0f / std::sqrt(a.v[q]);
#endif
  return y * (R(1.5f) - R(0.5f) * a * y * y);
}
template <int W, class Level>
PLATEGAIT_HD Lanes<double, W, Level> reciprocal_sqrt(Lanes<double, W, Level> a) {
  Lanes<double, W, Level> y;
  for (int q = 0; q < W; q++) y.v[q] = 1.0 / std::sqrt(a.v[q]);
  return y;
}

/// a^(1/5) for a ≥ 0, from a^(-1/5): the exponent bits give a first guess within 4 %, and Newton's
/// r ← r (6 − a r⁵)/5 needs no division. Zero gives a tiny number instead of zero.
template <class T, int W, class Level>
PLATEGAIT_HD Lanes<T, W, Level> fifth_root(Lanes<T, W, Level> a) {
  using R = Lanes<T, W, Level>;
  using I = typename LaneMask<T, W, Level>::V;
  constexpr bool single = sizeof(T) == 4;
  a = larger(a, R(T(1e-30)));
  // 6/5 of the exponent bias, less the mean error of reading the mantissa as a logarithm.
  constexpr T bias = single ? T(1.2 * (127 - 0.0450466) * 8388608.0) : T(1.2 * (1023 - 0.0450466) * 4503599627370496.0);
  using V = typename R::V;
  const V bits = __builtin_convertvector((I)a.v, V);
  R r = V(__builtin_convertvector(bias - bits * T(0.2), I));
  for (int i = 0; i < (single ? 3 : 4); i++) {
    const R r2 = r * r;
    r = r * (R(T(1.2)) - R(T(0.2)) * a * r2 * r2 * r);
  }
  const R r2 = r * r;
  return a * r2 * r2;
}

template <int W, class L>
PLATEGAIT_HD Lanes<double, W, L> floor_of(Lanes<double, W, L> a) {
#if defined(__wasm_simd128__)
  return __builtin_elementwise_floor(a.v);
#else
  Lanes<double, W, L> y;
  for (int q = 0; q < W; q++) y.v[q] = std::floor(a.v[q]);
  return y;
#endif
}
template <class T, int W, class L>
PLATEGAIT_HD Lanes<T, W, L> narrow_to(Lanes<double, W, L> a, Lanes<T, W, L>) {
  return __builtin_convertvector(a.v, typename Lanes<T, W, L>::V);
}
template <class T, int W, class L>
PLATEGAIT_HD Lanes<double, W, L> widen(Lanes<T, W, L> a) {
  return __builtin_convertvector(a.v, typename Lanes<double, W, L>::V);
}
template <int W, class L>
PLATEGAIT_HD LaneIndex<W, L> index_of(Lanes<double, W, L> a) {
  return {__builtin_convertvector(a.v, typename LaneIndex<W, L>::V)};
}
/// Each lane looks into its own row of the one table that all share.
template <class T, int W, class L>
PLATEGAIT_HD Lanes<T, W, L> look_up(const double* table, LaneIndex<W, L> index, int columns, int column,
                                    Lanes<T, W, L>) {
  Lanes<T, W, L> y;
  for (int q = 0; q < W; q++) y.v[q] = static_cast<T>(table[static_cast<std::int64_t>(index.v[q]) * columns + column]);
  return y;
}

}  // namespace plategait
