#include "core/limit/limit-sensitivity.h"
#include "core/modal/modal.h"
#include "core/path/analysis.h"
#include "core/path/stability.h"
#include "doc/view/capacity-settings.h"
#include "doc/view/sheet.h"
#include "io/project/project-members.h"
#include "io/result/result-file.h"
#include "io/text/fault-text.h"
#include "io/text/file-writer.h"
#include "io/text/mechanism-text.h"
#include "io/text/outcome-text.h"
#include "library/library-private.h"

#include <math.h>

struct QuoinModes {
  QnModes modes;
};

/* --- Running ----------------------------------------------------------------------------- */

/* That of the callback which runs in this thread. */
static _Thread_local const QuoinCaller *calling;

double
quoin_progress_get_done (void)
{
  return calling != NULL ? calling->done : (double) NAN;
}

const char *
quoin_progress_get_what (void)
{
  return calling != NULL ? calling->what : NULL;
}

bool
quoin_library_tell (QuoinCaller *caller, double done, int32_t iterations)
{
  const QuoinCaller *outer = calling;
  if (caller->func == NULL)
    return true;
  caller->done = fmax (caller->done, done);
  calling = caller;
  bool goes_on = caller->func (caller->reached, caller->steps, iterations, caller->data);
  calling = outer;
  caller->cancelled = caller->cancelled || !goes_on;
  return goes_on;
}

/* The end of an analysis in time is known; of others the share grows with every call, ever more slowly.
 * The bound of a path leaves the multiplier that the path has reached. */
static bool
report (const QnProgress *progress, void *data)
{
  enum { HALF_WAY = 100 };
  QuoinCaller *caller = data;
  bool in_time = caller->model->analysis.procedure == QN_PROCEDURE_DYNAMIC;
  double calls = caller->calls++;
  if (caller->func == NULL)
    return true;
  caller->what = caller->all != NULL ? caller->all
                 : in_time           ? "time"
                 : progress->rigid   ? "limit analysis"
                                     : "path";
  if (!progress->rigid) {
    caller->reached = in_time ? progress->time : progress->multiplier;
    caller->steps = progress->steps;
  }
  return quoin_library_tell (caller,
                             !in_time ? calls / (calls + HALF_WAY)
                             : progress->end > 0
                               ? fmin (progress->time / progress->end, 1)
                               : 0,
                             progress->iterations);
}

/* The last call, once the analysis has come to its end. */
static void
report_end (QuoinCaller *caller, const QnResult *result)
{
  if (caller->calls > 0 && result->outcome != QN_OUTCOME_CANCELLED)
    quoin_library_tell (caller, 1, result->statistics.iterations);
}

/* A result that takes over what the core has filled. */
static QuoinResult *
make_result (QuoinModel *model, QnResult *filled, const char *name)
{
  QuoinResult *result = g_new0 (QuoinResult, 1);
  g_atomic_ref_count_init (&result->references);
  result->model = quoin_model_ref (model);
  result->name = g_path_get_basename (name);
  result->result = *filled;
  result->multipliers = g_new (double, filled->step_count + 1);
  for (size_t i = 0; i < filled->step_count; i++)
    result->multipliers[i] = filled->steps[i].multiplier;
  result->forces = g_new (double, 2 * filled->pair_count + 1);
  for (size_t i = 0; i < filled->pair_count; i++) {
    result->forces[2 * i] = filled->pairs[i].normal_force;
    result->forces[2 * i + 1] = filled->pairs[i].shear_force;
  }
  return result;
}

typedef QnStatus (*Analysis) (const QnModel *model, const QnContacts *contacts,
                              QnProgressFunc progress, void *data, QnResult *result,
                              QnDiag *diag);

