/* Largest and smallest numbers, their order, and the range that given ones must keep. */
#pragma once

#include "core/base/problem.h"

#include <math.h>
#include <stddef.h>

/* The smaller and the larger of two numbers, the second if the first is NaN; fmin and fmax would be
 * calls. */
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

/* The larger of two, NaN if either is NaN: a bound on an error that NaN does not pass. */
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

/* Range of input numbers other than 0: stiffnesses, moments and energies, which are products of several of
 * them, then have finite squares and quotients in double precision. */
#define QN_LARGEST_NUMBER 1e30
#define QN_LEAST_NUMBER   1e-30

typedef enum { QN_RANGE_FINITE, QN_RANGE_NOT_NEGATIVE, QN_RANGE_POSITIVE } QnRange;

/* Problem of a number outside its range or larger than `largest`; QN_PROBLEM_NONE: none. */
static inline QnProblem
qn_number_problem (double value, QnRange range, double largest)
{
  return !isfinite (value)                                       ? QN_PROBLEM_NOT_FINITE
         : range == QN_RANGE_POSITIVE && value <= 0              ? QN_PROBLEM_NOT_POSITIVE
         : range == QN_RANGE_NOT_NEGATIVE && value < 0           ? QN_PROBLEM_NEGATIVE
         : fabs (value) > largest                                ? QN_PROBLEM_TOO_LARGE
         : range == QN_RANGE_POSITIVE && value < QN_LEAST_NUMBER ? QN_PROBLEM_TOO_SMALL
                                                                 : QN_PROBLEM_NONE;
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

/* Sum of a[i] b[i]. */
static inline double
qn_dot (const double *a, const double *b, size_t count)
{
  double sum = 0;

  for (size_t i = 0; i < count; i++)
    sum += a[i] * b[i];
  return sum;
}
