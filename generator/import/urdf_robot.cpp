// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/import/urdf_robot.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/expression/error.hpp"

namespace torsor {
namespace {

/// Beyond this [rad] an angle was not meant to be a multiple of π/12.
const Number& suspicious() {
  static const Number angle = Number::rational(1, 10000);
  return angle;
}

/// "0", "pi/2", "-5 pi/12": k π/12.
std::string twelfths_text(const Number& k) {
  if (k.is_zero()) return "0";
  const Number part = k / Number(12);
  const std::string exact = part.abs().to_string();  // "1/2", "5/12", "1"
  const std::size_t slash = exact.find('/');
  const std::string numerator = exact.substr(0, slash);
  return (k.sign() < 0 ? "-" : "") + (numerator == "1" ? std::string() : numerator + " ") + "pi" +
         (slash == std::string::npos ? "" : exact.substr(slash));
}

class Reader {
 public:
  Reader(UrdfRobot& robot, const Number& tolerance) : robot_(robot), tolerance_(tolerance) {}

  void link(const XmlElement& element) {
    element.require_only({"name", "type"});
    UrdfLink link{element.place(), element.text("name"), std::nullopt};
    if (const auto inertial = element.child("inertial")) link.inertial = read_inertial(*inertial, "link " + link.name);
    robot_.links.push_back(std::move(link));
  }

  void joint(const XmlElement& element) {
    element.require_only({"name", "type"});
    UrdfJoint joint;
    joint.place = element.place();
    joint.name = element.text("name");
    joint.type = type(element);
    joint.parent = reference(element, "parent");
    joint.child = reference(element, "child");
    const std::string where = "joint " + joint.name;
    if (const auto origin = element.child("origin")) joint.origin = placement(*origin, where);
    if (joint.moves_by_numbers()) read_motion(element, joint, where);
    if (const auto mimic = element.child("mimic")) joint.mimic = read_mimic(*mimic, joint, where);
    robot_.joints.push_back(std::move(joint));
  }

 private:
  /// Tells of attributes that are there.
  void tell_without_effect(const XmlElement& element, const std::vector<const char*>& attributes,
                           const UrdfJoint& joint, const std::string& why = "") {
    std::vector<std::string> given;
    for (const char* name : attributes) {
      if (element.optional_number(name).has_value()) given.push_back(fmt::format("{} {}", name, element.text(name)));
    }
    if (given.empty()) return;
    robot_.without_effect.push_back(
        fmt::format("{}: {} of <{}>{}", joint.name, fmt::join(given, ", "), element.name(), why));
  }

  /// Axis, limits, damping. What other joints say of them, such as a null axis, means nothing.
  void read_motion(const XmlElement& element, UrdfJoint& joint, const std::string& where) {
    if (const auto axis = element.child("axis")) joint.axis = direction(*axis, where);
    if (const auto limit = element.child("limit")) {
      limit->require_only({"lower", "upper", "velocity", "effort", "acceleration", "deceleration", "jerk"});
      tell_without_effect(*limit, {"acceleration", "deceleration", "jerk"}, joint);
      if (joint.type == UrdfJointType::continuous) {
        tell_without_effect(*limit, {"lower", "upper"}, joint, ", because the joint is continuous");
      } else {
        joint.lower = limit->optional_number("lower");
        joint.upper = limit->optional_number("upper");
      }
      joint.velocity = limit->optional_number("velocity");
      joint.effort = limit->optional_number("effort");
      if (joint.lower && joint.upper && *joint.upper < *joint.lower) {
        limit->fail("lower is larger than upper; exchange them");
      }
    }
    if (const auto safety = element.child("safety_controller")) {
      safety->require_only({"soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity"});
      tell_without_effect(*safety, {"soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity"}, joint);
    }
    if (const auto dynamics = element.child("dynamics")) {
      dynamics->require_only({"damping", "friction"});
      joint.damping = dynamics->optional_number("damping");
      joint.friction = dynamics->optional_number("friction");
      for (const auto& value : {joint.damping, joint.friction}) {
        if (value && value->sign() < 0)
          dynamics->fail("damping and friction take energy away; they are never negative");
      }
    }
  }

  /// Tells what an angle was taken for.
  void tell(const XmlNumber& angle, const std::optional<Number>& twelfths, const std::string& where) {
    if (angle.value.is_zero()) return;
    if (twelfths) return robot_.changes.add(angle.text + " is " + twelfths_text(*twelfths), where);
    if (const auto near = twelfths_of_pi(angle.value, suspicious())) {
      robot_.almost.push_back(
          fmt::format("{} in {} is near {} but beyond the tolerance: sines and cosines that would "
                      "vanish do not; a larger --angle-tolerance takes it as that",
                      angle.text, where, twelfths_text(*near)));
    }
  }

  UrdfPlacement placement(const XmlElement& origin, const std::string& where) {
    origin.require_only({"xyz", "rpy"});
    UrdfPlacement place;
    if (origin.has("xyz")) {
      const auto xyz = origin.three_numbers("xyz");
      for (std::size_t i = 0; i < 3; ++i) place.xyz[i] = xyz[i].value;
    }
    if (!origin.has("rpy")) return place;
    const auto rpy = origin.three_numbers("rpy");
    for (std::size_t i = 0; i < 3; ++i) {
      require_angle(origin, rpy[i].value);
      const ExactAngle angle = exact_angle(rpy[i].value, tolerance_);
      tell(rpy[i], angle.twelfths, where + " (rpy)");
      place.rotation = rotation_about(static_cast<int>(i), angle) * place.rotation;
    }
    return place;
  }

