// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// Whether results of kernels are right to rounding: found numbers against reference values of as many digits or more.
/// It includes nothing of the project, so that programs that link nothing but a generated header can use it.
namespace torsor::testing_rounding {

/// What one operation may be off by, relative to its result.
template <class Float>
inline constexpr double unit_of = std::numeric_limits<Float>::epsilon() / 2;

namespace detail {

/// The same number in the reference's type, which has its digits.
template <class Reference, class Found>
Reference exactly(const Found& x) {
  if constexpr (std::is_floating_point_v<Found> && requires { Reference::from_double(1.0); }) {
    return Reference::from_double(static_cast<double>(x));
  } else {
    return static_cast<Reference>(x);
  }
}
template <class Number>
double in_double(const Number& x) {
  if constexpr (requires { x.to_double(); }) {
    return x.to_double();
  } else {
    return static_cast<double>(x);
  }
}
template <class Reference>
double norm(const std::vector<Reference>& x) {
  using std::sqrt;
  Reference square(0);
  for (const Reference& each : x) square += each * each;
  return in_double(sqrt(square));
}

}  // namespace detail

/// An error in roundings of numbers of some size. It is 0 where nothing is off, and infinite where something is and
/// there is nothing to measure it by, or where one of them is no number.
inline double roundings(double error, double size, double unit) {
  if (error == 0 && size >= 0) return 0;
  const double ratio = std::abs(error) / (unit * size);
  return ratio >= 0 ? ratio : std::numeric_limits<double>::infinity();
}
/// That of one result: |found − truth|, taken in the digits of the reference.
template <class Found, class Reference>
double roundings(const Found& found, const Reference& truth, double size, double unit) {
  return roundings(detail::in_double(detail::exactly<Reference>(found) - truth), size, unit);
}

/// A result that is further off than it may be, in roundings of its size.
struct Excess {
  std::string entry;
  double off, allowed;
};

/// Compares results, entry by entry, and keeps those that exceed their bound.
class RightToRounding {
 public:
  /// Unit roundoff of what was found: `unit_of<double>`, or a power of ten for numbers of many digits.
  explicit RightToRounding(double unit) : unit_(unit) {}

  /// One result. It may be off by `allowed` roundings of numbers of this size: that of the terms it is a sum of, or its
  /// own times the condition of what was solved.
  template <class Found, class Reference>
  void entry(std::string_view name, const Found& found, const Reference& truth, double size, double allowed) {
    add(name, roundings(found, truth, size, unit_), allowed);
  }
  /// The same with the reference's own size.
  template <class Found, class Reference>
  void entry(std::string_view name, const Found& found, const Reference& truth, double allowed) {
    entry(name, found, truth, std::abs(detail::in_double(truth)), allowed);
  }
  /// Results of one unit that form a vector: Euclid's norm of the difference against that of the reference.
  template <class Found, class Reference>
  void vector(std::string_view name, const std::vector<Found>& found, const std::vector<Reference>& truth,
              double allowed) {
    if (found.size() != truth.size()) return add(name, std::numeric_limits<double>::infinity(), allowed);
    std::vector<Reference> difference;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      difference.push_back(detail::exactly<Reference>(found[i]) - truth[i]);
    }
    add(name, roundings(detail::norm(difference), detail::norm(truth), unit_), allowed);
  }

  [[nodiscard]] const std::vector<Excess>& excesses() const { return excesses_; }
  /// How many entries were compared: a test that compares none has shown nothing.
  [[nodiscard]] int compared() const { return compared_; }
  /// The largest part of its bound that an entry takes.
  [[nodiscard]] double worst() const { return worst_; }
  explicit operator bool() const { return excesses_.empty() && compared_ > 0; }

  friend std::ostream& operator<<(std::ostream& out, const RightToRounding& all) {
    if (all.compared_ == 0) out << "nothing was compared";
    for (const Excess& each : all.excesses_) {
      out << each.entry << " is off by " << each.off << " roundings, allowed are " << each.allowed << '\n';
    }
    return out;
  }

 private:
  void add(std::string_view name, double off, double allowed) {
    ++compared_;
    if (!(off / allowed <= worst_)) worst_ = off / allowed;
    if (!(off <= allowed)) excesses_.push_back({std::string(name), off, allowed});
  }

  double unit_, worst_ = 0;
  int compared_ = 0;
  std::vector<Excess> excesses_;
};

}  // namespace torsor::testing_rounding
