// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/printing/alike_names.hpp"
#include "torsor/generator/printing/fitted_matrix.hpp"
#include "torsor/generator/printing/latex_width.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/page.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor::printing {
namespace {

constexpr std::size_t matrix_width = 90;  // characters of plain text that fit on a line of the page
constexpr double line_width = 440;  // points: 17 cm without the indent of lines

std::string value_in_latex(const Written& value) {
  const bool number = value.size() == 1 && value[0].factors.empty() && value[0].coefficient.is_rational();
  return number ? value_latex(value[0].coefficient) : latex(value);
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
        "\\setlength{\\emergencystretch}{12em}\n"
        "\\setcounter{MaxMatrixCols}{64}\n"
        "\\begin{document}\n";
  }
  void title(const SceneContent& scene) override {
    const std::string text = scene.name + (scene.title.empty() ? "" : ": " + scene.title);
    out_ += "\\section*{" + latex_escaped(text) + "}\n";
    for (const std::string& sentence : alike_names(scene, say)) note(sentence);
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
    std::string line = fmt::format("{} &= {}", latex_name(symbol.name), value_in_latex(value));
    if (with_unit && written_unit(symbol) != "1") line += fmt::format("\\;{}", latex_unit(symbol));
    row(line);
  }
  void equation(const std::string& label, const Written& left, const Written& right,
                const Remark& remark) override {
    const double label_width = label.empty() ? 0 : latex_width(latex_name(label)) + 25;  // its parentheses, and room before them
    const std::string body = latex_equation(left, right, line_width - label_width);
    const bool apart = body.starts_with('&');
    if (apart) close();
    put(body, label.empty() ? "" : fmt::format(" \\tag{{${}$}}", latex_name(label)), remark);
    if (apart) close();
  }
  void stated(const Spelling& left, const Written& right, const Remark& remark) override {
    const double left_width = latex_width(left.latex) + 15;
    put(fmt::format("{} &= {}", left.latex, latex_lines(right, line_width - left_width).latex), "", remark);
  }
  void matrix(const Spelling& name, const std::string& entry, const WrittenMatrix& rows) override {
    if (rows.empty() || rows[0].empty()) return;
    const FittedMatrix matrix = fitted(entry, rows, matrix_width, say);
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
      row(fmt::format("{} &= {}", latex_name(entry_name), latex_lines(value, line_width - 40).latex));
    }
  }
  std::string finish() override {
    close();
    if (document_) out_ += "\\end{document}\n";
    return std::move(out_);
  }

 private:
  /// An equation with a remark: beside it where one line holds both, else on a line of its own, so that it cannot fall off
  /// the page.
  void put(const std::string& body, const std::string& label, const Remark& remark) {
    constexpr double letter = 5, room = 60;  // points: of small letters, and between a centred equation and what stands beside it
    const double of_remark = letter * static_cast<double>(remark.plain.size()) + room;
    if (!remark.empty() && label.empty() && body.find("\\\\") == std::string::npos && latex_width(body) + 2 * of_remark < line_width) {
      return row(fmt::format("{} \\tag*{{\\small ({})}}", body, said(remark)));
    }
    row(body + label);
    if (remark.empty()) return;
    close();
    out_ += fmt::format("\\hfill{{\\small ({})}}\\par\n", said(remark));
  }
  static std::string said(const Remark& remark) {
    return remark.latex.empty() ? latex_escaped(accented(remark.plain)) : remark.latex;
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
