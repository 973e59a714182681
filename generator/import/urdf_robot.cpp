// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_robot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/urdf_deviation.hpp"
#include "torsor/generator/import/urdf_inertial.hpp"
#include "torsor/generator/import/urdf_placement.hpp"
#include "torsor/generator/import/urdf_vocabulary.hpp"

namespace torsor {
namespace {

/// Without blanks around it, in small letters.
std::string plain_word(std::string word) {
  constexpr const char* blanks = " \t\r\n";
  word.erase(0, word.find_first_not_of(blanks));
  word.erase(word.find_last_not_of(blanks) + 1);
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return word;
}

class Reader {
 public:
  Reader(UrdfRobot& robot, const Number& tolerance) : robot_(robot), placements_(robot, tolerance) {}

  void link(const XmlElement& element) {
    UrdfLink link{element.place(), element.text("name"), std::nullopt};
    check(element, "link " + link.name);
    if (const auto inertial = element.child("inertial")) {
      link.inertial = read_inertial(*inertial, link.name, placements_, robot_);
    }
    robot_.links.push_back(std::move(link));
  }

  void joint(const XmlElement& element) {
    UrdfJoint joint;
    joint.place = element.place();
    joint.name = element.text("name");
    const std::string where = "joint " + joint.name;
    check(element, where);
    joint.type = type(element, where);
    joint.parent = reference(element, "parent", where);
    joint.child = reference(element, "child", where);
    if (const auto origin = element.child("origin")) {
      check(*origin, where);
      joint.origin = placements_.placement(*origin, where);
      judge_distance(joint.origin, *origin, where);
    }
    if (joint.moves_by_numbers()) read_motion(element, joint, where);
    if (const auto mimic = element.child("mimic")) read_mimic(*mimic, joint, where);
    robot_.joints.push_back(std::move(joint));
  }

 private:
  void check(const XmlElement& element, const std::string& where) { check_vocabulary(element, where, robot_.notes); }

  /// Links of 0.1 m are written so in mm.
  void judge_distance(const UrdfPlacement& origin, const XmlElement& element, const std::string& where) {
    if (std::none_of(origin.xyz.begin(), origin.xyz.end(), [](const Number& x) { return x.abs() >= Number(100); })) return;
    robot_.notes.add("the origin of a joint is 100 m away or more, which suggests other units than m", where, element.place(),
                     ReadingNotes::Parts::each);
  }

  /// Tells of attributes that are there.
  void report_without_effect(const XmlElement& element, const std::vector<const char*>& attributes,
                           const UrdfJoint& joint, const std::string& why = "") {
    std::vector<std::string> given;
    for (const char* name : attributes) {
      if (element.has(name)) given.push_back(fmt::format("{} {}", name, element.text(name)));
    }
    if (given.empty()) return;
    robot_.without_effect.push_back(
        fmt::format("{}: {} of <{}>{}", joint.name, fmt::join(given, ", "), element.name(), why));
  }

  /// Axis, limits, damping. What other joints say of them, such as a null axis, means nothing.
  void read_motion(const XmlElement& element, UrdfJoint& joint, const std::string& where) {
    if (const auto axis = element.child("axis")) {
      check(*axis, where);
      joint.axis = placements_.direction(*axis, where);
    }
    if (const auto limit = element.child("limit")) read_limit(*limit, joint, where);
    if (const auto safety = element.child("safety_controller")) {
      check(*safety, where);
      report_without_effect(*safety, {"soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity"}, joint);
    }
    if (const auto dynamics = element.child("dynamics")) {
      check(*dynamics, where);
      joint.damping = dynamics->optional_number("damping");
      joint.friction = dynamics->optional_number("friction");
      for (const auto& value : {joint.damping, joint.friction}) {
        if (value && value->sign() < 0)
          dynamics->fail("damping and friction take energy away; they are never negative");
      }
    }
  }

