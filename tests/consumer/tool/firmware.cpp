// SPDX-License-Identifier: GPL-3.0-or-later
#include "sliding_arm.hpp"

template struct sliding_arm::Mechanism<float>;
