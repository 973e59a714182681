// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torsor/generator/expression/expression.hpp"
#include "torsor/generator/geometry/rotation.hpp"
#include "torsor/generator/geometry/triple.hpp"
#include "torsor/generator/mechanics/inertia.hpp"
#include "torsor/generator/mechanics/scene_content.hpp"

namespace torsor {

struct MeasuredVector;

/// A mechanism as its author describes it: parameters, coordinates, frames joined in a tree, bodies attached to frames,
/// actions, constraints, initial state. Nothing is derived here.
///
/// Names are unique in a scene. Frames are tied by joints: the child's axes coincide with the parent's when the joint's
/// coordinate is zero, apart from the joint's placement. A joint's coordinate may be any formula of coordinates and
/// time, so that absolute angles, mimic joints and motions imposed by a law of time need nothing special. `validate`
/// (generator/dynamics/equations/validation.hpp) looks at the whole scene; every program calls it before deriving anything.
class Scene {
 public:
  explicit Scene(std::string name, std::string title = {});

  // --- quantities ---------------------------------------------------------------------------------------------------
  /// A constant of the mechanism. Without a value it must be given at run time. Its unit is printed as it is written here:
  /// "N m/rad", "rad", "J".
  Expression parameter(const std::string& name, std::string_view unit);
  Expression parameter(const std::string& name, std::string_view unit, const Expression& value);
  /// A parameter that stays a symbol in kernels although it has a (default) value. A default that is a formula is the number
  /// it comes to with the defaults of others: who sets these later sets this one too.
  Expression run_time_parameter(const std::string& name, std::string_view unit, const Expression& value);
  /// Gives a parameter another value: a number, or a formula of parameters that do not depend on it.
  void set_parameter(const Expression& parameter, const Expression& value);
  /// A generalised coordinate q [unit]; its velocity and acceleration come with it. An angle has the unit "rad", a ratio "1".
  Expression coordinate(const std::string& name, std::string_view unit);
  /// A coordinate that its joint holds at zero. It exists so that the reaction against it can be asked for
  /// (incompatible parametrisation). The reaction P_q − Q_q at q = 0 has the coordinate's name.
  Expression released_coordinate(const std::string& name, std::string_view unit);
  /// An orientation by a unit quaternion. Its coordinates are <name>_w, _x, _y, _z. Its three velocities
  /// <name>_omega_x, _y, _z are the components of the relative angular velocity in the axes of the frame that it
  /// turns. Use it in exactly one joint.
  AttitudeHandle attitude(const std::string& name);
  /// The time t [s].
  Expression time() const;

  /// Imposes a law of time on a coordinate, e.g. `drive(phi, omega * time())`. The coordinate is no unknown any more. A law
  /// that moves a joint has a continuous rate: where it jumps or has a kink (max, abs, piecewise), the motion would need an
  /// impulse, and the scene is refused. The same holds for time in the displacement of a joint.
  void drive(const Expression& coordinate, const Expression& law);
  /// The state at t = 0. A coordinate that is not given starts at zero, at rest; given again, the last one counts.
  void initial(const Expression& coordinate, const Expression& value, const Expression& rate = 0);
  /// The same of an attitude: (w, x, y, z) is normalised when it is used. An attitude that is given none starts at
  /// (1, 0, 0, 0).
  void initial(AttitudeHandle attitude, const std::array<Expression, 4>& quaternion,
               const Triple& angular_velocity = {Expression(0), Expression(0), Expression(0)});

  /// Limits of a coordinate. They become the header's table `Mechanism::limits`; nothing here enforces them. Those that are
  /// not given stay as an earlier call left them.
  void limits(const Expression& coordinate, const CoordinateLimits& limits);

