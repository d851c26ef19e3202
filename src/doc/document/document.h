/* A document: one project with its history, its selection and its analyses.
 *
 * The state of a document is its project with the prepared model, and the model may be empty. Every
 * edit works on a copy, which is then prepared like a project that was read: an edit that would make
 * an invalid project is refused with the reason and leaves everything as it was. The project is
 * written as text after every edit; the history keeps the differences of these texts, so that undo
 * needs no code per command.
 *
 * Signals, all without arguments:
 *   "changed"       the model is another one: edited, undone, loaded
 *   "history-changed" steps, their position or whether there are unsaved changes
 *   "file-changed"  the path
 *   "runs-changed"  the list of runs, or which of them is current
 *   "job-changed"   an analysis started or ended
 *   "job-progress"  the running analysis has something to report
 */
#pragma once

#include "doc/document/history.h"
#include "doc/document/job.h"
#include "doc/document/run.h"
#include "doc/document/selection.h"
#include "io/project/project.h"
#include <gio/gio.h>

#define QN_TYPE_DOCUMENT (qn_document_get_type ())
G_DECLARE_FINAL_TYPE (QnDocument, qn_document, QN, DOCUMENT, GObject)

/* An empty drawing: no blocks, one dry joint law, own weight as dead load, own weight to the
 * right as live load. */
QnDocument *qn_document_new (void);

/* ---- the file ---- */

/* Replaces everything by the content of a project file. On failure nothing changes. */
gboolean qn_document_load (QnDocument *document, const char *path, GError **error);

/* The same for a file that stays as it is, an example: the document gets no path and counts as
 * saved, so that nothing is asked before it is edited. Relative paths start from the file's folder
 * until it is saved elsewhere. */
gboolean qn_document_load_copy (QnDocument *document, const char *path, GError **error);

/* Recovers unsaved changes of the file `path` (NULL: never saved). They remain unsaved: the file does not
 * change until the user saves. */
gboolean qn_document_load_recovered (QnDocument *document, const char *text,
                                     const char *path, GError **error);

/* Writes the project and remembers the path. */
gboolean qn_document_save (QnDocument *document, const char *path, GError **error);

/* Whether the file has changed since it was read or written here: saving would undo that. One that
 * has gone or cannot be read has not. */
gboolean qn_document_is_changed_elsewhere (QnDocument *document);

/* Whether the file holds the history too, so that steps can be undone after opening it again.
 * Loading a file that has one turns it on. */
void qn_document_set_keeps_history (QnDocument *document, gboolean keeps);
gboolean qn_document_get_keeps_history (QnDocument *document);

const char *qn_document_get_path (QnDocument *document); /* NULL: never saved */
/* Folder that relative paths start from, or NULL for a document that came from no file. */
const char *qn_document_get_folder (QnDocument *document);
/* The project as it would be written, without the history. */
const char *qn_document_get_text (QnDocument *document);
char *qn_document_dup_display_name (QnDocument *document);
gboolean qn_document_is_modified (QnDocument *document);

/* ---- the model ---- */

/* Prepared; empty (no blocks) for an empty drawing. Borrowed until the next "changed". */
const QnModel *qn_document_get_model (QnDocument *document);
/* Faces, pairs and findings of the model; empty for an empty drawing. Borrowed likewise. */
const QnContacts *qn_document_get_contacts (QnDocument *document);
const QnProject *qn_document_get_project (QnDocument *document);
QnSelection *qn_document_get_selection (QnDocument *document);

/* ---- edits ---- */

/* An edit begins with a copy of the project, for the caller to change. FALSE with an error where there is no
 * memory for it. */
gboolean qn_document_begin_edit (QnDocument *document, QnProject *draft, GError **error);

/* Ends an edit: takes over the draft, which becomes the project as one step of the history (see
 * qn_document_edit()). FALSE with an error if the draft breaks a rule, or `done` is FALSE with an error set. */
gboolean qn_document_end_edit (QnDocument *document, QnProject *draft, const char *name,
                               const char *key, gboolean done, GError **error);

/* The same by a function that changes the draft, whose model and extras may be replaced. Blocks may be
 * appended behind the wall blocks; for removals and changes of walls see edit.h and edit-masonry.h. False
 * with an error refuses the edit. */
typedef gboolean (*QnEditFunc) (QnProject *draft, gpointer user_data, GError **error);

