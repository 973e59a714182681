// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "generator/printing/html_text.hpp"
#include "generator/printing/notation.hpp"
#include "generator/printing/page.hpp"

namespace torsor::printing {
namespace {

constexpr std::size_t line_of_page = 100;  // characters of plain text on a line

std::string number_or(const Written& value, std::string (*write)(const Written&)) {
  const bool number = value.size() == 1 && value[0].factors.empty() && value[0].coefficient.is_rational();
  return number ? decimal_text(value[0].coefficient) : write(value);
}

/// The unit as a reader expects it: a coordinate without dimension is an angle, unless it is a quaternion's.
std::string unit_in_text(const Symbol& symbol) {
  const bool angle =
      symbol.kind == SymbolKind::coordinate && symbol.unit.is_dimensionless() && symbol.attitude.expired();
  if (angle) return "rad";
  return symbol.unit.is_dimensionless() ? "" : symbol.unit.to_string();
}

class HtmlPage final : public Page {
 public:
  void title(const SceneContent&) override {}
  void section(const std::string& heading) override {
    close();
    out_ += fmt::format("<details open><summary><h3>{}</h3></summary>\n", html_escaped(heading));
    open_ = true;
  }
  void note(const std::string& sentence) override { out_ += fmt::format("<p>{}</p>\n", html_escaped(sentence)); }
  void formula(const std::string& plain, const std::string& latex) override {
    out_ += fmt::format("<p data-mixed=\"{}\">{}</p>\n", html_escaped(latex), html_escaped(plain));
  }
  void symbol(const Symbol& symbol, const std::string& remark) override {
    const std::string unit = unit_in_text(symbol);
    out_ += fmt::format("<p class=\"symbol\"><span data-inline=\"{}\">{}</span>{} {}</p>\n",
                        html_escaped(latex_name(symbol.name)), html_escaped(symbol.name),
                        unit.empty() ? "" : fmt::format(" [{}]", html_escaped(unit)), html_escaped(remark));
  }
  void value(const Symbol& symbol, const Written& value, bool with_unit) override {
    const std::string unit = with_unit ? unit_in_text(symbol) : "";
    const std::string left = latex_name(symbol.name) + " = " + number_or(value, latex);
    const std::string plain = symbol.name + " = " + number_or(value, text);
    out_ += fmt::format("<p class=\"symbol\"><span data-inline=\"{}\">{}</span> {}</p>\n", html_escaped(left),
                        html_escaped(plain), html_escaped(unit));
  }
  void equation(const std::string& label, const Written& left, const Written& right,
                const std::string& remark) override {
    const std::size_t left_size = text(left).size();
    std::string body;
    if (left_size + text(right).size() <= line_of_page) {
      body = fmt::format("{} &= {}", latex(left), latex(right));
    } else if (left_size < 20) {
      body = fmt::format("{} &= {}", latex(left), latex_lines(right, line_of_page));
    } else {
      body = fmt::format("&{} \\\\\n&\\quad = {}", latex_lines(left, line_of_page), latex_lines(right, line_of_page));
    }
    display("\\begin{aligned}" + body + "\\end{aligned}", text(left) + " = " + text(right), label, remark);
  }
  void matrix(const std::string& name, const std::vector<std::vector<Written>>& rows) override {
    if (rows.empty() || rows[0].empty()) return;
    std::size_t widest = 0;
    std::string plain = name + " =";
    std::string body = fmt::format("\\mathbf{{{}}} = \\begin{{pmatrix}}", name);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      body += i == 0 ? "" : " \\\\ ";
      plain += "\n  [ ";
      std::size_t width = 0;
      for (std::size_t j = 0; j < rows[i].size(); ++j) {
        body += (j > 0 ? " & " : "") + latex(rows[i][j]);
        plain += (j > 0 ? ",  " : "") + text(rows[i][j]);
        width += text(rows[i][j]).size() + 2;
      }
      plain += " ]";
      widest = std::max(widest, width);
    }
    if (widest <= 2 * line_of_page) {
      display(body + "\\end{pmatrix}", plain, "", "");
    } else {
      entries(name, rows);
    }
  }
  std::string finish() override {
    close();
    return std::move(out_);
  }

 private:
  /// A wide matrix entry by entry; what is not listed is zero.
  void entries(const std::string& name, const std::vector<std::vector<Written>>& rows) {
    bool zeros = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < rows[i].size(); ++j) {
        zeros = zeros || rows[i][j].empty();
        if (rows[i][j].empty()) continue;
        const std::string index = rows[i].size() == 1 ? fmt::format("{}", i + 1) : fmt::format("{},{}", i + 1, j + 1);
        display(fmt::format("\\begin{{aligned}}\\mathbf{{{}}}_{{{}}} &= {}\\end{{aligned}}", name, index,
                            latex_lines(rows[i][j], line_of_page)),
                fmt::format("{}[{}] = {}", name, index, text(rows[i][j])), "", "");
      }
    }
    if (zeros) note(fmt::format("The other entries of {} are zero.", name));
  }

  void display(const std::string& latex, const std::string& plain, const std::string& label,
               const std::string& remark) {
    out_ += "<div class=\"equation\">";
    if (!label.empty()) {
      out_ += fmt::format("<span class=\"label\" data-inline=\"{}\">{}</span>", html_escaped(latex_name(label)),
                          html_escaped(label));
    }
    out_ += fmt::format("<div class=\"formula\" data-latex=\"{}\">{}</div>", html_escaped(latex), html_lines(plain));
    if (!remark.empty()) out_ += fmt::format("<p class=\"remark\">{}</p>", html_escaped(remark));
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

std::unique_ptr<Page> html_page() { return std::make_unique<HtmlPage>(); }

}  // namespace torsor::printing
