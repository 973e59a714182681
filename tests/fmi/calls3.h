/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The calls of FMI 3.0, and in which modes it allows them. */
static void quiet(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message) {
  (void)environment;
  (void)status;
  if (strcmp(category, "logStatusError") != 0 || strncmp(message, "fmi3", 4) != 0) abort();
}

static void* make(int exchange) {
  if (fmi3InstantiateModelExchange("one", "{another}", "", 0, 1, NULL, quiet) != NULL) abort();
  if (exchange) return fmi3InstantiateModelExchange("one", TOKEN, "", 0, 1, NULL, quiet);
  return fmi3InstantiateCoSimulation("one", TOKEN, "", 0, 1, 0, 0, NULL, 0, NULL, quiet, NULL);
}
static void release(void) { fmi3FreeInstance(instance); }
static void free_saved(void) { fmi3FreeFMUState(instance, &saved); }

static bool flags[6];
static double* const into = numbers;

static int enter_initialization(void) {
  const double tolerance = pick(3) ? 1e-6 : number(), start = pick(3) ? 0.0 : number(), stop = pick(3) ? 100.0 : number();
  may_refuse = 1;
  return (int)fmi3EnterInitializationMode(instance, pick(2) == 0, tolerance, start, pick(4) == 0, stop);
}
static int exit_initialization(void) { return (int)fmi3ExitInitializationMode(instance); }
static int update(void) {
  return (int)fmi3UpdateDiscreteStates(instance, &flags[0], &flags[1], &flags[2], &flags[3], &flags[4], into);
}
static int enter_continuous(void) { return (int)fmi3EnterContinuousTimeMode(instance); }
static int enter_event(void) { return (int)fmi3EnterEventMode(instance); }
static int step(void) {
  const double time = ((unit*)instance)->m.now.time, length[] = {1e-4, 1e-3, 1e-5, -1e-4, HUGE_VAL - HUGE_VAL};
  const int status = (int)fmi3DoStep(instance, pick(9) ? time : number(), length[pick(5)], pick(2) == 0,
                                     &flags[0], &flags[1], &flags[2], into);
  may_refuse = 1;
  if (status == discarded) mode = failed;
  return status;
}
static int complete(void) { return (int)fmi3CompletedIntegratorStep(instance, 1, &flags[0], &flags[1]); }
static int set_time(void) {
  may_refuse = 1;
  return (int)fmi3SetTime(instance, number());
}
static int set_states(void) {
  may_refuse = 1;
  return (int)fmi3SetContinuousStates(instance, some(NX), pick(9) ? NX : 1);
}
static int get_numbers(void) {
  const unsigned n = pick(4);
  may_refuse = 1;
  return (int)fmi3GetFloat64(instance, references(0, variable_count + pick(2), n), n, into, pick(9) ? n : n + 1);
}
static int set_numbers(void) {
  const unsigned n = pick(4);
  may_refuse = 1;
  return (int)fmi3SetFloat64(instance, references(0, variable_count + 1, n), n, some(n), pick(9) ? n : n + 1);
}
static int get_nothing(void) {
  may_refuse = 1;
  return (int)(pick(2) ? fmi3GetFloat64(instance, NULL, 1, NULL, 1) : fmi3GetInt32(instance, NULL, 0, NULL, 0));
}
static int derivatives(void) {
  may_refuse = 1;
  return (int)fmi3GetContinuousStateDerivatives(instance, into, pick(9) ? NX : 0);
}
static int states(void) { return (int)fmi3GetContinuousStates(instance, into, NX); }
static int nominals(void) { return (int)fmi3GetNominalsOfContinuousStates(instance, into, NX); }
static int indicators(void) {
  may_refuse = 1;
  return (int)fmi3GetEventIndicators(instance, into, pick(2));
}
static int along(void) {
  const unsigned unknowns = pick(4), knowns = pick(4);
  const unsigned* const unknown = references(NX, NX + (pick(4) == 0), unknowns);
  unsigned copy[4];
  memcpy(copy, unknown, sizeof(copy));
  may_refuse = 1;
  if (pick(2)) {
    return (int)fmi3GetDirectionalDerivative(instance, copy, unknowns, references(0, NX, knowns), knowns, some(knowns), knowns,
                                             into, unknowns);
  }
  return (int)fmi3GetAdjointDerivative(instance, copy, unknowns, references(0, NX + 2, knowns), knowns, some(unknowns), unknowns,
                                       into, pick(9) ? knowns : 0);
}
static int save(void) {
  const int status = (int)fmi3GetFMUState(instance, &saved);
  if (status == ok) saved_mode = mode;
  return status;
}
static int restore(void) {
  const int status = (int)fmi3SetFMUState(instance, saved);
  may_refuse = saved == NULL;
  if (status == ok) mode = saved_mode;
  return status;
}
static int forget(void) { return (int)fmi3FreeFMUState(instance, &saved); }
static int serialise(void) {
  may_refuse = 1;
  if (saved == NULL || fmi3SerializedFMUStateSize(instance, saved, sizes) != fmi3OK) return refused;
  if (sizes[0] > sizeof(bytes) || fmi3SerializeFMUState(instance, saved, bytes, sizes[0] - 1) != fmi3Error) abort();
  if (fmi3SerializeFMUState(instance, saved, bytes, sizes[0]) != fmi3OK) abort();
  return (int)fmi3DeserializeFMUState(instance, bytes, sizes[0] + pick(2), &saved);
}
static int reset(void) { return (int)fmi3Reset(instance); }
static int terminate(void) { return (int)fmi3Terminate(instance); }
static int step_mode(void) { return (int)fmi3EnterStepMode(instance); }
static int configure(void) { return (int)(pick(2) ? fmi3EnterConfigurationMode(instance) : fmi3ExitConfigurationMode(instance)); }
static int debug(void) { return (int)fmi3SetDebugLogging(instance, pick(2) == 0, 0, NULL); }
static int count(void) {
  return (int)(pick(2) ? fmi3GetNumberOfContinuousStates(instance, sizes) : fmi3GetNumberOfEventIndicators(instance, sizes));
}
static int nobody(void) { return (int)fmi3GetFloat64(NULL, NULL, 0, NULL, 0); }

