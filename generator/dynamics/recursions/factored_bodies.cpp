// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/factored_bodies.hpp"

#include <algorithm>
#include <array>

#include "torsor/generator/dynamics/forces/virtual_power.hpp"
#include "torsor/generator/dynamics/motion/central_bodies.hpp"
#include "torsor/generator/dynamics/recursions/articulated_bodies.hpp"
#include "torsor/generator/program/flattening.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

constexpr std::size_t components = 6;  ///< of a motion: Ω, then V

/// c, d and f of one square: a component of motion, angular · Ω + linear · V(P), its weight, and the force that acts
/// along it.
struct Square {
  Value weight, force;
  Vector angular, linear;
  std::size_t carried = 0;  ///< P is the origin of that link; of the link itself when 0
};

/// The same as it answers to the motions X_j and to that of the joint.
struct Answer {
  Value weight, force;
  std::array<Value, components> of;
  Value joint, joint_sum;  ///< the same, as a definition and as a sum
};

Value& component(Vector& angular, Vector& linear, std::size_t j) {
  return (j < 3 ? angular : linear)[static_cast<int>(j % 3)];
}

bool is_along(const Link& link, std::size_t j) { return is_along_joint(link, static_cast<int>(j % 3), j < 3); }

/// The point of a link that its joint leaves where it is, but for the rate that it is solved for: unless a joint beyond moves
/// it in the link, to where this joint moves it no more.
struct Tip {
  std::size_t link = 0;  ///< whose origin it is; 0: the centre of mass of a body
  Vector arm;            ///< from the link's origin
  Vector velocity;       ///< per unit rate of the joint
  Value square{};        ///< of that; zero where it may vanish
  std::optional<int> aligned;  ///< the only component that this has
};

struct JointSolution {
  Tip tip;
  std::array<Value, components> gain, fix;  ///< g_j, ρ_j
  Value along;                              ///< u
};

class FactoredRecursion {
 public:
  FactoredRecursion(const BodyTree& tree, const JointCoordinates& joints, const std::vector<Value>& efforts,
                    const std::map<int, Wrench>& wrenches)
      : tree_(tree),
        joints_(joints),
        efforts_(efforts),
        wrenches_(wrenches),
        flattening_(Flattening::of_matrix(tree.program(), efforts.size())),
        bodies_(central_bodies(tree)),
        reference_(reference_motion(tree, std::vector<Axes>(tree.links().size(), Axes::own))),
        handed_(tree.links().size()),
        done_(tree.links().size()) {}

  ForwardSolution run() {
    solution_.method = name_of_squares;
    for (std::size_t k = links_.size(); k-- > 1;) hand_over(k);
    accelerate();
    return std::move(solution_);
  }

 private:
  Vector arm_of(std::size_t carried) const {
    return carried == 0 ? Vector() : bound(program_, tree_.arm(links_[carried]));
  }

  /// 1/x; of what is one product in parameters and functions, written as one, so that it cancels.
  Value inverse_of(const Value& x) {
    if (const auto flat = flattening_(x); flat && flat->polynomial().terms().size() == 1) return pow(*flat, -1);
    return program_.bind(pow(x, -1));
  }

  Value less(const Value& a, const Value& b, const Value& c) {
    return b.is_zero() || c.is_zero() ? a : program_.bind(flattening_.difference(a, b, c));
  }

  // ---- matter of a link ----

  std::vector<Square> own_squares(std::size_t k) {
    std::vector<Square> squares;
    bool first = true;
    for (const CentralBody& body : bodies_) {
      if (body.link != k) continue;
      add(squares, body, first);
      first = false;
    }
    if (first && wrenches_.contains(static_cast<int>(k))) add(squares, {k, {}, {}, {}}, true);
    return squares;
  }

