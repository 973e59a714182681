// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/mechanics/identifier.hpp"
#include "generator/mechanics/scene.hpp"

namespace torsor {

void Scene::gravity(const Triple& acceleration) { content_.gravity = acceleration; }

void Scene::spring(const std::string& name, const Expression& elongation, const Expression& stiffness,
                   const Expression& rest) {
  claim(name, "action");
  content_.actions.emplace_back(ElongationSpring{name, elongation, stiffness, rest});
}
void Scene::damper(const std::string& name, const Expression& elongation, const Expression& damping) {
  claim(name, "action");
  content_.actions.emplace_back(ElongationDamper{name, elongation, damping});
}
void Scene::spring(const std::string& name, const PointReference& a, const PointReference& b,
                   const Expression& stiffness, const Expression& rest) {
  claim(name, "action");
  content_.actions.emplace_back(PointSpring{name, a, b, stiffness, rest});
}
void Scene::damper(const std::string& name, const PointReference& a, const PointReference& b,
                   const Expression& damping) {
  claim(name, "action");
  content_.actions.emplace_back(PointDamper{name, a, b, damping});
}
Expression Scene::motor(const std::string& name, const Expression& displacement) {
  require_identifier(name, "motor");
  claim(name, "input");
  claim(name, "action");
  const SymbolPointer input = add_symbol(name, Unit::parse("J") / displacement.unit(), SymbolKind::input);
  content_.actions.emplace_back(Motor{name, input, displacement});
  return input;
}
void Scene::force(const std::string& name, const FrameReference& body, const PointReference& point,
                  const Triple& components, const FrameReference& axes) {
  claim(name, "action");
  content_.actions.emplace_back(GivenForce{name, body, point, components, axes});
}
void Scene::torque(const std::string& name, const FrameReference& body, const Triple& components,
                   const FrameReference& axes) {
  claim(name, "action");
  content_.actions.emplace_back(GivenTorque{name, body, components, axes});
}

}  // namespace torsor
