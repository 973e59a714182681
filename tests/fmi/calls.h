/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The calls that both versions of FMI have, and the table of all. calls2.h and calls3.h say what is their own, and include
 * this: `fmi(Name)` is a function of the version, `Flag` its truth value. */
static void release(void) { fmi(FreeInstance)(instance); }
static void free_saved(void) { free_state(instance, &saved); }

static int exit_initialization(void) {
  may_refuse = 1; /* a start near which nothing meets the constraints */
  return (int)fmi(ExitInitializationMode)(instance);
}
static int enter_continuous(void) { return (int)fmi(EnterContinuousTimeMode)(instance); }
static int enter_event(void) { return (int)fmi(EnterEventMode)(instance); }
static int step(void) {
  const double time = ((unit*)instance)->m.now.time, length[] = {1e-4, 1e-3, 1e-5, -1e-4, HUGE_VAL - HUGE_VAL};
  const int status = do_step(pick(9) ? time : number(), length[pick(5)], pick(2) == 0);
  may_refuse = 1;
  if (status == discarded) mode = failed;
  return status;
}
static int complete(void) { return (int)fmi(CompletedIntegratorStep)(instance, 1, &flags[0], &flags[1]); }
static int set_time(void) {
  may_refuse = 1;
  return (int)fmi(SetTime)(instance, number());
}
static int set_states(void) {
  may_refuse = 1;
  return (int)fmi(SetContinuousStates)(instance, some(NX), pick(9) ? NX : 1);
}
static int get_numbers(void) {
  const unsigned n = pick(4);
  may_refuse = 1;
  return get_values(references(0, variable_count + pick(2), n), n, into, pick(9) ? n : n + 1);
}
static int set_numbers(void) {
  const unsigned n = pick(4);
  may_refuse = 1;
  return set_values(references(0, variable_count + 1, n), n, some(n), pick(9) ? n : n + 1);
}
static int get_nothing(void) {
  may_refuse = 1;
  return pick(2) ? get_values(NULL, 1, NULL, 1) : get_no_integers();
}
static int derivatives(void) {
  may_refuse = 1;
  return (int)get_derivatives(instance, into, pick(9) ? NX : 0);
}
static int states(void) { return (int)fmi(GetContinuousStates)(instance, into, NX); }
static int nominals(void) { return (int)fmi(GetNominalsOfContinuousStates)(instance, into, NX); }
static int indicators(void) {
  may_refuse = 1;
  return (int)fmi(GetEventIndicators)(instance, into, pick(2) ? NI : pick(2));
}
static int along(void) {
  const unsigned unknowns = pick(4), knowns = pick(4);
  const unsigned* const unknown = pick(2) ? references(NX, NX + (pick(4) == 0), unknowns)
                                          : references(torsor_first_multiplier, NL + NE + NO + NR + (pick(4) == 0), unknowns);
  unsigned copy[4];
  memcpy(copy, unknown, sizeof(copy));
  may_refuse = 1;
  return get_derivative_along(copy, unknowns, knowns);
}
static int save(void) {
  const int status = (int)get_state(instance, &saved);
  if (status == ok) saved_mode = mode;
  return status;
}
static int restore(void) {
  const int status = (int)set_state(instance, saved);
  may_refuse = saved == NULL;
  if (status == ok) mode = saved_mode;
  return status;
}
static int forget(void) { return (int)free_state(instance, &saved); }
static int serialise(void) {
  may_refuse = 1;
  if (saved == NULL || (int)size_of_state(instance, saved, sizes) != ok) return refused;
  if (sizes[0] > sizeof(bytes) || (int)state_to_bytes(instance, saved, (Byte*)bytes, sizes[0] - 1) != refused) abort();
  if ((int)state_to_bytes(instance, saved, (Byte*)bytes, sizes[0]) != ok) abort();
  return (int)state_from_bytes(instance, (const Byte*)bytes, sizes[0] + pick(2), &saved);
}
static int reset(void) { return (int)fmi(Reset)(instance); }
static int terminate(void) { return (int)fmi(Terminate)(instance); }
static int debug(void) {
  static const char* const categories[] = {"logStatusError", "logStatusDiscard", "logStatusError", "another"};
  const unsigned from = pick(2), count = pick(4 - from);
  const int on = pick(2) == 0, status = (int)fmi(SetDebugLogging)(instance, on, count, categories + from);
  may_refuse = on && from + count == 4;
  return status;
}
static int nobody(void) { return (int)get_derivatives(NULL, NULL, 0); }

enum { leading = 8 };
static const Call calls[] = {
    {"EnterInitializationMode", enter_initialization, instantiated, instantiated, initialization},
    {"ExitInitializationMode", exit_initialization, initialization, initialization, begins},
    {"discrete states", update, event_mode, 0, 0},
    {"EnterContinuousTimeMode", enter_continuous, event_mode, 0, continuous_time},
    {"DoStep", step, 0, step_complete, 0},
    {"CompletedIntegratorStep", complete, continuous_time, 0, 0},
    {"SetContinuousStates", set_states, continuous_time, 0, 0},
    {"get numbers", get_numbers, evaluable, evaluable, 0},
    {"EnterEventMode", enter_event, event_follows, 0, event_mode},
    {"SetTime", set_time, event_mode | continuous_time, 0, 0},
    {"set numbers", set_numbers, any_mode & ~(terminated | failed), any_mode & ~(terminated | failed), 0},
    {"get nothing", get_nothing, any_mode, any_mode, 0},
    {"derivatives", derivatives, tells_derivatives, tells_derivatives, 0},
    {"GetContinuousStates", states, tells_states, tells_states, 0},
    {"GetNominalsOfContinuousStates", nominals, tells_nominals, tells_nominals, 0},
    {"GetEventIndicators", indicators, tells_states, tells_states, 0},
    {"directional derivative", along, evaluable, evaluable, 0},
    {"get a state", save, any_mode, any_mode, 0},
    {"set a state", restore, any_mode, any_mode, 0},
    {"free a state", forget, any_mode, any_mode, 0},
    {"serialise a state", serialise, any_mode, any_mode, 0},
    {"Reset", reset, any_mode, any_mode, instantiated},
    {"Terminate", terminate, event_mode | continuous_time, step_complete | failed, terminated},
    {"SetDebugLogging", debug, any_mode, any_mode, 0},
    {"no instance", nobody, 0, 0, 0},
    OWN_CALLS,
};
