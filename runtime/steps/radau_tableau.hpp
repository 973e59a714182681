// SPDX-License-Identifier: MIT
#pragma once

namespace torsor::runtime {

/// The coefficients of Radau IIA of order 5 (three stages; Hairer-Wanner II, IV.5, table 5.6) and of the way its
/// equations are solved (IV.8, and the code radau5 of the same authors): A⁻¹ = T Λ T⁻¹ with one real eigenvalue and one
/// pair, the roots of λ³ - 9 λ² + 36 λ - 60.
template <class Scalar>
struct RadauTableau {
  static constexpr Scalar c1 = Scalar(0.15505102572168219018L), c2 = Scalar(0.64494897427831780982L);

  static constexpr Scalar real = Scalar(3.6378342527444957322L);
  static constexpr Scalar pair_re = Scalar(2.6810828736277521339L), pair_im = Scalar(3.0504301992474105694L);

  static constexpr Scalar t11 = Scalar(9.1232394870892942792e-2L), t12 = Scalar(-0.14125529502095420843L),
                          t13 = Scalar(-3.0029194105147424492e-2L);
  static constexpr Scalar t21 = Scalar(0.24171793270710701896L), t22 = Scalar(0.20412935229379993199L),
                          t23 = Scalar(0.38294211275726193779L);
  static constexpr Scalar t31 = Scalar(0.96604818261509293619L);  // t32 = 1, t33 = 0

  static constexpr Scalar i11 = Scalar(4.3255798900631553510L), i12 = Scalar(0.33919925181580986954L),
                          i13 = Scalar(0.54177053993587487119L);
  static constexpr Scalar i21 = Scalar(-4.1787185915519047273L), i22 = Scalar(-0.32768282076106238708L),
                          i23 = Scalar(0.47662355450055045196L);
  static constexpr Scalar i31 = Scalar(-0.50287263494578687595L), i32 = Scalar(2.5719269498556054292L),
                          i33 = Scalar(-0.59603920482822492497L);

  // The error's weights of the stages: -(13 + 7 √6)/3, (-13 + 7 √6)/3, -1/3.
  static constexpr Scalar e1 = Scalar(-10.048809399827415562L), e2 = Scalar(1.3821427331607488958L),
                          e3 = Scalar(-0.33333333333333333333L);
};

}  // namespace torsor::runtime