  /// The velocity of the centre of mass, and L D Lᵀ of the operator there. `applies`: the wrench on the link too.
  void add(std::vector<Square>& squares, const CentralBody& body, bool applies) {
    Acceleration& motion = reference_.links[body.link];
    const Vector acceleration = bound(program_, motion.linear() + motion.u_times(body.center));
    Vector force = -(body.mass * acceleration);
    Link turning;
    turning.mass.inertia = body.inertia;
    Vector moment = -screw_less_gravity(program_, motion, turning).moment;
    if (const auto wrench = wrenches_.find(static_cast<int>(body.link)); applies && wrench != wrenches_.end()) {
      const Wrench applied = tree_.applied(body.link, wrench->second);
      const Vector resultant = bound(program_, applied.resultant);
      force += resultant;
      moment += applied.moment;
      moment += cross(resultant, body.center);
    }
    const Value one = program_.number(Number(1));
    for (int i = 0; i < 3; ++i) {
      Square square{body.mass, program_.bind(force[i]), {}, {}};
      square.linear[i] = one;
      square.angular = bound(program_, cross(body.center, square.linear));
      keep(squares, std::move(square));
    }
    Matrix rest = body.inertia;
    for (int i = 0; i < 3; ++i) {
      Square square{program_.bind(rest(i, i)), program_.bind(moment[i]), {}, {}};
      square.angular[i] = one;
      for (int j = i + 1; j < 3 && !square.weight.is_zero(); ++j) {
        if (rest(i, j).is_zero()) continue;
        const Value inverse = inverse_of(square.weight);
        square.angular[j] = program_.bind(rest(i, j) * inverse);
        moment[j] -= square.angular[j] * square.force;
      }
      for (int j = i + 1; j < 3; ++j) {
        for (int l = i + 1; l < 3; ++l) rest(j, l) = less(rest(j, l), square.angular[l], rest(i, j));
      }
      keep(squares, std::move(square));
    }
  }

  static void keep(std::vector<Square>& squares, Square square) {
    if (!square.weight.is_zero() || !square.force.is_zero()) squares.push_back(std::move(square));
  }

  // ---- from the tips to the ground ----

  void hand_over(std::size_t k) {
    const Link& link = links_[k];
    std::vector<Square> squares = own_squares(k);
    const auto own = static_cast<std::ptrdiff_t>(squares.size());
    for (std::size_t c = k + 1; c < links_.size(); ++c) {
      if (links_[c].parent == static_cast<int>(k)) squares.insert(squares.end(), handed_[c].begin(), handed_[c].end());
    }
    std::vector<Answer> answers = answers_of(k, squares);
    // Where a link's own matter resists, what it carries cannot take a pivot away, at whatever angles.
    std::vector<Answer> guard(answers.begin(), answers.begin() + own);
    if (is_free(link)) {
      add_effort(k, answers);
      give_way(k, answers);
      std::array<Value, components> gain;
      eliminate(guard, gain);
    }
    if (link.parent == 0) return;
    std::vector<Square> result = gathered(answers, pivots_of(guard));
    for (Square& square : result) {
      square.angular = bound(program_, tree_.to_parent(link, square.angular));
      square.linear = bound(program_, tree_.to_parent(link, square.linear));
      square.carried = k;
    }
    handed_[k] = std::move(result);
  }

  Tip tip_of(std::size_t k) const {
    const Link& link = links_[k];
    Tip tip;
    for (std::size_t c = k + 1; c < links_.size() && tip.link == 0; ++c) {
      if (links_[c].parent == static_cast<int>(k)) tip.link = c;
    }
    tip.arm = arm_of(tip.link);
    if (tip.link == 0) {
      const auto body =
          std::find_if(bodies_.begin(), bodies_.end(), [k](const CentralBody& each) { return each.link == k; });
      if (body != bodies_.end()) tip.arm = body->center;
    }
    tip.velocity = link.joint == JointKind::revolute ? cross(link.axis, tip.arm) : link.axis;
    const Value square = dot(tip.velocity, tip.velocity);
    if (program_.stage(square) > Stage::parameters) return tip;
    tip.square = square;
    int count = 0;
    for (int i = 0; i < 3; ++i) {
      if (tip.velocity[i].is_zero()) continue;
      ++count;
      tip.aligned = i;
    }
    if (count != 1) tip.aligned.reset();
    return tip;
  }


