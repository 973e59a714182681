// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/readable_page.hpp"

#include <fmt/format.h>

#include "torsor/generator/dynamics/theorems/flat_polynomials.hpp"
#include "torsor/generator/printing/notation.hpp"

namespace torsor::printing {

void ReadablePage::section(const std::string& heading) {
  lines_.emplace_back([heading](Page& page) { page.section(heading); });
}

void ReadablePage::note(const std::string& sentence) {
  lines_.emplace_back([sentence](Page& page) { page.note(sentence); });
}

void ReadablePage::equation(const std::string& label, const std::string& name, const Value& value,
                            const std::string& remark) {
  gather(value);
  lines_.emplace_back([=, this](Page& page) { page.equation(label, named(name), written(value), remark); });
}

void ReadablePage::equation(const std::string& label, const Value& left, const Value& right,
                            const std::string& remark) {
  gather(left);
  gather(right);
  lines_.emplace_back([=, this](Page& page) {
    const Written written_left = written(left);
    page.equation(label, written_left, written(right), remark);
  });
}

void ReadablePage::stated(const Spelling& left, const Value& value, const std::string& remark) {
  gather(value);
  lines_.emplace_back([=, this](Page& page) { page.stated(left, written(value), remark); });
}

void ReadablePage::positive(const Value& value) {
  lines_.emplace_back([=, this](Page& page) {
    if (!view_.sum(value)) return page.note("  " + readable(value) + " > 0");
    const Written condition = written(value);
    page.formula("  " + text(condition) + " > 0", "$" + latex(condition) + " > 0$");
  });
}

void ReadablePage::matrix(const Spelling& name, const std::string& entry, const ValueMatrix& matrix) {
  for (const std::vector<Value>& row : matrix) {
    for (const Value& each : row) gather(each);
  }
  lines_.emplace_back([=, this](Page& page) {
    std::vector<std::vector<Written>> rows;
    for (const std::vector<Value>& row : matrix) {
      rows.emplace_back();
      for (const Value& each : row) rows.back().push_back(written(each));
    }
    page.matrix(name, entry, rows);
  });
}

std::string ReadablePage::finish(const SceneContent& scene, const PageStyle& style) {
  const std::unique_ptr<Page> page = page_of(style);
  page->title(scene);
  if (!long_results_.empty()) {
    definitions_.emplace(*program_, long_results_);
    page->note(
        page->say("What has more than {} terms, or more than {} before anything cancels, is given by the named definitions at the "
                  "end.",
                  view_.limits().terms, view_.limits().expansion));
  }
  for (const auto& line : lines_) line(*page);
  laws_of_time(scene, *page);
  if (definitions_) {
    page->section(page->say("Definitions"));
    for (const DefinitionsView::Line& line : definitions_->lines()) {
      page->equation("", collected(Sum::definition(line.number)), line.right, meaning_of(line, page->say));
    }
  }
  return page->finish();
}

void ReadablePage::gather(const Value& value) {
  if (!value.is_zero() && !view_.sum(value)) long_results_.push_back(value);
}

Written ReadablePage::written(const Value& value) {
  if (value.is_zero()) return {};
  const std::optional<Sum> sum = view_.sum(value);
  if (sum) add_symbols(*sum, used_);
  return collected(sum ? *sum : definitions_->sum(value));
}

void ReadablePage::laws_of_time(const SceneContent& scene, Page& page) {
  bool first = true;
  for (const CoordinateContent& c : scene.coordinates) {
    if (!c.law) continue;
    for (const SymbolPointer& name : {c.q, c.v, c.a}) {
      const std::optional<Sum> law = used_.contains(name.get()) ? view_.law(name) : std::nullopt;
      if (!law) continue;
      if (first) page.section(page.say("Laws of time"));
      first = false;
      page.value(*name, collected(*law), level(*law) <= Level::constant);
    }
  }
}

}  // namespace torsor::printing
