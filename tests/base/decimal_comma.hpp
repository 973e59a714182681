// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <clocale>
#include <cstdlib>
#include <string>

#include "torsor/generator/base/shell_word.hpp"
#include "torsor/generator/base/temporary_folder.hpp"

namespace torsor::testing_locale {

/// While it lives, this process has a locale with a decimal comma, as desktop programs set it, made for it where the
/// machine has the means.
class DecimalComma {
 public:
  DecimalComma() {
    const std::string made = (folder_.path() / "de_DE.UTF-8").string();
    if (std::system(("localedef -i de_DE -f UTF-8 " + shell_word(made) + " > /dev/null 2>&1").c_str()) != 0) return;
    setenv("LOCPATH", folder_.path().c_str(), 1);
    const bool known = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
    unsetenv("LOCPATH");
    is_set_ = known && *std::localeconv()->decimal_point == ',';
  }
  DecimalComma(const DecimalComma&) = delete;
  DecimalComma& operator=(const DecimalComma&) = delete;
  ~DecimalComma() { std::setlocale(LC_ALL, "C"); }

  bool is_set() const { return is_set_; }

 private:
  TemporaryFolder folder_{folder_of_temporary_files(), "torsor-locale-"};
  bool is_set_ = false;
};

}  // namespace torsor::testing_locale
