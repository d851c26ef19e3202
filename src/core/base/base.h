/* Quoin core: words that every other core header builds on.
 *
 * The core is plain C11 with libm and SuiteSparse: no GLib, no input or output, no threads,
 * no global state. All quantities are SI (m, N, kg, s, rad) unless a comment says otherwise.
 */
#pragma once

#include <assert.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Entities refer to each other by their index in the model's arrays, never by pointers that
 * a reallocation could invalidate. */
typedef int32_t QnId;

/* "No such entity" for a QnId. */
#define QN_NONE ((QnId) -1)

/* Programmer errors, never bad input. */
#define QN_ASSERT(expr) assert (expr)

#define QN_N_ELEMENTS(a) (sizeof (a) / sizeof ((a)[0]))

#define QN_PI 3.14159265358979323846

/* m/s2: what "g" means as a unit, whatever the gravity of a project. */
#define QN_STANDARD_GRAVITY 9.80665

/* Unrolls the next loop, of a fixed, small number of iterations, so
 * that its data stay in registers. */
#if defined __clang__
#define QN_UNROLL _Pragma ("unroll")
#elif defined __GNUC__
#define QN_UNROLL _Pragma ("GCC unroll 16")
#else
#define QN_UNROLL
#endif

/* Degrees of freedom of a block, in the order in which they are stored everywhere. */
typedef enum {
  QN_DOF_UX, /* displacement of the centroid along x, m */
  QN_DOF_UY, /* displacement of the centroid along y, m */
  QN_DOF_RZ, /* rotation about the centroid, rad, counter-clockwise positive */
  QN_DOF_COUNT
} QnDof;