  /// X_j, and what it does to the tip.
  struct UnitMotion {
    Twist twist;
    Vector tip;
  };

  std::array<UnitMotion, components> unit_motions(std::size_t k) {
    const Link& link = links_[k];
    const bool turns = link.joint == JointKind::revolute;
    JointSolution& joint = done_[k];
    std::array<UnitMotion, components> motions;
    for (std::size_t j = 0; j < components; ++j) {
      auto& [twist, tip] = motions[j];
      component(twist.angular, twist.linear, j) = program_.number(Number(1));
      tip = twist.linear + cross(twist.angular, joint.tip.arm);
      if (!is_free(link)) continue;
      Value& fix = joint.fix[j];
      if (!joint.tip.square.is_zero()) {
        const Value inverse = inverse_of(joint.tip.square);
        fix = -(dot(tip, joint.tip.velocity) * inverse);
        tip += fix * joint.tip.velocity;
        if (joint.tip.aligned) tip[*joint.tip.aligned] = Value();
      } else if (turns) {
        fix = -dot(link.axis, twist.angular);
        tip += fix * joint.tip.velocity;
      }
      (turns ? twist.angular : twist.linear) += fix * link.axis;
    }
    return motions;
  }

  std::vector<Answer> answers_of(std::size_t k, const std::vector<Square>& squares) {
    const Link& link = links_[k];
    JointSolution& joint = done_[k];
    joint.tip = tip_of(k);
    const std::array<UnitMotion, components> motions = unit_motions(k);
    Twist own;
    (link.joint == JointKind::revolute ? own.angular : own.linear) = link.axis;
    std::vector<Answer> answers;
    for (const Square& square : squares) {
      const Vector arm = arm_of(square.carried);
      const auto answer = [&](const Twist& twist, const Vector& velocity) {
        Value sum = dot(square.angular, twist.angular);
        sum += dot(square.linear, velocity);
        return flattening_.cheaper(sum);
      };
      Answer all{square.weight, square.force, {}, {}, {}};
      for (std::size_t j = 0; j < components; ++j) {
        if (is_free(link) && is_along(link, j)) continue;  // where the joint gives way, nothing is felt
        const auto& [twist, tip] = motions[j];
        const bool at_tip = square.carried != 0 && square.carried == joint.tip.link;
        all.of[j] = program_.bind(answer(twist, at_tip ? tip : twist.linear + cross(twist.angular, arm)));
      }
      if (is_free(link)) all.joint_sum = answer(own, own.linear + cross(own.angular, arm));
      all.joint = program_.bind(all.joint_sum);
      answers.push_back(std::move(all));
    }
    return answers;
  }

  /// c_rj and g_j; D and 1/D, zero where the joint moves none of them.
  std::pair<Value, Value> eliminate(std::vector<Answer>& answers, std::array<Value, components>& gain) {
    Value pivot;
    std::vector<Value> pulls;
    for (const Answer& answer : answers) {
      pulls.push_back(program_.bind(answer.weight * answer.joint));
      pivot += pulls.back() * answer.joint;
    }
    if (pivot.is_zero()) return {};
    pivot = program_.bind(pivot, "pivot");
    const Value inverse = inverse_of(pivot);
    for (std::size_t j = 0; j < components; ++j) {
      gain[j] = projected(answers, pulls, j, inverse);
      for (Answer& answer : answers) answer.of[j] = less(answer.of[j], gain[j], answer.joint);
    }
    return {pivot, inverse};
  }

  Value projected(const std::vector<Answer>& answers, const std::vector<Value>& pulls, std::size_t j,
                  const Value& inverse) {
    Value common;
    for (std::size_t r = 0; r < answers.size(); ++r) common += pulls[r] * answers[r].of[j];
    common = program_.bind(flattening_.cheaper(common));
    return common.is_zero() ? Value() : program_.bind(flattening_.cheaper(common * inverse));
  }