  // --- the tree of joints -------------------------------------------------------------------------------------------
  // Each joint is placed in its parent by a constant origin and rotation (`placement`); `axis` is a direction in the
  // placed axes. A joint of several freedoms makes intermediate frames <name>.1, <name>.2 and so on. Equations give the
  // twist of the child in the parent at the child's origin C: Ω = Ω(child/parent) and V = V(C/parent). There `axis` counts
  // with length 1, and x, y and z are the placed axes.
  /// The frame of reference. It is the parent of every tree.
  FrameHandle ground() const;
  /// A frame fixed in its parent: an origin and a rotation without any freedom. It carries bodies, closes loops,
  /// gives axes.
  /// Equation: Ω = 0, V = 0.
  FrameHandle weld(const std::string& name, const FrameReference& parent, const Placement& placement);
  /// Rotation by `angle` about the unit vector `axis` (components in the placed parent axes).
  /// Equation: Ω(child/parent) = d(angle)/dt axis, V = 0.
  FrameHandle revolute(const std::string& name, const FrameReference& parent, const Triple& axis,
                       const Expression& angle, const Placement& placement = {});
  /// Translation by `displacement` along the unit vector `axis` (components in the placed parent axes).
  /// Equation: Ω = 0, V = d(displacement)/dt axis.
  FrameHandle prismatic(const std::string& name, const FrameReference& parent, const Triple& axis,
                        const Expression& displacement, const Placement& placement = {});
  /// Turns by `angle` and advances by `pitch` [m/rad] times it (the lead of the screw over 2π).
  /// Equation: Ω = d(angle)/dt axis, V = pitch d(angle)/dt axis.
  FrameHandle helical(const std::string& name, const FrameReference& parent, const HelicalMotion& motion,
                      const Placement& placement = {});
  /// Slides along the axis, then turns about it.
  /// Equation: Ω = d(angle)/dt axis, V = d(displacement)/dt axis.
  FrameHandle cylindrical(const std::string& name, const FrameReference& parent, const CylindricalMotion& motion,
                          const Placement& placement = {});
  /// Turns about `first`, fixed in the parent, then about `second`, which turns along; perpendicular directions.
  /// Equation: Ω = d(first_angle)/dt n1 + d(second_angle)/dt n2, V = 0; n2 is `second` as the first angle has turned
  /// it.
  FrameHandle universal(const std::string& name, const FrameReference& parent, const UniversalMotion& motion,
                        const Placement& placement = {});
  /// Three plane rotations about the joint's origin. Singular where the first and the last axis are parallel.
  /// Equation: Ω = Σ d(angle_i)/dt n_i, V = 0; n_i is the axis of the i-th rotation as those before have turned it.
  FrameHandle spherical(const std::string& name, const FrameReference& parent, const PlaneRotations& rotations,
                        const Placement& placement = {});
  /// The same freedom without any singular orientation.
  /// Equation: Ω = ω_x x' + ω_y y' + ω_z z' along the axes of the child, V = 0; the quaternion e has the rate ½ e (0,
  /// ω).
  FrameHandle spherical(const std::string& name, const FrameReference& parent, AttitudeHandle attitude,
                        const Placement& placement = {});
  /// Slides by (x, y) in the plane z = 0 of the placed axes, then turns about z.
  /// Equation: Ω = d(angle)/dt z, V = ẋ x + ẏ y.
  FrameHandle planar(const std::string& name, const FrameReference& parent, const PlanarMotion& motion,
                     const Placement& placement = {});
  /// The line x of the frame stays in the plane z = 0. The frame slides by (x, y), turns by `yaw` about z, then by
  /// `roll` about x.
  /// Equation: Ω = d(yaw)/dt z + d(roll)/dt x', V = ẋ x + ẏ y; x' is the axis x of the child.
  FrameHandle line_contact(const std::string& name, const FrameReference& parent, const LineContactMotion& motion,
                           const Placement& placement = {});
  /// The origin of the frame slides along `axis`; the frame turns in any way about it.
  /// Equation: Ω is that of `turn`, as for `spherical`; V = d(displacement)/dt axis.
  FrameHandle sphere_in_cylinder(const std::string& name, const FrameReference& parent,
                                 const SphereInCylinderMotion& motion, const Placement& placement = {});
  /// The origin of the frame slides by (x, y) in the plane z = 0; the frame turns in any way about it.
  /// Equation: Ω is that of `turn`, as for `spherical`; V = ẋ x + ẏ y.
  FrameHandle point_contact(const std::string& name, const FrameReference& parent, const PointContactMotion& motion,
                            const Placement& placement = {});
  /// Six degrees of freedom: translation (x, y, z) in the parent's axes, then three plane rotations. The intermediate
  /// frames are named <name>.x, .y, .z, .1 and .2, e.g. "hoop.2" after two rotations of Euler's sequence.
  /// Equation: Ω is that of the rotations, as for `spherical`; V = ẋ x + ẏ y + ż z.
  FrameHandle free(const std::string& name, const FrameReference& parent, const Triple& position,
                   const PlaneRotations& rotations);
  FrameHandle free(const std::string& name, const FrameReference& parent, const Triple& position,
                   AttitudeHandle attitude);
  /// Gives the joint that moves a frame a name of its own in graphs; otherwise it has the name of the frame. A weld
  /// that is named is a joint between two bodies of the structure graph. Any other weld makes one body of both.
  void name_joint(const FrameHandle& frame, const std::string& name);

