// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace torsor::runtime {

/// The weights of an error: each component counts in units of  absolute + relative |y_i|.
/// Source: Hairer-Nørsett-Wanner I, II.4 (4.10), (4.11).
template <class Scalar>
struct Tolerances {
  Scalar relative, absolute;

  /// Relative tolerances below four roundings of the scalar promise what no step can keep.
  [[nodiscard]] static bool usable(double relative, double absolute) noexcept {
    const bool works = relative == 0.0 || relative >= 4.0 * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
    return works && std::isfinite(relative) && absolute >= 0.0 && std::isfinite(absolute) && relative + absolute > 0.0;
  }

  // A component that is exactly zero weighs nothing even when its tolerance is zero too.
  [[nodiscard]] Scalar square(Scalar value, Scalar magnitude) const noexcept {
    if (value == Scalar(0)) return Scalar(0);
    const Scalar ratio = value / (absolute + relative * magnitude);
    return ratio * ratio;
  }

  template <std::size_t size>
  [[nodiscard]] Scalar norm(const std::array<Scalar, size>& v, const std::array<Scalar, size>& y) const noexcept {
    Scalar sum = Scalar(0);
    for (std::size_t i = 0; i < size; ++i) sum += square(v[i], std::abs(y[i]));
    return std::sqrt(sum / static_cast<Scalar>(size));
  }
};

/// The proportional-integral step control of the Dormand-Prince methods. `Gains` has `integral` (Hairer's β, the
/// stabilisation of Lund), `proportional`, `safety`, `strongest_shrink` and `strongest_growth`.
/// Source: Hairer-Wanner II, IV.2 (2.43c).
template <class Scalar, class Gains>
class StepControl {
 public:
  static constexpr Scalar strongest_shrink = Scalar(Gains::strongest_shrink);

  /// The length to try after one that was refused with this weighted error.
  [[nodiscard]] static Scalar shorter(Scalar h, Scalar error) noexcept {
    if (!std::isfinite(error)) return h * strongest_shrink;
    return h * std::max(strongest_shrink, safety / std::pow(error, Scalar(Gains::proportional)));
  }

  /// The length to try after one that was kept with this error; `planned` is what it was before the end cut it short.
  [[nodiscard]] Scalar longer(Scalar h, Scalar error, Scalar planned, bool after_rejection) noexcept {
    Scalar factor = growth;
    if (error > Scalar(0)) {
      Scalar wanted = safety / std::pow(error, Scalar(Gains::proportional));
      if constexpr (Gains::integral > 0.0) wanted *= std::pow(memory_, Scalar(Gains::integral));
      factor = std::clamp(wanted, strongest_shrink, growth);
    }
    Scalar proposal = h * factor;
    if (after_rejection) proposal = std::min(proposal, h);
    // A step cut short by the end says little about how long the next one may be.
    if (h < planned * Scalar(0.99))
      proposal = std::max(proposal, planned);
    else
      memory_ = std::max(error, Scalar(1e-4));
    return proposal;
  }

 private:
  static constexpr Scalar safety = Scalar(Gains::safety), growth = Scalar(Gains::strongest_growth);
  Scalar memory_ = Scalar(1e-4);  // the last error kept, for the integral part
};

/// The interval in which the first step is looked for: the end of the integration, the longest step allowed, and the
/// shortest that the clock can tell.
template <class Scalar>
struct StepRange {
  Scalar start, end, longest;

  [[nodiscard]] Scalar shortest() const noexcept {
    return Scalar(100) * std::numeric_limits<Scalar>::epsilon() * std::abs(start);
  }
};

/// What the steps of an integration begin with.
template <class Scalar, std::size_t size>
struct StepsAhead {
  StepRange<Scalar> range;
  const std::array<Scalar, size>& y;  ///< the state at range.start
  Tolerances<Scalar> tolerances;
};

/// A first step: one that changes y by a hundredth of its own scale, tried with Euler's method, gives the second
/// derivative, and that the length at which the error terms reach a hundredth of the tolerance. `slope` is y' there.
/// Source: Hairer-Nørsett-Wanner I, II.4 (4.14).
template <class F, class Scalar, std::size_t size>
[[nodiscard]] Scalar starting_step(F& f, const StepsAhead<Scalar, size>& ahead, const std::array<Scalar, size>& slope,
                                   int order) {
  const auto& [range, y, tolerances] = ahead;
  const Scalar reach = std::abs(range.end - range.start);
  const Scalar d0 = tolerances.norm(y, y), d1 = tolerances.norm(slope, y), little = Scalar(1e-5);
  Scalar h0 = !std::isfinite(d1) || d0 < little || d1 < little ? Scalar(1e-6) : Scalar(0.01) * d0 / d1;
  // Far from time 0 the clock itself sets a least step, which the equations know nothing of.
  h0 = std::min({std::max(h0, range.shortest()), range.longest, reach});
  const Scalar signed_h0 = std::copysign(h0, range.end - range.start);
  std::array<Scalar, size> moved, change;
  for (std::size_t i = 0; i < size; ++i) moved[i] = y[i] + signed_h0 * slope[i];
  // Where the trial step leaves the model's domain, the step control finds the way back from h0.
  if (!f(range.start + signed_h0, moved, change)) return h0;
  for (std::size_t i = 0; i < size; ++i) change[i] = (change[i] - slope[i]) / h0;
  Scalar steepest = std::max(d1, tolerances.norm(change, y));
  if (!std::isfinite(steepest)) {
    // Without an absolute tolerance what starts from zero has the scale of its way.
    for (std::size_t i = 0; i < size; ++i) moved[i] = std::abs(moved[i]) + h0 * h0 * std::abs(change[i]);
    steepest = std::max(tolerances.norm(slope, moved), tolerances.norm(change, moved));
  }
  const Scalar h1 = steepest <= Scalar(1e-15)
                        ? std::max(Scalar(1e-6), h0 * Scalar(1e-3))
                        : std::pow(Scalar(0.01) / steepest, Scalar(1) / static_cast<Scalar>(order));
  const Scalar proposal = std::min(std::max(std::min(Scalar(100) * h0, h1), range.shortest()), range.longest);
  return std::isfinite(proposal) && proposal > Scalar(0) ? proposal : h0;
}

}  // namespace torsor::runtime
