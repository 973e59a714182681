/* SPDX-License-Identifier: MIT */
/* A library of `torsor build` in GNU Octave (mkoctfile --mex torsor_call.c -I INCLUDE) or MATLAB (mex torsor_call.c ...).
 *
 *   arm = torsor_call('./libarm.so')                         what it has: names, units, parameters, kernels, start
 *   tau = torsor_call('./libarm.so', 'inverse_dynamics', q, v, 'accelerations', a)
 *   [y, ends] = torsor_call('./libarm.so', 'integrate', times, [q0; v0], 'tolerance', 1e-10)
 *
 * Each column of q, v and of what is given by name is one state; a single column stands for all states. A result of r rows
 * and c columns is r x c, for n states r x c x n. Units are SI, angles in rad. docs/python.md, "Octave and MATLAB". */
#define _XOPEN_SOURCE 700 /* realpath */
#include <dlfcn.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "mex.h"
#include "torsor/runtime/abi.h"

/* A library stays open until the function is cleared, with one model of its own parameters. */
enum { most_libraries = 64 };
static struct {
  void* library; /* one for each file, whatever path names it */
  const torsor_abi* abi;
  torsor_model* model;
} opened[most_libraries];
static int opened_count;

static void close_all(void) {
  for (int i = 0; i < opened_count; ++i) {
    opened[i].abi->destroy(opened[i].model);
    dlclose(opened[i].library);
  }
  opened_count = 0;
}

static char* text_of(const mxArray* value, const char* what) {
  char* const text = mxIsChar(value) ? mxArrayToString(value) : NULL;
  if (text == NULL) mexErrMsgIdAndTxt("torsor:usage", "%s is a text in single quotes", what);
  return text;
}

/* The place of a library in the table, which is opened where it is not yet. */
static int open_library(const mxArray* name) {
  typedef const torsor_abi* entry_point(void);
  char* const path = text_of(name, "the library's path");
  entry_point* entry = NULL;
  /* The whole path: dlopen takes one that it knows for what it was in another folder. */
  char* const whole_path = strchr(path, '/') == NULL ? NULL : realpath(path, NULL);
  void* const library = dlopen(whole_path == NULL ? path : whole_path, RTLD_NOW | RTLD_LOCAL);
  void* symbol;
  free(whole_path);
  if (library == NULL) {
    mexErrMsgIdAndTxt("torsor:library", "%s%s", dlerror(), strchr(path, '/') == NULL ? "; begin with ./ for this folder" : "");
  }
  for (int i = 0; i < opened_count; ++i) {
    if (opened[i].library != library) continue;
    dlclose(library); /* it was opened once more */
    return i;
  }
  if (opened_count == most_libraries) {
    dlclose(library);
    mexErrMsgIdAndTxt("torsor:library", "%d libraries are open: clear torsor_call", most_libraries);
  }
  symbol = dlsym(library, "torsor_mechanism");
  if (symbol != NULL) memcpy(&entry, &symbol, sizeof(entry));
  if (entry == NULL || entry()->version != TORSOR_ABI_VERSION) {
    dlclose(library);
    mexErrMsgIdAndTxt("torsor:library", "'%s' is no library of torsor build of version %d", path, TORSOR_ABI_VERSION);
  }
  opened[opened_count].abi = entry();
  opened[opened_count].model = entry()->create(NULL);
  if (opened[opened_count].model == NULL) {
    dlclose(library);
    mexErrMsgIdAndTxt("torsor:memory", "no memory");
  }
  opened[opened_count].library = library;
  mexAtExit(close_all);
  return opened_count++;
}

static mxArray* names_of(const torsor_abi_quantity* all, int32_t count, int units) {
  mxArray* const cells = mxCreateCellMatrix((mwSize)count, 1);
  for (int32_t i = 0; i < count; ++i) mxSetCell(cells, (mwIndex)i, mxCreateString(units ? all[i].unit : all[i].name));
  return cells;
}

