/* SPDX-License-Identifier: GPL-3.0-or-later */
/* contacts LIBRARY: the example billiard as a library of `torsor build`, moved from event to event by a program in C. A
 * ball of radius R on a cloth, struck in its middle with V, slides for 2 V/(7 f g) and then rolls with 5/7 V; one that
 * falls from a height h with the restitution e strikes after T = sqrt(2 h/g), then in intervals 2 e T, 2 e^2 T ... */
#include "tests/abi/open_library.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { nq = 7, n = 13, x = 0, z = 2, turn = 3, vx = nq, vz = nq + 2, turns = nq + 4, most_events = 64 };

static int failures = 0;
static void expect(int holds, const char* what) {
  if (holds) return;
  printf("not so: %s\n", what);
  ++failures;
}

static const double R = 0.028575, g = 9.81, f = 0.2, V = 2.0, h = 0.1, e = 0.5;

typedef struct record {
  int count, stop_at;
  torsor_contact_event events[most_events];
  double before[most_events][n], after[most_events][n], impulses[most_events][3];
  int32_t regimes[most_events];
} record;

static int32_t tell(void* context, const torsor_contact_event* event) {
  record* const all = context;
  const int k = all->count++;
  if (k >= most_events) return 1;
  all->events[k] = *event;
  memcpy(all->before[k], event->before, sizeof(all->before[k]));
  memcpy(all->after[k], event->after, sizeof(all->after[k]));
  memcpy(all->impulses[k], event->impulses, sizeof(all->impulses[k]));
  all->regimes[k] = event->regimes[0];
  return all->count == all->stop_at;
}

typedef struct call {
  torsor_contact_motion of;
  double start[2][n], states[2][4][n], times[4], ends[2];
  int32_t statuses[2], regimes[2][4], contacts[2];
  int64_t calls[2];
  record told;
} call;

/* Two motions, both as the scene starts, whose events are told. */
static void prepare(call* c, const torsor_abi* m, const torsor_model* model) {
  memset(c, 0, sizeof(*c));
  for (int s = 0; s < 2; ++s) m->initial_state(model, NULL, c->start[s], c->start[s] + nq);
  torsor_motion* const motion = &c->of.motion;
  motion->model = model;
  motion->motions = 2;
  motion->threads = 1;
  motion->method = 1;
  motion->relative_tolerance = motion->absolute_tolerance = 1e-13;
  motion->start.data = c->start;
  motion->start.state = sizeof(c->start[0]);
  motion->start.row = sizeof(double);
  motion->times = c->times;
  motion->time_count = 4;
  motion->states.data = c->states;
  motion->states.state = sizeof(c->states[0]);
  motion->states.row = sizeof(c->states[0][0]);
  motion->states.column = sizeof(double);
  motion->statuses = c->statuses;
  motion->ends = c->ends;
  motion->calls = c->calls;
  c->of.regimes = c->regimes[0];
  c->of.contacts = c->contacts;
  c->of.observer = tell;
  c->of.observer_context = &c->told;
}

static void fall(double* y) {
  y[z] = R + h;
  y[vx] = 0.0;
}

static int near(double a, double b, double tolerance) { return fabs(a - b) <= tolerance; }

static void check_table(const torsor_abi* m) {
  expect(m->contact_count == 1 && m->contact_row_count == 3, "the table has one contact in space");
  const torsor_abi_contact* const cloth = m->contacts;
  expect(strcmp(cloth->name, "cloth") == 0 && strcmp(cloth->gap_unit, "m") == 0 && strcmp(cloth->reaction_unit, "N") == 0,
         "the contact has its name and units");
  expect(cloth->normal == 1 && cloth->tangents == 2, "it has a normal and two tangents");
}

