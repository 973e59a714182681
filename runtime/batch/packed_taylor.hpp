// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "torsor/runtime/batch/batch.hpp"
#include "torsor/runtime/batch/motion_ensemble.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/status.hpp"
#include "torsor/runtime/steps/compensated_state.hpp"
#include "torsor/runtime/steps/step_clock.hpp"
#include "torsor/runtime/steps/step_control.hpp"
#include "torsor/runtime/steps/taylor_rule.hpp"

namespace torsor::runtime {

/// Taylor's method for several motions of one mechanism at once, one in each lane of a pack. Coefficients and
/// polynomials are computed for all lanes together,
///   y(t + h) = y + h c_1 + ... + h^p c_p,   t, h and y with a number in each lane,
/// while each lane has the order, the step length, the checks, the rejections and the end of its own that `Taylor`
/// would give it alone: the rule and the clock are the same. Coefficients are computed to the highest order of all
/// lanes and are zero beyond a lane's own. A lane that has ended or failed stands still, with h = 0, and repeats the
/// last state that was good.
///
/// Quaternions get their norm back after each step, as alone. Where the kernel fails for a pack, its lanes are computed
/// one by one. Without fused multiply-adds the results have the bits of single ones; with them rounding differs, and
/// may change a step's length by as much, or whether one at the very limit is kept.
template <template <class> class Mechanism, class Number, template <class> class InputLaw, int lane_count>
class PackedTaylor {
 public:
  static_assert(Mechanism<Number>::multiplier_count == 0,
                "lanes of a pack are not projected and would drift off their constraints: take motion_ensemble");
  using Single = Mechanism<Number>;
  using Packed = Mechanism<Simd<Number, lane_count>>;
  using Vector = StateVector<Single>;

  /// As many members as there are lanes, or fewer.
  PackedTaylor(const std::vector<Member<Single>>& members, const Taylor& method, const InputLaw<Single>& law,
               const InputLaw<Packed>& packed_law)
      : method_(method),
        tolerances_{static_cast<Number>(method.relative_tolerance), static_cast<Number>(method.absolute_tolerance)},
        lanes_(lanes_of(members, method, law)),
        motion_(parameters_of(members), packed_law) {
    for (int i = 0; i < lane_count; ++i) {
      const Member<Single>& member = members[stands_for(i)];
      Vector y = pack<Single>(member.state);
      (void)start_with_unit_quaternions<Single>(y);  // one of zeros is in no lane that can start
      set_lane(y_, i, y);
      start_.set(i, member.state.time);
    }
  }

  /// Through given times in turn, each hit exactly, as far as each lane gets; `keep(i, k, y)` is told the state of
  /// member i at times[k].
  template <class Keep>
  void integrate_through(std::span<const Number> times, const Keep& keep) {
    begin();
    for (std::size_t i = 0; i < lanes_.size(); ++i) head_for_next(i, times, keep);
    while (plan(times)) {
      attempt();
      decide();
      for (std::size_t i = 0; i < lanes_.size(); ++i) {
        Lane& lane = lanes_[i];
        if (lane.moving && lane.clock.result.time == times[lane.target]) head_for_next(i, times, keep);
      }
    }
  }

  /// The last good state of member i, at result(i).time; of one that could not start that is its start.
  [[nodiscard]] Vector state(std::size_t i) const noexcept {
    return lanes_[i].startable ? lane_of(y_, static_cast<int>(i)) : lanes_[i].start;
  }
  /// How member i ended.
  [[nodiscard]] const Result<Number>& result(std::size_t i) const noexcept { return lanes_[i].clock.result; }

 private:
  using Pack = ScalarOf<Packed>;
  using PackedVector = StateVector<Packed>;
  static constexpr std::size_t size = std::tuple_size_v<Vector>, room = jet_order_max + 1;
  using Coefficients = std::array<PackedVector, room>;

  struct Lane {
    EquationsOfMotion<Single, InputLaw<Single>> alone;
    StepClock<Number> clock;
    TaylorRule<Number, size> rule;
    bool has_attitudes = false;  // no quaternion of zeros
    bool usable = false;         // options, time and state
    bool startable = false;      // else another member stands in the lane of the pack
    Vector start{};
    std::size_t target = 0;  // index of the time it is on its way to
    bool prepared = false, moving = false;
    Evaluation said = Evaluation::ok;  // of the step being tried
    Number error = Number(0);
  };

