// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_contacts.hpp"

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/exact_direction.hpp"

namespace torsor {
namespace {

/// A face of a box or a cylinder by its outward normal, along an axis of the <collision> element.
struct Face {
  std::size_t axis;
  int sign;
};

/// One side of a pair as it is written: "table", "table+z".
struct Side {
  std::string link;
  std::string face_word;  ///< "+z"; empty: all of the link
  std::optional<Face> face;
};

const char* form_name(const UrdfCollision& collision) {
  if (std::holds_alternative<form::Sphere>(*collision.form)) return "sphere";
  return std::holds_alternative<form::Box>(*collision.form) ? "box" : "cylinder";
}

class Pairs {
 public:
  Pairs(const UrdfContactScene& around, const UrdfCollisions& collisions)
      : robot_(around.robot), frames_(around.frames), collisions_(collisions) {}

  void add(const std::string& word) {
    option_ = "--contacts " + word;
    const auto [a, b] = sides(word);
    const auto of_a = collisions_.of_link(a.link, option_), of_b = collisions_.of_link(b.link, option_);
    check_links(a, b);
    if (a.face && b.face) {
      throw UsageError(
          fmt::format("{} names two faces, which meet along edges: name one, and the corners or rims of the other "
                      "link touch it",
                      option_));
    }
    const std::string name = frames_.at(a.link) + "_" + frames_.at(b.link);
    std::optional<FrameHandle> plane;
    if (a.face) plane = face_of(a, of_a, name);
    if (b.face) plane = face_of(b, of_b, name);
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      for (std::size_t j = 0; j < of_b.size(); ++j) {
        std::string numbered = name;
        if (of_a.size() > 1) numbered += fmt::format("_{}", i + 1);
        if (of_b.size() > 1) numbered += fmt::format("_{}", j + 1);
        if (plane) {
          collisions_.touch_plane(numbered, a.face ? *of_b[j] : *of_a[i], *plane);
        } else {
          meet(numbered, *of_a[i], *of_b[j]);
        }
      }
    }
  }

 private:
  Side side(const std::string& word) const {
    if (!frames_.contains(word) && word.size() > 2) {
      const std::string link = word.substr(0, word.size() - 2), face = word.substr(word.size() - 2);
      const std::size_t axis = std::string("xyz").find(face[1]);
      if (axis != std::string::npos && (face[0] == '+' || face[0] == '-')) {
        return {link, face, Face{axis, face[0] == '+' ? 1 : -1}};
      }
    }
    return {word, "", std::nullopt};
  }

  /// Names of links may have colons: that one parts them which leaves two links.
  std::pair<Side, Side> sides(const std::string& word) const {
    std::vector<std::pair<Side, Side>> known, half_known, any;
    for (std::size_t at = word.find(':'); at != std::string::npos; at = word.find(':', at + 1)) {
      std::pair<Side, Side> pair{side(word.substr(0, at)), side(word.substr(at + 1))};
      const int count = (frames_.contains(pair.first.link) ? 1 : 0) + (frames_.contains(pair.second.link) ? 1 : 0);
      (count == 2 ? known : count == 1 ? half_known : any).push_back(std::move(pair));
    }
    if (known.size() > 1) {
      throw UsageError(
          fmt::format("{} can be read as several pairs of links, '{}' and '{}' or '{}' and '{}': rename a link",
                      option_, known[0].first.link, known[0].second.link, known[1].first.link, known[1].second.link));
    }
    if (!known.empty()) return known.front();
    if (!half_known.empty()) return half_known.front();
    if (!any.empty()) return any.front();
    throw UsageError(fmt::format("--contacts takes pairs of links, A:B, e.g. left_finger:ball, and got '{}'", word));
  }

