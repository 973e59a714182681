/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sequences of random calls of one unit of FMI, with good and bad arguments, in every order. Each call is answered as the
 * standard's state machine says; the sanitizers that this is compiled with see to the rest. With -DCOUNT_ALLOCATIONS and
 * -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc no call may allocate but those that make an instance or a state.
 *   cc -DUNIT='"NAME_fmi3.c"' -DCALLS='"calls3.h"' -DTOKEN='"{...}"' random_calls.c; ./a.out SEQUENCES */
#include UNIT
#include <stdio.h>

#ifdef COUNT_ALLOCATIONS
/* The linker sends calls of NAME to __wrap_NAME, and those of __real_NAME to NAME. */
static long allocations;
void* __real_malloc(size_t size);
void* __real_calloc(size_t count, size_t size);
void* __real_realloc(void* place, size_t size);
void* __wrap_malloc(size_t size);
void* __wrap_calloc(size_t count, size_t size);
void* __wrap_realloc(void* place, size_t size);
void* __wrap_malloc(size_t size) { return ++allocations, __real_malloc(size); }
void* __wrap_calloc(size_t count, size_t size) { return ++allocations, __real_calloc(count, size); }
void* __wrap_realloc(void* place, size_t size) { return ++allocations, __real_realloc(place, size); }
#else
enum { allocations = 0 };
#endif

enum { ok = 0, discarded = 2, refused = 3, any_mode = 127, begins = -1 };

static void* instance;
static void* saved; /* a state of the unit, and the mode it was saved in */
static int saved_mode, mode, exchanging;
static double numbers[4 * NX + NU + NL + 64];
static size_t sizes[2];
static unsigned char bytes[torsor_fmi_bytes + 8];

static unsigned long long seed = 88172645463325252ull;
static unsigned pick(unsigned below) { /* Marsaglia 2003, xorshift64 */
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return (unsigned)(seed >> 33) % below;
}

/* Something finite, mostly; with bad numbers now and then. */
static double number(void) {
  static const double odd[] = {0.0, -1.0, 1e-300, 1e300, -1e308};
  const unsigned k = pick(40);
  if (k == 0) return HUGE_VAL;
  if (k == 1) return HUGE_VAL - HUGE_VAL;
  if (k < 7) return odd[k - 2];
  return (int)pick(2001) / 1000.0 - 1.0;
}

static const unsigned* references(unsigned from, unsigned below, unsigned count) {
  static unsigned vr[8];
  unsigned i;
  for (i = 0; i < count; ++i) vr[i] = from + pick(below);
  return vr;
}

/* States, and the first derivatives, which are none; or inputs, parameters, and what follows them. */
static const unsigned* some_known(unsigned count) {
  return pick(2) ? references(0, NX + 2, count) : references(torsor_first_input, NU + NP + 1, count);
}

static const double* some(unsigned count) {
  static double values[NX + 8];
  unsigned i;
  for (i = 0; i < count; ++i) values[i] = number();
  return values;
}

typedef struct {
  const char* name;
  int (*call)(void);
  int exchange, simulation; /* modes in which it is allowed */
  int next;                 /* mode after it; 0: as before; begins: the first one of a simulation */
} Call;

/* Whether a call may be refused though it is allowed: its arguments may be bad. */
static int may_refuse;

/* Whether an event has ended the motion: random states may meet no constraints, and no laws of contact. */
static int ended(void) { return ((const unit*)instance)->m.now.mode == terminated; }

/* Whether the unit said that the motion ends, and what it said last. */
static int motion_ended;
static char heard[400];
static void hear(const char* message) {
  motion_ended |= strstr(message, "the motion ends") != NULL;
  snprintf(heard, sizeof(heard), "%s", message);
}

static const char* category_of(int status) { return status == discarded ? "logStatusDiscard" : "logStatusError"; }

enum { evaluable = initialization | event_mode | continuous_time | step_complete | terminated | failed };

#include CALLS

int main(int count, char** words) {
  const long sequences = count > 1 ? atol(words[1]) : 1000;
  long done, made = 0, answers[4] = {0};
  int k;
  for (done = 0; done < sequences; ++done) {
    exchanging = (int)pick(2);
    instance = make(exchanging);
    if (instance == NULL) return fprintf(stderr, "no instance\n"), 1;
    mode = instantiated;
    for (k = 0; k < 60; ++k) {
      /* Half of the calls are those that lead on: few sequences would get anywhere else. */
      const unsigned n = sizeof(calls) / sizeof(calls[0]);
      const Call* const each = &calls[pick(2) ? pick(n) : pick(leading)];
      const int allowed_now = ((exchanging ? each->exchange : each->simulation) & mode) != 0;
      const long before = allocations;
      int status;
      may_refuse = motion_ended = 0;
      status = each->call();
      if (allocations != before && each->call != save && each->call != serialise) {
        return fprintf(stderr, "%s allocates\n", each->name), 1;
      }
      made += allocations - before;
      if (status != ok && status != discarded && status != refused) {
        return fprintf(stderr, "%s answers %d\n", each->name, status), 1;
      }
      /* A motion with contacts may end, and the unit says so; its mode is then its own matter. */
      if (HAS_CONTACTS && motion_ended) may_refuse = 1;
      if (!allowed_now ? status != refused : status == refused && !may_refuse) {
        return fprintf(stderr, "%s answers %d in mode %d of %s: %s\n", each->name, status, mode, exchanging ? "ME" : "CS", heard), 1;
      }
      if (status == ok && each->next > 0) mode = each->next;
      if (status == ok && each->next == begins) mode = exchanging ? event_mode : step_complete;
      if (allowed_now && status == refused) mode = ((const unit*)instance)->m.now.mode;
      ++answers[status];
    }
    free_saved();
    release();
  }
  printf("%ld sequences: %ld calls ok, %ld discarded, %ld refused; %ld states made\n", done, answers[ok], answers[discarded],
         answers[refused], made);
#ifdef COUNT_ALLOCATIONS
  if (made == 0) return 1; /* nothing was counted */
#endif
  return answers[ok] > 0 && answers[refused] > 0 ? 0 : 1;
}
