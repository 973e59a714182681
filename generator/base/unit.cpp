// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/unit.hpp"

#include <algorithm>
#include <charconv>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

constexpr std::array<const char*, Unit::base_count> base_names{"kg", "m", "s", "A", "K", "mol", "cd"};
constexpr int largest_half_exponent = 126;
/// No unit has more; a stack has an end.
constexpr int deepest = 20;
constexpr std::size_t longest_quoted = 200;

struct NamedUnit {
  std::string_view name;
  Unit unit;
};

constexpr std::array named_units{
    NamedUnit{"1", Unit()},
    NamedUnit{"kg", Unit(1)},
    NamedUnit{"m", Unit(0, 1)},
    NamedUnit{"s", Unit(0, 0, 1)},
    NamedUnit{"A", Unit(0, 0, 0, 1)},
    NamedUnit{"K", Unit::base(4)},
    NamedUnit{"mol", Unit::base(5)},
    NamedUnit{"cd", Unit::base(6)},
    NamedUnit{"rad", Unit()},
    NamedUnit{"sr", Unit()},
    NamedUnit{"N", Unit(1, 1, -2)},
    NamedUnit{"J", Unit(1, 2, -2)},
    NamedUnit{"W", Unit(1, 2, -3)},
    NamedUnit{"Pa", Unit(1, -1, -2)},
    NamedUnit{"Hz", Unit(0, 0, -1)},
    NamedUnit{"C", Unit(0, 0, 1, 1)},
    NamedUnit{"V", Unit(1, 2, -3, -1)},
    NamedUnit{"ohm", Unit(1, 2, -3, -2)},
    NamedUnit{"F", Unit(-1, -2, 4, 2)},
    NamedUnit{"H", Unit(1, 2, -2, -2)},
    NamedUnit{"Wb", Unit(1, 2, -2, -1)},
    NamedUnit{"T", Unit(1, 0, -2, -1)},
};

struct ScaledUnit {
  std::string_view name;
  std::string_view base;
  std::string_view conversion;
};

constexpr std::array scaled_units{
    ScaledUnit{"mm", "m", "multiply the value by 1/1000"},
    ScaledUnit{"cm", "m", "multiply the value by 1/100"},
    ScaledUnit{"dm", "m", "multiply the value by 1/10"},
    ScaledUnit{"km", "m", "multiply the value by 1000"},
    ScaledUnit{"um", "m", "multiply the value by 1e-6"},
    ScaledUnit{"in", "m", "multiply the value by 0.0254"},
    ScaledUnit{"ft", "m", "multiply the value by 0.3048"},
    ScaledUnit{"g", "kg", "multiply the value by 1/1000"},
    ScaledUnit{"mg", "kg", "multiply the value by 1e-6"},
    ScaledUnit{"t", "kg", "multiply the value by 1000"},
    ScaledUnit{"lb", "kg", "multiply the value by 0.45359237"},
    ScaledUnit{"ms", "s", "multiply the value by 1/1000"},
    ScaledUnit{"us", "s", "multiply the value by 1e-6"},
    ScaledUnit{"min", "s", "multiply the value by 60"},
    ScaledUnit{"h", "s", "multiply the value by 3600"},
    ScaledUnit{"deg", "rad", "multiply the value by pi/180"},
    ScaledUnit{"°", "rad", "multiply the value by pi/180"},
    ScaledUnit{"rpm", "rad/s", "multiply the value by pi/30"},
    ScaledUnit{"degC", "K", "add 273.15 to a temperature"},
    ScaledUnit{"mN", "N", "multiply the value by 1/1000"},
    ScaledUnit{"kN", "N", "multiply the value by 1000"},
    ScaledUnit{"kJ", "J", "multiply the value by 1000"},
    ScaledUnit{"mW", "W", "multiply the value by 1/1000"},
    ScaledUnit{"kW", "W", "multiply the value by 1000"},
    ScaledUnit{"bar", "Pa", "multiply the value by 100000"},
    ScaledUnit{"kPa", "Pa", "multiply the value by 1000"},
    ScaledUnit{"MPa", "Pa", "multiply the value by 1e6"},
    ScaledUnit{"GPa", "Pa", "multiply the value by 1e9"},
    ScaledUnit{"kHz", "Hz", "multiply the value by 1000"},
    ScaledUnit{"mA", "A", "multiply the value by 1/1000"},
};

std::int8_t checked_half(int half, const char* operation) {
  if (half > largest_half_exponent || half < -largest_half_exponent) {
    throw UnitError(std::string("the ") + operation + " of units leads to an exponent of " + std::to_string(half / 2) +
                    ", beyond the limit of 63: check the powers of the expression");
  }
  return static_cast<std::int8_t>(half);
}