static QuoinResult *
run (Analysis analysis, QuoinModel *model, QuoinProgressFunc progress, void *data,
     QuoinError **error)
{
  QnDiag diag = { 0 };
  QnResult result;
  if (!quoin_library_given (model, "model", error))
    return NULL;
  QuoinCaller caller = { .func = progress,
                         .data = data,
                         .model = &model->project.model,
                         .all = analysis == qn_stability_run ? "stability" : NULL };
  if (model->unread != NULL)
    return quoin_library_take_error (error, model->project.name,
                                     g_error_copy (model->unread));
  if (qn_contacts_require_sound (&model->project.model, &model->contacts, &diag) != QN_OK
      || analysis (&model->project.model, &model->contacts, report, &caller, &result,
                   &diag)
           != QN_OK)
    return quoin_library_take_diag (error, &model->project, &diag);
  report_end (&caller, &result);
  return make_result (model, &result, "result");
}

QuoinResult *
quoin_solve (QuoinModel *model, QuoinProgressFunc progress, void *data,
             QuoinError **error)
{
  return run (qn_analysis_run, model, progress, data, error);
}

QuoinResult *
quoin_stability (QuoinModel *model, QuoinProgressFunc progress, void *data,
                 QuoinError **error)
{
  if (model != NULL && model->project.model.analysis.geometry != QN_GEOMETRY_NONLINEAR)
    return quoin_library_set_error (error, QUOIN_ERROR_INVALID,
                                    "%s: analysis.geometry: linear geometry has no "
                                    "buckling: set it to nonlinear",
                                    model->project.name);
  return run (qn_stability_run, model, progress, data, error);
}

QuoinResult *
quoin_limit (QuoinModel *model, bool associative, QuoinProgressFunc progress, void *data,
             QuoinError **error)
{
  if (!quoin_library_given (model, "model", error))
    return NULL;
  const char *const overrides[] = { "analysis.procedure=limit",
                                    associative ? "analysis.flow=associative"
                                                : "analysis.flow=non-associative",
                                    NULL };
  g_autoptr (QuoinModel) own = quoin_model_with (model, overrides, error);
  return own != NULL ? quoin_solve (own, progress, data, error) : NULL;
}

char *
quoin_limit_sensitivity (const QuoinResult *result, QuoinError **error)
{
  QnDiag diag = { 0 };
  QnLimitSensitivity found;
  gsize length;
  if (!quoin_library_given (result, "result", error))
    return NULL;
  const QnProject *project = &result->model->project;
  const QnModel *model = &project->model;
  if (!result->result.limit.given || result->result.limit.flow != QN_FLOW_ASSOCIATIVE
      || result->result.outcome != QN_OUTCOME_COLLAPSE)
    return quoin_library_set_error (error, QUOIN_ERROR_NO_ANSWER,
                                    "%s: no collapse by associative limit analysis",
                                    project->name);
  if (qn_limit_sensitivity (model, &result->model->contacts, &result->result, &found,
                            &diag)
      != QN_OK)
    return quoin_library_take_diag (error, project, &diag);
  QnFileWriter *out = qn_file_writer_new_in_memory ();
  qn_file_writer_json (out, "{ \"multiplier\": %g, \"laws\": [", found.multiplier);
  for (size_t i = 0; i < model->law_count; i++) {
    const QnLawSensitivity *law = &found.laws[i];
    qn_file_writer_json (out,
                         ", { \"name\": %s, \"friction\": %g, \"cohesion\": %g, "
                         "\"tension\": %g, \"weight\": %g, \"thickness\": %g }",
                         model->laws[i].name, law->friction, law->cohesion, law->tension,
                         law->weight, law->thickness);
  }
  qn_file_writer_puts (out, "], \"dead_loads\": [");
  for (size_t i = 0; i < model->dead_load_count; i++)
    qn_file_writer_json (out, ", %g", found.dead_loads[i]);
  qn_file_writer_puts (out, "], \"live_loads\": [");
  for (size_t i = 0; i < model->live_load_count; i++)
    qn_file_writer_json (out, ", %g", found.live_loads[i]);
  qn_file_writer_puts (out, "] }\n");
  qn_limit_sensitivity_clear (&found);
  return qn_file_writer_steal (out, &length);
}

