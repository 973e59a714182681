// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

// Names in generated texts of any language. A user's name has a letter first, no underscore last and none doubled; as a
// member it stands as it is, as a local variable it gets a prefix of its kind. What a printer needs beside users'
// members ends in an underscore. So no two names can meet, whatever the user chose.

/// The local variable that holds a value number: q_theta, v_theta, a_theta, u_torque, l_normal, p_mass, t; s_theta and c_theta
/// for sine and cosine of a coordinate or parameter; empty for everything else, which is numbered function by function.
std::string local_name(const Program& program, ValueNumber value_number);

/// The coordinate's name for its velocity and acceleration too, else the symbol's own.
std::string member_name(const Symbol& symbol);

/// The local variable of a number: n2, n9_81, n1_over_3; k<index> when its text would be long.
std::string constant_name(const Number& number, std::size_t index);

}  // namespace torsor
