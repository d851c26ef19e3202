/* A study file that is being written: its parameters, plan, run and outputs, with undo.
 *
 * The state is the text of the file, so that other members (correlations, weights, a title) stay
 * unchanged; an edit is a step that can be undone. A draft need not be sound: qn_study_read() tests it.
 */
#pragma once

#include "study/plan/study.h"

typedef struct QnDraft QnDraft;

/* Kinds of values of a parameter that a form can show. */
typedef enum {
  QN_DRAFT_UNIFORM,   /* first: least, second: greatest */
  QN_DRAFT_NORMAL,    /* mean, deviation */
  QN_DRAFT_LOGNORMAL, /* mean, deviation */
  QN_DRAFT_RANGE,     /* least, greatest, at `levels` equally spaced values */
  QN_DRAFT_OTHER      /* as the file says */
} QnDraftKind;

typedef struct QnDraftParameter {
  const char *name, *path; /* the first path; both borrowed until the next edit */
  QnDraftKind kind;
  double first, second;
  int levels; /* 0: not given */
} QnDraftParameter;

/* The values that 5 % and 95 % of all do not exceed; of limits, these. NaN of kinds that a form does not
 * show. */
void qn_draft_get_fractiles (const QnDraftParameter *parameter, double *low,
                             double *high);

/* A new draft for the project file `model`, to be kept as `path`; nothing is written yet. */
QnDraft *qn_draft_new (const char *path, const char *model, QnStudyRun run);

/* Reads one that is there. Errors: QN_IO_ERROR. */
QnDraft *qn_draft_load (const char *path, GError **error);
void qn_draft_free (QnDraft *draft);

/* Writes the file where it has changed. Errors: QN_IO_ERROR. */
gboolean qn_draft_save (QnDraft *draft, GError **error);

/* The same at another place; `model` is the path of the project from there, or an absolute one. Drops the
 * undo history. */
gboolean qn_draft_save_as (QnDraft *draft, const char *path, const char *model,
                           GError **error);

const char *qn_draft_get_path (const QnDraft *draft);

gboolean qn_draft_can_undo (const QnDraft *draft);
gboolean qn_draft_can_redo (const QnDraft *draft);
void qn_draft_undo (QnDraft *draft);
void qn_draft_redo (QnDraft *draft);

/* ---- parameters ---- */

guint qn_draft_count (const QnDraft *draft);
QnDraftParameter qn_draft_parameter (const QnDraft *draft, guint index);

/* Adds the number at a path of the project, whose value is `base`: uniform, a tenth to either side, and
 * of a whole number at least 1. FALSE where it varies already. */
gboolean qn_draft_vary (QnDraft *draft, const char *path, double base, gboolean whole);

void qn_draft_remove (QnDraft *draft, guint index);
void qn_draft_set_name (QnDraft *draft, guint index, const char *name);
/* Another kind with the same mean and deviation, or, between limits and these, with the same
 * fractiles. */
void qn_draft_set_kind (QnDraft *draft, guint index, QnDraftKind kind);
void qn_draft_set_values (QnDraft *draft, guint index, QnDraftKind kind, double first,
                          double second, int levels);

/* ---- plan, run, outputs ---- */

QnPlanKind qn_draft_get_plan (const QnDraft *draft, int *count);
/* count: of plans that are not by levels. Distributions get levels where the plan needs them. */
void qn_draft_set_plan (QnDraft *draft, QnPlanKind kind, int count);

QnStudyRun qn_draft_get_run (const QnDraft *draft);
/* Outputs become those that are usual for the run. */
void qn_draft_set_run (QnDraft *draft, QnStudyRun run);

gboolean qn_draft_has_output (const QnDraft *draft, QnStudyOutput output);
void qn_draft_set_output (QnDraft *draft, QnStudyOutput output, gboolean wanted);
