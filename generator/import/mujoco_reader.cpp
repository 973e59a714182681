// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/mujoco_reader.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

/// MuJoCo tells warnings and errors by functions that a program sets; otherwise it writes a file and ends the program.
/// There is one of each in a process.
std::vector<std::string>* warnings = nullptr;

void keep_warning(const char* message) {
  if (warnings != nullptr) warnings->emplace_back(message);
}
void throw_error(const char* message) { throw FileError(fmt::format("MuJoCo: {}", message)); }

/// Sets them while a file is read.
class Listening {
 public:
  explicit Listening(std::vector<std::string>& all) : warning_(mju_user_warning), error_(mju_user_error) {
    warnings = &all;
    mju_user_warning = keep_warning;
    mju_user_error = throw_error;
  }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;
  ~Listening() {
    mju_user_warning = warning_;
    mju_user_error = error_;
    warnings = nullptr;
  }

 private:
  void (*warning_)(const char*);
  void (*error_)(const char*);
};

/// One line of what MuJoCo says in several.
std::string one_line(const std::string& message) {
  std::string line;
  for (const char c : message) {
    if (c != '\n' && c != '\r')
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

/// ":12" where the message tells a line.
std::string line_number(const std::string& message) {
  const std::size_t at = message.rfind("line ");
  const std::size_t other = message.rfind("line = ");
  const std::size_t begin = other != std::string::npos ? other + 7 : at == std::string::npos ? at : at + 5;
  if (begin == std::string::npos) return "";
  const std::size_t end = std::min(message.find_first_not_of("0123456789", begin), message.size());
  return end == begin || message.compare(begin, end - begin, "0") == 0 ? "" : ":" + message.substr(begin, end - begin);
}

/// Files of a later MuJoCo have elements and attributes that an earlier one takes for mistakes.
std::string remedy(const std::string& message) {
  if (message.find("Schema violation") == std::string::npos) return "";
  return fmt::format("; correct the name, or if the file is for a later MuJoCo than {0}, write it in the terms of {0} or "
                     "build torsor with the later one",
                     mj_versionString());
}

template <std::size_t N>
std::array<double, N> numbers(const mjtNum* first) {
  std::array<double, N> all{};
  std::copy_n(first, N, all.begin());
  return all;
}

std::string name_of_object(const mjModel& m, int address) { return m.names + address; }

std::string or_else(const std::string& name, const std::string& otherwise) { return name.empty() ? otherwise : name; }

/// Names for what has none in the file, apart from the file's and from one another: a_joint, a_joint_2.
class MadeNames {
 public:
  MadeNames(const mjModel& m, const int* addresses, int count) {
    for (int i = 0; i < count; ++i) taken_.insert(name_of_object(m, addresses[i]));
  }
  std::string or_made(const std::string& name, const std::string& otherwise) {
    if (!name.empty()) return name;
    std::string made = otherwise;
    for (int n = 2; !taken_.insert(made).second; ++n) made = fmt::format("{}_{}", otherwise, n);
    return made;
  }

 private:
  std::set<std::string> taken_;
};

const char* geometry(int type) {
  switch (type) {
    case mjGEOM_PLANE:
      return "plane";
    case mjGEOM_HFIELD:
      return "hfield";
    case mjGEOM_SPHERE:
      return "sphere";
    case mjGEOM_CAPSULE:
      return "capsule";
    case mjGEOM_ELLIPSOID:
      return "ellipsoid";
    case mjGEOM_CYLINDER:
      return "cylinder";
    case mjGEOM_BOX:
      return "box";
    case mjGEOM_MESH:
      return "mesh";
    default:
      return "other";
  }
}

class Compiled {
 public:
  Compiled(const mjModel& m, const std::string& file) : m_(m), reference_(mj_makeData(&m), mj_deleteData) {
    mj_kinematics(&m, reference_.get());
    model_.file = file;
    model_.name = m.names;
  }

  MjcfModel read() {
    if (!disabled(mjDSBL_GRAVITY)) model_.gravity = numbers<3>(m_.opt.gravity);
    require_finite("option", "gravity", m_.opt.gravity, 3);
    model_.limits_act = !without_constraints(mjDSBL_LIMIT);
    read_bodies();
    read_joints();
    read_geometry();
    read_tendons();
    read_actuators();
    read_equalities();
    note_the_rest();
    return std::move(model_);
  }

 private:
  bool disabled(int flag) const { return (m_.opt.disableflags & flag) != 0; }
  bool without_constraints(int flag) const { return disabled(flag) || disabled(mjDSBL_CONSTRAINT); }

  /// Throws where a number of the file is none; it would be met where no name is known any more.
  void require_finite(const std::string& object, const char* what, const mjtNum* first, int count) const {
    for (int i = 0; i < count; ++i) {
      if (std::isfinite(first[i])) continue;
      throw FileError(fmt::format("{}: {}: {} is {}; give finite numbers", model_.file, object, what, shortest(first[i])));
    }
  }
  void note(std::string text) { model_.notes.push_back(std::move(text)); }
  void remark(std::string text) { model_.remarks.push_back(std::move(text)); }

  void read_bodies() {
    MadeNames names(m_, m_.name_bodyadr, m_.nbody);
    for (int i = 0; i < m_.nbody; ++i) {
      MjcfBody body;
      body.name = names.or_made(name_of_object(m_, m_.name_bodyadr[i]), fmt::format("body_{}", i));
      const std::string object = "body " + body.name;
      require_finite(object, "its place", m_.body_pos + 3 * i, 3);
      require_finite(object, "its orientation", m_.body_quat + 4 * i, 4);
      require_finite(object, "its mass", m_.body_mass + i, 1);
      require_finite(object, "its centre of mass", m_.body_ipos + 3 * i, 3);
      require_finite(object, "its inertia", m_.body_inertia + 3 * i, 3);
      require_finite(object, "its inertia", m_.body_iquat + 4 * i, 4);
      body.parent = m_.body_parentid[i];
      body.position = numbers<3>(m_.body_pos + 3 * i);
      body.quaternion = numbers<4>(m_.body_quat + 4 * i);
      body.mass = m_.body_mass[i];
      body.center = numbers<3>(m_.body_ipos + 3 * i);
      body.principal = numbers<4>(m_.body_iquat + 4 * i);
      body.inertia = numbers<3>(m_.body_inertia + 3 * i);
      body.mocap = m_.body_mocapid[i] >= 0;
#if mjVERSION_HEADER >= 233
      body.floats_weightless = m_.body_gravcomp[i] != 0;
#endif
      model_.bodies.push_back(std::move(body));
    }
  }

  void read_joints() {
    static constexpr std::array<int, 4> sizes{7, 4, 1, 1};
    const bool passive = !disabled(mjDSBL_PASSIVE);
    MadeNames names(m_, m_.name_jntadr, m_.njnt);
    for (int i = 0; i < m_.njnt; ++i) {
      MjcfJoint joint;
      joint.body = m_.jnt_bodyid[i];
      const std::string& body = model_.bodies[static_cast<std::size_t>(joint.body)].name;
      joint.name = names.or_made(name_of_object(m_, m_.name_jntadr[i]), body + "_joint");
      const std::string object = "joint " + joint.name;
      joint.type = static_cast<MjcfJointType>(m_.jnt_type[i]);
      joint.position = numbers<3>(m_.jnt_pos + 3 * i);
      joint.axis = numbers<3>(m_.jnt_axis + 3 * i);
      const int q = m_.jnt_qposadr[i], v = m_.jnt_dofadr[i], size = sizes.at(static_cast<std::size_t>(m_.jnt_type[i]));
      require_finite(object, "pos", m_.jnt_pos + 3 * i, 3);
      require_finite(object, "axis", m_.jnt_axis + 3 * i, 3);
      require_finite(object, "ref", m_.qpos0 + q, size);
      require_finite(object, "springref", m_.qpos_spring + q, size);
      require_finite(object, "armature", m_.dof_armature + v, 1);
      require_finite(object, "frictionloss", m_.dof_frictionloss + v, 1);
      require_finite(object, "stiffness", m_.jnt_stiffness + i, 1);
      require_finite(object, "damping", m_.dof_damping + v, 1);
      if (m_.jnt_limited[i] != 0) require_finite(object, "range", m_.jnt_range + 2 * i, 2);
      joint.reference.assign(m_.qpos0 + q, m_.qpos0 + q + size);
      joint.spring_reference.assign(m_.qpos_spring + q, m_.qpos_spring + q + size);
      joint.armature = m_.dof_armature[v];
      joint.friction_loss = without_constraints(mjDSBL_FRICTIONLOSS) ? 0 : m_.dof_frictionloss[v];
      if (passive) {
        joint.stiffness = m_.jnt_stiffness[i];
        joint.damping = m_.dof_damping[v];
      }
      joint.limited = m_.jnt_limited[i] != 0;
      joint.range = numbers<2>(m_.jnt_range + 2 * i);
      model_.joints.push_back(std::move(joint));
    }
    if (!passive) remark("the flag passive is disabled: springs and dampers do not act");
  }

  /// Whether <contact><pair> names it: it touches the other one whatever its contype.
  bool in_pair(int geom) const {
    const auto names = [geom](const int* first, int count) { return std::find(first, first + count, geom) != first + count; };
    return names(m_.pair_geom1, m_.npair) || names(m_.pair_geom2, m_.npair);
  }

  void read_geometry() {
    const bool untouched = without_constraints(mjDSBL_CONTACT);
    if (untouched && m_.ngeom > 0) remark("the flag contact or constraint is disabled: no geom touches another");
    for (int i = 0; i < m_.ngeom && !untouched; ++i) {
      if (m_.geom_contype[i] == 0 && m_.geom_conaffinity[i] == 0 && !in_pair(i)) continue;
      model_.geoms.push_back({name_of_object(m_, m_.name_geomadr[i]), geometry(m_.geom_type[i]), m_.geom_bodyid[i],
                              numbers<3>(m_.geom_size + 3 * i), numbers<3>(m_.geom_pos + 3 * i),
                              numbers<3>(m_.geom_friction + 3 * i), numbers<4>(m_.geom_quat + 4 * i)});
    }
    for (int i = 0; i < m_.nsite; ++i) {
      const std::string object = "site " + or_else(name_of_object(m_, m_.name_siteadr[i]), fmt::format("site_{}", i));
      require_finite(object, "its place", m_.site_pos + 3 * i, 3);
      require_finite(object, "its orientation", m_.site_quat + 4 * i, 4);
      model_.sites.push_back({or_else(name_of_object(m_, m_.name_siteadr[i]), fmt::format("site_{}", i)),
                              m_.site_bodyid[i], numbers<3>(m_.site_pos + 3 * i), numbers<4>(m_.site_quat + 4 * i)});
    }
  }

  void read_tendons() {
    const bool passive = !disabled(mjDSBL_PASSIVE);
    for (int i = 0; i < m_.ntendon; ++i) {
      MjcfTendon tendon;
      tendon.name = or_else(name_of_object(m_, m_.name_tendonadr[i]), fmt::format("tendon_{}", i));
      read_path(i, tendon);
      if (passive) {
        tendon.stiffness = m_.tendon_stiffness[i];
        tendon.damping = m_.tendon_damping[i];
      }
      const std::string object = "tendon " + tendon.name;
      require_finite(object, "stiffness", m_.tendon_stiffness + i, 1);
      require_finite(object, "damping", m_.tendon_damping + i, 1);
      require_finite(object, "frictionloss", m_.tendon_frictionloss + i, 1);
      require_finite(object, "its length", m_.tendon_length0 + i, 1);
      tendon.friction_loss = without_constraints(mjDSBL_FRICTIONLOSS) ? 0 : m_.tendon_frictionloss[i];
#if mjVERSION_HEADER >= 230
      tendon.rest = m_.tendon_lengthspring[2 * i];
      if (tendon.stiffness != 0 && m_.tendon_lengthspring[2 * i + 1] != tendon.rest) {
        note(fmt::format("tendon {}: its spring is slack between two lengths; it acts here from the first one on",
                         tendon.name));
      }
#else
      tendon.rest = m_.tendon_lengthspring[i];
#endif
      tendon.length_at_reference = m_.tendon_length0[i];
      tendon.limited = m_.tendon_limited[i] != 0;
      model_.tendons.push_back(std::move(tendon));
    }
  }

  /// Of two sites where the bodies stand as the file places them.
  double distance(int site, int other) const {
    double square = 0;
    for (int k = 0; k < 3; ++k) {
      const double apart = reference_->site_xpos[3 * site + k] - reference_->site_xpos[3 * other + k];
      square += apart * apart;
    }
    return std::sqrt(square);
  }

  void read_path(int i, MjcfTendon& tendon) const {
    const int* before = nullptr;  // the site that the next one is joined to
    double divisor = 1;
    for (int k = m_.tendon_adr[i]; k < m_.tendon_adr[i] + m_.tendon_num[i]; ++k) {
      const int object = m_.wrap_objid[k];
      switch (m_.wrap_type[k]) {
        case mjWRAP_JOINT:
          tendon.terms.emplace_back(object, m_.wrap_prm[k]);
          break;
        case mjWRAP_PULLEY:
          before = nullptr;
          divisor = m_.wrap_prm[k];
          break;
        case mjWRAP_SITE:
          if (before) tendon.spans.push_back({*before, object, divisor, distance(*before, object)});
          before = &m_.wrap_objid[k];
          break;
        default:
          tendon.wraps = true;
      }
    }
  }

  /// How the force comes about, empty where it is the control itself.
  std::string law(int i) const {
    const mjtNum* gain = m_.actuator_gainprm + i * mjNGAIN;
    const mjtNum* bias = m_.actuator_biasprm + i * mjNBIAS;
    const bool fixed = m_.actuator_gaintype[i] == mjGAIN_FIXED;
    const bool affine = m_.actuator_biastype[i] == mjBIAS_AFFINE;
    if (m_.actuator_dyntype[i] != mjDYN_NONE) return "the force follows the control by dynamics of its own";
    if (!fixed || (m_.actuator_biastype[i] != mjBIAS_NONE && !affine))
      return "the force is no linear function of the control";
    std::string text = gain[0] == 1 ? "control" : shortest(gain[0]) + " control";
    if (affine) {
      static constexpr std::array<const char*, 3> of{"", " length", " velocity"};
      for (std::size_t k = 0; k < 3; ++k) {
        if (bias[k] != 0)
          text += fmt::format(" {} {}{}", bias[k] < 0 ? "-" : "+", shortest(std::abs(bias[k])), of.at(k));
      }
    }
    return text == "control" ? "" : "the force is " + text;
  }

  void read_actuators() {
    if (disabled(mjDSBL_ACTUATION)) {
      if (m_.nu > 0) remark("the flag actuation is disabled: actuators do not act");
      return;
    }
    for (int i = 0; i < m_.nu; ++i) {
      MjcfActuator actuator;
      actuator.name = or_else(name_of_object(m_, m_.name_actuatoradr[i]), fmt::format("actuator_{}", i));
      switch (m_.actuator_trntype[i]) {
        case mjTRN_JOINT:
          actuator.transmission = MjcfTransmission::joint;
          break;
        case mjTRN_JOINTINPARENT:
          actuator.transmission = MjcfTransmission::joint_in_parent;
          break;
        case mjTRN_TENDON:
          actuator.transmission = MjcfTransmission::tendon;
          break;
        case mjTRN_SITE:
          actuator.transmission = MjcfTransmission::site;
          if (m_.actuator_trnid[2 * i + 1] >= 0) actuator.reference = m_.actuator_trnid[2 * i + 1];
          break;
        case mjTRN_SLIDERCRANK:
          actuator.transmission = MjcfTransmission::slider_crank;
          actuator.reference = m_.actuator_trnid[2 * i + 1];
          actuator.rod = m_.actuator_cranklength[i];
          break;
        default:
          actuator.transmission = MjcfTransmission::other;
      }
      require_finite("actuator " + actuator.name, "gear", m_.actuator_gear + 6 * i, 6);
      actuator.target = m_.actuator_trnid[2 * i];
      actuator.gear = numbers<6>(m_.actuator_gear + 6 * i);
      actuator.law = law(i);
      const auto bounded = [&](const char* what, const mjtNum* range) {
        actuator.law += fmt::format("{}the {} lies between {} and {}", actuator.law.empty() ? "" : "; ", what, shortest(range[0]),
                                    shortest(range[1]));
      };
      if (m_.actuator_forcelimited[i] != 0) bounded("force", m_.actuator_forcerange + 2 * i);
      if (m_.actuator_ctrllimited[i] != 0 && !disabled(mjDSBL_CLAMPCTRL)) bounded("control", m_.actuator_ctrlrange + 2 * i);
      model_.actuators.push_back(std::move(actuator));
    }
  }

  void read_equalities() {
    const bool off = without_constraints(mjDSBL_EQUALITY);
    if (off && m_.neq > 0) remark("the flag equality or constraint is disabled: equality constraints do not act");
    for (int i = 0; i < m_.neq && !off; ++i) {
      MjcfEquality equality;
      equality.name = or_else(name_of_object(m_, m_.name_eqadr[i]), fmt::format("equality_{}", i));
#if mjVERSION_HEADER >= 300
      const bool active = m_.eq_active0[i] != 0;
#else
      const bool active = m_.eq_active[i] != 0;
#endif
      if (!active) {
        remark(fmt::format("equality constraint {} is not active", equality.name));
        continue;
      }
      equality.first = m_.eq_obj1id[i];
      if (m_.eq_obj2id[i] >= 0) equality.second = m_.eq_obj2id[i];
      const mjtNum* data = m_.eq_data + i * mjNEQDATA;
      require_finite("equality constraint " + equality.name, "a number of it", data, mjNEQDATA);
      switch (m_.eq_type[i]) {
        case mjEQ_CONNECT:
          equality.type = MjcfEqualityType::connect;
          equality.first_point = numbers<3>(data);
          equality.second_point = numbers<3>(data + 3);
          break;
        case mjEQ_WELD:
          equality.type = MjcfEqualityType::weld;
          equality.first_point = numbers<3>(data + 3);
          equality.second_point = numbers<3>(data);
          equality.quaternion = numbers<4>(data + 6);
          break;
        case mjEQ_JOINT:
        case mjEQ_TENDON:
          equality.type = m_.eq_type[i] == mjEQ_JOINT ? MjcfEqualityType::joint : MjcfEqualityType::tendon;
          equality.polynomial = numbers<5>(data);
          break;
        default:
          equality.type = MjcfEqualityType::other;
      }
#if mjVERSION_HEADER >= 322
      if ((equality.type == MjcfEqualityType::connect || equality.type == MjcfEqualityType::weld) &&
          m_.eq_objtype[i] != mjOBJ_BODY) {
        equality.type = MjcfEqualityType::other;  // between sites
      }
#endif
      model_.equalities.push_back(std::move(equality));
    }
  }

  void note_the_rest() {
    for (int i = 0; i < m_.nkey; ++i) {
      remark(fmt::format("keyframe {}: the start is that of the bodies' places, and of --initial",
                         or_else(name_of_object(m_, m_.name_keyadr[i]), std::to_string(i))));
    }
    if (m_.opt.density != 0 || m_.opt.viscosity != 0) note("the medium (density, viscosity, wind) does not act");
#if mjVERSION_HEADER >= 230
    if (m_.nplugin > 0) note("plugins do not act");
#endif
#if mjVERSION_HEADER >= 300
    if (m_.nflex > 0) note("flexible bodies (flex) do not act");
#endif
  }

  const mjModel& m_;
  std::unique_ptr<mjData, void (*)(mjData*)> reference_;
  MjcfModel model_;
};

}  // namespace

MjcfModel read_with_mujoco(const std::string& path) {
  std::vector<std::string> told;
  std::array<char, 2000> message{};
  const Listening listening(told);
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(
      mj_loadXML(path.c_str(), nullptr, message.data(), static_cast<int>(message.size())), mj_deleteModel);
  const std::string text = message.data();
  if (!model) throw FileError(fmt::format("{}{}: MuJoCo: {}{}", path, line_number(text), one_line(text), remedy(text)));
  MjcfModel read = Compiled(*model, path).read();
  if (!text.empty()) told.push_back(text);
  for (const std::string& warning : told) read.notes.push_back("MuJoCo warns: " + one_line(warning));
  return read;
}

}  // namespace torsor
