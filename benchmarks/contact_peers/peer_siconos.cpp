// SPDX-License-Identifier: GPL-3.0-or-later
// Siconos: Moreau and Jean's steps, its event-driven motion where nothing rubs, and its sweeps of Gauss and Seidel. The
// chain's mass matrix, forces, gaps and rows are those of our generated header.
#include <SiconosKernel.hpp>

#include <FrictionContactProblem.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <SparseBlockMatrix.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/contact_peers/closed_forms.hpp"
#include "benchmarks/contact_peers/peers.hpp"
#include "chain_on_floor.hpp"

namespace torsor::contact_peers {
namespace {

using Mechanism = ::chain_on_floor::Mechanism<double>;
constexpr unsigned rods = 4;

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::shared_ptr<SiconosVector> vector_of(double value) {
  auto result = std::make_shared<SiconosVector>(1);
  (*result)(0) = value;
  return result;
}
std::shared_ptr<SimpleMatrix> one() {
  auto result = std::make_shared<SimpleMatrix>(1, 1);
  (*result)(0, 0) = 1;
  return result;
}

void to_the_end(TimeStepping& simulation) {
  while (simulation.hasNextEvent()) {
    simulation.computeOneStep();
    simulation.nextStep();
  }
}

Outcome bounce(double step, bool with_events) {
  auto ball = std::make_shared<LagrangianLinearTIDS>(vector_of(1), vector_of(0), one());
  ball->setFExtPtr(vector_of(-bouncing::g));
  auto system = std::make_shared<NonSmoothDynamicalSystem>(0., bouncing::end);
  system->insertDynamicalSystem(ball);
  system->link(std::make_shared<Interaction>(std::make_shared<NewtonImpactNSL>(bouncing::restitution),
                                             std::make_shared<LagrangianLinearTIR>(one())),
               ball);
  auto times = std::make_shared<TimeDiscretisation>(0., step);
  double seconds = 0;
  if (with_events) {
    const auto simulation = std::make_shared<EventDriven>(system, times);  // it hands out pointers to itself
    simulation->insertIntegrator(std::make_shared<LsodarOSI>());
    simulation->insertNonSmoothProblem(std::make_shared<LCP>(), SICONOS_OSNSP_ED_IMPACT);
    simulation->insertNonSmoothProblem(std::make_shared<LCP>(), SICONOS_OSNSP_ED_SMOOTH_ACC);
    const Stopwatch watch;
    while (simulation->hasNextEvent()) {
      simulation->advanceToEvent();
      simulation->processEvents();
    }
    seconds = watch.seconds();
  } else {
    const auto simulation =
        std::make_shared<TimeStepping>(system, times, std::make_shared<MoreauJeanOSI>(0.5), std::make_shared<LCP>());
    const Stopwatch watch;
    to_the_end(*simulation);
    seconds = watch.seconds();
  }
  return {seconds, std::abs((*ball->q())(0) - bouncing::height())};
}

Mechanism::State state_of(const Mechanism::Precomputed& precomputed, const SiconosVector& q, const SiconosVector* v) {
  Mechanism::State state = Mechanism::initial_state(precomputed.parameters);
  for (unsigned i = 0; i < rods; ++i) {
    state.q[static_cast<int>(i)] = q(i);
    state.v[static_cast<int>(i)] = v != nullptr ? (*v)(i) : 0;
  }
  return state;
}

/// M dv/dt + h(q, v) = J' r.
class Chain : public LagrangianDS {
 public:
  Chain(std::shared_ptr<SiconosVector> q, std::shared_ptr<SiconosVector> v) : LagrangianDS(q, v) {
    _mass = std::make_shared<SimpleMatrix>(rods, rods);
    _hasConstantMass = false;
    _fInt = std::make_shared<SiconosVector>(rods);
    _forces = std::make_shared<SiconosVector>(rods);
  }
  void computeMass() override { computeMass(_q[0]); }
  void computeMass(std::shared_ptr<SiconosVector> q) override {
    std::array<double, rods * rods> mass;
    Mechanism::mass_matrix(precomputed_, state_of(precomputed_, *q, nullptr), mass);
    for (unsigned i = 0; i < rods; ++i) {
      for (unsigned j = 0; j < rods; ++j) (*_mass)(i, j) = mass[j * rods + i];
    }
  }
  void computeFInt(double time) override { computeFInt(time, _q[0], _q[1]); }
  void computeFInt(double, std::shared_ptr<SiconosVector> q, std::shared_ptr<SiconosVector> v) override {
    Mechanism::GeneralizedForces bias{};
    Mechanism::bias(precomputed_, state_of(precomputed_, *q, v.get()), bias);
    for (unsigned i = 0; i < rods; ++i) (*_fInt)(i) = bias[static_cast<int>(i)];
  }

