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

/* Read by all, changed by the functions below alone. Model and contacts are borrowed until the next
 * "changed"; the model is prepared, and empty (no blocks) for an empty drawing. */
struct _QnDocument {
  GObject parent_instance;

  char *path;          /* NULL: never saved */
  char *folder;        /* that relative paths start from; NULL: nowhere */
  QnProject project;   /* the state; its digest: qn_document_get_project() */
  QnProjectText *text; /* what it is written as, without the history */
  QnContacts contacts;
  char *fingerprint; /* qn_document_get_fingerprint(); NULL: to be computed */
  char *file_digest; /* of the file as it was read or written; NULL: not known */
  QnEditHistory *history;
  /* By the last edit: free blocks of a parametric wall or another object that was moved, turned or cut in
   * part; its step says so in its name. */
  gboolean dissolved;
  QnSelection *selection;
  gboolean never_saved;   /* came from memory: counts as modified */
  gboolean keeps_history; /* in the file */

  QnJob *job;        /* NULL: none runs */
  char *job_text;    /* what the project was written as when it began; NULL: a live one */
  GError *job_error; /* why the last analysis gave no run, or NULL */
  QnDiag job_diag;
  GPtrArray *runs; /* of QnRun, of this session, oldest first */
  QnRun *run;      /* the current one, or NULL */
  guint run_number;
};

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

char *qn_document_dup_display_name (QnDocument *document);
gboolean qn_document_is_modified (QnDocument *document);

/* The project with its digest, as metadata and results name it. */
const QnProject *qn_document_get_project (QnDocument *document);

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

/* Replaces a top-level member that the model does not hold (view, figures, …), as an
 * undoable step; `json` is the new value or NULL to remove it. */
gboolean qn_document_edit_extra (QnDocument *document, const char *name, const char *key,
                                 const char *member, const char *json, GError **error);

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

/* What an analysis depends on: a digest of all of it, a space, and one of the model alone. */
const char *qn_document_get_fingerprint (QnDocument *document);

/* Ends the running analysis, if any, and forgets its outcome. */
void qn_document_drop_job (QnDocument *document);

/* ---- names of runs (run-name.c): the difference from the first run or the user's text, and the method ---- */

/* The member of the project that keeps names the user gave, by the digest of the model. */
#define QN_RUN_NAMES_MEMBER "run_names"

/* Renames a run, and all others of the same model, as a step; "" or NULL: as proposed. */
gboolean qn_document_rename_run (QnDocument *document, const QnRun *run,
                                 const char *label, GError **error);

/* Differences between the projects of two runs, translated, such as "friction 0.5"; NULL if the text of one
 * project is unknown. */
GPtrArray *qn_run_list_changes (const QnRun *from, const QnRun *to);

/* Proposes a name for a run that is to be added, whose name is its method so far, and drops those that it
 * repeats; `text` is what the project was written as. */
void qn_document_take_run (QnDocument *document, QnRun *run, const char *text);
/* Names of all runs from what the project keeps; TRUE where one is new. */
gboolean qn_document_name_runs (QnDocument *document);

/* ---- runs as result files (run-file.c): kept beside the project, and looked at again without solving ---- */

/* Writes a run of the document as `quoin-cli solve -o` would. Refuses one of an earlier model, for
 * the file must name the project that it belongs to, and those that are no load path or limit
 * analysis. */
gboolean qn_document_write_result (QnDocument *document, const QnRun *run,
                                   const char *path, GError **error);

/* What was set for the run alone, as for `--set`; NULL where that is nothing. Free with g_strfreev(). */
char **qn_run_dup_overrides (const QnRun *run, const QnAnalysisSettings *projects);

/* Whether the file says of itself, at its beginning, that it is a result. */
gboolean qn_is_result_file (const char *path);

/* Adds what a result file says to the runs and makes it the current one. It counts as outdated
 * where the project has changed since; refused where blocks or contacts are others. */
gboolean qn_document_open_result (QnDocument *document, const char *path, GError **error);
