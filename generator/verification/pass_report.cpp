// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/pass_report.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/listing/earliest_start.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "torsor/generator/verification/verify.hpp"
#include "torsor/generator/verification/worst.hpp"

namespace torsor {
namespace {

/// The kernels of a scene under one choice of passes.
struct Variant {
  Variant(const Scene& scene, const std::vector<std::string>& names, const ModelOptions& options)
      : kernels(make_own_kernels(scene, options, names)) {
    std::erase_if(kernels, [](const OwnKernel& each) { return each.kernel.series.has_value(); });
  }

  const Kernel& kernel(std::size_t k) const { return kernels[k].kernel; }
  const Program& program(std::size_t k) const { return kernels[k].equations->program(); }
  int operations(std::size_t k) const { return count(program(k), kernel(k).values()).total(); }
  int cycles(std::size_t k) const {
    const Program& program = this->program(k);
    const EarliestStarts starts(program);
    int last = 0;
    for (const Value& value : kernel(k).values()) {
      last = std::max(last, starts(starts.scheduled(value.polynomial())));
    }
    return last;
  }

  std::vector<OwnKernel> kernels;
};

using Results = std::vector<std::vector<Real>>;  ///< of every kernel at one state

/// At the states of seeds `seed`, `seed` + 1, …
std::vector<Results> results_of(const Scene& scene, const Variant& variant, const PassReportOptions& asked) {
  std::vector<Results> results;
  std::vector<Evaluator<Real>> evaluate;
  for (const OwnKernel& own : variant.kernels) {
    evaluate.emplace_back(own.equations->program(), Evaluator<Real>::SymbolValue());
  }
  for (int s = 0; s < asked.states; ++s) {
    const RandomState state(scene, asked.seed + static_cast<std::uint64_t>(s));
    results.emplace_back();
    for (std::size_t k = 0; k < variant.kernels.size(); ++k) {
      evaluate[k].move_to(state.in_real());
      results.back().emplace_back();
      for (const Assignment& each : variant.kernel(k).assignments) {
        results.back().back().push_back(evaluate[k](each.value));
      }
    }
  }
  return results;
}

/// Of the results of one kernel, unit by unit: numbers of different units have no common norm.
double difference(const Kernel& kernel, const std::vector<Real>& first, const std::vector<Real>& second) {
  std::map<std::string, std::pair<Real, Real>> sums;  // by unit: squares of differences, of results
  for (std::size_t i = 0; i < kernel.assignments.size(); ++i) {
    const std::string unit = kernel.assignments[i].value.unit().to_string();
    auto& [apart, size] = sums.try_emplace(unit, Real(0), Real(0)).first->second;
    apart += (first[i] - second[i]) * (first[i] - second[i]);
    size += first[i] * first[i];
  }
  double worst = 0;
  for (const auto& [unit, sum] : sums) {
    if (sum.first.is_zero()) continue;
    const Real size = sum.second.is_zero() ? Real(1) : sum.second;  // nothing is left: absolutely
    const double ratio = std::sqrt((sum.first / size).to_double());
    if (is_worse(ratio, worst)) worst = ratio;
  }
  return worst;
}

std::map<std::string, double> worst_errors(const Scene& scene, const ModelOptions& model,
                                           const std::vector<std::string>& kernels, const PassReportOptions& report) {
  VerifyOptions options;
  options.model = model;
  options.kernels = kernels;
  options.precisions = {Precision::in_double};
  options.digits = report.digits;
  options.states = report.states;
  options.seed = report.seed;
  options.climbs = 0;
  std::map<std::string, double> worst;
  for (const VerifyRow& row : verify_scene(scene, options)) {
    double& known = worst[row.kernel];
    if (is_worse(row.worst.scaled, known)) known = row.worst.scaled;
  }
  return worst;
}

/// A kernel whose results all vanish has no errors.
double error_of(const std::map<std::string, double>& errors, const std::string& kernel) {
  const auto place = errors.find(kernel);
  return place == errors.end() ? 0 : place->second;
}

}  // namespace

bool PassReport::equal() const {
  const double allowed = std::pow(10.0, -2.0 * digits / 3);
  for (const KernelPasses& kernel : kernels) {
    for (const PassEffect& effect : kernel.without) {
      if (!(effect.difference <= allowed)) return false;
    }
  }
  return true;
}

PassReport report_passes(const Scene& scene, const std::vector<std::string>& names, const ModelOptions& options,
                         const PassReportOptions& asked) {
  const WorkingDigits precision(asked.digits + 10);
  PassReport report{scene.name(), {}, {}, asked.digits};
  const Variant whole(scene, names, options);
  std::vector<std::string> present;
  for (const OwnKernel& each : whole.kernels) present.push_back(each.kernel.name);
  const auto errors = worst_errors(scene, options, present, asked);
  for (std::size_t k = 0; k < present.size(); ++k) {
    report.kernels.push_back({present[k], {whole.operations(k), whole.cycles(k), 0, error_of(errors, present[k])}, {}});
  }
  const std::vector<Results> exact = results_of(scene, whole, asked);
  for (const Pass& pass : all_passes()) {
    if (!(options.passes.*(pass.on))) continue;
    report.passes.emplace_back(pass.name);
    ModelOptions fewer = options;
    fewer.passes.*(pass.on) = false;
    const Variant variant(scene, present, fewer);
    const auto errors_without = worst_errors(scene, fewer, present, asked);
    const std::vector<Results> other = results_of(scene, variant, asked);
    for (std::size_t k = 0; k < present.size(); ++k) {
      double apart = 0;
      for (std::size_t n = 0; n < exact.size(); ++n) {
        const double here = difference(whole.kernel(k), exact[n][k], other[n][k]);
        if (is_worse(here, apart)) apart = here;
      }
      report.kernels[k].without.push_back(
          {variant.operations(k), variant.cycles(k), apart, error_of(errors_without, present[k])});
    }
  }
  return report;
}

}  // namespace torsor
