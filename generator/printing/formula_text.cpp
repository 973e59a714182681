// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/formula_text.hpp"

#include <cctype>
#include <cstdlib>

#include <fmt/format.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// What a person writes stays far below these; a stack has an end, for reading and for all that follows.
constexpr std::size_t longest = 4000;
constexpr int deepest = 100;

/// Recursive descent over  sum = product {+- product},  product = sign {*/ sign},  sign = [+-] power,
/// power = primary [^ integer].
class Parser {
 public:
  Parser(const std::string& text, const Scene& scene) : text_(text), scene_(scene) {}

  Expression parse() {
    if (text_.size() > longest) {
      throw UsageError(fmt::format("cannot read the formula '{}...': it has {} characters, and {} are the most",
                                   text_.substr(0, 40), text_.size(), longest));
    }
    const Expression result = sum();
    if (peek() != '\0') fail("an operator is missing");
    return result;
  }

 private:
  char peek() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail(const std::string& reason) const {
    throw UsageError(fmt::format("cannot read the formula '{}' at '{}': {}", text_, text_.substr(at_), reason));
  }

  /// One level of parentheses or signs deeper.
  class Nested {
   public:
    explicit Nested(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > deepest) parser_.fail(fmt::format("formulas are nested at most {} deep", deepest));
    }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;
    ~Nested() { --parser_.depth_; }

   private:
    Parser& parser_;
  };

  Expression sum() {
    const Nested nested(*this);
    Expression result = product();
    for (;;) {
      if (take('+')) {
        result = result + product();
      } else if (take('-')) {
        result = result - product();
      } else {
        return result;
      }
    }
  }
  Expression product() {
    Expression result = sign();
    for (;;) {
      if (take('*')) {
        result = result * sign();
      } else if (take('/')) {
        result = result / sign();
      } else {
        return result;
      }
    }
  }
  Expression sign() {
    if (take('-')) {
      const Nested nested(*this);
      return -sign();
    }
    take('+');
    return power();
  }
  Expression power() {
    const Expression base = primary();
    if (!take('^')) return base;
    const bool negative = take('-');
    std::string digits;
    while (is_digit(peek())) digits += text_[at_++];
    if (digits.empty() || digits.size() > 2) fail("an exponent is a whole number below 100");
    return pow(base, (negative ? -1 : 1) * std::atoi(digits.c_str()));
  }
  Expression primary() {
    if (take('(')) {
      const Expression inside = sum();
      if (!take(')')) fail("a closing parenthesis is missing");
      return inside;
    }
    const char c = peek();
    if (is_digit(c) || c == '.') return number();
    if (is_letter(c)) return name();
    fail("a number, a name or a parenthesis is expected");
  }
  Expression number() {
    const std::size_t start = at_;
    const auto digits = [this] {
      while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
    };
    digits();
    if (at_ + 1 < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      const bool exponent_sign = text_[at_ + 1] == '-' || text_[at_ + 1] == '+';
      if (is_digit(text_[at_ + 1]) || exponent_sign) {
        at_ += 2;
        digits();
      }
    }
    return Expression(parse_decimal(text_.substr(start, at_ - start)));
  }
  Expression name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '_')) ++at_;
    while (at_ < text_.size() && text_[at_] == '\'') ++at_;
    const std::string word = text_.substr(start, at_ - start);
    if (peek() == '(') return call(word, start);
    return symbol(word, start);
  }
  Expression call(const std::string& function, std::size_t start) {
    take('(');
    std::vector<Expression> arguments{sum()};
    while (take(',')) arguments.push_back(sum());
    if (!take(')')) fail("a closing parenthesis is missing");
    if (function == "tan" && arguments.size() == 1) return tan(arguments[0]);
    if (function == "tanh" && arguments.size() == 1) return tanh(arguments[0]);
    if (function == "min" && arguments.size() == 2) return min(arguments[0], arguments[1]);
    std::string known = "tan, tanh, min";
    for (const FunctionTraits& traits : functions()) {
      if (function == traits.name && arguments.size() == traits.arity) return torsor::call(traits.function, arguments);
      known += fmt::format(", {}", traits.name);
    }
    at_ = start;
    std::vector<std::string> names{"tan", "tanh", "min"};
    for (const FunctionTraits& traits : functions()) names.emplace_back(traits.name);
    fail(fmt::format("{}the functions are {}; atan2, max and min take two arguments, select three",
                     did_you_mean(function, names), known));
  }
  Expression symbol(const std::string& word, std::size_t start) {
    const SceneContent& scene = scene_.content();
    std::vector<std::string> known;
    for (const ParameterContent& parameter : scene.parameters) {
      if (parameter.symbol->name == word) return parameter.symbol;
      known.push_back(parameter.symbol->name);
    }
    for (const CoordinateContent& c : scene.coordinates) {
      for (const SymbolPointer& s : symbols_of(c)) {
        if (s->name == word) return s;
        known.push_back(s->name);
      }
    }
    for (const AttitudeContent& attitude : scene.attitudes) {
      for (const SymbolPointer& e : attitude.symbols->e) {
        if (e->name == word) return e;
        known.push_back(e->name);
      }
    }
    if (word == "t") return scene.time;
    if (word == "pi") return pi();
    at_ = start;
    fail(fmt::format("{}the scene '{}' has no parameter or coordinate of that name", did_you_mean(word, known), scene.name));
  }

  const std::string& text_;
  const Scene& scene_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

Expression parse_formula(const std::string& text, const Scene& scene) { return Parser(text, scene).parse(); }

}  // namespace torsor
