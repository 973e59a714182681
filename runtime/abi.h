/* SPDX-License-Identifier: MIT */
/* A mechanism as a shared library: what `torsor build` makes, for every language that calls C. C99; also C++.
 *
 * The library has one symbol, `torsor_mechanism`, which gives a table of everything else:
 *
 *   const torsor_abi* arm = torsor_mechanism();           (or what dlsym finds under that name)
 *   torsor_model* model = arm->create(NULL);              (with the parameters of the scene)
 *   double q[7], v[7], a[7], forces[7];
 *   torsor_call call = {.model = model, .states = 1};
 *   call.q.data = q; call.v.data = v; call.accelerations.data = a;
 *   torsor_view results[1] = {{.data = forces, .row = sizeof(double)}};
 *   call.q.row = call.v.row = call.accelerations.row = sizeof(double);
 *   call.results = results;
 *   int64_t failed = arm->kernels[k].evaluate(&call);
 *
 * Numbers are double, units SI, angles in rad. Nothing here throws. Tables and texts live as long as the library. */
#ifndef TORSOR_ABI_H
#define TORSOR_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Another number: another layout. What a later version adds stands at the end of a structure. */
#define TORSOR_ABI_VERSION 2

/* A number of a vector: its name, and its unit as a person writes it. */
typedef struct torsor_abi_quantity {
  const char* name;
  const char* unit;
} torsor_abi_quantity;

/* What a kernel writes: a result, or a member of it; rows x columns numbers. Without columns: one for each order, 0 and
 * the highest included (Taylor coefficients). */
typedef struct torsor_abi_result {
  const char* name;
  int32_t rows, columns;
  int32_t dimensions; /* 0: a number, 1: a vector, 2: a matrix, also of one row or column */
  const char* unit;   /* of all its entries but those that are always zero; where those of a vector differ, of each:
                         "N, N m", with 0 for those. Empty where entries of a matrix differ, and of a series */
} torsor_abi_result;

/* Where numbers are: entry (i, j) of state s at data + s * state + i * row + j * column, all in bytes. A step of 0
 * gives the same numbers to all states. Addresses are those of doubles. */
typedef struct torsor_view {
  void* data;
  ptrdiff_t state, row, column;
} torsor_view;

/* Parameters, with what depends on them only. Not changed by calls: threads may share it. */
typedef struct torsor_model torsor_model;

/* What is said of one state; larger is worse. */
enum {
  torsor_state_ok = 0,
  torsor_state_singular = 1,           /* the mass matrix or the constraints lose rank */
  torsor_state_not_finite = 2,         /* a result is not a finite number */
  torsor_state_argument_not_finite = 3 /* an argument is not: the results are not meaningful */
};

/* Why a call did nothing. */
enum {
  torsor_call_without_model = -1,
  torsor_call_without_argument = -2, /* q, v or what else the kernel reads has no data */
  torsor_call_without_memory = -3,
  torsor_call_bad_order = -4,
  torsor_call_without_kernels = -5, /* the library lacks kernels that a motion needs */
  torsor_call_impossible_parameters = -6 /* torsor_abi.impossible says what of the model's parameters is */
};

/* One call of a kernel for one state or many. */
typedef struct torsor_call {
  const torsor_model* model;
  size_t states;
  uint32_t threads; /* 0: as many as the processor runs at once; results do not depend on it */
  int32_t order;    /* the highest, of Taylor coefficients */
  /* Column vectors. Those that the kernel does not read are not looked at. time, multipliers and inputs without data
   * are zero. */
  torsor_view time, q, v, accelerations, multipliers, inputs;
  const torsor_view* results; /* one for each of the kernel's results; those without data are not written */
  int32_t* statuses;          /* one for each state, or NULL */
  int32_t worst;              /* out: of all states */
} torsor_call;

/* Returns how many states failed, or one of the negative numbers above. A state's results do not depend on its
 * neighbours. One that fails has what the kernel left; those of others are good. */
typedef int64_t torsor_evaluate(torsor_call* call);

typedef struct torsor_abi_kernel {
  const char* name;
  int32_t reads_accelerations, reads_multipliers, reads_inputs; /* beside time, q and v */
  int32_t has_status; /* can be singular; a result that is not finite is told of every kernel */
  int32_t takes_order;
  int32_t result_count;
  const torsor_abi_result* results;
  torsor_evaluate* evaluate;
} torsor_abi_kernel;

