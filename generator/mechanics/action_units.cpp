// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/action_units.hpp"

#include <fmt/format.h>

#include "torsor/generator/mechanics/require_unit.hpp"

namespace torsor {
namespace {

std::string along(const Expression& elongation) {
  return fmt::format("on {} [{}]", elongation.to_string(), elongation.unit().to_string());
}

struct Units {
  void operator()(const ElongationSpring& s) const {
    require_unit(s.stiffness, units::joule / s.elongation.unit().pow(2),
                 fmt::format("the stiffness of the spring '{}' {}", s.name, along(s.elongation)));
    require_unit(s.rest, s.elongation.unit(), fmt::format("the rest of the spring '{}' {}", s.name, along(s.elongation)));
  }
  void operator()(const ElongationDamper& d) const {
    require_unit(d.damping, units::joule * units::second / d.elongation.unit().pow(2),
                 fmt::format("the damping of the damper '{}' {}", d.name, along(d.elongation)));
  }
  void operator()(const PointSpring& s) const {
    require_unit(s.stiffness, units::newton / units::metre, fmt::format("the stiffness of the spring '{}'", s.name));
    require_unit(s.rest, units::metre, fmt::format("the rest length of the spring '{}'", s.name));
  }
  void operator()(const PointDamper& d) const {
    require_unit(d.damping, units::newton / units::metre_per_second,
                 fmt::format("the damping of the damper '{}'", d.name));
  }
  void operator()(const GivenForce& f) const {
    require_unit(f.components, units::newton, fmt::format("a component of the force '{}'", f.name));
  }
  void operator()(const GivenTorque& t) const {
    require_unit(t.components, units::newton_metre, fmt::format("a component of the torque '{}'", t.name));
  }
  template <class Other>
  void operator()(const Other&) const {}
};

}  // namespace

void require_action_units(const ActionContent& action) { std::visit(Units(), action); }

}  // namespace torsor
