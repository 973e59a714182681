// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#ifdef TORSOR_WITH_MUJOCO

#include <array>
#include <cmath>
#include <memory>
#include <random>

#include <mujoco/mujoco.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/import/mjcf.hpp"
#include "torsor/generator/import/mujoco_reader.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor::mjcf_dynamics_test {
namespace {

/// MuJoCo works in doubles with some 10² operations for each entry; entries are compared with the largest.
constexpr double rounding_of_mujoco = 1e-12;

using Numbers = std::vector<double>;

/// MuJoCo's model of a file and a state of it.
class Mujoco {
 public:
  explicit Mujoco(const std::string& path) {
    std::array<char, 1000> error{};
    model_.reset(mj_loadXML(path.c_str(), nullptr, error.data(), 1000));
    if (!model_) throw FileError(error.data());
    data_.reset(mj_makeData(model_.get()));
  }
  mjModel& model() { return *model_; }
  mjData& data() { return *data_; }

  /// Any positions and velocities; quaternions of length 1.
  void randomise(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-1.5, 1.5);
    for (int i = 0; i < model_->nq; ++i) data_->qpos[i] = uniform(random);
    mj_normalizeQuat(model_.get(), data_->qpos);
    for (int i = 0; i < model_->nv; ++i) data_->qvel[i] = uniform(random);
    for (int i = 0; i < model_->nv; ++i) data_->qacc[i] = uniform(random);
    for (int i = 0; i < model_->nu; ++i) data_->ctrl[i] = uniform(random);
  }

 private:
  std::unique_ptr<mjModel, void (*)(mjModel*)> model_{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, void (*)(mjData*)> data_{nullptr, mj_deleteData};
};

/// The scene of a file and its equations at a state of MuJoCo.
class Read {
 public:
  explicit Read(const std::string& path, const MjcfOptions& options = {})
      : file_(read_with_mujoco(path)), imported_(mjcf_scene(file_, options)), equations_(imported_.scene) {
    validate(imported_.scene);
  }
  const Equations& equations() const { return equations_; }
  const ImportedMjcf& imported() const { return imported_; }

  /// Values of symbols by their names in the scene.
  void take(Mujoco& mujoco) {
    values_.clear();
    const mjModel& m = mujoco.model();
    const mjData& d = mujoco.data();
    const SceneContent& scene = imported_.scene.content();
    std::size_t attitude = 0, coordinate = 0;
    for (int j = 0; j < m.njnt; ++j) {
      const int q = m.jnt_qposadr[j], v = m.jnt_dofadr[j];
      const bool free = m.jnt_type[j] == mjJNT_FREE, ball = m.jnt_type[j] == mjJNT_BALL;
      const int places = free ? 3 : ball ? 0 : 1, rates = free ? 6 : ball ? 3 : 1;
      if (!free && !ball && !has_coordinate(j)) continue;
      for (int k = 0; k < rates; ++k) {
        const CoordinateContent& c = scene.coordinates.at(coordinate++);
        if (k < places) values_[c.q.get()] = d.qpos[q + k];
        values_[c.v.get()] = d.qvel[v + k];
        values_[c.a.get()] = d.qacc[v + k];
      }
      if (!free && !ball) continue;
      const auto& e = scene.attitudes.at(attitude++).symbols->e;
      for (std::size_t k = 0; k < 4; ++k) values_[e[k].get()] = d.qpos[q + places + static_cast<int>(k)];
    }
    ASSERT_EQ(coordinate, scene.coordinates.size());
  }
  void set(const SymbolPointer& symbol, double value) { values_[symbol.get()] = value; }

  Numbers evaluate(const std::vector<Value>& wanted) {
    Evaluator<Real> evaluate(equations_.program(), [this](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::pi) return Real::pi(50);
      const auto found = values_.find(symbol.get());
      return found == values_.end() ? Real(0) : Real(from_double(found->second), 50);
    });
    Numbers all;
    for (const Real& value : evaluate(wanted)) all.push_back(value.to_double());
    return all;
  }

  /// Whether the joint has a coordinate of its own: it follows no other.
  bool has_coordinate(int joint) const {
    const std::string& name = file_.joints.at(static_cast<std::size_t>(joint)).name;
    for (const MjcfEquality& law : file_.equalities) {
      if (law.type == MjcfEqualityType::joint && law.first == joint) return false;
    }
    return !name.empty();
  }

 private:
  MjcfModel file_;
  ImportedMjcf imported_;
  Equations equations_;
  std::map<const Symbol*, double> values_;
};

