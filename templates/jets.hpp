// SPDX-License-Identifier: MIT
#ifndef TORSOR_JET_SUPPORT
#define TORSOR_JET_SUPPORT 1

namespace torsor {

/// Pairs of Taylor series and their convolutions, side by side in lanes. A coefficient of order 0 is not kept: whoever
/// asks for a sum adds the terms with it.
template <class Scalar, int count>
struct Convolutions {
  static constexpr int order_max = 30;
  static constexpr int lanes = (count + 3) / 4 * 4;
  struct Sums {
    Scalar lane[lanes];
    TORSOR_DEVICE const Scalar& operator[](int i) const noexcept { return lane[i]; }
  };

  /// The terms a_i b_(k-i), i = 1..k-1, of each pair, summed.
  TORSOR_DEVICE Sums sums(int k) const noexcept {
    Sums result;
    for (int l = 0; l < lanes; ++l) result.lane[l] = scalar_traits<Scalar>::constant(0.0, 0.0f, "0/1");
    for (int i = 1; i < k; ++i) {
      for (int l = 0; l < lanes; ++l) result.lane[l] = result.lane[l] + left_[i][l] * right_[k - i][l];
    }
    return result;
  }

  /// The coefficients of order k.
  TORSOR_DEVICE void keep(int k, const Scalar (&left)[count], const Scalar (&right)[count]) noexcept {
    for (int l = 0; l < count; ++l) left_[k][l] = left[l];
    for (int l = 0; l < count; ++l) right_[k][l] = right[l];
    for (int l = count; l < lanes; ++l) {
      left_[k][l] = right_[k][l] = scalar_traits<Scalar>::constant(0.0, 0.0f, "0/1");
    }
  }

 private:
  Scalar left_[order_max][lanes], right_[order_max][lanes];
};

}  // namespace torsor
#endif
