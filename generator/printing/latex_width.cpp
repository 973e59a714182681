// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/latex_width.hpp"

#include <algorithm>
#include <cctype>

namespace torsor::printing {
namespace {

// Points of Computer Modern at 10 points, as TeX's tables of the fonts have them; of letters an average where they differ little.
constexpr double script = 0.7, relation = 13.3, sign = 12.2, minus = 7.8, parenthesis = 4.6, thin = 1.7;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

double letter(char c) {
  switch (c) {
    case 'm': return 8.8;
    case 'w': return 7.2;
    case 'M': return 10.8;
    case 'W': return 9.5;
    case 'i': case 'j': case 'l': case '.': case ':': return 3.5;
    case '|': return 2.8;
    default: return std::isupper(static_cast<unsigned char>(c)) != 0 ? 7.8 : 5.2;
  }
}

class Ruler {
 public:
  explicit Ruler(std::string_view latex) : text_(latex) {}

  /// Up to the brace that closes what is being read.
  double measure() {
    double width = 0;
    bool after_operand = false;
    while (at_ < text_.size() && text_[at_] != '}') {
      const char c = text_[at_];
      if (c == '_' || c == '^') {
        width += scripts();
      } else if (c == '\\') {
        width += command(after_operand);
      } else {
        ++at_;
        if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == '&') continue;
        if (c == '{') {
          width += measure();
          ++at_;
        } else if (c == '+' || c == '-') {
          width += after_operand ? sign : minus;
          after_operand = false;
          continue;
        } else if (c == '=' || c == '<' || c == '>') {
          width += relation;
          after_operand = false;
          continue;
        } else if (c == '(' || c == ')') {
          width += parenthesis;
          after_operand = c == ')';
          continue;
        } else {
          width += letter(c);
        }
        after_operand = true;
      }
    }
    return width;
  }

 private:
  /// One below and one above stand over each other.
  double scripts() {
    double widest = 0;
    while (at_ < text_.size() && (text_[at_] == '_' || text_[at_] == '^')) {
      ++at_;
      widest = std::max(widest, script * argument());
    }
    return widest;
  }

  double argument() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (at_ >= text_.size()) return 0;
    bool operand = false;
    if (text_[at_] == '\\') return command(operand);
    if (text_[at_] != '{') return letter(text_[at_++]);
    ++at_;
    const double width = measure();
    ++at_;
    return width;
  }

  double command(bool& after_operand) {
    std::size_t end = at_ + 1;
    while (end < text_.size() && is_letter(text_[end])) ++end;
    if (end == at_ + 1) ++end;
    const std::string_view name = text_.substr(at_ + 1, std::min(end, text_.size()) - at_ - 1);
    at_ = std::min(end, text_.size());
    if (name == "left" || name == "right" || name == "bigl" || name == "bigr") {
      const char delimiter = at_ < text_.size() ? text_[at_++] : ' ';
      after_operand = name == "right" || name == "bigr";
      return (delimiter == '|' ? 3.3 : parenthesis) + (name == "left" ? thin : 0);
    }
    if (name == "," || name == ";" || name == "!") return name == "," ? thin : name == ";" ? 2.8 : -thin;
    if (name == "quad" || name == "qquad") return name == "quad" ? 10 : 20;
    if (name == "\\") return 0;
    if (name == "cdot" || name == "times") {
      after_operand = false;
      return name == "cdot" ? 7.2 : sign;
    }
    after_operand = true;
    if (name == "ldots") return 11.7;
    if (name == "frac") {
      const double over = argument(), under = argument();
      return std::max(over, under) + 2.4;
    }
    if (name == "sqrt") return 8.4 + argument();
    for (const std::string_view accent : {"dot", "ddot", "vec", "mathrm", "mathbf", "text", "operatorname", "mathop"}) {
      if (name == accent) return argument();
    }
    for (const std::string_view call : {"sin", "cos", "tan", "exp", "log", "min", "max"}) {
      if (name == call) return 13 + thin;
    }
    return 5.8;  // a Greek letter
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

double latex_width(std::string_view latex) { return Ruler(latex).measure(); }

}  // namespace torsor::printing
