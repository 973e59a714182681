// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "torsor/runtime/contacts/contact_system.hpp"

// Mechanisms in space of one to four bodies, trees and loops, with balls and corners on them that meet walls and each
// other.
namespace random_space_scenes {

using namespace torsor::runtime;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

struct Body {
  enum class Base { free, hinge, ball } base = Base::free;
  int parent = -1;           ///< -1: jointed to the ground
  Vector3d there{0, 0, 0};   ///< where it is jointed: on the ground or on its parent
  Vector3d here{0, 0, 0};    ///< on itself, from its centre of mass
  Vector3d axis{0, 0, 1};    ///< of a hinge, on the parent
  double mass = 1;
  Vector3d inertia{1, 1, 1};
};
struct Ball { int body; Vector3d centre; double radius; };  ///< a corner where the radius is 0
struct Wall { Vector3d normal; double at; };
struct Touch { int ball, other; bool wall; double friction, restitution; };
struct Pin { int a, b; Vector3d on_a, on_b; };  ///< closes a loop: one point of both

class SpaceScene {
 public:
  static constexpr std::size_t nq = 28, nv = 24, contacts = 8;
  static constexpr int constraints = 3;  ///< at most: a reading has as many rows as there are
  using State = std::array<double, nq + nv>;

  double g = 9.81;
  std::vector<Body> bodies;
  std::vector<Ball> balls;
  std::vector<Wall> walls{{{0, 0, 1}, 0}, {{1, 0, 0}, -2}, {{-1, 0, 0}, -2}, {{0, 0.6, 0.8}, -1.2}};
  std::vector<Touch> touches;
  std::vector<Pin> pins;

  [[nodiscard]] ContactRule rule(int i) const {
    if (i >= static_cast<int>(touches.size())) return {.tangents = 0};
    const Touch& touch = touches[static_cast<std::size_t>(i)];
    return {.tangents = touch.friction > 0 ? 2 : 0, .friction = touch.friction, .restitution = touch.restitution};
  }

  [[nodiscard]] Evaluation read(double, const State& y, ContactReading& reading) const {
    const std::vector<Place> places = places_of(y);
    reading.M.setZero();
    reading.F.setZero();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Place& at = places[k];
      const Matrix3d I = at.R * bodies[k].inertia.asDiagonal() * at.R.transpose();
      reading.M += bodies[k].mass * at.J.transpose() * at.J + at.turns.transpose() * I * at.turns;
      reading.F += bodies[k].mass * at.J.transpose() * (Vector3d(0, 0, -g) - at.bias);
      reading.F -= at.turns.transpose() * (I * at.turn_bias + at.w.cross(I * at.w));
    }
    for (Eigen::Index i = 0; i < reading.M.rows(); ++i) {
      if (reading.M(i, i) == 0) reading.M(i, i) = 1;  // a velocity that no body has
    }
    std::fill(reading.gap.begin(), reading.gap.end(), 1.0);
    reading.J.setZero();
    reading.w.setZero();
    reading.drift.setZero();
    int row = 0;
    for (std::size_t i = 0; i < touches.size(); ++i) read_contact(touches[i], places, reading, i, row);
    const auto m = static_cast<Eigen::Index>(3 * pins.size());
    reading.A.resize(m, Eigen::NoChange);
    for (auto* each : {&reading.gamma, &reading.value, &reading.rate}) each->resize(m);
    for (std::size_t k = 0; k < pins.size(); ++k) {
      const Place a = at_point(places, pins[k].a, pins[k].on_a), b = at_point(places, pins[k].b, pins[k].on_b);
      const auto first = static_cast<Eigen::Index>(3 * k);
      reading.A.middleRows(first, 3) = a.J - b.J;
      reading.gamma.segment(first, 3) = a.bias - b.bias;
      reading.value.segment(first, 3) = a.p - b.p;
      reading.rate.segment(first, 3) = a.v - b.v;
    }
    return Evaluation::ok;
  }

