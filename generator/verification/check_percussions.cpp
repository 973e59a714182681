// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/check_percussions.hpp"

#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/verification/lagrange_derivation.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "torsor/generator/verification/worst.hpp"

namespace torsor {
namespace {

class PercussionCheck {
 public:
  PercussionCheck(const Scene& scene, const CheckOptions& options)
      : scene_(scene), options_(options), precision_(options.digits + 10), kernels_(scene), road_(scene) {
    for (const char* name : {"impact", "delassus"}) {
      for (const Assignment& each : make_kernel(name, kernels_).assignments) {
        results_.emplace(each.target.member + fmt::format("[{}]", each.target.entry.value_or(0)), each.value);
      }
    }
    for (const ContactRows& contact : contact_rows(road_.equations().model())) {
      rows_.insert(rows_.end(), contact.rows.begin(), contact.rows.end());
    }
  }

  std::vector<CheckResult> run() {
    for (int k = 0; k < options_.states; ++k) {
      const RandomState state(scene_, static_cast<std::uint64_t>(k) + 1);
      Evaluator<Real> here(kernels_.program(), state.in_real());
      Evaluator<Real> there(road_.equations().program(), [&](const SymbolPointer& symbol) {
        return is_released(symbol) ? Real(0) : state.in_real()(symbol);
      });
      put_back(here, there);
    }
    const double bound = std::pow(10.0, 5 - options_.digits);  // five digits for rounding and cancellation
    return {{"impact", "answers to unit impulses put back into the jump equations", jumps_, bound},
            {"delassus", "W and q against rows of contacts along those answers and the motion", delassus_, bound}};
  }

 private:
  bool is_released(const SymbolPointer& symbol) const {
    const auto& coordinates = kernels_.model().coordinates();
    for (auto i = static_cast<std::size_t>(kernels_.model().unknown_count()); i < coordinates.size(); ++i) {
      if (symbol == coordinates[i].q || symbol == coordinates[i].v || symbol == coordinates[i].a) return true;
    }
    return false;
  }

  /// |Σ terms| over Σ |terms|, or over a size that is larger: terms that all vanish leave their rounding.
  static void keep(const std::vector<Real>& terms, double& worst, const Real& least = Real(0)) {
    Real sum(0), size(0);
    for (const Real& term : terms) {
      sum += term;
      size += abs(term);
    }
    if (size < least) size = least;
    if (sum == Real(0)) return;
    const double relative = (abs(sum) / size).to_double();
    if (is_worse(relative, worst)) worst = relative;
  }

  void put_back(Evaluator<Real>& here, Evaluator<Real>& there) {
    const auto n = static_cast<std::size_t>(kernels_.model().unknown_count());
    const std::size_t m = kernels_.constraints().size(), count = rows_.size();
    const auto entry = [&](const char* member, std::size_t i) { return here(results_.at(fmt::format("{}[{}]", member, i))); };
    const std::vector<Real> a = here(kernels_.forward().accelerations);
    // Sizes for terms that vanish: with Cauchy's inequality in the metric of the masses, J a is at most √(W aᵀ M a).
    std::vector<Real> diagonal, own;
    Real energy(0);
    for (std::size_t i = 0; i < n; ++i) {
      diagonal.push_back(there(road_.mass()[i][i]));
      for (std::size_t j = 0; j < n; ++j) energy += a[i] * there(road_.mass()[i][j]) * a[j];
    }
    for (std::size_t s = 0; s < count; ++s) own.push_back(abs(entry("matrix", count * s + s)));
    for (std::size_t s = 0; s < count; ++s) {
      std::vector<Real> jump;
      for (std::size_t i = 0; i < n; ++i) jump.push_back(entry("velocities", n * s + i));
      for (std::size_t i = 0; i < n; ++i) {
        std::vector<Real> terms{-there(rows_[s].jacobian[i])};
        for (std::size_t j = 0; j < n; ++j) terms.push_back(there(road_.mass()[i][j]) * jump[j]);
        for (std::size_t j = 0; j < m; ++j) {
          const ConstraintRow& row = road_.equations().constraints()[j];
          terms.push_back(-(there(row.jacobian[i]) * entry("multipliers", m * s + j)));
        }
        keep(terms, jumps_, sqrt(diagonal[i] * own[s]));
      }
      for (const std::size_t j : kernels_.redundancy().kept) {
        const std::vector<Value>& row = road_.equations().constraints()[j].jacobian;
        Real size(0);
        for (std::size_t i = 0; i < n; ++i) size += abs(there(row[i])) * sqrt(own[s] / diagonal[i]);
        keep(along(row, jump, there), jumps_, size);
      }
      for (std::size_t r = 0; r < count; ++r) {
        std::vector<Real> terms = along(rows_[r].jacobian, jump, there);
        terms.push_back(-entry("matrix", count * s + r));
        keep(terms, delassus_, sqrt(own[r] * own[s]));
      }
      std::vector<Real> terms = along(rows_[s].jacobian, a, there);
      terms.push_back(there(rows_[s].drift));
      terms.push_back(-entry("free", s));
      keep(terms, delassus_, sqrt(own[s] * energy));
    }
  }

  static std::vector<Real> along(const std::vector<Value>& row, const std::vector<Real>& v, Evaluator<Real>& there) {
    std::vector<Real> terms;
    for (std::size_t i = 0; i < v.size(); ++i) terms.push_back(there(row[i]) * v[i]);
    return terms;
  }

  const Scene& scene_;
  CheckOptions options_;
  WorkingDigits precision_;
  Equations kernels_;
  LagrangeDerivation road_;
  std::map<std::string, Value> results_;  ///< of both kernels, "velocities[3]"
  std::vector<ContactRow> rows_;
  double jumps_ = 0, delassus_ = 0;
};

}  // namespace

std::vector<CheckResult> check_percussions(const Scene& scene, const CheckOptions& options) {
  if (scene.content().contacts.empty() || !Equations(scene).massless().empty()) return {};
  return PercussionCheck(scene, options).run();
}

}  // namespace torsor
