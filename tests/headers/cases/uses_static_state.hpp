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
    static Scalar last{};
    last += state.q[0];
    return last;
  }
};
}  // namespace case_under_test
