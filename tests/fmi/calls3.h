/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What only FMI 3.0 has, and in which modes it allows it. */
#define fmi(name) fmi3##name
#define get_state fmi3GetFMUState
#define set_state fmi3SetFMUState
#define free_state fmi3FreeFMUState
#define size_of_state fmi3SerializedFMUStateSize
#define state_to_bytes fmi3SerializeFMUState
#define state_from_bytes fmi3DeserializeFMUState
#define get_derivatives fmi3GetContinuousStateDerivatives
typedef fmi3Byte Byte;

enum { tells_derivatives = evaluable, tells_states = evaluable,
       tells_nominals = any_mode, event_follows = continuous_time };

static void quiet(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message) {
  (void)environment;
  if (strcmp(category, category_of((int)status)) != 0 || strncmp(message, "fmi3", 4) != 0) abort();
  hear(message);
}

static void* make(int exchange) {
  if (fmi3InstantiateModelExchange("one", "{another}", "", 0, 1, NULL, quiet) != NULL) abort();
  if (exchange) return fmi3InstantiateModelExchange("one", TOKEN, "", 0, 1, NULL, quiet);
  return fmi3InstantiateCoSimulation("one", TOKEN, "", 0, 1, 0, 0, NULL, 0, NULL, quiet, NULL);
}

static bool flags[6];
static double* const into = numbers;

static int enter_initialization(void) {
  const double tolerance = pick(3) ? 1e-6 : number(), start = pick(3) ? 0.0 : number(), stop = pick(3) ? 100.0 : number();
  may_refuse = 1;
  return (int)fmi3EnterInitializationMode(instance, pick(2) == 0, tolerance, start, pick(4) == 0, stop);
}
static int update(void) {
  const int status = (int)fmi3UpdateDiscreteStates(instance, &flags[0], &flags[1], &flags[2], &flags[3], &flags[4], into);
  may_refuse = ended();
  return status;
}
static int do_step(double time, double length, int no_return) {
  return (int)fmi3DoStep(instance, time, length, no_return, &flags[0], &flags[1], &flags[2], into);
}
static int get_values(const unsigned* which, unsigned n, double* values, unsigned size) {
  return (int)fmi3GetFloat64(instance, which, n, values, size);
}
static int set_values(const unsigned* which, unsigned n, const double* values, unsigned size) {
  return (int)fmi3SetFloat64(instance, which, n, values, size);
}
static int get_no_integers(void) { return (int)fmi3GetInt32(instance, NULL, 0, NULL, 0); }
static int get_derivative_along(const unsigned* unknown, unsigned unknowns, unsigned knowns) {
  if (pick(2)) {
    return (int)fmi3GetDirectionalDerivative(instance, unknown, unknowns, some_known(knowns), knowns, some(knowns), knowns,
                                             into, unknowns);
  }
  return (int)fmi3GetAdjointDerivative(instance, unknown, unknowns, some_known(knowns), knowns, some(unknowns), unknowns,
                                       into, pick(9) ? knowns : 0);
}
static int step_mode(void) { return (int)fmi3EnterStepMode(instance); }
static int configure(void) { return (int)(pick(2) ? fmi3EnterConfigurationMode(instance) : fmi3ExitConfigurationMode(instance)); }
static int count(void) {
  return (int)(pick(2) ? fmi3GetNumberOfContinuousStates(instance, sizes) : fmi3GetNumberOfEventIndicators(instance, sizes));
}

#define OWN_CALLS                                    \
  {"EnterStepMode", step_mode, 0, 0, 0},             \
  {"EnterConfigurationMode", configure, 0, 0, 0},    \
  {"GetNumberOf", count, any_mode, any_mode, 0}
#include "calls.h"
