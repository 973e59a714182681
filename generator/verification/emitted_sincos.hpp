// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsor {

/// Sine and cosine as every generated header computes them (templates/sincos.hpp): the same bits.
void emitted_sincos(double angle, double& sine, double& cosine);
void emitted_sincos(float angle, float& sine, float& cosine);

}  // namespace torsor
