// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace work_precision {

/// A ball that bounces until it rests and a ball that slides until it rolls, by the layer of events over each method:
/// time of the processor and the error of what has a closed form. A table.
void measure_contact(int turns);

}  // namespace work_precision
