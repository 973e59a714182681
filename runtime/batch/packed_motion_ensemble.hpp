// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "torsor/runtime/batch/batch.hpp"
#include "torsor/runtime/batch/motion_ensemble.hpp"
#include "torsor/runtime/batch/packed_taylor.hpp"

namespace torsor::runtime {

/// A method of fixed step made of an explicit formula: Midpoint, RungeKutta4.
template <class Method>
concept ExplicitFixedStep = requires(const Method& method) {
  typename Method::Formula;
  { method.step } -> std::convertible_to<double>;
  { method.compensated } -> std::convertible_to<bool>;
};

/// A method whose steps packs can take.
template <class Method>
concept PackableMethod = ExplicitFixedStep<Method> || std::same_as<Method, Taylor>;

/// The equations of motion of a pack of members, for a formula. They fail where one lane fails.
template <HasForwardDynamics Packed, class InputLaw>
class PackedMotion {
 public:
  using Pack = ScalarOf<Packed>;
  using Vector = StateVector<Packed>;

  PackedMotion(const typename Packed::Parameters& parameters, const InputLaw& law) noexcept
      : motion_(parameters, law) {}

  [[nodiscard]] bool operator()(const Pack& t, const Vector& y, Vector& dydt) {
    ++calls;
    return motion_(t, y, dydt) == Evaluation::ok && every_finite(dydt);
  }

  /// As EquationsOfMotion does, lane by lane.
  [[nodiscard]] bool settle(Vector& y) const noexcept {
    if constexpr (HasQuaternions<Packed>) normalise_quaternions<Packed>(y);
    return every_finite(y);
  }

  [[nodiscard]] static bool every_finite(const Vector& values) noexcept {
    const Pack largest(std::numeric_limits<typename Pack::Lane>::max());
    auto finite = abs(values[0]) <= largest;
    for (std::size_t i = 1; i < values.size(); ++i) finite = finite && abs(values[i]) <= largest;
    return all(finite);
  }

  std::int64_t calls = 0;

 private:
  EquationsOfMotion<Packed, InputLaw> motion_;
};

/// A formula for FixedStepRun whose state stands beside the run's own, which is idle: intervals are cut into steps as
/// for a number.
template <class Motion, class Sum>
class PackedSteps {
 public:
  PackedSteps(Motion& motion, typename Motion::Vector& y, const Sum& sum) noexcept
      : motion_(&motion), y_(&y), sum_(sum) {}

  template <class F, class Number>
  [[nodiscard]] IntegrationStatus step(F&, Number t, Number h, const std::array<Number, 1>& idle,
                                       std::array<Number, 1>& next) {
    using Pack = typename Motion::Pack;
    next = idle;
    typename Motion::Vector reached;
    const bool done = sum_.step(*motion_, Pack(t), Pack(h), *y_, reached) && Motion::every_finite(reached) &&
                      motion_->settle(reached);
    if (done) *y_ = reached;
    return done ? IntegrationStatus::reached_end : IntegrationStatus::model_failure;
  }

 private:
  Motion* motion_;
  typename Motion::Vector* y_;
  Sum sum_;
};

/// A law of inputs for one member and for a pack of them: both, or none.
template <class Single, class Packed>
struct LawOfBoth {
  Single single;
  Packed packed;
  constexpr LawOfBoth(Single of_one, Packed of_pack) : single(std::move(of_one)), packed(std::move(of_pack)) {}
};

/// A MotionEnsemble whose members take their steps in packs, as many at once as a register has lanes:
///   run_ensemble(file, ensemble.head(), ensemble.groups(), options)
/// Each lane's operations are those of a member alone: without fused multiply-adds (-ffp-contract=off) the records are
/// the same bit by bit, with them both stay within the same bound of rounding. With a fixed step a group of which one
/// member fails, or whose members start at different times, is computed member by member; with Taylor's method each
/// lane has steps of its own, and goes as far as it gets: see PackedTaylor.
/// Members with constraints are computed one by one too: nothing projects the lanes of a pack onto them.
/// `InputLaw` is given for both scalars, or for none. Both are called from several threads at once, each for members
/// of its own. In each lane they must give the result of the law of one member for that lane's state. Otherwise a
/// record depends on whether its group was computed in a pack. Numbers of a law, such as gains, belong into the label.
template <template <class> class Mechanism, class Number, class Members, PackableMethod Method,
          template <class> class InputLaw = NoInputs, int lanes = native_lanes<Number>>
class PackedMotionEnsemble {
 public:
  using Single = Mechanism<Number>;
  using Packed = Mechanism<Simd<Number, lanes>>;
  using Alone = MotionEnsemble<Single, Members, Method, InputLaw<Single>>;