static QuoinModes *
find_modes (QuoinModel *model, size_t count, QnModalState state,
            QuoinProgressFunc progress, void *data, QuoinError **error)
{
  if (!quoin_library_given (model, "model", error))
    return NULL;
  if (count == 0)
    return quoin_library_set_error (error, QUOIN_ERROR_USAGE, "count: counts from 1");
  QnDiag diag = { 0 };
  QnResult result;
  g_autoptr (QuoinModes) modes = g_new0 (QuoinModes, 1);
  QuoinCaller caller = {
    .func = progress, .data = data, .model = &model->project.model, .all = "modes"
  };
  if (qn_modal_run (&model->project.model, &model->contacts, state, count, report,
                    &caller, &modes->modes, &result, &diag)
      != QN_OK)
    return quoin_library_take_diag (error, &model->project, &diag);
  bool found = modes->modes.count > 0 || result.outcome == QN_OUTCOME_CANCELLED;
  report_end (&caller, &result);
  qn_result_clear (&result);
  if (found)
    return g_steal_pointer (&modes);
  return quoin_library_set_error (error, QUOIN_ERROR_NO_ANSWER,
                                  "%s: no equilibrium was found, so there are no "
                                  "vibrations about it",
                                  model->project.name);
}

QuoinModes *
quoin_modal (QuoinModel *model, size_t count, bool loaded, QuoinProgressFunc progress,
             void *data, QuoinError **error)
{
  return find_modes (model, count, loaded ? QN_MODAL_LOADED : QN_MODAL_DEAD_LOAD,
                     progress, data, error);
}

QuoinModes *
quoin_modal_sliding (QuoinModel *model, size_t count, bool loaded,
                     QuoinProgressFunc progress, void *data, QuoinError **error)
{
  QnModalState state = (loaded ? QN_MODAL_LOADED : QN_MODAL_DEAD_LOAD) | QN_MODAL_SLIDING;
  return find_modes (model, count, state, progress, data, error);
}

/* "option=value" one after the other. */
static bool
set_capacity (QnCapacitySettings *settings, const char *const *options, GError **cause)
{
  for (; options != NULL && *options != NULL; options++) {
    g_auto (GStrv) parts = g_strsplit (*options, "=", 2);
    const char *value = parts[0] != NULL && parts[1] != NULL ? parts[1] : "";
    if (!qn_capacity_settings_set (settings, parts[0] != NULL ? parts[0] : "", value,
                                   cause))
      return false;
  }
  return true;
}

/* The answer of a model that is written over; false with an error of either kind. */
static bool
find_capacity (QuoinModel *own, QnCapacityAnswer *answer, QuoinCaller *caller,
               QuoinError **error)
{
  QnProject *project = &own->project;
  QnDiag diag = { 0 };
  QnStatus status = qn_contacts_require_sound (&project->model, &own->contacts, &diag);
  if (status == QN_OK)
    status = qn_capacity_answer_find (answer, &project->model, &own->contacts, report,
                                      caller, &diag);
  if (status != QN_OK && status != QN_ERROR_CANCELLED)
    return quoin_library_take_diag (error, project, &diag);
  if (status == QN_ERROR_CANCELLED || answer->capacity.count == 0)
    return quoin_library_set_error (error, QUOIN_ERROR_NO_ANSWER, "%s: %s", project->name,
                                    answer->reason != NULL ? answer->reason
                                                           : "cancelled");
  qn_capacity_answer_check (answer);
  return true;
}

char *
quoin_capacity (QuoinModel *model, const char *const *options, const char *picture,
                QuoinProgressFunc progress, void *data, QuoinError **error)
{
  if (!quoin_library_given (model, "model", error))
    return NULL;
  QnCapacitySettings settings;
  QnCapacityAnswer answer = { 0 };
  QnRecord points = { 0 };
  QnMetadata metadata;
  GError *cause = NULL;
  gsize length;
  char *text = NULL;
  g_autoptr (QuoinModel) own = quoin_library_model_with (model, NULL, NULL, error);
  if (own == NULL)
    return NULL;
  QuoinCaller caller = {
    .func = progress, .data = data, .model = &own->project.model, .all = "capacity"
  };
  qn_project_get_metadata (&own->project, &metadata);
  if (qn_capacity_settings_read (&own->project, &settings, &cause)
      && set_capacity (&settings, options, &cause)
      && qn_capacity_settings_apply (&settings, &own->project, FALSE, &answer, &points,
                                     &cause)
      && find_capacity (own, &answer, &caller, error)
      && (picture == NULL
          || qn_capacity_answer_export (&answer, own->project.model.title, &metadata,
                                        picture, &cause))) {
    report_end (&caller, &(QnResult){ .outcome = QN_OUTCOME_TARGET_REACHED });
    text = qn_capacity_answer_dup_json (&answer, &own->project, &length);
  }
  if (cause != NULL)
    quoin_library_take_error (error, own->project.name, cause);
  qn_capacity_answer_clear (&answer);
  qn_record_clear (&points);
  qn_capacity_settings_clear (&settings);
  return text;
}

