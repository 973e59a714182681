// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mutation.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <string_view>

namespace torsor::fuzzing {
namespace {

constexpr std::size_t longest = 64 * 1024;

/// What breaks readers: numbers at the ends of their ranges, names of other things, pieces of markup, bytes of no text.
constexpr std::array<std::string_view, 64> hostile{
    "0", "-0", "1", "-1", "1e-400", "1e400", "1e9999", "1e-9999", "1e10001", "1e999999999999999999999", "nan", "inf", "-inf",
    "0x1p-1", "1/0", "1/3", "0.1000000000000000055511151231257827", ".", "-", "+", "e", "1e", "--1", "1,5", "1.5708",
    "3.141592653589793", "6.283185307179586", "1e-16", "2147483648", "18446744073709551616", "", " ", "\n", "\t", "\"", "'",
    "<", ">", "&", "&amp;", "&#0;", "&lt;", "<!--", "-->", "]]>", "<![CDATA[", "<?xml?>", "</robot>", "<link name=\"base\"/>",
    "<mimic joint=\"turn\" multiplier=\"2\" offset=\"1\"/>", "floating", "planar", "fixed", "RAND_MAX", "int", "ground",
    "$(id)", "`id`", "*/", "\?\?/", "\xff", "\xe2\x80\xae", "\xed\xa0\x80", "\\"};

class Damage {
 public:
  Damage(std::string text, const std::vector<std::string>& corpus, std::uint64_t seed)
      : text_(std::move(text)), corpus_(corpus), random_(seed) {}

  std::string done() {
    const std::size_t places = 1 + below(8);
    for (std::size_t i = 0; i < places; ++i) damage();
    text_.resize(std::min(text_.size(), longest));
    return std::move(text_);
  }

 private:
  // std::uniform_int_distribution gives other numbers with another library.
  std::size_t below(std::size_t count) { return count == 0 ? 0 : static_cast<std::size_t>(random_() % count); }
  std::size_t place() { return below(text_.size() + 1); }

  /// A part of the text: a few bytes, a number or a word, or from one '<' to another.
  std::pair<std::size_t, std::size_t> part() {
    const std::size_t at = place();
    std::size_t begin = at, end = at;
    switch (below(3)) {
      case 0:
        end = std::min(text_.size(), at + below(16));
        break;
      case 1: {
        const auto in_word = [&](std::size_t i) { return std::string_view(" \"'<>=/,;\n").find(text_[i]) == std::string_view::npos; };
        while (begin > 0 && in_word(begin - 1)) --begin;
        while (end < text_.size() && in_word(end)) ++end;
        break;
      }
      default:
        begin = std::min(text_.rfind('<', at), text_.size());
        for (std::size_t more = 1 + below(6); more > 0 && end < text_.size(); --more) end = text_.find('<', end + 1);
        end = std::min(end, text_.size());
        begin = std::min(begin, end);
        break;
    }
    return {begin, end - begin};
  }

  void damage() {
    const auto [begin, length] = part();
    switch (below(8)) {
      case 0:
        text_.erase(begin, length);
        break;
      case 1:
        text_.replace(begin, length, hostile[below(hostile.size())]);
        break;
      case 2:
        text_.insert(place(), hostile[below(hostile.size())]);
        break;
      case 3: {  // twice, or many times
        const std::string copy = text_.substr(begin, length);
        const std::size_t at = place();
        for (std::size_t more = below(4) == 0 ? 200 : 1; more > 0 && text_.size() < longest; --more) text_.insert(at, copy);
        break;
      }
      case 4: {  // elsewhere
        const std::string moved = text_.substr(begin, length);
        text_.erase(begin, length);
        text_.insert(place(), moved);
        break;
      }
      case 5:
        if (!text_.empty()) text_[below(text_.size())] = static_cast<char>(random_());
        break;
      case 6: {  // a piece of another one
        const std::string& other = corpus_[below(corpus_.size())];
        const std::size_t from = below(other.size() + 1);
        text_.replace(begin, length, other.substr(from, below(200)));
        break;
      }
      default:
        text_.resize(place());
        break;
    }
  }

  std::string text_;
  const std::vector<std::string>& corpus_;
  std::mt19937_64 random_;
};

}  // namespace

std::string damaged(const std::vector<std::string>& corpus, std::uint64_t seed, std::uint64_t number) {
  const std::uint64_t own = (seed * 0x9e3779b97f4a7c15U) ^ ((number + 1) * 0xbf58476d1ce4e5b9U);
  return Damage(corpus[number % corpus.size()], corpus, own).done();
}

}  // namespace torsor::fuzzing
