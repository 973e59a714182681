// SPDX-License-Identifier: GPL-3.0-or-later
// The double pendulum from three states; ends by extrapolation of order 32 with 72 digits.
#include "generated/double_pendulum.hpp"

#include "benchmarks/work_precision/ways.hpp"

namespace work_precision {
namespace {

using Mechanism = double_pendulum::Mechanism<double>;
using State = std::array<double, 4>;

Problem problem(std::string name, std::string text, const State& start, double end_time, const State& end) {
  constexpr double deepest_fall = 3 * 9.81 * 2;
  const Case<Mechanism, 4> motion{start, end_time, end, [](const State& y) { return y; }, deepest_fall};
  return {std::move(name), std::move(text), all_ways(motion)};
}

}  // namespace

Problem double_pendulum_mild() {
  return problem("dp_mild", "double pendulum from (0.75, 0.5) at rest, 10 s", {0.75, 0.5, 0, 0}, 10,
                 {2.875846664665684478653768910960e-02, -3.14591990168469073955176124159e-01,
                  1.816638635026446881379475521071e+00, 1.166381986603743572564266177165e+00});
}

Problem double_pendulum_easy() {
  return problem("dp_easy", "double pendulum from (2, 2.5) at rest, 10 s", {2.0, 2.5, 0, 0}, 10,
                 {-7.53128874294912389398266804858e-01, 1.627933082053701835561177617174e+00,
                  -4.08736885134418806501939800498e+00, -8.86970257838753173566782985360e+00});
}

Problem double_pendulum_hard() {
  return problem("dp_hard", "double pendulum from (pi/2, pi/2) at rest, 20 s",
                 {1.5707963267948966, 1.5707963267948966, 0, 0}, 20,
                 {7.487609755149033159515944895772e-01, -2.58324619988856107490477082164e+01,
                  4.078003969273397255604108576893e+00, 2.779889455355823245354899486589e+00});
}

}  // namespace work_precision
