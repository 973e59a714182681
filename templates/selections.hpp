// SPDX-License-Identifier: MIT-0
#ifndef TORSOR_SELECTION_SUPPORT
#define TORSOR_SELECTION_SUPPORT 1

namespace torsor {

/// Functions that take one of several forms, without a branch, and the angle of a vector. What is not a number stays so.
template <class Scalar>
struct Selections {
  using traits = scalar_traits<Scalar>;

  TORSOR_DEVICE TORSOR_INLINED static Scalar zero() noexcept { return traits::constant(0.0, 0.0f, "0/1"); }
  TORSOR_DEVICE TORSOR_INLINED static Scalar one() noexcept { return traits::constant(1.0, 1.0f, "1/1"); }

  TORSOR_DEVICE TORSOR_INLINED static Scalar absolute(const Scalar& x) noexcept {
    return traits::select(x > zero(), x, zero() - x);
  }
  TORSOR_DEVICE TORSOR_INLINED static Scalar sign(const Scalar& x) noexcept {
    return traits::select(x > zero(), one(), traits::select(x < zero(), -one(), x));
  }
  TORSOR_DEVICE TORSOR_INLINED static Scalar maximum(const Scalar& a, const Scalar& b) noexcept {
    return traits::select(a >= b, a, traits::select(a < b, b, a + b));
  }
  /// a where the condition is not negative, else b.
  TORSOR_DEVICE TORSOR_INLINED static Scalar chosen(const Scalar& condition, const Scalar& a, const Scalar& b) noexcept {
    return traits::select(condition >= zero(), a, traits::select(condition < zero(), b, condition));
  }

  /// The angle of (x, y) in (-pi, pi], 0 of (0, 0): that of the scalar's traits where they have an atan2, else one for
  /// float, double and packs of either, within 2 ulp.
  TORSOR_DEVICE TORSOR_INLINED static Scalar arctangent(const Scalar& y, const Scalar& x) noexcept {
    return arctangent_by<traits>(y, x, 0);
  }

 private:
  template <class Traits>
  TORSOR_DEVICE TORSOR_INLINED static auto arctangent_by(const Scalar& y, const Scalar& x, int) noexcept
      -> decltype(Traits::atan2(y, x)) {
    return Traits::atan2(y, x);
  }
  /// Of the smaller over the larger component, less pi/4 where that quotient is beyond tan(pi/8):
  /// atan r = r + r z P(z), z = r r, |r| <= tan(pi/8); then back to its octant, m pi/4 on, by two parts of pi/4.
  template <class Traits>
  TORSOR_DEVICE TORSOR_INLINED static Scalar arctangent_by(const Scalar& y, const Scalar& x, long) noexcept {
    TORSOR_AS_WRITTEN
    const auto number = [](double in_double, float in_float) { return Traits::constant(in_double, in_float, nullptr); };
    const Scalar along = absolute(x), up = absolute(y);
    const auto steep = up > along;
    const Scalar least = Traits::select(steep, along, up), most = Traits::select(steep, up, along);
    const auto beyond = least > number(0.41421356237309503, 0.41421357f) * most;
    const Scalar below = Traits::select(beyond, least + most, most);
    const Scalar r = Traits::select(beyond, least - most, least) / Traits::select(below <= zero(), one(), below);
    const Scalar z = r * r, z2 = z * z;
    Scalar P;
    if constexpr (Traits::is_float) {
      const Scalar P01 = number(0.0, -0x1.55554ap-2f) + z * number(0.0, 0x1.9991e2p-3f);
      const Scalar P23 = number(0.0, -0x1.23b9a2p-3f) + z * number(0.0, 0x1.b22456p-4f);
      P = P01 + z2 * (P23 + z2 * number(0.0, -0x1.f2e5a8p-5f));
    } else {
      const Scalar z4 = z2 * z2;
      const Scalar P01 = number(-0x1.555555555553dp-2, 0.0f) + z * number(0x1.9999999995869p-3, 0.0f);
      const Scalar P23 = number(-0x1.24924922ad512p-3, 0.0f) + z * number(0x1.c71c70e6083c6p-4, 0.0f);
      const Scalar P45 = number(-0x1.745cf8db95cb6p-4, 0.0f) + z * number(0x1.3b11190f1498dp-4, 0.0f);
      const Scalar P67 = number(-0x1.10ebb7d245dd7p-4, 0.0f) + z * number(0x1.df0f46f2d5465p-5, 0.0f);
      const Scalar P89 = number(-0x1.9cd2b525edae2p-5, 0.0f) + z * number(0x1.37d5ae0dde472p-5, 0.0f);
      P = (P01 + z2 * P23) + z4 * ((P45 + z2 * P67) + z4 * (P89 + z2 * number(-0x1.256aac8b848dfp-6, 0.0f)));
    }
    const Scalar turn = r + r * z * P;
    const Scalar two = number(2.0, 2.0f), four = number(4.0, 4.0f);
    const Scalar eighths = Traits::select(beyond, one(), zero());
    const auto back = x < zero();
    const Scalar m_right = Traits::select(steep, two - eighths, eighths), t_right = Traits::select(steep, -turn, turn);
    const Scalar m = Traits::select(back, four - m_right, m_right), t = Traits::select(back, -t_right, t_right);
    const Scalar high = number(0x1.921fb54442d18p-1, 0x1.921fbp-1f), low = number(0x1.1a62633145c07p-55, 0x1.5110b4p-23f);
    const Scalar angle = m * high + (m * low + t);
    return Traits::select(y < zero(), -angle, angle);
  }
};

}  // namespace torsor
#endif
