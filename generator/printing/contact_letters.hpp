// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene_content.hpp"
#include "torsor/generator/printing/page.hpp"

namespace torsor::printing {

/// Letters of the laws of contact: g of a gap, e, f, h, b of coefficients. One that a symbol of the scene has gets an index,
/// so that its gravity g is no gap.
class ContactLetters {
 public:
  explicit ContactLetters(const SceneContent& scene);

  /// A sentence or a name in plain text, and a formula in LaTeX, with the letters of this page.
  std::string plain(const std::string& text) const { return replaced(text, false); }
  std::string latex(const std::string& formula) const { return replaced(formula, true); }
  /// A sentence with formulas between dollars.
  std::string in_sentence(const std::string& text) const;

 private:
  struct Letter {
    std::string usual;
    Spelling here;
  };

  std::string replaced(const std::string& text, bool latex) const;

  std::vector<Letter> letters_;
};

}  // namespace torsor::printing
