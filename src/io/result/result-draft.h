/* Private to the reading of results: the members of a file before they are compared with each
 * other, and how they become a result. */
#ifndef QN_IO_RESULT_DRAFT_H
#define QN_IO_RESULT_DRAFT_H

#include "io/json/json-stream.h"
#include "io/result/result-file.h"
#include "io/result/result-forces.h"
#include "io/result/result-history.h"

/* QnResultRows of three numbers, one for each block. */
typedef struct QnResultRows {
  double *items;
  size_t count, capacity; /* numbers, not rows */
} QnResultRows;

typedef struct QnResultNames {
  GPtrArray *items;
} QnResultNames;

typedef struct QnResultIds {
  QnId *items;
  size_t count, capacity;
} QnResultIds;

/* A number that may be null, or missing. */
typedef struct QnOptionalNumber {
  bool given;
  double number;
} QnOptionalNumber;

/* What is read before it is known to fit together. */
typedef struct QnResultDraft {
  QnResultFile file;
  QnResultNames blocks, overrides, nodes, tie_names;
  QnOptionalNumber collapse, first_limit, associative_bound, broken_bound, beyond_linear,
    unproved;
  QnResultIds unstable, supports;
  QnStep step; /* that is being read */
  QnResultRows displacements, mechanism, reactions, velocities;
  QnStepForces forces;
  QnHistoryDraft history;
  QnResultRows node_displacements, node_mechanism;
  QnBeamForces *beam_forces;
  size_t beam_force_count, beam_force_capacity, element_count;
  QnTieResult *ties;
  size_t tie_count, tie_capacity;
  gboolean has_mechanism;
  double fixed_points[QN_RESULT_SOLUTIONS];
  gint32 fixed_point_count;
  double interval[2];   /* `collapse_interval`, NAN: null */
  int interval_ends;    /* that were read: 2, or 0 where there is none */
  size_t rows_per_step; /* numbers; of the first step */
  size_t step_capacity, contact_capacity, pair_capacity;
} QnResultDraft;

/* Checks that everything that counts the same counts alike, and hands the arrays over to the file.
 * FALSE with the stream's error. */
gboolean qn_result_draft_take (QnResultDraft *draft, QnJsonStream *stream);

void qn_result_draft_clear (QnResultDraft *draft);

#endif
