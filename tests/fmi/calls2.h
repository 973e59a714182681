/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What only FMI 2.0 has, and in which modes it allows it. */
#define fmi(name) fmi2##name
#define get_state fmi2GetFMUstate
#define set_state fmi2SetFMUstate
#define free_state fmi2FreeFMUstate
#define size_of_state fmi2SerializedFMUstateSize
#define state_to_bytes fmi2SerializeFMUstate
#define state_from_bytes fmi2DeSerializeFMUstate
#define get_derivatives fmi2GetDerivatives
typedef fmi2Byte Byte;

enum { tells_derivatives = event_mode | continuous_time | terminated | failed, tells_states = tells_derivatives | initialization,
       tells_nominals = tells_derivatives | instantiated,
       event_follows = continuous_time | event_mode };

static void quiet(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category, fmi2String message,
                  ...) {
  (void)environment;
  if (strcmp(name, "one") != 0 || strcmp(category, category_of((int)status)) != 0) abort();
  if (strncmp(message, "fmi2", 4) != 0 || strchr(message, '%') != NULL) abort();
  hear(message);
}
static const fmi2CallbackFunctions callbacks = {quiet, calloc, free, NULL, NULL};

static void* make(int exchange) {
  if (fmi2Instantiate("one", fmi2ModelExchange, "{another}", "", &callbacks, 0, 1) != NULL) abort();
  return fmi2Instantiate("one", exchange ? fmi2ModelExchange : fmi2CoSimulation, TOKEN, "", &callbacks, 0, 1);
}

static fmi2Boolean flags[2];
static fmi2EventInfo events;
static double* const into = numbers;

static int set_up(void) {
  const double tolerance = pick(3) ? 1e-6 : number(), start = pick(3) ? 0.0 : number(), stop = pick(3) ? 100.0 : number();
  may_refuse = 1;
  return (int)fmi2SetupExperiment(instance, pick(2) == 0, tolerance, start, pick(4) == 0, stop);
}
static int enter_initialization(void) { return (int)fmi2EnterInitializationMode(instance); }
static int update(void) {
  const int status = (int)fmi2NewDiscreteStates(instance, &events);
  may_refuse = ended();
  return status;
}
static int do_step(double time, double length, int no_return) { return (int)fmi2DoStep(instance, time, length, no_return); }
static int get_values(const unsigned* which, unsigned n, double* values, unsigned size) {
  (void)size;
  return (int)fmi2GetReal(instance, which, n, values);
}
static int set_values(const unsigned* which, unsigned n, const double* values, unsigned size) {
  (void)size;
  return (int)fmi2SetReal(instance, which, n, values);
}
static int get_no_integers(void) { return (int)fmi2GetInteger(instance, NULL, 0, NULL); }
static int get_derivative_along(const unsigned* unknown, unsigned unknowns, unsigned knowns) {
  return (int)fmi2GetDirectionalDerivative(instance, unknown, unknowns, some_known(knowns), knowns, some(knowns), into);
}
static int status_of_step(void) {
  fmi2Status status;
  may_refuse = 1;
  if (fmi2GetStatus(instance, fmi2DoStepStatus, &status) != fmi2Discard) abort();
  return (int)(pick(2) ? fmi2GetRealStatus(instance, fmi2LastSuccessfulTime, into)
                       : fmi2GetBooleanStatus(instance, fmi2Terminated, &flags[0]));
}
static int cancel(void) { return (int)fmi2CancelStep(instance); }

#define OWN_CALLS                                               \
  {"SetupExperiment", set_up, instantiated, instantiated, 0},   \
  {"GetRealStatus", status_of_step, any_mode, any_mode, 0},     \
  {"CancelStep", cancel, 0, 0, 0}
#include "calls.h"
