// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/decimal_point.hpp"

#include <clocale>

#ifndef _WIN32
#include <locale.h>

namespace torsor {

DecimalPoint::DecimalPoint() : with_point_(newlocale(LC_NUMERIC_MASK, "C", duplocale(uselocale(locale_t{})))) {
  if (with_point_ != nullptr) before_ = uselocale(static_cast<locale_t>(with_point_));
}

DecimalPoint::~DecimalPoint() {
  if (with_point_ == nullptr) return;
  uselocale(static_cast<locale_t>(before_));
  freelocale(static_cast<locale_t>(with_point_));
}

}  // namespace torsor
#else
#include <string>

namespace torsor {

DecimalPoint::DecimalPoint() : with_point_(new std::string(setlocale(LC_NUMERIC, nullptr))) {
  _configthreadlocale(_ENABLE_PER_THREAD_LOCALE);
  setlocale(LC_NUMERIC, "C");
}

DecimalPoint::~DecimalPoint() {
  const auto* before = static_cast<std::string*>(with_point_);
  setlocale(LC_NUMERIC, before->c_str());
  delete before;
}

}  // namespace torsor
#endif
