// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/fixed_axis_momenta.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/geometry/quaternion.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

/// A field of displacements: ξ_i along freedom i, and what it makes of the velocities of lengths that turn with it.
struct Turn {
  std::vector<Value> along, of_velocity;
};

/// What stands before a frame's attitude: the frame whose axes are fixed to it, and lengths along them.
struct Base {
  std::string frame;
  std::array<SymbolPointer, 3> lengths;
  bool from_its_origin = true;  ///< the lengths lead from there
  [[nodiscard]] bool turns_about(std::size_t d) const {
    return lengths[(d + 1) % 3] != nullptr && lengths[(d + 2) % 3] != nullptr;
  }
};

class FixedAxes {
 public:
  FixedAxes(const Equations& equations, const NaturalLanguage& say)
      : equations_(equations), model_(equations.model()), say_(say), kinetic_(kinetic_energy(model_)) {
    for (int i = 0; i < model_.unknown_count(); ++i) velocities_.push_back(model_.coordinates()[as_index(i)].v);
    momenta_ = gradient(kinetic_, velocities_);
    along_q_ = gradient_along(kinetic_, velocities_);
    Value u = gravity_force_function(model_);
    u += equations.actions().spring_force_function;
    if (!u.is_zero()) of_u_ = gradient_along(u, velocities_);
    others_ = applied_forces(model_, applied_actions(model_, ActionKind::without_force_function));
  }

  std::vector<FixedAxisMomentum> operator()() const {
    std::vector<FixedAxisMomentum> result;
    if (kinetic_.is_zero()) return result;
    for (std::size_t k = 0; k < model_.scene().attitudes.size(); ++k) {
      const AttitudeContent& attitude = model_.scene().attitudes[k];
      const std::optional<Base> base = base_of(k);
      if (!base || !place(attitude.symbols->omega[0])) continue;
      for (std::size_t d = 0; d < 3; ++d) {
        FixedAxisMomentum own = judged(turn(attitude, nullptr, d));
        if (!own.reasons.empty() && base->turns_about(d)) {
          FixedAxisMomentum whole = judged(turn(attitude, &*base, d));
          whole.about_base = true;
          for (const std::size_t across : {std::min((d + 1) % 3, (d + 2) % 3), std::max((d + 1) % 3, (d + 2) % 3)}) {
            if (!base->from_its_origin) whole.zero.push_back(base->lengths[across]->name);
          }
          if (whole.reasons.empty()) own = std::move(whole);
        }
        own.frame = attitude.frame;
        own.base = base->frame;
        own.axis = std::string(1, "xyz"[d]);
        result.push_back(std::move(own));
      }
    }
    return result;
  }

 private:
  std::optional<std::size_t> place(const SymbolPointer& velocity) const {
    const auto found = std::find(velocities_.begin(), velocities_.end(), velocity);
    if (found == velocities_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - velocities_.begin());
  }

  // From the frame that turns up through frames that slide along single axes.
  std::optional<Base> base_of(std::size_t attitude) const {
    const SceneContent& scene = model_.scene();
    const auto turned = std::find_if(scene.frames.begin(), scene.frames.end(),
                                     [&](const FrameContent& f) { return f.attitude == static_cast<int>(attitude); });
    if (turned == scene.frames.end() || !turned->parent || !turned->placement.rotation.is_identity()) return std::nullopt;
    Base base;
    base.from_its_origin = is_zero(turned->placement.origin);
    const FrameContent* frame = &parent_of(*turned);
    while (frame->parent && frame->joint == JointKind::prismatic && frame->placement.rotation.is_identity()) {
      const std::optional<std::size_t> d = axis_of(*frame);
      const SymbolPointer length = frame->displacement.as_symbol();
      if (!d || base.lengths[*d] || !length || !length->rate || !place(length->rate)) break;
      base.lengths[*d] = length;
      base.from_its_origin = base.from_its_origin && is_zero(frame->placement.origin);
      frame = &parent_of(*frame);
    }
    base.frame = frame->name;
    return base;
  }
  static bool is_zero(const Triple& place) {
    return std::all_of(place.begin(), place.end(), [](const Expression& each) { return each.is_zero(); });
  }
  const FrameContent& parent_of(const FrameContent& frame) const {
    const SceneContent& scene = model_.scene();
    return scene.frames[as_index(scene.frame_index(*frame.parent, frame.name))];
  }
  std::optional<std::size_t> axis_of(const FrameContent& frame) const {
    for (std::size_t d = 0; d < 3; ++d) {
      const bool others_are_zero = frame.axis[(d + 1) % 3].is_zero() && frame.axis[(d + 2) % 3].is_zero();
      if (others_are_zero && (model_.program().lower(frame.axis[d]) - model_.program().number(Number(1))).is_zero()) return d;
    }
    return std::nullopt;
  }

