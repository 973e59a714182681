// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/mechanics/scene_content.hpp"

namespace torsor {

/// What equations of the smooth mechanism leave out, in sentences: reactions of contacts and stops, and dry friction, which
/// acts whether anything touches or not.
std::vector<std::string> uncounted_contacts(const SceneContent& scene, const NaturalLanguage& say = {});

/// "contact", "stop", "dry friction", "resistance to turning": what a contact of the scene is.
std::string kind_of(const ContactContent& contact);

}  // namespace torsor