  void coordinate_rates(double, const State& y, std::array<double, nq>& rates) const {
    rates.fill(0);
    std::size_t q = 0, v = nq;
    for (const Body& body : bodies) {
      if (body.base == Body::Base::hinge) {
        rates[q++] = y[v++];
        continue;
      }
      for (int k = 0; body.base == Body::Base::free && k < 3; ++k) rates[q++] = y[v++];
      // The angular velocity in the axes of the parent, or of the ground: p' = ω p/2.
      const double x = y[v], h = y[v + 1], z = y[v + 2], p0 = y[q], p1 = y[q + 1], p2 = y[q + 2], p3 = y[q + 3];
      rates[q] = (-x * p1 - h * p2 - z * p3) / 2;
      rates[q + 1] = (x * p0 + h * p3 - z * p2) / 2;
      rates[q + 2] = (h * p0 + z * p1 - x * p3) / 2;
      rates[q + 3] = (z * p0 + x * p2 - h * p1) / 2;
      q += 4;
      v += 3;
    }
  }

  void normalise(State& y) const {
    std::size_t q = 0;
    for (const Body& body : bodies) {
      if (body.base == Body::Base::hinge) {
        ++q;
        continue;
      }
      if (body.base == Body::Base::free) q += 3;
      const double length = std::hypot(std::hypot(y[q], y[q + 1]), std::hypot(y[q + 2], y[q + 3]));
      for (int k = 0; k < 4; ++k) y[q++] /= length;
    }
  }

