// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/printing/latex_width.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/notation_latex.hpp"

namespace torsor::printing {
namespace {

/// What a line break does not part: its LaTeX, and its width.
struct Piece {
  std::string latex;
  double size = 0;
  bool multiplies = false;  ///< what stands before it: a line that begins with it begins with a cross
};

constexpr double indent_of_lines = 20;  // of \qquad
constexpr double sign_width = 12.2;  // of a plus or a minus, with the space around it

double size_of(const WrittenTerm& term) { return sign_width + latex_width(term_latex(term)); }
double size_of(const WrittenFactor& factor) { return latex_width(factor_latex(factor, std::abs(factor.halves))); }

/// \sin, \cos and the like: one argument in parentheses.
bool is_call(const WrittenFactor& factor) {
  return factor.base && factor.base->kind == Base::Kind::function && factor.others.empty() &&
         factor.base->function != Function::abs && factor.base->function != Function::sign &&
         factor.base->function != Function::select;
}

/// A sum inside, at whose terms lines may end.
bool is_breakable(const WrittenFactor& factor) {
  return (!factor.base || (is_call(factor) && factor.halves > 1)) && factor.inside.size() > 1;
}

std::string exponent(int halves) {
  if (halves == 2) return {};
  return halves % 2 == 0 ? fmt::format("^{{{}}}", halves / 2) : fmt::format("^{{{}/2}}", halves);
}

/// Parts formulas at their sums: those outside first, then inside parentheses, where a person would.
class LineBreaker {
 public:
  explicit LineBreaker(double width) : width_(width) {}

  BrokenLines lines(const Written& written) {
    add(written);
    std::string result;
    double column = 0;
    for (const Piece& piece : pieces_) {
      const bool first = result.empty();
      const bool fits = first || column + piece.size <= width_;
      if (!first) {  // the empty group keeps the space around a sign
        result += fits ? " " : " \\\\\n  &\\qquad {}";
        if (!fits && piece.multiplies) result += "\\times ";
      }
      column = fits ? column + piece.size : indent_of_lines + piece.size;
      result += piece.latex;
    }
    return result.empty() ? BrokenLines{"0", 5} : BrokenLines{std::move(result), column};
  }

 private:
  void add(const Written& written) {
    bool first = true;
    for (const WrittenTerm& term : with_parts_of_numbers(written)) {
      add(term, first);
      first = false;
    }
  }

  /// A term, in several pieces where one line cannot hold it: what is short, as it is written on one line; then what is
  /// long, factor by factor.
  void add(const WrittenTerm& term, bool first) {
    const auto is_long = [this](const WrittenFactor& factor) { return is_breakable(factor) && size_of(factor) > width_ / 3; };
    if (size_of(term) <= width_) {
      pieces_.push_back({sign_latex(term, first) + term_latex(term), size_of(term)});
      return;
    }
    if (std::none_of(term.factors.begin(), term.factors.end(), is_long)) {
      add_factors(term, first);
      return;
    }
    const auto first_long = std::find_if(term.factors.begin(), term.factors.end(), is_long);
    WrittenTerm before{term.coefficient.abs(), {}}, after{Number(1), {}};
    for (auto factor = term.factors.begin(); factor != term.factors.end(); ++factor) {
      if (!is_long(*factor)) (factor < first_long || factor->halves < 0 ? before : after).factors.push_back(*factor);
    }
    const bool nothing = before.coefficient.is_one() && before.factors.empty();
    std::string head = sign_latex(term, first) + (nothing ? "" : term_latex(before) + " ");
    double head_size = nothing ? sign_width : size_of(before);
    bool multiplies = false;
    for (const WrittenFactor& factor : term.factors) {
      if (!is_long(factor)) continue;
      add(factor, head, head_size, multiplies);
      head.clear();
      head_size = 0;
      multiplies = true;
    }
    if (after.factors.empty()) return;
    pieces_.back().latex += " " + term_latex(after);
    pieces_.back().size += size_of(after) - sign_width;
  }

  /// A product of long names: as many on a line as there is room for, the number and the denominator before them.
  void add_factors(const WrittenTerm& term, bool first) {
    WrittenTerm line{term.coefficient.abs(), {}};
    for (const WrittenFactor& factor : term.factors) {
      if (factor.halves < 0) line.factors.push_back(factor);
    }
    std::string sign = sign_latex(term, first);
    bool multiplies = false, any = false;
    const auto end_line = [&] {
      pieces_.push_back({sign + term_latex(line), size_of(line), multiplies});
      sign.clear();
      multiplies = true;
      any = false;
      line = {Number(1), {}};
    };
    for (const WrittenFactor& factor : term.factors) {
      if (factor.halves < 0) continue;
      if (any && size_of(line) + size_of(factor) >= width_) end_line();
      line.factors.push_back(factor);
      any = true;
    }
    end_line();
  }

  /// A factor with a long sum inside, behind `head`.
  void add(const WrittenFactor& factor, const std::string& head, double head_size, bool multiplies) {
    const std::size_t begin = pieces_.size();
    add(factor.inside);
    std::string open = head, close;
    if (factor.base) {
      open += fmt::format("\\{}{}\\bigl(", name_on_paper(factor), exponent(factor.halves));
      close = "\\bigr)";
    } else {
      open += factor.size ? "\\bigl|" : "\\bigl(";
      close = (factor.size ? "\\bigr|" : "\\bigr)") + exponent(factor.halves);
    }
    pieces_[begin].latex = open + pieces_[begin].latex;
    pieces_[begin].size += head_size + (factor.base ? 24 : 6);
    pieces_[begin].multiplies = multiplies;
    pieces_.back().latex += close;
    pieces_.back().size += 6;
  }

  double width_;
  std::vector<Piece> pieces_;
};

}  // namespace

BrokenLines latex_lines(const Written& written, double width) { return LineBreaker(width).lines(written); }

std::string latex_equation(const Written& left, const Written& right, double width) {
  constexpr double equals = 13.3, short_left = 100, indent_of_right = 10;
  const double left_size = latex_width(latex(left)), right_size = latex_width(latex(right));
  if (left_size + equals + right_size <= width) return fmt::format("{} &= {}", latex(left), latex(right));
  if (left_size < short_left) return fmt::format("{} &= {}", latex(left), latex_lines(right, width - left_size - equals).latex);
  // Apart: lines begin at the margin, not below the = of the neighbours.
  const BrokenLines lines = latex_lines(left, width);
  if (lines.last + equals + right_size <= width) return fmt::format("&{} = {}", lines.latex, latex(right));
  return fmt::format("&{} \\\\\n  &\\quad = {}", lines.latex, latex_lines(right, width - equals - indent_of_right).latex);
}

}  // namespace torsor::printing
