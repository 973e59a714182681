// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/unclosed_element.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace torsor {
namespace {

struct Open {
  std::string name;
  int line = 0;
};

/// Walks over the tags of a text and keeps those that are open.
class Tags {
 public:
  explicit Tags(std::string_view text) : text_(text) {}

  std::optional<UnclosedElement> run() {
    while (next_tag()) {
      if (skipped("<!--", "-->") || skipped("<![CDATA[", "]]>") || skipped("<?", "?>") || skipped("<!", ">")) continue;
      if (broken_) return std::nullopt;  // what is open there is told by the parser
      const std::size_t end = end_of_tag();
      if (end == std::string_view::npos) return std::nullopt;
      const bool closes = text_.substr(at_, 2) == "</";
      const std::string name = name_at(at_ + (closes ? 2 : 1));
      if (name.empty()) return std::nullopt;
      if (closes) {
        if (open_.empty()) return UnclosedElement{line(), fmt::format("</{}> closes nothing; remove it", name)};
        if (open_.back().name != name) return mismatch(name);
        open_.pop_back();
      } else if (text_[end - 1] != '/') {
        open_.push_back({name, line()});
      }
      at_ = end + 1;
    }
    if (open_.empty()) return std::nullopt;
    at_ = text_.find_last_not_of(" \t\r\n");
    const Open& last = open_.back();
    return UnclosedElement{line(), fmt::format("</{0}> is missing: <{0}> of line {1} is not closed when the file ends",
                                               last.name, last.line)};
  }

 private:
  bool next_tag() {
    if (at_ >= text_.size()) return false;
    at_ = text_.find('<', at_);
    return at_ != std::string_view::npos;
  }

  /// Moves behind what begins and ends so, if it stands here.
  bool skipped(std::string_view begin, std::string_view end) {
    if (broken_ || text_.substr(at_, begin.size()) != begin) return false;
    const std::size_t close = text_.find(end, at_ + begin.size());
    broken_ = close == std::string_view::npos;
    if (!broken_) at_ = close + end.size();
    return !broken_;
  }

  /// Where the > of the tag stands that begins here; values in quotes may hold one.
  std::size_t end_of_tag() const {
    char quote = 0;
    for (std::size_t i = at_ + 1; i < text_.size(); ++i) {
      const char c = text_[i];
      if (quote != 0) {
        if (c == quote) quote = 0;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        return i;
      } else if (c == '<') {
        break;
      }
    }
    return std::string_view::npos;
  }

  std::string name_at(std::size_t begin) const {
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n/>", begin), text_.size());
    return std::string(text_.substr(begin, end - begin));
  }

  int line() {
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
    counted_ = at_;
    return line_;
  }

  UnclosedElement mismatch(const std::string& name) {
    const Open& inner = open_.back();
    return {line(), fmt::format("</{}> stands where </{}> must: <{}> of line {} is not closed by its own name", name,
                                inner.name, inner.name, inner.line)};
  }

  std::string_view text_;
  std::size_t at_ = 0, counted_ = 0;
  int line_ = 1;
  bool broken_ = false;
  std::vector<Open> open_;
};

}  // namespace

std::optional<UnclosedElement> unclosed_element(std::string_view text) { return Tags(text).run(); }

}  // namespace torsor
