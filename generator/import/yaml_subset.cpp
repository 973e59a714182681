// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/yaml_subset.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor::xacro {
namespace {

struct YamlLine {
  int number = 0;
  std::size_t indent = 0;
  std::string text;  ///< without indentation, comment and blanks at the end
};

/// The unit of a tag in SI, as a factor.
const std::map<std::string, double>& unit_tags() {
  static const std::map<std::string, double> tags{{"degrees", std::numbers::pi / 180},
                                                  {"radians", 1.0},
                                                  {"meters", 1.0},
                                                  {"centimeters", 0.01},
                                                  {"millimeters", 0.001},
                                                  {"inches", 0.0254},
                                                  {"feet", 0.3048},
                                                  {"kilograms", 1.0},
                                                  {"grams", 0.001}};
  return tags;
}

/// Digits of a base below 37; nothing where there are others, none, or too many for 64 bits.
std::optional<std::int64_t> digits_of_base(std::string_view digits, int base) {
  std::int64_t value = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  const bool whole = failure == std::errc() && end == digits.data() + digits.size() && digits.front() != '-';
  return whole ? std::optional(value) : std::nullopt;
}

/// As YAML 1.1 has numbers of base 60: 1:30 is 90, and 1:30.5 is 90.5.
std::optional<Value> yaml_sixtieths(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) word.remove_prefix(1);
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= word.size();) {
    const std::size_t end = std::min(word.find(':', begin), word.size());
    parts.emplace_back(word.substr(begin, end - begin));
    begin = end + 1;
  }
  if (parts.size() < 2 || parts[0].starts_with('_')) return std::nullopt;
  std::string& last = parts.back();
  const std::size_t point = last.find('.');
  const bool whole = point == std::string::npos;
  std::erase(parts[0], '_');
  if (parts[0].empty() || (whole && parts[0][0] == '0')) return std::nullopt;
  if (!whole) {
    if (last.find_first_not_of("0123456789_", point + 1) != std::string::npos) return std::nullopt;
    std::erase(last, '_');
  }
  std::int64_t number = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string digits = k + 1 < parts.size() ? parts[k] : last.substr(0, point);
    const std::optional<std::int64_t> digit = digits.empty() ? std::nullopt : digits_of_base(digits, 10);
    const bool fits = digit && number < 1000000000000 && (k == 0 || (*digit < 60 && digits.size() < 3));
    if (!fits) return std::nullopt;
    number = number * 60 + *digit;
  }
  if (whole) return Value(negative ? -number : number);
  double value = 0, power = 1;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {  // as Python sums it
    value += *python_float(*part) * power;
    power *= 60;
  }
  return Value(negative ? -value : value);
}

/// As YAML 1.1 has them, with underscores: 12, of base 2 0b101, of base 8 017, of base 16 0x1F.
std::optional<std::int64_t> yaml_integer(std::string word) {
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) word.erase(0, 1);
  if (word.empty() || word.front() < '0' || word.front() > '9') return std::nullopt;
  std::erase(word, '_');
  const std::string_view all = word;
  std::optional<std::int64_t> value;
  if (all.starts_with("0b") || all.starts_with("0x")) {
    if (all.size() > 2) value = digits_of_base(all.substr(2), all[1] == 'b' ? 2 : 16);
  } else {
    value = digits_of_base(all, all.size() > 1 && all[0] == '0' ? 8 : 10);
  }
  return value && negative ? std::optional(-*value) : value;
}