  // --- points and bodies --------------------------------------------------------------------------------------------
  /// A point given by its components in a frame. They may depend on the coordinates, as those of a contact point do.
  /// Equation: OP = c1 x + c2 y + c3 z; O, x, y and z are origin and axes of the frame.
  PointHandle point(const std::string& name, const FrameReference& frame, const Triple& components);
  /// The point of that name, which may be declared later.
  static PointReference point(const std::string& name) { return PointReference(name); }
  /// The lowest point of the rim of a thin disc along the normal z of `plane`: there a wheel touches the plane. The
  /// disc is centred at the origin of `frame`, and its unit `axis` is given there. It is not defined for a disc lying flat.
  /// Equation: P = C − r (n − (n·k) k)/√(1 − (n·k)²), with the normal n and the axis k.
  PointHandle disc_contact(const std::string& name, const DiscContact& disc);
  /// The same of a sphere.
  /// Equation: P = C − r n.
  PointHandle sphere_contact(const std::string& name, const FrameReference& frame, const Expression& radius,
                             const FrameReference& plane);
  /// The same of a torus: a tube of the given radius [m] around a circle about `axis`; as a point, of its convex hull.
  /// Equation: P = C − R (n − (n·k) k)/√(1 − (n·k)²) − r n, R the radius of the circle, r that of the tube.
  PointHandle torus_contact(const std::string& name, const TorusContact& torus);
  /// The same of a solid ellipsoid with its semi-axes [m] along those of the frame.
  /// Equation: P = C − S n/√(n · S n), S = diag(a², b², c²).
  PointHandle ellipsoid_contact(const std::string& name, const FrameReference& frame, const Triple& semi_axes,
                                const FrameReference& plane);
  /// The same of any smooth convex body, by its support function h(u) = max u · CP [m], C the origin of the frame. h
  /// is a formula of the components of u along the frame's axes, with h(k u) = k h(u) for k > 0 (Schneider, Convex
  /// Bodies: The Brunn-Minkowski Theory, §1.7). A function that is not homogeneous or not convex is refused.
  /// Equation: P = C + ∇h(−n).
  PointHandle support_contact(const std::string& name, const FrameReference& frame,
                              const std::function<Expression(const Triple& u)>& h, const FrameReference& plane);
  /// A rigid body fixed in a frame: its mass, its centre of mass and its inertia. A frame may carry several.
  /// `Moments::as_given` accepts moments that no matter has, such as identified ones.
  /// Equation: T = ½ m V(G)² + ½ Ω · J Ω, J about the centre of mass G.
  void body(const std::string& name, const FrameReference& frame, const Inertia& inertia,
            Moments moments = Moments::of_matter);
  /// The reflected inertia a of a rotor behind its gear, which a displacement e drives; a is in kg m² where e is an
  /// angle, in kg where it is a length. For a ratio N and a rotor of inertia J, a = N² J. It resists along e alone: it has
  /// no weight, no place, and no momentum (Featherstone, Rigid Body Dynamics Algorithms, §9.6, without gyroscopic terms).
  /// Equation: T = ½ a ė².
  void reflected_inertia(const std::string& name, const Expression& displacement, const Expression& inertia);

