// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/notation_latex.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor::printing {
namespace {

constexpr std::array<std::string_view, 33> greek{
    "alpha", "beta",  "gamma", "delta", "epsilon", "zeta",  "eta", "theta",   "iota", "kappa", "lambda",
    "mu",    "nu",    "xi",    "pi",    "rho",     "sigma", "tau", "upsilon", "phi",  "chi",   "psi",
    "omega", "Gamma", "Delta", "Theta", "Lambda",  "Xi",    "Pi",  "Sigma",   "Phi",  "Psi",   "Omega"};

bool is_greek(const std::string& word) { return std::find(greek.begin(), greek.end(), word) != greek.end(); }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string word(const std::string& text) {
  if (is_greek(text)) return fmt::format("\\{}", text);
  return text.size() == 1 ? text : fmt::format("\\mathrm{{{}}}", text);
}

std::string subscript(const std::string& text) {
  return std::all_of(text.begin(), text.end(), is_digit) ? text : latex_name(text);
}

/// A rational as its size, e.g. \frac{1}{2}.
std::string rational(const cln::cl_RA& value) {
  if (is_read_as_decimal(value)) {
    const std::string decimal = decimal_text(Number(cln::abs(value)));
    if (decimal.find('/') == std::string::npos) return dots_in_latex(decimal);
  }
  const std::string numerator = Number(cln::abs(cln::numerator(value))).to_string();
  const std::string denominator = Number(cln::denominator(value)).to_string();
  return denominator == "1" ? numerator : fmt::format("\\frac{{{}}}{{{}}}", numerator, denominator);
}

std::string number_latex(const Number& size, bool with_factors) {
  constexpr std::array<const char*, 4> roots{"", "\\sqrt{2}", "\\sqrt{3}", "\\sqrt{6}"};
  std::string result;
  int parts = 0;
  for (int i = 0; i < 4; ++i) {
    const cln::cl_RA& part = size.part(i);
    if (part == 0) continue;
    const bool negative = part < 0;
    if (parts > 0) result += negative ? " - " : " + ";
    if (parts == 0 && negative) result += "-";
    const std::string number = rational(part);
    result += i > 0 && number == "1" ? "" : number + (i > 0 ? " " : "");
    result += roots[static_cast<std::size_t>(i)];
    ++parts;
  }
  return parts > 1 && with_factors ? fmt::format("\\left({}\\right)", result) : result;
}

/// Calls whose power does not stand after their name.
std::string call_latex(const WrittenFactor& factor) {
  const std::string first = latex(factor.inside);
  switch (factor.base->function) {
    case Function::abs: return fmt::format("\\left|{}\\right|", first);
    case Function::select: {
      std::string rows;
      for (const Case& each : cases_of(factor)) {
        rows += latex(*each.value) + " & ";
        rows += each.condition == nullptr
                    ? "\\text{else}"
                    : fmt::format("{} {} 0 \\\\ ", latex(*each.condition), each.holds ? "\\ge" : "<");
      }
      return fmt::format("\\begin{{cases}} {} \\end{{cases}}", rows);
    }
    default: break;
  }
  std::string inside = first;
  for (const Written& other : factor.others) inside += ", " + latex(other);
  const std::string name = name_on_paper(factor);
  return factor.base->function == Function::maximum
             ? fmt::format("\\{}\\left({}\\right)", name, inside)
             : fmt::format("\\operatorname{{{}}}\\left({}\\right)", name, inside);
}

}  // namespace

std::string factor_latex(const WrittenFactor& factor, int halves) {
  const bool call = factor.base && factor.base->kind == Base::Kind::function;
  const std::string exponent = halves == 2 || halves == 1 ? ""
                               : halves % 2 == 0          ? fmt::format("^{{{}}}", halves / 2)
                                                          : fmt::format("^{{{}/2}}", halves);
  const bool named = call && factor.others.empty() && factor.base->function != Function::abs &&
                     factor.base->function != Function::sign;
  if (call && !named) {
    const std::string body = call_latex(factor);
    if (halves == 1) return fmt::format("\\sqrt{{{}}}", body);
    const bool cases = factor.base->function == Function::select;
    return exponent.empty() || !cases ? body + exponent : fmt::format("\\left({}\\right){}", body, exponent);
  }
  if (call) {
    const std::string call_of =
        fmt::format("\\{}{}\\left({}\\right)", name_on_paper(factor), exponent, latex(factor.inside));
    return halves == 1 ? fmt::format("\\sqrt{{{}}}", call_of) : call_of;
  }
  std::string base;
  if (!factor.base) {
    base = latex(factor.inside);
    if (factor.size) {
      base = fmt::format("\\left|{}\\right|", base);
    } else if (halves != 1) {
      base = fmt::format("\\left({}\\right)", base);
    }
  } else {
    base = factor.base->kind == Base::Kind::definition ? fmt::format("z_{{{}}}", factor.base->definition)
                                                       : latex_name(factor.base->symbol->name);
  }
  return halves == 1 ? fmt::format("\\sqrt{{{}}}", base) : base + exponent;
}

namespace {

/// Whether a factor is a name of several letters, which needs room beside it: "edge height" is no product of ten letters.
bool is_word(const std::string& factor) {
  static constexpr std::array<std::string_view, 3> begins{"\\mathrm{", "\\dot{\\mathrm{", "\\ddot{\\mathrm{"};
  return std::any_of(begins.begin(), begins.end(), [&factor](std::string_view begin) { return factor.starts_with(begin); });
}

bool is_pi(const WrittenFactor& factor) {
  return factor.halves == 2 && factor.base && factor.base->kind == Base::Kind::symbol && factor.base->symbol->kind == SymbolKind::pi;
}

}  // namespace