/* Inputs u as they depend on time and y = [q; v]. */
typedef void torsor_input_law(void* context, double time, const double* y, double* inputs);

/* Motions from one time to others: y = [q; v], of n numbers. */
typedef struct torsor_motion {
  const torsor_model* model;
  size_t motions;
  uint32_t threads;    /* as in torsor_call */
  int32_t method;      /* place in the table of methods */
  int32_t unprojected; /* not 0: constraints drift. 0 takes the kernels mass_matrix and constraints where there are some:
                        * without them torsor_motion_unsuitable_model */
  double step;         /* of methods with a fixed step */
  double relative_tolerance, absolute_tolerance, first_step,
      largest_step;      /* of the others; steps of 0: their own choice */
  int64_t step_limit;    /* 0: that of the method */
  torsor_view time;      /* at the start, one for each motion */
  torsor_view start;     /* y there */
  torsor_view inputs;    /* constant along a motion; without data zero */
  torsor_input_law* law; /* or NULL; then `inputs` is not looked at. With threads it is called from several at once */
  void* context;
  const double* times; /* in the order in which they are reached */
  size_t time_count;
  torsor_view states; /* out: y of motion s at time i in row i; column is the step between its numbers */
  int32_t* statuses;  /* out: a torsor_motion_status for each motion, or NULL */
  double* ends;       /* out: the last time reached, or NULL */
  int64_t* calls;     /* out: evaluations of the equations, or NULL */
} torsor_motion;

/* Why a motion ended; with contacts for these reasons too. */
enum {
  torsor_motion_reached_end = 0,
  torsor_motion_stopped = 1,
  torsor_motion_invalid_options = 2,
  torsor_motion_step_too_small = 3,
  torsor_motion_too_many_steps = 4,
  torsor_motion_model_failure = 5,
  torsor_motion_no_convergence = 6,
  torsor_motion_unsuitable_model = 7,
  torsor_motion_no_regimes = 8,         /* no regimes of contacts fulfil their laws (Painleve) */
  torsor_motion_energy_gained = 9,      /* by the law of impact */
  torsor_motion_penetrates = 10,        /* a contact starts below its surface */
  torsor_motion_open_loops = 11,        /* constraints cannot be closed near the start */
  torsor_motion_impossible_surface = 12, /* coefficients that no surface has */
  torsor_motion_too_many_events = 13,
  torsor_motion_event_not_followed = 14,
  torsor_motion_law_of_one_contact = 15, /* the energetic law of impact, and several contacts struck at once */
  torsor_motion_without_memory = 16,
  torsor_motion_jams = 17, /* a contact that slides: the equations become singular, and what follows is not determined */
  torsor_motion_change_point = 18, /* constraints of loops lose rank, and a contact moves there: the motion does not pass it */
  torsor_motion_no_point = 19, /* a contact has no single point or normal (a flat disc), or its gap, or its rate, falls by a jump */
  torsor_motion_zero_quaternion = 20, /* the start has a quaternion of zeros: no attitude. Others are given norm 1 first */
  torsor_motion_no_impact = 21, /* no impulses fulfil the law of impact, or its collisions have no end: choose another law */
  torsor_motion_regimes_not_found = 22 /* of contacts; they are too many to try all */
};

typedef struct torsor_method {
  const char* name;
  int32_t fixed_step; /* reads `step`; else tolerances */
} torsor_method;

/* A contact that opens and closes, a stop, or dry friction. */
typedef struct torsor_abi_contact {
  const char* name;
  const char* gap_unit;      /* "m", or "rad" where an angle has a stop */
  const char* reaction_unit; /* of its reactions and, times s, of its impulses */
  int32_t normal;            /* 0: it has no gap, and is always closed: dry friction, resistance to turning */
  int32_t tangents;          /* rows of its reactions beside the normal one, which is the first */
} torsor_abi_contact;

/* What a contact does. Without friction a closed contact slides. */
enum { torsor_contact_open = 0, torsor_contact_sticks = 1, torsor_contact_slides = 2 };

