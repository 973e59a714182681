// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/dynamics/motion/ground_motion.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/verification/check_contacts.hpp"
#include "torsor/generator/verification/random_state.hpp"

namespace torsor::contacts_test {
namespace {

using namespace torsor::literals;

/// A free body in space, so far up that it touches nothing, and the plane of the ground or of a moving frame.
struct InSpace {
  Scene scene{"contacts"};
  FrameHandle table, body;
  InSpace() {
    const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
    const Expression tilt = scene.coordinate("tilt", "rad");
    const AttitudeHandle turn = scene.attitude("turn");
    scene.initial(z, 9);
    table = scene.revolute("table", scene.ground(), axis::x, tilt);
    body = scene.free("body", scene.ground(), {x, y, z}, turn);
    scene.body("table", table, Inertia::box(Expression::quantity("1", "kg"), Expression::quantity("1", "m"), Expression::quantity("2", "m"), Expression::quantity("0.1", "m")));
    scene.body("body", body, Inertia::solid_sphere(Expression::quantity("1", "kg"), Expression::quantity("0.5", "m")));
  }
};

/// A body in the plane x, z.
struct InPlane {
  Scene scene{"contacts"};
  Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m"), turn = scene.coordinate("turn", "rad");
  FrameHandle body = make();
  FrameHandle make() {
    scene.initial(z, 9);
    const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
    const FrameHandle lift = scene.prismatic("lift", slide, axis::z, z);
    const FrameHandle turned = scene.revolute("body", lift, axis::y, turn);
    scene.body("body", turned, Inertia::solid_sphere(Expression::quantity("1", "kg"), Expression::quantity("0.5", "m")));
    return turned;
  }
};

const Expression metre = Expression::quantity("1", "m");
const SurfaceLaw rough{.friction = 0.3_r, .restitution = 0.5_r};

struct Shape {
  std::string name;
  bool normal;
  std::size_t tangents;
};

std::vector<Shape> shapes_of(const Scene& scene) {
  Program program(Model::resolver(scene, {}));
  const Model model(scene, program);
  std::vector<Shape> shapes;
  for (const ContactRows& contact : contact_rows(model)) {
    shapes.push_back({contact.name, contact.normal, contact.tangents()});
  }
  return shapes;
}

// Derivatives along motions in sixty digits: gaps against their rates and rows, slips against their drifts.
void expect_consistent(const Scene& scene) {
  for (const CheckResult& result : check_contacts(scene, {.digits = 30, .states = 3})) {
    EXPECT_TRUE(result.passed()) << result.name << ": " << result.worst;
  }
}

TEST(Contacts, OfEveryShapeWithAMovingPlaneAreConsistent) {
  const auto u_norm = [](const Triple& u) {
    return metre * sqrt(pow(u[0], 2) + 2 * pow(u[1], 2) + 3 * pow(u[2], 2));
  };
  InSpace s;
  const shape::Plane plane{.frame = s.table, .belt = {Expression::quantity("0.2", "m/s"), Expression(0)}};
  const PointHandle tip = s.scene.point("tip", s.body, {0.1_r * metre, 0.2_r * metre, -0.3_r * metre});
  s.scene.contact("point", shape::Point{tip}, plane, rough);
  s.scene.contact("sphere", plane, shape::Sphere{.frame = s.body, .radius = 0.5_r * metre}, rough);
  s.scene.contact("disc", shape::Disc{.frame = s.body, .axis = axis::y, .radius = 0.5_r * metre}, plane, rough);
  s.scene.contact("ellipsoid", shape::Ellipsoid{.frame = s.body, .semi_axes = {metre, 0.5_r * metre, 0.2_r * metre}}, plane, rough);
  s.scene.contact("convex", shape::Convex{.frame = s.body, .support = u_norm}, plane, rough);
  s.scene.contact("spheres", shape::Sphere{.frame = s.body, .radius = 0.5_r * metre},
                  shape::Sphere{.frame = s.table, .radius = 0.2_r * metre}, rough);
  s.scene.contact("bowl", shape::HollowSphere{.frame = s.table, .radius = 20 * metre},
                  shape::Sphere{.frame = s.body, .radius = 0.5_r * metre}, rough);
  for (const Shape& contact : shapes_of(s.scene)) EXPECT_EQ(contact.tangents, 2U) << contact.name;
  expect_consistent(s.scene);
}

/// A unit reaction of a row, put on the first body at the contact's point and taken from the second, has the row's generalised forces.
void expect_places_of_rows(const Scene& scene, const std::vector<std::pair<FrameHandle, FrameHandle>>& bodies) {
  const WorkingDigits precision(50);
  Program program(Model::resolver(scene, {}));
  const Model model(scene, program);
  const GroundMotion motion(model);
  const std::vector<ContactRows> rows = contact_rows(model);
  const std::vector<ContactPlace> places = contact_places(model);
  const RandomState state(scene, 7);
  ASSERT_EQ(places.size(), rows.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    ASSERT_EQ(places[k].directions.size(), rows[k].rows.size());
    const auto partials = [&](const FrameHandle& body) {
      const int link = model.place(body, "test").link;
      return motion.partial_velocities(link, bound(program, places[k].point - motion.origin(link)));
    };
    const std::vector<Vector> first = partials(bodies[k].first), second = partials(bodies[k].second);
    for (std::size_t row = 0; row < rows[k].rows.size(); ++row) {
      for (std::size_t i = 0; i < rows[k].rows[row].jacobian.size(); ++i) {
        const Value force = program.bind(dot(places[k].directions[row], bound(program, first[i] - second[i])));
        Evaluator<Real> at(program, state.in_real());
        // Numbers of order one to 1e2 in 50 digits.
        EXPECT_LE(abs(at(force) - at(rows[k].rows[row].jacobian[i])).to_double(), 1e-44) << rows[k].name << " " << row << " " << i;
      }
    }
  }
}

// No field of directions turns smoothly on all of a sphere: near its pole the axes of friction lose digits. Balls that are placed by
// hand, as at (2, 3, 6)/7 of their distance, are not there.
TEST(Contacts, BetweenSpheresHaveUnitAxesInEveryUsualDirection) {
  InSpace s;
  s.scene.contact("spheres", shape::Sphere{.frame = s.body, .radius = 0.35_r * metre},
                  shape::Sphere{.frame = s.scene.ground(), .radius = 0.35_r * metre}, rough);
  Program program(Model::resolver(s.scene, {}));
  const Model model(s.scene, program);
  const std::vector<Vector> directions = contact_places(model)[0].directions;
  ASSERT_EQ(directions.size(), 3U);
  std::vector<Value> products;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) products.push_back(program.bind(dot(directions[i], directions[j])));
  }
  const std::vector<double> unit{1, 0, 1, 0, 0, 1};
  double worst = 0;
  for (int x = -7; x <= 7; ++x) {
    for (int y = -7; y <= 7; ++y) {
      for (int z = -7; z <= 7; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        Evaluator<double> at(program, [&](const SymbolPointer& symbol) {
          return 0.1 * (symbol->name == "x" ? x : symbol->name == "y" ? y : z);
        });
        for (std::size_t k = 0; k < products.size(); ++k) worst = std::max(worst, std::abs(at(products[k]) - unit[k]));
      }
    }
  }
  EXPECT_LT(worst, 1e-14);  // some roundings over an angle of a thirtieth
}

