// SPDX-License-Identifier: GPL-3.0-or-later
// Worst states through every kernel of one generated header, linked in by kernels_by_number.hpp.
//   states random NUMBER            random states: every result is a number, or a status says so
//   states extremes                 no number, infinity, huge, tiny and denormal inputs
//   states rounding [KERNEL...]     directed rounding against rounding to nearest, within the bound, but for these
//                                   kernels, whose results may be what rounding leaves of terms that cancel
//   states write FILE               results at a few hundred states, bit for bit
//   states same FILE                the same bits
//   states near FILE [KERNEL...]    within the bound (fused multiplications), but for these kernels
// The bound of a kernel that solves nothing is that of its condition; of one that solves, that of the matrix as well,
// and forward dynamics must meet the equations of motion.
// Ends with 1 and a line for each kernel that fails.
#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/headers/stress/bound.hpp"
#include "tests/headers/stress/kernels.hpp"

namespace {

using namespace worst_states;

// A kernel with a status never says ok beside what is no number; one without gives numbers at states drawn from
// the mechanics' own.
int random_states(long number) {
  Kernels kernels;
  Complaints complaints;
  std::mt19937_64 random(20261121);
  long refused = 0;
  for (long n = 0; n < number; ++n) {
    const Values in = kernels.draw(random);
    const Results& at = kernels(in);
    for (std::size_t k = 0; k < at.names.size(); ++k) {
      if (at.status[k] > 0) ++refused;
      if (at.status[k] <= 0 && !at.finite(k)) complaints.add(at.names[k], "a result that is not finite", in);
    }
  }
  std::printf("%ld states, %ld times a status other than ok\n", number, refused);
  return complaints.report();
}

int extremes() {
  Kernels kernels;
  Complaints complaints;
  std::mt19937_64 random(20261121);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_status = [&](const Values& in, const std::string& what) {
    const Results& at = kernels(in);
    for (std::size_t k = 0; k < at.names.size(); ++k) {
      if (at.status[k] == 0 && !at.finite(k)) complaints.add(at.names[k], "ok beside no number, " + what, in);
    }
  };
  for (int repeat = 0; repeat < 5; ++repeat) {
    const Values in = kernels.draw(random);
    // One input that is no number: a kernel that reads it must not lose sight of it.
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      Values bad = in, other = in;
      bad[i] = nan;
      expect_status(bad, "one input no number");
      const Results spoilt = kernels(bad);
      for (const double shift : {0.37, -0.81}) {
        other[i] = in[i] + shift;
        const Results& changed = kernels(other);
        for (std::size_t k = 0; k < spoilt.names.size(); ++k) {
          if (spoilt.status[k] > 0 || changed.status[k] > 0) continue;
          for (std::size_t j = spoilt.begin(k); j < spoilt.end(k); ++j) {
            if (!std::isnan(spoilt.values[j]) && spoilt.values[j] != changed.values[j] && std::isfinite(changed.values[j]))
              complaints.add(spoilt.names[k], "input " + std::to_string(i) + " matters, but not where it is no number", bad);
          }
        }
      }
      for (const double value : {infinite, -infinite, 1e308, -1e308}) {
        bad[i] = value;
        expect_status(bad, value > 1e300 && value < infinite ? "one input 1e308" : "one input infinite");
      }
    }
    for (const double scale : {1e150, 1e-150, 1e-310, 5e-324, 0.0}) {
      for (int which = 0; which < 3; ++which) {  // coordinates, the others, all
        Values scaled = in;
        for (std::size_t i = kernels.begin(coordinates); i < kernels.begin(parameters); ++i) {
          const bool is_coordinate = i < kernels.begin(velocities);
          if (which == 2 || (which == 0) == is_coordinate) scaled[i] = std::copysign(scale, in[i]);
        }
        char name[40];
        std::snprintf(name, sizeof name, "inputs of size %g", scale);
        expect_status(scaled, name);
        // Small velocities, accelerations and forces are states like any other.
        if (scale > 1.0 || which != 1) continue;
        const Results& at = kernels(scaled);
        for (std::size_t k = 0; k < at.names.size(); ++k) {
          if (at.status[k] <= 0 && !at.finite(k)) complaints.add(at.names[k], std::string("no number at ") + name, scaled);
        }
      }
    }
  }
  return complaints.report();
}

