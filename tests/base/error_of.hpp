// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <string>

#include "torsor/generator/base/error.hpp"

namespace torsor::testing_errors {

/// The text of the error an action throws; says so when it throws none.
template <class Expected = Error>
std::string error_of(const auto& action) {
  try {
    action();
  } catch (const Expected& error) {
    return error.what();
  } catch (const std::exception& error) {
    return std::string("another kind of error: ") + error.what();
  }
  return "no error";
}

}  // namespace torsor::testing_errors
