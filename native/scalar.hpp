// Primitive operations on plain numbers, in the vocabulary that laws.hpp is written in.
//
// lanes.hpp offers the same vocabulary on SIMD packs; the laws never know which of the two they run on.
// A GPU thread advances one run with these.
#pragma once

#include "marker.hpp"

#if !defined(__CUDACC_RTC__)
#include <cmath>
#endif

namespace plategait {

/// What belongs to a number type: its element, its mask, its index, its wider companion for time and phase.
template <class R>
struct Traits;

template <>
struct Traits<float> {
  using Element = float;
  using Mask = bool;
  using Index = int;
  using Wide = double;
};

template <>
struct Traits<double> {
  using Element = double;
  using Mask = bool;
  using Index = int;
  using Wide = double;
};

template <class R>
using Element = typename Traits<R>::Element;
template <class R>
using Mask = typename Traits<R>::Mask;
template <class R>
using Index = typename Traits<R>::Index;
template <class R>
using Wide = typename Traits<R>::Wide;

PLATEGAIT_HD float select(bool condition, float yes, float no) { return condition ? yes : no; }
PLATEGAIT_HD double select(bool condition, double yes, double no) { return condition ? yes : no; }
PLATEGAIT_HD bool any_of(bool condition) { return condition; }
PLATEGAIT_HD float smaller(float a, float b) { return a < b ? a : b; }
PLATEGAIT_HD double smaller(double a, double b) { return a < b ? a : b; }
PLATEGAIT_HD float larger(float a, float b) { return a > b ? a : b; }
PLATEGAIT_HD double larger(double a, double b) { return a > b ? a : b; }
PLATEGAIT_HD float reciprocal_sqrt(float a) { return 1.0f / sqrtf(a); }
PLATEGAIT_HD double reciprocal_sqrt(double a) { return 1.0 / sqrt(a); }
PLATEGAIT_HD float fifth_root(float a) { return powf(a, 0.2f); }
PLATEGAIT_HD double fifth_root(double a) { return pow(a, 0.2); }
PLATEGAIT_HD double floor_of(double a) { return floor(a); }
PLATEGAIT_HD float narrow_to(double a, float) { return static_cast<float>(a); }
PLATEGAIT_HD double narrow_to(double a, double) { return a; }
PLATEGAIT_HD double widen(float a) { return a; }
PLATEGAIT_HD double widen(double a) { return a; }
PLATEGAIT_HD int index_of(double a) { return static_cast<int>(a); }

/// Row `index` of a table with `columns` numbers per row, at `column`. The last argument says which type is wanted.
template <class R>
PLATEGAIT_HD R look_up(const double* table, int index, int columns, int column, R) {
  return static_cast<R>(table[static_cast<long long>(index) * columns + column]);
}

}  // namespace plategait
