// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <type_traits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#if defined(__GNUC__)
#define TORSOR_SIMD_INLINED inline __attribute__((always_inline))
#define TORSOR_SIMD_OUTLINED __attribute__((noinline, cold))
#else
#define TORSOR_SIMD_INLINED inline
#define TORSOR_SIMD_OUTLINED
#endif
#if defined(__clang__) && __clang_major__ >= 13  // sines need sums that are not reassociated, see TORSOR_AS_WRITTEN of headers
#define TORSOR_SIMD_AS_WRITTEN _Pragma("clang fp reassociate(off)")
#else
#define TORSOR_SIMD_AS_WRITTEN
#endif

namespace torsor::runtime {

/// What a source file is compiled for. It is part of every pack's type, so that functions compiled with other options,
/// whose packs travel in other registers, are other functions.
enum class InstructionSet : int { portable, avx, avx2, avx512 };

#if defined(__AVX512F__)
constexpr InstructionSet compiled_for = InstructionSet::avx512;
constexpr int vector_bytes = 64;
#elif defined(__AVX2__)
constexpr InstructionSet compiled_for = InstructionSet::avx2;
constexpr int vector_bytes = 32;
#elif defined(__AVX__)
constexpr InstructionSet compiled_for = InstructionSet::avx;
constexpr int vector_bytes = 32;
#else
constexpr InstructionSet compiled_for = InstructionSet::portable;
constexpr int vector_bytes = 16;
#endif

/// Numbers that one vector register holds: 4 doubles or 8 floats with AVX2, 8 or 16 with AVX-512, else 2 or 4.
template <class Number>
constexpr int native_lanes = vector_bytes / static_cast<int>(sizeof(Number));

namespace detail {

/// Lanes in a vector register where there is one of just that size, else in an array.
template <class Number, int lanes, bool in_register>
struct LaneStorage {
  struct Numbers {
    Number lane[lanes];
    constexpr Number& operator[](int i) noexcept { return lane[i]; }
    constexpr const Number& operator[](int i) const noexcept { return lane[i]; }
  };
  struct Flags {
    bool lane[lanes];
    constexpr bool& operator[](int i) noexcept { return lane[i]; }
    constexpr const bool& operator[](int i) const noexcept { return lane[i]; }
  };
};
#if defined(__GNUC__) && !defined(__CUDACC__)
template <class Number, int lanes>
struct LaneStorage<Number, lanes, true> {
  typedef Number Numbers __attribute__((vector_size(lanes * sizeof(Number))));
  using Flags = decltype(Numbers{} < Numbers{});  // integers, all bits set where it holds
};
#endif

constexpr bool fits_register([[maybe_unused]] int bytes) noexcept {
#if defined(__GNUC__) && !defined(__CUDACC__)
  return bytes >= 8 && bytes <= vector_bytes && (bytes & (bytes - 1)) == 0;
#else
  return false;
#endif
}

}  // namespace detail

/// One scalar for several states at once, a state in each lane: `Mechanism<Simd<double, 4>>` runs the kernels of a
/// generated header on four states. Operations are those of Number, lane by lane, with the same roundings.
template <class Number, int lane_count, InstructionSet instructions = compiled_for>
class Simd {
  static_assert(std::is_same<Number, float>::value || std::is_same<Number, double>::value, "lanes are float or double");
  static_assert(lane_count > 0, "a pack has at least one lane");

 public:
  using Lane = Number;
  static constexpr int lanes = lane_count;
  static constexpr bool in_register = detail::fits_register(lane_count * static_cast<int>(sizeof(Number)));

 private:
  using Storage = detail::LaneStorage<Number, lane_count, in_register>;

 public:
  using Numbers = typename Storage::Numbers;  ///< the vector type of a register, or an array

