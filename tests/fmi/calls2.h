/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The calls of FMI 2.0, and in which modes it allows them. */
static void quiet(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category, fmi2String format,
                  ...) {
  (void)environment;
  (void)status;
  if (strcmp(name, "one") != 0 || strcmp(category, "logStatusError") != 0 || strlen(format) == 0) abort();
}
static const fmi2CallbackFunctions callbacks = {quiet, calloc, free, NULL, NULL};

static void* make(int exchange) {
  if (fmi2Instantiate("one", fmi2ModelExchange, "{another}", "", &callbacks, 0, 1) != NULL) abort();
  return fmi2Instantiate("one", exchange ? fmi2ModelExchange : fmi2CoSimulation, TOKEN, "", &callbacks, 0, 1);
}
static void release(void) { fmi2FreeInstance(instance); }
static void free_saved(void) { fmi2FreeFMUstate(instance, &saved); }

static fmi2Boolean flags[2];
static fmi2EventInfo events;
static double* const into = numbers;

static int set_up(void) {
  const double tolerance = pick(3) ? 1e-6 : number(), start = pick(3) ? 0.0 : number(), stop = pick(3) ? 100.0 : number();
  may_refuse = 1;
  return (int)fmi2SetupExperiment(instance, pick(2) == 0, tolerance, start, pick(4) == 0, stop);
}
static int enter_initialization(void) { return (int)fmi2EnterInitializationMode(instance); }
static int exit_initialization(void) { return (int)fmi2ExitInitializationMode(instance); }
static int update(void) { return (int)fmi2NewDiscreteStates(instance, &events); }
static int enter_continuous(void) { return (int)fmi2EnterContinuousTimeMode(instance); }
static int enter_event(void) { return (int)fmi2EnterEventMode(instance); }
static int step(void) {
  const double time = ((unit*)instance)->m.now.time, length[] = {1e-4, 1e-3, 1e-5, -1e-4, HUGE_VAL - HUGE_VAL};
  const int status = (int)fmi2DoStep(instance, pick(9) ? time : number(), length[pick(5)], pick(2) == 0);
  may_refuse = 1;
  if (status == discarded) mode = failed;
  return status;
}
static int complete(void) { return (int)fmi2CompletedIntegratorStep(instance, 1, &flags[0], &flags[1]); }
static int set_time(void) {
  may_refuse = 1;
  return (int)fmi2SetTime(instance, number());
}
static int set_states(void) {
  may_refuse = 1;
  return (int)fmi2SetContinuousStates(instance, some(NX), pick(9) ? NX : 1);
}
static int get_numbers(void) {
  const unsigned n = pick(4);
  may_refuse = 1;
  return (int)fmi2GetReal(instance, references(0, variable_count + pick(2), n), n, into);
}
static int set_numbers(void) {
  const unsigned n = pick(4);
  may_refuse = 1;
  return (int)fmi2SetReal(instance, references(0, variable_count + 1, n), n, some(n));
}
static int get_nothing(void) {
  may_refuse = 1;
  return (int)(pick(2) ? fmi2GetReal(instance, NULL, 1, NULL) : fmi2GetInteger(instance, NULL, 0, NULL));
}
static int derivatives(void) {
  may_refuse = 1;
  return (int)fmi2GetDerivatives(instance, into, pick(9) ? NX : 0);
}
static int states(void) { return (int)fmi2GetContinuousStates(instance, into, NX); }
static int nominals(void) { return (int)fmi2GetNominalsOfContinuousStates(instance, into, NX); }
static int indicators(void) {
  may_refuse = 1;
  return (int)fmi2GetEventIndicators(instance, into, pick(2));
}
static int along(void) {
  const unsigned unknowns = pick(4), knowns = pick(4);
  const unsigned* const unknown = references(NX, NX + (pick(4) == 0), unknowns);
  unsigned copy[4];
  memcpy(copy, unknown, sizeof(copy));
  may_refuse = 1;
  return (int)fmi2GetDirectionalDerivative(instance, copy, unknowns, references(0, NX + 2, knowns), knowns, some(knowns), into);
}
static int save(void) {
  const int status = (int)fmi2GetFMUstate(instance, &saved);
  if (status == ok) saved_mode = mode;
  return status;
}
static int restore(void) {
  const int status = (int)fmi2SetFMUstate(instance, saved);
  may_refuse = saved == NULL;
  if (status == ok) mode = saved_mode;
  return status;
}
static int forget(void) { return (int)fmi2FreeFMUstate(instance, &saved); }
static int serialise(void) {
  may_refuse = 1;
  if (saved == NULL || fmi2SerializedFMUstateSize(instance, saved, sizes) != fmi2OK) return refused;
  if (sizes[0] > sizeof(bytes) || fmi2SerializeFMUstate(instance, saved, (fmi2Byte*)bytes, sizes[0] - 1) != fmi2Error) abort();
  if (fmi2SerializeFMUstate(instance, saved, (fmi2Byte*)bytes, sizes[0]) != fmi2OK) abort();
  return (int)fmi2DeSerializeFMUstate(instance, (const fmi2Byte*)bytes, sizes[0] + pick(2), &saved);
}
static int reset(void) { return (int)fmi2Reset(instance); }
static int terminate(void) { return (int)fmi2Terminate(instance); }
static int debug(void) { return (int)fmi2SetDebugLogging(instance, pick(2) == 0, 0, NULL); }
static int status_of_step(void) {
  fmi2Status status;
  may_refuse = 1;
  if (fmi2GetStatus(instance, fmi2DoStepStatus, &status) != fmi2Discard) abort();
  return (int)(pick(2) ? fmi2GetRealStatus(instance, fmi2LastSuccessfulTime, into)
                       : fmi2GetBooleanStatus(instance, fmi2Terminated, &flags[0]));
}
static int cancel(void) { return (int)fmi2CancelStep(instance); }
static int nobody(void) { return (int)fmi2GetReal(NULL, NULL, 0, NULL); }

