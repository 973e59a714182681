// SPDX-License-Identifier: MIT
#pragma once

namespace torsor::runtime {

/// The coefficients of Dormand and Prince's pair 5(4) and of its continuous extension.
/// Source: Hairer-Nørsett-Wanner I, table II.5.2; extension: their code dopri5, constants D1 to D7.
template <class Scalar>
struct DormandPrinceTableau {
  static constexpr Scalar ratio(double numerator, double denominator) noexcept {
    return static_cast<Scalar>(static_cast<long double>(numerator) / static_cast<long double>(denominator));
  }
  static constexpr Scalar c2 = ratio(1, 5), c3 = ratio(3, 10), c4 = ratio(4, 5), c5 = ratio(8, 9);
  static constexpr Scalar a21 = ratio(1, 5);
  static constexpr Scalar a31 = ratio(3, 40), a32 = ratio(9, 40);
  static constexpr Scalar a41 = ratio(44, 45), a42 = ratio(-56, 15), a43 = ratio(32, 9);
  static constexpr Scalar a51 = ratio(19372, 6561), a52 = ratio(-25360, 2187), a53 = ratio(64448, 6561),
                          a54 = ratio(-212, 729);
  static constexpr Scalar a61 = ratio(9017, 3168), a62 = ratio(-355, 33), a63 = ratio(46732, 5247),
                          a64 = ratio(49, 176), a65 = ratio(-5103, 18656);
  // The row of the solution of order 5 is also the seventh stage: first same as last.
  static constexpr Scalar a71 = ratio(35, 384), a73 = ratio(500, 1113), a74 = ratio(125, 192), a75 = ratio(-2187, 6784),
                          a76 = ratio(11, 84);
  // Difference of the solutions of orders 5 and 4.
  static constexpr Scalar e1 = ratio(71, 57600), e3 = ratio(-71, 16695), e4 = ratio(71, 1920),
                          e5 = ratio(-17253, 339200), e6 = ratio(22, 525), e7 = ratio(-1, 40);
  static constexpr Scalar d1 = ratio(-12715105075.0, 11282082432.0), d3 = ratio(87487479700.0, 32700410799.0),
                          d4 = ratio(-10690763975.0, 1880347072.0), d5 = ratio(701980252875.0, 199316789632.0),
                          d6 = ratio(-1453857185.0, 822651844.0), d7 = ratio(69997945.0, 29380423.0);
};

}  // namespace torsor::runtime