  std::array<Number, 3> direction(const XmlElement& axis, const std::string& where) {
    axis.require_only({"xyz"});
    const auto xyz = axis.three_numbers("xyz");
    const std::array<Number, 3> given{xyz[0].value, xyz[1].value, xyz[2].value};
    if (std::all_of(given.begin(), given.end(), [](const Number& n) { return n.is_zero(); })) {
      axis.fail("xyz is the null vector; give the direction of the joint, e.g. xyz=\"0 0 1\"");
    }
    const ExactDirection exact = exact_direction(given, tolerance_);
    if (exact.changed) {
      const auto& n = exact.components;
      robot_.changes.add(fmt::format("{} {} {} is ({}, {}, {})", xyz[0].text, xyz[1].text, xyz[2].text,
                                     n[0].to_string(), n[1].to_string(), n[2].to_string()),
                         where + " (axis)");
    }
    return exact.components;
  }

  UrdfInertial read_inertial(const XmlElement& element, const std::string& where) {
    UrdfInertial inertial;
    inertial.place = element.place();
    element.require_only({});
    UrdfPlacement origin;
    if (const auto given = element.child("origin")) origin = placement(*given, where);
    inertial.center = origin.xyz;
    const XmlElement mass = element.required_child("mass", "<mass value=\"...\"/>");
    mass.require_only({"value"});
    inertial.mass = mass.number("value");
    const XmlElement inertia = element.required_child(
        "inertia", "<inertia ixx=\"...\" iyy=\"...\" izz=\"...\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>");
    inertia.require_only({"ixx", "ixy", "ixz", "iyy", "iyz", "izz"});
    const Number xx = inertia.number("ixx"), yy = inertia.number("iyy"), zz = inertia.number("izz");
    const Number xy = inertia.number("ixy"), xz = inertia.number("ixz"), yz = inertia.number("iyz");
    const std::array<std::array<Number, 3>, 3> given{{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
    const Rotation& r = origin.rotation;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        Number& sum = inertial.inertia[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        for (int k = 0; k < 3; ++k) {
          for (int l = 0; l < 3; ++l) {
            sum += r(i, k) * given[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)] * r(j, l);
          }
        }
      }
    }
    return inertial;
  }

  UrdfMimic read_mimic(const XmlElement& element, const UrdfJoint& joint, const std::string& where) {
    element.require_only({"joint", "multiplier", "offset"});
    UrdfMimic mimic;
    mimic.place = element.place();
    mimic.joint = element.text("joint");
    if (!joint.turns() && !joint.slides()) {
      element.fail("only revolute, continuous and prismatic joints can mimic; remove it or change the type of joint");
    }
    if (element.has("multiplier")) mimic.multiplier = element.number("multiplier");
    if (!element.has("offset")) return mimic;
    mimic.offset = element.number("offset");
    if (joint.turns()) {
      require_angle(element, mimic.offset);
      mimic.offset_twelfths = twelfths_of_pi(mimic.offset, tolerance_);
      tell({mimic.offset, element.text("offset")}, mimic.offset_twelfths, where + " (offset)");
    }
    return mimic;
  }

  static void require_angle(const XmlElement& element, const Number& angle) {
    if (angle.abs() > Number(1000000)) element.fail("an angle is beyond 10^6; give angles in radians");
  }

  static UrdfJointType type(const XmlElement& element) {
    static const std::map<std::string, UrdfJointType> types{
        {"revolute", UrdfJointType::revolute},   {"continuous", UrdfJointType::continuous},
        {"prismatic", UrdfJointType::prismatic}, {"fixed", UrdfJointType::fixed},
        {"floating", UrdfJointType::floating},   {"planar", UrdfJointType::planar}};
    const std::string name = element.text("type");
    const auto found = types.find(name);
    if (found == types.end()) {
      element.fail(fmt::format(
          "unknown type of joint '{}'; use revolute, continuous, prismatic, fixed, floating or planar", name));
    }
    return found->second;
  }

  static UrdfLinkReference reference(const XmlElement& joint, const char* which) {
    const XmlElement element = joint.required_child(which, fmt::format("<{} link=\"...\"/>", which));
    element.require_only({"link"});
    return {element.place(), element.text("link")};
  }

  UrdfRobot& robot_;
  const Number& tolerance_;
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

UrdfRobot read_robot(std::string_view text, const std::string& file, const Number& angle_tolerance,
                     const std::vector<XmlLine>& lines) {
  const XmlFile xml(text, file, lines);
  const XmlElement root = xml.root();
  if (root.name() != "robot") {
    root.fail("the root element of a URDF file is <robot>; convert other formats (SDF, MJCF, xacro) to URDF first");
  }
  UrdfRobot robot;
  robot.file = file;
  robot.name = root.text("name");
  Reader reader(robot, angle_tolerance);
  for (const XmlElement& link : root.children("link")) reader.link(link);
  for (const XmlElement& joint : root.children("joint")) reader.joint(joint);
  if (robot.links.empty()) root.fail("has no <link>; a robot has at least one");
  refuse_duplicates(robot.links, "link");
  refuse_duplicates(robot.joints, "joint");
  return robot;
}

}  // namespace torsor
