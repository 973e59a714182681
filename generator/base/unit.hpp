// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "torsor/generator/base/error.hpp"

namespace torsor {

/// A dimension of the SI: product of powers of kg, m, s, A, K, mol, cd. Exponents are multiples of 1/2 (a root of a
/// mass is met on the way to a frequency). Radian and steradian are dimensionless. There are no scaled units: a value
/// is always in the base unit.
class Unit {
 public:
  static constexpr int base_count = 7;

  /// Dimensionless.
  constexpr Unit() = default;
  /// kg^mass m^length s^time A^current, whole exponents within ±63 (else UnitError).
  constexpr explicit Unit(int mass, int length = 0, int time = 0, int current = 0)
      : halves_{halves(mass), halves(length), halves(time), halves(current)} {}
  /// The base unit `index`, in the order kg, m, s, A, K, mol, cd.
  static constexpr Unit base(int index) {
    Unit unit;
    unit.halves_[static_cast<std::size_t>(index)] = 2;
    return unit;
  }

  /// Reads "kg m^2/s^2", "N*m", "N·m", "N s/m", "rad/s", "J/(kg K)", "m^(1/2)", "1". Factors are joined by a space, '*'
  /// or '·'; each '/' divides by the one factor or parenthesis after it. A product after a '/' ("J/kg K") has two
  /// readings and is refused. Throws UnitError naming the text: unknown names (the known ones are listed), scaled
  /// units such as mm, g or deg (the SI unit to use is told).
  static Unit parse(std::string_view text);

  constexpr bool is_dimensionless() const { return *this == Unit(); }
  /// Twice the exponent of base unit `index`, in the order kg, m, s, A, K, mol, cd.
  constexpr int half_exponent(int index) const { return halves_[static_cast<std::size_t>(index)]; }

  /// Throw UnitError when an exponent leaves ±63.
  Unit operator*(const Unit& other) const;
  Unit operator/(const Unit& other) const;
  Unit pow(int exponent) const;
  /// Square root. Throws UnitError when an exponent would need quarters.
  Unit root() const;

  constexpr bool operator==(const Unit&) const = default;

  /// Base units, "kg m^2 s^-2", "kg^(1/2)"; "1" when dimensionless. parse reads it back.
  std::string to_string() const;

 private:
  static constexpr std::int8_t halves(int exponent) {
    if (exponent > 63 || exponent < -63) throw UnitError("a unit's exponent lies beyond 63: check its powers");
    return static_cast<std::int8_t>(2 * exponent);
  }

  std::array<std::int8_t, base_count> halves_{};
};

/// The text of a unit as it is set in print: "N*m" and "N·m" become "N m". `parse` reads it as it reads `text`.
std::string spaced_unit(std::string_view text);

namespace units {
inline constexpr Unit one{};
inline constexpr Unit kilogram{1};
inline constexpr Unit metre{0, 1};
inline constexpr Unit second{0, 0, 1};
inline constexpr Unit radian{};
inline constexpr Unit metre_per_second{0, 1, -1};
inline constexpr Unit metre_per_second_squared{0, 1, -2};
inline constexpr Unit radian_per_second{0, 0, -1};
inline constexpr Unit radian_per_second_squared{0, 0, -2};
inline constexpr Unit newton{1, 1, -2};
inline constexpr Unit newton_metre{1, 2, -2};
inline constexpr Unit joule{1, 2, -2};
inline constexpr Unit watt{1, 2, -3};
inline constexpr Unit kilogram_metre_squared{1, 2};
}  // namespace units

}  // namespace torsor