  Turn turn(const AttitudeContent& attitude, const Base* base, std::size_t d) const {
    Program& program = model_.program();
    Turn turn{std::vector<Value>(velocities_.size()), std::vector<Value>(velocities_.size())};
    const auto& e = attitude.symbols->e;
    const Quaternion p{program.symbol(e[0]), {program.symbol(e[1]), program.symbol(e[2]), program.symbol(e[3])}};
    const Matrix rotation = rotation_matrix(program, p);
    for (std::size_t i = 0; i < 3; ++i) {
      turn.along[*place(attitude.symbols->omega[i])] = rotation(static_cast<int>(d), static_cast<int>(i));
    }
    if (base == nullptr) return turn;
    // d ∧ r: of the lengths behind d in turn, the first has minus the second, the second has the first.
    const SymbolPointer& first = base->lengths[(d + 1) % 3];
    const SymbolPointer& second = base->lengths[(d + 2) % 3];
    const std::size_t i = *place(first->rate), j = *place(second->rate);
    turn.along[i] = -program.symbol(second);
    turn.along[j] = program.symbol(first);
    turn.of_velocity[i] = -program.symbol(second->rate);
    turn.of_velocity[j] = program.symbol(first->rate);
    return turn;
  }

  static Value work(const std::vector<Value>& along, const std::vector<Value>& forces) {
    Value sum;
    for (std::size_t i = 0; i < along.size(); ++i) {
      if (!along[i].is_zero() && !forces[i].is_zero()) sum += along[i] * forces[i];
    }
    return sum;
  }
  static bool acts(const Value& value) { return value.program() != nullptr && !identically_zero(value); }

  FixedAxisMomentum judged(const Turn& turn) const {
    FixedAxisMomentum result;
    result.momentum = work(turn.along, momenta_);
    if (result.momentum.program() == nullptr) result.reasons.push_back(say_("T has no momentum along it"));
    Value change = work(turn.along, along_q_);
    change += work(turn.of_velocity, momenta_);
    if (acts(change)) result.reasons.push_back(say_("T depends on it"));
    if (!of_u_.empty() && acts(work(turn.along, of_u_))) result.reasons.push_back(say_("U depends on it"));
    bool forces = acts(work(turn.along, others_));
    for (const auto& input : equations_.actions().inputs) forces = forces || acts(work(turn.along, input));
    for (const ConstraintRow& row : equations_.constraints()) forces = forces || acts(work(turn.along, row.column));
    if (forces) result.reasons.push_back(say_("forces act along it"));
    return result;
  }

  const Equations& equations_;
  const Model& model_;
  const NaturalLanguage& say_;
  Value kinetic_;
  std::vector<SymbolPointer> velocities_;
  std::vector<Value> momenta_, along_q_, of_u_, others_;
};

}  // namespace

std::vector<FixedAxisMomentum> fixed_axis_momenta(const Equations& equations, const NaturalLanguage& say) {
  return FixedAxes(equations, say)();
}

}  // namespace torsor
