// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "torsor/runtime/contacts/contact_problem.hpp"

namespace torsor::runtime {

/// What the automaton knows of one contact between events.
struct ContactState {
  bool touches = false;  ///< gap and its rate are zero; always so of dry friction
  ContactRegime regime = ContactRegime::open;
  std::array<double, 2> direction{1, 0};  ///< of slip, while it slides
  double fastest = 0;                     ///< the largest slip since it slides [m/s]
  bool begins = false;                    ///< its slip has just begun: the direction follows from forces
  double begun = 0;                       ///< when [s]
  double residue = 0;                     ///< what was left of w_T then, an error whatever its size [m/s]
  bool fades = false;                     ///< its slip has been near its end, and is followed through it
  bool idle = false;      ///< it neither presses nor opens, to rounding: closed until N is negative beyond that
  double force_slack = 0;                 ///< [N] it was decided with N, or what is left of its bound, zero to rounding
};

}  // namespace torsor::runtime