static void set_quantities(mxArray* to, const char* name, const char* units, const torsor_abi_quantity* all, int32_t count) {
  mxSetField(to, 0, name, names_of(all, count, 0));
  mxSetField(to, 0, units, names_of(all, count, 1));
}

static mxArray* kernels_of(const torsor_abi* abi) {
  const char* fields[] = {"name", "results", "reads"};
  mxArray* const all = mxCreateStructMatrix((mwSize)abi->kernel_count, 1, 3, fields);
  for (int32_t k = 0; k < abi->kernel_count; ++k) {
    const torsor_abi_kernel* const kernel = &abi->kernels[k];
    const char* reads[3];
    mxArray *results = mxCreateCellMatrix(1, (mwSize)kernel->result_count), *read;
    int count = 0;
    for (int32_t i = 0; i < kernel->result_count; ++i) mxSetCell(results, (mwIndex)i, mxCreateString(kernel->results[i].name));
    if (kernel->reads_accelerations) reads[count++] = "accelerations";
    if (kernel->reads_multipliers && abi->multiplier_count > 0) reads[count++] = "multipliers";
    if (kernel->reads_inputs && abi->input_count > 0) reads[count++] = "inputs";
    read = mxCreateCellMatrix(1, (mwSize)count);
    for (int i = 0; i < count; ++i) mxSetCell(read, (mwIndex)i, mxCreateString(reads[i]));
    mxSetField(all, (mwIndex)k, "name", mxCreateString(kernel->name));
    mxSetField(all, (mwIndex)k, "results", results);
    mxSetField(all, (mwIndex)k, "reads", read);
  }
  return all;
}

static mxArray* description(int place) {
  const char* fields[] = {"name",       "coordinates",     "coordinate_units",   "velocities", "velocity_units", "inputs",
                          "input_units", "multipliers",    "multiplier_units",   "parameters", "parameter_units",
                          "default_parameters", "kernels", "methods", "time", "q", "v"};
  const torsor_abi* const abi = opened[place].abi;
  mxArray* const all = mxCreateStructMatrix(1, 1, (int)(sizeof(fields) / sizeof(fields[0])), fields);
  mxArray *parameters = mxCreateDoubleMatrix((mwSize)abi->parameter_count, 1, mxREAL), *methods;
  mxArray* const q = mxCreateDoubleMatrix((mwSize)abi->coordinate_count, 1, mxREAL);
  mxArray* const v = mxCreateDoubleMatrix((mwSize)abi->velocity_count, 1, mxREAL);
  double time = 0.0;
  mxSetField(all, 0, "name", mxCreateString(abi->name));
  set_quantities(all, "coordinates", "coordinate_units", abi->coordinates, abi->coordinate_count);
  set_quantities(all, "velocities", "velocity_units", abi->velocities, abi->velocity_count);
  set_quantities(all, "inputs", "input_units", abi->inputs, abi->input_count);
  set_quantities(all, "multipliers", "multiplier_units", abi->multipliers, abi->multiplier_count);
  set_quantities(all, "parameters", "parameter_units", abi->parameters, abi->parameter_count);
  for (int32_t i = 0; i < abi->parameter_count; ++i) mxGetPr(parameters)[i] = abi->default_parameters[i];
  mxSetField(all, 0, "default_parameters", parameters);
  mxSetField(all, 0, "kernels", kernels_of(abi));
  methods = mxCreateCellMatrix(1, (mwSize)abi->method_count);
  for (int32_t i = 0; i < abi->method_count; ++i) mxSetCell(methods, (mwIndex)i, mxCreateString(abi->methods[i].name));
  mxSetField(all, 0, "methods", methods);
  abi->initial_state(opened[place].model, &time, mxGetPr(q), mxGetPr(v));
  mxSetField(all, 0, "time", mxCreateDoubleScalar(time));
  mxSetField(all, 0, "q", q);
  mxSetField(all, 0, "v", v);
  return all;
}

