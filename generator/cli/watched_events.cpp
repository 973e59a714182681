// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/watched_events.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/printing/formula_text.hpp"

namespace torsor {
namespace {

/// "a = b" is a − b, where a plain number has the unit of the other side.
Expression difference(const std::string& text, const Scene& scene) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return parse_formula(text, scene);
  const Expression left = parse_formula(text.substr(0, equals), scene);
  const Expression right = parse_formula(text.substr(equals + 1), scene);
  const bool number = right.unit() == Unit() && !(left.unit() == Unit());
  return left - (number ? right * Expression::quantity(Number(1), left.unit()) : right);
}

}  // namespace

WatchedEvents::WatchedEvents(const Scene& scene, EvaluatedMotion& motion, const std::vector<EventRequest>& requests)
    : motion_(motion) {
  for (const EventRequest& request : requests) {
    const std::size_t colon = request.text.find(':');
    std::string name = colon == std::string::npos ? request.text : request.text.substr(0, colon);
    const std::string formula = colon == std::string::npos ? request.text : request.text.substr(colon + 1);
    if (name.empty() || name.find_first_of(",\n") != std::string::npos) {
      throw UsageError(fmt::format("an event is NAME: FORMULA or FORMULA, e.g. \"hit: x - l\", and got '{}'", request.text));
    }
    watched_.push_back({std::move(name), motion.watched(difference(formula, scene), formula), request.ends});
  }
}

double WatchedEvents::value(const Watched& watched, const MotionIntegrator& at) const {
  const double number = motion_.value(at.time(), at.state(), watched.formula);
  if (std::isnan(number)) throw Error(fmt::format("the formula of the event '{}' is no number at t = {:.9g} s", watched.name, at.time()));
  return number;
}

std::vector<MetEvent> WatchedEvents::between(const MotionIntegrator& before, const MotionIntegrator& after) {
  std::vector<MetEvent> met;
  for (const Watched& watched : watched_) {
    const double first = value(watched, before), last = value(watched, after);
    if (!((first > 0 && last <= 0) || (first < 0 && last >= 0))) continue;
    if (std::optional<MetEvent> event = located(watched, before, after)) met.push_back(std::move(*event));
  }
  std::stable_sort(met.begin(), met.end(), [](const MetEvent& a, const MetEvent& b) { return a.time < b.time; });
  return met;
}

/// By the Illinois method: the false position, with the weight of an end halved that stays twice. The motion goes on from
/// the row before each time, by the method itself. Nothing where the formula changes its sign by a pole: it is then larger
/// there than at both ends.
std::optional<MetEvent> WatchedEvents::located(const Watched& watched, const MotionIntegrator& before, const MotionIntegrator& after) const {
  double low = before.time(), high = after.time(), at_low = value(watched, before), at_high = value(watched, after);
  double largest = 0.0;
  for (const double end : {at_low, at_high}) {
    if (std::isfinite(end)) largest = std::max(largest, std::abs(end));
  }
  std::unique_ptr<MotionIntegrator> beyond = after.copy();
  int side = 0;
  constexpr int patience = 60;
  for (int step = 0; step < patience && at_high != 0.0 && high - low > 1e-14 * high; ++step) {
    double t = (low * at_high - high * at_low) / (at_high - at_low);
    if (!(t > low && t < high)) t = 0.5 * (low + high);
    std::unique_ptr<MotionIntegrator> there = before.copy();
    if (!there->advance(t)) {
      throw Error(fmt::format("the event '{}' near t = {:.9g} s cannot be located: {}", watched.name, t, there->status()));
    }
    const double now = value(watched, *there);
    if (now != 0.0 && (now > 0) == (at_low > 0)) {
      low = t;
      at_low = now;
      if (side == -1) at_high /= 2;
      side = -1;
    } else {
      high = t;
      at_high = now;
      beyond = std::move(there);
      if (side == 1) at_low /= 2;
      side = 1;
    }
  }
  if (!(std::abs(value(watched, *beyond)) <= largest)) return std::nullopt;
  const double time = beyond->time();
  return MetEvent{watched.name, time, watched.ends, std::move(beyond)};
}

}  // namespace torsor