  using Laws = LawOfBoth<InputLaw<Single>, InputLaw<Packed>>;

  PackedMotionEnsemble(EnsemblePlan<Number> plan, Members members, Method method, Laws laws)
      : members_(members),
        times_(plan.times),
        method_(method),
        laws_(laws),
        alone_(std::move(plan), std::move(members), method, std::move(laws.single)) {}

  /// Of mechanisms without inputs, or with inputs that are zero.
  PackedMotionEnsemble(EnsemblePlan<Number> plan, Members members,
                       Method method) requires std::same_as<InputLaw<Single>, NoInputs<Single>>
      : PackedMotionEnsemble(std::move(plan), std::move(members), std::move(method), Laws({}, {})) {}

  /// Whether members take steps in packs: where there are constraints, the motion of one member is held on them.
  static constexpr bool in_packs = Single::multiplier_count == 0;

  /// Another question than that of the members alone, because fused operations may round otherwise. The same one where
  /// all members are computed alone.
  [[nodiscard]] RecordHead head() const {
    RecordHead head = alone_.head();
    if (in_packs) head.question = Digest{}.add("packs").add(head.question).add(std::uint64_t{lanes}).value();
    return head;
  }

  /// For run_ensemble; the ensemble must outlive it.
  [[nodiscard]] EnsembleGroups groups() const {
    return {lanes, [this](std::uint64_t first, std::uint64_t count, std::span<double> records) {
              compute(first, count, records);
            }};
  }

  /// The records of members first to first + count - 1, at most as many as there are lanes.
  void compute(std::uint64_t first, std::uint64_t count, std::span<double> records) const {
    if constexpr (in_packs && std::same_as<Method, Taylor>) {
      in_lanes(first, count, records);
      return;
    }
    if constexpr (in_packs && !std::same_as<Method, Taylor>) {
      if (in_a_pack(first, count, records)) return;
    }
    const std::size_t numbers = records.size() / count;
    for (std::uint64_t i = 0; i < count; ++i) alone_(first + i, records.subspan(i * numbers, numbers));
  }

 private:
  using Motion = PackedMotion<Packed, InputLaw<Packed>>;
  using Vector = typename Motion::Vector;

  /// Each lane with steps of its own.
  void in_lanes(std::uint64_t first, std::uint64_t count, std::span<double> records) const {
    std::vector<Member<Single>> members;
    for (std::uint64_t i = 0; i < count; ++i) members.push_back(members_(first + i));
    std::fill(records.begin(), records.end(), std::numeric_limits<double>::quiet_NaN());
    const std::size_t numbers = records.size() / count;
    PackedTaylor<Mechanism, Number, InputLaw, lanes> motions(members, method_, laws_.single, laws_.packed);
    motions.integrate_through(times_, [&](std::size_t i, std::size_t time, const StateVector<Single>& y) {
      for (std::size_t k = 0; k < y.size(); ++k) {
        records[i * numbers + Alone::lead + time * y.size() + k] = static_cast<double>(y[k]);
      }
    });
    for (std::size_t i = 0; i < count; ++i) write_end(motions.result(i), records.subspan(i * numbers, numbers));
  }