static const mxArray* matrix(const mxArray* value, const char* name, size_t rows) {
  if (!mxIsDouble(value) || mxIsComplex(value) || mxIsSparse(value) || mxGetNumberOfDimensions(value) != 2)
    mexErrMsgIdAndTxt("torsor:argument", "%s is a full matrix of real doubles", name);
  if (mxGetM(value) != rows)
    mexErrMsgIdAndTxt("torsor:argument", "%s has %d rows, not %d: one column for each state", name, (int)mxGetM(value), (int)rows);
  return value;
}

/* One column for each of `states`, which it may raise from 1, or one for all of them. */
static torsor_view columns(const mxArray* value, const char* name, int32_t rows, size_t* states) {
  const size_t count = mxGetN(matrix(value, name, (size_t)rows));
  torsor_view view = {NULL, 0, (ptrdiff_t)sizeof(double), 0};
  if (count != 1 && *states == 1) *states = count;
  if (count != 1 && count != *states)
    mexErrMsgIdAndTxt("torsor:argument", "%s has %d columns, where others have %d", name, (int)count, (int)*states);
  view.data = mxGetPr(value);
  view.state = count == 1 ? 0 : (ptrdiff_t)(sizeof(double) * (size_t)rows);
  return view;
}

static double scalar(const mxArray* value, const char* name) {
  if (!mxIsDouble(value) || mxIsComplex(value) || mxIsSparse(value) || mxGetNumberOfElements(value) != 1)
    mexErrMsgIdAndTxt("torsor:argument", "%s is a real number", name);
  return mxGetScalar(value);
}

static int32_t whole(const mxArray* value, const char* name, int32_t most) {
  const double number = scalar(value, name);
  if (!(number >= 0 && number <= most) || number != (double)(int32_t)number)
    mexErrMsgIdAndTxt("torsor:argument", "%s is a whole number from 0 to %d", name, (int)most);
  return (int32_t)number;
}

/* What is given by name, in pairs at the end; `known` says which names a call takes, and ends with NULL. */
static const mxArray* named(int count, const mxArray* const* pairs, const char* name) {
  const mxArray* found = NULL;
  for (int i = 0; i + 1 < count; i += 2) {
    char* const word = text_of(pairs[i], "the name of an option");
    if (strcmp(word, name) == 0) found = pairs[i + 1];
    mxFree(word);
  }
  return found;
}

static void expect_known(int count, const mxArray* const* pairs, const char* const* known) {
  if (count % 2 != 0) mexErrMsgIdAndTxt("torsor:usage", "options come in pairs: a name and a value");
  for (int i = 0; i < count; i += 2) {
    char* const word = text_of(pairs[i], "the name of an option");
    const char* const* each = known;
    while (*each != NULL && strcmp(*each, word) != 0) ++each;
    if (*each == NULL) mexErrMsgIdAndTxt("torsor:usage", "there is no option '%s' here", word);
    for (int k = 0; k < i; k += 2) {
      char* const other = text_of(pairs[k], "the name of an option");
      if (strcmp(other, word) == 0) mexErrMsgIdAndTxt("torsor:usage", "the option '%s' is given twice", word);
      mxFree(other);
    }
    mxFree(word);
  }
}

/* The library's own model, or one of other parameters, which the caller destroys. */
static torsor_model* model_of(int place, const mxArray* parameters) {
  const torsor_abi* const abi = opened[place].abi;
  torsor_model* model = opened[place].model;
  if (parameters != NULL) {
    matrix(parameters, "parameters", (size_t)abi->parameter_count);
    if (mxGetN(parameters) != 1) mexErrMsgIdAndTxt("torsor:argument", "parameters are one column");
    model = abi->create(mxGetPr(parameters));
    if (model == NULL) mexErrMsgIdAndTxt("torsor:memory", "no memory");
    if (abi->size >= sizeof(torsor_abi) && abi->impossible(model) != NULL) { /* an earlier library has no such entry */
      char said[512];
      strncpy(said, abi->impossible(model), sizeof(said) - 1);
      said[sizeof(said) - 1] = '\0';
      abi->destroy(model);
      mexErrMsgIdAndTxt("torsor:argument", "%s: give other parameters", said);
    }
  }
  return model;
}