  /// What a comparison says, lane by lane. It is true when it holds in all lanes.
  class Mask {
   public:
    [[nodiscard]] TORSOR_SIMD_INLINED bool operator[](int lane) const noexcept { return flags_[lane] != 0; }
    [[nodiscard]] TORSOR_SIMD_INLINED explicit operator bool() const noexcept { return all(*this); }
    // Both sides are always evaluated: a branch would cost more than a comparison.
    [[nodiscard]] friend TORSOR_SIMD_INLINED Mask operator&&(const Mask& a, const Mask& b) noexcept {
      Mask both;
      if constexpr (in_register) {
        both.flags_ = a.flags_ & b.flags_;
      } else {
        for (int i = 0; i < lanes; ++i) both.flags_[i] = a.flags_[i] && b.flags_[i];
      }
      return both;
    }
    /// Lane by lane; !mask is another question, whether some lane lacks it.
    [[nodiscard]] friend TORSOR_SIMD_INLINED Mask opposite(const Mask& a) noexcept {
      Mask other;
      if constexpr (in_register) {
        other.flags_ = ~a.flags_;
      } else {
        for (int i = 0; i < lanes; ++i) other.flags_[i] = !a.flags_[i];
      }
      return other;
    }
    [[nodiscard]] friend TORSOR_SIMD_INLINED bool all(const Mask& mask) noexcept {
#if defined(__AVX512F__)
      if constexpr (in_register && sizeof(mask.flags_) == 64) {
        constexpr int every = static_cast<int>((1U << lanes) - 1U);
        if constexpr (sizeof(Number) == 8)
          return _mm512_cmpneq_epi64_mask((__m512i)mask.flags_, _mm512_setzero_si512()) == every;
        else
          return _mm512_cmpneq_epi32_mask((__m512i)mask.flags_, _mm512_setzero_si512()) == every;
      }
#endif
#if defined(__AVX__)
      if constexpr (in_register && sizeof(mask.flags_) == 32) {
        if constexpr (sizeof(Number) == 8) return _mm256_movemask_pd((__m256d)mask.flags_) == 15;
        return _mm256_movemask_ps((__m256)mask.flags_) == 255;
      }
#endif
#if defined(__SSE2__)
      if constexpr (in_register && sizeof(mask.flags_) == 16) {
        if constexpr (sizeof(Number) == 8) return _mm_movemask_pd((__m128d)mask.flags_) == 3;
        return _mm_movemask_ps((__m128)mask.flags_) == 15;
      }
#endif
      bool holds = true;
      for (int i = 0; i < lanes; ++i) holds = holds && mask.flags_[i] != 0;
      return holds;
    }

   private:
    friend class Simd;
    typename Storage::Flags flags_;
  };

  Simd() = default;
  /// The same in all lanes.
  TORSOR_SIMD_INLINED explicit Simd(Number value) noexcept {
    for (int i = 0; i < lanes; ++i) values_[i] = value;
  }
  [[nodiscard]] TORSOR_SIMD_INLINED Number operator[](int lane) const noexcept { return values_[lane]; }
  TORSOR_SIMD_INLINED void set(int lane, Number value) noexcept { values_[lane] = value; }

  [[nodiscard]] friend TORSOR_SIMD_INLINED Simd operator+(const Simd& a, const Simd& b) noexcept {
    TORSOR_SIMD_AS_WRITTEN
    Simd result;
    if constexpr (in_register) {
      result.values_ = a.values_ + b.values_;
    } else {
      for (int i = 0; i < lanes; ++i) result.values_[i] = a.values_[i] + b.values_[i];
    }
    return result;
  }
  [[nodiscard]] friend TORSOR_SIMD_INLINED Simd operator-(const Simd& a, const Simd& b) noexcept {
    TORSOR_SIMD_AS_WRITTEN
    Simd result;
    if constexpr (in_register) {
      result.values_ = a.values_ - b.values_;
    } else {
      for (int i = 0; i < lanes; ++i) result.values_[i] = a.values_[i] - b.values_[i];
    }
    return result;
  }
  [[nodiscard]] friend TORSOR_SIMD_INLINED Simd operator*(const Simd& a, const Simd& b) noexcept {
    TORSOR_SIMD_AS_WRITTEN
    Simd result;
    if constexpr (in_register) {
      result.values_ = a.values_ * b.values_;
    } else {
      for (int i = 0; i < lanes; ++i) result.values_[i] = a.values_[i] * b.values_[i];
    }
    return result;
  }
  [[nodiscard]] friend TORSOR_SIMD_INLINED Simd operator/(const Simd& a, const Simd& b) noexcept {
    TORSOR_SIMD_AS_WRITTEN
    Simd result;
    if constexpr (in_register) {
      result.values_ = a.values_ / b.values_;
    } else {
      for (int i = 0; i < lanes; ++i) result.values_[i] = a.values_[i] / b.values_[i];
    }
    return result;
  }
  [[nodiscard]] friend TORSOR_SIMD_INLINED Simd operator-(const Simd& a) noexcept {
    TORSOR_SIMD_AS_WRITTEN
    Simd result;
    if constexpr (in_register) {
      result.values_ = -a.values_;
    } else {
      for (int i = 0; i < lanes; ++i) result.values_[i] = -a.values_[i];
    }
    return result;
  }
  TORSOR_SIMD_INLINED Simd& operator+=(const Simd& b) noexcept { return *this = *this + b; }
  TORSOR_SIMD_INLINED Simd& operator-=(const Simd& b) noexcept { return *this = *this - b; }
  TORSOR_SIMD_INLINED Simd& operator*=(const Simd& b) noexcept { return *this = *this * b; }
  TORSOR_SIMD_INLINED Simd& operator/=(const Simd& b) noexcept { return *this = *this / b; }

