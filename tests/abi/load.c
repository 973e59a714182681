/* SPDX-License-Identifier: GPL-3.0-or-later */
/* load LIBRARY: opens a library of `torsor build` as a program in C would, and checks what runtime/abi.h promises of
 * every mechanism: every kernel over many states has the bits of the same states one by one, whatever the strides and
 * threads; what is not finite is told and harms no neighbour; misuse is refused; a motion arrives. */
#include "tests/abi/open_library.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { states = 37 }; /* several packs, and one that is not full */

static int failures = 0;
static void expect(int holds, const char* what, const char* where) {
  if (holds) return;
  printf("%s: not so: %s\n", where, what);
  ++failures;
}

static double* numbers(size_t count) {
  double* all = calloc(count > 0 ? count : 1, sizeof(double));
  if (all == NULL) exit(2);
  return all;
}

/* Between -1 and 1, the same each time. */
static double next(void) {
  static unsigned long long state = 1;
  state = state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(state >> 11) * 0x1p-52 - 1.0;
}

static torsor_view columns(double* data, int rows) {
  torsor_view view = {data, (ptrdiff_t)sizeof(double) * rows, sizeof(double), 0};
  return view;
}

typedef struct arguments {
  double *time, *q, *v, *a, *lambda, *u;
} arguments;

static void fill(double* to, size_t count) {
  for (size_t i = 0; i < count; ++i) to[i] = next();
}

/* States near the start, so that constraints nearly hold and roots exist. */
static arguments make_arguments(const torsor_abi* m, const torsor_model* model) {
  arguments x;
  double start = 0.0;
  double* q0 = numbers((size_t)m->coordinate_count);
  x.time = numbers(states);
  x.q = numbers((size_t)(states * m->coordinate_count));
  x.v = numbers((size_t)(states * m->velocity_count));
  x.a = numbers((size_t)(states * m->velocity_count));
  x.lambda = numbers((size_t)(states * m->multiplier_count));
  x.u = numbers((size_t)(states * m->input_count));
  m->initial_state(model, &start, q0, NULL);
  for (int s = 0; s < states; ++s) {
    x.time[s] = start + 0.01 * s;
    for (int k = 0; k < m->coordinate_count; ++k) x.q[s * m->coordinate_count + k] = q0[k] + 0.1 * next();
  }
  fill(x.v, (size_t)(states * m->velocity_count));
  fill(x.a, (size_t)(states * m->velocity_count));
  fill(x.lambda, (size_t)(states * m->multiplier_count));
  fill(x.u, (size_t)(states * m->input_count));
  free(q0);
  return x;
}

static torsor_call call_of(const torsor_abi* m, const torsor_model* model, const arguments* x, int first) {
  torsor_call call;
  memset(&call, 0, sizeof(call));
  call.model = model;
  call.states = 1;
  call.threads = 1;
  call.order = 6;
  call.time = columns(x->time + first, 1);
  call.q = columns(x->q + first * m->coordinate_count, m->coordinate_count);
  call.v = columns(x->v + first * m->velocity_count, m->velocity_count);
  call.accelerations = columns(x->a + first * m->velocity_count, m->velocity_count);
  call.multipliers = columns(x->lambda + first * m->multiplier_count, m->multiplier_count);
  call.inputs = columns(x->u + first * m->input_count, m->input_count);
  return call;
}

/* Results of a state one after the other, matrices row by row (by_rows) or column by column. */
static size_t place_results(const torsor_abi_kernel* kernel, int order, double* data, int by_rows, torsor_view* views) {
  size_t size = 0;
  for (int r = 0; r < kernel->result_count; ++r) {
    const int rows = kernel->results[r].rows;
    const int width = kernel->results[r].columns == 0 ? order + 1 : kernel->results[r].columns;
    views[r].data = rows == 0 ? NULL : data + size;
    views[r].row = (ptrdiff_t)sizeof(double) * (by_rows ? width : 1);
    views[r].column = (ptrdiff_t)sizeof(double) * (by_rows ? 1 : rows);
    size += (size_t)(rows * width);
  }
  for (int r = 0; r < kernel->result_count; ++r) views[r].state = (ptrdiff_t)(size * sizeof(double));
  return size;
}