static void finish(int place, torsor_model* model) {
  if (model != opened[place].model) opened[place].abi->destroy(model);
}

static mxArray* whole_numbers(const int32_t* from, size_t count) {
  mxArray* const to = mxCreateDoubleMatrix(1, (mwSize)count, mxREAL);
  for (size_t i = 0; i < count; ++i) mxGetPr(to)[i] = from[i];
  return to;
}

/* A kernel's results, and then the status of each state where it is asked for: without it, a state that fails is an error. */
static void evaluate(int place, const torsor_abi_kernel* kernel, int outputs, mxArray** out, int count, const mxArray* const* in) {
  static const char* const known[] = {"accelerations", "multipliers", "inputs", "time", "parameters", "threads", "order", NULL};
  static const char* const words[] = {"ok", "singular", "not finite", "an argument is not finite"};
  const torsor_abi* const abi = opened[place].abi;
  const mxArray *a, *lambda, *u, *time, *threads, *order;
  const char* unread = NULL;
  torsor_call call;
  torsor_view* views;
  int64_t failed;
  size_t states = 1;
  memset(&call, 0, sizeof(call));
  if (count < 2) mexErrMsgIdAndTxt("torsor:usage", "a kernel takes q and v, and what else it reads by name");
  expect_known(count - 2, in + 2, known);
  if (outputs > kernel->result_count + 1)
    mexErrMsgIdAndTxt("torsor:usage", "%s has %d results, and statuses", kernel->name, (int)kernel->result_count);
  a = named(count - 2, in + 2, "accelerations");
  lambda = named(count - 2, in + 2, "multipliers");
  u = named(count - 2, in + 2, "inputs");
  time = named(count - 2, in + 2, "time");
  threads = named(count - 2, in + 2, "threads");
  order = named(count - 2, in + 2, "order");
  if (kernel->reads_accelerations && a == NULL) mexErrMsgIdAndTxt("torsor:argument", "%s reads accelerations", kernel->name);
  if (a != NULL && !kernel->reads_accelerations) unread = "accelerations";
  if (lambda != NULL && !kernel->reads_multipliers) unread = "multipliers";
  if (u != NULL && !kernel->reads_inputs) unread = "inputs";
  if (unread != NULL) mexErrMsgIdAndTxt("torsor:usage", "%s does not read '%s': leave it out", kernel->name, unread);
  if (order == NULL && kernel->takes_order)
    mexErrMsgIdAndTxt("torsor:usage", "%s takes 'order', the highest of its Taylor coefficients", kernel->name);
  for (int pass = 0; pass < 2; ++pass) { /* the first finds how many states there are */
    call.q = columns(in[0], "q", abi->coordinate_count, &states);
    call.v = columns(in[1], "v", abi->velocity_count, &states);
    if (a != NULL) call.accelerations = columns(a, "accelerations", abi->velocity_count, &states);
    if (lambda != NULL) call.multipliers = columns(lambda, "multipliers", abi->multiplier_count, &states);
    if (u != NULL) call.inputs = columns(u, "inputs", abi->input_count, &states);
    if (time != NULL) call.time = columns(time, "time", 1, &states);
  }
  call.states = states;
  call.threads = threads == NULL ? 1 : (uint32_t)whole(threads, "threads", 1024);
  if (order != NULL && !kernel->takes_order) mexErrMsgIdAndTxt("torsor:usage", "%s takes no order", kernel->name);
  if (order != NULL) call.order = whole(order, "order", 1000);
  views = mxCalloc((size_t)kernel->result_count + 1, sizeof(*views));
  for (int32_t i = 0; i < kernel->result_count && (i < outputs || i == 0); ++i) {
    const torsor_abi_result* const result = &kernel->results[i];
    const size_t rows = (size_t)result->rows, across = result->columns > 0 ? (size_t)result->columns : (size_t)call.order + 1;
    const mwSize sizes[3] = {(mwSize)rows, (mwSize)across, (mwSize)states};
    const torsor_view view = {NULL, (ptrdiff_t)(sizeof(double) * rows * across), (ptrdiff_t)sizeof(double),
                              (ptrdiff_t)(sizeof(double) * rows)};
    /* Column vectors of many states are the columns of a matrix. */
    out[i] = result->dimensions < 2 ? mxCreateDoubleMatrix(sizes[0], sizes[2], mxREAL) : mxCreateNumericArray(3, sizes, mxDOUBLE_CLASS, mxREAL);
    views[i] = view;
    views[i].data = mxGetPr(out[i]);
  }
  call.results = views;
  call.statuses = mxCalloc(states > 0 ? states : 1, sizeof(int32_t));
  call.model = model_of(place, named(count - 2, in + 2, "parameters"));
  failed = kernel->evaluate(&call);
  finish(place, (torsor_model*)(uintptr_t)call.model);
  if (failed < 0) mexErrMsgIdAndTxt("torsor:call", "%s refuses the call: %d (runtime/abi.h)", kernel->name, (int)failed);
  if (outputs > kernel->result_count) {
    out[kernel->result_count] = whole_numbers(call.statuses, states);
  } else if (failed > 0) {
    mexErrMsgIdAndTxt("torsor:state", "%s: %s in %d of %d states; ask for statuses as one more output", kernel->name,
                      words[call.worst >= 0 && call.worst < 4 ? call.worst : 2], (int)failed, (int)states);
  }
  mxFree(call.statuses);
  mxFree(views);
}

