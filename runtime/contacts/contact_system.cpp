// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_system.hpp"

#include <stdexcept>
#include <string>

namespace torsor::runtime {

ContactReading::ContactReading(const ContactSizes& sizes, int rows, int bearings)
    : M(sizes.velocities, sizes.velocities), F(sizes.velocities),
      gap(static_cast<std::size_t>(sizes.contacts)), J(rows, sizes.velocities), w(rows), drift(rows),
      A(sizes.constraints, sizes.velocities), gamma(sizes.constraints), value(sizes.constraints),
      rate(sizes.constraints), B(bearings, sizes.velocities), C(bearings, rows), D(bearings, sizes.constraints), R0(bearings) {}

ContactMechanism::ContactMechanism(const ContactSizes& sizes) : sizes_(sizes) {
  if (sizes.contacts <= most_contacts) return;
  throw std::length_error("a mechanism has " + std::to_string(sizes.contacts) + " contacts and may have up to " +
                          std::to_string(most_contacts) + ": leave out some, or move bodies apart as grains");
}

}  // namespace torsor::runtime