  /// What D is made of, without what cancels in c_r s: an angle that locks the joint is told from a small inertia.
  Value made_of(const std::vector<Answer>& answers) {
    Value sum;
    for (const Answer& answer : answers) {
      const std::vector<Term>& terms = answer.joint_sum.polynomial().terms();
      for (const Term& term : terms) {
        const Value part = terms.size() == 1 ? answer.joint : Value(program_, Polynomial(term), answer.joint.unit());
        sum += program_.bind(answer.weight * part) * part;
      }
    }
    return program_.bind(sum);
  }

  /// The effort Q of the joint, which works on its rate, ρ_j in X_j: a square without weight. Its reaction on the parent
  /// comes of that.
  void add_effort(std::size_t k, std::vector<Answer>& answers) {
    const auto place = static_cast<std::size_t>(std::find(joints_.joints.begin(), joints_.joints.end(), k) -
                                                joints_.joints.begin());
    Value effort;
    for (std::size_t i = 0; i < efforts_.size(); ++i) {
      const Number& rate = joints_.inverse[i][place];
      if (!rate.is_zero()) effort += rate * efforts_[i];
    }
    if (effort.is_zero()) return;
    const Value one = program_.number(Number(1));
    answers.push_back({{}, program_.bind(effort), done_[k].fix, one, one});
  }

  void give_way(std::size_t k, std::vector<Answer>& answers) {
    JointSolution& joint = done_[k];
    const Value scale = made_of(answers);
    const auto [pivot, inverse] = eliminate(answers, joint.gain);
    solution_.pivots.push_back({pivot, scale});
    if (pivot.is_zero()) return;  // identically singular: the caller's test of the pivot fails
    Value effort;
    for (const Answer& answer : answers) effort += answer.joint * answer.force;
    joint.along = program_.bind(program_.bind(effort) * inverse);
    for (Answer& answer : answers) {
      const Value pull = program_.bind(answer.weight * answer.joint);
      answer.force = less(answer.force, joint.along, pull);
    }
  }

  static constexpr std::array<std::size_t, components> order{3, 4, 5, 0, 1, 2};

  /// The components in which these answer by themselves.
  std::vector<std::size_t> pivots_of(std::vector<Answer> answers) {
    std::vector<std::size_t> pivots;
    for (const std::size_t p : order) {
      Value total;
      for (const Answer& answer : answers) total += program_.bind(answer.weight * answer.of[p]) * answer.of[p];
      if (total.is_zero() || identically_zero(total)) {
        for (Answer& answer : answers) answer.of[p] = Value();
        continue;
      }
      pivots.push_back(p);
      take(answers, p, program_.bind(total));
    }
    return pivots;
  }

  /// Leaves of all answers what is orthogonal to component p, and of the forces what that does not yield to.
  Square take(std::vector<Answer>& answers, std::size_t p, const Value& total) {
    Square square{total, {}, {}, {}};
    const Value inverse = inverse_of(total);
    std::vector<Value> pulls;
    for (const Answer& answer : answers) {
      pulls.push_back(program_.bind(answer.weight * answer.of[p]));
      square.force += answer.of[p] * answer.force;
    }
    square.force = program_.bind(square.force);
    component(square.angular, square.linear, p) = program_.number(Number(1));
    for (std::size_t j = 0; j < components; ++j) {
      if (j == p) continue;
      const Value share = projected(answers, pulls, j, inverse);
      component(square.angular, square.linear, j) = share;
      for (Answer& answer : answers) answer.of[j] = less(answer.of[j], share, answer.of[p]);
    }
    const Value response = program_.bind(square.force * inverse);
    for (std::size_t r = 0; r < answers.size(); ++r) {
      answers[r].force = less(answers[r].force, response, pulls[r]);
      answers[r].of[p] = Value();
    }
    return square;
  }

