#include "cli/base/input.h"

#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "core/path/analysis.h"
#include "doc/document/job.h"
#include "io/exchange/record.h"
#include "io/text/outcome-text.h"

#include <glib/gi18n.h>
#include <string.h>

char **qn_overrides;
gboolean qn_allow_outside, qn_no_timings;

/* Both lists, one after the other, for the rest of the program; NULL where both are. */
static char **
join (char **first, char **second)
{
  g_autoptr (GStrvBuilder) builder = g_strv_builder_new ();
  if (first == NULL && second == NULL)
    return NULL;
  if (first != NULL)
    g_strv_builder_addv (builder, (const char **) first);
  if (second != NULL)
    g_strv_builder_addv (builder, (const char **) second);
  return qn_cli_keep (g_strv_builder_end (builder));
}

void
qn_input_override (const char *override, gboolean before)
{
  char *one[] = { (char *) override, NULL };
  qn_overrides = before ? join (one, qn_overrides) : join (qn_overrides, one);
}

void
qn_input_refuse (const QnProject *project, const QnDiag *diag)
{
  qn_project_set_error (project, diag, QN_TROUBLE);
  qn_cli_must (FALSE);
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

QnInput *
qn_input_read (const char *path)
{
  QnInput *input = qn_cli_keep (g_new0 (QnInput, 1));
  QnModel *model = &input->project.model;
  QnDiag diag = { 0 };

  qn_cli_must (qn_project_load (path, (const char *const *) qn_overrides, &input->project,
                                QN_TROUBLE));
  model->analysis.workers = qn_threads_get ();
  if (model->block_count == 0 && model->beam_count == 0)
    qn_diag_set_field (&diag, QN_PROBLEM_NO_BLOCKS, QN_ENTITY_MODEL, QN_NONE, "blocks",
                       0);
  else if (qn_contacts_detect (model, &input->contacts, &diag) == QN_OK)
    return input;
  qn_input_refuse (&input->project, &diag);
  return input;
}

QnInput *
qn_input_load (const char *path)
{
  QnInput *input = qn_input_read (path);
  tell_warnings (input->project.warnings);
  return input;
}

void
qn_input_require_sound (const QnInput *input)
{
  QnDiag diag = { 0 };
  if (qn_contacts_require_sound (&input->project.model, &input->contacts, &diag) != QN_OK)
    qn_input_refuse (&input->project, &diag);
  g_autoptr (GPtrArray) texts =
    qn_project_dup_finding_texts (&input->project, &input->contacts.findings);
  tell_warnings (texts);
}

void
qn_input_prepare (QnInput *input)
{
  QnProject *project = &input->project;
  const QnAnalysisSettings *analysis = &project->model.analysis;
  if (analysis->procedure == QN_PROCEDURE_DYNAMIC) {
    qn_cli_must (qn_project_read_records (project, NULL, qn_allow_outside, QN_TROUBLE));
    tell_warnings (project->warnings);
  }
  qn_input_require_sound (input);
  gboolean lacks = qn_model_lacks_live_load (&project->model);
  if (analysis->procedure == QN_PROCEDURE_DYNAMIC) {
    if (!lacks)
      qn_cli_warning ("%s: loads.live: %s", project->name,
                      _ ("has no effect in an analysis in time"));
    return;
  }
  /* A path without a live load has no answer, unless it is that of the dead load alone. Limit
   * analysis and stages refuse it themselves. */
  if (lacks && analysis->max_multiplier != 0 && project->model.stage_count == 0
      && analysis->procedure != QN_PROCEDURE_LIMIT)
    qn_cli_fail (QN_EXIT_INVALID,
                 _ ("%s: loads: %s: add one to loads.live, or set "
                    "analysis.max_multiplier=0 for the dead load alone"),
                 project->name, _ (qn_problem_text (QN_PROBLEM_NO_LIVE_LOAD)));
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

void
qn_input_fail (const QnInput *input, QnInputState state, const QnDiag *diag)
{
  const char *problem =
    diag->status != QN_ERROR_NO_MEMORY ? state_problem (state, diag) : NULL;
  if (problem == NULL)
    qn_input_refuse (&input->project, diag);
  qn_cli_fail (QN_EXIT_NO_ANSWER, "%s: %s", input->project.name, problem);
}

QnInput *
qn_input_load_with_result (const char *path, const char *result_path)
{
  QnResultFile file;
  gboolean same_bytes = TRUE;
  if (result_path == NULL)
    return qn_input_load (path);
  qn_cli_must (qn_result_file_read (result_path, &file, QN_TROUBLE));
  QnInput *input = qn_input_load_for_result (&file, path, result_path, &same_bytes);
  if (!same_bytes)
    qn_cli_warning (_ ("%s has changed since %s was computed"), path, result_path);
  return input;
}

QnInput *
qn_input_load_for_result (const QnResultFile *file, const char *path,
                          const char *result_path, gboolean *same_bytes)
{
  char **own = qn_overrides;
  qn_overrides = join (file->overrides, own);
  QnInput *input = qn_input_load (path);
  qn_overrides = own;
  input->file = *file;
  qn_cli_must (qn_result_file_match (&input->file, result_path, &input->project,
                                     &input->contacts, same_bytes, QN_TROUBLE));
  return input;
}

void
qn_input_solve (QnInput *input)
{
  QnDiag diag = { 0 };
  const QnProject *project = &input->project;
  QnResult *result = &input->file.result;

  qn_input_prepare (input);
  qn_terminal_progress_begin ();
  QnStatus status = qn_analysis_run (&project->model, &input->contacts,
                                     qn_terminal_progress_update, NULL, result, &diag);
  qn_terminal_progress_done ();
  if (qn_interrupt_seen ())
    qn_cli_cancelled (project->name);
  if (status != QN_OK)
    qn_input_refuse (project, &diag);
  if (result->outcome == QN_OUTCOME_NOT_CONVERGED
      || result->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE) {
    g_autofree char *cause = qn_outcome_dup_cause (&project->model, result);
    qn_cli_warning ("%s: %s", project->name, cause);
  }
}

QnInput *
qn_input_load_or_solve (const char *path, const char *result)
{
  QnInput *input = qn_input_load_with_result (path, result);
  if (result == NULL)
    qn_input_solve (input);
  return input;
}

QnSheetRun *
qn_input_load_runs (char **arguments, gsize count)
{
  QnSheetRun *runs = qn_cli_keep (g_new0 (QnSheetRun, count));
  for (gsize i = 0; i < count; i++) {
    const char *argument = arguments[i], *equals = strrchr (argument, '=');
    const char *name = equals != NULL ? equals + 1 : argument;
    const char *slash = strrchr (name, G_DIR_SEPARATOR);
    if (g_file_test (argument, G_FILE_TEST_EXISTS))
      equals = NULL;
    g_autofree char *model = equals != NULL
                               ? g_strndup (argument, (gsize) (equals - argument))
                               : g_strdup (argument);
    const QnInput *input =
      qn_input_load_or_solve (model, equals != NULL ? equals + 1 : NULL);
    runs[i] = (QnSheetRun){ .project = &input->project,
                            .contacts = &input->contacts,
                            .result = &input->file.result,
                            .name = slash != NULL ? slash + 1 : name };
  }
  return runs;
}
