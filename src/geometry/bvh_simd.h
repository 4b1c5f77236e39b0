// Four floats at once by the compilers' vector extension: one source for SSE, NEON and wasm (and plain code
// elsewhere). Eight at once are two fours, or one register where code is compiled for AVX2.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__x86_64__)
#include <immintrin.h>
#endif
// The AddressSanitizer's build goes without, so that its tests run what machines without AVX2 run.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define ANAMORPH_HAS_AVX2_CODE 1
#define ANAMORPH_AVX2 __attribute__((target("avx2,bmi,bmi2,lzcnt")))
#endif

#define ANAMORPH_ALWAYS_INLINE inline __attribute__((always_inline))

namespace anamorph {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

ANAMORPH_ALWAYS_INLINE Float4 broadcast(float value) {
  return Float4{value, value, value, value};
}
ANAMORPH_ALWAYS_INLINE Float4 minimum(Float4 a, Float4 b) {
  return a < b ? a : b;
}
ANAMORPH_ALWAYS_INLINE Float4 maximum(Float4 a, Float4 b) {
  return a > b ? a : b;
}

/// `from` must be aligned to 16 bytes, as `to` below.
ANAMORPH_ALWAYS_INLINE Float4 load(const float* from) {
  Float4 value;
  std::memcpy(&value, __builtin_assume_aligned(from, 16), sizeof value);
  return value;
}

ANAMORPH_ALWAYS_INLINE void store(float* to, Float4 value) {
  std::memcpy(__builtin_assume_aligned(to, 16), &value, sizeof value);
}

/// Bit i is set where lane i of a comparison holds.
ANAMORPH_ALWAYS_INLINE unsigned laneMask(Int4 comparison) {
#if defined(__x86_64__)
  return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(comparison)));
#else
  const Int4 bits = comparison & Int4{1, 2, 4, 8};
  return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

/// Eight floats on every machine.
struct FloatPair {
  Float4 low, high;

  static ANAMORPH_ALWAYS_INLINE FloatPair splat(float value) { return {broadcast(value), broadcast(value)}; }
  static ANAMORPH_ALWAYS_INLINE FloatPair load(const float* from) {
    return {anamorph::load(from), anamorph::load(from + 4)};
  }
  ANAMORPH_ALWAYS_INLINE void store(float* to) const {
    anamorph::store(to, low);
    anamorph::store(to + 4, high);
  }
  friend ANAMORPH_ALWAYS_INLINE FloatPair operator-(FloatPair a, FloatPair b) {
    return {a.low - b.low, a.high - b.high};
  }
  friend ANAMORPH_ALWAYS_INLINE FloatPair operator*(FloatPair a, FloatPair b) {
    return {a.low * b.low, a.high * b.high};
  }
  friend ANAMORPH_ALWAYS_INLINE FloatPair minimum(FloatPair a, FloatPair b) {
    return {minimum(a.low, b.low), minimum(a.high, b.high)};
  }
  friend ANAMORPH_ALWAYS_INLINE FloatPair maximum(FloatPair a, FloatPair b) {
    return {maximum(a.low, b.low), maximum(a.high, b.high)};
  }
  /// Bit i is set where lane i of a is <= that of b.
  friend ANAMORPH_ALWAYS_INLINE unsigned lessEqualMask(FloatPair a, FloatPair b) {
    return laneMask(a.low <= b.low) | laneMask(a.high <= b.high) << 4;
  }
};

#if defined(ANAMORPH_HAS_AVX2_CODE)

/// The same in one register. Every function that touches it must be compiled for AVX2.
struct Float8 {
  __m256 lanes;

  ANAMORPH_AVX2 static ANAMORPH_ALWAYS_INLINE Float8 splat(float value) { return {_mm256_set1_ps(value)}; }
  ANAMORPH_AVX2 static ANAMORPH_ALWAYS_INLINE Float8 load(const float* from) {
    return {_mm256_load_ps(from)};
  }
  ANAMORPH_AVX2 ANAMORPH_ALWAYS_INLINE void store(float* to) const { _mm256_store_ps(to, lanes); }

  ANAMORPH_AVX2 friend ANAMORPH_ALWAYS_INLINE Float8 operator-(Float8 a, Float8 b) {
    return {_mm256_sub_ps(a.lanes, b.lanes)};
  }
  ANAMORPH_AVX2 friend ANAMORPH_ALWAYS_INLINE Float8 operator*(Float8 a, Float8 b) {
    return {_mm256_mul_ps(a.lanes, b.lanes)};
  }
  ANAMORPH_AVX2 friend ANAMORPH_ALWAYS_INLINE Float8 minimum(Float8 a, Float8 b) {
    return {_mm256_min_ps(a.lanes, b.lanes)};
  }
  ANAMORPH_AVX2 friend ANAMORPH_ALWAYS_INLINE Float8 maximum(Float8 a, Float8 b) {
    return {_mm256_max_ps(a.lanes, b.lanes)};
  }
  ANAMORPH_AVX2 friend ANAMORPH_ALWAYS_INLINE unsigned lessEqualMask(Float8 a, Float8 b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.lanes, b.lanes, _CMP_LE_OQ)));
  }
};

#endif

}  // namespace anamorph