// Each result is within 8 roundings of the exact one to nearest (docs/accuracy.md), and a directed rounding is up to
// twice as long: 8 + 16.
constexpr double allowed = 24.0;

using Names = std::vector<std::string>;
bool among(const Names& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Other results of the same kernels against their bounds.
class Comparison {
 public:
  Comparison(const char* what, const Names& excepted) : what_(what), excepted_(excepted) {}

  /// Of kernels that solve nothing in roundings of their condition. Of the others in roundings of the condition of the
  /// matrix too, times the unknowns: what a backward stable solution keeps to.
  void results(const Bound& bound, const Results& found, const Values& in) {
    const double of_motion = bound.of_motion();
    if (of_motion < infinite) {
      most_ = std::max(most_, of_motion);
    } else {
      ++unbounded_;
    }
    for (std::size_t k = 0; k < found.names.size(); ++k) {
      if (among(excepted_, found.names[k])) continue;
      if (found.status[k] > 0 || bound.nearest().status[k] > 0) continue;
      const int solved = solves(found.names[k], bound.constraints() > 0);
      const double size = solved == 0 ? 1.0 : std::pow(of_motion, solved) * bound.unknowns();
      const double off = bound.roundings(found, k) / size;
      double& worst = solved == 0 ? direct_ : solved_;
      worst = std::max(worst, off);
      if (!(off <= allowed)) complaints_.add(found.names[k], what_ + " changes more than the bound", in);
    }
  }

  /// Forward dynamics `found` without inputs, put into inverse dynamics to nearest.
  void equations(Kernels& kernels, const Results& found, const Values& in) {
    if (among(excepted_, "inverse_dynamics")) return;
    const double off = backward(kernels, in, found) / static_cast<double>(kernels.unknowns());
    backward_ = std::max(backward_, off);
    if (!(off <= allowed)) complaints_.add("forward_dynamics", "misses its equations, " + what_, in);
  }

  [[nodiscard]] int report() const {
    std::printf("%s, in roundings, %g allowed: results %.3g of their condition; solutions %.3g of that of the matrix, "
                "equations of motion missed by %.3g, for each unknown; the matrix's condition is at most %.2g, and infinite "
                "at %d states\n",
                what_.c_str(), allowed, direct_, solved_, backward_, most_, unbounded_);
    return complaints_.report();
  }

 private:
  std::string what_;
  const Names& excepted_;
  Complaints complaints_;
  double direct_ = 0.0, solved_ = 0.0, backward_ = 0.0, most_ = 0.0;
  int unbounded_ = 0;
};

/// Without inputs, which inverse_dynamics does not know.
Values without_inputs(const Kernels& kernels, Values in) {
  std::fill(in.begin() + static_cast<std::ptrdiff_t>(kernels.begin(inputs)),
            in.begin() + static_cast<std::ptrdiff_t>(kernels.begin(parameters)), 0.0);
  return in;
}

int rounding(const Names& excepted) {
  Kernels kernels;
  Comparison comparison("directed rounding", excepted);
  std::mt19937_64 random(20261121);
  for (int n = 0; n < 40; ++n) {
    const Values in = without_inputs(kernels, kernels.draw(random));
    const Bound bound(kernels, in);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::fesetround(mode);
      const Results found = kernels(in);
      std::fesetround(FE_TONEAREST);
      comparison.results(bound, found, in);
      comparison.equations(kernels, found, in);
    }
  }
  return comparison.report();
}

