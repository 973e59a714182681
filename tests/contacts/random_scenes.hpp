// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "torsor/runtime/contacts/contact_system.hpp"

// Plane mechanisms of one to four bodies, trees and loops, with discs on them that meet walls and each other.
namespace random_scenes {

using namespace torsor::runtime;
using Vector2 = Eigen::Vector2d;

inline Vector2 across(const Vector2& a) { return {-a.y(), a.x()}; }
inline Vector2 turned(const Vector2& a, double angle) { return std::cos(angle) * a + std::sin(angle) * across(a); }

struct Body {
  enum class Base { free, on_ground, on_body } base = Base::free;
  int parent = 0;
  Vector2 there{0, 0};  ///< where it is jointed: on the ground or on its parent
  Vector2 here{0, 0};   ///< on itself, from its centre of mass
  double mass = 1, inertia = 1;
};
struct Disc { int body; Vector2 centre; double radius; };
struct Wall { Vector2 normal; double at; };
struct Touch { int disc, other; bool wall; double friction, restitution; };
struct Pin { int a, b; Vector2 on_a, on_b; };  ///< closes a loop

class RandomScene {
 public:
  static constexpr std::size_t nq = 12, nv = 12, contacts = 8;
  static constexpr int constraints = 4;  ///< at most: a reading has as many rows as there are
  using State = std::array<double, nq + nv>;
  double g = 9.81;

  std::vector<Body> bodies;
  std::vector<Disc> discs;
  std::vector<Wall> walls{{{0, 1}, 0}, {{1, 0}, -2}, {{-1, 0}, -2}};
  std::vector<Touch> touches;
  std::vector<Pin> pins;

  [[nodiscard]] ContactRule rule(int i) const {
    if (i >= static_cast<int>(touches.size())) return {.tangents = 0};
    const Touch& touch = touches[static_cast<std::size_t>(i)];
    return {.tangents = touch.friction > 0 ? 1 : 0, .friction = touch.friction, .restitution = touch.restitution};
  }

  [[nodiscard]] Evaluation read(double, const State& y, ContactReading& reading) const {
    const std::vector<Place> places = places_of(y);
    reading.M.setIdentity();
    reading.F.setZero();
    Eigen::Index n = 0;
    for (const Place& place : places) n = std::max(n, place.angle + 1);
    reading.M.topLeftCorner(n, n).setZero();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Place& at = places[k];
      const double m = bodies[k].mass;
      reading.M += m * at.J.transpose() * at.J;
      reading.M(at.angle, at.angle) += bodies[k].inertia;
      reading.F += m * at.J.transpose() * (Vector2(0, -g) - at.bias);
    }
    std::fill(reading.gap.begin(), reading.gap.end(), 1.0);
    reading.J.setZero();
    reading.w.setZero();
    reading.drift.setZero();
    int row = 0;
    for (std::size_t i = 0; i < touches.size(); ++i) read_contact(touches[i], places, reading, static_cast<int>(i), row);
    const auto m = static_cast<Eigen::Index>(2 * pins.size());
    reading.A.resize(m, Eigen::NoChange);
    for (auto* each : {&reading.gamma, &reading.value, &reading.rate}) each->resize(m);
    for (std::size_t k = 0; k < pins.size(); ++k) {
      const Place a = at_point(places, pins[k].a, pins[k].on_a), b = at_point(places, pins[k].b, pins[k].on_b);
      const auto first = static_cast<Eigen::Index>(2 * k);
      reading.A.middleRows(first, 2) = a.J - b.J;
      reading.gamma.segment(first, 2) = a.bias - b.bias;
      reading.value.segment(first, 2) = a.p - b.p;
      reading.rate.segment(first, 2) = a.v - b.v;
    }
    return Evaluation::ok;
  }

  void coordinate_rates(double, const State& y, std::array<double, nq>& rates) const {
    for (std::size_t i = 0; i < nq; ++i) rates[i] = y[nq + i];
  }

