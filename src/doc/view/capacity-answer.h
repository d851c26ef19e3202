/* Capacity curves for the window and the command line: the path that they come from, checks against a
 * spectrum, and the plot. docs/method/capacity.md has the formulas. */
#pragma once

#include "core/base/progress.h"
#include "core/capacity/capacity.h"
#include "core/contact/contacts.h"
#include "doc/text/units.h"
#include "io/project/project.h"
#include "render/figure/plot.h"

#include <gio/gio.h>

/* The checks of both codes, in the order of tables. */
typedef enum {
  QN_CAPACITY_SLV,
  QN_CAPACITY_SLC,
  QN_CAPACITY_SD,
  QN_CAPACITY_NC,
  QN_CAPACITY_STATE_COUNT
} QnCapacityCheck;

/* Sentence on the period of a check: its assumptions, or the reason of a refusal. Free with g_free(). */
char *qn_capacity_dup_basis (const QnCapacityState *state, QnCapacityCheck check);

typedef struct QnCapacityAnswer {
  gboolean kinematic;       /* whether the curve is to be that of a mechanism, */
  const QnResult *collapse; /* of this result, borrowed; NULL: of limit analysis */
  QnId control;             /* block that is to be controlled; QN_NONE: to be chosen */
  QnCapacity capacity;      /* owned, as is what follows, */
  char *block;              /* name of the controlled block */
  char
    *reason; /* why the path ended before multiplier 0, or there is no curve; else NULL */
  gboolean has_spectrum;
  QnSpectrum spectrum;  /* its points are borrowed */
  double confidence;    /* FC, >= 1 */
  double tie_strain;    /* at which ties break; 0: not known; */
  double part_period;   /* T0 of a part that vibrates freely, s; 0: it is rigid */
  QnLinearCheck linear; /* this and what follows with a spectrum; of a mechanism, */
  QnEnDemand en;        /* and of a path alone */
  QnCapacityState states[QN_CAPACITY_STATE_COUNT];
} QnCapacityAnswer;

/* How many checks it has, from SLV on: those of EN 1998-3 rest on the rise of a path, at the level of
 * the ground. */
int qn_capacity_answer_count_states (const QnCapacityAnswer *answer);

/* Them as a table: cells row by row, the head first; the ratio is "0.660 – not met", "1.250" or
 * "refused". */
#define QN_CAPACITY_COLUMNS 7
GPtrArray *qn_capacity_answer_make_table (const QnCapacityAnswer *answer, QnUnits units);

/* What was found, line by line: M*, e*, peak and end; of a mechanism alpha0 with its works beside the
 * collapse that was found, and the linear checks. Free with g_free(). */
char *qn_capacity_answer_dup_facts (const QnCapacityAnswer *answer, QnUnits units);

/* The curve of a mechanism where answer->kinematic says so, or the path in large displacements
 * until the multiplier is zero again, of the horizontal displacement of answer->control;
 * QN_NONE: that of the model's own displacement control, or else the one that moves
 * furthest in the mechanism of limit analysis. The model's settings of the analysis are
 * overwritten. Without a point and with a reason where a path ends since its budget is spent, its numbers
 * are not true, or nothing moves. With a spectrum it is followed a second time, with half the stiffness of
 * the joints. Refuses models with stages, and what core/capacity does. Fills what the answer owns. */
QnStatus qn_capacity_answer_find (QnCapacityAnswer *answer, QnModel *model,
                                  const QnContacts *contacts, QnProgressFunc report,
                                  void *report_data, QnDiag *diag);
void qn_capacity_answer_clear (QnCapacityAnswer *answer);

/* The same in a thread of its own, of a copy of the model, with `kinematic`, `control` and `tie_strain`
 * of what is asked. Ends with what an answer owns, which must be empty; FALSE with an error where there is
 * no curve, and with G_IO_ERROR_CANCELLED. */
void qn_capacity_find_async (const QnModel *model, const QnCapacityAnswer *asked,
                             GCancellable *cancellable, GAsyncReadyCallback callback,
                             gpointer user_data);
gboolean qn_capacity_find_finish (GAsyncResult *result, QnCapacityAnswer *answer,
                                  GError **error);

/* The checks, where there is a spectrum. */
void qn_capacity_answer_check (QnCapacityAnswer *answer);

/* The curve, and with a spectrum what it is held against; borrows nothing. */
QnPlot *qn_capacity_answer_plot (const QnCapacityAnswer *answer);

/* Curve and checks as JSON, keys as in the manual; free with g_free(). */
char *qn_capacity_answer_dup_json (const QnCapacityAnswer *answer,
                                   const QnProject *project, gsize *length);

/* Writes the curve as a picture, or as a table where the path ends in .csv. */
gboolean qn_capacity_answer_export (const QnCapacityAnswer *answer, const char *title,
                                    const QnMetadata *metadata, const char *path,
                                    GError **error);
gboolean qn_capacity_answer_write_csv (const QnCapacityAnswer *answer, const char *path,
                                       GError **error);
