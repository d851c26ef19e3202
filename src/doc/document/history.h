/* History: unlimited named undo and redo over the text of a project.
 *
 * The state of a document is the text of its project file. A step is the difference between
 * two such texts: the runs of lines that it took away and put in their place. So every
 * command can be undone without code of its own, a step costs only what it changed, and the
 * whole history can be stored as text.
 */
#pragma once

#include <glib.h>

/* Read by all, changed by the functions below and where the present state becomes the clean one. */
typedef struct QnEditHistory {
  GPtrArray *steps; /* those done first, then those undone, oldest first */
  guint position;   /* steps done: there is one to undo where it is above 0 */
  gint64 clean;     /* position of the clean state; -1: it cannot be reached any more */
  gboolean broken;  /* the next step is separate from the last */
} QnEditHistory;

/* Without steps, in a clean state. */
QnEditHistory *qn_history_new (void);
void qn_history_free (QnEditHistory *history);

/* Appends a step from one text to the next; steps that had been undone are forgotten.
 *
 * name: what the user reads after "Undo", copied.
 * key: NULL, or a word for the gesture that makes the step: consecutive steps of the same key
 *      are one (arrow keys that nudge a block, a value being dragged). */
void qn_history_record (QnEditHistory *history, const char *name, const char *key,
                        const char *before, const char *after);

/* Ends the gesture: the next step is separate even if it has the same key. */
void qn_history_break (QnEditHistory *history);

/* Walks to the state after so many steps: its text, where `text` is the present one. NULL where there are
 * not so many. The caller frees it. */
char *qn_history_go_to (QnEditHistory *history, const char *text, guint position);

const char *qn_history_get_name (const QnEditHistory *history, guint step);

/* ---- in a file ---- */

/* The history as a JSON object, to be kept beside `text`, the present state. The caller frees
 * it. */
char *qn_history_to_json (const QnEditHistory *history, const char *text);

/* The history that was kept beside `text`, or NULL where it belongs to another text: every step
 * has been tried. The present state counts as clean. */
QnEditHistory *qn_history_from_json (const char *json, const char *text);
