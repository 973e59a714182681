// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/base/linear_algebra/real_rows.hpp"
#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/motion/initial_numbers.hpp"
#include "torsor/generator/geometry/real_vector.hpp"
#include "torsor/generator/mechanics/structure_graph.hpp"

namespace torsor {

/// Place of a frame in the ground frame.
struct RealPose {
  RealRotation rotation;  ///< its columns are the frame's axes
  RealVector origin;
};

/// The freedoms of one joint of the graph, as unit twists {Ω, V_O} of its b relative to its a, at the ground's origin
/// and along its axes: rows of six numbers.
struct JointTwists {
  RealRows twists;
  std::vector<std::string> names;  ///< "turn about z"
};

/// A mechanism in numbers, at one configuration of its joints: each freedom of each joint of the tree is a variable of
/// its own, whatever formulas of coordinates the scene has for them. Lengths are divided by `length`, the size of the
/// mechanism, so that turns and slides compare. Copies are configurations of their own.
class JointSpace {
 public:
  /// At the initial configuration.
  JointSpace(const Scene& scene, const StructureGraph& graph, const NaturalLanguage& language = {});

  const Real& length() const { return length_; }
  int variable_count() const { return variables_; }
  /// Adds to the variables; an orientation by a quaternion turns by the vector of its three.
  void move(const RealRow& by);
  /// Largest difference of a joint's displacement, or of an entry of an attitude's rotation, from another
  /// configuration.
  Real distance_from(const JointSpace& other) const;

  /// Twists of all joints of the graph, in its order.
  std::vector<JointTwists> twists() const;
  /// Axes and point of a joint: those its a holds, and the origin of its b.
  RealPose place(const GraphJoint& joint) const;

  /// What the joints that close loops have left open, each locked direction a number, and how it moves with the
  /// variables.
  RealRow closure_errors() const;
  RealRows closure_jacobian() const;
  /// Newton's method on the closures from here, each step the smallest on `largest_rank` independent conditions. True when all conditions hold to `small`; else the configuration is left where it was.
  bool close(std::size_t largest_rank, const Real& small);

 private:
  struct Frame {
    std::optional<int> parent;      ///< none for the ground
    RealPose placement;
    JointKind kind = JointKind::weld;
    RealVector axis;
    Real displacement;
    RealRotation turned;            ///< of an attitude
    std::optional<int> variable;    ///< the first of three for an attitude; none where nothing moves
    bool slides_with_turn = false;  ///< the slide of a helical joint, which shares the variable of its turn
    Real per_variable;              ///< 1, or the pitch for that slide
  };
  using Closure = JointClosure;

  void place_frames();
  /// Unit twist of one variable, from all frames that it moves.
  RealRow variable_twist(int variable) const;
  RealRow closure_row(const Closure& law) const;

  NaturalLanguage say_;
  const SceneContent* scene_;
  const StructureGraph* graph_;
  Real length_;
  int variables_ = 0;
  std::vector<Frame> frames_;
  std::vector<RealPose> poses_;
  std::vector<Closure> closures_;
  std::vector<Real> pitches_;        ///< of the closures
  std::vector<Real> joint_pitches_;  ///< of the scene's joints
};

/// "x" for an axis of the ground (either sense), else three components of three digits.
std::string direction_text(const RealVector& direction);

}  // namespace torsor
