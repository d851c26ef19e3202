/* Largest and smallest numbers, their order. */
#ifndef QN_CORE_NUMBERS_H
#define QN_CORE_NUMBERS_H

#include <math.h>
#include <stddef.h>

/* The smaller and the larger of two finite numbers; fmin and fmax would be calls, for the sake of
 * NaN. */
static inline double
qn_min (double a, double b)
{
  return a < b ? a : b;
}

static inline double
qn_max (double a, double b)
{
  return a > b ? a : b;
}

/* The larger of two, NaN where one of them is: of what must be small, nothing that is no number passes. */
static inline double
qn_worse (double a, double b)
{
  return isnan (a) || b <= a ? a : b;
}

/* For qsort() and g_array_sort() of numbers, ascending. */
static inline int
qn_compare_doubles (const void *a, const void *b)
{
  double x = *(const double *) a, y = *(const double *) b;

  return (x > y) - (x < y);
}

/* Largest absolute value; those that are NaN do not count. */
static inline double
qn_largest (const double *values, size_t count)
{
  double largest = 0;

  for (size_t i = 0; i < count; i++)
    largest = fmax (largest, fabs (values[i]));
  return largest;
}

#endif
