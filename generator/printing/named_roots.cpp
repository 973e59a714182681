// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/named_roots.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/oriented_squares.hpp"

namespace torsor::printing {
namespace {

/// A shorter radicand says more than a name: x^2 + y^2.
constexpr std::size_t short_radicand = 16;
/// A denominator of more letters that occurs more often is named as a root's square though it stands under no root.
constexpr std::size_t long_denominator = 60;
constexpr int often = 3;

bool is_root(const WrittenFactor& factor) { return !factor.base && !factor.size && factor.halves % 2 != 0; }
bool is_denominator(const WrittenFactor& factor) {
  return !factor.base && !factor.size && factor.halves < 0 && factor.halves % 2 == 0;
}

/// The greatest rational that all terms share, with the sign of the first; 1 where a coefficient is not rational.
Number shared(const Written& sum) {
  cln::cl_I numerators = 0, denominators = 1;
  for (const WrittenTerm& term : sum) {
    if (!term.coefficient.is_rational()) return Number(1);
    numerators = cln::gcd(numerators, cln::numerator(term.coefficient.part(0)));
    denominators = cln::lcm(denominators, cln::denominator(term.coefficient.part(0)));
  }
  if (cln::zerop(numerators)) return Number(1);
  const Number size(numerators / denominators);
  return sum.front().coefficient.sign() < 0 ? -size : size;
}

/// Keeps what is written until all of it is known.
class RootPage final : public Page {
 public:
  explicit RootPage(std::unique_ptr<Page> page) : Page(page->say), page_(std::move(page)) {}

  void title(const SceneContent& scene) override {
    lines_.emplace_back([this, &scene] { page_->title(scene); });
  }
  void section(const std::string& heading) override {
    lines_.emplace_back([this, heading] { page_->section(heading); });
  }
  void step(const std::string& heading) override {
    lines_.emplace_back([this, heading] { page_->step(heading); });
  }
  void note(const std::string& sentence) override {
    lines_.emplace_back([this, sentence] { page_->note(sentence); });
  }
  void formula(const std::string& plain, const std::string& latex) override {
    lines_.emplace_back([this, plain, latex] { page_->formula(plain, latex); });
  }
  void symbol(const Symbol& symbol, const std::string& remark) override {
    lines_.emplace_back([this, symbol, remark] { page_->symbol(symbol, remark); });
  }
  void value(const Symbol& symbol, const Written& value, bool with_unit) override {
    see(value);
    lines_.emplace_back([this, symbol, value, with_unit] { page_->value(symbol, finished(value), with_unit); });
  }
  void equation(const std::string& label, const Written& left, const Written& right,
                const Remark& remark) override {
    see(left);
    see(right);
    lines_.emplace_back([=, this] { page_->equation(label, finished(left), finished(right), remark); });
  }
  void stated(const Spelling& left, const Written& right, const Remark& remark) override {
    see(right);
    lines_.emplace_back([=, this] { page_->stated(left, finished(right), remark); });
  }
  void matrix(const Spelling& name, const std::string& entry, const std::vector<std::vector<Written>>& rows) override {
    for (const auto& row : rows) {
      for (const Written& each : row) count(each);  // signs are those of the equations
    }
    lines_.emplace_back([=, this] {
      std::vector<std::vector<Written>> with_names = rows;
      for (auto& row : with_names) {
        for (Written& each : row) each = squares_.oriented_entry(named_in(each));
      }
      page_->matrix(name, entry, with_names);
    });
  }

  std::string finish() override {
    int number = 0;
    for (const std::string& radicand : in_order_) {
      Root& root = roots_.at(radicand);
      if (root.roots == 0 || root.count + beside(root) == 1) continue;
      root.name = fmt::format("root_{}", ++number);
      name_part(root);
    }
    for (const std::string& radicand : in_order_) {
      Root& root = roots_.at(radicand);
      const bool occurs_often = radicand.size() > long_denominator && root.count > often;
      if (root.name.empty() && occurs_often) root.name = fmt::format("root_{}", ++number);
    }
    for (const auto& line : lines_) line();
    if (number > 0) page_->section(say("Roots"));
    for (const std::string& radicand : in_order_) {
      const Root& root = roots_.at(radicand);
      if (root.name.empty() || !root.size.is_one()) continue;
      WrittenFactor itself;
      itself.inside = finished(root.radicand);
      itself.halves = 1;
      page_->equation("", named(root.name), {{Number(1), {itself}}}, "");
    }
    return page_->finish();
  }

