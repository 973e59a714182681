// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/friction_regime.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/program/written_unit.hpp"

namespace torsor {

FrictionRegime::FrictionRegime(EvaluatedMotion& motion) : motion_(motion) {
  const std::size_t count = motion.equations().constraints().size();
  for (std::size_t j = 0; j < count; ++j) {
    if (motion.constraint(j).friction) watched_.push_back({j});
  }
}

void FrictionRegime::look(double t, const std::vector<double>& y) {
  if (watched_.empty()) return;
  motion_.move_to(t, y);
  for (std::size_t j = 0; j < motion_.equations().constraints().size(); ++j) {
    force_ = std::max(force_, std::abs(motion_.multiplier(j)));
  }
  for (Watched& each : watched_) {
    if (each.pulls || each.drives) continue;
    const double lambda = motion_.multiplier(each.row);
    const double power = lambda * motion_.value(motion_.constraint(each.row).friction_power);
    each.power = std::max(each.power, std::abs(power));
    constexpr double rounding = 1e-9, least = 1e-12;  // beside what was met; [N] and [W] where nothing is loaded
    each.pulls = lambda < -rounding * force_ - least;
    each.drives = power > rounding * each.power + least;
    each.time = t;
    each.lambda = lambda;
  }
}

std::vector<std::string> FrictionRegime::remarks() const {
  std::vector<std::string> all;
  for (const Watched& each : watched_) {
    if (!each.pulls && !each.drives) continue;
    const ConstraintRow& row = motion_.constraint(each.row);
    const std::string what =
        each.pulls
            ? fmt::format("the normal force of the constraint '{}' is {:.4g} {}: it pulls, which no surface does", row.name,
                          each.lambda, written_unit(*row.multiplier))
            : fmt::format("the slip at the constraint '{}' is against the direction that its friction assumes: it drives the motion",
                          row.name);
    all.push_back(fmt::format("at t = {:.6g} s {}; for a surface that only presses, whose friction follows the slip, use "
                              "contact(...)",
                              each.time, what));
  }
  return all;
}

}  // namespace torsor