void
quoin_modes_free (QuoinModes *modes)
{
  if (modes == NULL)
    return;
  qn_modes_clear (&modes->modes);
  g_free (modes);
}

QUOIN_GET (size_t, quoin_modes_get_count, QuoinModes, 0, of->modes.count)
QUOIN_GET (const double *, quoin_modes_get_omega, QuoinModes, NULL, of->modes.omega)
QUOIN_GET (const double *, quoin_modes_get_shapes, QuoinModes, NULL, of->modes.shapes)
QUOIN_GET (const double *, quoin_modes_get_masses, QuoinModes, NULL, of->modes.masses)
QUOIN_GET (size_t, quoin_modes_get_body_count, QuoinModes, 0,
           of->modes.block_count + of->modes.node_count)

void
quoin_modes_get_damping (const QuoinModes *modes, double ratio, double coefficients[2])
{
  if (modes == NULL || coefficients == NULL || modes->modes.count == 0)
    return;
  QnModesDamping damping = qn_modes_damping (&modes->modes, ratio);
  coefficients[0] = damping.mass;
  coefficients[1] = damping.stiffness;
}

/* --- Files ------------------------------------------------------------------------------- */

/* Lists of strings; NULL is an empty one. */
static bool
equal_lists (char **a, char **b)
{
  static const char *const none[] = { NULL };
  return g_strv_equal (a != NULL ? (const char *const *) a : none,
                       b != NULL ? (const char *const *) b : none);
}

/* Takes the result over from a file, if it was read. Overrides of its analysis that the model has not are
 * its model's, as of the command line. */
static QuoinResult *
take_file (QuoinModel *model, QnResultFile *file, gboolean read, const char *name,
           GError *cause, QuoinError **error)
{
  gboolean same = FALSE;
  if (!read)
    return quoin_library_take_error (error, name, cause);
  g_autoptr (QuoinModel) own =
    equal_lists (file->overrides, model->project.overrides)
      ? quoin_model_ref (model)
      : quoin_library_model_with (model, (const char *const *) file->overrides, NULL,
                                  error);
  if (own == NULL)
    return NULL;
  if (!qn_result_file_match (file, name, &own->project, &own->contacts, &same, &cause))
    return quoin_library_take_error (error, name, cause);
  QuoinResult *result = make_result (own, &file->result, name);
  result->changed = !same || !equal_lists (file->overrides, own->project.overrides);
  file->result = (QnResult){ 0 };
  return result;
}

QuoinResult *
quoin_result_read (QuoinModel *model, const char *path, QuoinError **error)
{
  if (!quoin_library_given (model, "model", error)
      || !quoin_library_given (path, "path", error))
    return NULL;
  g_auto (QnResultFile) file = { 0 };
  GError *cause = NULL;
  gboolean read = qn_result_file_read (path, &file, &cause);
  return take_file (model, &file, read, path, cause, error);
}

QuoinResult *
quoin_result_parse (QuoinModel *model, const char *text, size_t length, const char *name,
                    QuoinError **error)
{
  if (!quoin_library_given (model, "model", error)
      || !quoin_library_given (text, "text", error)
      || !quoin_library_given (name, "name", error))
    return NULL;
  g_auto (QnResultFile) file = { 0 };
  GError *cause = NULL;
  gboolean read = qn_result_file_parse (text, length, name, &file, &cause);
  return take_file (model, &file, read, name, cause, error);
}

