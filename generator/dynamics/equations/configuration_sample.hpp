// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {

/// A configuration of a scene in numbers: where values of its program are evaluated, from where it can be displaced
/// along the freedoms. It starts as the scene does, at t = 0; parameters that have no value get an invented one.
class ConfigurationSample {
 public:
  explicit ConfigurationSample(const Model& model);
  ConfigurationSample(const ConfigurationSample& other);
  ConfigurationSample& operator=(const ConfigurationSample& other);
  ~ConfigurationSample() = default;

  /// Value at this configuration and time; velocities, accelerations, inputs and multipliers are zero.
  Real operator()(const Value& value);
  std::vector<Real> operator()(const std::vector<Value>& values);

  /// Adds δ to each coordinate; turns each unit quaternion e by δ in its moving axes: e + ½ e (0, δ), normalised.
  void displace(const std::vector<Real>& along_freedoms);
  /// Gives every position a generic value.
  void scatter();
  void set_time(const Real& time);
  /// Gives parameters other values than their own: by that part of it, or by that much when it is zero.
  void vary(const std::vector<SymbolPointer>& parameters, const Real& part);
  /// Largest size of the coordinates that have that unit.
  Real extent(const Unit& unit) const;

 private:
  void refresh();

  const Model* model_;
  std::vector<SymbolPointer> positions_;
  std::vector<Real> values_;  ///< of the positions
  Real time_;
  std::vector<std::pair<SymbolPointer, Real>> varied_;  ///< parameters that have another value here
  bool invent_ = false;
  Evaluator<Real> evaluate_;
};

}  // namespace torsor