std::string data_file(const std::string& name) { return TORSOR_SOURCE_DIR "/tests/import/data/mjcf/" + name + ".xml"; }

void expect_near(const Numbers& actual, const Numbers& expected, double tolerance, const std::string& what) {
  ASSERT_EQ(actual.size(), expected.size()) << what;
  double largest = 0;
  for (const double x : expected) largest = std::max(largest, std::abs(x));
  ASSERT_GT(largest, 0) << what;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(actual[i], expected[i], tolerance * largest) << what << " " << i;
  }
}

/// M of the unknowns, row by row.
std::vector<Value> entries(const Equations& equations) {
  std::vector<Value> all;
  for (const std::vector<Value>& row : equations.mass()) all.insert(all.end(), row.begin(), row.end());
  return all;
}

class MjcfTree : public testing::TestWithParam<const char*> {};

// Inverse dynamics, mass matrix and forces of actuators of MuJoCo's own functions, without constraints.
TEST_P(MjcfTree, MovesAsMujocoMovesIt) {
  Mujoco mujoco(data_file(GetParam()));
  mujoco.model().opt.disableflags |= mjDSBL_CONSTRAINT;
  Read read(data_file(GetParam()));
  const auto n = static_cast<std::size_t>(mujoco.model().nv);
  ASSERT_EQ(read.equations().model().unknown_count(), mujoco.model().nv);
  std::mt19937 random(20261122);
  for (int state = 0; state < 3; ++state) {
    mujoco.randomise(random);
    mjData& d = mujoco.data();
    const Numbers accelerations(d.qacc, d.qacc + n);
    mj_forward(&mujoco.model(), &d);
    std::copy(accelerations.begin(), accelerations.end(), d.qacc);
    mj_inverse(&mujoco.model(), &d);
    read.take(mujoco);
    Numbers mass(n * n);
    mj_fullM(&mujoco.model(), mass.data(), d.qM);
    expect_near(read.evaluate(entries(read.equations())), mass, rounding_of_mujoco, "mass matrix");
    expect_near(read.evaluate(read.equations().inverse_dynamics()), Numbers(d.qfrc_inverse, d.qfrc_inverse + n),
                rounding_of_mujoco, "inverse dynamics");
    // What is left when the actuators' forces are inputs, or the parameters that stand for them.
    const SceneContent& scene = read.imported().scene.content();
    int found = 0;
    for (int i = 0; i < mujoco.model().nu; ++i) {
      std::string name = mj_id2name(&mujoco.model(), mjOBJ_ACTUATOR, i);
      std::replace(name.begin(), name.end(), ' ', '_');
      for (const SymbolPointer& input : read.equations().model().inputs()) {
        if (input->name != name) continue;
        read.set(input, d.actuator_force[i]);
        ++found;
      }
      for (const ParameterContent& parameter : scene.parameters) {
        if (parameter.symbol->name != name) continue;
        read.set(parameter.symbol, d.actuator_force[i]);
        ++found;
      }
    }
    EXPECT_EQ(found, mujoco.model().nu);
    if (mujoco.model().nu == 0) continue;
    Numbers rest = read.evaluate(read.equations().inverse_dynamics());
    const Numbers inputs = read.evaluate(read.equations().of_inputs());
    Numbers expected(n);
    for (std::size_t i = 0; i < n; ++i) {
      rest[i] -= inputs[i];
      expected[i] = d.qfrc_inverse[i] - d.qfrc_actuator[i];
    }
    expect_near(rest, expected, rounding_of_mujoco, "with actuators");
  }
}

INSTANTIATE_TEST_SUITE_P(Files, MjcfTree, testing::Values("walker", "crane", "sinews"),
                         [](const auto& file) { return std::string(file.param); });

