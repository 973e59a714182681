// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_expression.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/import/xacro_tokens.hpp"

namespace torsor::xacro {
namespace {

/// Beyond this many nested brackets nothing was written by a person.
constexpr int deepest_brackets = 200;
constexpr std::size_t most_words = 4000;
constexpr std::size_t most_steps = 100000;

/// What a part of an expression is worth, computed when it is needed: `a if c else b` looks at one side only.
struct Names {
  const Surroundings* outside = nullptr;
  std::map<std::string, Value> local;  ///< of [... for x in ...]
  std::size_t* steps = nullptr;        ///< of all lists that are gone through
};
using Part = std::function<Value(const Names&)>;

class Parser {
 public:
  explicit Parser(std::string_view text) : words_(tokens(text)) {
    if (words_.size() > most_words) throw ExpressionError(fmt::format("the expression has over {} words", most_words));
  }

  Part whole() {
    if (peek().kind == Token::Kind::end) throw ExpressionError("the expression is empty");
    Part part = is_tuple_next(expression());
    if (peek().kind != Token::Kind::end) {
      throw ExpressionError(fmt::format("'{}' is not expected there", peek().word));
    }
    return part;
  }

 private:
  const Token& peek() const { return words_[at_]; }
  const Token& next() { return words_[at_ + 1 < words_.size() ? at_++ : at_]; }
  bool is(const char* word) const {
    return (peek().kind == Token::Kind::symbol || peek().kind == Token::Kind::name) && peek().word == word;
  }
  bool take(const char* word) {
    if (!is(word)) return false;
    next();
    return true;
  }
  void expect(const char* word) {
    if (take(word)) return;
    throw ExpressionError(peek().kind == Token::Kind::end
                              ? fmt::format("'{}' is missing at the end", word)
                              : fmt::format("'{}' is expected before '{}'", word, peek().word));
  }

  /// a, b at the outermost place is a tuple.
  Part is_tuple_next(Part first) {
    if (!is(",")) return first;
    std::vector<Part> parts{std::move(first)};
    while (take(",")) {
      if (peek().kind == Token::Kind::end) break;
      parts.push_back(expression());
    }
    return sequence(std::move(parts), true);
  }

  static Part sequence(std::vector<Part> parts, bool tuple) {
    return [parts = std::move(parts), tuple](const Names& names) {
      Value::List items;
      for (const Part& part : parts) items.push_back(part(names));
      return Value::list(std::move(items), tuple);
    };
  }

  Part expression() {
    if (++depth_ > deepest_brackets) throw ExpressionError("the expression is nested too deeply");
    if (is("lambda")) throw ExpressionError("lambda is not read here; write a macro or a property");
    Part value = disjunction();
    if (take("if")) {
      Part when = disjunction();
      expect("else");
      Part otherwise = expression();
      value = [value, when, otherwise](const Names& names) {
        return when(names).truth() ? value(names) : otherwise(names);
      };
    }
    --depth_;
    return value;
  }

  Part disjunction() {
    Part left = conjunction();
    while (take("or")) {
      left = [left, right = conjunction()](const Names& names) {
        Value value = left(names);
        return value.truth() ? value : right(names);
      };
    }
    return left;
  }

  Part conjunction() {
    Part left = negation();
    while (take("and")) {
      left = [left, right = negation()](const Names& names) {
        Value value = left(names);
        return value.truth() ? right(names) : value;
      };
    }
    return left;
  }

  Part negation() {
    if (!take("not")) return comparison();
    if (++depth_ > deepest_brackets) throw ExpressionError("the expression is nested too deeply");
    Part part = negation();
    --depth_;
    return [part](const Names& names) { return Value(!part(names).truth()); };
  }

  std::string comparison_sign() {
    for (const char* sign : {"==", "!=", "<=", ">=", "<", ">", "in"}) {
      if (take(sign)) return sign;
    }
    if (take("not")) {
      expect("in");
      return "not in";
    }
    if (take("is")) return take("not") ? "is not" : "is";
    return "";
  }