TEST(Contacts, HaveForcesAtTheirPoints) {
  InSpace s;
  const shape::Plane plane{.frame = s.table, .belt = {Expression::quantity("0.2", "m/s"), Expression(0)}};
  s.scene.contact("point", shape::Point{s.scene.point("tip", s.body, {0.1_r * metre, 0.2_r * metre, -0.3_r * metre})}, plane, rough);
  s.scene.contact("sphere", plane, shape::Sphere{.frame = s.body, .radius = 0.5_r * metre}, rough);
  s.scene.contact("disc", shape::Disc{.frame = s.body, .axis = axis::y, .radius = 0.5_r * metre}, plane, rough);
  s.scene.contact("spheres", shape::Sphere{.frame = s.body, .radius = 0.5_r * metre},
                  shape::Sphere{.frame = s.table, .radius = 0.2_r * metre}, rough);
  s.scene.contact("bowl", shape::HollowSphere{.frame = s.table, .radius = 20 * metre},
                  shape::Sphere{.frame = s.body, .radius = 0.5_r * metre}, rough);
  expect_places_of_rows(s.scene, std::vector<std::pair<FrameHandle, FrameHandle>>(5, {s.body, s.table}));

  InPlane flat;
  flat.scene.contact("circle", shape::Sphere{.frame = flat.body, .radius = 0.5_r * metre},
                     shape::Plane{.frame = flat.scene.ground()}, rough);
  flat.scene.contact("drum", shape::Sphere{.frame = flat.body, .radius = 0.5_r * metre},
                     shape::HollowSphere{.frame = flat.scene.ground(), .radius = 20 * metre}, rough);
  expect_places_of_rows(flat.scene, {{flat.body, flat.scene.ground()}, {flat.body, flat.scene.ground()}});
}

