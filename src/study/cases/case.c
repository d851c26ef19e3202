#include "study/cases/case.h"

#include "core/base/clock.h"
#include "core/base/integer.h"
#include "core/limit/limit.h"
#include "core/modal/modal.h"
#include "core/path/analysis.h"
#include "core/result/mechanism.h"
#include "io/exchange/record.h"
#include "io/result/result-file.h"
#include "io/text/io-error.h"
#include "io/text/text-format.h"
#include "render/scene/reading.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* ---- shapes of mechanisms ---- */

static const char digits[] =
  "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/* Digits for -LEVELS … LEVELS. */
#define LEVELS 31

static char
digit_of (double part)
{
  return digits[LEVELS + qn_to_integer (rint (LEVELS * part), -LEVELS, LEVELS)];
}

char *
qn_shape_dup (const QnModel *model, const double *velocities)
{
  QnVec2 low = { INFINITY, INFINITY }, high = { -INFINITY, -INFINITY };
  QnVec2 speeds[QN_SHAPE_POINTS * QN_SHAPE_POINTS];
  double largest = 0;
  if (model->block_count == 0)
    return NULL;
  for (size_t b = 0; b < model->block_count; b++)
    for (int32_t k = 0; k < model->blocks[b].vertex_count; k++) {
      QnVec2 p = qn_model_block_vertices (model, (QnId) b)[k];
      low = qn_vec2 (fmin (low.x, p.x), fmin (low.y, p.y));
      high = qn_vec2 (fmax (high.x, p.x), fmax (high.y, p.y));
    }
  for (int i = 0; i < QN_SHAPE_POINTS * QN_SHAPE_POINTS; i++) {
    double x = (i % QN_SHAPE_POINTS + 0.5) / QN_SHAPE_POINTS;
    double y = ((double) (i / QN_SHAPE_POINTS) + 0.5) / QN_SHAPE_POINTS;
    QnVec2 point = { low.x + x * (high.x - low.x), low.y + y * (high.y - low.y) };
    double depth;
    QnId index = qn_model_deepest_block (model, 0, false, point, &depth);
    const QnBlock *block = &model->blocks[index];
    const double *v = velocities + (size_t) index * QN_DOF_COUNT;
    /* Away from the block its motion is that of its centroid: a thin ring has few points. */
    QnVec2 arm = depth >= 0 ? qn_vec2_sub (point, block->centroid) : qn_vec2 (0, 0);
    speeds[i] = qn_vec2_add_scaled (qn_vec2 (v[QN_DOF_UX], v[QN_DOF_UY]), v[QN_DOF_RZ],
                                    qn_vec2_perp (arm));
    largest = fmax (largest, fmax (fabs (speeds[i].x), fabs (speeds[i].y)));
  }
  if (!(largest > 0) || !isfinite (largest))
    return NULL;
  char *shape = g_malloc (QN_SHAPE_LENGTH + 1);
  for (int i = 0; i < QN_SHAPE_POINTS * QN_SHAPE_POINTS; i++) {
    shape[2 * i] = digit_of (speeds[i].x / largest);
    shape[2 * i + 1] = digit_of (speeds[i].y / largest);
  }
  shape[QN_SHAPE_LENGTH] = '\0';
  return shape;
}

static double
level_of (char digit)
{
  const char *place = strchr (digits, digit);
  return place != NULL ? (double) (place - digits - LEVELS) : 0;
}

double
qn_shape_cosine (const char *a, const char *b)
{
  double product = 0, aa = 0, bb = 0;
  if (a == NULL || b == NULL || strlen (a) != QN_SHAPE_LENGTH
      || strlen (b) != QN_SHAPE_LENGTH)
    return 0;
  for (int i = 0; i < QN_SHAPE_LENGTH; i++) {
    double x = level_of (a[i]), y = level_of (b[i]);
    product += x * y;
    aa += x * x;
    bb += y * y;
  }
  return aa > 0 && bb > 0 ? product / sqrt (aa * bb) : 0;
}

void
qn_case_model_clear (QnCaseModel *model)
{
  qn_result_clear (&model->result);
  qn_contacts_clear (&model->contacts);
  qn_project_clear (&model->project);
}

