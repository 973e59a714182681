// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/kernels/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "torsor/generator/verification/worst.hpp"

namespace kernels {
namespace {

double difference(const std::vector<double>& numbers, const std::vector<double>& expected) {
  double greatest = 0, difference = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    greatest = std::max(greatest, std::abs(expected[i]));
    const double each = std::abs(numbers.at(i) - expected[i]);
    if (torsor::is_worse(each, difference)) difference = each;
  }
  return difference / greatest;
}

}  // namespace

std::vector<double> differences(const std::vector<Way>& ways, Quantity quantity, std::size_t states) {
  std::vector<double> worst(ways.size());
  for (std::size_t k = 0; k < states; ++k) {
    std::vector<double> expected;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      ways[i].run(k, k + 1);
      const std::vector<double> numbers = ways[i].result();
      if (i == 0) expected = numbers;
      const double each = difference(numbers, expected);
      if (torsor::is_worse(each, worst[i])) worst[i] = each;
      if (ways[i].scalar == "double" && !(each <= 1e-9)) {
        throw std::runtime_error(fmt::format("{} of {} differs from {} by {:.1e} in state {}", name_of(quantity),
                                             ways[i].label(), ways[0].label(), each, k));
      }
    }
  }
  return worst;
}

}  // namespace kernels
