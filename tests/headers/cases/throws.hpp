// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

namespace torsor {
template <class Scalar>
struct scalar_traits {};
}  // namespace torsor

namespace case_under_test {
template <class Scalar>
struct Mechanism {
  struct State {
    std::array<Scalar, 2> q;
  };
  static Scalar energy(const State& state) noexcept {
    if (state.q[0] < Scalar(0)) throw 1;
    return state.q[1];
  }
};
}  // namespace case_under_test
