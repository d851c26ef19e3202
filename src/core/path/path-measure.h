/* The measure that a step prescribes: the multiplier, or a linear combination of displacements (see
 * QnTarget), for one displacement its unit vector, for work the live load, for arc length the
 * direction of the path (Riks 1979, Crisfield 1981, linearised).
 */
#pragma once

#include "core/path/path.h"

typedef struct QnPathMeasure {
  QnPath *path; /* borrowed */
  QnProcedure procedure;
  int32_t unknown;   /* the controlled one, or QN_NONE */
  double start, end; /* controlled displacement, scaled: begin and target; NaN: none */
  double first;      /* first step */
  double
    slope; /* d multiplier / d measure at the begin of work or arc length; 0: unknown */
  double *direction;
  double *unit;   /* direction of the controlled displacement; zero: none */
  double *last_u; /* displacements before the last accepted step, or at setup */
} QnPathMeasure;

/* Chooses direction and first step at the committed state. `measure` is overwritten without
 * being cleared; its arrays are the trace's. False when memory runs out. */
bool qn_path_measure_setup (QnPathMeasure *measure, QnPath *path);

/* Prescribes the work of the live load instead of the multiplier; `first`: work of an increment of the
 * multiplier by the tangent of the committed state. False when memory runs out. */
bool qn_path_measure_take_work (QnPathMeasure *measure, double increment);

/* Call with a new equilibrium before it is accepted: copies the committed displacements to last_u. */
void qn_path_measure_keep_last (QnPathMeasure *measure);

/* Sets the direction of the arc to that of the accepted step. Do not call after a step in which friction may
 * have turned the path sharply: an arc that follows every corner returns on itself. */
void qn_path_measure_follow (QnPathMeasure *measure);

/* Remaining way to the controlled displacement over this step; INFINITY for other measures. */
double qn_path_measure_share_to_end (const QnPathMeasure *measure, double step);

/* Whether the controlled displacement has reached its target. */
bool qn_path_measure_is_at_end (const QnPathMeasure *measure);