  /// Kinetic and potential energy.
  [[nodiscard]] std::pair<double, double> energies(const State& y) const {
    double kinetic = 0, potential = 0;
    const std::vector<Place> places = places_of(y);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Vector3d w = places[k].R.transpose() * places[k].w;
      kinetic += bodies[k].mass * places[k].v.squaredNorm() / 2 + w.dot(bodies[k].inertia.asDiagonal() * w) / 2;
      potential += bodies[k].mass * g * places[k].p.z();
    }
    return {kinetic, potential};
  }

  [[nodiscard]] ContactReading reading_at(const State& y) const {
    const ContactSizes sizes{static_cast<int>(nq), static_cast<int>(nv), static_cast<int>(contacts), constraints};
    ContactReading reading(sizes, 3 * static_cast<int>(contacts));
    (void)read(0, y, reading);
    return reading;
  }
  /// The gaps of all contacts that there are.
  [[nodiscard]] std::vector<double> gaps(const State& y) const {
    const ContactReading reading = reading_at(y);
    return {reading.gap.begin(), reading.gap.begin() + static_cast<std::ptrdiff_t>(touches.size())};
  }
  /// Pins the point of b that lies on that of a.
  void pin(const State& y, int a, int b, const Vector3d& on_a) {
    const std::vector<Place> places = places_of(y);
    const Place at = at_point(places, a, on_a), base = places[static_cast<std::size_t>(b)];
    pins.push_back({a, b, on_a, base.R.transpose() * (at.p - base.p)});
  }

 private:
  using Rows = Eigen::Matrix<double, 3, 24>;
  /// A point of a body: where it is, how it moves, its acceleration J a + bias; and how the body turns.
  struct Place {
    Vector3d p{0, 0, 0}, v{0, 0, 0}, bias{0, 0, 0}, w{0, 0, 0}, turn_bias{0, 0, 0};
    Rows J = Rows::Zero(), turns = Rows::Zero();
    Matrix3d R = Matrix3d::Identity();
  };

  // The columns of a × rows.
  [[nodiscard]] static Rows cross(const Rows& rows, const Vector3d& a) {
    Matrix3d K;
    K << 0, a.z(), -a.y(), -a.z(), 0, a.x(), a.y(), -a.x(), 0;
    return K * rows;  // rows × a
  }
  [[nodiscard]] static Place moved(const Place& from, const Vector3d& offset) {
    Place to = from;
    const Vector3d r = from.R * offset;
    to.p += r;
    to.v += from.w.cross(r);
    to.bias += from.turn_bias.cross(r) + from.w.cross(from.w.cross(r));
    to.J += cross(from.turns, r);
    return to;
  }
  [[nodiscard]] static Place at_point(const std::vector<Place>& places, int body, const Vector3d& offset) {
    return moved(places[static_cast<std::size_t>(body)], offset);
  }

  [[nodiscard]] std::vector<Place> places_of(const State& y) const {
    std::vector<Place> places;
    std::size_t q = 0, v = nq;
    const auto column = [](std::size_t at) { return static_cast<Eigen::Index>(at - nq); };
    for (const Body& body : bodies) {
      Place at;
      if (body.base == Body::Base::free) {
        for (int k = 0; k < 3; ++k, ++q, ++v) {
          at.p(k) = y[q];
          at.v(k) = y[v];
          at.J(k, column(v)) = 1;
        }
      } else if (body.parent < 0) {
        at.p = body.there;
      } else {
        at = at_point(places, body.parent, body.there);
      }
      const Matrix3d from = at.R;
      const Vector3d w = at.w;
      Vector3d relative{0, 0, 0};
      if (body.base == Body::Base::hinge) {
        relative = from * body.axis * y[v];
        at.turns.col(column(v++)) += from * body.axis;
        at.R = from * Eigen::AngleAxisd(y[q++], body.axis).toRotationMatrix();
      } else {
        for (int k = 0; k < 3; ++k, ++v) {
          relative += from.col(k) * y[v];
          at.turns.col(column(v)) += from.col(k);
        }
        at.R = from * Quaterniond(y[q], y[q + 1], y[q + 2], y[q + 3]).normalized().toRotationMatrix();
        q += 4;
      }
      at.w += relative;
      at.turn_bias += w.cross(relative);
      places.push_back(moved(at, -body.here));
    }
    return places;
  }

  void read_contact(const Touch& touch, const std::vector<Place>& places, ContactReading& reading, std::size_t i,
                    int& row) const {
    const Ball& ball = balls[static_cast<std::size_t>(touch.ball)];
    const Place a = at_point(places, ball.body, ball.centre);
    Place b;
    Vector3d n, turns{0, 0, 0};
    double radius_b = 0;
    if (touch.wall) {
      const Wall& wall = walls[static_cast<std::size_t>(touch.other)];
      n = wall.normal;
      reading.gap[i] = n.dot(a.p) - wall.at - ball.radius;
    } else {
      const Ball& other = balls[static_cast<std::size_t>(touch.other)];
      b = at_point(places, other.body, other.centre);
      radius_b = other.radius;
      const double distance = (a.p - b.p).norm();
      n = (a.p - b.p) / distance;
      reading.gap[i] = distance - ball.radius - radius_b;
      turns = (a.v - b.v - n * n.dot(a.v - b.v)) / distance;
    }
    const double ra = ball.radius, rb = radius_b;
    const Vector3d slip = a.v - b.v - ra * a.w.cross(n) - rb * b.w.cross(n);
    const Rows slips = a.J - b.J - ra * cross(a.turns, n) - rb * cross(b.turns, n);
    const Vector3d bias = a.bias - b.bias - ra * (a.turn_bias.cross(n) + a.w.cross(turns)) -
                          rb * (b.turn_bias.cross(n) + b.w.cross(turns));
    const auto add = [&](const Vector3d& along, const Vector3d& rate) {
      reading.J.row(row) = along.transpose() * slips;
      reading.w(row) = along.dot(slip);
      reading.drift(row++) = along.dot(bias) + rate.dot(slip);
    };
    add(n, turns);
    // Tangents that turn smoothly but where n = -e_z.
    const Vector3d m = n + Vector3d::UnitZ();
    const double c = 1 + n.z();
    for (int k = 0; k < 2 && touch.friction > 0; ++k) {
      add(Vector3d::Unit(k) - n(k) / c * m, -turns(k) / c * m - n(k) / c * (turns - turns.z() / c * m));
    }
  }
};

struct Start { SpaceScene scene; SpaceScene::State y{}; };

