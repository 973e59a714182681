// SPDX-License-Identifier: GPL-3.0-or-later
// Worst states through every kernel of one generated header, linked in by kernels_by_number.hpp.
//   states random NUMBER            random states: every result is a number, or a status says so
//   states extremes                 no number, infinity, huge, tiny and denormal inputs
//   states rounding [KERNEL...]     directed rounding against rounding to nearest, within the bound, but for these
//                                   kernels, whose results may be what rounding leaves of terms that cancel
//   states write FILE               results at a few hundred states, bit for bit
//   states same FILE                the same bits
//   states near FILE [KERNEL...]    within the bound (fused multiplications)
// Ends with 1 and a line for each kernel that fails.
#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

extern "C" {
void torsor_evaluate(const double* in, double* out, int* status, const char** names, int* ends, int* kernels);
void torsor_start(double* in);
int torsor_size_of_part(int part);
int torsor_quaternion(int number);
}

namespace {

using Values = std::vector<double>;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int parts = 6;
enum Part { coordinates, velocities, accelerations, multipliers, inputs, parameters };

struct Results {
  Values values;
  std::vector<int> status, ends;
  std::vector<const char*> names;

  [[nodiscard]] std::size_t begin(std::size_t kernel) const {
    return kernel == 0 ? 0 : static_cast<std::size_t>(ends[kernel - 1]);
  }
  [[nodiscard]] std::size_t end(std::size_t kernel) const { return static_cast<std::size_t>(ends[kernel]); }
  [[nodiscard]] bool finite(std::size_t kernel) const {
    for (std::size_t i = begin(kernel); i < end(kernel); ++i) {
      if (!std::isfinite(values[i])) return false;
    }
    return true;
  }
};

class Kernels {
 public:
  Kernels() {
    for (int part = 0; part < parts; ++part) begins_[part + 1] = begins_[part] + torsor_size_of_part(part);
    Values in = start();
    results_.values.resize(200'000);
    results_.status.resize(32);
    results_.ends.resize(32);
    results_.names.resize(32);
    int count = 0;
    torsor_evaluate(in.data(), results_.values.data(), results_.status.data(), results_.names.data(),
                    results_.ends.data(), &count);
    const auto kernels = static_cast<std::size_t>(count);
    results_.status.resize(kernels);
    results_.ends.resize(kernels);
    results_.names.resize(kernels);
    results_.values.resize(static_cast<std::size_t>(results_.ends.back()));
  }

  /// Time, then the parts.
  [[nodiscard]] std::size_t begin(int part) const { return 1 + static_cast<std::size_t>(begins_[part]); }
  [[nodiscard]] std::size_t size() const { return begin(parts); }

  [[nodiscard]] Values start() const {
    Values in(size(), 0.0);
    torsor_start(in.data());
    return in;
  }

  /// About the initial state: coordinates moved by up to 2, everything else drawn from (-3, 3); parameters as they are.
  [[nodiscard]] Values draw(std::mt19937_64& random) const {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    Values in = start();
    in[0] = std::abs(uniform(random));
    for (std::size_t i = begin(coordinates); i < begin(velocities); ++i) in[i] += 2.0 * uniform(random);
    for (std::size_t i = begin(velocities); i < begin(parameters); ++i) in[i] = 3.0 * uniform(random);
    normalise(in);
    return in;
  }

  void normalise(Values& in) const {
    for (int number = 0; torsor_quaternion(number) >= 0; ++number) {
      double* q = in.data() + begin(coordinates) + torsor_quaternion(number);
      const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
      for (int i = 0; i < 4; ++i) q[i] /= norm;
    }
  }

  const Results& operator()(const Values& in) {
    int count = 0;
    torsor_evaluate(in.data(), results_.values.data(), results_.status.data(), nullptr, nullptr, &count);
    return results_;
  }

 private:
  int begins_[parts + 1] = {};
  Results results_;
};

/// One line for each kernel and complaint, however often it happens.
class Complaints {
 public:
  void add(const char* kernel, const std::string& what, const Values& in) {
    auto& entry = seen_[std::string(kernel) + ": " + what];
    if (entry.first++ == 0) entry.second = in;
  }
  [[nodiscard]] int report() const {
    for (const auto& [what, entry] : seen_) {
      std::printf("%s (%ld times), first at", what.c_str(), entry.first);
      for (const double value : entry.second) std::printf(" %.17g", value);
      std::printf("\n");
    }
    return seen_.empty() ? 0 : 1;
  }