enum {
  torsor_event_impact = 0,
  torsor_event_opens = 1,
  torsor_event_slips = 2,
  torsor_event_slip_ends = 3,
  torsor_event_accumulation = 4 /* bounces without end are over; the time is that to which they tend */
};

/* What happened to contacts. Arrays last as long as the call of the observer. */
typedef struct torsor_contact_event {
  size_t motion; /* which of the motions */
  int32_t kind;
  int32_t contact; /* the one that caused it */
  double time;
  const double *before, *after; /* y on either side */
  const int32_t* regimes;       /* of each contact, afterwards */
  const double* impulses;       /* of each row; zero but of impacts and accumulations */
  double energy_lost;           /* what contacts take: T- - T+ where no surface moves by itself */
} torsor_contact_event;

/* Returns 0 to go on; else the motion ends as stopped. With threads it is called from several at once. */
typedef int32_t torsor_contact_observer(void* context, const torsor_contact_event* event);

/* How velocities after an impact follow from those before: docs/contacts.md. */
enum {
  torsor_impact_newton_moreau = 0,
  torsor_impact_poisson = 1,
  torsor_impact_energetic = 2,
  torsor_impact_sequential = 3
};

/* Motions from event to event of contacts. What is zero takes the runtime's own choice, what is negative is refused. */
typedef struct torsor_contact_motion {
  torsor_motion motion; /* times that rise, by a method with tolerances; never unprojected */
  int32_t impact_law;
  int32_t impact_without_collision; /* not 0: where one contact slips and no regimes exist, by the energetic law */
  double touch;                     /* [m] gaps up to it are closed when another contact has an event */
  double at_rest;                   /* [m/s] velocities up to it are zero at the start */
  double accumulation;              /* [s] bounces whose remaining time is at most this are over */
  int64_t event_limit;
  torsor_contact_observer* observer; /* or NULL */
  void* observer_context;
  int32_t* regimes;  /* out: of contact k of motion s at time i at [(s * time_count + i) * contact_count + k], or NULL; -1
                        where a time was not reached */
  int32_t* contacts; /* out: for each motion the contact that ended it, or -1; or NULL */
} torsor_contact_motion;

typedef struct torsor_abi {
  uint32_t version; /* TORSOR_ABI_VERSION of the library */
  uint32_t size;    /* sizeof(torsor_abi) there */
  const char* name;
  uint64_t fingerprint; /* of the generated text */
  uint32_t lanes;       /* states that a kernel takes at once */
  int32_t coordinate_count, velocity_count, input_count, multiplier_count, parameter_count;
  const torsor_abi_quantity *coordinates, *velocities, *inputs, *multipliers, *parameters;
  const double* default_parameters;
  int32_t quaternion_count;
  const int32_t* quaternions; /* places of their first components (w) in q */
  int32_t kernel_count;
  const torsor_abi_kernel* kernels;
  int32_t method_count;
  const torsor_method* methods;

  /* Of parameters, those of the scene for NULL. NULL: no memory. */
  torsor_model* (*create)(const double* parameters);
  void (*destroy)(torsor_model* model);
  /* The state in which the scene starts, with these parameters. */
  void (*initial_state)(const torsor_model* model, double* time, double* q, double* v);
  /* Returns how many motions did not reach the last time, or a negative number as above. What was not reached is not a
   * number. */
  int64_t (*integrate)(const torsor_motion* motion);

  /* Contacts. Kernels are those of the mechanism with its contacts open; `integrate` moves it from event to event, as
   * integrate_contacts does by the runtime's own choices. */
  int32_t contact_count, contact_row_count;
  const torsor_abi_contact* contacts;
  int64_t (*integrate_contacts)(const torsor_contact_motion* motion); /* NULL without contacts */

  /* What no mechanism is made of, of a model's parameters: a mass below zero, a friction that pushes, stops exchanged. Names
   * it and the number; NULL where there is nothing. Calls with such a model are refused. The text lives as long as the model. */
  const char* (*impossible)(const torsor_model* model);
} torsor_abi;

#ifndef TORSOR_ABI_EXPORT
#define TORSOR_ABI_EXPORT
#endif
TORSOR_ABI_EXPORT const torsor_abi* torsor_mechanism(void);

#ifdef __cplusplus
}
#endif

#endif
