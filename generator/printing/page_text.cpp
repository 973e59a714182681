// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "generator/printing/notation.hpp"
#include "generator/printing/page.hpp"

namespace torsor::printing {
namespace {

constexpr std::size_t page_width = 160;

/// A lone number as a decimal, anything else as a formula.
std::string value_text(const Written& value) {
  const bool number = value.size() == 1 && value[0].factors.empty();
  return number ? decimal_text(value[0].coefficient) : text(value);
}

/// A coordinate without dimension is an angle, unless it is a quaternion's.
std::string unit_text(const Symbol& symbol) {
  const bool angle =
      symbol.kind == SymbolKind::coordinate && symbol.unit.is_dimensionless() && symbol.attitude.expired();
  return angle ? "rad" : symbol.unit.to_string();
}

class TextPage final : public Page {
 public:
  void title(const SceneContent& scene) override {
    out_ += scene.title.empty() ? fmt::format("{}\n", scene.name) : fmt::format("{}: {}\n", scene.name, scene.title);
  }
  void section(const std::string& heading) override { out_ += "\n" + heading + "\n"; }
  void note(const std::string& sentence) override { out_ += "  " + sentence + "\n"; }
  void formula(const std::string& plain, const std::string&) override { note(plain); }
  void symbol(const Symbol& symbol, const std::string& remark) override {
    out_ += fmt::format("  {} [{}]", symbol.name, unit_text(symbol));
    out_ += remark.empty() ? "\n" : fmt::format("  {}\n", remark);
  }
  void value(const Symbol& symbol, const Written& value, bool with_unit) override {
    out_ += fmt::format("  {} = {}", symbol.name, value_text(value));
    if (with_unit && !symbol.unit.is_dimensionless()) out_ += fmt::format(" {}", symbol.unit.to_string());
    out_ += "\n";
  }
  void equation(const std::string& label, const Written& left, const Written& right,
                const std::string& remark) override {
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
    out_ += remark.empty() ? fmt::format("{}\n", line) : fmt::format("{}    ({})\n", line, remark);
  }
  void matrix(const std::string& name, const std::vector<std::vector<Written>>& rows) override {
    if (rows.empty() || rows[0].empty()) return;
    std::vector<std::size_t> widths(rows[0].size(), 0);
    std::size_t total = 0;
    for (std::size_t j = 0; j < widths.size(); ++j) {
      for (const auto& row : rows) widths[j] = std::max(widths[j], text(row[j]).size());
      total += widths[j] + 3;
    }
    if (total > page_width) {
      entries(name, rows);
      return;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::string head = name + " = ";
      out_ += "  " + (i == 0 ? head : std::string(head.size(), ' ')) + "[ ";
      for (std::size_t j = 0; j < widths.size(); ++j) {
        out_ += fmt::format("{:<{}}", text(rows[i][j]), widths[j]) + (j + 1 < widths.size() ? ",  " : " ]\n");
      }
    }
  }
  std::string finish() override { return std::move(out_); }

 private:
  /// A wide matrix entry by entry; what is not listed is zero.
  void entries(const std::string& name, const std::vector<std::vector<Written>>& rows) {
    bool zeros = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < rows[i].size(); ++j) {
        zeros = zeros || rows[i][j].empty();
        if (rows[i][j].empty()) continue;
        const bool column = rows[i].size() == 1;
        const std::string head =
            column ? fmt::format("  {}[{}] = ", name, i + 1) : fmt::format("  {}[{},{}] = ", name, i + 1, j + 1);
        out_ += head + text_lines(rows[i][j], head.size(), std::string(head.size(), ' '), page_width) + "\n";
      }
    }
    if (zeros) out_ += fmt::format("  The other entries of {} are zero.\n", name);
  }

  std::string out_;
};

}  // namespace

std::unique_ptr<Page> text_page() { return std::make_unique<TextPage>(); }

Written named(const std::string& name) {
  const auto symbol = std::make_shared<const Symbol>(Symbol{name, Unit(), SymbolKind::parameter, 0, nullptr});
  return collected(Sum::symbol(symbol));
}

}  // namespace torsor::printing