  void read_limit(const XmlElement& limit, UrdfJoint& joint, const std::string& where) {
    check(limit, where);
    report_without_effect(limit, {"acceleration", "deceleration", "jerk"}, joint);
    if (joint.type == UrdfJointType::continuous) {
      report_without_effect(limit, {"lower", "upper"}, joint, ", because the joint is continuous");
    } else {
      joint.lower = limit.optional_bound("lower");
      joint.upper = limit.optional_bound("upper");
      if (limit.has("lower") != limit.has("upper")) take_other_bound(limit, joint, where);
    }
    joint.velocity = limit.optional_bound("velocity");
    joint.effort = limit.optional_bound("effort");
    if (joint.lower && joint.upper && *joint.upper < *joint.lower) {
      robot_.notes.add("lower of <limit> is larger than upper, and both are left out", where, limit.place());
      joint.lower.reset();
      joint.upper.reset();
    }
    // Drives of many turns have bounds beyond a few thousand, or such as 1e16.
    const auto of_degrees = [](const std::optional<Number>& bound) { return bound && bound->abs() > Number(31) && bound->abs() <= Number(720); };
    if (joint.turns() && (of_degrees(joint.lower) || of_degrees(joint.upper))) {
      robot_.notes.add("a limit is beyond five turns, which suggests degrees, and is taken in rad", where, limit.place());
    }
  }

  /// By the format a bound that is not given is 0. Without both the joint is taken as unlimited, as files mean it.
  void take_other_bound(const XmlElement& limit, UrdfJoint& joint, const std::string& where) {
    const char* missing = limit.has("lower") ? "upper" : "lower";
    (limit.has("lower") ? joint.upper : joint.lower) = Number(0);
    robot_.notes.add(fmt::format("<limit> has no {}, which is 0 by the format", missing), where, limit.place(),
                     ReadingNotes::Parts::each);
  }

  void read_mimic(const XmlElement& element, UrdfJoint& joint, const std::string& where) {
    if (joint.type == UrdfJointType::fixed) {
      robot_.notes.add("<mimic> of a fixed joint is void", where, element.place());
      return;
    }
    check(element, where);
    UrdfMimic mimic;
    mimic.place = element.place();
    mimic.joint = element.text("joint");
    if (!joint.has_displacement()) {
      element.fail("only revolute, continuous and prismatic joints can mimic; remove it or change the type of joint");
    }
    if (element.has("multiplier")) mimic.multiplier = element.number("multiplier");
    if (element.has("offset")) {
      mimic.offset = element.number("offset");
      if (joint.turns()) {
        mimic.offset_twelfths =
            placements_.twelfths(element, {mimic.offset, element.text("offset")}, offset_of(joint.name));
      }
    }
    joint.mimic = std::move(mimic);
  }

  UrdfJointType type(const XmlElement& element, const std::string& where) {
    static const std::vector<std::pair<std::string, UrdfJointType>> types{
        {"revolute", UrdfJointType::revolute},   {"continuous", UrdfJointType::continuous},
        {"prismatic", UrdfJointType::prismatic}, {"fixed", UrdfJointType::fixed},
        {"floating", UrdfJointType::floating},   {"planar", UrdfJointType::planar},
        {"spherical", UrdfJointType::spherical}, {"ball", UrdfJointType::spherical}};
    const std::string given = element.text("type");
    const std::string name = plain_word(given);
    std::vector<std::string> known;
    for (const auto& [word, type] : types) {
      known.push_back(word);
      if (word != name) continue;
      if (word != given) robot_.notes.add(fmt::format("type '{}' of <joint> is read as {}", given, word), where, element.place());
      return type;
    }
    element.fail(fmt::format(
        "unknown type of joint '{}'; {}use revolute, continuous, prismatic, fixed, floating, planar or spherical", given,
        did_you_mean(name, known)));
  }

  UrdfLinkReference reference(const XmlElement& joint, const char* which, const std::string& where) {
    const XmlElement element = joint.required_child(which, fmt::format("<{} link=\"...\"/>", which));
    check(element, where);
    return {element.place(), element.text("link")};
  }