TEST(Contacts, InAPlaneHaveOneTangent) {
  InPlane s;
  const shape::Plane floor{.frame = s.scene.ground()};
  s.scene.contact("circle", shape::Sphere{.frame = s.body, .radius = 0.5_r * metre}, floor, rough);
  s.scene.contact("drum", shape::Sphere{.frame = s.body, .radius = 0.5_r * metre},
                  shape::HollowSphere{.frame = s.scene.ground(), .radius = 20 * metre}, rough);
  s.scene.contact("box", shape::Box{.frame = s.body, .half_edges = {0.2_r * metre, 0, 0.1_r * metre}}, floor, rough);
  s.scene.contact("smooth", shape::Sphere{.frame = s.body, .radius = 0.4_r * metre}, floor);
  s.scene.stop(s.turn, -1, 1);
  s.scene.dry_friction("bearing", s.turn, {.bound = Expression::quantity("0.1", "N m")});
  const std::vector<Shape> rows = shapes_of(s.scene);
  ASSERT_EQ(rows.size(), 10U);
  EXPECT_EQ(rows[2].name, "box_1");
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(rows[k].tangents, 1U) << rows[k].name;
  EXPECT_EQ(rows[6].tangents, 0U);
  EXPECT_EQ(rows[7].name, "turn_lower");
  EXPECT_EQ(rows[8].tangents, 0U);
  EXPECT_FALSE(rows[9].normal);
  EXPECT_EQ(rows[9].tangents, 1U);
  expect_consistent(s.scene);
}

TEST(Contacts, ThatResistTurnsHaveRowsOfAngularVelocities) {
  const SurfaceLaw soft{.friction = 0.3_r, .rolling = 0.01_r * metre, .spinning = 0.002_r * metre};
  InSpace s;
  s.scene.contact("sphere", shape::Sphere{.frame = s.body, .radius = 0.5_r * metre}, shape::Plane{.frame = s.table}, soft);
  s.scene.contact("spheres", shape::Sphere{.frame = s.body, .radius = 0.5_r * metre},
                  shape::Sphere{.frame = s.table, .radius = 0.2_r * metre}, soft);
  const std::vector<Shape> rows = shapes_of(s.scene);
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[1].name, "sphere_rolling");
  EXPECT_EQ(rows[1].tangents, 2U);
  EXPECT_EQ(rows[5].name, "spheres_spinning");
  EXPECT_EQ(rows[5].tangents, 1U);
  EXPECT_FALSE(rows[5].normal);
  expect_consistent(s.scene);

  InPlane flat;
  flat.scene.contact("circle", shape::Sphere{.frame = flat.body, .radius = 0.5_r * metre},
                     shape::Plane{.frame = flat.scene.ground()}, {.friction = 0.3_r, .rolling = 0.01_r * metre});
  ASSERT_EQ(shapes_of(flat.scene).size(), 2U);
  EXPECT_EQ(shapes_of(flat.scene)[1].tangents, 1U);
  expect_consistent(flat.scene);
  const Equations equations(flat.scene);
  const ConstantTable pressed_by = make_kernel("contacts", equations).structures[0].tables.back();
  EXPECT_EQ(pressed_by.name, "contact_pressed_by");
  EXPECT_EQ(std::get<ConstantTable::Indices>(pressed_by.value), (ConstantTable::Indices{0, 1}));
}

TEST(Contacts, AreAbsentFromKernelsOfAMechanismWithoutAny) {
  const InPlane s;
  EXPECT_EQ(why_absent("contacts", Equations(s.scene)), "the scene has no contacts that open and close");
  EXPECT_EQ(why_absent("contact_coefficients", Equations(s.scene)), "the scene has no contacts that open and close");
}