// Results at a few hundred states, statuses among them.
Values record(Kernels& kernels, std::vector<Values>* states = nullptr) {
  std::mt19937_64 random(314159);
  Values all;
  for (int n = 0; n < 200; ++n) {
    const Values in = kernels.draw(random);
    if (states != nullptr) states->push_back(in);
    const Results& at = kernels(in);
    for (const int status : at.status) all.push_back(status);
    all.insert(all.end(), at.values.begin(), at.values.end());
  }
  return all;
}

int write(const char* path) {
  Kernels kernels;
  const Values all = record(kernels);
  std::FILE* file = std::fopen(path, "wb");
  if (file == nullptr || std::fwrite(all.data(), sizeof(double), all.size(), file) != all.size() ||
      std::fclose(file) != 0) {
    std::printf("cannot write %s\n", path);
    return 1;
  }
  return 0;
}

/// What `write` left, at the states of `record`: one line of statuses and results for each.
std::vector<Results> read_results(const char* path, Kernels& kernels, const std::vector<Values>& states,
                                  std::size_t size) {
  Values all(size + 1);
  std::FILE* file = std::fopen(path, "rb");
  const std::size_t found = file == nullptr ? 0 : std::fread(all.data(), sizeof(double), all.size(), file);
  if (file != nullptr) std::fclose(file);
  if (found != size) {
    std::printf("%s holds %zu numbers, expected %zu\n", path, found, size);
    return {};
  }
  std::vector<Results> results;
  const double* from = all.data();
  for (const Values& state : states) {
    results.push_back(kernels(state));
    for (int& status : results.back().status) status = static_cast<int>(*from++);
    for (double& value : results.back().values) value = *from++;
  }
  return results;
}

int same(const char* path) {
  Kernels kernels;
  Complaints complaints;
  std::vector<Values> states;
  const std::size_t size = record(kernels, &states).size();
  const std::vector<Results> there = read_results(path, kernels, states, size);
  if (there.empty()) return 1;
  for (std::size_t n = 0; n < states.size(); ++n) {
    const Results& here = kernels(states[n]);
    for (std::size_t k = 0; k < here.names.size(); ++k) {
      bool equal = here.status[k] == there[n].status[k];
      for (std::size_t j = here.begin(k); j < here.end(k); ++j) {
        const double &x = here.values[j], &y = there[n].values[j];
        equal = equal && (std::memcmp(&x, &y, sizeof(double)) == 0 || (std::isnan(x) && std::isnan(y)));
      }
      if (!equal) complaints.add(here.names[k], "other bits than in " + std::string(path), states[n]);
    }
  }
  return complaints.report();
}

int near(const char* path, const Names& excepted) {
  Kernels kernels;
  Comparison comparison("fused multiplication", excepted);
  std::vector<Values> states;
  const std::size_t size = record(kernels, &states).size();
  const std::vector<Results> there = read_results(path, kernels, states, size);
  if (there.empty()) return 1;
  for (std::size_t n = 0; n < 60; ++n) {
    comparison.results(Bound(kernels, states[n]), there[n], states[n]);
    const Values in = without_inputs(kernels, states[n]);
    const Results found = kernels(in);
    comparison.equations(kernels, found, in);
  }
  return comparison.report();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  const Names more(argv + std::min(argc, what == "near" ? 3 : 2), argv + argc);
  if (what == "random" && argc == 3) return random_states(std::atol(argv[2]));
  if (what == "extremes" && argc == 2) return extremes();
  if (what == "rounding") return rounding(more);
  if (what == "write" && argc == 3) return write(argv[2]);
  if (what == "same" && argc == 3) return same(argv[2]);
  if (what == "near" && argc >= 3) return near(argv[2], more);
  std::printf("usage: states random NUMBER | extremes | rounding [KERNEL...] | write FILE | same FILE | near FILE [KERNEL...]\n");
  return 2;
}
