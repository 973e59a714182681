// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The kernels of one generated header, linked in by kernels_by_number.hpp, as one function from numbers to numbers.
#include <cmath>
#include <cstdio>
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

namespace worst_states {

using Values = std::vector<double>;
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
inline constexpr int parts = 6;
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

  [[nodiscard]] std::size_t constraints() const { return begin(inputs) - begin(multipliers); }
  /// Accelerations and multipliers.
  [[nodiscard]] std::size_t unknowns() const { return begin(inputs) - begin(accelerations); }

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

}  // namespace worst_states