/// Recursive descent over
///   product  = power { (' ' | '*' | '·') power } { '/' power }
///   power    = ( name | '1' | '(' product ')' ) [ '^' exponent ]
///   exponent = integer | '(' integer [ '/2' ] ')'
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : text_(text), rest_(text) {}

  Unit read() {
    const Unit unit = read_product();
    if (!rest_.empty()) refuse("\"" + std::string(rest_) + "\" is not expected there");
    return unit;
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    const bool whole = text_.size() <= longest_quoted;
    throw UnitError("cannot read the unit \"" + std::string(text_.substr(0, longest_quoted)) + (whole ? "\": " : "...\": ") +
                    reason);
  }

  void skip_spaces() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
  }

  bool take(std::string_view token) {
    if (rest_.substr(0, token.size()) != token) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  Unit read_product() {
    skip_spaces();
    Unit product = read_power();
    bool divided = false;
    for (;;) {
      skip_spaces();
      if (rest_.empty() || rest_.front() == ')') return product;
      if (take("/")) {
        divided = true;
        skip_spaces();
        product = product / read_power();
        continue;
      }
      if (divided) {
        refuse("a product after a '/' can be read in two ways; write parentheses, as in J/(kg K), or J/kg/K");
      }
      if (take("*") || take("·")) skip_spaces();
      product = product * read_power();
    }
  }

  Unit read_power() {
    Unit base;
    if (take("(")) {
      if (++depth_ > deepest) refuse("parentheses are nested more than 20 deep");
      base = read_product();
      if (!take(")")) refuse("a closing parenthesis is missing");
      --depth_;
    } else {
      base = read_name();
    }
    if (!take("^")) return base;
    if (!take("(")) return base.pow(read_integer());
    const int numerator = read_integer();
    const bool halved = take("/2");
    if (!take(")")) refuse("an exponent is an integer or a half, as in m^2, m^-1 or m^(1/2)");
    const Unit power = base.pow(numerator);
    return halved ? power.root() : power;
  }

  int read_integer() {
    int value = 0;
    const auto [end, status] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (status != std::errc() || value > 63 || value < -63) {
      refuse("an exponent is an integer between -63 and 63 or a half, as in m^2, m^-1 or m^(1/2)");
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  Unit read_name() {
    const std::size_t end = rest_.find_first_of(" */^()");
    std::string_view name = rest_.substr(0, std::min(end, rest_.find("·")));
    if (name.empty()) refuse("a unit's name is missing; the dimensionless unit is written 1");
    const auto known = std::find_if(named_units.begin(), named_units.end(),
                                    [name](const NamedUnit& candidate) { return candidate.name == name; });
    if (known != named_units.end()) {
      rest_.remove_prefix(name.size());
      return known->unit;
    }
    const auto scaled = std::find_if(scaled_units.begin(), scaled_units.end(),
                                     [name](const ScaledUnit& candidate) { return candidate.name == name; });
    if (scaled != scaled_units.end()) {
      refuse("\"" + std::string(name) + "\" is a scaled unit; use the SI unit " + std::string(scaled->base) + " (" +
             std::string(scaled->conversion) + ")");
    }
    std::string names;
    std::vector<std::string> words;
    for (const NamedUnit& candidate : named_units) {
      words.emplace_back(candidate.name);
      names += " " + words.back();
    }
    refuse("\"" + std::string(name) + "\" is unknown; " + did_you_mean(name, words) + "the known units are" + names);
  }

  std::string_view text_;
  std::string_view rest_;
  int depth_ = 0;  ///< of parentheses
};

}  // namespace

Unit Unit::parse(std::string_view text) { return UnitReader(text).read(); }

std::string spaced_unit(std::string_view text) {
  std::string spaced;
  bool apart = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool dot = text.substr(i).starts_with("·");
    if (dot || text[i] == ' ' || text[i] == '*') {
      apart = true;
      if (dot) ++i;  // its second byte
      continue;
    }
    const bool beside = spaced.empty() || text[i] == '/' || text[i] == ')' || spaced.back() == '/' || spaced.back() == '(';
    if (apart && !beside) spaced += ' ';
    apart = false;
    spaced += text[i];
  }
  return spaced;
}

Unit Unit::operator*(const Unit& other) const {
  Unit result;
  for (std::size_t index = 0; index < halves_.size(); ++index) {
    result.halves_[index] = checked_half(halves_[index] + other.halves_[index], "product");
  }
  return result;
}

Unit Unit::operator/(const Unit& other) const {
  Unit result;
  for (std::size_t index = 0; index < halves_.size(); ++index) {
    result.halves_[index] = checked_half(halves_[index] - other.halves_[index], "quotient");
  }
  return result;
}

Unit Unit::pow(int exponent) const {
  // Clamped so that the product below cannot overflow; a clamped exponent is refused unless the unit is dimensionless.
  const int bounded = std::clamp(exponent, -2 * largest_half_exponent, 2 * largest_half_exponent);
  Unit result;
  for (std::size_t index = 0; index < halves_.size(); ++index) {
    result.halves_[index] = checked_half(halves_[index] * bounded, "power");
  }
  return result;
}

Unit Unit::root() const {
  Unit result;
  for (std::size_t index = 0; index < halves_.size(); ++index) {
    if (halves_[index] % 2 != 0) {
      throw UnitError("the unit " + to_string() + " has no square root here: the exponent of " +
                      std::string(base_names[index]) + " would be a quarter; take roots of even powers");
    }
    result.halves_[index] = static_cast<std::int8_t>(halves_[index] / 2);
  }
  return result;
}

std::string Unit::to_string() const {
  std::string text;
  for (std::size_t index = 0; index < halves_.size(); ++index) {
    const int half = halves_[index];
    if (half == 0) continue;
    if (!text.empty()) text += ' ';
    text += base_names[index];
    if (half % 2 != 0) {
      text += "^(" + std::to_string(half) + "/2)";
    } else if (half != 2) {
      text += "^" + std::to_string(half / 2);
    }
  }
  return text.empty() ? "1" : text;
}

}  // namespace torsor