  UrdfRobot& robot_;
  UrdfPlacements placements_;
};

/// Two of one kind with the same name.
template <class Part>
void refuse_duplicates(const std::vector<Part>& parts, const char* kind) {
  std::map<std::string, int> lines;
  for (const Part& part : parts) {
    const auto [first, added] = lines.emplace(part.name, part.place.line);
    if (!added) {
      part.place.fail(fmt::format("another {} at line {} has the same name; give each its own", kind, first->second));
    }
  }
}

/// The robot's name, that of the file where it has none.
std::string name_of_robot(const XmlElement& root, const std::string& file, ReadingNotes& notes) {
  const std::string given = root.has("name") ? plain_word(root.value("name")) : "";
  if (!given.empty()) return root.text("name");
  const std::string base = file.substr(file.find_last_of('/') + 1);
  const std::string stem = base.substr(0, base.find('.'));
  notes.add(fmt::format("<robot> has no name and takes that of the file, '{}'", stem), "", root.place());
  return stem;
}

}  // namespace

bool UrdfInertial::is_zero() const {
  const auto zero = [](const Number& n) { return n.is_zero(); };
  return mass.is_zero() && std::all_of(inertia.begin(), inertia.end(),
                                       [&](const auto& row) { return std::all_of(row.begin(), row.end(), zero); });
}

void UrdfChanges::add(const std::string& change, const std::string& where) {
  const auto same = [&change](const auto& entry) { return entry.first == change; };
  const auto found = std::find_if(changes_.begin(), changes_.end(), same);
  if (found == changes_.end()) {
    changes_.push_back({change, {where}});
  } else if (found->second.back() != where) {
    found->second.push_back(where);
  }
}

std::vector<std::string> UrdfChanges::lines() const {
  std::vector<std::string> lines;
  for (const auto& [change, places] : changes_) lines.push_back(fmt::format("{}: {}", change, fmt::join(places, ", ")));
  return lines;
}

namespace {

/// Angles within the tolerance are made exact, each by itself.
UrdfRobot robot_of(const XmlElement& root, const std::string& file, const Number& angle_tolerance) {
  if (root.name() != "robot") {
    if (looks_like(root.name(), "robot")) root.fail("the root element of a URDF file is <robot>; did you mean that?");
    root.fail("files that are read here have the root element <robot> (URDF, xacro) or <mujoco> (MJCF); convert others, as SDF, to "
              "one of these first");
  }
  UrdfRobot robot;
  robot.file = file;
  check_vocabulary(root, "", robot.notes);
  robot.name = name_of_robot(root, file, robot.notes);
  Reader reader(robot, angle_tolerance);
  for (const XmlElement& link : root.children("link")) reader.link(link);
  for (const XmlElement& joint : root.children("joint")) reader.joint(joint);
  if (robot.links.empty()) root.fail("has no <link>; a robot has at least one");
  refuse_duplicates(robot.links, "link");
  refuse_duplicates(robot.joints, "joint");
  return robot;
}

/// Two digits, and not less than the number.
std::string rounded_up(double size) {
  const double unit = std::pow(10, std::floor(std::log10(size)) - 1);
  return fmt::format("{:.1e}", std::ceil(size / unit) * unit);
}

}  // namespace

UrdfRobot read_robot(std::string_view text, const std::string& file, const Number& angle_tolerance,
                     const std::vector<XmlLine>& lines) {
  const XmlFile xml(text, file, lines);
  const XmlElement root = xml.root();
  const double allowed = angle_tolerance.to_double();
  const double all = std::numeric_limits<double>::infinity();
  UrdfRobot robot = robot_of(root, file, angle_tolerance);
  const UrdfDeviation together = largest_deviation(robot, all);
  UrdfDeviation kept = together;
  Number each = angle_tolerance;
  for (int attempt = 0; kept.sum > allowed; ++attempt) {
    constexpr int attempts = 8;  // directions may need a second one
    each = attempt < attempts ? smaller_tolerance(robot, each, allowed) : Number();
    robot = robot_of(root, file, each);
    kept = largest_deviation(robot, all);
  }
  robot.visuals = read_visuals(root, angle_tolerance);
  robot.collisions = read_collisions(root, angle_tolerance);
  constexpr double of_doubles = 1e-15;  // a few angles with all digits of a double
  if (kept.sum > of_doubles) {
    robot.exact_together =
        fmt::format("from the root to link {} they add up to {} rad, to no other link to more", kept.link, rounded_up(kept.sum));
  }
  if (together.sum > allowed) {
    robot.almost.push_back(fmt::format("all within --angle-tolerance would add up to {} rad from the root to link {}, beyond it; "
                                       "--angle-tolerance {} takes them all",
                                       rounded_up(together.sum), together.link, rounded_up(together.sum)));
  }
  return robot;
}

}  // namespace torsor