  /// One square for each pivot, and what the pivots leave.
  std::vector<Square> gathered(std::vector<Answer>& answers, const std::vector<std::size_t>& pivots) {
    std::vector<Square> squares;
    for (const std::size_t p : pivots) {
      Value total;
      for (const Answer& answer : answers) total += program_.bind(answer.weight * answer.of[p]) * answer.of[p];
      squares.push_back(take(answers, p, program_.bind(total)));
    }
    std::vector<Value> left;
    for (const Answer& answer : answers) left.insert(left.end(), answer.of.begin(), answer.of.end());
    clear_identically_zero(left);
    for (std::size_t r = 0; r < answers.size(); ++r) {
      Square square{answers[r].weight, answers[r].force, {}, {}};
      bool any = false;
      for (std::size_t j = 0; j < components; ++j) {
        const Value& value = left[r * components + j];
        component(square.angular, square.linear, j) = value;
        any = any || !value.is_zero();
      }
      if (any) squares.push_back(std::move(square));
    }
    return squares;
  }

  // ---- from the ground to the tips ----

  void accelerate() {
    std::vector<Vector> angular(links_.size()), linear(links_.size()), at_tip(links_.size());
    std::vector<Value> joints(links_.size());
    for (std::size_t k = 1; k < links_.size(); ++k) {
      const Link& link = links_[k];
      const JointSolution& joint = done_[k];
      const auto parent = static_cast<std::size_t>(link.parent);
      const Vector origin = done_[parent].tip.link == k
                                ? at_tip[parent]
                                : bound(program_, linear[parent] + cross(angular[parent], arm_of(k)));
      Vector turning = bound(program_, tree_.from_parent(link, angular[parent]));
      Vector moving = bound(program_, tree_.from_parent(link, origin));
      angular[k] = turning;
      linear[k] = moving;
      Value along = joint.along, fixed;
      if (is_free(link)) {
        for (std::size_t j = 0; j < components; ++j) {
          fixed += joint.fix[j] * component(turning, moving, j);
          if (!is_along(link, j)) along -= joint.gain[j] * component(turning, moving, j);
        }
        along = program_.bind(along);
        joints[k] = along + fixed;  // a sum: what the parent turns by, which it takes away, is added again below
        Vector& moved = link.joint == JointKind::revolute ? angular[k] : linear[k];
        for (int i = 0; i < 3; ++i) {
          const Value& axis = link.axis[i];
          moved[i] += axis.is_constant() ? axis.polynomial().constant() * joints[k] : axis * joints[k];
        }
        moved = bound(program_, moved);
      }
      if (joint.tip.link == 0) continue;
      Vector there = linear[k] + cross(angular[k], joint.tip.arm);
      if (is_free(link) && joint.tip.aligned) {
        there = moving + cross(turning, joint.tip.arm);
        there[*joint.tip.aligned] = along * joint.tip.velocity[*joint.tip.aligned];
      }
      at_tip[k] = bound(program_, there);
    }
    for (std::size_t i = 0; i < efforts_.size(); ++i) {
      Value sum;
      for (std::size_t place = 0; place < joints_.joints.size(); ++place) {
        const Number& rate = joints_.inverse[i][place];
        if (rate.is_zero()) continue;
        const std::size_t k = joints_.joints[place];
        sum += rate * (joints[k] + reference_.joints[k]);
      }
      solution_.accelerations.push_back(program_.bind(cancelled(program_, sum)));
    }
  }

  const BodyTree& tree_;
  Program& program_ = tree_.program();
  const std::vector<Link>& links_ = tree_.links();
  const JointCoordinates& joints_;
  const std::vector<Value>& efforts_;
  const std::map<int, Wrench>& wrenches_;
  Flattening flattening_;
  std::vector<CentralBody> bodies_;
  ReferenceMotion reference_;
  std::vector<std::vector<Square>> handed_;  ///< to the parent, by link
  std::vector<JointSolution> done_;
  ForwardSolution solution_;
};

}  // namespace

ForwardSolution factored_forward(const BodyTree& tree, const JointCoordinates& joints, const std::vector<Value>& efforts,
                                 const std::map<int, Wrench>& wrenches) {
  return FactoredRecursion(tree, joints, efforts, wrenches).run();
}

}  // namespace torsor
