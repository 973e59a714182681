// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_scale.hpp"

#include <algorithm>
#include <cmath>

namespace torsor::runtime {

double unit_of_row(double own) noexcept {
  if (!(own > 0) || !std::isfinite(own)) return 1;
  int exponent = 0;
  std::frexp(own, &exponent);  // own is from 2^(exponent - 1) to 2^exponent
  return std::ldexp(1.0, static_cast<int>(std::floor(exponent / 2.0)));
}

double unit_of_row(double own, double normal) noexcept { return unit_of_row(own <= 1e-20 * normal ? normal : own); }

ContactScale::ContactScale(const ContactProblem& problem) noexcept {
  const int n = problem.rows();
  units_.resize(n);
  for (int i = 0; i < n; ++i) group_[as(i)] = i;
  for (int i = 0; i < problem.count; ++i) {
    const int first = problem.first_row(i);
    const double normal = problem.law(i).normal ? problem.W(first, first) : 0;
    for (int row = first; row < first + problem.law(i).rows(); ++row) units_(row) = unit_of_row(problem.W(row, row), normal);
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) {
      if (problem.W(i, j) != 0 || problem.W(j, i) != 0) join(i, j);
    }
  }
  // What presses a contact acts on its friction.
  for (int i = 0; i < problem.count; ++i) {
    const int first = problem.first_row(i);
    for (int k = 1; k < problem.law(i).rows(); ++k) join(first + k, first);
    if (const std::optional<int> pressing = problem.pressing_row(i)) join(first, *pressing);
    for (int k = 0, own = problem.bearing_row(i); k < problem.law(i).bearing; ++k, ++own) {
      for (int j = 0; j < n; ++j) {
        if (problem.S(own, j) != 0) join(first, j);
      }
    }
  }
}

void ContactScale::join(int row, int other) noexcept {
  const int from = group_[as(row)], to = group_[as(other)];
  if (from == to) return;
  for (int i = 0; i < static_cast<int>(units_.size()); ++i) {
    if (group_[as(i)] == from) group_[as(i)] = to;
  }
}

ContactVector ContactScale::largest(const ContactVector& sizes) const noexcept {
  ContactVector of_group = ContactVector::Zero(sizes.size()), all(sizes.size());
  for (Eigen::Index i = 0; i < sizes.size(); ++i) {
    double& most = of_group(group(i));
    if (!(std::abs(sizes(i)) <= most)) most = std::isnan(sizes(i)) ? INFINITY : std::abs(sizes(i));
  }
  for (Eigen::Index i = 0; i < sizes.size(); ++i) all(i) = of_group(group(i));
  return all;
}

ContactVector ContactScale::sums(const ContactVector& parts) const noexcept {
  ContactVector of_group = ContactVector::Zero(parts.size()), all(parts.size());
  for (Eigen::Index i = 0; i < parts.size(); ++i) of_group(group(i)) += parts(i);
  for (Eigen::Index i = 0; i < parts.size(); ++i) all(i) = of_group(group(i));
  return all;
}

// Parts of the largest one: that may be next to nothing, which over sizes would be zero.
double size_along(const ContactVector& sizes, const ContactVector& all, int first, int count) noexcept {
  double length = 0, part = 0, largest = 0;
  const double most = count > 0 ? all.segment(first, count).cwiseAbs().maxCoeff() : 0;
  for (int k = first; k < first + count; ++k) {
    largest = std::max(largest, sizes(k));
    if (all(k) == 0) continue;
    length = std::hypot(length, all(k) / most);
    part = std::hypot(part, all(k) / most / sizes(k));
  }
  return length > 0 ? length / part : largest;
}

double largest_part(const ContactVector& parts, const ContactVector& wholes) noexcept {
  double largest = 0;
  for (Eigen::Index i = 0; i < parts.size(); ++i) {
    if (parts(i) == 0) continue;
    const double part = std::abs(parts(i)) / wholes(i);
    if (std::isnan(part)) return INFINITY;
    largest = std::max(largest, part);
  }
  return largest;
}

}  // namespace torsor::runtime
