// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsor {

/// While it lives, the C library reads numbers of this thread with a decimal point, whatever the locale of the process: a
/// desktop program or a notebook may have set one with a decimal comma.
class DecimalPoint {
 public:
  DecimalPoint();
  DecimalPoint(const DecimalPoint&) = delete;
  DecimalPoint& operator=(const DecimalPoint&) = delete;
  ~DecimalPoint();

 private:
  void* with_point_;
  void* before_ = nullptr;
};

}  // namespace torsor