// q = G(r): the joints that follow go along, and the equations are MuJoCo's along ∂q/∂r.
TEST(MjcfEquality, JointsFollowOthers) {
  Mujoco mujoco(data_file("coupled"));
  mujoco.model().opt.disableflags |= mjDSBL_CONSTRAINT;
  Read read(data_file("coupled"));
  ASSERT_EQ(read.equations().model().unknown_count(), 2);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int state = 0; state < 3; ++state) {
    mjData& d = mujoco.data();
    // ja and je are free; jb = −0.1 + 0.1 − 2 (ja − 0.2), jc a polynomial of jb + 0.1, jd is held.
    const double ja = uniform(random), va = uniform(random), aa = uniform(random);
    const double je = uniform(random), ve = uniform(random), ae = uniform(random);
    const double jb = -2 * (ja - 0.2), x = jb + 0.1;
    const double jc = 0.05 + x * (0.3 + x * (0.2 + x * (-0.1 + x * 0.04)));
    const double slope = 0.3 + x * (0.4 + x * (-0.3 + x * 0.16)), bend = 0.4 + x * (-0.6 + x * 0.48);
    const double to_b = -2, to_c = slope * to_b;
    const Numbers q{ja, jb, jc, 0.7, je}, v{va, to_b * va, to_c * va, 0, ve};
    const Numbers a{aa, to_b * aa, to_c * aa + bend * (to_b * va) * (to_b * va), 0, ae};
    std::copy(q.begin(), q.end(), d.qpos);
    std::copy(v.begin(), v.end(), d.qvel);
    std::copy(a.begin(), a.end(), d.qacc);
    d.ctrl[0] = uniform(random);
    mj_inverse(&mujoco.model(), &d);
    read.take(mujoco);
    const mjtNum* f = d.qfrc_inverse;
    expect_near(read.evaluate(read.equations().inverse_dynamics()), {f[0] + to_b * f[1] + to_c * f[2], f[4]},
                rounding_of_mujoco, "inverse dynamics");
    // The motor of jb has the gear 3.
    read.set(read.equations().model().inputs().at(0), 1);
    expect_near(read.evaluate(read.equations().of_inputs()), {3 * to_b, 0}, rounding_of_mujoco, "motor");
  }
}

// A box of MuJoCo's composites holds its inner nodes twice: by their joints, and by a tendon of these.
TEST(MjcfEquality, WhatIsHeldAlreadyIsNotConstrainedOnceMore) {
  const Read read(data_file("held"));
  EXPECT_EQ(read.imported().notes,
            std::vector<std::string>{"equality constraints of what is held already do not act: hold sum"});
  EXPECT_EQ(read.equations().model().unknown_count(), 1);
  EXPECT_EQ(read.equations().constraints().size(), 0U);
}

// What equalities hold, directly or by another joint, does not move: no input acts on it.
TEST(MjcfEquality, ActuatorsOfWhatIsHeldDoNotAct) {
  MjcfModel model = read_with_mujoco(data_file("held"));
  const auto joint = [&](const std::string& name) {
    const auto is_named = [&](const MjcfJoint& each) { return each.name == name; };
    return static_cast<int>(std::find_if(model.joints.begin(), model.joints.end(), is_named) - model.joints.begin());
  };
  const auto motor = [&](const std::string& name, MjcfTransmission transmission, int target) {
    MjcfActuator actuator;
    actuator.name = name;
    actuator.transmission = transmission;
    actuator.target = target;
    actuator.gear[0] = 1;
    model.actuators.push_back(actuator);
  };
  MjcfSite site;
  site.name = "top";
  site.body = model.joints[static_cast<std::size_t>(joint("y"))].body;
  site.quaternion = {1, 0, 0, 0};
  model.sites.push_back(site);
  MjcfEquality follows = model.equalities[1];  // y = 2 x, and x is held
  follows.second = joint("x");
  follows.polynomial = {0, 2, 0, 0, 0};
  model.equalities[1] = follows;
  motor("on swing", MjcfTransmission::joint, joint("swing"));
  motor("on x", MjcfTransmission::joint, joint("x"));
  motor("on y", MjcfTransmission::joint, joint("y"));
  motor("on top", MjcfTransmission::site, static_cast<int>(model.sites.size()) - 1);
  const ImportedMjcf made = mjcf_scene(model);
  EXPECT_EQ(made.notes, (std::vector<std::string>{
                            "actuators do not act: on x (its joint is held), on y (its joint is held), on top (its site does "
                            "not move)",
                            "equality constraints of what is held already do not act: hold sum"}));
  EXPECT_EQ(Equations(made.scene).model().inputs().size(), 1U);
}

// They change no motion: an input, a force or the inertia of a rotor would only stand in the equations.
TEST(MjcfEquality, JointsThatAreHeldHaveNoSpringsDampersRotorsOrFriction) {
  const ImportedMjcf without = mjcf_scene(read_with_mujoco(data_file("held")));
  for (double MjcfJoint::* const property :
       {&MjcfJoint::stiffness, &MjcfJoint::damping, &MjcfJoint::armature, &MjcfJoint::friction_loss}) {
    MjcfModel model = read_with_mujoco(data_file("held"));
    for (MjcfJoint& joint : model.joints) {
      if (joint.name == "x") joint.*property = 2;
    }
    const ImportedMjcf made = mjcf_scene(model);
    EXPECT_EQ(made.notes, (std::vector<std::string>{
                              "springs, dampers, rotors and friction of joints that equalities hold do not act: x",
                              "equality constraints of what is held already do not act: hold sum"}));
    EXPECT_EQ(made.scene.content().actions.size(), without.scene.content().actions.size());
    EXPECT_EQ(made.scene.content().bodies.size(), 2U);
  }
}