void
qn_case_result_clear (QnCaseResult *result)
{
  g_free (result->outcome);
  g_free (result->reason);
  g_free (result->mechanism);
  g_free (result->shape);
  *result = (QnCaseResult){ 0 };
}

void
qn_case_result_fail (QnCaseResult *result, const char *reason)
{
  *result = (QnCaseResult){ .failed = TRUE, .reason = g_strdup (reason) };
  for (int i = 0; i < QN_STUDY_OUTPUT_COUNT; i++)
    result->numbers[i] = NAN;
}

/* "path=value" for every path of every parameter, NULL-terminated. Combinations find what they
 * multiply in `model` (nullable: they are left out). */
static char **
dup_overrides (const QnStudy *study, const double *values, const QnModel *model)
{
  GPtrArray *overrides = g_ptr_array_new ();
  char number[QN_NUMBER_TEXT_SIZE];
  if (qn_study_run_override (study->run) != NULL)
    g_ptr_array_add (overrides, g_strdup (qn_study_run_override (study->run)));
  if (study->factorizations > 0)
    g_ptr_array_add (overrides, g_strdup_printf ("analysis.max_factorizations=%d",
                                                 study->factorizations));
  for (guint i = 0; i < study->parameters->len; i++) {
    const QnParameter *parameter = qn_study_parameter (study, i);
    qn_number_text (values[i], number);
    for (char **path = parameter->paths; *path != NULL; path++)
      g_ptr_array_add (overrides, g_strconcat (*path, "=", number, NULL));
  }
  if (study->combinations != NULL && model != NULL) {
    gsize index = (gsize) values[study->parameters->len - 1] - 1;
    qn_combination_add_overrides (study->combinations->pdata[index], model, overrides);
  }
  g_ptr_array_add (overrides, NULL);
  return (char **) g_ptr_array_free (overrides, FALSE);
}

/* The project with the values of a case: what a combination multiplies depends on the other
 * parameters. */
static gboolean
parse (const QnStudy *study, const double *values, QnProject *project, GError **error)
{
  const QnProject *base = &study->project;
  g_auto (GStrv) overrides = dup_overrides (study, values, NULL);
  if (!qn_project_parse (base->text, base->text_length, base->name,
                         (const char *const *) overrides, project, error))
    return FALSE;
  if (study->combinations == NULL)
    return TRUE;
  g_auto (GStrv) combined = dup_overrides (study, values, &project->model);
  qn_project_clear (project);
  return qn_project_parse (base->text, base->text_length, base->name,
                           (const char *const *) combined, project, error);
}

/* Reads the case and finds its contacts. */
static gboolean
prepare (const QnStudy *study, const double *values, QnCaseModel *model, GError **error)
{
  QnDiag diag = { 0 };
  if (!parse (study, values, &model->project, error)
      || (qn_study_record_count (study) > 0
          && !qn_project_read_records (&model->project, study->folder, FALSE, error)))
    return FALSE;
  if (qn_contacts_detect (&model->project.model, &model->contacts, &diag) == QN_OK
      && qn_contacts_require_sound (&model->project.model, &model->contacts, &diag)
           == QN_OK)
    return TRUE;
  qn_project_set_error (&model->project, &diag, error);
  return FALSE;
}

/* What bounds the multiplier from above whatever the dilatancy; NaN where limit analysis does not
 * know the joints, or finds no bound. */
static double
associative_multiplier (const QnCaseModel *model)
{
  if (model->result.has_associative_bound)
    return model->result.associative_bound;
  QnLimitSolution solution;
  double bound = NAN;
  if (qn_limit_associative (&model->project.model, &model->contacts, NULL, NULL,
                            &solution, NULL)
        == QN_OK
      && solution.outcome == QN_OUTCOME_COLLAPSE)
    bound = solution.upper_bound;
  qn_limit_solution_clear (&solution);
  return bound;
}

static double
largest_displacement (const QnResult *result)
{
  double largest = 0;
  if (result->step_count == 0)
    return NAN;
  const double *u = qn_result_step_displacements (result, result->step_count - 1);
  for (size_t b = 0; b < qn_result_body_count (result); b++)
    largest = fmax (
      largest, hypot (u[b * QN_DOF_COUNT + QN_DOF_UX], u[b * QN_DOF_COUNT + QN_DOF_UY]));
  return largest;
}

