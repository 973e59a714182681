// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

/// Sine and cosine to 113 bits, by the C library.
__extension__ typedef __float128 Quad;
void quad_sincos(double angle, Quad& sine, Quad& cosine);

/// |computed - exact| in units of the last place that a number of that many bits (53 or 24) and least exponent has at
/// the exact value.
double ulps(double computed, Quad exact, int bits = 53, int least_exponent = -1022);

/// The same by CLN, for where quad precision might not decide: relative errors of 1e-40 and less.
double ulps_by_cln(double computed, double angle, bool is_sine);

/// The doubles nearest to multiples of pi/2: for each exponent those integers M < 2^53 for which M 2^e comes nearest,
/// by the continued fraction of 2^e 2/pi.
std::vector<double> hardest_reductions();
