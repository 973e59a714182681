// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/printing/fitted_matrix.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/page.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor::printing {
namespace {

constexpr std::size_t page_width = 160;

/// A lone number as a decimal, anything else as a formula.
std::string value_in_text(const Written& value) {
  const bool number = value.size() == 1 && value[0].factors.empty();
  return number ? value_text(value[0].coefficient) : text(value);
}

class TextPage final : public Page {
 public:
  using Page::Page;
  void title(const SceneContent& scene) override {
    out_ += scene.title.empty() ? fmt::format("{}\n", scene.name) : fmt::format("{}: {}\n", scene.name, scene.title);
  }
  void section(const std::string& heading) override { out_ += "\n" + heading + "\n"; }
  void note(const std::string& sentence) override { out_ += "  " + sentence + "\n"; }
  void formula(const std::string& plain, const std::string&) override { note(plain); }
  void symbol(const Symbol& symbol, const std::string& remark) override {
    out_ += fmt::format("  {} [{}]", symbol.name, written_unit(symbol));
    out_ += remark.empty() ? "\n" : fmt::format("  {}\n", remark);
  }
  void value(const Symbol& symbol, const Written& value, bool with_unit) override {
    out_ += fmt::format("  {} = {}", symbol.name, value_in_text(value));
    if (with_unit && written_unit(symbol) != "1") out_ += fmt::format(" {}", written_unit(symbol));
    out_ += "\n";
  }
  void equation(const std::string& label, const Written& left, const Written& right,
                const Remark& remark) override {
    const std::string start = label.empty() ? "  " : fmt::format("  {}:  ", label);
    std::string line = start + text(left) + " = " + text(right);
    if (line.size() > page_width) {
      const std::string indent(start.size() + 2, ' ');
      line = start + text_lines(left, start.size(), indent, page_width);
      const bool short_left = line.size() < start.size() + 20;
      line += short_left ? " = " : fmt::format("\n{}= ", indent);
      const std::size_t column = short_left ? line.size() : indent.size() + 2;
      line += text_lines(right, column, indent + "  ", page_width);
    }
    out_ += remark.empty() ? fmt::format("{}\n", line) : fmt::format("{}    ({})\n", line, remark.plain);
  }
  void stated(const Spelling& left, const Written& right, const Remark& remark) override {
    const std::string start = "  " + left.plain + " = ";
    const std::string line = start + text_lines(right, start.size(), "      ", page_width);
    out_ += remark.empty() ? line + "\n" : fmt::format("{}    ({})\n", line, remark.plain);
  }
  void matrix(const Spelling& name, const std::string& entry, const WrittenMatrix& rows) override {
    if (rows.empty() || rows[0].empty()) return;
    const FittedMatrix matrix = fitted(entry, rows, page_width, say);
    if (!matrix.instead.empty()) note(fmt::format("{}, {}:", name.plain, matrix.instead));
    std::vector<std::size_t> widths(matrix.instead.empty() ? rows[0].size() : 0, 0);
    for (std::size_t j = 0; j < widths.size(); ++j) {
      for (const auto& row : matrix.rows) widths[j] = std::max(widths[j], text(row[j]).size());
    }
    for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
      const std::string head = name.plain + " = ";
      out_ += "  " + (i == 0 ? head : std::string(head.size(), ' ')) + "[ ";
      for (std::size_t j = 0; j < widths.size(); ++j) {
        out_ += fmt::format("{:<{}}", text(matrix.rows[i][j]), widths[j]) + (j + 1 < widths.size() ? ",  " : " ]\n");
      }
    }
    for (const auto& [entry_name, value] : matrix.named) {
      const std::string head = fmt::format("  {} = ", entry_name);
      out_ += head + text_lines(value, head.size(), std::string(head.size(), ' '), page_width) + "\n";
    }
  }
  std::string finish() override { return std::move(out_); }

 private:
  std::string out_;
};

}  // namespace

std::unique_ptr<Page> text_page(const NaturalLanguage& language) { return std::make_unique<TextPage>(language); }

Spelling bold(const std::string& name) { return {name, fmt::format("\\mathbf{{{}}}", name)}; }

Spelling named_object(const std::string& name) {
  const bool identifier = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  });
  return {name, identifier ? latex_name(name) : fmt::format("\\text{{{}}}", latex_escaped(name))};
}

Written named(const std::string& name) {
  const auto symbol = std::make_shared<const Symbol>(Symbol{name, Unit(), SymbolKind::parameter, 0, nullptr});
  return collected(Sum::symbol(symbol));
}

}  // namespace torsor::printing
