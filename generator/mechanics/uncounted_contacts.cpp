// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/uncounted_contacts.hpp"

#include <fmt/ranges.h>

namespace torsor {
namespace {

struct KindOf {
  std::string operator()(const PointOnPlane&) const { return "contact"; }
  std::string operator()(const SphereOnSphere&) const { return "contact"; }
  std::string operator()(const Stop&) const { return "stop"; }
  std::string operator()(const FrictionAlong&) const { return "dry friction"; }
  std::string operator()(const FrictionInJoint&) const { return "dry friction"; }
  std::string operator()(const TurnOnContact&) const { return "resistance to turning"; }
};

}  // namespace

std::string kind_of(const ContactContent& contact) { return std::visit(KindOf(), contact.geometry); }

std::vector<std::string> uncounted_contacts(const SceneContent& scene, const NaturalLanguage& say) {
  bool opens = false;
  std::vector<std::string> frictions, sentences;
  for (const ContactContent& contact : scene.contacts) {
    const std::string kind = kind_of(contact);
    if (kind == "dry friction") frictions.push_back(contact.name);
    opens = opens || kind == "contact" || kind == "stop";
  }
  if (opens) sentences.push_back(say("Every contact is taken to be open here: reactions of closed contacts are not counted."));
  if (!frictions.empty()) {
    sentences.push_back(say("Dry friction is not counted here: {}.", fmt::format("{}", fmt::join(frictions, ", "))));
  }
  return sentences;
}

}  // namespace torsor