 private:
  std::map<std::string, std::pair<long, Values>> seen_;
};

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

/// What a result may be off by rounding: `ulps` of what a change of each input by a rounding makes of it, at least of
/// the largest result of its kernel. The sizes are those of a kernel's results, of one order of magnitude each.
class Bound {
 public:
  Bound(Kernels& kernels, const Values& in) : nearest_(kernels(in)), condition_(nearest_.names.size(), 0.0) {
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      Values up = in, down = in;
      const double step = 1e-6 * std::max(1e-3, std::abs(in[i]));
      up[i] += step;
      down[i] -= step;
      const Results above = kernels(up);
      const Results& below = kernels(down);
      for (std::size_t k = 0; k < condition_.size(); ++k) {
        double change = 0.0;
        for (std::size_t j = above.begin(k); j < above.end(k); ++j) {
          change = std::max(change, std::abs(above.values[j] - below.values[j]));
        }
        condition_[k] += change / (up[i] - down[i]) * std::abs(in[i]);
      }
    }
    for (std::size_t k = 0; k < condition_.size(); ++k) {
      for (std::size_t j = nearest_.begin(k); j < nearest_.end(k); ++j) {
        condition_[k] = std::max(condition_[k], std::abs(nearest_.values[j]));
      }
    }
  }

  [[nodiscard]] const Results& nearest() const { return nearest_; }
  /// The largest difference from other results, in units of the bound's rounding.
  [[nodiscard]] double roundings(const Results& other, std::size_t kernel) const {
    double worst = 0.0;
    for (std::size_t j = nearest_.begin(kernel); j < nearest_.end(kernel); ++j) {
      const double difference = std::abs(other.values[j] - nearest_.values[j]);
      worst = std::isfinite(difference) ? std::max(worst, difference) : infinite;
    }
    return worst > 0.0 ? worst / (epsilon * condition_[kernel]) : 0.0;
  }

