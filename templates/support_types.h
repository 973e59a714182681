/* SPDX-License-Identifier: MIT-0 */
#ifndef TORSOR_C_SUPPORT
#define TORSOR_C_SUPPORT 3
// Define TORSOR_SINGLE before the first generated header, alike in the whole program, for float in place of double, and
// TORSOR_LIBM for the library's sine and cosine, TORSOR_SMALL for one function of an angle that is called for each sine,
// where room counts more than time. The file is C99, and as C++ the same.
#include <math.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0)
#ifndef TORSOR_LIBM
#define TORSOR_LIBM  // sums would be reassociated or hold more digits than their type
#endif
#endif

#ifdef TORSOR_SINGLE
typedef float torsor_real;
#define TORSOR_NUMBER(in_double, in_float) (in_float)
#define TORSOR_FUNCTION(name) name##f
#else
typedef double torsor_real;
#define TORSOR_NUMBER(in_double, in_float) (in_double)
#define TORSOR_FUNCTION(name) name
#endif
// First in a function whose sums must stay as they are: options of clang that reassociate leave no macro but __FAST_MATH__.
#if defined(__clang__) && __clang_major__ >= 13
#define TORSOR_AS_WRITTEN _Pragma("clang fp reassociate(off)")
#else
#define TORSOR_AS_WRITTEN
#endif
#if defined(__GNUC__)
#define TORSOR_UNUSED __attribute__((unused))
#else
#define TORSOR_UNUSED
#endif
// What hardly any call needs stays out of the functions that may need it, and out of their registers.
#if defined(__GNUC__)
#define TORSOR_APART __attribute__((unused, noinline, cold)) static
#elif defined(_MSC_VER)
#define TORSOR_APART __declspec(noinline) static
#else
#define TORSOR_APART static
#endif
#if defined(TORSOR_SMALL) && defined(__GNUC__)
#define TORSOR_ONE_SINE __attribute__((unused, noinline)) static
#elif defined(TORSOR_SMALL) && defined(_MSC_VER)
#define TORSOR_ONE_SINE __declspec(noinline) static
#elif defined(TORSOR_SMALL)
#define TORSOR_ONE_SINE static
#else
#define TORSOR_ONE_SINE TORSOR_UNUSED static inline
#endif

/// What a kernel says about its results; the larger, the worse.
typedef enum { torsor_ok = 0, torsor_singular = 1, torsor_not_finite = 2 } torsor_status;

enum { torsor_order_max = 30 };  // of Taylor coefficients

/// A number of a mechanism: its name, and its unit as a person writes it.
typedef struct {
  const char* name;
  const char* unit;
} torsor_quantity;

/// Numbers that a kernel writes, column by column: a result, or a member of one that is a structure. No columns: as many
/// as are asked for, one for each order of a Taylor series.
typedef struct {
  const char* result;
  const char* member;  // empty: the whole result
  int rows, columns;
  int dimensions;    // 0: a number, 1: a vector, 2: a matrix
  const char* unit;  // of all entries but those that are always zero; where entries of a vector differ, of each:
                     // "m, rad", with 0 for those; empty where those of a matrix differ
} torsor_result;

typedef struct {
  const char* name;
  int reads_accelerations, reads_multipliers, reads_inputs;  // behind precomputed and state
  int has_status;                                            // returns a torsor_status
  const torsor_result* results;
  int result_count;
} torsor_kernel;
#elif TORSOR_C_SUPPORT != 3
#error "headers of incompatible versions of torsor meet here: write them again with one version"
#endif