class YamlReader {
 public:
  YamlReader(const std::string& text, const std::string& file) : file_(file) {
    std::size_t begin = 0;
    for (int number = 1; begin <= text.size(); ++number) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      add_line(text.substr(begin, end - begin), number);
      begin = end + 1;
    }
  }

  Value whole() {
    if (lines_.empty()) return {};
    Value value = block(lines_[0].indent);
    if (at_ < lines_.size()) fail(lines_[at_], "is indented otherwise than what it belongs to");
    return value;
  }

 private:
  [[noreturn]] void fail(const YamlLine& line, const std::string& message) const {
    throw FileError(fmt::format("{}:{}: '{}': {}", file_, line.number, line.text, message));
  }

  void add_line(std::string text, int number) {
    while (!text.empty() && (text.back() == ' ' || text.back() == '\r' || text.back() == '\t')) text.pop_back();
    const std::size_t indent = text.find_first_not_of(' ');
    if (indent == std::string::npos) return;
    YamlLine line{number, indent, text.substr(indent)};
    if (line.text[0] == '\t') fail(line, "is indented by a tab; YAML takes blanks");
    char quote = 0;
    for (std::size_t i = 0; i < line.text.size(); ++i) {
      const char c = line.text[i];
      if (quote != 0) {
        if (c == quote) quote = 0;
      } else if ((c == '\'' || c == '"') &&
                 (i == 0 || std::string_view(" [{,:").find(line.text[i - 1]) != std::string_view::npos)) {
        quote = c;
      } else if (c == '#' && (i == 0 || line.text[i - 1] == ' ')) {
        line.text.erase(i);
        break;
      }
    }
    while (!line.text.empty() && line.text.back() == ' ') line.text.pop_back();
    if (line.text.empty() || line.text[0] == '%' || (line.text == "---" && lines_.empty())) return;
    if (line.text == "---" || line.text == "...") fail(line, "several documents in one file are not read here");
    lines_.push_back(std::move(line));
  }

  /// Where the colon stands that ends a key; npos when the text is no entry of a mapping.
  static std::size_t colon(const std::string& text) {
    char quote = 0;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const char c = text[i];
      if (quote != 0) {
        if (c == quote) quote = 0;
      } else if ((c == '\'' || c == '"') && i == 0) {
        quote = c;
      } else if (c == '[' || c == '{') {
        ++depth;
      } else if (c == ']' || c == '}') {
        --depth;
      } else if (c == ':' && depth == 0 && (i + 1 == text.size() || text[i + 1] == ' ')) {
        return i;
      }
    }
    return std::string::npos;
  }

  static bool begins_item(const YamlLine& line) { return line.text == "-" || line.text.starts_with("- "); }

  Value block(std::size_t indent) {
    if (++depth_ > 100) fail(lines_[at_], "is nested too deeply");
    Value value = begins_item(lines_[at_])                       ? list(indent)
                  : colon(lines_[at_].text) == std::string::npos ? single()
                                                                 : mapping(indent);
    --depth_;
    return value;
  }

  Value single() {
    const YamlLine line = lines_[at_++];
    return inline_value(line, joined(line.text));
  }

  Value list(std::size_t indent) {
    Value::List items;
    while (at_ < lines_.size() && lines_[at_].indent == indent && begins_item(lines_[at_])) {
      YamlLine& line = lines_[at_];
      const std::size_t content = line.text.find_first_not_of(' ', 1);
      if (content == std::string::npos) {
        ++at_;
        items.push_back(at_ < lines_.size() && lines_[at_].indent > indent ? block(lines_[at_].indent) : Value());
      } else {
        // What follows the dash is a block that is indented as far as it stands.
        line.indent = indent + content;
        line.text.erase(0, content);
        items.push_back(block(line.indent));
      }
    }
    return Value::list(std::move(items));
  }

  Value mapping(std::size_t indent) {
    Value::Dictionary entries;
    while (at_ < lines_.size() && lines_[at_].indent == indent && !begins_item(lines_[at_])) {
      const YamlLine line = lines_[at_];
      const std::size_t end = colon(line.text);
      if (end == std::string::npos) fail(line, "is no entry; write key: value");
      Value key = inline_value(line, line.text.substr(0, end));
      const std::size_t content = line.text.find_first_not_of(' ', end + 1);
      ++at_;
      Value value;
      if (content != std::string::npos) {
        value = inline_value(line, joined(line.text.substr(content)));
      } else if (at_ < lines_.size() &&
                 (lines_[at_].indent > indent || (lines_[at_].indent == indent && begins_item(lines_[at_])))) {
        value = block(lines_[at_].indent);
      }
      add_entry(line, entries, std::move(key), std::move(value));
    }
    if (at_ < lines_.size() && lines_[at_].indent > indent)
      fail(lines_[at_], "is indented otherwise than what it belongs to");
    return Value::dictionary(std::move(entries));
  }

  void add_entry(const YamlLine& line, Value::Dictionary& entries, Value key, Value value) const {
    for (const auto& [other, before] : entries) {
      if (other == key) fail(line, fmt::format("the key {} was there before; keep one", key.quoted()));
    }
    entries.emplace_back(std::move(key), std::move(value));
  }

  /// A list in brackets may go on in the next lines.
  std::string joined(std::string text) {
    const auto open = [](const std::string& all) {
      int depth = 0;
      char quote = 0;
      for (const char c : all) {
        if (quote != 0) {
          if (c == quote) quote = 0;
        } else if (c == '\'' || c == '"') {
          quote = c;
        } else {
          depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        }
      }
      return depth > 0;
    };
    if (text[0] != '[' && text[0] != '{') return text;
    while (open(text) && at_ < lines_.size()) text += " " + lines_[at_++].text;
    return text;
  }

  Value inline_value(const YamlLine& line, const std::string& text) {
    std::size_t at = 0;
    Value value = flow(line, text, at, "");
    if (text.find_first_not_of(' ', at) != std::string::npos) fail(line, "cannot be read; put texts in quotes");
    return value;
  }

  static void skip(const std::string& text, std::size_t& at) {
    while (at < text.size() && text[at] == ' ') ++at;
  }

  /// A value at `at`; plain texts end before one of `stops`.
  Value flow(const YamlLine& line, const std::string& text, std::size_t& at, const std::string& stops) {
    skip(text, at);
    if (at >= text.size()) return {};
    const char c = text[at];
    if (c == '[' || c == '{') return collection(line, text, at);
    if (c == '\'' || c == '"') return in_quotes(line, text, at);
    if (c == '!') return tagged(line, text, at, stops);
    if (std::string_view("&*|>@`").find(c) != std::string_view::npos) {
      fail(line, "anchors and texts of several lines are not read here; write the value itself");
    }
    const std::size_t end = stops.empty() ? text.size() : std::min(text.find_first_of(stops, at), text.size());
    std::string word = text.substr(at, end - at);
    while (!word.empty() && word.back() == ' ') word.pop_back();
    at = end;
    return plain(word);
  }

  Value collection(const YamlLine& line, const std::string& text, std::size_t& at) {
    if (++depth_ > 100) fail(line, "is nested too deeply");
    const bool is_list = text[at++] == '[';
    const char close = is_list ? ']' : '}';
    Value::List items;
    Value::Dictionary entries;
    for (skip(text, at); at < text.size() && text[at] != close; skip(text, at)) {
      Value value = flow(line, text, at, is_list ? ",]" : ":,}");
      skip(text, at);
      if (!is_list) {
        if (at >= text.size() || text[at] != ':') fail(line, "an entry in braces is written {key: value}");
        ++at;
        Value content = flow(line, text, at, ",}");
        add_entry(line, entries, std::move(value), std::move(content));
        skip(text, at);
      } else {
        items.push_back(std::move(value));
      }
      if (at < text.size() && text[at] == ',')
        ++at;
      else if (at < text.size() && text[at] != close)
        fail(line, "a comma is missing");
    }
    if (at >= text.size()) fail(line, fmt::format("'{}' is missing", close));
    ++at;
    --depth_;
    return is_list ? Value::list(std::move(items)) : Value::dictionary(std::move(entries));
  }

  Value in_quotes(const YamlLine& line, const std::string& text, std::size_t& at) {
    const char quote = text[at];
    std::string content;
    for (++at; at < text.size(); ++at) {
      if (text[at] == quote) {
        if (quote == '\'' && at + 1 < text.size() && text[at + 1] == '\'') {
          content += text[++at];
          continue;
        }
        ++at;
        return content;
      }
      if (quote == '"' && text[at] == '\\' && at + 1 < text.size()) {
        ++at;
        if (std::string_view("nt\\\"/ ").find(text[at]) == std::string_view::npos) {
          fail(line, fmt::format("the escape \\{} is not read here; write the character itself", text[at]));
        }
        content += text[at] == 'n' ? '\n' : text[at] == 't' ? '\t' : text[at];
      } else {
        content += text[at];
      }
    }
    fail(line, "a quote is not closed");
  }

  Value tagged(const YamlLine& line, const std::string& text, std::size_t& at, const std::string& stops) {
    const std::size_t end = std::min(text.find_first_of(" " + stops, at), text.size());
    const std::string tag = text.substr(at + 1, end - at - 1);
    at = end;
    const auto unit = unit_tags().find(tag);
    if (unit == unit_tags().end())
      fail(line, fmt::format("the tag !{} is unknown; there are !degrees, !radians, !meters, "
                             "!millimeters, !kilograms and their like",
                             tag));
    const Value value = flow(line, text, at, stops);
    if (!value.is_number()) fail(line, fmt::format("!{} takes a number", tag));
    return value.number(tag) * unit->second;
  }

  /// As YAML 1.1 reads it in Python: 1e3 without a point is a text, 1.0e+3 a number.
  static Value plain(const std::string& word) {
    if (word.empty() || word == "~" || word == "null" || word == "Null" || word == "NULL") return {};
    for (const char* yes : {"true", "True", "TRUE", "yes", "Yes", "YES", "on", "On", "ON"}) {
      if (word == yes) return true;
    }
    for (const char* no : {"false", "False", "FALSE", "no", "No", "NO", "off", "Off", "OFF"}) {
      if (word == no) return false;
    }
    if (const auto whole = yaml_integer(word)) return *whole;
    if (const auto number = yaml_sixtieths(word)) return *number;
    for (const char* name : {".inf", ".Inf", ".INF"}) {
      if (word == name || word == std::string("+") + name) return *python_float("inf");
      if (word == std::string("-") + name) return *python_float("-inf");
    }
    if (word == ".nan" || word == ".NaN" || word == ".NAN") return *python_float("nan");
    const bool decimal =
        word.find('.') != std::string::npos && word.find_first_not_of("+-0123456789.eE_") == std::string::npos;
    const std::size_t exponent = word.find_first_of("eE");
    const bool is_signed = exponent == std::string::npos ||
                           (exponent + 1 < word.size() && (word[exponent + 1] == '+' || word[exponent + 1] == '-'));
    if (decimal && is_signed) {
      if (const auto real = python_float(word)) return *real;
    }
    return word;
  }

  std::string file_;
  std::vector<YamlLine> lines_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

Value yaml_value(const std::string& text, const std::string& file) { return YamlReader(text, file).whole(); }

}  // namespace torsor::xacro