 private:
  const Mechanism::Precomputed precomputed_ = Mechanism::precompute(Mechanism::default_parameters());
};

class Touch : public LagrangianScleronomousR {
 public:
  explicit Touch(unsigned contact) : contact_(contact) {}
  void computeh(const BlockVector& q, BlockVector&, SiconosVector& y) override {
    y.zero();
    y(0) = at(q).gap[contact_];
  }
  void computeJachq(const BlockVector& q, BlockVector&) override {
    const Mechanism::Contacts now = at(q);
    constexpr unsigned rows = Mechanism::contact_row_count;
    for (unsigned row = 0; row < 2; ++row) {
      for (unsigned i = 0; i < rods; ++i) (*_jachq)(row, i) = now.jacobian[i * rows + 2 * contact_ + row];
    }
  }
  void computeDotJachq(const BlockVector&, BlockVector&, const BlockVector&) override {}

 private:
  Mechanism::Contacts at(const BlockVector& q) const {
    SiconosVector angles(rods);
    for (unsigned i = 0; i < rods; ++i) angles(i) = q(i);
    Mechanism::Contacts contacts;
    Mechanism::contacts(precomputed_, state_of(precomputed_, angles, nullptr), contacts);
    return contacts;
  }
  const unsigned contact_;
  const Mechanism::Precomputed precomputed_ = Mechanism::precompute(Mechanism::default_parameters());
};

Outcome fall(double step, double tolerance, const std::array<double, rods>& truth) {
  const Mechanism::State start = Mechanism::initial_state();
  auto q = std::make_shared<SiconosVector>(rods), v = std::make_shared<SiconosVector>(rods);
  for (unsigned i = 0; i < rods; ++i) (*q)(i) = start.q[static_cast<int>(i)], (*v)(i) = start.v[static_cast<int>(i)];
  auto chain = std::make_shared<Chain>(q, v);
  auto system = std::make_shared<NonSmoothDynamicalSystem>(0., 2.);
  system->insertDynamicalSystem(chain);
  const double friction = Mechanism::default_parameters().f;
  for (unsigned k = 0; k < rods; ++k) {
    system->link(std::make_shared<Interaction>(std::make_shared<NewtonImpactFrictionNSL>(0., 0., friction, 2),
                                               std::make_shared<Touch>(k)),
                 chain);
  }
  auto contacts = std::make_shared<FrictionContact>(2, SICONOS_FRICTION_2D_NSGS);
  contacts->numericsSolverOptions()->dparam[SICONOS_DPARAM_TOL] = tolerance;
  contacts->numericsSolverOptions()->iparam[SICONOS_IPARAM_MAX_ITER] = 10000;
  const auto simulation = std::make_shared<TimeStepping>(system, std::make_shared<TimeDiscretisation>(0., step),
                                                         std::make_shared<MoreauJeanOSI>(0.5), contacts);
  simulation->setNewtonTolerance(tolerance);
  simulation->setNewtonMaxIteration(20);
  const Stopwatch watch;
  to_the_end(*simulation);
  const double seconds = watch.seconds();
  double most = 0;
  for (unsigned i = 0; i < rods; ++i) most = std::max(most, std::abs((*chain->q())(i)-truth[i]));
  return {seconds, most};
}

template <class Entry>
Entry* room(std::size_t count) {
  return static_cast<Entry*>(std::calloc(count, sizeof(Entry)));
}

/// Freed by NM_clear.
NumericsMatrix* matrix_of(const ContactSolve& problem) {
  const auto count = static_cast<unsigned>(problem.friction.size());
  SparseBlockStructuredMatrix* W = SBM_new();
  W->nbblocks = static_cast<unsigned>(problem.blocks.size());
  W->blocknumber0 = W->blocknumber1 = count;
  W->blocksize0 = room<unsigned>(count);
  W->blocksize1 = room<unsigned>(count);
  for (unsigned i = 0; i < count; ++i) W->blocksize0[i] = W->blocksize1[i] = 3 * (i + 1);
  W->block = room<double*>(problem.blocks.size());
  W->filled1 = count + 1;
  W->filled2 = problem.blocks.size();
  W->index1_data = room<std::size_t>(count + 1);
  W->index2_data = room<std::size_t>(problem.blocks.size());
  for (std::size_t k = 0; k < problem.blocks.size(); ++k) {
    W->block[k] = room<double>(9);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column)
        W->block[k][3 * column + row] = problem.values[k][3 * row + column];
    }
    W->index2_data[k] = static_cast<std::size_t>(problem.blocks[k][1]);
    W->index1_data[problem.blocks[k][0] + 1] = k + 1;
  }
  return NM_new_SBM(static_cast<int>(3 * count), static_cast<int>(3 * count), W);
}

