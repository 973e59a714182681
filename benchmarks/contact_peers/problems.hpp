// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "benchmarks/contact_peers/problem.hpp"

namespace torsor::contact_peers {

Problem bouncing_ball(), billiard_ball(), chain_on_floor(), quadruped();
Problem spheres_in_a_box(), six_discs();
Problem discs_that_settle(int discs, int steps);

}  // namespace torsor::contact_peers
