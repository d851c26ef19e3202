/* Capacity curves for the window and the command line: the path that they come from, checks against a
 * spectrum, and the plot. docs/method/capacity.md has the formulas. */
#ifndef QN_DOC_CAPACITY_ANSWER_H
#define QN_DOC_CAPACITY_ANSWER_H

#include "core/base/progress.h"
#include "core/capacity/capacity.h"
#include "core/contact/contacts.h"
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

/* "SLV" …; the code that it is of. */
const char *qn_capacity_check_name (QnCapacityCheck check);
const char *qn_capacity_check_code (QnCapacityCheck check);

/* "0.660 – not met", "1.250", "refused"; what the period of a check rests on, or why it is refused: a sentence.
 * Translated; free with g_free(). */
char *qn_capacity_dup_verdict (const QnCapacityState *state);
char *qn_capacity_dup_basis (const QnCapacityState *state, QnCapacityCheck check);

typedef struct QnCapacityAnswer {
  QnCapacity capacity; /* owned */
  gboolean has_spectrum;
  QnSpectrum spectrum; /* its points are borrowed */
  double confidence;   /* FC, >= 1 */
  QnEnDemand en;       /* this and what follows with a spectrum */
  QnCapacityState states[QN_CAPACITY_STATE_COUNT];
} QnCapacityAnswer;

/* How the search for the curve ended. */
typedef enum {
  QN_CAPACITY_FOUND,
  QN_CAPACITY_CANCELLED,
  QN_CAPACITY_REFUSED, /* what *diag says */
  QN_CAPACITY_STAGES,  /* the model has stages */
  QN_CAPACITY_NO_ANSWER
} QnCapacityEnd;

/* The path in large displacements until the multiplier is zero again, as a capacity curve. `control`:
 * the block whose horizontal displacement is controlled; QN_NONE: that of the model's own displacement
 * control, or else the one that moves furthest in the mechanism of limit analysis. The model's settings
 * of the analysis are overwritten. A path that ends since its budget is spent, or whose numbers are not
 * true, is NO_ANSWER. With a spectrum it is followed a second time, with half the stiffness of the joints.
 * Fills answer->capacity alone; qn_capacity_clear() frees it. *reason, which the
 * caller frees: why there is no curve (STAGES, NO_ANSWER), or why its path ended before multiplier 0;
 * else NULL. */
QnCapacityEnd qn_capacity_answer_find (QnCapacityAnswer *answer, QnModel *model,
                                       const QnContacts *contacts, QnId control,
                                       QnProgressFunc report, void *report_data,
                                       char **reason, QnDiag *diag);

/* The same in a thread of its own, of a copy of the model. Ends with QnCapacity, which the caller frees
 * with qn_capacity_clear() and g_free(); NULL with an error where there is no curve, and with
 * G_IO_ERROR_CANCELLED. The caller frees *control, the name of the block that was controlled, and
 * *reason, why the path ended before multiplier 0, or NULL. */
void qn_capacity_find_async (const QnModel *model, QnId control,
                             GCancellable *cancellable, GAsyncReadyCallback callback,
                             gpointer user_data);
QnCapacity *qn_capacity_find_finish (GAsyncResult *result, char **control, char **reason,
                                     GError **error);

/* The checks, where there is a spectrum. */
void qn_capacity_answer_check (QnCapacityAnswer *answer);

/* The curve, and with a spectrum what it is held against; borrows nothing. */
QnPlot *qn_capacity_answer_plot (const QnCapacityAnswer *answer);

/* Curve and checks as JSON, keys as in the manual; free with g_free(). */
char *qn_capacity_answer_dup_json (const QnCapacityAnswer *answer,
                                   const QnProject *project, gsize *length);

/* Writes the curve as a table. */
gboolean qn_capacity_answer_write_csv (const QnCapacityAnswer *answer, const char *path,
                                       GError **error);

#endif