std::string term_latex(const WrittenTerm& term) {
  const Number size = term.coefficient.abs();
  std::string numerator;
  std::string denominator;
  std::array<std::string, 2> last;
  // A share of pi is one fraction.
  const bool share = size.is_rational() && cln::denominator(size.part(0)) > 1 && !is_read_as_decimal(size.part(0)) &&
                     !term.factors.empty() && is_pi(term.factors[0]);
  for (std::size_t i = share ? 1 : 0; i < term.factors.size(); ++i) {
    const WrittenFactor& factor = term.factors[i];
    std::string& side = factor.halves > 0 ? numerator : denominator;
    std::string& before = last[factor.halves > 0 ? 0U : 1U];
    const std::string next = factor_latex(factor, std::abs(factor.halves));
    if (!side.empty()) side += is_word(before) || is_word(next) ? "\\, " : " ";
    side += next;
    before = next;
  }
  std::string body = numerator;
  if (!denominator.empty()) {
    // The stroke holds a lone sum together: no parentheses.
    const auto over = [](const WrittenFactor& factor) { return factor.halves > 0; };
    const auto only = std::find_if(term.factors.begin(), term.factors.end(), over);
    if (std::count_if(term.factors.begin(), term.factors.end(), over) == 1 && !only->base && !only->size && only->halves == 2) {
      numerator = latex(only->inside);
    }
    body = fmt::format("\\frac{{{}}}{{{}}}", numerator.empty() ? "1" : numerator, denominator);
  }
  if (share) {
    const Number over(cln::numerator(size.part(0)));
    const std::string part = fmt::format("\\frac{{{}\\pi}}{{{}}}", over.is_one() ? "" : over.to_string() + " ",
                                         Number(cln::denominator(size.part(0))).to_string());
    return body.empty() ? part : fmt::format("{} {}", part, body);
  }
  if (size.is_one() && !body.empty()) return body;
  const std::string number = number_latex(size, !body.empty());
  return body.empty() ? number : fmt::format("{} {}", number, body);
}

std::string sign_latex(const WrittenTerm& term, bool first) {
  const bool negative = term.coefficient.sign() < 0;
  if (first) return negative ? "-" : "";
  return negative ? "- " : "+ ";
}

std::string latex(const Written& written) {
  std::string result;
  for (const WrittenTerm& term : with_parts_of_numbers(written)) {
    if (!result.empty()) result += " ";
    result += sign_latex(term, result.empty()) + term_latex(term);
  }
  return result.empty() ? "0" : result;
}

std::string latex_name(const std::string& name) {
  if (const std::size_t bracket = name.find('['); bracket != std::string::npos && name.back() == ']') {
    const std::string matrix = name.substr(0, bracket);
    return fmt::format("{}_{{{}}}", matrix.size() == 1 ? "\\mathbf{" + matrix + "}" : "{" + latex_name(matrix) + "}",
                       name.substr(bracket + 1, name.size() - bracket - 2));
  }
  const std::size_t end = name.find('\'');
  const std::size_t dots = end == std::string::npos ? 0 : name.size() - end;
  std::string stem = name.substr(0, end);
  std::string below;
  const std::size_t cut = stem.find('_');
  if (cut != std::string::npos) {
    std::string piece;
    for (const char c : stem.substr(cut + 1) + "_") {
      if (c != '_') {
        piece += c;
        continue;
      }
      if (!below.empty()) below += ",";
      below += subscript(piece);
      piece.clear();
    }
    stem.resize(cut);
  }
  std::size_t letters = stem.size();
  while (letters > 1 && is_digit(stem[letters - 1])) --letters;
  if (letters < stem.size()) {
    const std::string digits = stem.substr(letters);
    below = below.empty() ? digits : fmt::format("{},{}", digits, below);
    stem.resize(letters);
  }
  std::string result = word(stem);
  if (dots > 0) result = fmt::format("\\{}{{{}}}", dots == 1 ? "dot" : "ddot", result);
  return below.empty() ? result : fmt::format("{}_{{{}}}", result, below);
}

namespace {

std::string upright(const std::string& unit) {
  std::string result;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit[i] == ' ') {
      result += "\\,";
    } else if (unit[i] != '^') {
      result += unit[i];
    } else if (unit[i + 1] == '(') {
      const std::size_t end = unit.find(')', i);
      result += fmt::format("^{{{}}}", unit.substr(i + 2, end - i - 2));
      i = end;
    } else {
      std::size_t end = i + 1;
      while (end < unit.size() && (is_digit(unit[end]) || unit[end] == '-')) ++end;
      result += fmt::format("^{{{}}}", unit.substr(i + 1, end - i - 1));
      i = end - 1;
    }
  }
  return fmt::format("\\mathrm{{{}}}", result);
}

}  // namespace

std::string latex_unit(const Unit& unit) { return upright(written_unit(unit)); }
std::string latex_unit(const Symbol& symbol) { return upright(written_unit(symbol)); }

std::string accented(std::string sentence) {
  static constexpr std::pair<std::string_view, std::string_view> names[] = {{"Painleve", "Painlev\xc3\xa9"}};
  for (const auto& [plain, proper] : names) {
    for (std::size_t at = sentence.find(plain); at != std::string::npos; at = sentence.find(plain, at + proper.size())) {
      sentence.replace(at, plain.size(), proper);
    }
  }
  return sentence;
}

}  // namespace torsor::printing
