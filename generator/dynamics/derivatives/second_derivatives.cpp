// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/derivatives/second_derivatives.hpp"

#include <algorithm>

#include "torsor/generator/program/derivative.hpp"

namespace torsor {
namespace {

class SecondResidualDerivatives {
 public:
  SecondResidualDerivatives(const Equations& equations, Inputs inputs)
      : equations_(equations),
        program_(equations.program()),
        model_(equations.model()),
        inputs_(inputs),
        n_(static_cast<std::size_t>(model_.unknown_count())),
        first_(residual_derivatives(equations, inputs)) {
    for (std::size_t k = 0; k < n_; ++k) {
      by_position_.push_back(model_.along(static_cast<int>(k)));
      by_velocity_.push_back(partial_derivation(program_, model_.coordinates()[k].v));
      distances_.push_back(first_link(k));
    }
  }

  SecondForceDerivatives run() {
    differentiate_masses();
    differentiate_by_position();
    if (equations_.actions().wrenches.empty() && !any_attitude()) {
      velocities_from_masses();
    } else {
      add_by_velocity(first_.by_velocity);
    }
    return std::move(result_);
  }

 private:
  std::optional<int> attitude(std::size_t k) const { return model_.coordinates()[k].attitude; }
  bool any_attitude() const {
    for (std::size_t k = 0; k < n_; ++k) {
      if (attitude(k)) return true;
    }
    return false;
  }
  bool same_attitude(std::size_t j, std::size_t k) const { return attitude(j) && attitude(j) == attitude(k); }

  /// Links stand behind those that carry them.
  std::size_t first_link(std::size_t k) const {
    const std::vector<Link>& links = model_.links();
    const auto moved = [k](const Link& link) {
      return std::any_of(link.partials.begin(), link.partials.end(),
                         [k](const auto& partial) { return partial.first == static_cast<int>(k); });
    };
    return static_cast<std::size_t>(std::find_if(links.begin(), links.end(), moved) - links.begin());
  }
  bool nearer(std::size_t j, std::size_t k) const { return distances_[j] < distances_[k]; }

  Value derivative(Derivation& by, const Value& value) {
    if (value.is_zero()) return {};
    const Value slope = by(value);
    return program_.bind(slope);
  }

  void differentiate_masses() {
    const ValueMatrix& mass = equations_.mass();
    ValuePages& pages = result_.acceleration_position = zero_pages(n_, n_, n_);
    for (std::size_t k = 0; k < n_; ++k) {
      for (std::size_t i = 0; i < n_; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          pages[k][i][j] = derivative(by_position_[k], mass[i][j]);
          pages[k][j][i] = pages[k][i][j];
        }
      }
    }
  }

  void differentiate_by_position() {
    ValuePages& twice = result_.position_position = zero_pages(n_, n_, n_);
    ValuePages& mixed = result_.position_velocity = zero_pages(n_, n_, n_);
    for (std::size_t j = 0; j < n_; ++j) {
      for (std::size_t k = 0; k < n_; ++k) {
        const bool other_order = !same_attitude(j, k) && (nearer(j, k) || (!nearer(k, j) && j < k));
        for (std::size_t i = 0; i < n_; ++i) {
          mixed[k][i][j] = derivative(by_position_[j], first_.by_velocity[i][k]);
          if (other_order) continue;
          twice[k][i][j] = derivative(by_position_[k], first_.by_position[i][j]);
          if (!same_attitude(j, k)) twice[j][i][k] = twice[k][i][j];
        }
      }
    }
  }

  void velocities_from_masses() {
    const ForceDerivatives efforts = effort_derivatives(equations_, inputs_);
    add_by_velocity(efforts.by_velocity);
    const ValuePages& mass = result_.acceleration_position;
    ValuePages& pages = result_.velocity_velocity;
    for (std::size_t j = 0; j < n_; ++j) {
      for (std::size_t k = 0; k <= j; ++k) {
        for (std::size_t i = 0; i < n_; ++i) {
          Value symbol = mass[k][i][j] + mass[j][i][k];
          symbol -= mass[i][j][k];
          pages[k][i][j] = program_.bind(pages[k][i][j] + symbol);
          pages[j][i][k] = pages[k][i][j];
        }
      }
    }
  }

  void add_by_velocity(const ValueMatrix& first) {
    ValuePages& pages = result_.velocity_velocity = zero_pages(n_, n_, n_);
    for (std::size_t j = 0; j < n_; ++j) {
      for (std::size_t k = 0; k <= j; ++k) {
        for (std::size_t i = 0; i < n_; ++i) {
          pages[k][i][j] = derivative(by_velocity_[k], first[i][j]);
          pages[j][i][k] = pages[k][i][j];
        }
      }
    }
  }

  const Equations& equations_;
  Program& program_;
  const Model& model_;
  Inputs inputs_;
  std::size_t n_;
  ForceDerivatives first_;
  std::vector<Derivation> by_position_, by_velocity_;
  std::vector<std::size_t> distances_;
  SecondForceDerivatives result_;
};

}  // namespace

ValuePages zero_pages(std::size_t pages, std::size_t rows, std::size_t columns) {
  return ValuePages(pages, ValueMatrix(rows, std::vector<Value>(columns)));
}

SecondForceDerivatives second_residual_derivatives(const Equations& equations, Inputs inputs) {
  return SecondResidualDerivatives(equations, inputs).run();
}

}  // namespace torsor
