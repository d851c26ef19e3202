#include "cli/base/input.h"

#include "cli/base/message.h"
#include "doc/document/job.h"
#include "io/exchange/record.h"
#include "io/text/outcome-text.h"

#include <glib/gi18n.h>
#include <string.h>

QnExit
qn_input_refuse (const QnProject *project, const QnDiag *diag)
{
  GError *error = NULL;
  qn_project_set_error (project, diag, &error);
  return qn_cli_fail (error);
}

static QnExit
detect_contacts (QnInput *input)
{
  const QnModel *model = &input->project.model;
  QnDiag diag = { 0 };
  if (model->block_count == 0 && model->beam_count == 0)
    qn_diag_set_field (&diag, QN_PROBLEM_NO_BLOCKS, QN_ENTITY_MODEL, QN_NONE, "blocks",
                       0);
  else if (qn_contacts_detect (model, &input->contacts, &diag) == QN_OK)
    return QN_EXIT_DONE;
  return qn_input_refuse (&input->project, &diag);
}

/* A command that reads a project several times tells each warning once. */
static void
tell_warnings (const GPtrArray *warnings)
{
  static GHashTable *told;
  if (told == NULL)
    told = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  for (guint i = 0; i < warnings->len; i++)
    if (g_hash_table_add (told, g_strdup (g_ptr_array_index (warnings, i))))
      qn_cli_warning ("%s", (char *) g_ptr_array_index (warnings, i));
}

QnExit
qn_input_read (QnInput *input, const char *path, const QnInputOptions *options)
{
  GError *error = NULL;
  memset (input, 0, sizeof *input);
  if (!qn_project_load (path, (const char *const *) options->overrides, &input->project,
                        &error))
    return qn_cli_fail (error);
  input->project.model.analysis.workers = qn_threads_get ();

  QnExit code = detect_contacts (input);
  if (code != QN_EXIT_DONE)
    qn_input_clear (input);
  return code;
}

QnExit
qn_input_load (QnInput *input, const char *path, const QnInputOptions *options)
{
  QnExit code = qn_input_read (input, path, options);
  if (code == QN_EXIT_DONE)
    tell_warnings (input->project.warnings);
  return code;
}

static QnExit
read_records (QnInput *input, gboolean allow_outside)
{
  QnProject *project = &input->project;
  GError *error = NULL;
  if (project->model.analysis.procedure != QN_PROCEDURE_DYNAMIC)
    return QN_EXIT_DONE;
  if (!qn_project_read_records (project, NULL, allow_outside, &error))
    return qn_cli_fail (error);
  tell_warnings (project->warnings);
  return QN_EXIT_DONE;
}

QnExit
qn_input_require_sound (const QnInput *input)
{
  QnDiag diag = { 0 };
  if (qn_contacts_require_sound (&input->project.model, &input->contacts, &diag)
      == QN_OK) {
    g_autoptr (GPtrArray) texts =
      qn_project_dup_finding_texts (&input->project, &input->contacts.findings);
    tell_warnings (texts);
    return QN_EXIT_DONE;
  }
  return qn_input_refuse (&input->project, &diag);
}

/* A path without a live load has no answer, unless it is that of the dead load alone. Limit
 * analysis and stages refuse it themselves. */
static QnExit
require_live_load (const QnProject *project)
{
  const QnAnalysisSettings *analysis = &project->model.analysis;
  gboolean lacks = qn_model_lacks_live_load (&project->model);
  if (analysis->procedure == QN_PROCEDURE_DYNAMIC) {
    if (!lacks)
      qn_cli_warning ("%s: loads.live: %s", project->name,
                      _ ("has no effect in an analysis in time"));
    return QN_EXIT_DONE;
  }
  if (project->model.stage_count > 0 || analysis->procedure == QN_PROCEDURE_LIMIT
      || analysis->max_multiplier == 0 || !lacks)
    return QN_EXIT_DONE;
  qn_cli_error (_ ("%s: loads: %s: add one to loads.live, or set "
                   "analysis.max_multiplier=0 for the dead load alone"),
                project->name, _ (qn_problem_text (QN_PROBLEM_NO_LIVE_LOAD)));
  return QN_EXIT_INVALID;
}

QnExit
qn_input_prepare (QnInput *input, const QnInputOptions *options)
{
  QnExit code = read_records (input, options->allow_outside);
  if (code == QN_EXIT_DONE)
    code = qn_input_require_sound (input);
  return code == QN_EXIT_DONE ? require_live_load (&input->project) : code;
}

/* The sentence of a problem that lies in the state, translated; NULL for one of the input. */
static const char *
state_problem (QnInputState state, const QnDiag *diag)
{
  if (diag->problem == QN_PROBLEM_STATE_SLIPS && state == QN_INPUT_DEAD_LOAD)
    return _ ("pairs slip without dilatancy under the dead load: no symmetric stiffness");
  return qn_problem_is_of_state (diag->problem) ? _ (qn_problem_text (diag->problem))
                                                : NULL;
}

QnExit
qn_input_fail (const QnInput *input, QnInputState state, const QnDiag *diag)
{
  const char *problem =
    diag->status != QN_ERROR_NO_MEMORY ? state_problem (state, diag) : NULL;
  if (problem != NULL) {
    qn_cli_error ("%s: %s", input->project.name, problem);
    return QN_EXIT_NO_ANSWER;
  }
  return qn_input_refuse (&input->project, diag);
}

/* Both lists, one after the other; NULL where both are. The strings are borrowed. */
static char **
join_overrides (char **first, char **second)
{
  if (first == NULL && second == NULL)
    return NULL;
  GPtrArray *joined = g_ptr_array_new ();
  for (; first != NULL && *first != NULL; first++)
    g_ptr_array_add (joined, *first);
  for (; second != NULL && *second != NULL; second++)
    g_ptr_array_add (joined, *second);
  g_ptr_array_add (joined, NULL);
  return (char **) g_ptr_array_free (joined, FALSE);
}

QnExit
qn_input_load_with_result (QnInput *input, QnResultFile *file, const char *path,
                           const char *result_path, const QnInputOptions *options)
{
  GError *error = NULL;
  memset (input, 0, sizeof *input);
  if (!qn_result_file_read (result_path, file, &error))
    return qn_cli_fail (error);
  gboolean same_bytes = TRUE;
  QnExit code =
    qn_input_load_for_result (input, file, path, result_path, options, &same_bytes);
  if (code == QN_EXIT_DONE && !same_bytes)
    qn_cli_warning (_ ("%s has changed since %s was computed"), path, result_path);
  return code;
}

QnExit
qn_input_load_for_result (QnInput *input, QnResultFile *file, const char *path,
                          const char *result_path, const QnInputOptions *options,
                          gboolean *same_bytes)
{
  GError *error = NULL;
  g_autofree char **joined = join_overrides (file->overrides, options->overrides);
  QnExit code = qn_input_load (input, path, &(QnInputOptions){ .overrides = joined });
  if (code != QN_EXIT_DONE) {
    qn_result_file_clear (file);
    return code;
  }

  if (!qn_result_file_match (file, result_path, &input->project, &input->contacts,
                             same_bytes, &error)) {
    qn_input_clear (input);
    qn_result_file_clear (file);
    return qn_cli_fail (error);
  }
  return QN_EXIT_DONE;
}

void
qn_input_clear (QnInput *input)
{
  qn_contacts_clear (&input->contacts);
  qn_project_clear (&input->project);
}
