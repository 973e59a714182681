// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_format.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "torsor/generator/import/xacro_letters.hpp"

namespace torsor::xacro {
namespace {

constexpr int widest = 1000;  // no name and no number of a robot is wider

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  bool at_end() const { return at_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  char next() { return at_end() ? '\0' : text_[at_++]; }
  bool take(char expected) {
    if (at_end() || text_[at_] != expected) return false;
    ++at_;
    return true;
  }
  /// Up to one of the ends, which stays.
  std::string until(std::string_view ends) {
    const std::size_t end = std::min(text_.find_first_of(ends, at_), text_.size());
    const std::string word = text_.substr(at_, end - at_);
    at_ = end;
    return word;
  }
  std::optional<int> count() {
    if (std::isdigit(static_cast<unsigned char>(peek())) == 0) return std::nullopt;
    int value = 0;
    while (std::isdigit(static_cast<unsigned char>(peek())) != 0) {
      value = 10 * value + (next() - '0');
      refuse_if(value > widest, fmt::format("has a number above {}", widest));
    }
    return value;
  }
  void refuse_if(bool wrong, const std::string& what) const {
    if (wrong) throw ExpressionError(fmt::format("the format '{}' {}", text_, what));
  }

 private:
  const std::string& text_;
  std::size_t at_ = 0;
};

void append(std::string& text, const std::string& more) {
  if (text.size() + more.size() > longest_text) throw ExpressionError("a text grows without end");
  text += more;
}

/// By the format of the library, whose words are those of Python's other formats.
template <class Given>
std::string written(const std::string& format, const Given& value) {
  return fmt::format(fmt::runtime("{:" + format + "}"), value);
}

/// One conversion of %, the sign % already read.
std::string converted(Reader& reader, const Value& value) {
  std::string flags;
  while (std::string_view("-+ 0#").find(reader.peek()) != std::string_view::npos) flags += reader.next();
  const bool left = flags.find('-') != std::string::npos, zeros = flags.find('0') != std::string::npos;
  const std::optional<int> width = reader.count();
  std::optional<int> precision;
  if (reader.take('.')) precision = reader.count().value_or(0);
  const char type = reader.next();
  const bool text = type == 's' || type == 'r', whole = type == 'd' || type == 'i' || type == 'u';
  reader.refuse_if(!text && !whole && std::string_view("eEfFgG").find(type) == std::string_view::npos,
                   "has a conversion that is not read here; there are %d, %i, %u, %e, %f, %g, %s, %r and %%");
  std::string format = left ? "<" : zeros ? "" : ">";
  if (!text) {
    if (flags.find('+') != std::string::npos) format += "+";
    else if (flags.find(' ') != std::string::npos) format += " ";
    if (flags.find('#') != std::string::npos && !whole) format += "#";
    if (zeros && !left) format += "0";
  }
  if (width && *width > 0) format += std::to_string(*width);
  if (text) {
    std::string shown = type == 's' ? value.to_string() : value.quoted();
    if (precision) shown = part_of_letters(shown, 0, static_cast<std::size_t>(*precision));
    const std::size_t size = letter_count(shown), wanted = width ? static_cast<std::size_t>(*width) : 0;
    const std::string blanks(wanted > size ? wanted - size : 0, ' ');
    return left ? shown + blanks : blanks + shown;
  }
  const std::string user = fmt::format("%{}", type);
  if (whole) {
    reader.refuse_if(precision.has_value(), "has a precision of an integer, which is not read here; give a width with 0");
    if (value.is_whole()) return written(format + "d", value.integer(user));
    const double number = std::trunc(value.number(user));
    reader.refuse_if(!(std::abs(number) < 9e18), "has an integer beyond 64 bits");
    return written(format + "d", static_cast<std::int64_t>(number));
  }
  if (precision) format += "." + std::to_string(*precision);
  return written(format + type, value.number(user));
}

}  // namespace

std::string percent_format(const std::string& format, const Value& values) {
  Reader reader(format);
  std::string text;
  std::size_t used = 0;
  const std::size_t count = values.is_tuple() ? values.items().size() : 1;
  while (!reader.at_end()) {
    append(text, reader.until("%"));
    if (!reader.take('%')) break;
    reader.refuse_if(reader.at_end(), "ends within a conversion");
    if (reader.take('%')) {
      append(text, "%");
    } else if (reader.take('(')) {
      reader.refuse_if(!values.is_dictionary(), "has names: give a dictionary");
      const std::string name = reader.until(")");
      reader.refuse_if(!reader.take(')'), "has a name without ')'");
      append(text, converted(reader, item(values, name)));
      used = count;
    } else {
      reader.refuse_if(used >= count, fmt::format("has more conversions than the {} given", count == 1 ? "value" : "values"));
      const Value& value = values.is_tuple() ? values.items()[used] : values;
      ++used;
      append(text, converted(reader, value));
    }
  }
  reader.refuse_if(used < count && !values.is_dictionary(), fmt::format("has fewer conversions than values: {} of {}", used, count));
  return text;
}

}  // namespace torsor::xacro