  static void write_end(const Result<Number>& result, std::span<double> record) noexcept {
    record[0] = static_cast<double>(result.status);
    record[1] = static_cast<double>(result.evaluation);
    record[2] = static_cast<double>(result.time);
    record[3] = static_cast<double>(result.statistics.calls);
  }

  /// False where the members cannot go together to the end.
  bool in_a_pack(std::uint64_t first, std::uint64_t count, std::span<double> records) const {
    Batch<typename Single::Parameters, typename Packed::Parameters, Number, lanes> parameters(lanes);
    Vector y;
    Number start = Number(0);
    // Lanes beyond the last member repeat it.
    for (int lane = 0; lane < lanes; ++lane) {
      const Member<Single> member = members_(first + std::min(static_cast<std::uint64_t>(lane), count - 1));
      if (lane == 0) start = member.state.time;
      if (!(member.state.time == start)) return false;
      parameters.set(static_cast<std::size_t>(lane), member.parameters);
      StateVector<Single> alone = pack<Single>(member.state);
      if (!start_with_unit_quaternions<Single>(alone)) return false;
      for (std::size_t k = 0; k < y.size(); ++k) y[k].set(lane, alone[k]);
    }
    if (!Motion::every_finite(y)) return false;

    Motion motion(parameters.block(0), laws_.packed);
    using Sum = SummedFormula<typename Method::Formula, typename Motion::Pack, std::tuple_size_v<Vector>>;
    using Steps = PackedSteps<Motion, Sum>;
    const auto idle_system = [](Number, const std::array<Number, 1>&, std::array<Number, 1>&) noexcept {
      return Evaluation::ok;
    };
    std::array<Number, 1> idle{};
    FixedStepRun<Steps, decltype(idle_system), Number, 1> run(idle_system, idle, start, method_.step,
                                                              Steps(motion, y, Sum(method_.compensated)),
                                                              method_.step_limit);
    const std::size_t numbers = records.size() / count;
    std::size_t next = Alone::lead;
    const IgnoreSteps ignore;
    for (const Number time : times_) {
      run.advance(time, ignore);
      if (run.result().status != IntegrationStatus::reached_end) return false;
      for (std::uint64_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < y.size(); ++k) {
          records[i * numbers + next + k] = static_cast<double>(y[k][static_cast<int>(i)]);
        }
      }
      next += y.size();
    }
    Result<Number> result = run.result();
    result.statistics.calls = motion.calls;
    for (std::uint64_t i = 0; i < count; ++i) write_end(result, records.subspan(i * numbers, numbers));
    return true;
  }

  Members members_;
  std::vector<Number> times_;
  Method method_;
  Laws laws_;
  Alone alone_;
};

/// `const auto ensemble = packed_motion_ensemble<arm7::Mechanism, double>({.count = 1000, .times = times}, members,
/// RungeKutta4{.step = 1e-3});`
template <template <class> class Mechanism, class Number, class Members, PackableMethod Method>
[[nodiscard]] auto packed_motion_ensemble(EnsemblePlan<Number> plan, Members members, Method method) {
  return PackedMotionEnsemble<Mechanism, Number, Members, Method>(std::move(plan), std::move(members),
                                                                  std::move(method));
}

/// With a law of inputs for one member and for a pack of them: `packed_motion_ensemble<arm7::Mechanism, double,
/// Law>({.count = 1000, .times = times}, members, method, {Law<Single>{gains}, Law<Packed>{gains}})`. See
/// PackedMotionEnsemble.
template <template <class> class Mechanism, class Number, template <class> class InputLaw, class Members,
          PackableMethod Method>
[[nodiscard]] auto packed_motion_ensemble(
    EnsemblePlan<Number> plan, Members members, Method method,
    LawOfBoth<InputLaw<Mechanism<Number>>, InputLaw<Mechanism<NativeSimd<Number>>>> laws) {
  return PackedMotionEnsemble<Mechanism, Number, Members, Method, InputLaw>(std::move(plan), std::move(members),
                                                                            std::move(method), std::move(laws));
}

}  // namespace torsor::runtime