  [[nodiscard]] static bool usable(const Taylor& o) noexcept {
    return Tolerances<Number>::usable(o.relative_tolerance, o.absolute_tolerance) && o.first_step >= 0.0 &&
           o.largest_step >= 0.0 && o.step_limit > 0 && Taylor::Formula<Number, size>::usable(o);
  }

  // Whether members can start is asked of the single kernel, since one that cannot would spoil the pack.
  [[nodiscard]] std::vector<Lane> lanes_of(const std::vector<Member<Single>>& members, const Taylor& method,
                                           const InputLaw<Single>& law) const {
    std::vector<Lane> lanes;
    for (const Member<Single>& member : members) {
      lanes.push_back({EquationsOfMotion<Single, InputLaw<Single>>(member.parameters, law),
                       StepClock<Number>(method.largest_step), TaylorRule<Number, size>(method.order)});
      Lane& lane = lanes.back();
      Vector y = pack<Single>(member.state);
      lane.has_attitudes = start_with_unit_quaternions<Single>(y);
      lane.start = y;
      lane.clock.result.time = member.state.time;
      lane.usable = lane.has_attitudes && usable(method) && std::isfinite(member.state.time) && all_finite(y);
      if (!lane.usable) continue;
      lane.rule.start(y, tolerances_);
      std::array<Vector, room> c;
      lane.clock.refusal = jets_alone(lane, member.state.time, y, std::span(c).first(lane.rule.order() + 1));
      lane.startable = lane.clock.refusal == Evaluation::ok;
    }
    return lanes;
  }

  // The member whose parameters and state a lane has: its own, or another's where it has none that can start.
  [[nodiscard]] std::size_t stands_for(int lane) const noexcept {
    const auto own = static_cast<std::size_t>(lane);
    if (own < lanes_.size() && lanes_[own].startable) return own;
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      if (lanes_[i].startable) return i;
    }
    return 0;
  }
  [[nodiscard]] typename Packed::Parameters parameters_of(const std::vector<Member<Single>>& members) const {
    Batch<typename Single::Parameters, typename Packed::Parameters, Number, lane_count> parameters(lane_count);
    for (int i = 0; i < lane_count; ++i) {
      parameters.set(static_cast<std::size_t>(i), members[stands_for(i)].parameters);
    }
    return parameters.block(0);
  }

  [[nodiscard]] static Vector lane_of(const PackedVector& packed, int lane) noexcept {
    Vector y;
    for (std::size_t k = 0; k < size; ++k) y[k] = packed[k][lane];
    return y;
  }
  static void set_lane(PackedVector& packed, int lane, const Vector& y) noexcept {
    for (std::size_t k = 0; k < size; ++k) packed[k].set(lane, y[k]);
  }
  [[nodiscard]] static auto each(const Coefficients& c, int lane) noexcept {
    return [&c, lane](std::size_t k) { return lane_of(c[k], lane); };
  }

  [[nodiscard]] static Evaluation jets_alone(const Lane& lane, Number t, const Vector& y,
                                             std::span<Vector> c) noexcept {
    CheckedSystem<const EquationsOfMotion<Single, InputLaw<Single>>, Number, size> alone(lane.alone);
    (void)alone.jets(t, y, c);
    return alone.evaluation;
  }

  void begin() noexcept {
    degree_ = 0;
    for (const Lane& lane : lanes_) {
      if (lane.startable) degree_ = std::max(degree_, lane.rule.order());
    }
    if (degree_ == 0) return;
    for (Lane& lane : lanes_) lane.moving = lane.startable;
    compute_jets(start_, y_, std::span(start_c()).first(degree_ + 1),
                 [](const Lane& lane) { return lane.rule.order(); });
    for (Lane& lane : lanes_) {
      if (lane.startable) lane.clock.refusal = lane.said;
    }
  }

  // Towards the next time that is not the present one; a lane without any stands still.
  template <class Keep>
  void head_for_next(std::size_t i, std::span<const Number> times, const Keep& keep) {
    Lane& lane = lanes_[i];
    lane.moving = false;
    if (!lane.has_attitudes) {
      lane.clock.result.status = IntegrationStatus::model_failure;
      lane.clock.result.evaluation = Evaluation::not_finite;
      return;
    }
    for (; lane.target < times.size(); ++lane.target) {
      const Number end = times[lane.target];
      if (!lane.usable || !std::isfinite(end)) {
        lane.clock.result.status = IntegrationStatus::invalid_options;
        return;
      }
      if (end != lane.clock.result.time) {
        lane.moving = lane.prepared || prepare(i, end);
        lane.clock.set_out();
        return;
      }
      keep(i, lane.target, state(i));
    }
  }

