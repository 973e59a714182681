// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/model.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/expression/expression_derivative.hpp"
#include "torsor/generator/mechanics/freedom_positions.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {

Program::Resolver Model::resolver(const Scene& scene, const ModelOptions& options) {
  const SceneContent* content = &scene.content();
  return [content, options](const SymbolPointer& symbol) -> std::optional<Expression> {
    const bool has_value = (!options.symbolic_parameters && !options.all_run_time) || options.valued.contains(symbol->name);
    if (symbol->kind == SymbolKind::parameter && has_value) {
      for (const ParameterContent& parameter : content->parameters) {
        if (parameter.symbol != symbol) continue;
        if (!parameter.value) return std::nullopt;
        const bool kept = parameter.run_time || options.run_time.contains(symbol->name);
        if (kept && !options.valued.contains(symbol->name)) return std::nullopt;
        // A plain number is understood in the parameter's own unit.
        const bool plain = parameter.value->unit().is_dimensionless();
        return plain ? *parameter.value * Expression::quantity(Number(1), symbol->unit) : *parameter.value;
      }
    }
    for (const CoordinateContent& coordinate : content->coordinates) {
      const bool ours = coordinate.q == symbol || coordinate.v == symbol || coordinate.a == symbol;
      if (!ours) continue;
      if (coordinate.released && options.hold_released) return Expression(0);
      if (!coordinate.law) return std::nullopt;
      if (coordinate.q == symbol) return *coordinate.law;
      return coordinate.v == symbol ? rate(*coordinate.law) : rate(rate(*coordinate.law));
    }
    return std::nullopt;
  };
}

std::vector<SymbolPointer> run_time_parameters(const Scene& scene, const ModelOptions& options) {
  std::vector<SymbolPointer> symbols;
  for (const ParameterContent& parameter : scene.content().parameters) {
    const bool valued = parameter.value && options.valued.contains(parameter.symbol->name);
    const bool kept = !valued && (parameter.run_time || !parameter.value || options.all_run_time || options.symbolic_parameters ||
                                  options.run_time.contains(parameter.symbol->name));
    if (kept) symbols.push_back(parameter.symbol);
  }
  return symbols;
}

ModelOptions as_given(ModelOptions options) {
  options.passes.reframing = options.passes.regrouping = options.passes.off_axis = options.passes.length_unit =
      options.passes.products = false;
  return options;
}

Model::Model(const Scene& scene, Program& program, const ModelOptions& options)
    : BodyTree(scene.content(), program), options_(options) {
  program.set_measurer({[this](const Symbol& symbol) { return measured(symbol); },
                        [this](std::size_t size) { std::erase_if(measured_, [size](const auto& each) { return each.second.size > size; }); }});
  add_coordinates();
  add_links();
  gather_bodies();
  trees_.emplace(BodyTrees{*this, *this, *this});
  Passes passes = options_.passes;
  passes.reframing = passes.reframing && !options_.symbolic_parameters;
  run_passes(passes, *trees_);
}

void Model::add_coordinates() {
  for (const CoordinateContent& c : scene_->coordinates) {
    if (c.unknown()) coordinates_.push_back(c);
  }
  unknown_count_ = static_cast<int>(coordinates_.size());
  for (const CoordinateContent& c : scene_->coordinates) {
    if (c.released && !c.law) coordinates_.push_back(c);
  }
}

void Model::set_motion(Link& link, const FrameContent& frame) {
  Program& program = *program_;
  const Vector axis = lower(program, frame.axis);
  const Value square = dot(axis, axis);
  if (square.is_zero()) {
    throw SceneError(fmt::format("the axis of joint '{}' is the null vector: give a direction", frame.name));
  }
  const Value norm = program.sqrt(square);
  for (int i = 0; i < 3; ++i) link.axis[i] = axis[i].is_zero() ? Value() : axis[i] / norm;
  int negative = 1;
  for (int i = 0; i < 3; ++i) {
    const Vector& n = link.axis;
    if (!n[(i + 1) % 3].is_zero() || !n[(i + 2) % 3].is_zero()) continue;
    link.aligned = i;
    negative = n[i].is_number(-1) ? -1 : 1;
  }
  link.joint = frame.joint;
  link.displacement = of_configuration(frame.displacement, "the displacement of " + scene_->name_of(frame));
  link.rate = time_derivative(link.displacement.program() ? link.displacement : program.number(Number()));
  link.acceleration = time_derivative(link.rate);
  if (frame.joint == JointKind::revolute) {
    link.turn = link.aligned ? Turn::aligned : Turn::general;
    link.angle = Number(negative) * link.displacement;
    link.sine = program.sin(link.angle);
    link.cosine = program.cos(link.angle);
    if (!link.aligned) {  // Rodrigues: R = c 1 + s [n] + (1 - c) n nᵀ
      const Value one = program.number(Number(1));
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          const Value nn = link.axis[i] * link.axis[j];
          Value entry = nn - nn * link.cosine;
          if (i == j) entry += link.cosine;
          if (i != j) {
            const int k = 3 - i - j;
            const bool positive = (j - i + 3) % 3 == 2;  // [n]_ij = -n_k for (i, j) in cyclic order
            entry += Number(positive ? 1 : -1) * (link.axis[k] * link.sine);
          }
          link.rotation(i, j) = program.bind(entry);
        }
      }
    }
  }
  const std::vector<Value> all = partials(frame.displacement);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].is_zero()) link.partials.emplace_back(static_cast<int>(i), program.bind(all[i]));
  }
}

