// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include <cln/integer.h>
#include <cln/rational.h>
#include <fmt/format.h>

#include "torsor/generator/printing/notation.hpp"

namespace torsor::printing {
namespace {

/// A call; a selection by cases, "[a if c >= 0, else b]", the forms of a nested one in one row.
std::string call_text(const WrittenFactor& factor) {
  if (factor.base->function == Function::select) {
    std::string rows;
    for (const Case& each : cases_of(factor)) {
      rows += text(*each.value);
      if (each.condition != nullptr) rows += fmt::format(" if {} {} 0, else ", text(*each.condition), each.holds ? ">=" : "<");
    }
    return fmt::format("[{}]", rows);
  }
  std::string inside = text(factor.inside);
  for (const Written& other : factor.others) inside += ", " + text(other);
  return fmt::format("{}({})", name_on_paper(factor), inside);
}

std::string factor_text(const WrittenFactor& factor, int halves) {
  std::string base;
  if (!factor.base) {
    base = text(factor.inside);
    if (halves == 1) return fmt::format("sqrt({})", base);
    base = factor.size ? fmt::format("|{}|", base) : fmt::format("({})", base);
  } else {
    switch (factor.base->kind) {
      case Base::Kind::symbol:
        base = factor.base->symbol->name;
        break;
      case Base::Kind::definition:
        base = fmt::format("z{}", factor.base->definition);
        break;
      default:
        base = call_text(factor);
        break;
    }
    if (halves == 1) return fmt::format("sqrt({})", base);
  }
  if (halves == 2) return base;
  return halves % 2 == 0 ? fmt::format("{}^{}", base, halves / 2) : fmt::format("{}^({}/2)", base, halves);
}

/// The term without its sign.
std::string term_text(const WrittenTerm& term) {
  const Number size = term.coefficient.abs();
  std::string numerator;
  std::string denominator;
  int divisors = 0;
  for (const WrittenFactor& factor : term.factors) {
    std::string& side = factor.halves > 0 ? numerator : denominator;
    divisors += factor.halves < 0 ? 1 : 0;
    if (!side.empty()) side += " ";
    side += factor_text(factor, std::abs(factor.halves));
  }
  if (!size.is_one() || numerator.empty()) {
    std::string number = coefficient_text(size);
    const bool sum = number.find(" + ") != std::string::npos || number.find(" - ") != std::string::npos;
    if (sum && !term.factors.empty()) number = fmt::format("({})", number);
    numerator = numerator.empty() ? number : fmt::format("{} {}", number, numerator);
  }
  if (divisors == 0) return numerator;
  return divisors > 1 ? fmt::format("{}/({})", numerator, denominator) : fmt::format("{}/{}", numerator, denominator);
}

std::string sign_text(const WrittenTerm& term, bool first) {
  const bool negative = term.coefficient.sign() < 0;
  if (first) return negative ? "-" : "";
  return negative ? "- " : "+ ";
}

}  // namespace

std::string text(const Written& written) {
  std::string result;
  for (const WrittenTerm& term : with_parts_of_numbers(written)) {
    if (!result.empty()) result += " ";
    result += sign_text(term, result.empty()) + term_text(term);
  }
  return result.empty() ? "0" : result;
}

std::string text_lines(const Written& written, std::size_t first_column, const std::string& indent, std::size_t wanted_width) {
  // A name may be as long as a line: what stands beside it needs room all the same.
  const std::size_t width = std::max(wanted_width, indent.size() + 40);
  std::string result;
  std::size_t column = first_column;
  const auto put = [&](const std::string& piece) {
    if (!result.empty()) {
      const bool fits = column + 1 + piece.size() <= width;
      result += fits ? " " : "\n" + indent;
      column = fits ? column + 1 : indent.size();
    }
    result += piece;
    column += piece.size();
  };
  for (const WrittenTerm& term : with_parts_of_numbers(written)) {
    std::string piece = sign_text(term, result.empty()) + term_text(term);
    // A term that no line can hold is broken inside its parentheses.
    while (piece.size() + indent.size() > width) {
      const std::size_t from = width - indent.size();
      std::size_t cut = from;
      while (cut > 3 && piece.compare(cut, 3, " + ") != 0 && piece.compare(cut, 3, " - ") != 0) --cut;
      if (cut <= 3) break;
      put(piece.substr(0, cut));
      piece.erase(0, cut + 1);
    }
    put(piece);
  }
  return result.empty() ? "0" : result;
}

namespace {

/// The first digits of a fraction of more than 17 digits, as many as a double has, and dots: 0.96802809299417873... or
/// 3.3333333333333333...e-18. None: it is written as it is.
std::optional<std::string> first_digits(const cln::cl_RA& size) {
  constexpr int count = 17;
  const std::string over = Number(cln::numerator(size)).to_string(), under = Number(cln::denominator(size)).to_string();
  if (under == "1" || (over.size() <= count && under.size() <= count)) return std::nullopt;
  const auto ten_to = [](int power) {
    const cln::cl_RA size_of_power = cln::expt(cln::cl_RA(10), cln::cl_I(std::abs(power)));
    return power < 0 ? cln::recip(size_of_power) : size_of_power;
  };
  int power = static_cast<int>(over.size()) - static_cast<int>(under.size());
  if (size < ten_to(power)) --power;
  std::string digits = Number(cln::floor1(size * ten_to(count - 1 - power))).to_string();
  if (power < -4 || power >= count - 1) return fmt::format("{}.{}...e{}", digits[0], digits.substr(1), power);
  if (power < 0) return fmt::format("0.{}{}...", std::string(static_cast<std::size_t>(-power - 1), '0'), digits);
  const auto point = static_cast<std::size_t>(power + 1);
  return fmt::format("{}.{}...", digits.substr(0, point), digits.substr(point));
}

/// A number with roots: 1/2 + 1/3 sqrt(2).
std::string text_with_roots(const Number& number) {
  std::string text = number.to_string();
  std::replace(text.begin(), text.end(), '*', ' ');
  for (int i = 0; i < 4; ++i) {
    const cln::cl_RA size = cln::abs(number.part(i));
    if (const auto digits = first_digits(size)) {
      const std::string written = Number(size).to_string();
      text.replace(text.find(written), written.size(), *digits);
    }
  }
  return text;
}

/// Digits and the power of ten of a decimal with five zeros in a row; none of any other.
std::optional<std::pair<std::string, int>> with_power_of_ten(const std::string& decimal) {
  constexpr std::size_t many = 5;
  const std::string sign = decimal.starts_with('-') ? "-" : "";
  const std::string digits = decimal.substr(sign.size());
  if (digits.find_first_not_of("0123456789.") != std::string::npos || digits.ends_with('.')) return std::nullopt;
  const std::size_t point = digits.find('.');
  std::string mantissa;
  int power = 0;
  if (point == std::string::npos) {
    const std::size_t last = digits.find_last_not_of('0');
    if (last == std::string::npos || digits.size() - last - 1 < many) return std::nullopt;
    mantissa = digits.substr(0, last + 1);
    power = static_cast<int>(digits.size()) - 1;
  } else {
    const std::size_t first = digits.find_first_not_of("0.");
    if (digits[0] != '0' || first - point - 1 < many) return std::nullopt;
    mantissa = digits.substr(first);
    power = -static_cast<int>(first - point);
  }
  if (mantissa.size() > 1) mantissa.insert(1, ".");
  return std::pair{sign + mantissa, power};
}

}  // namespace

std::string value_text(const Number& number) {
  const std::string decimal = decimal_text(number);
  const auto parts = with_power_of_ten(decimal);
  return parts ? fmt::format("{}e{}", parts->first, parts->second) : decimal;
}

std::string value_latex(const Number& number) {
  const std::string decimal = decimal_text(number);
  const auto parts = with_power_of_ten(decimal);
  return parts ? fmt::format("{} \\cdot 10^{{{}}}", parts->first, parts->second) : dots_in_latex(decimal);
}

std::string dots_in_latex(const std::string& decimal) {
  const std::size_t dots = decimal.find("...");
  if (dots == std::string::npos) return decimal;
  const std::string power = decimal.substr(dots + 3);  // nothing, or e-7
  return decimal.substr(0, dots) + "\\ldots" + (power.empty() ? "" : fmt::format(" \\cdot 10^{{{}}}", power.substr(1)));
}

bool is_read_as_decimal(const cln::cl_RA& number) {
  const cln::cl_I denominator = cln::denominator(number);
  if (denominator > 1000 || (denominator > 1 && cln::abs(cln::numerator(number)) > cln::expt_pos(cln::cl_I(10), 17))) return true;
  const auto divides = [&](int by) { return cln::rem(denominator, by) == 0; };
  return divides(25) || (divides(5) && denominator > 100);
}

std::string coefficient_text(const Number& number) {
  if (!number.is_rational()) return text_with_roots(number);
  return is_read_as_decimal(number.part(0)) ? decimal_text(number) : number.to_string();
}

std::string decimal_text(const Number& number) {
  if (!number.is_rational()) return text_with_roots(number);
  const cln::cl_RA& value = number.part(0);
  cln::cl_I scale = 1;
  for (int places = 0; places <= 24; ++places, scale = scale * 10) {
    const cln::cl_RA scaled = value * scale;
    if (cln::denominator(scaled) != 1) continue;
    if (places == 0) return number.to_string();
    std::string digits = Number(cln::abs(cln::numerator(scaled))).to_string();
    const auto count = static_cast<std::size_t>(places);
    if (digits.size() <= count) digits.insert(0, count + 1 - digits.size(), '0');
    const std::size_t point = digits.size() - count;
    return fmt::format("{}{}.{}", number.sign() < 0 ? "-" : "", digits.substr(0, point), digits.substr(point));
  }
  const auto digits = first_digits(cln::abs(value));
  return digits ? (number.sign() < 0 ? "-" : "") + *digits : number.to_string();
}

}  // namespace torsor::printing
