// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/expression/expression.hpp"
#include "generator/geometry/rotation.hpp"
#include "generator/geometry/triple.hpp"
#include "generator/mechanics/inertia.hpp"
#include "generator/mechanics/scene_content.hpp"

namespace torsor {

/// A mechanism as its author describes it: parameters, coordinates, frames joined in a tree, bodies attached to frames,
/// actions, constraints, initial state. Nothing is derived here.
///
/// Names are unique in a scene. Frames are tied by joints: the child's axes coincide with the parent's when the joint's
/// coordinate is zero, apart from the joint's placement. A joint's coordinate may be any formula of coordinates and
/// time, so that absolute angles, mimic joints and motions imposed by a law of time need nothing special. `validate`
/// (dynamics/validation.hpp) looks at the whole scene; every program calls it before deriving anything.
class Scene {
 public:
  explicit Scene(std::string name, std::string title = {});

  // --- quantities ---------------------------------------------------------------------------------------------------
  /// A constant of the mechanism. Without a value it must be given at run time.
  Expression parameter(const std::string& name, std::string_view unit);
  Expression parameter(const std::string& name, std::string_view unit, const Expression& value);
  /// A parameter that stays a symbol in kernels although it has a (default) value.
  Expression run_time_parameter(const std::string& name, std::string_view unit, const Expression& value);
  /// A generalised coordinate q [unit]; its velocity and acceleration come with it.
  Expression coordinate(const std::string& name, std::string_view unit);
  /// A coordinate that the joints hold at zero: it exists so that the reaction against it can be asked for
  /// (incompatible parametrisation). The reaction has the coordinate's name: P_q − Q_q at q = 0.
  Expression released_coordinate(const std::string& name, std::string_view unit);
  /// t [s].
  Expression time() const;

  /// Imposes a law of time on a coordinate, e.g. `drive(phi, omega * time())`: it is no unknown any more.
  void drive(const Expression& coordinate, const Expression& law);
  /// State at t = 0; whatever is not given is zero.
  void initial(const Expression& coordinate, const Expression& value, const Expression& rate = 0);

  // --- geometry -----------------------------------------------------------------------------------------------------
  FrameHandle ground() const;
  FrameHandle weld(const std::string& name, const FrameReference& parent, const Placement& placement);
  /// Rotation by `angle` about the unit vector `axis` (components in the placed parent axes).
  FrameHandle revolute(const std::string& name, const FrameReference& parent, const Triple& axis,
                       const Expression& angle, const Placement& placement = {});
  FrameHandle prismatic(const std::string& name, const FrameReference& parent, const Triple& axis,
                        const Expression& displacement, const Placement& placement = {});
  /// Six degrees of freedom: translation (x, y, z) in the parent's axes, then three plane rotations. The intermediate
  /// frames are named <name>.x, .y, .z, .1 and .2, e.g. "hoop.2" after two rotations of Euler's sequence.
  FrameHandle free(const std::string& name, const FrameReference& parent, AngleSequence sequence,
                   const Triple& position, const Triple& angles);
  /// A point given by its components in a frame; they may depend on the coordinates (a contact point moves).
  PointHandle point(const std::string& name, const FrameReference& frame, const Triple& components);
  void body(const std::string& name, const FrameReference& frame, const Inertia& inertia);

  // --- actions ------------------------------------------------------------------------------------------------------
  /// Uniform gravity, components in the ground frame [m/s²].
  void gravity(const Triple& acceleration);
  /// Spring on an elongation or angle e: U = −½ k (e − rest)².
  void spring(const std::string& name, const Expression& elongation, const Expression& stiffness,
              const Expression& rest = 0);
  /// Damper on e: the force −c ė works with ė.
  void damper(const std::string& name, const Expression& elongation, const Expression& damping);
  /// Spring between two points: U = −½ k (|AB| − rest)².
  void spring(const std::string& name, const PointReference& a, const PointReference& b, const Expression& stiffness,
              const Expression& rest = 0);
  /// Damper between two points: tension c d|AB|/dt.
  void damper(const std::string& name, const PointReference& a, const PointReference& b, const Expression& damping);
  /// A motor working with the displacement e: its force or torque is an input of the kernels and is returned.
  Expression motor(const std::string& name, const Expression& displacement);
  /// A given force at a point of a body, components along the axes of `axes` [N].
  void force(const std::string& name, const FrameReference& body, const PointReference& point, const Triple& components,
             const FrameReference& axes);
  /// A given torque on a body, components along the axes of `axes` [N m].
  void torque(const std::string& name, const FrameReference& body, const Triple& components,
              const FrameReference& axes);
  /// A conservative action given by its force function U(q, t) [J]: Q_i = ∂U/∂q_i. U is part of the force function of
  /// the energy; its power is that of these Q_i.
  void force_function(const std::string& name, const Expression& u);
  /// An action of intensity F working with the displacement e: Q_i = F ∂e/∂q_i, power F ė. F is any formula of q, q̇ and
  /// t [J over the unit of e]: a non-linear damper, a belt, the law of a controller. It has no force function.
  void effort(const std::string& name, const Expression& displacement, const Expression& force);
  /// Mutual attraction of two points at the distance d: U = k/d, k = 𝒢 m1 m2 [N m²]; forces k/d² towards each other
  /// (course, §5.2.4).
  void gravitation(const std::string& name, const PointReference& a, const PointReference& b,
                   const Expression& strength);
  /// A given wrench on a body reduced at a point: force [N] and moment at that point [N m], along the axes of `axes`.
  void wrench(const std::string& name, const FrameReference& body, const PointReference& point, const Triple& force,
              const Triple& moment, const FrameReference& axes);
  /// Viscous drag at a point P of a body: the force −c V(P ∈ body/relative_to), c [N s/m]; the opposite acts on
  /// `relative_to` when it is not the ground. Power −c V².
  void drag(const std::string& name, const FrameReference& body, const PointReference& point,
            const Expression& coefficient, const FrameReference& relative_to = "ground");
  /// Viscous drag against turning: the torque −c Ω(body/relative_to), c [N m s], and its opposite. Power −c Ω².
  void rotational_drag(const std::string& name, const FrameReference& body, const Expression& coefficient,
                       const FrameReference& relative_to = "ground");
  /// A force of body b on body a at a point [N], components along the axes of `axes`, and the opposite of a on b at the
  /// same point. Its power F · V(P ∈ a/b) is the same in every frame of reference.
  void force_between(const std::string& name, const FrameReference& a, const FrameReference& b,
                     const PointReference& point, const Triple& components, const FrameReference& axes);
  /// A torque of body b on body a [N m] and the opposite of a on b; power C · Ω(a/b).
  void torque_between(const std::string& name, const FrameReference& a, const FrameReference& b,
                      const Triple& components, const FrameReference& axes);

