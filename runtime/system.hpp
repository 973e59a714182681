// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// y' = f(t, y): a callable `system(t, y, dydt)` that writes the derivative and returns an enumeration, 0 if it could.
/// It may have a member `project(y)` or `project(t, y)` too, noexcept, which removes what a step's error moved off an
/// invariant (the norm of a quaternion, a constraint); every method calls it once after each step kept. One that
/// returns an enumeration other than 0 fails like an evaluation: adaptive methods try a shorter step. A projection that
/// makes coordinates jump to an equivalent place comes with `unwound(y, before)`, the same state without the jump from
/// `before`: interpolants are led there. What a motion starts from may be given as no state is: a `settle_start(y)`, noexcept,
/// makes it one, and leaves alone what is one already; where it returns an enumeration other than 0 there is no motion.
template <class S, class Scalar, std::size_t size>
concept System = std::floating_point<Scalar> &&
    requires(S& system, const Scalar& t, const std::array<Scalar, size>& y, std::array<Scalar, size>& dydt) {
  requires std::is_enum_v<std::remove_cvref_t<decltype(system(t, y, dydt))>>;
};

/// What a system computes its derivatives in: its own `Precision` if it names one, else the scalar of the state.
template <class S, class Scalar>
struct PrecisionOf {
  using type = Scalar;
};
template <class S, class Scalar>
requires requires { typename S::Precision; }
struct PrecisionOf<S, Scalar> {
  using type = typename S::Precision;
};

template <class Scalar, std::size_t size>
[[nodiscard]] bool all_finite(const std::array<Scalar, size>& values) noexcept {
  bool finite = true;
  for (const Scalar& value : values) finite = finite && std::isfinite(value);
  return finite;
}

/// A system that says how a state is put back where it belongs.
template <class S, class Scalar, std::size_t size>
concept Settles = requires(S& system, const Scalar& t, std::array<Scalar, size>& y) {
  system.project(t, y);
}
|| requires(S& system, std::array<Scalar, size>& y) { system.project(y); };

/// A system that makes what a motion is to start from a state.
template <class S, class Scalar, std::size_t size>
concept StartsFrom = requires(const S& system, std::array<Scalar, size>& y) { system.settle_start(y); };

/// Makes what a motion is to start from a state, where the system says how. What is not finite is refused elsewhere.
template <class S, class Scalar, std::size_t size>
[[nodiscard]] Evaluation settle_start([[maybe_unused]] S& system, [[maybe_unused]] std::array<Scalar, size>& y) noexcept {
  if constexpr (requires { system.settle_start(y); }) {
    if (all_finite(y)) return to_evaluation(system.settle_start(y));
  }
  return Evaluation::ok;
}

/// A system that counts its calls and takes no derivative for granted: a value that is not finite is a failure even
/// when the system itself reports none.
template <class S, class Scalar, std::size_t size>
class CheckedSystem {
 public:
  explicit CheckedSystem(S& system) noexcept : system_(system) {}

  /// False when the model failed; `evaluation` then says how.
  [[nodiscard]] bool operator()(Scalar t, const std::array<Scalar, size>& y,
                                std::array<Scalar, size>& dydt) noexcept(noexcept(std::declval<S&>()(t, y, dydt))) {
    ++calls;
    evaluation = to_evaluation(system_(t, y, dydt));
    if (evaluation == Evaluation::ok && !all_finite(dydt)) evaluation = Evaluation::not_finite;
    return evaluation == Evaluation::ok;
  }

  /// Taylor coefficients of the motion through y, as many as the span holds. False when the model failed.
  template <class Coefficients>
  [[nodiscard]] bool jets(Scalar t, const std::array<Scalar, size>& y,
                          Coefficients c) noexcept(noexcept(std::declval<S&>().jets(t, y, c))) {
    ++calls;
    evaluation = to_evaluation(system_.jets(t, y, c));
    if (evaluation == Evaluation::ok && !(all_finite(c[1]) && all_finite(c.back())))
      evaluation = Evaluation::not_finite;
    return evaluation == Evaluation::ok;
  }

  /// Puts a state back where it belongs, after each step kept, if the system says how. False when it could not.
  [[nodiscard]] bool settle(Scalar t, std::array<Scalar, size>& y) noexcept {
    bool done = true;
    if constexpr (requires { system_.project(t, y); }) {
      done = settled([&] { return system_.project(t, y); });
    } else if constexpr (requires { system_.project(y); }) {
      done = settled([&] { return system_.project(y); });
    } else {
      return true;
    }
    if (done && !all_finite(y)) {
      evaluation = Evaluation::not_finite;
      done = false;
    }
    return done;
  }

  /// A settled state without the jumps of coordinates that settling brought to the one before.
  [[nodiscard]] std::array<Scalar, size> unwound(
      const std::array<Scalar, size>& y, [[maybe_unused]] const std::array<Scalar, size>& before) const noexcept {
    if constexpr (requires { system_.unwound(y, before); }) {
      return system_.unwound(y, before);
    } else {
      return y;
    }
  }

  /// The system itself, for what it may offer besides its derivative.
  [[nodiscard]] S& system() const noexcept { return system_; }

  std::int64_t calls = 0;
  std::int64_t jacobians = 0, decompositions = 0;  ///< counted by the implicit methods
  Evaluation evaluation = Evaluation::ok;

 private:
  template <class Project>
  bool settled(const Project& project) noexcept {
    if constexpr (std::is_void_v<decltype(project())>) {
      project();
      return true;
    } else {
      evaluation = to_evaluation(project());
      return evaluation == Evaluation::ok;
    }
  }

  S& system_;
};

/// The observer of those who want none.
struct IgnoreSteps {
  template <class... Anything>
  constexpr void operator()(const Anything&...) const noexcept {}
};

/// Calls the observer; one that returns a bool stops the integration by false, any other goes on.
template <class Observer, class... Arguments>
[[nodiscard]] bool notify(Observer& observer, const Arguments&... arguments) noexcept(
    std::is_nothrow_invocable_v<Observer&, const Arguments&...>) {
  if constexpr (std::is_same_v<std::invoke_result_t<Observer&, const Arguments&...>, bool>) {
    return observer(arguments...);
  } else {
    observer(arguments...);
    return true;
  }
}

}  // namespace torsor::runtime