  // --- what formulas may ask of the motion --------------------------------------------------------------------------
  // Vectors that follow from the motion of frames, as components along the axes of `axes`. They may stand in any
  // formula of an action, a constraint, a law of friction, a point, a joint or the law of a driven coordinate. Their
  // frames and points must have been declared before, with the parents of those frames. Neither values of parameters
  // nor initial states can depend on them. A joint's displacement, a point and a holonomic relation are places:
  // velocities are refused there.
  /// The components (w, x, y, z) of a unit quaternion: v_parent = R(e) v; `rate` of them is known.
  std::array<Expression, 4> attitude_components(AttitudeHandle attitude) const;
  /// A direction given in a frame, e.g. axis::z, seen in another: `direction("wheel", axis::z, "ground")`.
  Triple direction(const FrameReference& frame, const Triple& along, const FrameReference& axes);
  /// OP [m] from the origin O of a frame, along its axes. Its rate is V(P/frame), of the geometric point.
  Triple position(const PointReference& point, const FrameReference& frame);
  /// Ω(frame/relative_to) [rad/s].
  Triple angular_velocity(const FrameReference& frame, const FrameReference& axes,
                          const FrameReference& relative_to = "ground");
  /// V(P ∈ body/relative_to) [m/s], of the point of the body that is at P.
  Triple velocity(const PointReference& point, const FrameReference& body, const FrameReference& axes,
                  const FrameReference& relative_to = "ground");

  // --- actions ------------------------------------------------------------------------------------------------------
  /// Uniform gravity g, components in the ground frame [m/s²]. A scene has one.
  /// Equation: U = Σ m g · OG over the bodies.
  void gravity(const Triple& acceleration);
  /// Spring on an elongation or angle e.
  /// Equation: U = −½ k (e − rest)², Q_i = −k (e − rest) ∂e/∂q_i.
  void spring(const std::string& name, const Expression& elongation, const Expression& stiffness,
              const Expression& rest = 0);
  /// Damper on e: the force −c ė works with ė.
  /// Equation: Q_i = −c ė ∂e/∂q_i, power −c ė².
  void damper(const std::string& name, const Expression& elongation, const Expression& damping);
  /// Spring between two points.
  /// Equation: U = −½ k (|AB| − rest)².
  void spring(const std::string& name, const SpringBetween& spring);
  /// Damper between two points.
  /// Equation: tension c d|AB|/dt.
  void damper(const std::string& name, const PointReference& a, const PointReference& b, const Expression& damping);
  /// A motor that works with the displacement e. Its force or torque u is an input of the kernels, and is returned.
  /// Equation: Q_i = u ∂e/∂q_i.
  Expression motor(const std::string& name, const Expression& displacement);
  /// A given force F at a point P of a body, components along the axes of `axes` [N].
  /// Equation: Q_i = F · ∂V(P ∈ body)/∂q̇_i.
  void force(const std::string& name, const PointForce& force);
  /// A given torque C on a body, components along the axes of `axes` [N m].
  /// Equation: Q_i = C · ∂Ω(body)/∂q̇_i.
  void torque(const std::string& name, const FrameReference& body, const Triple& components,
              const FrameReference& axes);
  /// A conservative action given by its force function U(q, t) [J]. U is part of the force function of the energy; its
  /// power is that of these Q_i.
  /// Equation: Q_i = ∂U/∂q_i.
  void force_function(const std::string& name, const Expression& u);
  /// A generalised force F that works with the displacement e. F is any formula of q, q̇ and t [J over the unit of e]. It
  /// may be a non-linear damper, a belt, the law of a controller. It has no force function.
  /// Equation: Q_i = F ∂e/∂q_i, power F ė.
  void generalised_force(const std::string& name, const Expression& displacement, const Expression& force);
  /// Mutual attraction of two points at the distance d, k = 𝒢 m1 m2 [N m²] (course, §5.2.4).
  /// Equation: U = k/d; forces k/d² towards each other.
  void gravitation(const std::string& name, const PointReference& a, const PointReference& b,
                   const Expression& strength);
  /// A given wrench on a body, reduced at a point P: a force R [N] and a moment M_P [N m], along the axes of `axes`.
  /// Equation: power R · V(P ∈ body) + M_P · Ω(body), and Q_i the same of the partial velocities.
  void wrench(const std::string& name, const PointWrench& wrench);
  /// Viscous drag at a point P of a body, c [N s/m]; the opposite acts on `relative_to` when it is not the ground.
  /// Equation: force −c V, V = V(P ∈ body/relative_to), power −c V².
  void drag(const std::string& name, const PointDrag& drag);
  /// Viscous drag against turning, c [N m s], and its opposite on `relative_to`.
  /// Equation: torque −c Ω, Ω = Ω(body/relative_to), power −c Ω².
  void rotational_drag(const std::string& name, const FrameReference& body, const Expression& coefficient,
                       const FrameReference& relative_to = "ground");
  /// A force of body b on body a at a point [N], components along the axes of `axes`, and the opposite of a on b at the
  /// same point.
  /// Equation: power F · V(P ∈ a/b), the same in every frame of reference.
  void force_between(const std::string& name, const ForceBetween& force);
  /// A torque of body b on body a [N m] and the opposite of a on b.
  /// Equation: power C · Ω(a/b), the same in every frame of reference.
  void torque_between(const std::string& name, const TorqueBetween& torque);