  void check_links(const Side& a, const Side& b) {
    if (a.link == b.link) {
      throw UsageError(fmt::format("{} names the link '{}' twice, and a link does not meet itself: name two links",
                                   option_, a.link));
    }
    for (const UrdfJoint& joint : robot_.joints) {
      const bool shared = (joint.parent.link == a.link && joint.child.link == b.link) ||
                          (joint.parent.link == b.link && joint.child.link == a.link);
      if (!shared || joint.type == UrdfJointType::fixed) continue;
      throw UsageError(fmt::format(
          "the links '{}' and '{}' of {} share the joint '{}', where their shapes may overlap: leave the pair "
          "out, or give the shape that shall meet the other to a link of its own with a fixed joint",
          a.link, b.link, option_, joint.name));
    }
    if (body(a.link) == body(b.link)) {
      throw UsageError(
          fmt::format("the links '{}' and '{}' of {} are one body by fixed joints, and nothing can open or close "
                      "between them: leave the pair out",
                      a.link, b.link, option_));
    }
    const std::pair<std::string, std::string> first(a.link, a.face_word), second(b.link, b.face_word);
    if (seen_.insert(std::minmax(first, second)).second) return;
    throw UsageError(fmt::format("{} is a pair that was named before: name it once", option_));
  }

  /// The first link of those that fixed joints make one body.
  std::string body(std::string link) const {
    for (bool moved = true; moved;) {
      moved = false;
      for (const UrdfJoint& joint : robot_.joints) {
        if (joint.type != UrdfJointType::fixed || joint.child.link != link) continue;
        link = joint.parent.link;
        moved = true;
      }
    }
    return link;
  }

  FrameHandle face_of(const Side& of, const std::vector<const UrdfCollision*>& elements,
                      const std::string& name) const {
    if (elements.size() > 1) {
      throw UsageError(fmt::format(
          "the link '{}' in {} has {} <collision> elements, and {} does not say of which: give the one with that "
          "face to a link of its own with a fixed joint",
          of.link, option_, elements.size(), of.face_word));
    }
    const UrdfCollision& element = *elements.front();
    const auto* box = std::get_if<form::Box>(&*element.form);
    const auto* cylinder = std::get_if<form::Cylinder>(&*element.form);
    if (box == nullptr && (cylinder == nullptr || of.face->axis != 2)) {
      throw UsageError(fmt::format(
          "the <collision> of the link '{}' in {} is a {}, which has no plane face {}: a box has the faces +x, -x, "
          "+y, -y, +z and -z, a cylinder +z and -z",
          of.link, option_, form_name(element), of.face_word));
    }
    const Expression height = (box != nullptr ? box->edges[of.face->axis] : cylinder->length) / 2;
    std::array<Number, 3> normal{};
    normal[of.face->axis] = Number(of.face->sign);
    Triple origin{0, 0, 0};
    origin[of.face->axis] = of.face->sign * height;
    const FrameHandle centre = collisions_.at(name + "_box", collisions_.frame(of.link), *element.placement);
    return collisions_.at(name + "_face", centre, {origin, rotation_to(normal)});
  }

  void meet(const std::string& name, const UrdfCollision& a, const UrdfCollision& b) const {
    const bool round_a = std::holds_alternative<form::Sphere>(*a.form),
               round_b = std::holds_alternative<form::Sphere>(*b.form);
    if (round_a && round_b) return collisions_.touch_each_other(name, a, b);
    const std::string hint = round_b ? fmt::format("{}+z:{}", a.link, b.link) : fmt::format("{}:{}+z", a.link, b.link);
    throw UsageError(fmt::format(
        "the {} of '{}' and the {} of '{}' in {} have no exact contact: write spheres in their place, or name a face "
        "as in --contacts {}, which is then a plane without edges",
        form_name(a), a.link, form_name(b), b.link, option_, hint));
  }

  const UrdfRobot& robot_;
  const std::map<std::string, std::string>& frames_;
  const UrdfCollisions& collisions_;
  std::string option_;
  std::set<std::pair<std::pair<std::string, std::string>, std::pair<std::string, std::string>>> seen_;
};

}  // namespace

void add_contacts(const UrdfContactScene& around, const Surfaces& contacts) {
  if (contacts.named.empty()) return;
  const UrdfCollisions collisions(around, "contacts", contacts);
  Pairs pairs(around, collisions);
  for (const std::string& word : contacts.named) pairs.add(word);
}

}  // namespace torsor
