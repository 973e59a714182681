// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/motion/model.hpp"

namespace torsor {

/// Whether a joint may have to carry far more than its own link's matter, so that its pivot by difference loses digits:
/// a link is lighter than a tenth of what it carries, by the scene's values; of up to four unknowns also where masses
/// are set at run time, whatever they are. Of more than eight unknowns none is looked at.
bool light_may_carry_heavy(const Model& model);

/// Whether an energy may lose digits that way: a link with matter of its own carries a hundred times as much, or, of
/// up to four unknowns, masses are set at run time. Links without matter only place others, and take nothing from an energy.
bool light_matter_may_carry_heavy(const Model& model);

/// The method of forward dynamics that loses no digits where a light link carries a heavy one. Each is evaluated in 20
/// digits at 32 states, angles near multiples of a quarter turn and near each other among them, masses that are set at
/// run time of ratios up to 10^±6,
/// and compared with 60 digits; the error of the most accurate one there stands for the condition of the state. The
/// answer is `cheapest` where the cheapest loses less than a digit more than that, else the most accurate.
ForwardMethod forward_method_that_keeps_digits(const Scene& scene, const ModelOptions& options);

}  // namespace torsor