  // --- contact laws in an assumed regime ----------------------------------------------------------------------------
  // Each uses the multiplier N of `normal` as the normal force N = n · R(other → body) ≥ 0 [N]: give that constraint as
  // a distance, or name its reaction along n. Nothing watches the regime: N < 0 (the contact opens) and a slip that
  // stops are for the caller to see (runtime/contact_regime.hpp). Adhering is a no_slip constraint, without friction.
  /// Coulomb's law while sliding: at `point` of `body` the force T = −f N G/|G|, and the opposite on `other`. `direction`
  /// is G, of any length: the velocity of slip of body on other or a direction known beforehand (course, §6.2.3, whose
  /// printed T lacks the division by |G|).
  void sliding_friction(const std::string& name, const ConstraintHandle& normal, const Expression& f,
                        const FrameReference& body, const PointReference& point, const Triple& direction,
                        const FrameReference& axes, const FrameReference& other = "ground");
  /// Resistance to rolling: the moment −h N R12/|R12| on `body`, h [m], R12 the rolling part of Ω(body/other).
  void rolling_resistance(const std::string& name, const ConstraintHandle& normal, const Expression& h,
                          const FrameReference& body, const Triple& direction, const FrameReference& axes,
                          const FrameReference& other = "ground");
  /// Resistance to spinning: the moment −k N n on `body`, k [m], n the normal turned the way of the spin P12.
  void spinning_resistance(const std::string& name, const ConstraintHandle& normal, const Expression& k,
                           const FrameReference& body, const Triple& direction, const FrameReference& axes,
                           const FrameReference& other = "ground");

  // --- constraints --------------------------------------------------------------------------------------------------
  /// f(q, t) = 0.
  ConstraintHandle holonomic(const std::string& name, const Expression& f);
  /// Σ a_i(q, t) q̇_i − b(q, t) = 0, given as its left-hand side.
  ConstraintHandle nonholonomic(const std::string& name, const Expression& left_side);
  /// No slip: the velocity of the body's material point at `contact`, along `direction` (components in `axes`), is 0.
  ConstraintHandle no_slip(const std::string& name, const FrameReference& body, const PointReference& contact,
                           const Triple& direction, const FrameReference& axes);
  /// Closes a loop: AB · direction = 0, direction given in the ground frame.
  ConstraintHandle closure(const std::string& name, const PointReference& a, const PointReference& b,
                           const Triple& direction);
  /// Names the reaction that enforces a constraint: a force of unknown intensity on `body` at `contact` along
  /// `direction` (components in `axes`), and the opposite on `other`. Its multiplier is then that intensity [N].
  void reaction(const ConstraintHandle& constraint, const std::string& name, const FrameReference& body,
                const PointReference& contact, const Triple& direction, const FrameReference& axes,
                const FrameReference& other = "ground");

  const SceneContent& content() const { return content_; }
  const std::string& name() const { return content_.name; }

 private:
  SymbolPointer add_symbol(const std::string& name, const Unit& unit, SymbolKind kind, SymbolPointer rate = nullptr);
  void claim(const std::string& name, const std::string& what);
  FrameHandle add_frame(FrameContent frame);
  ConstraintHandle add_constraint(ConstraintContent constraint);
  void add_friction(ContactFriction friction);
  CoordinateContent& coordinate_of(const Expression& coordinate, const std::string& purpose);

  SceneContent content_;
};

}  // namespace torsor
