/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Counts what a unit with contacts allocates in its steps, events and derivatives among them: a ball that bounces between stops,
 * slides and rolls.
 *   cc -DUNIT='"NAME_fmi3.c"' -DCALLS='"calls3.h"' -DTOKEN='"{...}"' contact_allocations.c, linked with the contact layer */
#include UNIT
#include <stdio.h>

static long allocations;
void* __libc_malloc(size_t size);
void* __libc_memalign(size_t alignment, size_t size);
void* malloc(size_t size) { return ++allocations, __libc_malloc(size); }
void* aligned_alloc(size_t alignment, size_t size) { return ++allocations, __libc_memalign(alignment, size); }

/* What the two versions name differently. */
#ifdef FMI3_EXPORT
static void* made(int exchange) {
  return exchange ? fmi3InstantiateModelExchange("one", TOKEN, NULL, false, false, NULL, NULL)
                  : fmi3InstantiateCoSimulation("one", TOKEN, NULL, false, false, false, false, NULL, 0, NULL, NULL, NULL);
}
static int begun(void* c) { return fmi3EnterInitializationMode(c, true, 1e-10, 0.0, false, 0.0) || fmi3ExitInitializationMode(c); }
static int step(void* c, double time, double size) {
  bool a, b, d;
  double reached;
  return fmi3DoStep(c, time, size, true, &a, &b, &d, &reached);
}
static int updated(void* c) {
  bool a[5];
  double next;
  return fmi3UpdateDiscreteStates(c, a, a + 1, a + 2, a + 3, a + 4, &next);
}
static int completed(void* c) {
  bool a, b;
  return fmi3CompletedIntegratorStep(c, true, &a, &b);
}
#define CALL(name) fmi3##name
#define DERIVATIVES fmi3GetContinuousStateDerivatives
#define SET(c, vr, x) fmi3SetFloat64(c, vr, 1, x, 1)
#define GET(c, vr, x) fmi3GetFloat64(c, vr, 1, x, 1)
#define SLOPE(c, of, by, seed, x) fmi3GetDirectionalDerivative(c, of, 1, by, 1, seed, 1, x, 1)
#else
static void* made(int exchange) {
  static const fmi2CallbackFunctions none;
  return fmi2Instantiate("one", exchange ? fmi2ModelExchange : fmi2CoSimulation, TOKEN, NULL, &none, 0, 0);
}
static int begun(void* c) {
  return fmi2SetupExperiment(c, 1, 1e-10, 0.0, 0, 0.0) || fmi2EnterInitializationMode(c) || fmi2ExitInitializationMode(c);
}
static int step(void* c, double time, double size) { return fmi2DoStep(c, time, size, 1); }
static int updated(void* c) {
  fmi2EventInfo info;
  return fmi2NewDiscreteStates(c, &info);
}
static int completed(void* c) {
  fmi2Boolean a, b;
  return fmi2CompletedIntegratorStep(c, 1, &a, &b);
}
#define CALL(name) fmi2##name
#define DERIVATIVES fmi2GetDerivatives
#define SET(c, vr, x) fmi2SetReal(c, vr, 1, x)
#define GET(c, vr, x) fmi2GetReal(c, vr, 1, x)
#define SLOPE(c, of, by, seed, x) fmi2GetDirectionalDerivative(c, of, 1, by, 1, seed, x)
#endif

/* Inputs that push it to and fro, and parameters that change on the way. */
static int pushed(void* c, int k) {
  const unsigned push = torsor_first_input, friction = torsor_first_parameter;
  const double force = k % 8 < 4 ? 3.0 : -3.0, f = 0.2 + 0.01 * (k % 3);
  return SET(c, &push, &force) || SET(c, &friction, &f);
}

/* Euler's steps suffice here: who integrates is the importer. */
static int exchanged(void* c, int k, int* events) {
  const unsigned energy = torsor_first_energy, acceleration = torsor_first_derivative + NQ, velocity = NQ;
  const double one = 1.0;
  double y[NX], slope[NX], z[NI], value;
  int i, j, fallen = 0;
  if (CALL(EnterEventMode)(c) || pushed(c, k) || updated(c) || CALL(EnterContinuousTimeMode)(c)) return 1;
  for (j = 0; j < 50; ++j) {
    if (CALL(SetTime)(c, 0.05 * k + 1e-3 * j) || CALL(GetContinuousStates)(c, y, NX) || DERIVATIVES(c, slope, NX)) return 1;
    for (i = 0; i < NX; ++i) y[i] += 1e-3 * slope[i];
    if (CALL(SetContinuousStates)(c, y, NX) || CALL(GetEventIndicators)(c, z, NI) || GET(c, &energy, &value)) return 1;
    if (SLOPE(c, &acceleration, &velocity, &one, &value)) return 1;
    for (i = 0, fallen = 0; i < NI; ++i) fallen |= z[i] <= 0.0;
    if (fallen && (CALL(EnterEventMode)(c) || updated(c) || CALL(EnterContinuousTimeMode)(c))) return 1;
    if (!fallen && completed(c)) return 1;
    *events += fallen;
  }
  return 0;
}

int main(void) {
  int exchange, k;
  for (exchange = 0; exchange < 2; ++exchange) {
    void* const c = made(exchange);
    long before = 0;
    int events = 0;
    if (c == NULL || begun(c)) return fprintf(stderr, "it does not begin\n"), 1;
    if (exchange && (updated(c) || CALL(EnterContinuousTimeMode)(c))) return 1;
    for (k = 0; k < 400; ++k) {
      if (k == 40) before = allocations; /* its first events are behind it */
      if (exchange ? exchanged(c, k, &events) : pushed(c, k) || step(c, 0.05 * k, 0.05)) {
        return fprintf(stderr, "step %d of %s fails\n", k, exchange ? "ME" : "CS"), 1;
      }
    }
    if (before == 0) return fprintf(stderr, "nothing is counted\n"), 1;
    if (exchange && events < 10) return fprintf(stderr, "%d events only\n", events), 1;
    if (allocations != before) return fprintf(stderr, "%ld allocations in %s\n", allocations - before, exchange ? "ME" : "CS"), 1;
    printf("%s: no allocation after %ld; %d events found\n", exchange ? "ME" : "CS", before, events);
    CALL(FreeInstance)(c);
  }
  return 0;
}
