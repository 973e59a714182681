// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/contacts.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/motion/relative_motion.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

class ContactBuilder {
 public:
  ContactBuilder(const Model& model, const ContactContent& contact, Derivation& at_constant_velocity)
      : model_(model),
        program_(model.program()),
        contact_(contact),
        user_("contact '" + contact.name + "'"),
        at_constant_velocity_(at_constant_velocity) {
    rows_.name = contact.name;
  }

  void operator()(const PointOnPlane& on) {
    const FramePlace& plane = model_.place(on.plane, user_);
    const int axes = plane.link;
    const Vector normal = bound(program_, model_.express(axis::z, on.plane, axes, user_));
    // Not bound: from the centre of a round body its way to the point is then a constant, not a difference of places.
    const Vector point = model_.locate(on.point, axes, user_);
    const SceneContent& scene = model_.scene();
    const PointContent& content = scene.points[static_cast<std::size_t>(scene.point_index(on.point, user_))];
    if (content.lowest) {
      if (scene.frame_index(content.lowest->plane, user_) != scene.frame_index(on.plane, user_)) {
        throw SceneError(fmt::format("{} is between the point '{}', which is the lowest over another plane, and this one: "
                                     "declare the point of contact for the plane that it touches",
                                     user_, content.name));
      }
      opens(model_.lowest_height(content, axes, user_));
    } else {
      const Vector height = bound(program_, point - plane.origin);
      opens(dot(height, normal));
    }
    if (!has_friction()) return;
    const Surfaces at = surfaces(on);
    for (std::size_t k = 0; k < 2; ++k) slips(at.motion, at.tangents, k, program_.lower(on.belt[k]));
  }

  void operator()(const SphereOnSphere& spheres) {
    const Value radius_a = program_.lower(spheres.radius_a), radius_b = program_.lower(spheres.radius_b);
    const Value distance = line(spheres).second;
    Value gap = distance - radius_a - radius_b;
    if (spheres.hollow) gap = radius_b - radius_a - distance;
    opens(gap);
    if (!has_friction()) return;
    const Surfaces at = surfaces(spheres);
    for (std::size_t k = 0; k < at.tangents.size(); ++k) slips(at.motion, at.tangents, k, {});
  }

  void operator()(const Stop& stop) {
    const Value displacement = model_.of_configuration(stop.displacement, user_);
    const Value at = model_.of_configuration(stop.at, user_);
    opens(Number(stop.sign) * (displacement - at));
  }

  void operator()(const FrictionAlong& friction) {
    rows_.normal = false;
    add(program_.bind(time_derivative(model_.of_configuration(friction.displacement, user_))),
        model_.partials(friction.displacement));
  }

  void operator()(const FrictionInJoint& friction) {
    rows_.normal = false;
    rows_.joint = model_.place(friction.frame, user_).link;
    const Link& link = model_.links()[static_cast<std::size_t>(*rows_.joint)];
    std::vector<Value> partials(static_cast<std::size_t>(model_.unknown_count()));
    for (const auto& [i, partial] : link.partials) {
      if (i < model_.unknown_count()) partials[static_cast<std::size_t>(i)] = partial;
    }
    add(link.rate, std::move(partials));
    if (can_move(rows_.rows[0])) return;
    throw SceneError(fmt::format("{} is in a joint that no coordinate moves: nothing can slide in it", user_));
  }

  void operator()(const TurnOnContact& turn) {
    rows_.normal = false;
    rows_.pressed_by = turn.contact;
    const ContactGeometry& geometry = model_.scene().contacts[turn.contact].geometry;
    const auto* on = std::get_if<PointOnPlane>(&geometry);
    const Surfaces at = on != nullptr ? surfaces(*on) : surfaces(std::get<SphereOnSphere>(geometry));
    for (const Vector& about : turn.spinning ? std::vector<Vector>{at.normal} : at.tangents) {
      add(program_.bind(dot(at.motion.twist().angular, about)), at.motion.generalised_forces({Vector(), about}));
      if (!can_move(rows_.rows.back())) rows_.rows.pop_back();
    }
    if (!rows_.rows.empty()) return;
    throw SceneError(fmt::format("{} resists a turn that nothing can make: leave its length out", user_));
  }

  ContactRows take() { return std::move(rows_); }