 private:
  Results nearest_;
  Values condition_;
};

/// Kernels that solve equations: their results are as wrong as the mass matrix and the constraints are near to losing
/// rank, which `backward` judges instead.
bool solves(const char* kernel) {
  for (const char* name : {"forward_dynamics", "multipliers", "linearisation", "forward_dynamics_derivatives",
                           "forward_dynamics_second_derivatives", "forward_dynamics_sensitivities", "jets"}) {
    if (std::strcmp(kernel, name) == 0) return true;
  }
  return false;
}

/// How far accelerations and multipliers found without inputs miss M a + h = Aᵀ λ, in roundings of what a rounding of
/// each number in it changes. A backward stable solution misses by some roundings times the number of unknowns,
/// whatever the condition of M.
double backward(Kernels& kernels, const Values& in, const Results& found) {
  Values back = in;
  std::size_t force = found.names.size();
  for (std::size_t k = 0; k < found.names.size(); ++k) {
    const std::string name = found.names[k];
    if (name == "inverse_dynamics") force = k;
    if (name != "forward_dynamics" && name != "multipliers") continue;
    if (found.status[k] > 0) return 0.0;
    std::copy(found.values.begin() + static_cast<std::ptrdiff_t>(found.begin(k)),
              found.values.begin() + static_cast<std::ptrdiff_t>(found.end(k)),
              back.begin() +
                  static_cast<std::ptrdiff_t>(kernels.begin(name == "multipliers" ? multipliers : accelerations)));
  }
  if (force == found.names.size()) return 0.0;
  const Bound bound(kernels, back);
  Results nothing = bound.nearest();
  std::fill(nothing.values.begin(), nothing.values.end(), 0.0);
  return bound.roundings(nothing, force);
}

// Each result is within 8 roundings of the exact one to nearest (docs/accuracy.md), and a directed rounding is up to
// twice as long: 8 + 16.
constexpr double allowed = 24.0;

using Names = std::vector<std::string>;
bool among(const Names& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

int rounding(const Names& excepted) {
  Kernels kernels;
  Complaints complaints;
  std::mt19937_64 random(20261121);
  double worst = 0.0, worst_backward = 0.0;
  const double allowed_backward = allowed * static_cast<double>(kernels.begin(inputs) - kernels.begin(accelerations));
  for (int n = 0; n < 40; ++n) {
    Values in = kernels.draw(random);
    // Without inputs, which inverse_dynamics does not know.
    std::fill(in.begin() + static_cast<std::ptrdiff_t>(kernels.begin(inputs)),
              in.begin() + static_cast<std::ptrdiff_t>(kernels.begin(parameters)), 0.0);
    const Bound bound(kernels, in);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::fesetround(mode);
      const Results& directed = kernels(in);
      std::fesetround(FE_TONEAREST);
      const Results found = directed;
      for (std::size_t k = 0; k < found.names.size(); ++k) {
        if (solves(found.names[k]) || among(excepted, found.names[k])) continue;
        const double off = bound.roundings(found, k);
        worst = std::max(worst, off);
        if (!(off <= allowed)) complaints.add(found.names[k], "directed rounding changes more than the bound", in);
      }
      if (among(excepted, "inverse_dynamics")) continue;
      const double off = backward(kernels, in, found);
      worst_backward = std::max(worst_backward, off);
      if (!(off <= allowed_backward)) complaints.add("forward_dynamics", "misses its equations under directed rounding", in);
    }
  }
  std::printf("directed rounding: at most %.3g roundings of the condition, %g allowed; equations of motion missed by %.3g, "
              "%g allowed\n",
              worst, allowed, worst_backward, allowed_backward);
  return complaints.report();
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

int compare(const char* path, bool bits, const Names& excepted) {
  Kernels kernels;
  Complaints complaints;
  std::vector<Values> states;
  const Values here = record(kernels, &states);
  Values there(here.size() + 1);
  std::FILE* file = std::fopen(path, "rb");
  const std::size_t found = file == nullptr ? 0 : std::fread(there.data(), sizeof(double), there.size(), file);
  if (file != nullptr) std::fclose(file);
  if (found != here.size()) {
    std::printf("%s holds %zu numbers, expected %zu\n", path, found, here.size());
    return 1;
  }
  const std::size_t stride = here.size() / states.size();
  double worst = 0.0;
  for (std::size_t n = 0; n < states.size(); ++n) {
    Results other = kernels(states[n]);
    const std::size_t count = other.names.size();
    std::copy_n(there.begin() + static_cast<std::ptrdiff_t>(n * stride + count), stride - count, other.values.begin());
    if (bits) {
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t from = n * stride + count + other.begin(k), size = other.end(k) - other.begin(k);
        bool same = true;
        for (std::size_t j = from; j < from + size; ++j) {
          same = same && (std::memcmp(&here[j], &there[j], sizeof(double)) == 0 ||
                          (std::isnan(here[j]) && std::isnan(there[j])));
        }
        if (!same) complaints.add(other.names[k], "other bits than in " + std::string(path), states[n]);
      }
    } else if (n < 60) {
      const Bound bound(kernels, states[n]);
      for (std::size_t k = 0; k < count; ++k) {
        if (solves(other.names[k]) || among(excepted, other.names[k])) continue;
        const double off = bound.roundings(other, k);
        worst = std::max(worst, off);
        if (!(off <= allowed)) complaints.add(other.names[k], "further than the bound from " + std::string(path), states[n]);
      }
    }
  }
  if (!bits) std::printf("at most %.3g roundings of the condition, %g allowed\n", worst, allowed);
  return complaints.report();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  const Names more(argv + std::min(argc, what == "near" ? 3 : 2), argv + argc);
  if (what == "random" && argc == 3) return random_states(std::atol(argv[2]));
  if (what == "extremes" && argc == 2) return extremes();
  if (what == "rounding") return rounding(more);
  if (what == "write" && argc == 3) return write(argv[2]);
  if (what == "same" && argc == 3) return compare(argv[2], true, {});
  if (what == "near" && argc >= 3) return compare(argv[2], false, more);
  std::printf("usage: states random NUMBER | extremes | rounding [KERNEL...] | write FILE | same FILE | near FILE [KERNEL...]\n");
  return 2;
}