/// The k-th scene, the same on every machine.
inline Start random_space_start(unsigned k) {
  std::mt19937 source(20261124 + k);
  const auto number = [&](double low, double high) { return low + (high - low) * (static_cast<double>(source()) / 4294967296.0); };
  const auto choice = [&](int n) { return static_cast<int>(source() % static_cast<unsigned>(n)); };
  const auto vector = [&](double x, double y, double z) {
    Vector3d v;
    for (int i = 0; i < 3; ++i) v(i) = number(-1, 1);
    return Vector3d(x * v.x(), y * v.y(), z * v.z());
  };
  for (;;) {
    Start start;
    SpaceScene& scene = start.scene;
    const int count = 1 + choice(4);
    std::size_t q = 0, v = SpaceScene::nq;
    for (int i = 0; i < count; ++i) {
      Body body;
      body.mass = number(0.5, 2);
      const double turn = body.mass * number(0.01, 0.04);
      body.inertia = {turn, turn * number(0.6, 1.4), turn * number(0.8, 1.2)};
      const int base = choice(4);
      if (base > 1 || (base == 1 && i > 0)) {
        body.base = choice(2) == 0 ? Body::Base::hinge : Body::Base::ball;
        body.parent = i > 0 && base != 3 ? choice(i) : -1;
        body.axis = vector(1, 1, 1).normalized();
        body.here = vector(0.3, 0.1, 0.1);
        body.there = body.parent < 0 ? Vector3d(number(-1, 1), number(-1, 1), number(0.3, 0.8)) : vector(0.3, 0.1, 0.1);
      }
      if (body.base == Body::Base::free) {
        for (const double place : {number(-1.5, 1.5), number(-1, 1), number(0.3, 0.9)}) start.y[q++] = place;
        for (const double speed : {number(-3, 3), number(-3, 3), number(-3, 1)}) start.y[v++] = speed;
      }
      const int turns = body.base == Body::Base::hinge ? 1 : 3;
      if (turns == 1) start.y[q++] = number(-3, 3);
      for (int j = 0; turns == 3 && j < 4; ++j) start.y[q++] = number(-1, 1);
      for (int j = 0; j < turns; ++j) start.y[v++] = number(-5, 5);
      scene.bodies.push_back(body);
      const int on_it = 1 + choice(2);
      for (int d = 0; d < on_it; ++d) {
        scene.balls.push_back({i, vector(0.3, 0.15, 0.15), choice(4) == 0 ? 0 : number(0.05, 0.15)});
      }
    }
    scene.normalise(start.y);
    const bool joined = scene.bodies.back().base != Body::Base::free && scene.bodies.back().parent <= 0;
    if (count > 2 && choice(2) == 0 && !joined && scene.bodies[0].base != Body::Base::hinge) {
      scene.pin(start.y, 0, count - 1, vector(0.3, 0.3, 0.3));
    }
    const double e = choice(3) == 0 ? 0 : number(0.1, 0.8), f = choice(3) == 0 ? 0 : number(0.05, 0.4);
    std::vector<Touch> possible;
    for (int d = 0; d < static_cast<int>(scene.balls.size()); ++d) {
      const Ball& ball = scene.balls[static_cast<std::size_t>(d)];
      for (int w = 0; w < 4; ++w) possible.push_back({d, w, true, f, e});
      for (int o = 0; o < d; ++o) {
        const Ball& other = scene.balls[static_cast<std::size_t>(o)];
        // Bodies of one joint move by too few velocities against each other for a contact between them.
        const Body& upper = scene.bodies[static_cast<std::size_t>(ball.body)];
        const bool jointed = upper.base != Body::Base::free && upper.parent == other.body;
        if (ball.body != other.body && !jointed && ball.radius + other.radius > 0) possible.push_back({d, o, false, f, e});
      }
    }
    const int wanted = 1 + choice(8);
    while (static_cast<int>(scene.touches.size()) < wanted && !possible.empty()) {
      const auto which = static_cast<std::size_t>(choice(static_cast<int>(possible.size())));
      scene.touches.push_back(possible[which]);
      possible.erase(possible.begin() + static_cast<std::ptrdiff_t>(which));
    }
    const std::vector<double> gaps = scene.gaps(start.y);
    if (std::all_of(gaps.begin(), gaps.end(), [](double gap) { return gap > 1e-3; })) return start;
  }
}

}  // namespace random_space_scenes
