// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "torsor/runtime/contacts/contact_system.hpp"

namespace torsor::runtime {

/// What rounding of its constant lengths makes of a gap, as of 0.32 + x - 0.32 where x is zero: no coordinate shows their size,
/// so it is measured. Beside a state whose coordinates are next to nothing, what the gap changes by two small displacements is
/// compared with its rows J: what is left is rounding.
class GapRounding {
 public:
  explicit GapRounding(const ContactMechanism& mechanism);

  /// Reads the mechanism at time t some thirteen times, without allocation. Zero where the gap cannot be read there.
  void measure(double t, std::span<const double> y);
  /// The same beside what was measured before, of which the larger counts: lengths may have grown since, as places that a law of
  /// time moves away. Whether any is more than twice as large.
  bool measure_anew(double t, std::span<const double> y);
  /// What rounding makes of a gap whose rate is this row times the velocities: of its lengths, or of the coordinates.
  [[nodiscard]] double operator()(int contact, const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& rates,
                                  std::span<const double> y) const noexcept {
    return std::max(rounding_of_position(rates, y, mechanism_.sizes()), rounding_[static_cast<std::size_t>(contact)]);
  }

 private:
  /// The gaps at a displacement of h times the rates; false where they cannot be read.
  bool displaced(double t, double h, std::vector<double>& gaps);

  const ContactMechanism& mechanism_;
  std::vector<int> first_row_;  ///< of each contact, and the number of all; -1 where it has no normal
  ContactReading here_, there_;
  std::vector<double> y_, moved_, rates_, ahead_, behind_, rounding_, before_;
  std::vector<bool> follows_;
};

}  // namespace torsor::runtime