enum { leading = 8, evaluable = initialization | event_mode | continuous_time | step_complete | terminated | failed };
static const Call calls[] = {
    {"EnterInitializationMode", enter_initialization, instantiated, instantiated, initialization},
    {"ExitInitializationMode", exit_initialization, initialization, initialization, begins},
    {"UpdateDiscreteStates", update, event_mode, 0, 0},
    {"EnterContinuousTimeMode", enter_continuous, event_mode, 0, continuous_time},
    {"DoStep", step, 0, step_complete, 0},
    {"CompletedIntegratorStep", complete, continuous_time, 0, 0},
    {"SetContinuousStates", set_states, continuous_time, 0, 0},
    {"GetFloat64", get_numbers, evaluable, evaluable, 0},
    {"EnterEventMode", enter_event, continuous_time, 0, event_mode},
    {"SetTime", set_time, event_mode | continuous_time, 0, 0},
    {"SetFloat64", set_numbers, any_mode & ~(terminated | failed), any_mode & ~(terminated | failed), 0},
    {"Get of nothing", get_nothing, any_mode, any_mode, 0},
    {"GetContinuousStateDerivatives", derivatives, evaluable, evaluable, 0},
    {"GetContinuousStates", states, evaluable, evaluable, 0},
    {"GetNominalsOfContinuousStates", nominals, any_mode, any_mode, 0},
    {"GetEventIndicators", indicators, evaluable, evaluable, 0},
    {"GetDirectionalDerivative", along, evaluable, evaluable, 0},
    {"GetFMUState", save, any_mode, any_mode, 0},
    {"SetFMUState", restore, any_mode, any_mode, 0},
    {"FreeFMUState", forget, any_mode, any_mode, 0},
    {"SerializeFMUState", serialise, any_mode, any_mode, 0},
    {"Reset", reset, any_mode, any_mode, instantiated},
    {"Terminate", terminate, event_mode | continuous_time, step_complete | failed, terminated},
    {"EnterStepMode", step_mode, 0, 0, 0},
    {"EnterConfigurationMode", configure, 0, 0, 0},
    {"SetDebugLogging", debug, any_mode, any_mode, 0},
    {"GetNumberOf", count, any_mode, any_mode, 0},
    {"no instance", nobody, 0, 0, 0},
};