  [[nodiscard]] bool prepare(std::size_t i, Number end) {
    Lane& lane = lanes_[i];
    StepClock<Number>& clock = lane.clock;
    ++clock.result.statistics.calls;
    lane.prepared = clock.refusal == Evaluation::ok;
    if (!lane.prepared) {
      clock.give_up();
      return false;
    }
    clock.length = std::min(static_cast<Number>(method_.first_step), clock.largest);
    if (!(clock.length > Number(0))) {
      clock.length = lane.rule.first(each(start_c(), static_cast<int>(i)),
                                     StepRange<Number>{clock.result.time, end, clock.largest});
    }
    return true;
  }

  // False when no lane has a step to try.
  [[nodiscard]] bool plan(std::span<const Number> times) noexcept {
    bool any = false;
    for (Lane& lane : lanes_) {
      lane.moving = lane.moving && lane.clock.plan(times[lane.target], method_.step_limit);
      any = any || lane.moving;
    }
    return any;
  }

  // One step of each moving lane, to next_ and its coefficients; its error and what the model said.
  void attempt() noexcept {
    Pack h(Number(0)), t = start_;
    for (int i = 0; i < count(); ++i) {
      const Lane& lane = lanes_[static_cast<std::size_t>(i)];
      if (lane.moving) h.set(i, lane.clock.h);
      if (lane.startable) t.set(i, lane.clock.result.time);
    }
    PackedVector increment, slope;
    evaluate_taylor(std::span(start_c()).first(degree_ + 1), h, increment, slope);
    propose(increment);
    next_degree_ = 0;
    for (int i = 0; i < lane_count; ++i) {
      const bool tried = i < count() && lanes_[static_cast<std::size_t>(i)].moving;
      const Vector next = lane_of(next_, i);
      const bool finite = all_finite(next) && all_finite(lane_of(slope, i));
      if (!tried || !finite) set_lane(next_, i, lane_of(y_, i));
      if (!tried) continue;
      Lane& lane = lanes_[static_cast<std::size_t>(i)];
      lane.said = finite ? Evaluation::ok : Evaluation::not_finite;
      if (finite) {
        lane.rule.choose_next(next);
        ++lane.clock.result.statistics.calls;
      }
      next_degree_ = std::max({next_degree_, lane.rule.order(), lane.rule.next_order()});  // it may stay
    }
    compute_jets(t + h, next_, std::span(end_c()).first(next_degree_ + 1),
                 [](const Lane& lane) { return lane.rule.next_order(); });
    for (int i = 0; i < count(); ++i) {
      Lane& lane = lanes_[static_cast<std::size_t>(i)];
      if (lane.moving && lane.said == Evaluation::ok) compare(i, lane, lane_of(slope, i));
    }
  }

  /// y + increment, and its quaternions' norms back: a correction within a few roundings stays undone where sums are
  /// compensated, as in AccumulatedState.
  void propose(const PackedVector& increment) noexcept {
    next_sums_ = sums_;
    for (std::size_t k = 0; k < size; ++k) {
      next_[k] = method_.compensated ? next_sums_.add(k, y_[k], increment[k]) : y_[k] + increment[k];
    }
    if constexpr (HasQuaternions<Packed>) {
      PackedVector settled = next_;
      normalise_quaternions<Packed>(settled);
      const Pack few(method_.compensated ? Number(4) * std::numeric_limits<Number>::epsilon() : Number(0));
      Pack moved(Number(0));
      for (std::size_t k = 0; k < size; ++k) {
        moved = Pack::select(abs(settled[k] - next_[k]) > few * abs(next_[k]), Pack(Number(1)), moved);
      }
      for (std::size_t k = 0; k < size; ++k) next_[k] = Pack::select(moved > Pack(Number(0)), settled[k], next_[k]);
    }
  }

