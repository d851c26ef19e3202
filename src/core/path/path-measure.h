/* The measure that a step prescribes: the multiplier, or a linear combination of displacements (see
 * QnTarget), for one displacement its unit vector, for work the live load, for arc length the
 * direction of the path (Riks 1979, Crisfield 1981, linearised).
 */
#pragma once

#include "core/path/path.h"

typedef struct QnPathMeasure {
  QnPath *path; /* borrowed */
  QnProcedure procedure;
  int32_t unknown; /* the controlled one, or QN_NONE */
  double start,
    end;        /* of the controlled displacement, scaled: where its way begins (0, or
                        where a stage begins) and should end; NaN without one */
  double first; /* the first step, */
  double slope; /* and of the multiplier where work or arc length begins; 0: unknown */
  double *direction;
  double *unit;   /* direction of the controlled displacement; zero without one */
  double *last_u; /* displacements before the last accepted step, or at setup */
} QnPathMeasure;

/* Chooses direction and first step at the committed state. `measure` is overwritten without
 * being cleared; its arrays are the trace's. False when memory runs out. */
bool qn_path_measure_setup (QnPathMeasure *measure, QnPath *path);

/* From now on the work of the live load is prescribed instead of the multiplier: `first` is what belongs to
 * an increment of the multiplier by the tangent of the committed state. False when memory runs out. */
bool qn_path_measure_take_work (QnPathMeasure *measure, double increment);

/* To be called with a new equilibrium just before it is accepted: remembers the one that it
 * starts from. */
void qn_path_measure_keep_last (QnPathMeasure *measure);

/* Turns the arc into the direction of the step just accepted, along which the path goes on. Not
 * to be called after a step in which friction may have led the structure round a corner: an arc
 * that follows every corner, like one along the tangent, ends where it came from. */
void qn_path_measure_follow (QnPathMeasure *measure);

/* What is left of the way to the controlled displacement, as a share of this step; infinite
 * where another measure is prescribed. */
double qn_path_measure_share_to_end (const QnPathMeasure *measure, double step);

/* Whether the controlled displacement has come to its end. */
bool qn_path_measure_is_at_end (const QnPathMeasure *measure);
