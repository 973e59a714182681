// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/dormand_prince_853.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "torsor/generator/verification/dormand_prince_853_tableau.hpp"

namespace torsor {
namespace {

using Tableau = DormandPrince853Tableau;
// Hairer's constants of dop853, but for the safety factor: at 0.9 pendulums have every fifth step rejected.
constexpr double safety = 0.8, strongest_shrink = 0.3, strongest_growth = 6.0;

double factor_for(double error) {
  if (!std::isfinite(error)) return strongest_shrink;
  return error > 0 ? std::clamp(safety * std::pow(error, -1.0 / 8), strongest_shrink, strongest_growth) : strongest_growth;
}

}  // namespace

DormandPrince853::DormandPrince853(Slope slope, Settle settle, std::vector<double> y, double tolerance)
    : MotionIntegrator(std::move(slope), std::move(settle), std::move(y)), tolerance_(tolerance) {
  trial_ = next_ = y_;
  for (std::vector<double>& each : slopes_) each.resize(y_.size());
  if (!slope_(t_, y_, slopes_[0])) fail("there is no acceleration");
}

bool DormandPrince853::advance(double end) {
  if (!status_.empty()) return false;
  if (h_ == 0.0) h_ = first_step(end - t_);
  constexpr int patience = 60;  // of one step after another that is refused
  int refused = 0;
  const double least = shortest_step(end);
  while (end - t_ > least) {
    const bool lands = h_ >= end - t_;
    const double h = lands ? end - t_ : h_;
    const double error = attempt(h), reached = lands ? end : t_ + h;
    const bool kept = error <= 1.0;
    const double moved = kept ? settled(reached, next_, tolerance_) : 0.0;
    if (!kept || !(moved <= 1.0)) {
      h_ = h * std::min(1.0, factor_for(kept ? moved : error));
      if (++refused > patience || h_ < least) {
        if (moved > 1.0) return fail_settling();
        return fail(kept                ? "the constraints cannot be closed"
                    : std::isnan(error) ? "there is no acceleration"
                                        : "the steps have become too short");
      }
      continue;
    }
    const bool creeping = creeps(h, bend(h));
    t_ = reached;
    y_ = next_;
    ++steps_;
    if (creeping) return fail_creeping();
    if (!slope_(t_, y_, slopes_[0])) return fail("there is no acceleration");
    const double wanted = h * factor_for(error);
    // A step cut short to land on a time says little about how long the next may be.
    h_ = refused > 0 ? std::min(wanted, h) : h < 0.99 * h_ ? std::max(wanted, h_) : wanted;
    refused = 0;
  }
  return true;
}

double DormandPrince853::attempt(double h) {
  const std::size_t n = y_.size();
  for (std::size_t stage = 1; stage <= Tableau::stages; ++stage) {
    std::vector<double>& to = stage < Tableau::stages ? trial_ : next_;
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < stage; ++j) {
        if (Tableau::weights[stage - 1][j] != 0.0) sum += Tableau::weights[stage - 1][j] * slopes_[j][i];
      }
      to[i] = y_[i] + h * sum;
    }
    if (stage < Tableau::stages && !slope_(t_ + Tableau::times[stage] * h, trial_, slopes_[stage])) return std::nan("");
  }
  double fifth = 0.0, third = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    double off = 0.0, slope = 0.0;
    for (std::size_t j = 0; j < Tableau::stages; ++j) {
      off += Tableau::fifth[j] * slopes_[j][i];
      slope += Tableau::weights[Tableau::stages - 1][j] * slopes_[j][i];
    }
    const double low = Tableau::third[0] * slopes_[0][i] + Tableau::third[1] * slopes_[8][i] + Tableau::third[2] * slopes_[11][i];
    const double weight = tolerance_ * (1.0 + std::max(std::abs(y_[i]), std::abs(next_[i])));
    fifth += (off / weight) * (off / weight);
    third += ((slope - low) / weight) * ((slope - low) / weight);
  }
  const double mixed = fifth + 0.01 * third;
  return mixed == 0.0 ? 0.0 : std::abs(h) * fifth / std::sqrt(mixed * static_cast<double>(n));
}

double DormandPrince853::bend(double h) const {
  double most = 0.0;
  for (std::size_t i = 0; i < y_.size(); ++i) {
    const double weight = tolerance_ * (1.0 + std::max(std::abs(y_[i]), std::abs(next_[i])));
    for (std::size_t j = 1; j < Tableau::stages; ++j) most = std::max(most, h * std::abs(slopes_[j][i] - slopes_[0][i]) / weight);
  }
  return most;
}

double DormandPrince853::first_step(double span) const {
  double size = 0.0, slope = 0.0;
  for (std::size_t i = 0; i < y_.size(); ++i) {
    const double weight = 1.0 + std::abs(y_[i]);
    size += (y_[i] / weight) * (y_[i] / weight);
    slope += (slopes_[0][i] / weight) * (slopes_[0][i] / weight);
  }
  const double guess = slope > 0 && size > 0 ? 0.01 * std::sqrt(size / slope) : 1e-3;
  return std::min(span, std::max(guess, 1e-6 * span));
}

}  // namespace torsor