bool
quoin_result_write (const QuoinResult *result, const char *path, QuoinError **error)
{
  if (!quoin_library_given (result, "result", error)
      || !quoin_library_given (path, "path", error))
    return false;
  GError *cause = NULL;
  if (qn_result_file_write (path, &result->model->project, &result->model->contacts,
                            &result->result, QN_DETAIL_FORCES, &cause))
    return true;
  return quoin_library_take_error (error, path, cause);
}

char *
quoin_result_to_text (const QuoinResult *result)
{
  gsize length;
  return result != NULL
           ? qn_result_dup_text (&result->model->project, &result->model->contacts,
                                 &result->result, QN_DETAIL_STEPS, &length)
           : NULL;
}

bool
quoin_result_check (const QuoinResult *result, char **faults, QuoinError **error)
{
  if (faults != NULL)
    *faults = NULL;
  if (!quoin_library_given (result, "result", error))
    return false;
  const QnProject *project = &result->model->project;
  const QnContacts *contacts = &result->model->contacts;
  gsize length;
  g_autofree char *text =
    qn_result_dup_text (project, contacts, &result->result, QN_DETAIL_FORCES, &length);
  g_auto (QnResultFile) file = { 0 };
  QnResultFaults found;
  GError *cause = NULL;
  if (!qn_result_file_parse (text, length, "result", &file, &cause)
      || !qn_result_file_find_faults (&file, "result", project, contacts, &found, &cause))
    return quoin_library_take_error (error, "result", cause);
  g_autoptr (GString) lines = g_string_new (NULL);
  for (int i = 0; i < found.count; i++) {
    g_autofree char *fault =
      qn_fault_dup_text (&project->model, contacts, &found.items[i]);
    g_string_append_printf (lines, "%s%s", i > 0 ? "\n" : "", fault);
  }
  if (faults != NULL)
    *faults = g_strdup (lines->str);
  return found.count == 0;
}

/* --- What it says ------------------------------------------------------------------------ */

QuoinResult *
quoin_library_result_ref (QuoinResult *result)
{
  g_atomic_ref_count_inc (&result->references);
  return result;
}

void
quoin_result_free (QuoinResult *result)
{
  if (result == NULL || !g_atomic_ref_count_dec (&result->references))
    return;
  quoin_model_unref (result->model);
  qn_result_clear (&result->result);
  g_free (result->name);
  g_free (result->multipliers);
  g_free (result->forces);
  g_free (result);
}