  static bool holds(const std::string& sign, const Value& a, const Value& b) {
    if (sign == "==") return a == b;
    if (sign == "!=") return !(a == b);
    if (sign == "<") return less(a, b);
    if (sign == ">") return less(b, a);
    if (sign == "<=") return less(a, b) || a == b;
    if (sign == ">=") return less(b, a) || a == b;
    if (sign == "is" || sign == "is not") return identical(a, b) == (sign == "is");
    return contains(b, a) == (sign == "in");
  }

  Part comparison() {
    Part first = sum();
    std::vector<std::pair<std::string, Part>> rest;
    for (std::string sign = comparison_sign(); !sign.empty(); sign = comparison_sign()) {
      Part right = sum();
      rest.emplace_back(std::move(sign), std::move(right));
    }
    if (rest.empty()) return first;
    return [first, rest](const Names& names) {
      Value left = first(names);
      for (const auto& [sign, part] : rest) {
        Value right = part(names);
        if (!holds(sign, left, right)) return Value(false);
        left = std::move(right);
      }
      return Value(true);
    };
  }

  using Operator = Value (*)(const Value&, const Value&);
  static Part both(Part left, Part right, Operator operation) {
    return [left = std::move(left), right = std::move(right), operation](const Names& names) {
      const Value a = left(names);
      const Value b = right(names);
      return operation(a, b);
    };
  }

  Part sum() {
    Part left = product();
    for (;;) {
      const Operator operation = is("+") ? add : is("-") ? subtract : nullptr;
      if (operation == nullptr) return left;
      next();
      Part right = product();
      left = both(std::move(left), std::move(right), operation);
    }
  }

  Part product() {
    Part left = signed_value();
    for (;;) {
      const Operator operation = is("*")    ? multiply
                                 : is("/")  ? divide
                                 : is("//") ? floor_divide
                                 : is("%")  ? modulo
                                            : nullptr;
      if (operation == nullptr) return left;
      next();
      Part right = signed_value();
      left = both(std::move(left), std::move(right), operation);
    }
  }

  Part signed_value() {
    const bool minus = is("-");
    if (!minus && !is("+")) return raised();
    next();
    if (++depth_ > deepest_brackets) throw ExpressionError("the expression is nested too deeply");
    Part part = signed_value();
    --depth_;
    return [part, minus](const Names& names) {
      const Value value = part(names);
      if (minus) return negative(value);
      (void)value.number("+");
      return value.is_bool() ? Value(value.integer("+")) : value;
    };
  }

  Part raised() {
    Part base = with_items();
    if (!take("**")) return base;
    if (++depth_ > deepest_brackets) throw ExpressionError("the expression is nested too deeply");
    Part exponent = signed_value();
    --depth_;
    return both(std::move(base), std::move(exponent), power);
  }

  std::vector<Part> arguments() {
    std::vector<Part> parts;
    while (!take(")")) {
      if (!parts.empty()) {
        if (peek().kind == Token::Kind::end) expect(")");
        expect(",");
        if (take(")")) break;
      }
      if (peek().kind == Token::Kind::name && words_[at_ + 1].word == "=" &&
          words_[at_ + 1].kind == Token::Kind::symbol) {
        throw ExpressionError(fmt::format("{}=...: arguments by name are not read here", peek().word));
      }
      Part part = expression();
      parts.push_back(is("for") ? comprehension(std::move(part)) : std::move(part));
    }
    return parts;
  }

  static std::vector<Value> values(const std::vector<Part>& parts, const Names& names) {
    std::vector<Value> all;
    for (const Part& part : parts) all.push_back(part(names));
    return all;
  }