  ContactPlace place() const {
    ContactPlace result;
    result.directions.resize(rows_.rows.size());
    const auto* on = std::get_if<PointOnPlane>(&contact_.geometry);
    const auto* spheres = std::get_if<SphereOnSphere>(&contact_.geometry);
    if (on == nullptr && spheres == nullptr) return result;
    const Surfaces at = on != nullptr ? surfaces(*on, 0) : surfaces(*spheres);
    result.point = model_.locate(at.point, 0);
    for (std::size_t row = 0; row < rows_.rows.size(); ++row) {
      result.directions[row] = row == 0 ? at.normal : at.tangents[rows_.rows[row].tangent];
    }
    return result;
  }

 private:
  bool has_friction() const { return !contact_.friction.is_zero() || !contact_.static_friction.is_zero(); }

  /// Two surfaces at the point where they touch, in the axes of the motion.
  struct Surfaces {
    RelativeMotion motion;
    Vector normal;
    std::vector<Vector> tangents;
    SeenPoint point;
  };
  Surfaces surfaces(const PointOnPlane& on) const { return surfaces(on, model_.place(on.plane, user_).link); }
  Surfaces surfaces(const PointOnPlane& on, int axes) const {
    const int plane = model_.place(on.plane, user_).link;
    const SceneContent& scene = model_.scene();
    const PointContent& content = scene.points[static_cast<std::size_t>(scene.point_index(on.point, user_))];
    const int link = model_.place(content.frame, user_).link;
    const SeenPoint point = model_.see(on.point, axes, user_);
    return {RelativeMotion(model_, link, plane, point),
            bound(program_, model_.express(axis::z, on.plane, axes, user_)),
            {bound(program_, model_.express(axis::x, on.plane, axes, user_)),
             bound(program_, model_.express(axis::y, on.plane, axes, user_))},
            point};
  }
  Surfaces surfaces(const SphereOnSphere& spheres) const {
    const FramePlace& at_a = model_.place(spheres.a, user_);
    const auto [apart, distance] = line(spheres);
    const Vector n = bound(program_, pow(distance, -1) * apart);
    const SeenPoint point{{at_a.link, at_a.origin}, 0, -(program_.lower(spheres.radius_a) * n)};
    const int link_b = model_.place(spheres.b, user_).link;
    return {RelativeMotion(model_, at_a.link, link_b, point), n, tangents_across(n), point};
  }

  /// From the centre of the second sphere to that of the first, back where it is hollow, and the distance.
  std::pair<Vector, Value> line(const SphereOnSphere& spheres) const {
    const FramePlace& at_a = model_.place(spheres.a, user_);
    const FramePlace& at_b = model_.place(spheres.b, user_);
    const GeometricPoint a{at_a.link, at_a.origin}, b{at_b.link, at_b.origin};
    const Vector apart = bound(program_, spheres.hollow ? model_.between(a, b, 0) : model_.between(b, a, 0));
    const Value radius_b = program_.lower(spheres.radius_b);
    Value square = dot(apart, apart);
    // A pin in the middle of its hole has no normal: at 1e-15 of the radius, whose square floats hold too, nothing but 0/0
    // changes.
    if (spheres.hollow) square += program_.number(Number(10).pow(-30)) * (radius_b * radius_b);
    return {apart, program_.sqrt(square)};
  }

  void opens(const Value& gap) {
    rows_.gap = program_.bind(gap);
    std::vector<Value> jacobian;
    for (int i = 0; i < model_.unknown_count(); ++i) {
      Derivation along = model_.along(i);
      jacobian.push_back(program_.bind(along(rows_.gap)));
    }
    add(program_.bind(time_derivative(rows_.gap)), std::move(jacobian));
    if (can_move(rows_.rows[0])) return;
    throw SceneError(fmt::format("{} involves no coordinate: nothing can open or close it; name bodies that move on each "
                                 "other",
                                 user_));
  }

  void slips(const RelativeMotion& motion, const std::vector<Vector>& tangents, std::size_t k, const Value& belt) {
    const Value rate = program_.bind(dot(motion.twist().linear, tangents[k]));
    add(belt.is_zero() ? rate : program_.bind(rate - belt), motion.generalised_forces({tangents[k], Vector()}));
    rows_.rows.back().tangent = k;
    if (!can_move(rows_.rows.back())) rows_.rows.pop_back();
  }