  // --- contact laws in an assumed regime ----------------------------------------------------------------------------
  // Each law uses the multiplier N of `normal` as the normal force N = n · R(other → body) ≥ 0 [N]. Give that
  // constraint as a distance, or name its reaction along n; another one is refused. `simulate` notes where N < 0 (the
  // contact would open) and where the slip is against its assumed direction. A motion of the runtime watches neither: its
  // caller must, and must notice a slip that stops (runtime/events/contact_regime.hpp). Adhering is a no_slip
  // constraint, without friction.
  /// Coulomb's law while sliding: the force T at `point` of `body`, and the opposite on `other`. f is the
  /// `coefficient`. `direction` is G, of any length: the velocity of slip of body on other, or a direction known
  /// beforehand (course, §6.2.3, whose printed T lacks the division by |G|).
  /// Equation: T = −f N G/|G|.
  void sliding_friction(const std::string& name, const ConstraintHandle& normal, const SlidingFriction& friction);
  /// Any law of friction: the force T at `point` of `body`, and the opposite on `other`. G is the velocity of slip: the
  /// part of V(P ∈ body/other) along x and y of the axes of `plane`, whose z is the normal. With ε > 0 [m/s], the
  /// `smoothing`, the force is smooth through rest, where it vanishes. Beyond some ε it is −N φ(|G|) G/|G| to a
  /// relative (ε/G)²/2. `law` gives φ, a plain number, as a formula of s.
  /// Equation: T = −N φ(s) G/s, s = √(G² + ε²).
  void friction_law(const std::string& name, const ConstraintHandle& normal, const FrictionLaw& friction);
  /// Resistance to rolling: a moment on `body`, h the `length` [m], R12 the rolling part of Ω(body/other).
  /// Equation: M = −h N R12/|R12|.
  void rolling_resistance(const std::string& name, const ConstraintHandle& normal,
                          const RotationResistance& resistance);
  /// Resistance to spinning: a moment on `body`, k the `length` [m], n the normal turned the way of the spin P12.
  /// Equation: M = −k N n.
  void spinning_resistance(const std::string& name, const ConstraintHandle& normal,
                           const RotationResistance& resistance);

