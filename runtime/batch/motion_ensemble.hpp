// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torsor/runtime/batch/ensemble.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/digest.hpp"

namespace torsor::runtime {

/// The options that all methods of fixed step have.
template <class Method>
void add_fixed_step(Digest& digest, const Method& method) noexcept {
  digest.add(method.step).add(static_cast<std::uint64_t>(method.step_limit)).add(std::uint64_t{method.compensated});
}
/// What an integrator's results depend on. For a method of your own, declare such a function beside it.
inline void add_to_digest(Digest& digest, const Midpoint& method) noexcept {
  add_fixed_step(digest.add("midpoint"), method);
}
inline void add_to_digest(Digest& digest, const RungeKutta4& method) noexcept {
  add_fixed_step(digest.add("Runge-Kutta 4"), method);
}
/// The options that all methods with steps of their own choice have.
template <class Method>
void add_step_control(Digest& digest, const Method& method) noexcept {
  digest.add(method.relative_tolerance).add(method.absolute_tolerance);
  digest.add(method.first_step).add(method.largest_step).add(static_cast<std::uint64_t>(method.step_limit));
  digest.add(std::uint64_t{method.compensated});
}
inline void add_to_digest(Digest& digest, const DormandPrince54& method) noexcept {
  add_step_control(digest.add("Dormand-Prince 5(4)"), method);
}
inline void add_to_digest(Digest& digest, const DormandPrince853& method) noexcept {
  add_step_control(digest.add("Dormand-Prince 8(5,3)"), method);
}
inline void add_to_digest(Digest& digest, const Taylor& method) noexcept {
  add_step_control(digest.add("Taylor").add(static_cast<std::uint64_t>(method.order)), method);
}

/// What tells one member of an ensemble from another.
template <MechanismModel M>
struct Member {
  typename M::Parameters parameters = M::default_parameters();
  typename M::State state = initial_state_with<M>(parameters);
};

/// How a member's motion ended, and its states [q; v] at the times it reached.
template <MechanismModel M>
struct MemberMotion {
  IntegrationStatus status = IntegrationStatus::reached_end;
  Evaluation evaluation = Evaluation::ok;
  double end = 0.0;        ///< the last time it reached
  std::int64_t calls = 0;  ///< of the model
  std::vector<StateVector<M>> states;
};

/// How many members an ensemble has, and what it keeps of each.
template <class Scalar>
struct EnsemblePlan {
  std::uint64_t count = 0;      ///< of members
  std::vector<Scalar> times{};  ///< [s] at which each member's state is kept, in the order of its motion
  /// Tells apart what cannot be seen from an ensemble: the law of inputs, and the version of a mechanism without a
  /// `fingerprint`.
  std::string label{};
};

/// Many motions of one mechanism: member i starts in a state of its own, with parameters of its own, and is integrated
/// by the same method through the same times. `members(i)` gives a Member<M>, the same whenever it is asked, from any
/// thread. The records of `run_ensemble(file, ensemble.head(), ensemble)` have: status, what the model said, the last
/// time, calls, then [q; v] at each time; what was not reached is not a number. Quaternions are given norm 1 at the start;
/// a member with a quaternion of zeros has model_failure and not_finite.
template <HasForwardDynamics M, class Members, class Method, class InputLaw = NoInputs<M>>
requires std::same_as<std::invoke_result_t<const Members&, std::uint64_t>, Member<M>>
class MotionEnsemble {
 public:
  using Scalar = ScalarOf<M>;
  static constexpr std::size_t size = coordinates_of<M> + velocities_of<M>, lead = 4;

  MotionEnsemble(EnsemblePlan<Scalar> plan, Members members, Method method, InputLaw law = {})
      : plan_(std::move(plan)), members_(std::move(members)), method_(std::move(method)), law_(std::move(law)) {}

