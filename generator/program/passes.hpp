// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsor {

/// Which passes are on: what makes kernels cheap. Each is exact, and can be left out to see what it saves; the table of
/// all is all_passes() in dynamics/motion/pass_table.hpp.
struct Passes {
  bool sharing = true;
  bool identities = true;
  bool zero_test = true;
  bool products = true;
  bool factoring = true;
  bool hoisting = true;
  bool reframing = true;
  bool regrouping = true;
  bool off_axis = true;
  bool length_unit = true;
  bool scheduling = true;
};

}  // namespace torsor