/* The widest crack at the last step, between two blocks or, where `blocks` is NULL, anywhere, m; NaN
 * where nothing was computed or the blocks have no joint. */
static double
crack_width (const QnCaseModel *model, char *const *blocks)
{
  const QnModel *core = &model->project.model;
  const QnResult *result = &model->result;
  double widest = blocks != NULL ? NAN : 0;
  if (result->step_count == 0)
    return NAN;
  const size_t last = result->step_count - 1;
  const QnMotion motion = qn_step_motion (core, result, last);
  g_autofree QnPairResult *pairs = qn_step_pairs (&model->contacts, result, last);
  QnId a = blocks != NULL ? qn_model_find_block (core, blocks[0]) : QN_NONE;
  QnId b = blocks != NULL ? qn_model_find_block (core, blocks[1]) : QN_NONE;
  for (size_t f = 0; f < model->contacts.face_count; f++) {
    const QnContactFace *face = &model->contacts.faces[f];
    if (blocks != NULL
        && !((face->a == a && face->b == b) || (face->a == b && face->b == a)))
      continue;
    widest =
      fmax (widest, qn_joint_crack (&model->contacts, (QnId) f, pairs, &motion).width);
  }
  return widest;
}

static double
crack_misfit (const QnStudy *study, const QnCaseModel *model)
{
  double sum = 0;
  if (model->result.outcome != QN_OUTCOME_TARGET_REACHED)
    return NAN;
  for (guint i = 0; i < study->cracks->len; i++) {
    const QnMeasuredCrack *crack = &g_array_index (study->cracks, QnMeasuredCrack, i);
    double error = crack_width (model, crack->blocks) - crack->width;
    sum += error * error;
  }
  return sqrt (sum / study->cracks->len);
}

static double
known (gboolean is_known, double value)
{
  return is_known ? value : NAN;
}

static double
last_energy (const QnResult *result, QnEnergyKind kind)
{
  const QnHistory *history = &result->history;
  if (history->row_count == 0)
    return NAN;
  return history
    ->rows[(history->row_count - 1) * history->width + QN_HISTORY_ENERGY + kind];
}

static double
number_of (const QnStudy *study, const QnCaseModel *model, QnStudyOutput output)
{
  const QnResult *result = &model->result;
  const QnLimitFigures *figures = &result->limit;
  switch (output) {
  case QN_STUDY_COLLAPSE_MULTIPLIER:
    return known (result->has_collapse_multiplier, result->collapse_multiplier);
  case QN_STUDY_ASSOCIATIVE_MULTIPLIER:
    return associative_multiplier (model);
  case QN_STUDY_FIRST_LIMIT_MULTIPLIER:
    return known (result->has_first_limit_multiplier, result->first_limit_multiplier);
  case QN_STUDY_LOWER_BOUND:
    return known (figures->given, figures->lower_bound);
  case QN_STUDY_UPPER_BOUND:
    return known (figures->given, figures->upper_bound);
  case QN_STUDY_LAST_MULTIPLIER:
    return result->step_count > 0 ? result->steps[result->step_count - 1].multiplier
                                  : NAN;
  case QN_STUDY_LARGEST_DISPLACEMENT:
    return largest_displacement (result);
  case QN_STUDY_STEPS:
    return (double) result->step_count;
  case QN_STUDY_ITERATIONS:
    return result->statistics.iterations;
  case QN_STUDY_WIDEST_CRACK:
    return crack_width (model, NULL);
  case QN_STUDY_CRACK_MISFIT:
    return crack_misfit (study, model);
  case QN_STUDY_COLLAPSED:
    return result->outcome == QN_OUTCOME_COLLAPSE;
  case QN_STUDY_TIME_OF_COLLAPSE:
    return known (result->outcome == QN_OUTCOME_COLLAPSE, result->history.collapse_time);
  case QN_STUDY_PEAK_DISPLACEMENT:
    return known (result->history.peaks != NULL, qn_result_peak (result, NULL));
  case QN_STUDY_FRICTION_ENERGY:
    return last_energy (result, QN_ENERGY_FRICTION);
  case QN_STUDY_LARGEST_SLIP:
    return known (result->history.width > 0, result->history.largest_slip);
  case QN_STUDY_ENERGY_ERROR:
    return known (result->history.width > 0, result->history.energy_error);
  case QN_STUDY_MECHANISM_KIND:
  case QN_STUDY_MECHANISM_SHAPE:
  case QN_STUDY_FREQUENCY_1:
  case QN_STUDY_FREQUENCY_2:
  case QN_STUDY_FREQUENCY_3:
  case QN_STUDY_FREQUENCY_4:
  case QN_STUDY_FREQUENCY_5:
  case QN_STUDY_FREQUENCY_6:
  case QN_STUDY_OUTPUT_COUNT:
    break;
  }
  return NAN;
}