  [[nodiscard]] friend TORSOR_SIMD_INLINED Mask operator<(const Simd& a, const Simd& b) noexcept { return less(a, b); }
  [[nodiscard]] friend TORSOR_SIMD_INLINED Mask operator>(const Simd& a, const Simd& b) noexcept { return less(b, a); }
  [[nodiscard]] friend TORSOR_SIMD_INLINED Mask operator<=(const Simd& a, const Simd& b) noexcept {
    return not_above(a, b);
  }
  [[nodiscard]] friend TORSOR_SIMD_INLINED Mask operator>=(const Simd& a, const Simd& b) noexcept {
    return not_above(b, a);
  }

  /// Of each lane the one or the other.
  [[nodiscard]] TORSOR_SIMD_INLINED static Simd select(const Mask& mask, const Simd& yes, const Simd& no) noexcept {
    Simd result;
    if constexpr (in_register) {
      using Flags = typename Storage::Flags;
      result.values_ = (Numbers)((mask.flags_ & (Flags)yes.values_) | (~mask.flags_ & (Flags)no.values_));
    } else {
      for (int i = 0; i < lanes; ++i) result.values_[i] = mask.flags_[i] ? yes.values_[i] : no.values_[i];
    }
    return result;
  }
  [[nodiscard]] friend TORSOR_SIMD_INLINED Simd abs(const Simd& a) noexcept {
    Simd result;
    if constexpr (in_register) {
      using Flags = typename Storage::Flags;
      result.values_ = (Numbers)((Flags)a.values_ & ~(Flags)Simd(Number(-0.0)).values_);
    } else {
      for (int i = 0; i < lanes; ++i) result.values_[i] = std::abs(a.values_[i]);
    }
    return result;
  }
  [[nodiscard]] TORSOR_SIMD_INLINED static Simd sqrt(const Simd& a) noexcept {
    Simd result;
#if defined(__AVX512F__)
    // With a mask, because g++ 12 warns of its own form without.
    if constexpr (in_register && sizeof(a.values_) == 64) {
      if constexpr (sizeof(Number) == 8)
        result.values_ = (Numbers)_mm512_maskz_sqrt_pd(0xff, (__m512d)a.values_);
      else
        result.values_ = (Numbers)_mm512_maskz_sqrt_ps(0xffff, (__m512)a.values_);
      return result;
    }
#endif
#if defined(__AVX__)
    if constexpr (in_register && sizeof(a.values_) == 32) {
      if constexpr (sizeof(Number) == 8)
        result.values_ = (Numbers)_mm256_sqrt_pd((__m256d)a.values_);
      else
        result.values_ = (Numbers)_mm256_sqrt_ps((__m256)a.values_);
      return result;
    }
#endif
#if defined(__SSE2__)
    if constexpr (in_register && sizeof(a.values_) == 16) {
      if constexpr (sizeof(Number) == 8)
        result.values_ = (Numbers)_mm_sqrt_pd((__m128d)a.values_);
      else
        result.values_ = (Numbers)_mm_sqrt_ps((__m128)a.values_);
      return result;
    }
#endif
    for (int i = 0; i < lanes; ++i) result.values_[i] = std::sqrt(Number(a.values_[i]));
    return result;
  }
  [[nodiscard]] friend TORSOR_SIMD_INLINED Simd sqrt(const Simd& a) noexcept { return Simd::sqrt(a); }

  [[nodiscard]] TORSOR_SIMD_INLINED const Numbers& numbers() const noexcept { return values_; }
  TORSOR_SIMD_INLINED void set(const Numbers& numbers) noexcept { values_ = numbers; }

 private:
  TORSOR_SIMD_INLINED static Mask less(const Simd& a, const Simd& b) noexcept {
    Mask mask;
    if constexpr (in_register) {
      mask.flags_ = a.values_ < b.values_;
    } else {
      for (int i = 0; i < lanes; ++i) mask.flags_[i] = a.values_[i] < b.values_[i];
    }
    return mask;
  }
  TORSOR_SIMD_INLINED static Mask not_above(const Simd& a, const Simd& b) noexcept {
    Mask mask;
    if constexpr (in_register) {
      mask.flags_ = a.values_ <= b.values_;
    } else {
      for (int i = 0; i < lanes; ++i) mask.flags_[i] = a.values_[i] <= b.values_[i];
    }
    return mask;
  }

  Numbers values_;
};

/// The pack that fills one vector register.
template <class Number>
using NativeSimd = Simd<Number, native_lanes<Number>>;

}  // namespace torsor::runtime