// Contacts cannot act: that is noted, and refused strictly; where there are none, nothing is.
TEST(Mjcf, NotesWhatCannotActAndRefusesItStrictly) {
  MjcfModel model = read_with_mujoco(data_file("walker"));
  MjcfOptions strict;
  strict.strict = true;
  const std::vector<std::string> notes{"contacts do not act: the geometry of 1 geom is kept and has no effect"};
  EXPECT_EQ(mjcf_scene(model).notes, notes);
  EXPECT_EQ(mjcf_scene(model).contact_geometry.size(), 1U);
  try {
    mjcf_scene(model, strict);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), data_file("walker") + ": " + notes[0] + "; correct the file, or leave out --strict");
  }
  model.geoms.clear();
  EXPECT_EQ(mjcf_scene(model, strict).notes, std::vector<std::string>());
  model.joints[2].friction_loss = 0.5;  // the hinge of the ear
  EXPECT_EQ(mjcf_scene(model).notes, std::vector<std::string>{"frictionloss of joints acts with --friction file only: wiggle (0.5)"});
  model.tendons[0].wraps = true;
  EXPECT_EQ(mjcf_scene(model).notes,
            (std::vector<std::string>{"frictionloss of joints acts with --friction file only: wiggle (0.5)",
                                      "stiffness, damping and frictionloss of tendons around geoms do not act: sinew",
                                      "actuators do not act: winch (its tendon runs around geoms)"}));
}

// What cannot act is one line for each kind, however many parts of the model it concerns.
TEST(Mjcf, NotesOneLineForEachKind) {
  MjcfModel model = read_with_mujoco(data_file("sinews"));
  EXPECT_EQ(mjcf_scene(model).notes, std::vector<std::string>());
  for (MjcfJoint& joint : model.joints) joint.friction_loss = 0.25;
  for (MjcfTendon& tendon : model.tendons) tendon.limited = true;
  EXPECT_EQ(mjcf_scene(model).notes,
            (std::vector<std::string>{"frictionloss of joints acts with --friction file only: shoulder (0.25), elbow (0.25), "
                                      "twist (0.25), turn (0.25)",
                                      "frictionloss of ball and free joints does not act: socket (0.25), tether (0.25)",
                                      "the range of tendons does not act: cord, tackle, spring at rest"}));
}

// Opposite forces at two sites have a moment that what carries both feels or not, by MuJoCo's version; moments alone have
// none. Sites that do not move apart transmit nothing.
TEST(Mjcf, ForcesBetweenTwoSitesOfWhatMovesAreNoted) {
  MjcfModel model = read_with_mujoco(data_file("sinews"));
  const auto site = [&](const std::string& name) {
    const auto is_named = [&](const MjcfSite& each) { return each.name == name; };
    return static_cast<int>(std::find_if(model.sites.begin(), model.sites.end(), is_named) - model.sites.begin());
  };
  for (MjcfActuator& actuator : model.actuators) {
    if (actuator.name == "push") actuator.reference = site("biceps");
    if (actuator.name == "both") actuator.reference = site("brachialis");
    if (actuator.name == "piston") actuator.target = site("ceiling");
  }
  EXPECT_EQ(mjcf_scene(model).notes,
            std::vector<std::string>{"actuators do not act: push (it pushes from one site against another, and upper arm, "
                                     "which carries both, moves), both (its sites do not move apart), piston (its sites do "
                                     "not move apart)"});
}

// Near the attitude of rest the angle has no derivative; torque and stiffness have theirs: C = −k 2 v.
TEST(MjcfTree, ASpringOfABallJointIsLinearAtRest) {
  MjcfOptions weightless;
  weightless.gravity = std::array<Number, 3>{};
  Read read(data_file("sinews"), weightless);
  const SceneContent& scene = read.imported().scene.content();
  ASSERT_EQ(scene.attitudes.at(0).name, "socket_attitude");
  std::size_t omega = 0;
  while (scene.coordinates.at(omega).v->name != "socket_attitude_omega_x") ++omega;
  for (const double v : {0.0, 3e-15, 3e-25}) {  // at rest, and on either side of where |v| is taken as 1e-20
    Mujoco mujoco(data_file("sinews"));
    read.take(mujoco);
    const auto& e = scene.attitudes.at(0).symbols->e;
    read.set(e[0], 1);
    read.set(e[1], v);
    // Their product with e_w = 1 is exact but for |v|² beside 1, and the result is rounded once.
    EXPECT_NEAR(read.evaluate(read.equations().inverse_dynamics()).at(omega), 2 * 2.5 * v, 1e-15 * v);
  }
}