  /// dict(a=1, b=2).
  Part dictionary_by_names() {
    std::vector<std::pair<Part, Part>> entries;
    std::set<std::string> seen;
    while (!take(")")) {
      if (!entries.empty()) expect(",");
      const Value key(next().word);
      if (!seen.insert(key.text()).second) throw ExpressionError(fmt::format("dict(...) has {} twice; keep one", key.text()));
      expect("=");
      Part value = expression();
      entries.emplace_back([key](const Names&) { return key; }, std::move(value));
    }
    return dictionary(std::move(entries));
  }

  static Part dictionary(std::vector<std::pair<Part, Part>> entries) {
    return [entries = std::move(entries)](const Names& names) {
      Value::Dictionary content;
      for (const auto& [key, value] : entries) {
        Value k = key(names);
        Value v = value(names);
        content.emplace_back(std::move(k), std::move(v));
      }
      return Value::dictionary(std::move(content));
    };
  }

  Part call(const std::string& name) {
    if (name == "dict" && peek().kind == Token::Kind::name && words_[at_ + 1].word == "=") return dictionary_by_names();
    return [name, parts = arguments()](const Names& names) {
      const std::vector<Value> given = values(parts, names);
      if (auto value = names.outside->call(name, given)) return *value;
      if (auto value = call_function(name, given)) return *value;
      throw ExpressionError(
          fmt::format("unknown function '{}'; there are those of Python's math, abs, min, max, round, "
                      "len, range, int, float, str, list, dict, load_yaml",
                      name));
    };
  }

  static Part variable(const std::string& name) {
    return [name](const Names& names) {
      if (const auto found = names.local.find(name); found != names.local.end()) return found->second;
      if (auto value = names.outside->value(name)) return *value;
      if (auto value = constant(name)) return *value;
      throw ExpressionError(
          fmt::format("unknown name '{}'; define it by <xacro:property name=\"{}\" value=\"...\"/> or "
                      "as a parameter of the macro",
                      name, name));
    };
  }

  static Part slice(const Part& of, const Part& from, const Part& to) {
    return [of, from, to](const Names& names) {
      const Value value = of(names);
      return part_of(value, from ? from(names) : Value(), to ? to(names) : Value());
    };
  }

  Part subscript(const Part& of) {
    Part from;
    if (!is(":")) from = expression();
    if (take(":")) {
      Part to;
      if (!is("]")) to = expression();
      expect("]");
      return slice(of, from, to);
    }
    expect("]");
    return [of, from](const Names& names) {
      const Value value = of(names);
      const Value key = from(names);
      return item(value, key);
    };
  }

  Part with_items() {
    // math.pi and xacro.load_yaml are pi and load_yaml.
    if ((is("math") || is("xacro") || is("python")) && words_[at_ + 1].word == ".") {
      next();
      next();
    }
    Part part = is_dotted() ? dotted() : value_number();
    for (;;) {
      if (take("[")) {
        part = subscript(part);
      } else if (take(".")) {
        part = attribute(part);
      } else {
        return part;
      }
    }
  }

  bool is_symbol(std::size_t ahead, const char* word) const {
    return at_ + ahead < words_.size() && words_[at_ + ahead].kind == Token::Kind::symbol &&
           words_[at_ + ahead].word == word;
  }

  /// a.b that is no call: a property of a namespace, or an entry of a dictionary.
  bool is_dotted() const {
    return peek().kind == Token::Kind::name && is_symbol(1, ".") && at_ + 2 < words_.size() &&
           words_[at_ + 2].kind == Token::Kind::name && !is_symbol(3, "(");
  }
  Part dotted() {
    const std::string of = next().word;
    next();
    const std::string name = next().word;
    return [of, name, object = variable(of)](const Names& names) {
      if (!names.local.contains(of)) {
        if (auto value = names.outside->value(of + "." + name)) return *value;
      }
      return item(object(names), name);
    };
  }