void Model::add_attitude(const FrameContent& frame, const FramePlace& at) {
  Program& program = *program_;
  const Value one = program.number(Number(1));
  const auto& e = scene_->attitudes[as_index(*frame.attitude)].symbols->e;
  const auto twice = [&](std::size_t i, std::size_t j) {
    return program.bind(Number(2) * program.symbol(e[i]) * program.symbol(e[j]));
  };
  Matrix rotation;  // R_ii = 1 − 2 (e_j² + e_k²), R_ij = 2 (e_i e_j ∓ e_w e_k)
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const auto ui = static_cast<std::size_t>(i) + 1;
    const auto uj = static_cast<std::size_t>(j) + 1;
    const auto uk = static_cast<std::size_t>(k) + 1;
    const Value jj = twice(uj, uj);
    const Value kk = twice(uk, uk);
    const Value ij = twice(ui, uj);
    const Value wk = twice(0, uk);
    rotation(i, i) = program.bind(one - jj - kk);
    rotation(i, j) = program.bind(ij - wk);
    rotation(j, i) = program.bind(ij + wk);
  }
  int component = 0;
  for (std::size_t i = 0; i < coordinates_.size(); ++i) {
    const CoordinateContent& c = coordinates_[i];
    if (c.attitude != frame.attitude) continue;
    Link link;
    link.name = component == 2 ? frame.name : c.q->name;
    link.joint = JointKind::revolute;
    link.axis[component] = one;
    link.aligned = component;
    link.in_group = component;
    link.rate = program.symbol(c.v);
    link.acceleration = program.symbol(c.a);
    link.partials.emplace_back(static_cast<int>(i), one);
    link.parent = component == 0 ? at.link : static_cast<int>(links_.size()) - 1;
    if (component == 0) {
      link.placement_rotation = at.rotation;
      link.placement_origin = at.origin;
      link.turn = Turn::general;
      link.rotation = rotation;
    }
    links_.push_back(link);
    ++component;
  }
}

std::vector<SymbolPointer> Model::positions() const {
  std::vector<SymbolPointer> symbols;
  for (int i = 0; i < unknown_count_; ++i) {
    const auto own = positions_with(*scene_, coordinates_[static_cast<std::size_t>(i)]);
    symbols.insert(symbols.end(), own.begin(), own.end());
  }
  return symbols;
}

Value Model::of_configuration(const Expression& formula, const std::string& user) const {
  const Value value = program_->lower(formula);
  if (value.is_constant() || program_->stage(value) <= Stage::configuration) return value;
  throw SceneError(fmt::format("{} depends on velocities, accelerations or forces through {}: it must be a formula of "
                               "coordinates, time and parameters",
                               user, formula.to_string()));
}

std::vector<Value> Model::partials(const Expression& e) const {
  const Value value = program_->lower(e);
  std::vector<Value> result;
  for (const CoordinateContent& c : coordinates_) {
    if (c.released && options_.hold_released) {  // a zero in the program: the formula itself is differentiated
      const Expression partial = partial_derivative(e, c.q);
      const bool none = partial.is_zero();
      const bool whole = e.as_symbol() == c.q;
      result.push_back(none ? Value() : whole ? program_->number(Number(1)) : program_->lower(partial));
    } else {
      result.push_back(derivation_along(*program_, c.v)(value));
    }
  }
  return result;
}

void Model::add_links() {
  const auto& frames = scene_->frames;
  places_.resize(frames.size());
  std::vector<bool> done(frames.size(), false);
  links_.push_back({});
  links_[0].name = "ground";
  done[0] = true;
  for (std::size_t remaining = frames.size() - 1; remaining > 0;) {
    const std::size_t before = remaining;
    for (std::size_t f = 1; f < frames.size(); ++f) {
      const FrameContent& frame = frames[f];
      const auto parent = static_cast<std::size_t>(scene_->frame_index(*frame.parent, "joint '" + frame.name + "'"));
      if (done[f] || !done[parent] || !is_placed(frame.displacement, done)) continue;
      done[f] = true;
      --remaining;
      const FramePlace base = places_[parent];
      FramePlace here;
      here.link = base.link;
      here.rotation = base.rotation * frame.placement.rotation;
      here.origin = base.origin + base.rotation * lower(*program_, frame.placement.origin);
      if (frame.joint == JointKind::attitude) {
        add_attitude(frame, here);
        here = {static_cast<int>(links_.size()) - 1, Rotation(), Vector()};
      } else if (frame.joint != JointKind::weld) {
        Link link;
        link.name = frame.name;
        link.parent = here.link;
        link.placement_rotation = here.rotation;
        link.placement_origin = here.origin;
        set_motion(link, frame);
        links_.push_back(link);
        here = {static_cast<int>(links_.size()) - 1, Rotation(), Vector()};
      }
      places_[f] = here;
    }
    if (remaining == before) {
      for (std::size_t f = 1; f < frames.size(); ++f) {
        if (done[f]) continue;
        throw SceneError(fmt::format("frame '{}' hangs on itself: its chain of parents never reaches the ground; close "
                                     "a loop with a constraint instead",
                                     frames[f].name));
      }
    }
  }
}

std::vector<SymbolPointer> Model::inputs() const {
  std::vector<SymbolPointer> symbols;
  for (const ActionContent& action : scene_->actions) {
    if (const auto* motor = std::get_if<Motor>(&action)) symbols.push_back(motor->input);
  }
  return symbols;
}

}  // namespace torsor
