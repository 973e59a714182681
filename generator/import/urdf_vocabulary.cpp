// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_vocabulary.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"

namespace torsor {
namespace {

using Words = std::vector<std::string>;

/// What one element may hold. What is known and does not act is passed over without a word: pictures, shapes of contact,
/// what the reader itself tells of.
struct Vocabulary {
  Words attributes, other_attributes, elements, other_elements;
};

const std::map<std::string, Vocabulary>& vocabularies() {
  static const std::map<std::string, Vocabulary> all{
      {"robot", {{"name"}, {"version"}, {"link", "joint"}, {"material"}}},
      {"link", {{"name"}, {"type"}, {"inertial"}, {"visual", "collision"}}},
      {"inertial", {{}, {}, {"origin", "mass", "inertia"}, {}}},
      {"origin", {{"xyz", "rpy", "quat_xyzw"}, {}, {}, {}}},
      {"mass", {{"value"}, {}, {}, {}}},
      {"inertia", {{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}, {"iyx", "izx", "izy"}, {}, {}}},
      {"joint",
       {{"name", "type"},
        {},
        {"parent", "child", "origin", "axis", "limit", "dynamics", "mimic"},
        {"safety_controller", "calibration"}}},
      {"parent", {{"link"}, {}, {}, {}}},
      {"child", {{"link"}, {}, {}, {}}},
      {"axis", {{"xyz"}, {}, {}, {}}},
      {"limit", {{"lower", "upper", "velocity", "effort"}, {"acceleration", "deceleration", "jerk"}, {}, {}}},
      {"dynamics", {{"damping", "friction"}, {}, {}, {}}},
      {"mimic", {{"joint", "multiplier", "offset"}, {}, {}, {}}},
      {"safety_controller", {{}, {"soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity"}, {}, {}}}};
  return all;
}

/// Where what decides the motion belongs, by its name; names that mean several things are left out.
const std::map<std::string, std::string>& places_of_elements() {
  static const std::map<std::string, std::string> places{
      {"link", "robot"},      {"joint", "robot"},    {"inertial", "link"}, {"mass", "inertial"}, {"inertia", "inertial"},
      {"parent", "joint"},    {"child", "joint"},    {"axis", "joint"},    {"mimic", "joint"},   {"dynamics", "joint"}};
  return places;
}

const std::map<std::string, std::string>& places_of_attributes() {
  static const std::map<std::string, std::string> places{
      {"xyz", "origin"},      {"rpy", "origin"},     {"quat_xyzw", "origin"}, {"ixx", "inertia"},     {"ixy", "inertia"},
      {"ixz", "inertia"},     {"iyy", "inertia"},    {"iyz", "inertia"},      {"izz", "inertia"},     {"damping", "dynamics"},
      {"friction", "dynamics"}, {"multiplier", "mimic"}, {"offset", "mimic"}};
  return places;
}

bool contains(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Decimals of value zero, one or more: of zeros, signs, points and spaces, with exponents.
bool all_zero(const std::string& text) {
  std::istringstream words(text);
  std::string word;
  bool any = false;
  while (words >> word) {
    const std::string digits = word.substr(0, word.find_first_of("eE"));
    if (digits.find('0') == std::string::npos || digits.find_first_not_of("+-.0") != std::string::npos) return false;
    any = true;
  }
  return any;
}

class Check {
 public:
  Check(const XmlElement& element, const std::string& part, ReadingNotes& notes)
      : element_(element), name_(element.name()), part_(part), notes_(notes), known_(vocabularies().at(name_)) {}

  void run() const {
    for (const std::string& attribute : element_.attributes()) look_at_attribute(attribute);
    for (const XmlElement& child : element_.elements()) look_at_element(child);
    if (element_.holds_text()) note(fmt::format("text inside <{}> is not read", name_));
  }

 private:
  void note(const std::string& kind) const { notes_.add(kind, part_, element_.place()); }

  void look_at_attribute(const std::string& attribute) const {
    if (contains(known_.attributes, attribute) || contains(known_.other_attributes, attribute)) return;
    if (attribute == "xmlns" || attribute.starts_with("xmlns:") || attribute.starts_with("xml:")) return;
    if (const std::string meant = did_you_mean(attribute, known_.attributes); !meant.empty()) {
      element_.fail(fmt::format("has an attribute {}: {}the attributes that act are {}", attribute, meant,
                                fmt::join(known_.attributes, ", ")));
    }
    const auto place = places_of_elements().find(attribute);
    if (place != places_of_elements().end() && attribute != "joint" && attribute != "link") {  // those name parts elsewhere
      element_.fail(fmt::format("has an attribute {}, which would be ignored; write it as <{}> inside <{}>", attribute,
                                attribute, place->second));
    }
    const auto elsewhere = places_of_attributes().find(attribute);
    // Exporters write <axis rpy="0 0 0">, which says nothing wherever it stands; a multiplier of zero would say much.
    const bool nothing = attribute != "multiplier" && all_zero(element_.value(attribute.c_str()));
    if (elsewhere != places_of_attributes().end() && !nothing) {
      element_.fail(fmt::format("has an attribute {}, which belongs to <{}> and would be ignored here; move it there",
                                attribute, elsewhere->second));
    }
    note(fmt::format("attribute {} of <{}> is not read", attribute, name_));
  }

  void look_at_element(const XmlElement& child) const {
    const std::string name = child.name();
    if (contains(known_.elements, name)) return;
    if (contains(known_.other_elements, name)) return refuse_hidden(child);
    if (name.starts_with("xacro:")) {
      child.fail("is xacro, which is expanded first; run xacro on the file, or name the file .xacro");
    }
    if (const std::size_t colon = name.find(':'); colon != std::string::npos) {
      const std::string local = name.substr(colon + 1);
      if (contains(known_.elements, local)) {
        child.fail(fmt::format("is read by another program only, and the motion depends on it; write <{}>, or remove it",
                               local));
      }
    }
    if (const std::string meant = did_you_mean(name, known_.elements); !meant.empty()) {
      child.fail(fmt::format("stands in <{}>, which holds no such element: {}those that act are {}", name_, meant,
                             fmt::join(known_.elements, ", ")));
    }
    refuse_misplaced(child);
    notes_.add(fmt::format("<{}> in <{}> is not read", name, name_), part_, child.place());
  }

  void refuse_misplaced(const XmlElement& child) const {
    const auto elsewhere = places_of_elements().find(child.name());
    if (elsewhere == places_of_elements().end()) return;
    child.fail(fmt::format("belongs to <{}> and would be ignored in <{}>; move it there", elsewhere->second,
                           child.parent_name()));
  }

  /// Pictures and shapes of contact are not read, but no inertia may get lost in them.
  void refuse_hidden(const XmlElement& shape) const {
    for (const XmlElement& inside : shape.elements()) {
      const std::string name = inside.name();
      if (name == "inertial" || name == "inertia" || name == "joint" || name == "link") refuse_misplaced(inside);
    }
  }

  const XmlElement& element_;
  std::string name_;
  const std::string& part_;
  ReadingNotes& notes_;
  const Vocabulary& known_;
};

}  // namespace

void check_vocabulary(const XmlElement& element, const std::string& part, ReadingNotes& notes) {
  Check(element, part, notes).run();
}

}  // namespace torsor