  Part attribute(const Part& of) {
    if (peek().kind != Token::Kind::name) throw ExpressionError("a name is expected after '.'");
    const std::string name = next().word;
    if (!take("(")) return [of, name](const Names& names) { return item(of(names), name); };
    return [of, name, parts = arguments()](const Names& names) {
      const Value object = of(names);
      if (auto value = call_method(object, name, values(parts, names))) return *value;
      throw ExpressionError(
          fmt::format("{} ({}) has no method '{}' that is read here", object.quoted(), object.kind(), name));
    };
  }

  /// [e for x in list if c], the bracket and e already read.
  Part comprehension(Part each) {
    expect("for");
    std::vector<std::string> variables;
    do {
      if (peek().kind != Token::Kind::name) throw ExpressionError("a name is expected after 'for'");
      variables.push_back(next().word);
    } while (take(","));
    expect("in");
    Part of = disjunction();
    Part when;
    if (take("if")) when = disjunction();
    return [each = std::move(each), variables, of, when](const Names& names) {
      Names inner = names;
      Value::List items;
      const Value all = of(names);
      if (!all.is_list())
        throw ExpressionError(fmt::format("{} is {} and no list to go through", all.quoted(), all.kind()));
      for (const Value& value : all.items()) {
        if (++*names.steps > most_steps) throw ExpressionError("lists of lists are gone through too long");
        if (variables.size() == 1) inner.local[variables[0]] = value;
        for (std::size_t i = 0; variables.size() > 1 && i < variables.size(); ++i) {
          inner.local[variables[i]] = item(value, static_cast<std::int64_t>(i));
        }
        if (when && !when(inner).truth()) continue;
        items.push_back(each(inner));
      }
      return Value::list(std::move(items));
    };
  }

  Part bracketed(const char* close, bool tuple) {
    std::vector<Part> parts;
    bool comma = false;
    while (!take(close)) {
      if (!parts.empty()) {
        if (peek().kind == Token::Kind::end) expect(close);
        expect(",");
        comma = true;
        if (take(close)) break;
      }
      parts.push_back(expression());
      if (is("for")) {
        Part list = comprehension(std::move(parts.back()));
        expect(close);
        return list;
      }
    }
    if (tuple && parts.size() == 1 && !comma) return parts[0];
    return sequence(std::move(parts), tuple);
  }

  Part braces() {
    std::vector<std::pair<Part, Part>> entries;
    while (!take("}")) {
      if (!entries.empty()) {
        expect(",");
        if (take("}")) break;
      }
      Part key = expression();
      expect(":");
      Part value = expression();
      entries.emplace_back(std::move(key), std::move(value));
    }
    return dictionary(std::move(entries));
  }

  Part value_number() {
    const Token token = next();
    switch (token.kind) {
      case Token::Kind::number:
        return [value = token.value](const Names&) { return value; };
      case Token::Kind::text: {
        std::string text = token.word;
        while (peek().kind == Token::Kind::text) text += next().word;
        return [value = Value(text)](const Names&) { return value; };
      }
      case Token::Kind::name:
        if (token.word == "True" || token.word == "False") {
          return [value = Value(token.word == "True")](const Names&) { return value; };
        }
        if (token.word == "None") return [](const Names&) { return Value(); };
        if (take("(")) return call(token.word);
        return variable(token.word);
      case Token::Kind::symbol:
        if (token.word == "(") return bracketed(")", true);
        if (token.word == "[") return bracketed("]", false);
        if (token.word == "{") return braces();
        throw ExpressionError(fmt::format("'{}' is not expected there", token.word));
      case Token::Kind::end:
        break;
    }
    throw ExpressionError("the expression ends too early");
  }

  std::vector<Token> words_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

Value evaluate(std::string_view expression, const Surroundings& surroundings) {
  std::size_t steps = 0;
  const Names names{&surroundings, {}, &steps};
  return Parser(expression).whole()(names);
}

}  // namespace torsor::xacro
