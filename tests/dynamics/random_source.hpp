// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::testing_mechanisms {

/// Small exact numbers, the same from one seed everywhere; draw them one statement each.
class RandomSource {
 public:
  explicit RandomSource(unsigned seed) : random_(seed) {}

  int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }
  bool one_in(int n) { return below(n) == 0; }
  /// A fraction in (0.2, 1.8) with a prime denominator.
  Number fraction() {
    static constexpr int primes[] = {11, 13, 17, 19, 23};
    const int denominator = primes[below(5)];
    return Number::rational(denominator / 3 + below(denominator + denominator / 3), denominator);
  }
  Number signed_fraction() {
    const Number size = fraction();
    return one_in(2) ? size : -size;
  }
  Expression quantity(const char* unit) { return Expression::quantity(fraction(), Unit::parse(unit)); }
  Triple vector(const char* unit) {
    Triple v;
    for (Expression& component : v) {
      const Number number = one_in(4) ? Number() : signed_fraction();
      component = Expression::quantity(number, Unit::parse(unit));
    }
    return v;
  }

  Triple axis() {
    switch (below(6)) {
      case 0:
        return axis::x;
      case 1:
        return -axis::y;
      case 2:
        return axis::z;
      case 3:
        return {Number::rational(2, 3), Number::rational(-1, 3), Number::rational(2, 3)};  // exact unit vector
      case 4:
        return {1, 1, 0};
      default:
        return {1, -2, 3};  // its length is an irrational root
    }
  }

  Placement placement() {
    Placement place;
    place.origin = vector("m");
    const int first = below(3);
    const int angle = below(24);
    place.rotation = Rotation::about(first, angle);
    if (one_in(2)) place.rotation = place.rotation * Rotation::about((first + 1) % 3, below(24));
    return place;
  }

  /// A solid box of random edges, so that the operator is that of a true body; products of inertia by its own axes.
  Inertia inertia(const Expression& mass) {
    const Expression a = quantity("m");
    const Expression b = quantity("m");
    const Expression c = quantity("m");
    const Inertia box = Inertia::box(mass, a, b, c);
    if (one_in(3)) {
      return Inertia::general({.mass = mass, .xx = box.xx, .yy = box.yy, .zz = box.zz, .xy = box.xx / 7,
                               .xz = -box.yy / 9, .yz = box.zz / 11})
          .at(vector("m"));
    }
    return box.at(vector("m"));
  }

 private:
  std::mt19937 random_;
};

}  // namespace torsor::testing_mechanisms
