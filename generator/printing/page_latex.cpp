// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "generator/printing/notation.hpp"
#include "generator/printing/page.hpp"

namespace torsor::printing {
namespace {

constexpr std::size_t line_width = 90;  // characters of plain text that fit on a line of the page

std::string value_latex(const Written& value) {
  const bool number = value.size() == 1 && value[0].factors.empty() && value[0].coefficient.is_rational();
  return number ? decimal_text(value[0].coefficient) : latex(value);
}

class LatexPage final : public Page {
 public:
  explicit LatexPage(bool document) : document_(document) {
    if (!document) return;
    out_ =
        "\\documentclass{article}\n"
        "\\usepackage[utf8]{inputenc}\n"
        "\\usepackage{amsmath}\n"
        "\\allowdisplaybreaks\n"
        "\\setcounter{MaxMatrixCols}{64}\n"
        "\\begin{document}\n";
  }
  void title(const SceneContent& scene) override {
    const std::string text = scene.name + (scene.title.empty() ? "" : ": " + scene.title);
    out_ += "\\section*{" + latex_escaped(text) + "}\n";
  }
  void section(const std::string& heading) override {
    close();
    out_ += "\n\\subsection*{" + latex_escaped(heading) + "}\n";
  }
  void note(const std::string& sentence) override {
    close();
    out_ += latex_escaped(sentence) + "\\par\n";
  }
  void formula(const std::string&, const std::string& latex) override {
    close();
    out_ += latex + "\\par\n";
  }
  void symbol(const Symbol& symbol, const std::string& remark) override {
    close();
    const bool angle =
        symbol.kind == SymbolKind::coordinate && symbol.unit.is_dimensionless() && symbol.attitude.expired();
    out_ += fmt::format("${}$ [${}$] {}\\par\n", latex_name(symbol.name),
                        angle ? "\\mathrm{rad}" : latex_unit(symbol.unit), latex_escaped(remark));
  }
  void value(const Symbol& symbol, const Written& value, bool with_unit) override {
    std::string line = fmt::format("{} &= {}", latex_name(symbol.name), value_latex(value));
    if (with_unit && !symbol.unit.is_dimensionless()) line += fmt::format("\\;{}", latex_unit(symbol.unit));
    row(line);
  }
  void equation(const std::string& label, const Written& left, const Written& right,
                const std::string& remark) override {
    const std::size_t left_size = text(left).size();
    const bool broken = left_size + text(right).size() > line_width;
    std::string end;
    if (!remark.empty()) end += fmt::format(" && \\text{{{}}}", latex_escaped(remark));
    if (!label.empty()) end += fmt::format(" \\tag{{${}$}}", latex_name(label));
    if (!broken) {
      row(fmt::format("{} &= {}{}", latex(left), latex(right), end));
    } else if (left_size < 20) {
      row(fmt::format("{} &= {}{}", latex(left), latex_lines(right, line_width), end));
    } else {
      row(fmt::format("&{} \\\\\n  &\\quad = {}{}", latex_lines(left, line_width), latex_lines(right, line_width),
                      end));
    }
  }
  void matrix(const std::string& name, const std::vector<std::vector<Written>>& rows) override {
    if (rows.empty() || rows[0].empty()) return;
    if (!fits(rows)) {
      entries(name, rows);
      return;
    }
    std::string body = fmt::format("\\mathbf{{{}}} &= \\begin{{pmatrix}}", name);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      body += i == 0 ? "\n    " : " \\\\\n    ";
      for (std::size_t j = 0; j < rows[i].size(); ++j) {
        if (j > 0) body += " & ";
        body += latex(rows[i][j]);
      }
    }
    row(body + "\n  \\end{pmatrix}");
  }
  std::string finish() override {
    close();
    if (document_) out_ += "\\end{document}\n";
    return std::move(out_);
  }

 private:
  static bool fits(const std::vector<std::vector<Written>>& rows) {
    std::size_t total = 0;
    for (std::size_t j = 0; j < rows[0].size(); ++j) {
      std::size_t widest = 0;
      for (const auto& row : rows) widest = std::max(widest, text(row[j]).size());
      total += widest + 2;
    }
    return total <= line_width;
  }

  /// A wide matrix entry by entry; what is not listed is zero.
  void entries(const std::string& name, const std::vector<std::vector<Written>>& rows) {
    bool zeros = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < rows[i].size(); ++j) {
        zeros = zeros || rows[i][j].empty();
        if (rows[i][j].empty()) continue;
        const std::string index = rows[i].size() == 1 ? fmt::format("{}", i + 1) : fmt::format("{},{}", i + 1, j + 1);
        row(fmt::format("\\mathbf{{{}}}_{{{}}} &= {}", name, index, latex_lines(rows[i][j], line_width)));
      }
    }
    if (zeros) note(fmt::format("The other entries of {} are zero.", name));
  }

  /// Neighbouring equations share one environment.
  void row(const std::string& content) {
    out_ += open_ ? " \\\\\n  " : "\\begin{align*}\n  ";
    open_ = true;
    out_ += content;
  }
  void close() {
    if (open_) out_ += "\n\\end{align*}\n";
    open_ = false;
  }

  bool document_;
  bool open_ = false;
  std::string out_;
};

}  // namespace

std::unique_ptr<Page> latex_page(bool document) { return std::make_unique<LatexPage>(document); }

}  // namespace torsor::printing
