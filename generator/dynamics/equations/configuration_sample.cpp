// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/configuration_sample.hpp"

#include <algorithm>

#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/generic_state.hpp"

namespace torsor {

ConfigurationSample::ConfigurationSample(const Model& model)
    : model_(&model), positions_(model.positions()), time_(0), evaluate_(model.program(), {}) {
  const SceneContent& scene = model.scene();
  invent_ = std::any_of(scene.parameters.begin(), scene.parameters.end(), [](const auto& p) { return !p.value; });
  for (const SymbolPointer& q : positions_) values_.push_back(initial_value(scene, q, invent_));
  refresh();
}

// The evaluator asks the sample it belongs to.
ConfigurationSample::ConfigurationSample(const ConfigurationSample& other)
    : model_(other.model_),
      positions_(other.positions_),
      values_(other.values_),
      time_(other.time_),
      varied_(other.varied_),
      invent_(other.invent_),
      evaluate_(other.evaluate_) {
  refresh();
}

ConfigurationSample& ConfigurationSample::operator=(const ConfigurationSample& other) {
  values_ = other.values_;
  time_ = other.time_;
  varied_ = other.varied_;
  refresh();
  return *this;
}

void ConfigurationSample::refresh() {
  evaluate_.move_to([this](const SymbolPointer& symbol) {
    const auto place = std::find(positions_.begin(), positions_.end(), symbol);
    if (place != positions_.end()) return values_[static_cast<std::size_t>(place - positions_.begin())];
    if (symbol->kind == SymbolKind::time) return time_;
    for (const auto& [parameter, value] : varied_) {
      if (parameter == symbol) return value;
    }
    const bool constant = symbol->kind == SymbolKind::parameter || symbol->kind == SymbolKind::pi;
    return constant ? initial_value(model_->scene(), symbol, invent_) : Real(0);
  });
}

Real ConfigurationSample::operator()(const Value& value) { return evaluate_(value); }
std::vector<Real> ConfigurationSample::operator()(const std::vector<Value>& values) { return evaluate_(values); }

void ConfigurationSample::set_time(const Real& time) {
  time_ = time;
  refresh();
}

void ConfigurationSample::vary(const std::vector<SymbolPointer>& parameters, const Real& part) {
  varied_.clear();
  for (const SymbolPointer& parameter : parameters) {
    const Real value = initial_value(model_->scene(), parameter, invent_);
    const Real step = part * generic_value(parameter, 2);
    varied_.emplace_back(parameter, value.is_zero() ? step : value + value * step);
  }
  refresh();
}

void ConfigurationSample::scatter() {
  for (std::size_t i = 0; i < positions_.size(); ++i) values_[i] = generic_value(positions_[i], 1);
  refresh();
}

void ConfigurationSample::displace(const std::vector<Real>& along_freedoms) {
  std::size_t place = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_->unknown_count());) {
    if (!model_->coordinates()[i].attitude) {
      values_[place++] += along_freedoms[i++];
      continue;
    }
    const Real half = Real(1) / Real(2);
    const Real x = half * along_freedoms[i], y = half * along_freedoms[i + 1], z = half * along_freedoms[i + 2];
    const Real w = values_[place], ex = values_[place + 1], ey = values_[place + 2], ez = values_[place + 3];
    const std::array<Real, 4> turned{w - ex * x - ey * y - ez * z, ex + w * x + ey * z - ez * y,
                                     ey + w * y + ez * x - ex * z, ez + w * z + ex * y - ey * x};
    Real square(0);
    for (const Real& e : turned) square += e * e;
    const Real norm = sqrt(square);
    for (std::size_t k = 0; k < 4; ++k) values_[place + k] = turned[k] / norm;
    place += 4;
    i += 3;
  }
  refresh();
}

Real ConfigurationSample::extent(const Unit& unit) const {
  Real largest(0);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (positions_[i]->unit == unit) largest = std::max(largest, abs(values_[i]));
  }
  return largest;
}

}  // namespace torsor