  void add(Value rate, std::vector<Value> jacobian) {
    jacobian.resize(static_cast<std::size_t>(model_.unknown_count()));
    clear_identically_zero(jacobian);
    const Value drift = program_.bind(at_constant_velocity_(rate));
    rows_.rows.push_back({std::move(rate), std::move(jacobian), drift, 0});
  }

  static bool can_move(const ContactRow& row) {
    return std::any_of(row.jacobian.begin(), row.jacobian.end(), [](const Value& entry) { return !entry.is_zero(); });
  }

  std::vector<Vector> tangents_across(const Vector& n) const {
    const auto basis = [this](int i) {
      Vector e;
      e[i] = program_.number(Number(1));
      return e;
    };
    for (const int i : {1, 2, 0}) {
      if (!identically_zero(n[i])) continue;
      const Vector in_plane = bound(program_, cross(basis(i), n));
      return {in_plane, basis(i)};
    }
    // Axes in space have a pole, where they turn without end as n passes (there is no field of directions on a sphere). It is put
    // two degrees away from every direction whose components are as integers up to 12: bodies that are placed by hand do not
    // have their normal there. The axes here are those of a matrix of rational numbers, turned about n × c until the first of
    // them, c, is n. 1 + c · n is |n + c|²/2, which has its digits near the pole too.
    static constexpr int axes[3][3] = {{305943, -350670, 939626}, {676374, -653210, -464007}, {740530, 741495, 35610}};
    const auto axis_along = [this](int k) {
      Vector along;
      for (int i = 0; i < 3; ++i) along[i] = program_.number(Number(axes[k][i]) / Number(1048555));
      return along;
    };
    const Vector c = axis_along(0), half = bound(program_, n + c);
    const Value scale = program_.bind(program_.number(Number(2)) * pow(dot(half, half), -1));
    std::vector<Vector> tangents;
    for (const int k : {1, 2}) {
      const Vector along = axis_along(k);
      const Value part = program_.bind(scale * dot(along, n));
      tangents.push_back(bound(program_, along - part * half));
    }
    return tangents;
  }

  const Model& model_;
  Program& program_;
  const ContactContent& contact_;
  std::string user_;
  Derivation& at_constant_velocity_;
  ContactRows rows_;
};

/// What `take` makes of each contact of the scene.
template <class Take>
auto of_contacts(const Model& model, const Take& take) {
  Program& program = model.program();
  Derivation at_constant_velocity(
      program,
      [&program](const SymbolPointer& symbol) -> Value {
        if (symbol->kind == SymbolKind::time) return program.number(Number(1));
        if (symbol->kind == SymbolKind::coordinate) return rate_of(program, symbol);
        return {};
      },
      units::second);
  std::vector<decltype(take(std::declval<ContactBuilder&>()))> all;
  for (const ContactContent& contact : model.scene().contacts) {
    ContactBuilder builder(model, contact, at_constant_velocity);
    std::visit(builder, contact.geometry);
    all.push_back(take(builder));
  }
  return all;
}

}  // namespace

std::vector<ContactRows> contact_rows(const Model& model) {
  return of_contacts(model, [](ContactBuilder& builder) { return builder.take(); });
}

std::vector<ContactPlace> contact_places(const Model& model) {
  return of_contacts(model, [](ContactBuilder& builder) { return builder.place(); });
}

std::vector<ContactCoefficients> contact_coefficients(const Model& model) {
  Program& program = model.program();
  std::vector<ContactCoefficients> all;
  for (const ContactContent& contact : model.scene().contacts) {
    ContactCoefficients coefficients;
    coefficients.friction = program.lower(contact.friction);
    coefficients.static_friction = program.lower(contact.static_friction);
    coefficients.restitution = program.lower(contact.restitution);
    if (const auto* friction = std::get_if<FrictionAlong>(&contact.geometry)) {
      coefficients.bound = program.lower(friction->bound);
      coefficients.static_bound = program.lower(friction->static_bound);
    }
    if (const auto* joint = std::get_if<FrictionInJoint>(&contact.geometry); joint != nullptr && !joint->radius.is_zero()) {
      const Value radius = program.lower(joint->radius);
      coefficients.friction = program.bind(radius * coefficients.friction);
      coefficients.static_friction = program.bind(radius * coefficients.static_friction);
    }
    all.push_back(std::move(coefficients));
  }
  return all;
}

}  // namespace torsor