  // --- contacts that open and close ---------------------------------------------------------------------------------
  // Laws of Signorini, Coulomb and of impact, in no assumed regime: the kernels `contacts` and `contact_coefficients`
  // hand them over, and runtime/contacts moves the mechanism from event to event (docs/contacts.md). All other kernels
  // are those of the mechanism with its contacts open.
  /// Two bodies that may touch, with friction in the tangential plane, in a disc. A plane takes any other shape, in
  /// any order; a sphere takes a sphere or a hollow sphere. The normal n points from the second body (the plane, the
  /// hollow one) to the first, and slip is that of the first on the second. Tangents are x and y of the plane; one
  /// along which nothing can slip is left out, so that a plane mechanism has one. Resistance to rolling and to
  /// spinning makes the contacts <name>_rolling and <name>_spinning, whose moments work with the angular velocity of
  /// the first body on the second. A round shape makes the point <name>_point, a box the contacts <name>_1, _2 and so
  /// on with their points.
  /// Equation: 0 ≤ gap, 0 ≤ N, gap N = 0; |T| ≤ f_s N at rest, T = −f N G/|G| at the velocity of slip G. On impact
  /// the normal velocity v becomes −e v. There f is the friction, f_s the static friction, e the restitution.
  void contact(const std::string& name, const ContactShape& shape, const ContactShape& other, const SurfaceLaw& law = {});
  /// Stops of a coordinate, the contacts <coordinate>_lower and <coordinate>_upper, each a formula of coordinates, time
  /// and parameters or none.
  /// Equation: lower ≤ q ≤ upper; a stop pushes, N ≥ 0, where q is at it; on impact q̇ becomes −e q̇ at a stop at rest.
  void stop(const Expression& coordinate, const std::optional<Expression>& lower, const std::optional<Expression>& upper,
            const StopLaw& law = {});
  /// Dry friction in a joint: a force or torque of at most `bound` that works with the displacement, opposes its rate
  /// while that is not zero, and holds it at rest where it can.
  /// Equation: Q_i = F ∂e/∂q_i; F = −bound ė/|ė| where ė ≠ 0, |F| ≤ static_bound at rest.
  void dry_friction(const std::string& name, const Expression& displacement, const DryFriction& friction);
  /// Dry friction of the prismatic or revolute joint that carries `frame`, in proportion to the resultant R that the joint
  /// transmits across its axis. Moments that the joint transmits and a thrust along a revolute joint's axis add nothing.
  /// Equation: bound = f |R| of a prismatic joint, f r |R| of a journal with the radius r, as in `dry_friction`.
  void joint_friction(const std::string& name, const FrameReference& frame, const JointFriction& friction);

  // --- constraints --------------------------------------------------------------------------------------------------
  /// A holonomic constraint, given as its left-hand side f.
  /// Equation: f(q, t) = 0, Q_i = λ ∂f/∂q_i with the multiplier λ.
  ConstraintHandle holonomic(const std::string& name, const Expression& f);
  /// A constraint on velocities, linear in them, given as its left-hand side.
  /// Equation: Σ a_i(q, t) q̇_i − b(q, t) = 0, Q_i = λ a_i with the multiplier λ.
  ConstraintHandle nonholonomic(const std::string& name, const Expression& left_side);
  /// No slip along a direction. P is the body's material point at `contact`; `direction` is given along `axes`.
  /// Equation: V(P ∈ body/on) · direction = 0.
  ConstraintHandle no_slip(const std::string& name, const NoSlip& law);
  /// Rolls without slipping along x and y of `tangents`, whose z is the normal of contact. These are two constraints,
  /// <name>_x and <name>_y. Contact itself is another condition: build it into the coordinates, or add a `point_in_plane`.
  /// Equation: V(P ∈ body/on) · x = 0, V(P ∈ body/on) · y = 0.
  std::vector<ConstraintHandle> rolling(const std::string& name, const Rolling& rolling);
  /// The point stays in the plane z = 0 of a frame: it neither enters nor leaves it. The multiplier is the normal
  /// force on the point's body.
  /// Equation: OP · z = 0, O and z the origin and the normal of the plane; N = λ along z.
  ConstraintHandle point_in_plane(const std::string& name, const PointReference& point, const FrameReference& plane);
  /// An equation that closes a loop. The direction is given in the ground frame.
  /// Equation: AB · direction = 0.
  ConstraintHandle closure(const std::string& name, const PointReference& a, const PointReference& b,
                           const Triple& direction);
  /// An ideal joint between two frames that closes a loop. Its axes are those of the frames: a revolute joint turns
  /// about x of both. Each locked direction is one constraint. <name>_x, _y, _z hold AB along the axes of a, and
  /// their multipliers are components of the force on b. <name>_rx, _ry, _rz hold the orientation, and their
  /// multipliers are components of the moment on b about the axes of a. A line contact has one, <name>_ry, about
  /// z_a ∧ x_b, and a universal joint one, <name>_r, about x_a ∧ y_b.
  /// Equation: of a revolute joint AB = 0, x_b · y_a = 0, x_b · z_a = 0; other joints leave out what moves along
  /// their freedoms.
  std::vector<ConstraintHandle> loop_joint(const std::string& name, const LoopJoint& joint);
  /// Names the reaction that enforces a constraint. It is a force of unknown intensity on `body` at `contact` along
  /// `direction` (components in `axes`), and the opposite on `other`. The multiplier is then that intensity [N].
  /// Equation: Q_i = λ direction · ∂V(P ∈ body/other)/∂q̇_i.
  void reaction(const ConstraintHandle& constraint, const std::string& name, const PointReaction& reaction);