static void check_slides_then_rolls(const torsor_abi* m, const torsor_model* model) {
  static call c;
  const double end = 2 * V / (7 * f * g);
  prepare(&c, m, model);
  c.of.motion.motions = 1;
  for (int k = 0; k < 4; ++k) c.times[k] = end * (k + 1) / 2;
  for (int method = 0; method < m->method_count; ++method) {
    c.of.motion.method = method;
    c.told.count = 0;
    expect(m->integrate_contacts(&c.of) == 0 && c.statuses[0] == torsor_motion_reached_end && c.contacts[0] == -1,
           "the ball reaches its end");
    expect(c.told.count == 1 && c.told.events[0].kind == torsor_event_slip_ends && c.told.events[0].contact == 0 &&
               c.told.regimes[0] == torsor_contact_sticks,
           "its only event is the end of its slip");
    /* 1e-13 a step, and the event is located to rounding. */
    expect(near(c.told.events[0].time, end, 1e-11), "the slip ends when it should");
    for (int k = 0; k < 4; ++k) {
      const double t = c.times[k], at = fmin(t, end);
      expect(near(c.states[0][k][x], V * at - f * g * at * at / 2 + 5 * V / 7 * (t - at), 1e-11), "the ball is where it should be");
      expect(near(c.states[0][k][vx], V - f * g * at, 1e-11), "it has the velocity that it should have");
      if (k != 1) expect(c.regimes[0][k] == (k < 1 ? torsor_contact_slides : torsor_contact_sticks), "regimes are told at times");
    }
    expect(near(c.states[0][3][turns], 5 * V / 7 / R, 1e-9), "it rolls");
  }
  double alone[4][n];
  memcpy(alone, c.states[0], sizeof(alone));
  memset(c.states, 0, sizeof(c.states));
  expect(m->integrate(&c.of.motion) == 0 && memcmp(alone, c.states[0], sizeof(alone)) == 0,
         "the motion of libraries without contacts is the same with the runtime's choices");
}

static void check_bounces(const torsor_abi* m, const torsor_model* model) {
  static call c;
  const double T = sqrt(2 * h / g), v = sqrt(2 * g * h);
  prepare(&c, m, model);
  fall(c.start[1]);
  for (int k = 0; k < 4; ++k) c.times[k] = T * (k + 1);
  expect(m->integrate_contacts(&c.of) == 0, "both motions reach their end");
  int bounces = 0;
  double time = T, speed = v;
  for (int k = 0; k < c.told.count && k < most_events; ++k) {
    const torsor_contact_event* const event = &c.told.events[k];
    if (event->motion != 1) continue;
    if (event->kind == torsor_event_accumulation) {
      expect(near(event->time, 3 * T, 1e-9) && c.told.regimes[k] != torsor_contact_open, "the bounces end at 3 T, at rest");
      continue;
    }
    expect(event->kind == torsor_event_impact, "the events before are impacts");
    /* Rounding of the height, some 1e-17 m, is a part of 1e-9 of the tenth flight, which is 1e-4 s long. */
    if (bounces < 10) {
      expect(near(event->time, time, 1e-10), "the ball strikes when it should");
      expect(near(c.told.before[k][vz], -speed, 1e-9) && near(c.told.after[k][vz], e * speed, 1e-9), "and rebounds");
      /* P = m (1 + e) w, and what is lost is m w^2 (1 - e^2)/2, so that their ratio has no m. */
      expect(near(event->energy_lost / c.told.impulses[k][0], speed * (1 - e) / 2, 1e-9), "the impulse is that of the law");
    }
    ++bounces;
    speed *= e;
    time += 2 * speed / g;
  }
  expect(bounces > 10, "there are many bounces");
  expect(near(c.states[1][3][z], R, 1e-12) && near(c.states[1][3][vz], 0.0, 1e-12), "the ball comes to rest");

  /* The same by two threads, and stopped by the observer, which counts all events. */
  double both[2][4][n];
  memcpy(both, c.states, sizeof(both));
  c.of.observer = NULL;
  c.of.motion.threads = 2;
  expect(m->integrate_contacts(&c.of) == 0 && memcmp(both, c.states, sizeof(both)) == 0, "threads change nothing");
  c.of.observer = tell;
  c.of.motion.threads = 1;
  c.told.count = 0;
  c.told.stop_at = 2; /* the slip of the first, the first impact of the second */
  expect(m->integrate_contacts(&c.of) == 1 && c.statuses[0] == torsor_motion_reached_end &&
             c.statuses[1] == torsor_motion_stopped,
         "the observer ends a motion");
  expect(near(c.ends[1], T, 1e-10) && isnan(c.states[1][1][z]) && c.regimes[1][1] == -1, "what was not reached is not a number");
}