enum { leading = 8, evaluable = initialization | event_mode | continuous_time | step_complete | terminated | failed,
       moving = event_mode | continuous_time | terminated | failed };
static const Call calls[] = {
    {"EnterInitializationMode", enter_initialization, instantiated, instantiated, initialization},
    {"ExitInitializationMode", exit_initialization, initialization, initialization, begins},
    {"NewDiscreteStates", update, event_mode, 0, 0},
    {"EnterContinuousTimeMode", enter_continuous, event_mode, 0, continuous_time},
    {"DoStep", step, 0, step_complete, 0},
    {"CompletedIntegratorStep", complete, continuous_time, 0, 0},
    {"SetContinuousStates", set_states, continuous_time, 0, 0},
    {"GetReal", get_numbers, evaluable, evaluable, 0},
    {"EnterEventMode", enter_event, continuous_time | event_mode, 0, event_mode},
    {"SetTime", set_time, event_mode | continuous_time, 0, 0},
    {"SetReal", set_numbers, any_mode & ~(terminated | failed), any_mode & ~(terminated | failed), 0},
    {"Get of nothing", get_nothing, any_mode, any_mode, 0},
    {"GetDerivatives", derivatives, moving, moving, 0},
    {"GetContinuousStates", states, moving, moving, 0},
    {"GetNominalsOfContinuousStates", nominals, moving | instantiated, moving | instantiated, 0},
    {"GetEventIndicators", indicators, moving, moving, 0},
    {"GetDirectionalDerivative", along, evaluable, evaluable, 0},
    {"GetFMUstate", save, any_mode, any_mode, 0},
    {"SetFMUstate", restore, any_mode, any_mode, 0},
    {"FreeFMUstate", forget, any_mode, any_mode, 0},
    {"SerializeFMUstate", serialise, any_mode, any_mode, 0},
    {"Reset", reset, any_mode, any_mode, instantiated},
    {"Terminate", terminate, event_mode | continuous_time, step_complete | failed, terminated},
    {"CancelStep", cancel, 0, 0, 0},
    {"SetDebugLogging", debug, any_mode, any_mode, 0},
    {"GetRealStatus", status_of_step, any_mode, any_mode, 0},
    {"SetupExperiment", set_up, instantiated, instantiated, 0},
    {"no instance", nobody, 0, 0, 0},
};