  /// The question: the mechanism, every member, the times, the method, the label.
  [[nodiscard]] RecordHead head() const {
    Digest digest;
    digest.add(std::string_view(plan_.label)).add(std::uint64_t{sizeof(Scalar)}).add(std::uint64_t{size});
    if constexpr (requires { M::name; }) digest.add(std::string_view(M::name));
    if constexpr (requires { M::fingerprint; }) digest.add(static_cast<std::uint64_t>(M::fingerprint));
    for (const Scalar time : plan_.times) digest.add(static_cast<double>(time));
    add_to_digest(digest, method_);
    for (std::uint64_t i = 0; i < plan_.count; ++i) {
      const Member<M> member = members_(i);
      if constexpr (M::Parameters::size > 0) {
        for (int k = 0; k < M::Parameters::size; ++k) digest.add(static_cast<double>(parameter(member.parameters, k)));
      }
      digest.add(static_cast<double>(member.state.time));
      for (const Scalar y : pack<M>(member.state)) digest.add(static_cast<double>(y));
    }
    return {digest.value(), plan_.count, lead + size * plan_.times.size()};
  }

  void operator()(std::uint64_t index, std::span<double> record) const {
    const Member<M> member = members_(index);
    for (double& number : record) number = std::numeric_limits<double>::quiet_NaN();
    StateVector<M> y = pack<M>(member.state);
    std::size_t next = lead;
    const MotionOf<M, InputLaw> motion(member.parameters, law_);
    const auto keep = [&](Scalar, const StateVector<M>& reached) {
      for (const Scalar value : reached) record[next++] = static_cast<double>(value);
    };
    Result<Scalar> result;
    result.time = member.state.time;
    if (!start_with_unit_quaternions<M>(y)) {
      result.evaluation = Evaluation::not_finite;
    } else if constexpr (requires { motion.settle(result.time, y); }) {
      result.evaluation = motion.settle(result.time, y);
    }
    if (result.evaluation == Evaluation::ok) {
      result = integrate_through(motion, y, member.state.time, plan_.times, method_, keep);
    } else {  // a quaternion of zeros; or parameters of this member have opened the start, beyond what can be closed
      result.status = IntegrationStatus::model_failure;
    }
    record[0] = static_cast<double>(result.status);
    record[1] = static_cast<double>(result.evaluation);
    record[2] = static_cast<double>(result.time);
    record[3] = static_cast<double>(result.statistics.calls);
  }

 private:
  static Scalar parameter(const typename M::Parameters& parameters, int k) noexcept {
    static_assert(sizeof(parameters) == sizeof(Scalar) * static_cast<std::size_t>(M::Parameters::size));
    return std::bit_cast<std::array<Scalar, static_cast<std::size_t>(M::Parameters::size)>>(
        parameters)[static_cast<std::size_t>(k)];
  }

  EnsemblePlan<Scalar> plan_;
  Members members_;
  Method method_;
  InputLaw law_;
};

/// `auto ensemble = motion_ensemble<Mechanism<double>>({.count = 1000, .times = times}, members, DormandPrince54{});`
template <HasForwardDynamics M, class Members, class Method, class InputLaw = NoInputs<M>>
[[nodiscard]] auto motion_ensemble(EnsemblePlan<ScalarOf<M>> plan, Members members, Method method, InputLaw law = {}) {
  return MotionEnsemble<M, Members, Method, InputLaw>(std::move(plan), std::move(members), std::move(method),
                                                      std::move(law));
}

/// A record of a MotionEnsemble, read back.
template <MechanismModel M>
[[nodiscard]] MemberMotion<M> member_motion(std::span<const double> record) {
  constexpr std::size_t size = coordinates_of<M> + velocities_of<M>, lead = 4;
  MemberMotion<M> motion;
  motion.status = static_cast<IntegrationStatus>(static_cast<int>(record[0]));
  motion.evaluation = static_cast<Evaluation>(static_cast<int>(record[1]));
  motion.end = record[2];
  motion.calls = static_cast<std::int64_t>(record[3]);
  for (std::size_t first = lead; first + size <= record.size() && !std::isnan(record[first]); first += size) {
    StateVector<M>& y = motion.states.emplace_back();
    for (std::size_t i = 0; i < size; ++i) y[i] = static_cast<ScalarOf<M>>(record[first + i]);
  }
  return motion;
}

}  // namespace torsor::runtime