/* Why a motion ended: torsor_motion_reached_end and those after it. */
static const char* why(int32_t status) {
  static const char* const words[] = {"the end was reached", "it was stopped", "unusable times, tolerances or steps, or a start that is not finite",
      "the step fell below the resolution of time", "the limit of steps was met",
      "the equations are singular there, or loops are at a dead centre of a friction", "an implicit step did not converge",
      "the method does not suit the model, or the library lacks kernels that hold its constraints: mass_matrix, constraints"};
  if (status == torsor_motion_open_loops) return "the loops cannot be closed near the start";
  if (status == torsor_motion_zero_quaternion) return "a quaternion of the start is zero: it has no direction";
  return status >= 0 && status <= torsor_motion_unsuitable_model ? words[status] : "a status of contacts, see runtime/abi.h";
}

/* y at the times, one column for each, then the last time reached and the status; without statuses an early end is an error. */
static void integrate(int place, int outputs, mxArray** out, int count, const mxArray* const* in) {
  static const char* const known[] = {"inputs", "parameters", "method", "step", "tolerance", "time", NULL};
  const torsor_abi* const abi = opened[place].abi;
  const mxArray *u, *step, *tolerance, *start, *method;
  torsor_motion motion;
  double begin = 0.0, end = 0.0;
  int32_t status = 0;
  int64_t failed;
  size_t one = 1, times;
  const int32_t size = abi->coordinate_count + abi->velocity_count;
  memset(&motion, 0, sizeof(motion));
  if (count < 2) mexErrMsgIdAndTxt("torsor:usage", "integrate takes times and the start [q; v]");
  if (outputs > 3) mexErrMsgIdAndTxt("torsor:usage", "integrate gives y, the time reached and a status");
  expect_known(count - 2, in + 2, known);
  if (!mxIsDouble(in[0]) || mxIsComplex(in[0]) || mxIsSparse(in[0]))
    mexErrMsgIdAndTxt("torsor:argument", "times are full real doubles");
  times = mxGetNumberOfElements(in[0]);
  if (mxGetN(matrix(in[1], "[q; v]", (size_t)size)) != 1) mexErrMsgIdAndTxt("torsor:argument", "[q; v] is one column");
  u = named(count - 2, in + 2, "inputs");
  step = named(count - 2, in + 2, "step");
  tolerance = named(count - 2, in + 2, "tolerance");
  start = named(count - 2, in + 2, "time");
  method = named(count - 2, in + 2, "method");
  abi->initial_state(opened[place].model, &begin, NULL, NULL);
  if (start != NULL) begin = scalar(start, "time");
  motion.motions = motion.threads = 1;
  motion.time.data = &begin;
  motion.start = columns(in[1], "[q; v]", size, &one);
  if (u != NULL) motion.inputs = columns(u, "inputs", abi->input_count, &one);
  if (one != 1) mexErrMsgIdAndTxt("torsor:argument", "inputs of a motion are one column, and stay");
  motion.step = step == NULL ? 0.0 : scalar(step, "step");
  motion.relative_tolerance = motion.absolute_tolerance = tolerance == NULL ? 1e-9 : scalar(tolerance, "tolerance");
  if (method != NULL) {
    char* const name = text_of(method, "the method");
    while (motion.method < abi->method_count && strcmp(abi->methods[motion.method].name, name) != 0) ++motion.method;
    if (motion.method == abi->method_count) mexErrMsgIdAndTxt("torsor:usage", "there is no method '%s'", name);
    mxFree(name);
  }
  if (motion.method < abi->method_count) {
    const torsor_method* const by = &abi->methods[motion.method];
    if (by->fixed_step && step == NULL) mexErrMsgIdAndTxt("torsor:usage", "%s has a fixed step: give 'step'", by->name);
    if (by->fixed_step && tolerance != NULL)
      mexErrMsgIdAndTxt("torsor:usage", "%s has a fixed step and reads no 'tolerance': leave it out", by->name);
    if (!by->fixed_step && step != NULL)
      mexErrMsgIdAndTxt("torsor:usage", "%s chooses its own steps: leave 'step' out, or name another method", by->name);
  }
  motion.times = mxGetPr(in[0]);
  motion.time_count = times;
  out[0] = mxCreateDoubleMatrix((mwSize)size, (mwSize)times, mxREAL);
  motion.states.data = mxGetPr(out[0]);
  motion.states.row = (ptrdiff_t)(sizeof(double) * (size_t)size);
  motion.states.column = (ptrdiff_t)sizeof(double);
  motion.states.state = (ptrdiff_t)(sizeof(double) * (size_t)size * times);
  motion.statuses = &status;
  motion.ends = &end;
  motion.model = model_of(place, named(count - 2, in + 2, "parameters"));
  failed = abi->integrate(&motion);
  finish(place, (torsor_model*)(uintptr_t)motion.model);
  if (failed < 0) mexErrMsgIdAndTxt("torsor:call", "integrate refuses the call: %d (runtime/abi.h)", (int)failed);
  if (outputs > 1) out[1] = mxCreateDoubleScalar(end);
  if (outputs > 2) {
    out[2] = mxCreateDoubleScalar(status);
  } else if (failed > 0) {
    mexErrMsgIdAndTxt("torsor:motion", "the motion ends at t = %.17g with status %d: %s", end, (int)status, why(status));
  }
}

void mexFunction(int outputs, mxArray* out[], int count, const mxArray* in[]) {
  char* name;
  int place;
  int32_t k = 0;
  if (count < 1) mexErrMsgIdAndTxt("torsor:usage", "torsor_call(LIBRARY), or torsor_call(LIBRARY, KERNEL, q, v, NAME, VALUE, ...)");
  place = open_library(in[0]);
  if (count == 1) {
    out[0] = description(place);
    return;
  }
  name = text_of(in[1], "the name of a kernel");
  if (strcmp(name, "integrate") == 0) {
    integrate(place, outputs, out, count - 2, in + 2);
  } else {
    const torsor_abi* const abi = opened[place].abi;
    while (k < abi->kernel_count && strcmp(abi->kernels[k].name, name) != 0) ++k;
    if (k == abi->kernel_count)
      mexErrMsgIdAndTxt("torsor:usage", "%s has no kernel '%s': build --kernels names more", abi->name, name);
    evaluate(place, &abi->kernels[k], outputs, out, count - 2, in + 2);
  }
  mxFree(name);
}
