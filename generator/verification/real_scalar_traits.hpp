// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Include this after a generated header: that header declares the template which is specialised here.
#ifndef TORSOR_KERNEL_SUPPORT
#error "include a generated header before generator/verification/real_scalar_traits.hpp"
#endif

#include "torsor/generator/base/high_precision.hpp"

namespace torsor {

/// Lets a generated kernel run on Real. A constant comes from its exact text at Real::working_digits(); its double and
/// float literals are not looked at.
template <>
struct scalar_traits<Real> {
  static Real constant(double, float, const char* exact) noexcept { return Real::constant(exact); }
  template <class Callable>
  static Real formula(double, float, const Callable& callable) noexcept {
    return callable();
  }
  static Real pi() noexcept { return Real::pi(); }
  static Real select(bool condition, const Real& if_true, const Real& if_false) noexcept {
    return condition ? if_true : if_false;
  }
  static void sincos(const Real& angle, Real& sine, Real& cosine) noexcept { torsor::sincos(angle, sine, cosine); }
  static Real sqrt(const Real& x) noexcept { return torsor::sqrt(x); }
  static Real exp(const Real& x) noexcept { return torsor::exp(x); }
  static Real log(const Real& x) noexcept { return torsor::log(x); }
  static Real atan2(const Real& y, const Real& x) noexcept { return torsor::atan2(y, x); }
  static bool regular(const Real& pivot, const Real& diagonal) noexcept {
    return !(pivot <= pivot.epsilon() * torsor::abs(diagonal));
  }
  static bool finite(const Real& x) noexcept { return !x.is_nan(); }
};

}  // namespace torsor
