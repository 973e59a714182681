// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace torsor::runtime {

/// Which way a guard g(t, y) passes through zero as the integration proceeds (in its direction of time).
enum class Crossing { rising, falling, either };

/// What happens at a crossing: the observer is told; the integration ends; the state is set anew; or the state is set
/// anew and g >= 0 holds on.
enum class Response { note, stop, reset, barrier };

struct NoReset {};

/// A guard with what is done where it passes through zero. Made by `note`, `stop_at`, `reset_at` or `barrier`.
template <class Function, class Reset = NoReset>
struct Guard {
  Function function;
  Crossing crossing = Crossing::either;
  Response response = Response::note;
  Reset reset;
  bool from_above = false;  ///< it was positive before the start: zero or less there is a crossing
};

/// The observer is told of the crossing, and the integration goes on.
template <class Function>
[[nodiscard]] constexpr Guard<Function> note(Function function, Crossing crossing = Crossing::either) {
  return {std::move(function), crossing, Response::note, {}, false};
}

/// The integration ends at the crossing.
template <class Function>
[[nodiscard]] constexpr Guard<Function> stop_at(Function function, Crossing crossing = Crossing::either) {
  return {std::move(function), crossing, Response::stop, {}, false};
}

/// `reset(t, y)` changes the state at the crossing; one that returns false ends the integration there. A guard that the
/// reset leaves at zero is then on the side to which it goes from there.
template <class Function, class Reset>
[[nodiscard]] constexpr Guard<Function, Reset> reset_at(Function function, Crossing crossing, Reset reset) {
  return {std::move(function), crossing, Response::reset, std::move(reset), false};
}

/// A unilateral condition g >= 0: where g would fall below zero, `reset(t, y)` changes the state (an impact). A motion
/// that goes straight back through fires again at once, so that nothing sinks: what comes to rest on a barrier shows as
/// an accumulation of events.
template <class Function, class Reset>
[[nodiscard]] constexpr Guard<Function, Reset> barrier(Function function, Reset reset) {
  return {std::move(function), Crossing::falling, Response::barrier, std::move(reset), false};
}

/// How events are told from rounding. Rounding of a guard is estimated, where it is near zero, as
/// ε (Σ |∂g/∂y_i| max |y_i| + |∂g/∂t t|), the largest in the step, and from its answer to changes by a rounding.
template <class Scalar>
struct EventOptions {
  /// A guard that goes beyond zero by no more roundings than this, and comes back, grazes: no reset, the observer is
  /// told. Raise it to let larger errors of the integration pass as grazing.
  Scalar touch = Scalar(64);
  /// Events of one guard whose predicted remaining time is at most this are an accumulation. Never below 8 roundings of
  /// the time.
  Scalar accumulation = Scalar(0);
  /// Locate on steps of the method itself, from the start of the step in which the event lies, instead of on its
  /// interpolant: for interpolants that are less accurate than the method, at the cost of some ten steps an event.
  /// Always so with Radau IIA and Gauss collocation, which are far righter at the ends of steps than inside.
  bool by_stepping = false;
  long long event_limit = 1'000'000;  ///< crossings of all guards that are told of, and grazings
};

/// Several guards, each of its own type. Crossings at the same time (within four roundings of it) are dealt with in
/// the order of declaration.
template <class... Guards>
class Events {
 public:
  static constexpr std::size_t count = sizeof...(Guards);
  static_assert(count > 0, "events need at least one guard");
  EventOptions<double> options{};

  explicit constexpr Events(Guards... guards) : guards_(std::move(guards)...) {}

  template <class Scalar, std::size_t size>
  [[nodiscard]] Scalar value(std::size_t index, const Scalar& t, const std::array<Scalar, size>& y) const {
    Scalar result{};
    visit(index, [&](const auto& guard) { result = guard.function(t, y); });
    return result;
  }
  [[nodiscard]] Crossing crossing(std::size_t index) const {
    Crossing result{};
    visit(index, [&](const auto& guard) { result = guard.crossing; });
    return result;
  }
  /// Whether a guard is on its positive side before the start, whatever rounding says there.
  [[nodiscard]] bool from_above(std::size_t index) const {
    bool result = false;
    visit(index, [&](const auto& guard) { result = guard.from_above; });
    return result;
  }
  [[nodiscard]] Response response(std::size_t index) const {
    Response result{};
    visit(index, [&](const auto& guard) { result = guard.response; });
    return result;
  }
  /// False if the integration shall end.
  template <class Scalar, std::size_t size>
  [[nodiscard]] bool reset(std::size_t index, const Scalar& t, std::array<Scalar, size>& y) const {
    bool go_on = true;
    visit(index, [&](const auto& guard) { go_on = reset_by(guard, t, y); });
    return go_on;
  }

  template <class G, class Scalar, std::size_t size>
  [[nodiscard]] static bool reset_by(const G& guard, const Scalar& t, std::array<Scalar, size>& y) {
    using Reset = std::remove_cvref_t<decltype(guard.reset)>;
    if constexpr (std::is_same_v<Reset, NoReset>) {
      return guard.response != Response::stop;
    } else if constexpr (std::is_same_v<bool, std::invoke_result_t<const Reset&, const Scalar&, decltype(y)>>) {
      return guard.reset(t, y);
    } else {
      guard.reset(t, y);
      return true;
    }
  }

 private:
  template <class Action>
  void visit(std::size_t index, Action&& action) const {
    std::size_t i = 0;
    std::apply([&](const auto&... guard) { ((i++ == index ? action(guard) : void()), ...); }, guards_);
  }

  std::tuple<Guards...> guards_;
};

/// Many guards of one type, in the order of the array.
template <class G, std::size_t number>
class EventArray {
 public:
  static constexpr std::size_t count = number;
  static_assert(count > 0, "events need at least one guard");
  EventOptions<double> options{};

  explicit constexpr EventArray(std::array<G, number> guards) : guards_(std::move(guards)) {}

  template <class Scalar, std::size_t size>
  [[nodiscard]] Scalar value(std::size_t index, const Scalar& t, const std::array<Scalar, size>& y) const {
    return guards_[index].function(t, y);
  }
  [[nodiscard]] Crossing crossing(std::size_t index) const { return guards_[index].crossing; }
  [[nodiscard]] Response response(std::size_t index) const { return guards_[index].response; }
  [[nodiscard]] bool from_above(std::size_t index) const { return guards_[index].from_above; }
  template <class Scalar, std::size_t size>
  [[nodiscard]] bool reset(std::size_t index, const Scalar& t, std::array<Scalar, size>& y) const {
    return Events<G>::reset_by(guards_[index], t, y);
  }

 private:
  std::array<G, number> guards_;
};

}  // namespace torsor::runtime
