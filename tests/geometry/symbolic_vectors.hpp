// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/geometry/vector.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::testing_symbols {

/// A program with vectors whose components are symbols.
struct SymbolicVectors {
  Program program;

  Vector symbols(const std::string& name, const std::string& unit = "1") {
    Vector v;
    for (int i = 0; i < 3; ++i) v[i] = program.lower(make_symbol(name + "xyz"[i], unit));
    return v;
  }
};

}  // namespace torsor::testing_symbols