/* Makes one step of the history; an edit that changes nothing makes none. `name` and `key`
 * are those of qn_history_record(); a gesture ends when the selection changes. */
gboolean qn_document_edit (QnDocument *document, const char *name, const char *key,
                           QnEditFunc func, gpointer user_data, GError **error);

/* Compares the edit `other`, with the number `value`, with the edit `same`, with the present value. Returns the
 * path in the file of the only number that differs (*number: its text there, NaN: not written); NULL if an
 * edit is refused or anything else differs. Does not change the document. The caller frees it. */
char *qn_document_dup_number_path (QnDocument *document, QnEditFunc func, gpointer same,
                                   gpointer other, double value, double *number);

/* Whether the last edit has made free blocks of a parametric wall or another object that was moved,
 * turned or cut in part. Its step says so in its name. */
gboolean qn_document_has_dissolved (QnDocument *document);

/* Replaces a top-level member that the model does not hold (view, figures, …), as an
 * undoable step; `json` is the new value or NULL to remove it. */
gboolean qn_document_edit_extra (QnDocument *document, const char *name, const char *key,
                                 const char *member, const char *json, GError **error);

QnEditHistory *qn_document_get_history (QnDocument *document); /* for reading */
gboolean qn_document_undo (QnDocument *document);
gboolean qn_document_redo (QnDocument *document);
/* Walks to the state after `position` steps; FALSE where there are not so many. */
gboolean qn_document_go_to (QnDocument *document, guint position);

/* ---- analyses ---- */

/* Starts an analysis of the model as it is, with its own settings; one that runs already is
 * cancelled and its outcome dropped. */
gboolean qn_document_analyse (QnDocument *document, GError **error);

/* The same by another procedure, whatever the settings say. */
gboolean qn_document_analyse_with (QnDocument *document, QnProcedure procedure,
                                   QnFlow flow, GError **error);

/* Frequencies and modes of small vibrations about the equilibrium under dead load, or about the
 * last one of the analysis: a run for each of the lowest `count` modes. */
gboolean qn_document_find_modes (QnDocument *document, guint count, gboolean loaded,
                                 GError **error);

/* The load under which the structure loses its stability, in nonlinear geometry whatever the
 * settings say. */
gboolean qn_document_find_stability (QnDocument *document, GError **error);

/* The same as qn_document_analyse() after an edit, without being asked: its run replaces the
 * previous one of this kind. Limit analysis is that with the joints' own dilatancy. */
gboolean qn_document_analyse_live (QnDocument *document, GError **error);

void qn_document_cancel (QnDocument *document);
QnJob *qn_document_get_job (QnDocument *document); /* NULL when none runs */

/* Why the last analysis gave no run, or NULL. */
const GError *qn_document_get_job_error (QnDocument *document);
const QnDiag *qn_document_get_job_diag (QnDocument *document);

/* Runs of this session, oldest first; of QnRun. */
const GPtrArray *qn_document_get_runs (QnDocument *document);
QnRun *qn_document_get_run (QnDocument *document); /* the current one, or NULL */
void qn_document_set_run (QnDocument *document, QnRun *run);
/* Adds a run that was made elsewhere, and makes it the current one. */
void qn_document_add_run (QnDocument *document, QnRun *run);
void qn_document_remove_run (QnDocument *document, QnRun *run);

/* The latest run of the model as it is by that method, which was not made after an edit unless `live`, or
 * NULL. */
QnRun *qn_document_find_run (QnDocument *document, QnProcedure procedure, QnFlow flow,
                             gboolean live);

/* Changes since a run; titles, views and figures do not count. */
typedef enum {
  QN_RUN_CURRENT,
  QN_RUN_OTHER_SETTINGS, /* of the analysis alone: blocks, laws, loads are the same */
  QN_RUN_OTHER_MODEL,
  QN_RUN_OF_STUDY /* a case, whatever has changed */
} QnRunAge;

QnRunAge qn_document_get_run_age (QnDocument *document, const QnRun *run);

/* The angular frequencies, rad/s, ascending, of the modes about the dead load that were found last, while
 * blocks, laws and loads are as they were; NULL: there are none. Free with g_free(). */
double *qn_document_dup_omegas (QnDocument *document, gsize *count);

/* A sentence about it; empty for a current run. Static. */
const char *qn_run_age_text (QnRunAge age);

/* Whether it is not current. */
gboolean qn_document_is_stale (QnDocument *document, const QnRun *run);