/// What is left of a row when its part in the span of the others is taken away, over its length.
double outside_of(const std::vector<Numbers>& span, Numbers row) {
  const auto dot = [](const Numbers& a, const Numbers& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  };
  const double length = std::sqrt(dot(row, row));
  std::vector<Numbers> basis;
  const auto without_basis = [&](Numbers& v) {
    for (int twice = 0; twice < 2; ++twice) {
      for (const Numbers& e : basis) {
        const double part = dot(e, v);
        for (std::size_t i = 0; i < v.size(); ++i) v[i] -= part * e[i];
      }
    }
  };
  for (Numbers v : span) {
    const double before = std::sqrt(dot(v, v));
    without_basis(v);
    const double size = std::sqrt(dot(v, v));
    if (!(size > 1e-9 * before)) continue;
    for (double& x : v) x /= size;
    basis.push_back(v);
  }
  without_basis(row);
  return std::sqrt(dot(row, row)) / length;
}

// At the reference the loops are closed: what the constraints forbid there is what MuJoCo's constraints forbid.
TEST(MjcfEquality, ClosuresForbidWhatMujocoForbids) {
  Mujoco mujoco(data_file("loops"));
  Read read(data_file("loops"));
  mjModel& m = mujoco.model();
  mjData& d = mujoco.data();
  // A follower has no column in the scene: j6 = j4 is taken into account by adding its column to that of j4.
  mj_forward(&m, &d);
  read.take(mujoco);
  const auto n = static_cast<std::size_t>(read.equations().model().unknown_count());
  ASSERT_EQ(n + 1, static_cast<std::size_t>(m.nv));
  std::vector<Numbers> theirs;
  for (int row = 0; row < d.ne; ++row) {
    Numbers all(d.efc_J + row * m.nv, d.efc_J + (row + 1) * m.nv);
    all[9] += all[11];
    all.pop_back();
    double size = 0;
    for (const double x : all) size += x * x;
    if (size > 1e-20) theirs.push_back(all);
  }
  std::vector<Numbers> ours;
  for (const ConstraintRow& row : read.equations().constraints()) {
    ours.push_back(read.evaluate(row.jacobian));
    ASSERT_EQ(ours.back().size(), n);
  }
  ASSERT_EQ(theirs.size(), 9U);  // a plane pin 2, a weld 6, the second tie 1
  const auto empty = [](const Numbers& row) {
    return std::all_of(row.begin(), row.end(), [](double x) { return std::abs(x) < 1e-13; });
  };
  // Anchors are good to the last place of doubles, and lengths here are of the order of 1.
  for (const Numbers& row : ours) {
    if (empty(row)) continue;
    EXPECT_LT(outside_of(theirs, row), 1e-12);
  }
  for (const Numbers& row : theirs) EXPECT_LT(outside_of(ours, row), 1e-12);
}

// Closures of a plane mechanism forbid motions across its plane, which it has not. MuJoCo finds the place of the second
// body in doubles, off by 1e-17 m; where it is exact, those rows vanish and repeat the others.
TEST(MjcfEquality, LoopsInATiltedPlaneAreClosedExactly) {
  const Read read(data_file("tilted_loop"));
  std::size_t without = 0;
  for (const ConstraintRow& row : read.equations().constraints()) {
    const bool empty = std::all_of(row.jacobian.begin(), row.jacobian.end(), [](const Value& a) { return a.is_zero(); });
    if (!empty) continue;
    ++without;
    EXPECT_TRUE(identically_zero(row.value)) << row.name;
  }
  EXPECT_EQ(without, 4U);  // of the point one of three rows, of the weld one place and two turns
  // Along the plane: the point two, the weld three.
  EXPECT_EQ(read.equations().redundancy().kept.size(), 5U);
  EXPECT_EQ(read.equations().redundancy().dropped.size(), 4U);
}

}  // namespace
}  // namespace torsor::mjcf_dynamics_test

#else

TEST(MjcfTree, IsComparedWhereMujocoIsInstalled) { GTEST_SKIP() << "libmujoco-dev is not installed"; }

#endif