static void check_kernel(const torsor_abi* m, const torsor_abi_kernel* kernel, const torsor_model* model,
                         const arguments* x) {
  torsor_view* views = calloc((size_t)kernel->result_count, sizeof(torsor_view));
  const size_t size = place_results(kernel, 6, NULL, 1, views);
  double* alone = numbers(size * states);
  double* many = numbers(size * states);
  int32_t told_alone[states], told[states];
  for (int s = 0; s < states; ++s) {
    torsor_call call = call_of(m, model, x, s);
    place_results(kernel, 6, alone + (size_t)s * size, 1, views);
    call.results = views;
    call.statuses = told_alone + s;
    const int64_t failed = kernel->evaluate(&call);
    expect(failed == (told_alone[s] != 0), "one state fails as its status says", kernel->name);
    expect(told_alone[s] == 0 || kernel->has_status, "a kernel without a status does not fail", kernel->name);
  }
  for (unsigned threads = 1; threads <= 3; ++threads) {
    torsor_call call = call_of(m, model, x, 0);
    call.states = states;
    call.threads = threads;
    memset(many, 0, size * states * sizeof(double));
    place_results(kernel, 6, many, 1, views);
    call.results = views;
    call.statuses = told;
    kernel->evaluate(&call);
    expect(memcmp(told, told_alone, sizeof(told)) == 0, "many states have the statuses of each alone", kernel->name);
    for (int s = 0; s < states; ++s) {
      if (told[s] != 0) continue;
      expect(memcmp(many + (size_t)s * size, alone + (size_t)s * size, size * sizeof(double)) == 0,
             "many states have the bits of each alone", kernel->name);
    }
  }
  /* One number that is not finite, among good states. */
  torsor_call call = call_of(m, model, x, 0);
  const double kept = x->q[5 * m->coordinate_count];
  x->q[5 * m->coordinate_count] = NAN;
  call.states = states;
  place_results(kernel, 6, many, 1, views);
  call.results = views;
  call.statuses = told;
  kernel->evaluate(&call);
  x->q[5 * m->coordinate_count] = kept;
  expect(told[5] == torsor_state_argument_not_finite, "an argument that is not finite is told", kernel->name);
  expect(call.worst == torsor_state_argument_not_finite, "and is the worst of all", kernel->name);
  for (int s = 0; s < states; ++s) {
    if (s == 5 || told_alone[s] != 0) continue;
    expect(told[s] == 0 && memcmp(many + (size_t)s * size, alone + (size_t)s * size, size * sizeof(double)) == 0,
           "its neighbours are as they were", kernel->name);
  }
  call.q.data = NULL;
  expect(kernel->evaluate(&call) == torsor_call_without_argument, "a call without q is refused", kernel->name);
  call.model = NULL;
  expect(kernel->evaluate(&call) == torsor_call_without_model, "a call without a model is refused", kernel->name);
  free(views);
  free(alone);
  free(many);
}

static void check_motion(const torsor_abi* m, const torsor_model* model) {
  const int n = m->coordinate_count + m->velocity_count;
  double* start = numbers((size_t)n);
  double* reached = numbers((size_t)(2 * n));
  double* other = numbers((size_t)(2 * n));
  double times[2], time = 0.0;
  m->initial_state(model, &time, start, start + m->coordinate_count);
  times[0] = time + 0.05;
  times[1] = time + 0.1;
  torsor_motion motion;
  memset(&motion, 0, sizeof(motion));
  motion.model = model;
  motion.motions = 1;
  motion.threads = 1;
  motion.relative_tolerance = motion.absolute_tolerance = 1e-11;
  motion.step = 1e-4;
  motion.time.data = &time;
  motion.start = columns(start, n);
  motion.times = times;
  motion.time_count = 2;
  for (int k = 0; k < m->method_count; ++k) {
    double* const into = k == 0 ? reached : other;
    int32_t status = -1;
    motion.method = k;
    motion.states.data = into;
    motion.states.row = (ptrdiff_t)sizeof(double) * n;
    motion.states.column = sizeof(double);
    motion.statuses = &status;
    const int64_t failed = m->integrate(&motion);
    if (status == torsor_motion_unsuitable_model) continue; /* no Taylor series of this mechanism */
    expect(failed == 0 && status == torsor_motion_reached_end, "a motion reaches its end", m->methods[k].name);
    /* Midpoint, the coarsest, errs by h^2 times some thousand at rates of 150/s: 1e-4^2 * 1e4 = 1e-4 of the state. */
    for (int i = 0; i < 2 * n; ++i) {
      expect(fabs(into[i] - reached[i]) <= 1e-3 * (1.0 + fabs(reached[i])), "methods agree", m->methods[k].name);
    }
  }
  free(start);
  free(reached);
  free(other);
}

int main(int count, char** words) {
  if (count != 2) return 2;
  const torsor_mechanism_entry entry = opened(words[1]);
  if (entry == NULL) return 2;
  const torsor_abi* const m = entry();
  expect(m->version == TORSOR_ABI_VERSION && m->size == sizeof(torsor_abi), "the version is that of the header",
         m->name);
  expect(m == entry(), "the table is always the same", m->name);
  torsor_model* const model = m->create(NULL);
  torsor_model* const same = m->create(m->default_parameters);
  expect(model != NULL && same != NULL, "a model is made", m->name);
  arguments x = make_arguments(m, model);
  expect(m->kernel_count > 0, "there are kernels", m->name);
  expect((m->contact_count > 0) == (m->integrate_contacts != NULL), "what has contacts moves them", m->name);
  for (int k = 0; k < m->kernel_count; ++k) {
    for (int r = 0; r < m->kernels[k].result_count; ++r) {
      const torsor_abi_result* const result = &m->kernels[k].results[r];
      expect(result->unit != NULL && (result->dimensions == 2 || result->columns == 1) && (result->dimensions > 0 || result->rows == 1),
             "a result has dimensions and a unit", result->name);
    }
  }
  for (int k = 0; k < m->kernel_count; ++k) check_kernel(m, &m->kernels[k], k % 2 == 0 ? model : same, &x);
  check_motion(m, model);
  m->destroy(model);
  m->destroy(same);
  printf("%s: %d kernels, %d methods, %d failures\n", m->name, m->kernel_count, m->method_count, failures);
  free(x.time);
  free(x.q);
  free(x.v);
  free(x.a);
  free(x.lambda);
  free(x.u);
  return failures == 0 ? 0 : 1;
}
