// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "torsor/generator/printing/print_equations.hpp"
#include "torsor/generator/printing/written.hpp"

namespace torsor::printing {

/// One thing in both spellings: plain ASCII, and LaTeX.
struct Spelling {
  std::string plain, latex;
};

/// What is said about an equation: a sentence, or one that holds formulas in LaTeX between dollars.
struct Remark : Spelling {
  Remark() = default;
  Remark(const std::string& sentence) : Spelling{sentence, {}} {}
  Remark(const char* sentence) : Spelling{sentence, {}} {}
  Remark(const std::string& sentence, const std::string& with_formulas) : Spelling{sentence, with_formulas} {}
  bool empty() const { return plain.empty(); }
};

/// A matrix's name, bold in LaTeX.
Spelling bold(const std::string& name);
/// The name of a body, a joint or an action, which is data: an identifier as a symbol, anything else as escaped text.
Spelling named_object(const std::string& name);

/// Where equations are written: one implementation per format. English sentences are plain ASCII; `$...$` never
/// occurs in them.
class Page {
 public:
  explicit Page(const NaturalLanguage& language = {}) : say(language) {}
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  virtual ~Page() = default;

  virtual void title(const SceneContent& scene) = 0;
  virtual void section(const std::string& heading) = 0;
  /// A section that a reader may want to skip: folded where the format folds.
  virtual void step(const std::string& heading) { section(heading); }
  virtual void note(const std::string& sentence) = 0;
  /// A formula inside a sentence of its own: two spellings of the same thing.
  virtual void formula(const std::string& plain, const std::string& latex) = 0;
  /// A line of a list of symbols; `remark` says what it is.
  virtual void symbol(const Symbol& symbol, const std::string& remark) = 0;
  /// symbol = value [unit].
  virtual void value(const Symbol& symbol, const Written& value, bool with_unit) = 0;
  /// left = right; the label names the equation, the remark follows it. Both may be empty.
  virtual void equation(const std::string& label, const Written& left, const Written& right,
                        const Remark& remark) = 0;
  /// The same where the left side is no formula of symbols, e.g. dT/dtheta'.
  virtual void stated(const Spelling& left, const Written& right, const Remark& remark) = 0;
  /// One that is too wide has names in the place of its long entries, which follow it. `entry` begins those names.
  virtual void matrix(const Spelling& name, const std::string& entry,
                      const std::vector<std::vector<Written>>& rows) = 0;
  virtual std::string finish() = 0;

  const NaturalLanguage say;  ///< the language in which sentences are given to it
};

/// Lines of words as a page: one that is not indented begins a section.
std::string words_as_page(const std::string& text, const SceneContent& scene, const PageStyle& style);

/// A page in the format, which names roots that it meets several times.
std::unique_ptr<Page> page_of(const PageStyle& style);

std::unique_ptr<Page> text_page(const NaturalLanguage& language);
std::unique_ptr<Page> latex_page(bool document, const NaturalLanguage& language);
/// Folded sections of HTML without a title: every formula as text, with its LaTeX in the attribute data-latex. Whatever
/// comes from a scene is escaped.
std::unique_ptr<Page> html_page(const NaturalLanguage& language);

/// A one-letter name such as T or z12 as a sum.
Written named(const std::string& name);

}  // namespace torsor::printing