 private:
  struct Root {
    Written radicand;
    int count = 0, roots = 0;  ///< as a root or a denominator; as a root alone
    std::string name = {};
    Number size{1};  ///< what is named is the root of size · radicand
  };

  /// The sum that stands as a denominator without what its terms share: x + y beside √(2 x + 2 y).
  Root* part_of(const Root& root, const Number& size) {
    if (size.is_one()) return nullptr;
    Written part = root.radicand;
    for (WrittenTerm& term : part) term.coefficient = term.coefficient / size;
    const auto found = roots_.find(text(part));
    return found == roots_.end() || found->second.roots > 0 ? nullptr : &found->second;
  }
  int beside(const Root& root) {
    const Root* const part = part_of(root, shared(root.radicand));
    return part == nullptr ? 0 : part->count;
  }
  void name_part(const Root& root) {
    const Number size = shared(root.radicand);
    if (Root* const part = part_of(root, size)) {
      part->name = root.name;
      part->size = size;
    }
  }

  void see(const Written& written) {
    count(written);
    squares_.see(written);
  }
  Written finished(const Written& written) const { return squares_.oriented(named_in(written)); }

  void count(const Written& written) {
    for (const WrittenTerm& term : written) {
      for (const WrittenFactor& factor : term.factors) {
        if (!is_root(factor) && !is_denominator(factor)) {
          count(factor.inside);
          continue;
        }
        const std::string radicand = text(factor.inside);
        if (roots_.find(radicand) == roots_.end()) {
          count(factor.inside);  // a root inside a root stands before it
          if (radicand.size() <= short_radicand) continue;
          roots_.emplace(radicand, Root{factor.inside});
          in_order_.push_back(radicand);
        }
        Root& root = roots_.at(radicand);
        ++root.count;
        root.roots += is_root(factor) ? 1 : 0;
      }
    }
  }

  Written named_in(Written written) const {
    for (WrittenTerm& term : written) {
      for (WrittenFactor& factor : term.factors) {
        const bool may_be_named = is_root(factor) || is_denominator(factor);
        const auto root = may_be_named ? roots_.find(text(factor.inside)) : roots_.end();
        if (root == roots_.end() || root->second.name.empty()) {
          factor.inside = named_in(std::move(factor.inside));
          continue;
        }
        const int halves = 2 * factor.halves;
        if (!root->second.size.is_one()) term.coefficient = term.coefficient * root->second.size.pow(-factor.halves / 2);
        factor = named(root->second.name)[0].factors[0];
        factor.halves = halves;
      }
    }
    return written;
  }

  std::unique_ptr<Page> page_;
  std::vector<std::function<void()>> lines_;
  std::map<std::string, Root> roots_;  // by the text of the radicand; looked up only
  std::vector<std::string> in_order_;  // as they are first met
  OrientedSquares squares_;
};

}  // namespace

std::unique_ptr<Page> with_named_roots(std::unique_ptr<Page> page) {
  return std::make_unique<RootPage>(std::move(page));
}

std::string words_as_page(const std::string& text, const SceneContent& scene, const PageStyle& style) {
  const std::unique_ptr<Page> page = page_of(style);
  page->title(scene);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    const std::size_t words = line.find_first_not_of(' ');
    if (words == 0) page->section(line);
    if (words != 0 && words != std::string::npos) page->note(line.substr(words));
    begin = end + 1;
  }
  return page->finish();
}

std::unique_ptr<Page> page_of(const PageStyle& style) {
  return with_named_roots(style.format == Format::text    ? text_page(style.language)
                          : style.format == Format::latex ? latex_page(style.document, style.language)
                                                          : html_page(style.language));
}

}  // namespace torsor::printing