  // --- pictures -----------------------------------------------------------------------------------------------------
  /// Draws a form on a frame in reports. It replaces what the report would draw of the frame's body, and changes no
  /// equation. Lengths [m] are formulas; sliders of the report change them. The forms are form::Box{edges},
  /// form::Cylinder{radius, length} and form::Sphere{radius}, which are centred, form::Cone{radius, length} with its base
  /// in z = 0, form::Torus{radius, tube}, form::Segment{from, to, radius}, and form::Mesh{file} for `report --meshes`.
  /// The axis is z.
  void show(const Shown& shown);

  // --- further choices ----------------------------------------------------------------------------------------------
  /// Names coordinates that shall be independent where constraints are eliminated (linearisation), the most wanted
  /// first. Those that the constraints allow stay; the generator chooses the rest. An attitude's freedoms cannot be
  /// named.
  void independent(const std::vector<Expression>& coordinates);

  /// Keeps coordinates that move no mass, which are refused otherwise. Kinematics and inverse dynamics have them.
  /// Kernels that solve with the mass matrix are then absent.
  void keep_massless() { content_.keeps_massless = true; }

  /// Tells that the scene was read from a file; generated headers say so.
  void came_from(SceneOrigin origin) { content_.origin = std::move(origin); }

  /// The program and one of its commands, for texts that say how to make something again: "hoop_scene generate", or
  /// "torsor generate hoop.urdf" with the options of the scene's origin.
  std::string command_line(const std::string& command) const;

  const SceneContent& content() const { return content_; }
  const std::string& name() const { return content_.name; }

 private:
  SymbolPointer add_symbol(const std::string& name, const Unit& unit, SymbolKind kind, SymbolPointer rate = nullptr);
  /// With the unit that an author wrote.
  SymbolPointer add_symbol(const std::string& name, std::string_view unit, SymbolKind kind, SymbolPointer rate = nullptr);
  void claim(const std::string& name, const std::string& what);
  FrameHandle add_frame(FrameContent frame);
  PointHandle add_point(PointContent point);
  struct Step { std::string suffix; JointKind kind; Triple axis; Expression displacement; std::optional<int> attitude = std::nullopt; };
  struct StepsOfJoint {
    JointType type;
    std::vector<Step> steps;
  };
  FrameHandle add_joint(const std::string& name, const FrameReference& parent, const Placement& placement,
                        const StepsOfJoint& joint);
  static std::vector<Step> turn(const PlaneRotations& rotations);
  static std::vector<Step> turn(AttitudeHandle attitude);
  static std::vector<Step> turn(const SphericalMotion& by);
  static std::vector<Step> slides(const std::vector<std::pair<Triple, Expression>>& slides,
                                  const std::vector<Step>& then);
  ConstraintHandle add_constraint(ConstraintContent constraint);
  void add_friction(ContactFriction friction);
  void add_contact(ContactContent contact);
  std::vector<PointHandle> touching_points(const std::string& name, const ContactShape& shape, const FrameReference& plane);
  void add_resistance(const std::string& name, const char* kind, const ConstraintHandle& normal,
                      const RotationResistance& resistance);
  ConstraintHandle add_constraint(const std::string& name, ConstraintLaw law, const Unit& multiplier);
  Triple measured(MeasuredVector vector, const std::string& name, const Unit& unit, std::vector<SymbolPointer> made_of);
  std::string name_of(int frame) const;
  void refuse_measured(const Expression& formula, const std::string& what) const;
  CoordinateContent& coordinate_of(const Expression& coordinate, const std::string& purpose);

  SceneContent content_;
};

}  // namespace torsor
