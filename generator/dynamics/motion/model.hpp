// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/dynamics/motion/pass_table.hpp"
#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// How forward dynamics is solved.
enum class ForwardMethod {
  cheapest,          ///< the cheapest of those below that keeps the digits
  factorisation,     ///< L D Lᵀ of the mass matrix
  articulated_body,  ///< articulated bodies by the differences of their inertias
  sums_of_squares,   ///< articulated bodies as sums of squares (dynamics/recursions/factored_bodies.hpp)
};

/// How a scene's symbols enter a program.
struct ModelOptions {
  bool symbolic_parameters = false;       ///< keep every parameter as a symbol (printed equations)
  std::set<std::string> valued{};         ///< of these, parameters that have their values all the same
  bool all_run_time = false;              ///< the same for kernels: `--run-time all`
  std::set<std::string> run_time{};       ///< further parameters that stay symbols
  bool hold_released = true;              ///< released coordinates and their rates are zero; off: they are coordinates
  std::optional<std::set<std::string>> sensitive_to{};  ///< parameters of sensitivities; without: those that stay symbols
  ForwardMethod forward = ForwardMethod::cheapest;
  Passes passes{};                        ///< what makes kernels cheap
};

/// Parameters that stay symbols in kernels, in the scene's order: declared run-time, without a value, or asked for by the
/// options. They are what the header's `Parameters` lists.
std::vector<SymbolPointer> run_time_parameters(const Scene& scene, const ModelOptions& options);

/// The same options with frames, inertia and lengths left as the scene has them, and products where they stand.
ModelOptions as_given(ModelOptions options);

/// A point of the scene as seen along axes that are not its own: a point of a link, and from there a vector.
struct SeenPoint {
  GeometricPoint base;
  int axes = 0;
  Vector beyond{};  ///< from the base to the point, in the axes of link `axes`
};

/// A scene in a program: links, coordinates and what they need. The base of every derivation.
///
/// As a tree it has the frames of the scene: axes and origin of a link are those of the frame that the scene gives to
/// it, and what is asked about motions and actions is asked of it. The recursions of the equations of motion get one of
/// the trees below, whose links may stand elsewhere; only forces along coordinates come out of them.
class Model : public BodyTree {
 public:
  Model(const Scene& scene, Program& program, const ModelOptions& options = {});
  ~Model() { program_->set_measurer({}); }
  Model(const Model&) = delete;  // its program asks it for what formulas measure
  Model& operator=(const Model&) = delete;

  /// The resolver a program for this scene must be made with.
  static Program::Resolver resolver(const Scene& scene, const ModelOptions& options);

  const ModelOptions& options() const { return options_; }

  /// The same mechanism in the frames and the unit of length that cost least, as passes allow: with the inertia of its
  /// bodies;
  const BodyTree& with_bodies() const { return trees_->with_bodies; }
  /// regrouped, for composite and articulated inertias;
  const BodyTree& regrouped() const { return trees_->regrouped; }
  /// without lines of mass, for wrenches of inertia.
  const BodyTree& without_lines() const { return trees_->without_lines; }

  std::vector<SymbolPointer> inputs() const;
  /// What positions are functions of: the unknown coordinates, and the four components of each unit quaternion.
  std::vector<SymbolPointer> positions() const;

  /// Derivative with respect to the configuration along freedom i.
  Derivation along(int i) const {
    return derivation_along(*program_, coordinates_[static_cast<std::size_t>(i)].v);
  }

  /// A formula of coordinates, time and parameters: what places are functions of. Throws SceneError naming `user` where
  /// it depends on velocities or more.
  Value of_configuration(const Expression& formula, const std::string& user) const;
  /// ∂e/∂q_i for every coordinate; a released one counts when e is that coordinate itself.
  std::vector<Value> partials(const Expression& e) const;

  using BodyTree::express;
  using BodyTree::locate;
  /// A point of the scene in the axes of a link.
  Vector locate(const PointReference& point, int link, const std::string& user) const;
  /// The same from the link it is in: what is near it has its digits however far both are from the axes' origin.
  SeenPoint see(const PointReference& point, int axes, const std::string& user) const;
  /// The way from the origin of a joint to a point, along the axes of the point.
  Vector arm_of(int joint, const SeenPoint& point) const;
  /// The same from the origin of a link, in its axes.
  Vector locate(const SeenPoint& point, int link) const;
  /// A direction given in a frame of the scene, in the axes of a link.
  Vector express(const Triple& direction, const FrameReference& axes, int link, const std::string& user) const;
  /// Height of a point of contact (PointContent::lowest) over the plane it was found for: that of the centre C less
  /// r √(1 − (n·k)²), or r for a sphere, or h(−n); the point itself, whose own formula cancels where a disc lies flat, is
  /// not used.
  Value lowest_height(const PointContent& point, int link, const std::string& user) const;

 private:
  void add_coordinates();
  void add_links();
  void set_motion(Link& link, const FrameContent& frame);
  void add_attitude(const FrameContent& frame, const FramePlace& at);
  Value measured(const Symbol& symbol);
  Vector measured(const MeasuredVector& wanted);
  bool is_placed(const Expression& formula, const std::vector<bool>& done) const;
  /// h(u) and ∇h(u) of a support function along the frame's axes, u the direction down in them.
  std::pair<Value, Vector> supported(const PointContent& point, const Vector& down) const;
  Vector down_in(const PointContent& point, const FramePlace& at, const std::string& user) const;
  SeenPoint lowest(const PointContent& point, int link, const std::string& user) const;

  ModelOptions options_;
  struct Measured {
    Vector vector;
    std::size_t size;  ///< of the program when it was known
  };
  std::map<int, Measured> measured_;  ///< by index of the measured vector
  std::optional<BodyTrees> trees_;
};

}  // namespace torsor
