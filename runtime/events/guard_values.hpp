// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace torsor::runtime {

/// Values of guards along a step, and what rounding may make of them. What was found at a time is kept: guards are sought at
/// the same times, and again with other bands, while states inside a step and what guards read of them are dear. Those that
/// may have an event are therefore read together.
template <class Set, class Scalar, std::size_t size>
class GuardValues {
 public:
  static constexpr std::size_t count = Set::count;
  using Vector = std::array<Scalar, size>;

  explicit GuardValues(const Set& set) noexcept : set_(set) {}

  /// Guards that may have an event in the step that is looked through: those that may be asked for.
  std::array<bool, count> watched{};

  /// Another step, or another look at it: nothing is known.
  void forget() noexcept {
    for (Read& read : reads_) read.known = false;
    for (Read& read : roundings_) read.known = false;
    ends_known_ = false;
  }

  /// Value of a guard at a time.
  template <class Step>
  [[nodiscard]] Scalar value(std::size_t i, const Step& step, Scalar t) {
    Read& read = reads_[place<most_reads>(t)];
    if (!read.is_of(t)) {
      read = {t, true, {}};
      each(t, step(t), [&](std::size_t k, Scalar value) { read.values[k] = value; });
    }
    return read.values[i];
  }

  /// What rounding may make of a guard at a time: of the state and the time, to first order, and of its own terms, which
  /// shows in its answer to changes by a rounding.
  template <class Step>
  [[nodiscard]] Scalar rounding(std::size_t i, const Step& step, Scalar t) {
    Read& read = roundings_[place<most_roundings>(t)];
    if (!read.is_of(t)) read = {t, true, roundings(step, t)};
    return read.values[i];
  }

 private:
  using Values = std::array<Scalar, count>;
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  // Of many guards less is kept, so that it stays small on a stack.
  static constexpr std::size_t most_reads = count <= 16 ? 128 : count <= 64 ? 32 : count <= 512 ? 16 : 2;
  static constexpr std::size_t most_roundings = count <= 512 ? 16 : 2;

  struct Read {
    Scalar time = Scalar(0);
    bool known = false;
    Values values{};
    [[nodiscard]] bool is_of(Scalar t) const noexcept { return known && time == t; }
  };

  template <std::size_t places>
  static std::size_t place(Scalar t) noexcept {
    constexpr std::uint64_t spread = 0x9e3779b97f4a7c15;  // the golden ratio's fraction: neighbours come apart
    return (std::bit_cast<std::uint64_t>(static_cast<double>(t)) * spread) >> (64 - std::bit_width(places - 1));
  }

  template <class Use>
  void each(Scalar t, const Vector& y, const Use& use) const {
    for (std::size_t k = 0; k < count; ++k) {
      if (watched[k]) use(k, set_.value(k, t, y));
    }
  }

  template <class Step>
  Values roundings(const Step& step, Scalar t) {
    const Scalar relative = std::sqrt(epsilon), one = Scalar(1);
    if (!ends_known_) {
      y_start_ = step(step.start);
      y_end_ = step(step.end);
      ends_known_ = true;
    }
    Vector y = step(t);
    Values values{}, terms{}, noise{}, rates{};
    each(t, y, [&](std::size_t k, Scalar value) { values[k] = value; });
    // A guard may have no value beside the motion, as the force of a contact where others no longer hold: nothing is told there.
    const auto change = [&](std::size_t k, Scalar value) {
      const Scalar by = std::abs(value - values[k]);
      return std::isfinite(by) ? by : Scalar(0);
    };
    const auto add_terms = [&](std::size_t k, Scalar value) { terms[k] += change(k, value) / relative; };
    each(t * (one + relative), y, add_terms);
    for (std::size_t j = 0; j < size; ++j) {
      const Scalar kept = y[j], largest = std::max({std::abs(y_start_[j]), std::abs(y_end_[j]), std::abs(kept)});
      y[j] = kept + relative * largest;
      each(t, y, add_terms);
      y[j] = kept * (one + Scalar(2) * epsilon);
      each(t, y, [&](std::size_t k, Scalar value) { noise[k] = std::max(noise[k], change(k, value)); });
      y[j] = kept;
    }
    // How far a guard goes in a rounding of the time.
    const Scalar part = Scalar(1e-3) * (step.end - step.start);
    const bool room = step.end >= step.start ? t + part < step.end : step.end < t + part;
    const Scalar aside = room ? t + part : t - part;
    each(aside, step(aside), [&](std::size_t k, Scalar value) { rates[k] = change(k, value) / std::abs(part); });
    const auto touch = static_cast<Scalar>(set_.options.touch);
    for (std::size_t k = 0; k < count; ++k) {
      values[k] = touch * std::max(epsilon * terms[k], noise[k]) + Scalar(8) * epsilon * std::abs(t) * rates[k];
    }
    return values;
  }

  const Set& set_;
  std::array<Read, most_reads> reads_{};
  std::array<Read, most_roundings> roundings_{};
  Vector y_start_{}, y_end_{};
  bool ends_known_ = false;
};

}  // namespace torsor::runtime