Outcome sweep(const ContactSolve& problem, double tolerance) {
  NumericsMatrix* W = matrix_of(problem);
  std::vector<double> q = problem.q, friction = problem.friction, impulses(q.size()), velocities(q.size());
  FrictionContactProblem solved{};
  solved.dimension = 3;
  solved.numberOfContacts = static_cast<int>(friction.size());
  solved.M = W;
  solved.q = q.data();
  solved.mu = friction.data();
  SolverOptions* options = solver_options_create(SICONOS_FRICTION_3D_NSGS);
  options->dparam[SICONOS_DPARAM_TOL] = tolerance;
  options->iparam[SICONOS_IPARAM_MAX_ITER] = 100000;
  const Stopwatch watch;
  fc3d_driver(&solved, impulses.data(), velocities.data(), options);
  const double seconds = watch.seconds();
  solver_options_delete(options);
  std::free(options);
  NM_clear(W);
  std::free(W);
  return {seconds, problem.residual(impulses)};
}

}  // namespace

std::vector<Way> siconos_bouncing() {
  std::vector<Way> ways;
  for (const double step : {0.5}) {
    ways.push_back(
        {"Siconos", "events, " + number("outputs each %.1f s", step), [step] { return bounce(step, true); }});
  }
  for (const double step : {1e-2, 1e-3, 1e-4}) {
    ways.push_back({"Siconos", "steps of " + number("%.0e s", step), [step] { return bounce(step, false); }});
  }
  return ways;
}

std::vector<Way> siconos_chain(const std::array<double, rods>& truth) {
  std::vector<Way> ways;
  for (const double step : {1e-2, 1e-3, 1e-4}) {
    ways.push_back({"Siconos", "steps of " + number("%.0e s", step) + ", NSGS to 1e-8",
                    [step, truth] { return fall(step, 1e-8, truth); }});
  }
  return ways;
}

std::vector<Way> siconos_spheres(const ContactSolve& problem) {
  std::vector<Way> ways;
  for (const double tolerance : {1e-3, 1e-4, 1e-6}) {
    ways.push_back({"Siconos", "NSGS to " + number("%.0e", tolerance),
                    [problem, tolerance] { return sweep(problem, tolerance); }});
  }
  return ways;
}

}  // namespace torsor::contact_peers