static void check_refusals(const torsor_abi* m, const torsor_model* model) {
  static call c;
  prepare(&c, m, model);
  c.start[0][z] = R / 2;
  for (int k = 0; k < 4; ++k) c.times[k] = 0.1 * k;
  expect(m->integrate_contacts(&c.of) == 1 && c.statuses[0] == torsor_motion_penetrates && c.contacts[0] == 0 &&
             c.statuses[1] == torsor_motion_reached_end,
         "a ball in the cloth cannot begin, and harms no neighbour");
  prepare(&c, m, model);
  c.times[0] = 0.2;
  c.times[1] = 0.1;
  expect(m->integrate_contacts(&c.of) == 2 && c.statuses[0] == torsor_motion_invalid_options, "times that fall are refused");
  prepare(&c, m, model);
  c.times[0] = NAN;
  expect(m->integrate_contacts(&c.of) == 2 && c.statuses[0] == torsor_motion_invalid_options, "so is a time that is none");
  prepare(&c, m, model);
  c.of.impact_law = 4;
  expect(m->integrate_contacts(&c.of) == 2 && c.statuses[0] == torsor_motion_invalid_options, "so is a law that is none");
  prepare(&c, m, model);
  c.of.motion.method = m->method_count;
  expect(m->integrate_contacts(&c.of) == 2 && c.statuses[0] == torsor_motion_unsuitable_model, "so is another method");
  prepare(&c, m, model);
  c.of.event_limit = 3;
  fall(c.start[0]);
  for (int k = 0; k < 4; ++k) c.times[k] = 1.0 + k;
  expect(m->integrate_contacts(&c.of) == 1 && c.statuses[0] == torsor_motion_too_many_events, "events are limited");
  c.of.motion.model = NULL;
  expect(m->integrate_contacts(&c.of) == torsor_call_without_model, "a call without a model is refused");
  c.of.motion.model = model;
  c.of.motion.start.data = NULL;
  expect(m->integrate_contacts(&c.of) == torsor_call_without_argument, "and one without a start");
  double surface[2] = {-1.0, 0.0}; /* f, e */
  torsor_model* const impossible = m->create(surface);
  prepare(&c, m, impossible);
  expect(m->integrate_contacts(&c.of) == torsor_call_impossible_parameters, "no surface has f < 0");
  expect(strcmp(m->impossible(impossible), "contact 'cloth' has the friction f = -1: a surface never pushes along the slip") == 0,
         "and that is said of it");
  expect(m->impossible(model) == NULL, "of others nothing is");
  m->destroy(impossible);
  surface[0] = NAN; /* neither below zero nor above */
  torsor_model* const unknown = m->create(surface);
  prepare(&c, m, unknown);
  expect(m->integrate_contacts(&c.of) == 2 && c.statuses[0] == torsor_motion_impossible_surface && c.contacts[0] == 0,
         "a friction that is no number is that of no surface");
  m->destroy(unknown);
  prepare(&c, m, model);
  memset(c.start[0] + turn, 0, 4 * sizeof(double));
  for (int k = 0; k < 4; ++k) c.times[k] = 0.1 * k;
  expect(m->integrate_contacts(&c.of) == 1 && c.statuses[0] == torsor_motion_zero_quaternion && c.ends[0] == 0.0,
         "a quaternion of zeros is no attitude");
}

int main(int count, char** words) {
  if (count != 2) return 2;
  const torsor_mechanism_entry entry = opened(words[1]);
  if (entry == NULL) return 2;
  const torsor_abi* const m = entry();
  if (m->coordinate_count != nq || m->velocity_count != n - nq || m->parameter_count != 2) return 2;
  const double given[2] = {f, e};
  torsor_model* const model = m->create(given);
  check_table(m);
  check_slides_then_rolls(m, model);
  check_bounces(m, model);
  check_refusals(m, model);
  m->destroy(model);
  printf("%s: contacts from C, %d failures\n", m->name, failures);
  return failures == 0 ? 0 : 1;
}
