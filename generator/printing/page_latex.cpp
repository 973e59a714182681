// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/printing/fitted_matrix.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/page.hpp"

namespace torsor::printing {
namespace {

constexpr std::size_t line_width = 90;  // characters of plain text that fit on a line of the page

std::string value_latex(const Written& value) {
  const bool number = value.size() == 1 && value[0].factors.empty() && value[0].coefficient.is_rational();
  return number ? decimal_text(value[0].coefficient) : latex(value);
}

class LatexPage final : public Page {
 public:
  LatexPage(bool document, const NaturalLanguage& language) : Page(language), document_(document) {
    if (!document) return;
    out_ =
        "\\documentclass[a4paper]{article}\n"
        "\\usepackage[margin=2cm]{geometry}\n"
        "\\usepackage[utf8]{inputenc}\n"
        "\\usepackage{amsmath}\n"
        "\\allowdisplaybreaks\n"
        "\\setlength{\\parindent}{0pt}\n"
        "\\setlength{\\emergencystretch}{3em}\n"
        "\\setcounter{MaxMatrixCols}{64}\n"
        "\\begin{document}\n";
  }
  void title(const SceneContent& scene) override {
    const std::string text = scene.name + (scene.title.empty() ? "" : ": " + scene.title);
    out_ += "\\section*{" + latex_escaped(text) + "}\n";
  }
  void section(const std::string& heading) override {
    close();
    out_ += "\n\\subsection*{" + latex_escaped(accented(heading)) + "}\n";
  }
  void note(const std::string& sentence) override {
    close();
    out_ += latex_escaped(accented(sentence)) + "\\par\n";
  }
  void formula(const std::string&, const std::string& latex) override {
    close();
    out_ += latex + "\\par\n";
  }
  void symbol(const Symbol& symbol, const std::string& remark) override {
    close();
    out_ += fmt::format("${}$ [${}$] {}\\par\n", latex_name(symbol.name), latex_unit(symbol), latex_escaped(remark));
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
    const std::string end = label.empty() ? "" : fmt::format(" \\tag{{${}$}}", latex_name(label));
    if (!broken) {
      row(fmt::format("{} &= {}{}", latex(left), latex(right), end));
    } else if (left_size < 20) {
      row(fmt::format("{} &= {}{}", latex(left), latex_lines(right, line_width - left_size), end));
    } else {  // apart: its lines begin at the margin, not below the = of its neighbours
      close();
      row(fmt::format("&{} \\\\\n  &\\quad = {}{}", latex_lines(left, line_width), latex_lines(right, line_width),
                      end));
      close();
    }
    put(remark);
  }
  void stated(const Spelling& left, const Written& right, const std::string& remark) override {
    row(fmt::format("{} &= {}", left.latex, latex_lines(right, line_width)));
    put(remark);
  }
  void matrix(const Spelling& name, const std::string& entry, const WrittenMatrix& rows) override {
    if (rows.empty() || rows[0].empty()) return;
    const FittedMatrix matrix = fitted(entry, rows, line_width, say);
    if (!matrix.instead.empty()) {
      formula({}, fmt::format("${}$, {}:", name.latex, matrix.instead));
    } else {
      std::string body = fmt::format("{} &= \\begin{{pmatrix}}", name.latex);
      for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
        body += i == 0 ? "\n    " : " \\\\\n    ";
        for (std::size_t j = 0; j < matrix.rows[i].size(); ++j) {
          if (j > 0) body += " & ";
          body += latex(matrix.rows[i][j]);
        }
      }
      row(body + "\n  \\end{pmatrix}");
    }
    for (const auto& [entry_name, value] : matrix.named) {
      row(fmt::format("{} &= {}", latex_name(entry_name), latex_lines(value, line_width)));
    }
  }
  std::string finish() override {
    close();
    if (document_) out_ += "\\end{document}\n";
    return std::move(out_);
  }

 private:
  /// A remark on the equation before it: a line of its own, so that it cannot fall off the page.
  void put(const std::string& remark) {
    if (remark.empty()) return;
    close();
    out_ += fmt::format("\\hfill{{\\small ({})}}\\par\n", latex_escaped(accented(remark)));
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

std::unique_ptr<Page> latex_page(bool document, const NaturalLanguage& language) {
  return std::make_unique<LatexPage>(document, language);
}

}  // namespace torsor::printing
