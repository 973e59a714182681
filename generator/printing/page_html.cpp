// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/printing/alike_names.hpp"
#include "torsor/generator/printing/fitted_matrix.hpp"
#include "torsor/generator/printing/html_text.hpp"
#include "torsor/generator/printing/latex_width.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/page.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor::printing {
namespace {

constexpr std::size_t line_of_page = 92;  // characters of plain text on a line of a matrix, in print too
constexpr double width_of_page = 340;  // points of 10-point letters on a line of a window of 1100 pixels; in print more would fit

std::string number_or(const Written& value, std::string (*number)(const Number&), std::string (*write)(const Written&)) {
  const bool alone = value.size() == 1 && value[0].factors.empty() && value[0].coefficient.is_rational();
  return alone ? number(value[0].coefficient) : write(value);
}

/// The unit as a reader expects it, set by KaTeX where it has powers; nothing where there is none.
std::string unit_of(const Symbol& symbol) {
  const std::string unit = written_unit(symbol);
  if (unit == "1") return {};
  if (unit.find('^') == std::string::npos) return html_escaped(unit);
  return fmt::format("<span data-inline=\"{}\">{}</span>", html_escaped(latex_unit(symbol)), html_escaped(unit));
}

/// A sentence with formulas between dollars for the script of the page: text and formulas in turn, with U+2063 between them,
/// which text does not hold. So a dollar in a name stays one.
std::string mixed(const std::string& latex) {
  constexpr std::string_view between = "\xe2\x81\xa3";
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < latex.size(); ++i) {
    if (latex[i] == '$') {
      parts.emplace_back();
      continue;
    }
    if (latex[i] == '\\' && i + 1 < latex.size()) parts.back() += latex[i++];
    parts.back() += latex[i];
  }
  std::string result;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::string part = k % 2 == 0 ? latex_unescaped(parts[k]) : parts[k];
    for (std::size_t at = part.find(between); at != std::string::npos; at = part.find(between)) part.erase(at, between.size());
    result += (k == 0 ? "" : std::string(between)) + html_escaped(part);
  }
  return result;
}

class HtmlPage final : public Page {
 public:
  using Page::Page;
  void title(const SceneContent& scene) override {
    for (const std::string& sentence : alike_names(scene, say)) note(sentence);
  }
  void section(const std::string& heading) override { begin(heading, " open"); }
  void step(const std::string& heading) override { begin(heading, ""); }
  void note(const std::string& sentence) override {
    out_ += fmt::format("<p>{}</p>\n", html_escaped(accented(sentence)));
  }
  void formula(const std::string& plain, const std::string& latex) override {
    out_ += fmt::format("<p data-mixed=\"{}\">{}</p>\n", mixed(latex), html_escaped(plain));
  }
  void symbol(const Symbol& symbol, const std::string& remark) override {
    const std::string unit = unit_of(symbol);
    out_ += fmt::format("<p class=\"symbol\"><span data-inline=\"{}\">{}</span>{} {}</p>\n",
                        html_escaped(latex_name(symbol.name)), html_escaped(symbol.name),
                        unit.empty() ? "" : fmt::format(" [{}]", unit), html_escaped(remark));
  }
  void value(const Symbol& symbol, const Written& value, bool with_unit) override {
    const std::string unit = with_unit ? unit_of(symbol) : "";
    const std::string left = latex_name(symbol.name) + " = " + number_or(value, value_latex, latex);
    const std::string plain = symbol.name + " = " + number_or(value, value_text, text);
    out_ += fmt::format("<p class=\"symbol\"><span data-inline=\"{}\">{}</span> {}</p>\n", html_escaped(left),
                        html_escaped(plain), unit);
  }
  void equation(const std::string& label, const Written& left, const Written& right,
                const Remark& remark) override {
    display("\\begin{aligned}" + latex_equation(left, right, width_of_page) + "\\end{aligned}", text(left) + " = " + text(right), label, remark);
  }
  void stated(const Spelling& left, const Written& right, const Remark& remark) override {
    constexpr double long_left = 150;
    const double left_width = latex_width(left.latex);
    const bool apart = left_width > long_left;
    const std::string form = !apart ? "\\begin{{aligned}}{} &= {}\\end{{aligned}}"
                                    : "\\begin{{aligned}}&{} \\\\\n&\\quad = {}\\end{{aligned}}";
    display(fmt::format(fmt::runtime(form), left.latex, latex_lines(right, width_of_page - (apart ? 25 : left_width + 15)).latex),
            left.plain + " = " + text(right), "", remark);
  }
  void matrix(const Spelling& name, const std::string& entry, const WrittenMatrix& rows) override {
    if (rows.empty() || rows[0].empty()) return;
    const FittedMatrix matrix = fitted(entry, rows, line_of_page, say);
    if (!matrix.instead.empty()) {
      display(fmt::format("{}\\text{{, {}:}}", name.latex, matrix.instead),
              fmt::format("{}, {}:", name.plain, matrix.instead), "", "");
    } else {
      std::string plain = name.plain + " =";
      std::string body = fmt::format("{} = \\begin{{pmatrix}}", name.latex);
      for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
        body += i == 0 ? "" : " \\\\ ";
        plain += "\n  [ ";
        for (std::size_t j = 0; j < matrix.rows[i].size(); ++j) {
          body += (j > 0 ? " & " : "") + latex(matrix.rows[i][j]);
          plain += (j > 0 ? ",  " : "") + text(matrix.rows[i][j]);
        }
        plain += " ]";
      }
      display(body + "\\end{pmatrix}", plain, "", "");
    }
    for (const auto& [entry_name, value] : matrix.named) equation("", named(entry_name), value, "");
  }
  std::string finish() override {
    close();
    return std::move(out_);
  }

 private:
  void begin(const std::string& heading, const char* open) {
    close();
    out_ += fmt::format("<details{}><summary><h3>{}</h3></summary>\n", open, html_escaped(accented(heading)));
    open_ = true;
  }

  void display(const std::string& latex, const std::string& plain, const std::string& label,
               const Remark& remark) {
    out_ += "<div class=\"equation\">";
    if (!label.empty()) {
      out_ += fmt::format("<span class=\"label\" data-inline=\"{}\">{}</span>", html_escaped(latex_name(label)),
                          html_escaped(label));
    }
    out_ += fmt::format("<div class=\"formula\" data-latex=\"{}\">{}</div>", html_escaped(latex), html_lines(plain));
    if (!remark.empty()) {
      const std::string with_formulas = remark.latex.empty() ? "" : fmt::format(" data-mixed=\"{}\"", mixed(remark.latex));
      out_ += fmt::format("<p class=\"remark\"{}>{}</p>", with_formulas, html_escaped(accented(remark.plain)));
    }
    out_ += "</div>\n";
  }

  void close() {
    if (open_) out_ += "</details>\n";
    open_ = false;
  }

  bool open_ = false;
  std::string out_;
};

}  // namespace

std::unique_ptr<Page> html_page(const NaturalLanguage& language) { return std::make_unique<HtmlPage>(language); }

}  // namespace torsor::printing