  /// Kinetic energy and potential energy.
  [[nodiscard]] std::pair<double, double> energies(const State& y) const {
    double kinetic = 0, potential = 0;
    const std::vector<Place> places = places_of(y);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const double turning = y[nq + static_cast<std::size_t>(places[k].angle)];
      kinetic += bodies[k].mass * places[k].v.squaredNorm() / 2 + bodies[k].inertia * turning * turning / 2;
      potential += bodies[k].mass * g * places[k].p.y();
    }
    return {kinetic, potential};
  }

 private:
  using Rows = Eigen::Matrix<double, 2, 12>;
  /// A point of a body: where it is, how it moves, and its acceleration J a + bias.
  struct Place {
    Vector2 p{0, 0}, v{0, 0}, bias{0, 0};
    Rows J = Rows::Zero();
    Eigen::Index angle = 0;
    double turn = 0, turning = 0;
  };

  [[nodiscard]] static Place moved(const Place& from, const Vector2& offset) {
    Place to = from;
    const Vector2 r = turned(offset, from.turn);
    to.p += r;
    to.v += from.turning * across(r);
    to.bias -= from.turning * from.turning * r;
    to.J.col(from.angle) += across(r);
    return to;
  }
  [[nodiscard]] static Place at_point(const std::vector<Place>& places, int body, const Vector2& offset) {
    return moved(places[static_cast<std::size_t>(body)], offset);
  }

  [[nodiscard]] std::vector<Place> places_of(const State& y) const {
    std::vector<Place> places;
    std::size_t next = 0;
    for (const Body& body : bodies) {
      Place at;
      if (body.base == Body::Base::free) {
        for (int k = 0; k < 2; ++k, ++next) {
          at.p(k) = y[next];
          at.v(k) = y[nq + next];
          at.J(k, static_cast<Eigen::Index>(next)) = 1;
        }
      } else if (body.base == Body::Base::on_ground) {
        at.p = body.there;
      } else {
        at = at_point(places, body.parent, body.there);
      }
      at.angle = static_cast<Eigen::Index>(next);
      at.turn = y[next];
      at.turning = y[nq + next];
      ++next;
      places.push_back(moved(at, -body.here));
    }
    return places;
  }

  void read_contact(const Touch& touch, const std::vector<Place>& places, ContactReading& reading, int i, int& row) const {
    const Disc& disc = discs[static_cast<std::size_t>(touch.disc)];
    const Place a = at_point(places, disc.body, disc.centre);
    Place b;
    Vector2 n;
    double& gap = reading.gap[static_cast<std::size_t>(i)];
    double turns = 0, radius_b = 0;
    if (touch.wall) {
      const Wall& wall = walls[static_cast<std::size_t>(touch.other)];
      n = wall.normal;
      gap = n.dot(a.p) - wall.at - disc.radius;
    } else {
      const Disc& other = discs[static_cast<std::size_t>(touch.other)];
      b = at_point(places, other.body, other.centre);
      radius_b = other.radius;
      const double distance = (a.p - b.p).norm();
      n = (a.p - b.p) / distance;
      gap = distance - disc.radius - other.radius;
      turns = across(n).dot(a.v - b.v) / distance;
    }
    const Vector2 t = across(n), u = a.v - b.v;
    reading.J.row(row) = n.transpose() * (a.J - b.J);
    reading.w(row) = n.dot(u);
    reading.drift(row) = n.dot(a.bias - b.bias) + turns * t.dot(u);
    ++row;
    if (!(touch.friction > 0)) return;
    reading.J.row(row) = t.transpose() * (a.J - b.J);
    reading.J(row, a.angle) -= disc.radius;
    if (!touch.wall) reading.J(row, b.angle) -= radius_b;
    reading.w(row) = t.dot(u) - disc.radius * a.turning - radius_b * (touch.wall ? 0 : b.turning);
    reading.drift(row) = t.dot(a.bias - b.bias) - turns * n.dot(u);
    ++row;
  }

 public:
  [[nodiscard]] ContactReading reading_at(const State& y) const {
    ContactReading reading({static_cast<int>(nq), static_cast<int>(nv), static_cast<int>(contacts), constraints}, 3 * static_cast<int>(contacts));
    (void)read(0, y, reading);
    return reading;
  }
  /// The gaps of all contacts that there are.
  [[nodiscard]] std::vector<double> gaps(const State& y) const {
    const ContactReading reading = reading_at(y);
    return {reading.gap.begin(), reading.gap.begin() + static_cast<std::ptrdiff_t>(touches.size())};
  }
  /// Where a loop that these bodies close may be pinned: the point of b that lies on that of a.
  void pin(const State& y, int a, int b, const Vector2& on_a) {
    const std::vector<Place> places = places_of(y);
    const Place at = at_point(places, a, on_a), base = places[static_cast<std::size_t>(b)];
    pins.push_back({a, b, on_a, turned(at.p - base.p, -base.turn)});
  }
};