  // Coefficients of the moving lanes that have not failed, zero beyond a lane's own order. Where the pack fails, which
  // orders beyond a lane's own may cause too, each is computed alone.
  template <class OrderOf>
  void compute_jets(const Pack& t, const PackedVector& y, std::span<PackedVector> c, const OrderOf& order_of) noexcept {
    const auto counts = [](const Lane& lane) { return lane.moving && lane.said == Evaluation::ok; };
    const bool together = motion_.jets(t, y, c) == Evaluation::ok;
    for (int i = 0; i < count(); ++i) {
      Lane& lane = lanes_[static_cast<std::size_t>(i)];
      if (!counts(lane)) continue;
      const std::size_t order = order_of(lane);
      if (together) {
        const bool finite = all_finite(lane_of(c[1], i)) && all_finite(lane_of(c[order], i));
        lane.said = finite ? Evaluation::ok : Evaluation::not_finite;
      } else {
        std::array<Vector, room> own{};  // a lane that fails leaves some unwritten
        lane.said = jets_alone(lane, t[i], lane_of(y, i), std::span(own).first(order + 1));
        for (std::size_t k = 0; k <= order; ++k) set_lane(c[k], i, own[k]);
      }
      for (std::size_t k = order + 1; k < c.size(); ++k) set_lane(c[k], i, Vector{});
    }
  }

  void compare(int i, Lane& lane, const Vector& slope) noexcept {
    const Vector now = lane_of(y_, i), next = lane_of(next_, i), equations_slope = lane_of(end_c()[1], i);
    Vector noise{};
    const EndSlopes<Number, size> slopes{.polynomial = slope, .equations = equations_slope, .noise = noise};
    lane.error = lane.rule.disagreement(lane.clock.h, slopes, now, next);
    if (lane.error > Number(1)) {  // rarely: alone
      std::array<Vector, 2> there;
      ++lane.clock.result.statistics.calls;
      const Vector moved = lane.rule.some_roundings_from(now, next);
      if (jets_alone(lane, lane.clock.result.time + lane.clock.h, moved, there) == Evaluation::ok) {
        for (std::size_t k = 0; k < size; ++k) noise[k] = std::abs(there[1][k] - equations_slope[k]);
        lane.error = lane.rule.disagreement(lane.clock.h, slopes, now, next);
      }
    }
    if (!std::isfinite(lane.error)) lane.said = Evaluation::not_finite;
  }

  // Keeps the steps that may be kept; the other lanes stay.
  void decide() noexcept {
    for (int i = 0; i < count(); ++i) {
      Lane& lane = lanes_[static_cast<std::size_t>(i)];
      if (!lane.moving) continue;
      StepClock<Number>& clock = lane.clock;
      const Number length = std::abs(clock.h);
      if (lane.said == Evaluation::ok && lane.error <= Number(1)) {
        clock.keep(lane.rule.longer(each(end_c(), i), length, clock.length, clock.after_rejection()));
        lane.rule.accept();
      } else {
        clock.refuse(lane.said, lane.rule.shorter(length));
        stay(i);
      }
    }
    y_ = next_;
    sums_ = next_sums_;
    current_ = 1 - current_;
    degree_ = 0;
    for (const Lane& lane : lanes_) {
      if (lane.moving) degree_ = std::max(degree_, lane.rule.order());
    }
  }

  // Rarely: where a step begins is carried over to where it would have ended.
  void stay(int i) noexcept {
    set_lane(next_, i, lane_of(y_, i));
    set_lane(next_sums_.rest, i, lane_of(sums_.rest, i));
    for (std::size_t k = 0; k <= next_degree_; ++k) {
      set_lane(end_c()[k], i, k <= degree_ ? lane_of(start_c()[k], i) : Vector{});
    }
  }

  [[nodiscard]] Coefficients& start_c() noexcept { return c_[current_]; }
  [[nodiscard]] Coefficients& end_c() noexcept { return c_[1 - current_]; }
  [[nodiscard]] int count() const noexcept { return static_cast<int>(lanes_.size()); }

  Taylor method_;
  Tolerances<Number> tolerances_;
  std::vector<Lane> lanes_;
  EquationsOfMotion<Packed, InputLaw<Packed>> motion_;
  Pack start_;
  PackedVector y_, next_;
  CompensatedState<Pack, size> sums_{}, next_sums_{};
  std::size_t degree_ = 0, next_degree_ = 0;
  std::array<Coefficients, 2> c_{};  // at the start of a step and at its end, in turn
  std::size_t current_ = 0;
};

}  // namespace torsor::runtime
