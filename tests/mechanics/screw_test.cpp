// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/screw.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/mechanics/central_axis.hpp"
#include "torsor/generator/mechanics/rigid_motion.hpp"
#include "torsor/generator/mechanics/sliding_vector.hpp"
#include "tests/geometry/symbolic_vectors.hpp"

namespace torsor::screw_test {
namespace {

using namespace testing_symbols;

// Every kind is a type of its own.
template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
  a - b;
};
template <class A, class B>
concept Reciprocal = requires(A a, B b) {
  reciprocal_product(a, b);
};
static_assert(Addable<Twist, Twist> && Addable<Wrench, Wrench> && Addable<DynamicScrew, DynamicScrew>);
static_assert(!Addable<Twist, Wrench> && !Addable<Wrench, Twist> && !Addable<Wrench, DynamicScrew>);
static_assert(!Addable<MomentumScrew, DynamicScrew> && !Addable<MomentumScrew, Wrench>);
static_assert(Reciprocal<DynamicScrew, Twist> && !Reciprocal<Twist, Twist> && !Reciprocal<DynamicScrew, Wrench>);

class ScrewTest : public ::testing::Test, protected SymbolicVectors {
 protected:
  Vector numbers(const std::array<Number, 3>& v, const Unit& unit = Unit()) {
    return {program.number(v[0], unit), program.number(v[1], unit), program.number(v[2], unit)};
  }