void expect_error(const std::function<void(InPlane&)>& change, const std::string& message) {
  try {
    InPlane s;
    change(s);
    validate(s.scene);
    ADD_FAILURE() << "accepted; expected: " << message;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(Contacts, ThatNoSurfaceCanHaveAreRefused) {
  const auto law = [](const SurfaceLaw& given) {
    return [given](InPlane& s) {
      s.scene.contact("floor", shape::Sphere{.frame = s.body, .radius = metre}, shape::Plane{.frame = s.scene.ground()}, given);
    };
  };
  expect_error(law({.friction = -0.1_r}), "contact 'floor' has the friction");
  expect_error(law({.friction = 0.5_r, .static_friction = 0.4_r}), "contact 'floor' has the static friction");
  expect_error(law({.restitution = 1.1_r}), "contact 'floor' has the restitution");
  expect_error(law({.restitution = -0.1_r}), "contact 'floor' has the restitution");
  expect_error(law({.friction = 0.3_r, .rolling = -1 * metre}), "contact 'floor_rolling' has the length");
  expect_error(law({.friction = 0.3_r, .rolling = 0.1_r}), "the resistance to rolling of the contact 'floor'");
  expect_error(law({.friction = 0.3_r, .spinning = metre}), "contact 'floor_spinning' resists a turn that nothing can make");
  expect_error(
      [](InPlane& s) {
        s.scene.contact("floor", shape::Box{.frame = s.body, .half_edges = {metre, 0, metre}}, shape::Plane{.frame = s.scene.ground()},
                        {.rolling = metre});
      },
      "a box has corners");
  expect_error(law({.friction = metre}), "the friction of the contact 'floor'");
  expect_error(
      [](InPlane& s) {
        const Expression f = s.scene.run_time_parameter("f", "1", -0.2_r);
        s.scene.contact("floor", shape::Sphere{.frame = s.body, .radius = metre}, shape::Plane{.frame = s.scene.ground()},
                        {.friction = 2 * f});
      },
      "contact 'floor' has the friction");
  expect_error(
      [](InPlane& s) {
        s.scene.contact("floor", shape::Sphere{.frame = s.body, .radius = metre}, shape::Plane{.frame = s.scene.ground()},
                        {.friction = s.turn});
      },
      "the friction of contact 'floor' depends on the coordinate 'turn'");
  expect_error([](InPlane& s) { s.scene.dry_friction("rub", s.turn, {.bound = Expression::quantity("-1", "N m")}); },
               "contact 'rub' has the bound");
  expect_error([](InPlane& s) { s.scene.dry_friction("rub", s.turn, {.bound = metre}); }, "the bound of the dry friction 'rub'");
}

TEST(Contacts, ThatCannotBeginAreRefused) {
  expect_error(
      [](InPlane& s) {
        s.scene.contact("floor", shape::Sphere{.frame = s.body, .radius = 10 * metre}, shape::Plane{.frame = s.scene.ground()});
      },
      "contact 'floor' starts penetrating: its gap is -1 m");
  expect_error([](InPlane& s) { s.scene.stop(s.turn, 1, -1); }, "the stop 'turn_lower' at 1");
  expect_error([](InPlane& s) { s.scene.stop(s.turn, 1, 2); }, "contact 'turn_lower' starts penetrating");
  expect_error([](InPlane& s) { s.scene.stop(s.turn, std::nullopt, std::nullopt); }, "neither a lower nor an upper");
  expect_error([](InPlane& s) { s.scene.stop(s.turn, metre, std::nullopt); }, "the lower stop of 'turn'");
  expect_error(
      [](InPlane& s) {
        s.scene.contact("twice", shape::Sphere{.frame = s.body, .radius = metre}, shape::Box{.frame = s.scene.ground(), .half_edges = {metre, metre, metre}});
      },
      "the contact 'twice' is between a sphere and a box");
  expect_error(
      [](InPlane& s) {
        const FrameHandle wall = s.scene.weld("wall", s.scene.ground(), {});
        s.scene.contact("still", shape::Sphere{.frame = wall, .radius = metre}, shape::Plane{.frame = s.scene.ground()});
      },
      "contact 'still' involves no coordinate");
  expect_error(
      [](InPlane& s) {
        s.scene.contact("pin", shape::Sphere{.frame = s.body, .radius = 2 * metre},
                        shape::HollowSphere{.frame = s.scene.ground(), .radius = metre});
      },
      "the sphere must be smaller");
}

}  // namespace
}  // namespace torsor::contacts_test