struct Start { RandomScene scene; RandomScene::State y{}; };

/// The k-th scene: the same on every machine but for the distributions of its standard library.
inline Start random_start(unsigned k) {
  std::mt19937 source(20261123 + k);
  const auto number = [&](double low, double high) { return low + (high - low) * (static_cast<double>(source()) / 4294967296.0); };
  const auto choice = [&](int n) { return static_cast<int>(source() % static_cast<unsigned>(n)); };
  for (;;) {
    Start start;
    RandomScene& scene = start.scene;
    const int count = 1 + choice(4);
    std::size_t next = 0;
    for (int i = 0; i < count; ++i) {
      Body body;
      body.mass = number(0.5, 2);
      body.inertia = body.mass * number(0.01, 0.05);
      const int base = choice(3);
      if (i > 0 && base > 0) {
        body.base = Body::Base::on_body;
        body.parent = choice(i);
        body.there = {number(-0.3, 0.3), number(-0.1, 0.1)};
        body.here = {number(-0.3, 0.3), number(-0.1, 0.1)};
      } else if (base == 2) {
        body.base = Body::Base::on_ground;
        body.there = {number(-1, 1), number(0.5, 1.2)};
        body.here = {number(0.2, 0.4), 0};
      }
      scene.bodies.push_back(body);
      if (body.base == Body::Base::free) {
        start.y[next] = number(-1.5, 1.5);
        start.y[RandomScene::nq + next++] = number(-3, 3);
        start.y[next] = number(0.5, 1.5);
        start.y[RandomScene::nq + next++] = number(-3, 1);
      }
      start.y[next] = number(-3, 3);
      start.y[RandomScene::nq + next++] = number(-5, 5);
      const int on_it = 1 + choice(2);
      for (int d = 0; d < on_it; ++d) scene.discs.push_back({i, {number(-0.3, 0.3), number(-0.1, 0.1)}, number(0.05, 0.15)});
    }
    // Two pins between the same two bodies would say the same twice.
    const bool joined = scene.bodies.back().base == Body::Base::on_body && scene.bodies.back().parent == 0;
    if (count > 2 && choice(2) == 0 && !joined) scene.pin(start.y, 0, count - 1, {number(-0.3, 0.3), number(-0.3, 0.3)});
    const double e = choice(3) == 0 ? 0 : number(0.1, 0.8), f = choice(3) == 0 ? 0 : number(0.05, 0.4);
    std::vector<Touch> possible;
    for (int d = 0; d < static_cast<int>(scene.discs.size()); ++d) {
      for (int w = 0; w < 3; ++w) possible.push_back({d, w, true, f, e});
      for (int o = 0; o < d; ++o) {
        if (scene.discs[static_cast<std::size_t>(d)].body != scene.discs[static_cast<std::size_t>(o)].body) {
          possible.push_back({d, o, false, f, e});
        }
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

}  // namespace random_scenes