  Wrench wrench{symbols("R", "N"), symbols("M", "N m")};
  Twist twist{symbols("W", "rad/s"), symbols("V", "m/s")};
  Vector ab = symbols("b", "m"), ac = symbols("c", "m");
};

using ScrewReduction = ScrewTest;
using ScrewInvariants = ScrewTest;
using CentralAxisOf = ScrewTest;
using SlidingVectors = ScrewTest;
using Density = ScrewTest;
using TwistOfVelocities = ScrewTest;
using MotionRecognised = ScrewTest;

TEST_F(ScrewReduction, GoesFromPointToPointByAnyRoad) {
  const Wrench at_b = reduced_at(wrench, ab);
  EXPECT_TRUE(identically_zero(at_b.moment - (wrench.moment + cross(wrench.resultant, ab))));
  EXPECT_TRUE(identically_zero(reduced_at(at_b, ac - ab).moment - reduced_at(wrench, ac).moment));
  EXPECT_TRUE(identically_zero(reduced_at(at_b, -ab).moment - wrench.moment));
  // V_B = V_A + Ω ∧ AB, and AB·V_A = AB·V_B.
  const Twist there = reduced_at(twist, ab);
  EXPECT_TRUE(identically_zero(there.linear - (twist.linear + cross(twist.angular, ab))));
  EXPECT_TRUE(identically_zero(dot(ab, there.linear) - dot(ab, twist.linear)));
}

TEST_F(ScrewReduction, CommutesWithSumsAndFactors) {
  const Wrench other{symbols("S", "N"), symbols("N", "N m")};
  const Value k = program.lower(make_symbol("k"));
  EXPECT_TRUE(identically_zero(reduced_at(wrench + other, ab).moment -
                               (reduced_at(wrench, ab) + reduced_at(other, ab)).moment));
  EXPECT_TRUE(identically_zero(reduced_at(k * wrench, ab).moment - (k * reduced_at(wrench, ab)).moment));
  EXPECT_TRUE(identically_zero((wrench - other).resultant - (wrench + -other).resultant));
}

TEST_F(ScrewReduction, CommutesWithATurnOfTheAxes) {
  const Rotation r = Rotation::about(0, 5) * Rotation::about(1, 1);
  const Wrench one_way = turned(r, reduced_at(wrench, ab));
  const Wrench other_way = reduced_at(turned(r, wrench), r * ab);
  EXPECT_TRUE(identically_zero(one_way.moment - other_way.moment));
  EXPECT_TRUE(identically_zero(turned(constant_matrix(program, r), wrench).resultant - r * wrench.resultant));
}

TEST_F(ScrewInvariants, AreTheSameAtEveryPoint) {
  EXPECT_TRUE(identically_zero(scalar_invariant(reduced_at(wrench, ab)) - scalar_invariant(wrench)));
  EXPECT_TRUE(identically_zero(reduced_at(wrench, ab).resultant - wrench.resultant));
  const Value power = reciprocal_product(wrench, twist);
  EXPECT_TRUE(identically_zero(reciprocal_product(reduced_at(wrench, ab), reduced_at(twist, ab)) - power));
  EXPECT_FALSE(identically_zero(reciprocal_product(reduced_at(wrench, ab), twist) - power));
  EXPECT_EQ(power.unit(), units::watt);
}

TEST_F(ScrewInvariants, VanishForASlidingVectorAndForACouple) {
  const Wrench sliding = screw_of<screw_kind::Wrench>({{ab, wrench.resultant}}, ac);
  EXPECT_TRUE(identically_zero(scalar_invariant(sliding)));
  EXPECT_TRUE(identically_zero(scalar_invariant(Wrench{Vector(), wrench.moment})));
  EXPECT_FALSE(identically_zero(scalar_invariant(wrench)));
}

TEST_F(CentralAxisOf, AScrewHasItsMomentAlongTheResultant) {
  const CentralAxis axis = central_axis(wrench, "load");
  const Wrench there = reduced_at(wrench, axis.ah);
  EXPECT_TRUE(identically_zero(cross(there.moment, wrench.resultant)));
  EXPECT_TRUE(identically_zero(there.moment - axis.pitch * wrench.resultant));
  EXPECT_TRUE(identically_zero(dot(axis.ah, wrench.resultant)));
  EXPECT_TRUE(identically_zero(dot(axis.direction, axis.direction) - program.number(Number(1))));
  EXPECT_TRUE(identically_zero(cross(axis.direction, wrench.resultant)));
  EXPECT_EQ(axis.pitch.unit(), units::metre);
  // Further along the axis nothing changes; the point does not depend on where the screw was reduced.
  const Vector further = axis.ah + program.lower(make_symbol("alpha", "m")) * axis.direction;
  EXPECT_TRUE(identically_zero(reduced_at(wrench, further).moment - there.moment));
  const CentralAxis same = central_axis(reduced_at(wrench, ab), "load");
  EXPECT_TRUE(identically_zero(cross(ab + same.ah - axis.ah, wrench.resultant)));
  EXPECT_TRUE(identically_zero(same.pitch - axis.pitch));
}

TEST_F(CentralAxisOf, AScrewInNumbersLiesWhereThePictureSays) {
  // A turn of 2 rad/s about the vertical through (3, 0, 0) with 5 m/s along it: V(O) = 2 z ∧ (−3 x) + 5 z = (0, −6, 5).
  const Twist given{numbers({0, 0, 2}, units::radian_per_second), numbers({0, -6, 5}, units::metre_per_second)};
  const CentralAxis axis = central_axis(given, "screw");
  EXPECT_TRUE(axis.ah[0].is_number(3));
  EXPECT_TRUE(axis.ah[1].is_zero() && axis.ah[2].is_zero());
  EXPECT_TRUE(axis.direction[2].is_number(1));
  EXPECT_EQ(axis.pitch.polynomial().constant(), Number::rational(5, 2));
}

TEST_F(CentralAxisOf, ACoupleDoesNotExist) {
  const std::string message =
      "the screw 'brake' has no central axis: its resultant vanishes identically, it is a couple (the same moment at "
      "every point)";
  const Wrench couple{Vector(), wrench.moment};
  EXPECT_EQ(error_of<SceneError>([&] { central_axis(couple, "brake"); }), message);
  const Wrench hidden{cross(wrench.resultant, wrench.resultant), wrench.moment};
  EXPECT_EQ(error_of<SceneError>([&] { split_on_central_axis(hidden, "brake"); }), message);
  EXPECT_TRUE(identically_zero(reduced_at(couple, ab).moment - couple.moment));
}

TEST_F(CentralAxisOf, AScrewSplitsItIntoASlidingVectorAndTheSmallestCouple) {
  const ScrewParts<screw_kind::Wrench> parts = split_on_central_axis(wrench, "load");
  EXPECT_TRUE(identically_zero((parts.couple + parts.sliding).moment - wrench.moment));
  EXPECT_TRUE(identically_zero(parts.couple.resultant));
  EXPECT_TRUE(identically_zero(cross(parts.couple.moment, wrench.resultant)));
  const Vector h = central_axis(wrench, "load").ah;
  EXPECT_TRUE(identically_zero(reduced_at(parts.sliding, h).moment));
  // |M_B|² − |couple|² is the square of the rest: never smaller than on the axis.
  const Vector moment = reduced_at(wrench, ab).moment;
  const Vector rest = reduced_at(parts.sliding, ab).moment;
  const Value squares = dot(moment, moment) - dot(parts.couple.moment, parts.couple.moment);
  EXPECT_TRUE(identically_zero(squares - dot(rest, rest)));
  const ScrewParts<screw_kind::Wrench> here = split_at_point(wrench);
  EXPECT_TRUE(identically_zero((here.couple + here.sliding).moment - wrench.moment));
  EXPECT_TRUE(identically_zero(here.sliding.moment) && identically_zero(here.couple.resultant));
}

TEST_F(SlidingVectors, HaveAMomentThatIgnoresTheirPointOnTheLine) {
  const Vector force = wrench.resultant;
  const SlidingVector sliding{ab, force};
  const SlidingVector further{ab + program.lower(make_symbol("s", "m/N")) * force, force};
  EXPECT_TRUE(identically_zero(moment_at(sliding, ac) - moment_at(further, ac)));
  EXPECT_TRUE(identically_zero(moment_at(sliding, ac) - cross(ab - ac, force)));
}

TEST_F(SlidingVectors, FormTheScrewTheirMomentsObey) {
  const std::vector<SlidingVector> set{{ab, symbols("f", "N")}, {ac, symbols("g", "N")}, {Vector(), symbols("h", "N")}};
  const Wrench at_o = screw_of<screw_kind::Wrench>(set, Vector());
  const Vector place = symbols("p", "m");
  EXPECT_TRUE(identically_zero(screw_of<screw_kind::Wrench>(set, place).moment - reduced_at(at_o, place).moment));
  // Two opposite ones are a couple: AP ∧ V at every point.
  const std::vector<SlidingVector> pair{{ab, wrench.resultant}, {ac, -wrench.resultant}};
  const Wrench couple = screw_of<screw_kind::Wrench>(pair, place);
  EXPECT_TRUE(identically_zero(couple.resultant));
  EXPECT_TRUE(identically_zero(couple.moment - cross(ab - ac, wrench.resultant)));
}

TEST_F(SlidingVectors, TurnAboutAnAxisWithTheLeverArm) {
  // 10 N along y at x = 3: 30 N m about z, whatever the point of the axis and the length of its direction.
  const std::vector<SlidingVector> set{{numbers({3, 7, 1}, units::metre), numbers({4, 10, 5}, units::newton)}};
  const Wrench at_o = screw_of<screw_kind::Wrench>(set, Vector());
  for (const int z : {0, 4}) {
    const Vector on_axis = numbers({0, 7, z}, units::metre);
    const Value moment = moment_about(at_o, {.name = "hinge", .ab = on_axis, .direction = numbers({0, 0, 5})});
    EXPECT_TRUE(moment.is_number(30));
    EXPECT_EQ(moment.unit(), units::newton_metre);
  }
  EXPECT_EQ(error_of<SceneError>([&] { moment_about(at_o, {.name = "hinge", .ab = ab, .direction = {}}); }),
            "the direction of axis 'hinge' is the null vector: give a direction");
}

TEST_F(Density, AlongASegmentIsThatOfManySmallForces) {
  // f(s) = (3 s − s³) f0 per metre along the segment from B with edge e, of length 3: the mean over n equal pieces,
  // Simpson's rule being exact for cubics, and for the moment's quartics too with Boole's rule.
  const Vector edge = numbers({1, 2, 2}, units::metre);
  const Vector f0 = symbols("f", "N/m");
  const Value minus_one = program.number(Number(-1));
  const Value three = program.number(Number(3));
  const Wrench exact =
      screw_of_density<screw_kind::Wrench>({ab, {edge}}, {{three * f0, {1, 0, 0}}, {minus_one * f0, {3, 0, 0}}});
  std::vector<SlidingVector> set;
  const std::array<int, 5> boole{7, 32, 12, 32, 7};
  for (int k = 0; k < 5; ++k) {
    const Number s = Number::rational(k, 4);
    const Number weight = Number::rational(3 * boole[static_cast<std::size_t>(k)], 90) * (Number(3) * s - s * s * s);
    const Value length = program.number(weight, units::metre);
    set.push_back({ab + program.number(s) * edge, length * f0});
  }
  const Wrench sum = screw_of<screw_kind::Wrench>(set, Vector());
  EXPECT_TRUE(identically_zero(exact.resultant - sum.resultant));
  EXPECT_TRUE(identically_zero(exact.moment - sum.moment));
  EXPECT_EQ(exact.moment[0].unit(), units::newton_metre);
}

TEST_F(Density, OverARectangleGivesTheCentreOfPressure) {
  // Water on a vertical gate a x b below the surface: p = p0 s2 grows with the depth s2 b; resultant p0 a b/2 at 2 b/3.
  const Value a = program.lower(make_symbol("a", "m"));
  const Value b = program.lower(make_symbol("b", "m"));
  const Value p0 = program.lower(make_symbol("p0", "N/m^2"));
  const DensityRegion gate{Vector(), {{a, Value(), Value()}, {Value(), Value(), -b}}};
  const Wrench thrust = screw_of_density<screw_kind::Wrench>(gate, {{{Value(), p0, Value()}, {0, 1, 0}}});
  // √(a² b²) is a b for the positive lengths of a gate; squares avoid the question.
  const Value squared = pow(thrust.resultant[1], 2);
  EXPECT_TRUE(identically_zero(squared - Number::rational(1, 4) * pow(p0 * a * b, 2)));
  const CentralAxis axis = central_axis(thrust, "thrust");
  EXPECT_TRUE(identically_zero(axis.ah[0] - Number::rational(1, 2) * a));
  EXPECT_TRUE(identically_zero(axis.ah[2] + Number::rational(2, 3) * b));
  EXPECT_TRUE(identically_zero(axis.pitch));
}

TEST_F(Density, InABoxOfUniformWeightPassesThroughItsCentre) {
  const DensityRegion box{
      ab, {numbers({2, 0, 0}, units::metre), numbers({1, 3, 0}, units::metre), numbers({0, 1, 5}, units::metre)}};
  const Vector weight = symbols("w", "N/m^3");
  const Wrench sum = screw_of_density<screw_kind::Wrench>(box, {{weight}});
  const Vector centre = ab + numbers({Number::rational(3, 2), 2, Number::rational(5, 2)}, units::metre);
  EXPECT_TRUE(identically_zero(sum.resultant - program.number(Number(30), Unit(0, 3)) * weight));
  EXPECT_TRUE(identically_zero(reduced_at(sum, centre).moment));
}

TEST_F(Density, NeedsARegionWithAMeasure) {
  const Vector f = symbols("f", "N/m");
  const auto integrate = [&](const std::vector<Vector>& edges, const std::array<int, 3>& powers) {
    return error_of<SceneError>([&] { integrate_density({Vector(), edges}, {{f, powers}}); });
  };
  EXPECT_EQ(integrate({}, {0, 0, 0}),
            "a density acts along a segment, over a parallelogram or in a parallelepiped: give 1, 2 or 3 edges instead "
            "of 0");
  EXPECT_EQ(integrate({ab, program.number(Number(2)) * ab}, {0, 0, 0}),
            "the 2 edges of a density's region span no area: give independent edges");
  EXPECT_EQ(integrate({ab}, {-1, 0, 0}), "a density has the power -1 along edge 1: only polynomials are integrated");
  EXPECT_EQ(integrate({ab}, {0, 1, 0}),
            "a density depends on edge 2 of a region that has 1: give that edge or drop the power");
}

TEST_F(TwistOfVelocities, IsTheTwistThatGaveThem) {
  const Vector a = symbols("a", "m");
  const auto moving = [&](const char* name, const Vector& place) {
    return PointVelocity{name, place, bound(program, reduced_at(twist, place).linear)};
  };
  const Twist found = twist_of_velocities(moving("A", a), moving("B", ab), moving("C", ac));
  EXPECT_TRUE(identically_zero(found.angular - twist.angular));
  EXPECT_TRUE(identically_zero(found.linear - reduced_at(twist, a).linear));
}

TEST_F(TwistOfVelocities, NamesThePairThatStretches) {
  const Vector at_rest;
  const PointVelocity a{"A", Vector(), at_rest};
  const PointVelocity b{"B", numbers({1, 0, 0}, units::metre), at_rest};
  const PointVelocity c{"C", numbers({1, 1, 0}, units::metre), numbers({0, 1, 0}, units::metre_per_second)};
  EXPECT_EQ(error_of<SceneError>([&] { twist_of_velocities(a, b, c); }),
            "points 'A' and 'C' do not move as points of one body: AC·(V_C − V_A) must vanish, their distance would "
            "change; correct one of the velocities");
  const PointVelocity aligned{"D", numbers({3, 0, 0}, units::metre), at_rest};
  EXPECT_EQ(error_of<SceneError>([&] { twist_of_velocities(a, b, aligned); }),
            "points 'A', 'B' and 'D' are aligned: their velocities leave the turn about their line open; take a point "
            "off the line");
}

TEST_F(MotionRecognised, FollowsTheInvariantsOfTheTwist) {
  EXPECT_EQ(recognise(Twist{}).kind, MotionKind::rest);
  EXPECT_EQ(recognise(Twist{twist.angular - twist.angular, twist.linear}).kind, MotionKind::translation);
  EXPECT_EQ(recognise(Twist{twist.angular, cross(twist.angular, ab)}).kind, MotionKind::rotation);
  const RigidMotion screw = recognise(twist);
  EXPECT_EQ(screw.kind, MotionKind::screw);
  ASSERT_TRUE(screw.axis);
  EXPECT_TRUE(identically_zero(cross(reduced_at(twist, screw.axis->ah).linear, twist.angular)));
  EXPECT_FALSE(recognise(Twist{}).axis);
  EXPECT_EQ(to_string(MotionKind::screw), "screw motion");
}

TEST_F(MotionRecognised, TellsAnAxisThatStaysFromOneThatMoves) {
  const TestCoordinate angle("q");
  const TestCoordinate place("s", units::metre);
  const Value turn = program.lower(angle.v);
  const auto twist_about = [&](const Value& x) {  // the vertical through (x, 0, 0)
    const Vector omega(Value(), Value(), turn);
    return Twist{omega, cross(omega, Vector(-x, Value(), Value()))};
  };
  const RigidMotion fixed = recognise(twist_about(program.number(Number(2), units::metre)));
  EXPECT_EQ(fixed.kind, MotionKind::rotation);
  EXPECT_TRUE(fixed.fixed_axis);
  const RigidMotion wandering = recognise(twist_about(program.lower(place.q)));
  EXPECT_EQ(wandering.kind, MotionKind::rotation);
  EXPECT_FALSE(wandering.fixed_axis);
  EXPECT_TRUE(identically_zero(wandering.axis->ah[0] - program.lower(place.q)));
  // An axis that turns, through a fixed point.
  const Vector leaning(turn * program.sin(program.lower(angle.q)), Value(), turn);
  EXPECT_FALSE(recognise(Twist{leaning, Vector()}).fixed_axis);
}

}  // namespace
}  // namespace torsor::screw_test
