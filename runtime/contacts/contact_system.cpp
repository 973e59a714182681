// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace torsor::runtime {

ContactReading::ContactReading(const ContactSizes& sizes, int rows, int bearings)
    : M(sizes.velocities, sizes.velocities), F(sizes.velocities),
      gap(static_cast<std::size_t>(sizes.contacts)), J(rows, sizes.velocities), w(rows), drift(rows),
      A(sizes.constraints, sizes.velocities), gamma(sizes.constraints), value(sizes.constraints),
      rate(sizes.constraints), B(bearings, sizes.velocities), C(bearings, rows), D(bearings, sizes.constraints), R0(bearings) {}

double rounding_of_position(const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& rates,
                            std::span<const double> y, const ContactSizes& sizes) noexcept {
  const bool each = sizes.coordinates == sizes.velocities;  // coordinate j moves with velocity j
  double sum = 0, largest = 0;
  for (std::size_t j = 0; j < static_cast<std::size_t>(sizes.coordinates); ++j) largest = std::max(largest, std::abs(y[j]));
  for (int j = 0; j < sizes.velocities; ++j) sum += std::abs(rates(j)) * (each ? std::abs(y[static_cast<std::size_t>(j)]) : largest);
  return std::numeric_limits<double>::epsilon() * sum;
}

ContactMechanism::ContactMechanism(const ContactSizes& sizes) : sizes_(sizes) {
  if (sizes.contacts <= most_contacts) return;
  throw std::length_error("a mechanism has " + std::to_string(sizes.contacts) + " contacts and may have up to " +
                          std::to_string(most_contacts) + ": leave out some, or move bodies apart as grains");
}

}  // namespace torsor::runtime
