// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsor {

/// Sine and cosine as every generated header computes them (templates/sincos.hpp): the same bits.
void emitted_sincos(double angle, double& sine, double& cosine);
void emitted_sincos(float angle, float& sine, float& cosine);
/// The same of the angle of (x, y) (templates/selections.hpp).
double emitted_arctangent(double y, double x);
float emitted_arctangent(float y, float x);

}  // namespace torsor