static char *
dup_mechanism_kind (const QnCaseModel *model)
{
  QnMechanism mechanism;
  if (model->result.mechanism == NULL
      || qn_mechanism_of_result (&mechanism, &model->project.model, &model->contacts,
                                 &model->result, NULL)
           != QN_OK)
    return NULL;
  char *kind = g_strdup (qn_mechanism_kind_names[mechanism.kind]);
  qn_mechanism_clear (&mechanism);
  return kind;
}

static QnStatus
analyse (const QnStudy *study, QnCaseModel *model, QnCaseResult *result, QnDiag *diag)
{
  const QnModel *core = &model->project.model;
  /* A study asks for the bound itself, where it is one of its outputs. */
  if (core->analysis.bound == QN_BOUND_AUTO)
    model->project.model.analysis.bound = QN_BOUND_NEVER;
  if (study->run != QN_STUDY_MODAL)
    return qn_analysis_run (core, &model->contacts, NULL, NULL, &model->result, diag);

  enum { WANTED = QN_STUDY_FREQUENCY_6 - QN_STUDY_FREQUENCY_1 + 1 };
  QnModes modes;
  QnStatus status = qn_modal_run (core, &model->contacts, QN_MODAL_DEAD_LOAD, WANTED,
                                  NULL, NULL, &modes, &model->result, diag);
  for (size_t i = 0; status == QN_OK && i < MIN (modes.count, (size_t) WANTED); i++)
    result->numbers[QN_STUDY_FREQUENCY_1 + i] = modes.omega[i] / (2 * G_PI);
  qn_modes_clear (&modes);
  return status;
}

void
qn_case_solve (const QnStudy *study, const double *values, const char *keep,
               QnCaseModel *model, QnCaseResult *result)
{
  double start = qn_clock_seconds ();
  QnCaseModel own;
  GError *error = NULL;
  QnDiag diag = { 0 };
  QnCaseModel *current = model != NULL ? model : &own;

  *current = (QnCaseModel){ 0 };
  qn_case_result_fail (result, NULL);
  if (prepare (study, values, current, &error)) {
    if (analyse (study, current, result, &diag) != QN_OK)
      qn_project_set_error (&current->project, &diag, &error);
    else {
      result->failed = FALSE;
      result->outcome = g_strdup (qn_outcome_names[current->result.outcome]);
      for (guint i = 0; i < study->outputs->len; i++) {
        QnStudyOutput output = qn_study_output (study, i);
        if (output == QN_STUDY_MECHANISM_KIND)
          result->mechanism = dup_mechanism_kind (current);
        else if (output == QN_STUDY_MECHANISM_SHAPE)
          result->shape =
            current->result.mechanism != NULL
              ? qn_shape_dup (&current->project.model, current->result.mechanism)
              : NULL;
        else if (output < QN_STUDY_FREQUENCY_1)
          result->numbers[output] = number_of (study, current, output);
      }
    }
  }
  /* What an analysis that was not let to its end says is no answer. */
  QnStop stop = current->result.stop;
  if (error == NULL && (stop == QN_STOP_FACTORIZATIONS || stop == QN_STOP_TIME))
    g_set_error_literal (
      &error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
      stop == QN_STOP_TIME
        ? _ ("the analysis took longer than max_seconds allows")
        : _ ("the analysis took more factorisations than max_factorizations allows"));
  if (error == NULL && keep != NULL)
    qn_result_file_write (keep, &current->project, &current->contacts, &current->result,
                          QN_DETAIL_FORCES, &error);
  if (error != NULL) {
    qn_case_result_clear (result);
    qn_case_result_fail (result, error->message);
    qn_case_model_clear (current);
    g_error_free (error);
  } else if (model == NULL) {
    qn_case_model_clear (&own);
  }
  result->seconds = qn_clock_seconds () - start;
}