/* Of a result, or of an item of one of its lists. */
#define GET(type, name, none, value)                                                     \
  QUOIN_GET (type, quoin_result_##name, QuoinResult, none, value)
#define GET_ITEM(type, name, count, none, value)                                         \
  QUOIN_GET_ITEM (type, quoin_result_##name, QuoinResult, of->result.count, none, value)

/* A number that is given, or not-a-number. */
#define GET_GIVEN(name, given, number)                                                   \
  GET (double, name, (double) NAN, of->result.given ? of->result.number : (double) NAN)

GET (QuoinModel *, get_model, NULL, of->model)
GET (bool, is_of_changed_model, false, of->changed)
GET (const char *, get_outcome, NULL, qn_outcome_names[of->result.outcome])
GET_GIVEN (get_collapse_multiplier, has_collapse_multiplier, collapse_multiplier)
GET_GIVEN (get_first_limit_multiplier, has_first_limit_multiplier, first_limit_multiplier)
GET_GIVEN (get_lower_bound, limit.given, limit.lower_bound)
GET_GIVEN (get_upper_bound, limit.given, limit.upper_bound)
GET (bool, is_beyond_linear, false, of->result.linearity == QN_LINEARITY_BEYOND)

GET (size_t, get_solution_count, 0, (size_t) of->result.solution_count)
GET_ITEM (double, get_solution_multiplier, solution_count, (double) NAN,
          of->result.solutions[item].multiplier)
GET_ITEM (const char *, get_solution_found_by, solution_count, NULL,
          qn_procedure_names[of->result.solutions[item].found_by])
GET_ITEM (double, get_solution_displacement, solution_count, (double) NAN,
          of->result.solutions[item].displacement)

GET (size_t, get_event_count, 0, of->result.event_count)
GET_ITEM (double, get_event_multiplier, event_count, (double) NAN,
          of->result.events[item].multiplier)
GET_ITEM (const char *, get_event_kind, event_count, NULL,
          qn_event_kind_names[of->result.events[item].kind])
GET_ITEM (double, get_event_energy, event_count, (double) NAN,
          of->result.events[item].energy)

GET (size_t, get_step_count, 0, of->result.step_count)
GET (size_t, get_body_count, 0, qn_result_body_count (&of->result))
GET (const double *, get_multipliers, NULL, of->multipliers)
GET (const double *, get_displacements, NULL, of->result.displacements)
GET (const double *, get_mechanism, NULL, of->result.mechanism)
GET (size_t, get_pair_count, 0, of->result.pair_count)
GET (const double *, get_forces, NULL, of->forces)
GET_ITEM (const char *, get_pair_state, pair_count, NULL,
          qn_pair_state_names[of->result.pairs[item].state])
GET (size_t, get_tie_count, 0, of->result.tie_count)
GET (int32_t, get_iterations, 0, of->result.statistics.iterations)
GET (int32_t, get_factorizations, 0, of->result.statistics.factorizations)

char *
quoin_result_describe (const QuoinResult *result)
{
  if (result == NULL)
    return NULL;
  const QnModel *model = &result->model->project.model;
  g_autofree char *reason = qn_outcome_dup_reason (model, &result->result);
  g_autofree char *moves =
    qn_collapse_dup_text (model, &result->model->contacts, &result->result);
  return moves != NULL ? g_strdup_printf ("%s %s", reason, moves)
                       : g_steal_pointer (&reason);
}

void
quoin_result_get_collapse_interval (const QuoinResult *result, double interval[2])
{
  if (!(result != NULL && interval != NULL))
    return;
  QnProcedure found_by;
  qn_result_collapse_interval (&result->result, &interval[0], &found_by, &interval[1]);
}

double
quoin_result_get_beyond_linear_multiplier (const QuoinResult *result)
{
  if (result == NULL)
    return (double) NAN;
  bool given =
    quoin_result_is_beyond_linear (result) && result->result.history.width == 0;
  return given ? result->result.beyond_linear_multiplier : (double) NAN;
}

void
quoin_result_get_event_displacements (const QuoinResult *result, size_t event,
                                      double displacements[2])
{
  if (!(result != NULL && event < result->result.event_count && displacements != NULL))
    return;
  displacements[0] = result->result.events[event].displacement_before;
  displacements[1] = result->result.events[event].displacement_after;
}

const int32_t *
quoin_result_get_event_blocks (const QuoinResult *result, size_t event, size_t *count)
{
  bool given = result != NULL && event < result->result.event_count;
  if (count != NULL)
    *count = given ? result->result.events[event].block_count : 0;
  return given ? result->result.events[event].blocks : NULL;
}

/* NULL where the step does not tell it, or there is none. */
static const QnTieResult *
get_tie (const QuoinResult *result, size_t step, size_t tie)
{
  if (result == NULL || step >= result->result.step_count
      || tie >= result->result.tie_count)
    return NULL;
  const QnTieResult *ties = qn_result_step_ties (&result->result, step);
  return ties != NULL ? &ties[tie] : NULL;
}

bool
quoin_result_get_tie (const QuoinResult *result, size_t step, size_t tie, double *force,
                      double *elongation)
{
  const QnTieResult *found = get_tie (result, step, tie);
  if (force != NULL)
    *force = found != NULL ? found->force : (double) NAN;
  if (elongation != NULL)
    *elongation = found != NULL ? found->elongation : (double) NAN;
  return found != NULL;
}

const char *
quoin_result_get_tie_state (const QuoinResult *result, size_t step, size_t tie)
{
  const QnTieResult *found = get_tie (result, step, tie);
  return found != NULL ? qn_tie_state_names[found->state] : NULL;
}
