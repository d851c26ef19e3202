/* A background analysis: a frozen copy of the model, solved in a thread of its own.
 *
 * The job copies what it needs when it is made, so the document may be edited meanwhile. Its
 * progress is reported on the main context of the thread that started it, at most twenty
 * times a second. All functions are for that thread.
 */
#pragma once

#include "core/base/progress.h"
#include "core/base/workers.h"
#include "doc/document/run.h"

#include <gio/gio.h>

#define QN_TYPE_JOB (qn_job_get_type ())
G_DECLARE_FINAL_TYPE (QnJob, qn_job, QN, JOB, GObject)

/* Freezes a prepared model. NULL when memory runs out.
 *
 * name: of the run to be; fingerprint: of the document's model, handed on to the run. */
QnJob *qn_job_new (const QnModel *model, const char *name, const char *fingerprint,
                   GError **error);

/* Starts the thread. `callback` is called once, on the starting thread's main context, when
 * the analysis has ended in whatever way. A job is started only once. */
void qn_job_start (QnJob *job, GAsyncReadyCallback callback, gpointer user_data);

/* The run, of modes one for each, or NULL with an error when the model cannot be analysed. A cancelled
 * analysis that has converged steps is a run whose outcome says so; one without is
 * G_IO_ERROR_CANCELLED. `diag` tells the place of what is wrong. Of QnRun; free with g_ptr_array_unref(). */
GPtrArray *qn_job_finish (QnJob *job, GAsyncResult *result, QnDiag *diag, GError **error);

/* Asks the analysis to end soon; what has converged is kept. */
void qn_job_cancel (QnJob *job);

/* Holds the analysis at its next iteration, or lets it go on. */
void qn_job_set_paused (QnJob *job, gboolean paused);
gboolean qn_job_is_paused (QnJob *job);

/* The state behind the last signal "progress" (no arguments). */
QnProgress qn_job_get_progress (QnJob *job);

/* Points of the live curve: x number of a converged step, y multiplier; in time: x time, s, y displacement
 * of qn_job_get_followed(). The job owns the array, valid until control returns to the main loop. */
const QnVec2 *qn_job_get_curve (QnJob *job, gsize *count);

/* The run to be, with the analysed model. Before the start its kind may be set, for modes with `mode_count`
 * and `loaded`, and `live`. */
QnRun *qn_job_get_run (QnJob *job);

/* Of an analysis in time: the block whose displacement the live curve shows. Returns when it ends at
 * the latest, s; 0 for other analyses. */
double qn_job_get_followed (QnJob *job, QnId *block, QnDof *dof);

/* Estimated remaining seconds of an analysis in time at its mean speed without pauses; < 0: unknown. */
double qn_job_get_remaining (QnJob *job);

/* For other work in threads, as a QnProgressFunc: until `cancellable` is cancelled. */
bool qn_job_may_go_on (const QnProgress *progress, void *cancellable);

/* As many threads as there are processors, the caller's among them: started when they are first needed,
 * kept until the process ends. They work for one caller at a time: the threads of others, and that of a caller
 * where none can be started, do everything themselves. May be called from any thread. */
const QnWorkers *qn_threads_get (void);
