#include "doc/view/capacity-answer.h"

#include "core/modal/modal.h"
#include "core/path/analysis.h"
#include "doc/document/job.h"
#include "doc/edit/edit.h"
#include "doc/text/explain.h"
#include "doc/view/report-parts.h"
#include "doc/view/sheet.h"
#include "io/text/file-writer.h"
#include "io/text/outcome-text.h"
#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>

/* First step of the control over its target, where both are chosen here: the path rises while joints
 * still deform little. */
#define INCREMENTS 2000

/* Share of mass below which a word is due. */
#define SMALL_SHARE 0.5

/* "SLV" …; the code that it is of. */
static const char *
check_name (QnCapacityCheck check)
{
  static const char *const names[] = { "SLV", "SLC", "SD", "NC" };
  return names[check];
}

static const char *
check_code (QnCapacityCheck check)
{
  return check < QN_CAPACITY_SD ? "NTC 2018" : "EN 1998-3";
}

int
qn_capacity_answer_count_states (const QnCapacityAnswer *answer)
{
  if (!answer->has_spectrum)
    return 0;
  return answer->capacity.kinematic || answer->spectrum.floor.height > 0
           ? QN_CAPACITY_SD
           : QN_CAPACITY_STATE_COUNT;
}

static char *
dup_ratio (double ratio)
{
  return qn_text_printf (ratio < 1 ? _ ("%.3f – not met") : "%.3f", ratio);
}

GPtrArray *
qn_capacity_answer_make_table (const QnCapacityAnswer *answer, QnUnits units)
{
  GPtrArray *cells = g_ptr_array_new_with_free_func (g_free);
  qn_report_row (cells, units, "wwuwwuw", _ ("State"), _ ("Code"), _ ("Capacity (%s)"),
                 QN_QUANTITY_LENGTH, _ ("a* (m/s²)"), _ ("Period (s)"), _ ("Demand (%s)"),
                 QN_QUANTITY_LENGTH, _ ("Ratio"));
  for (int k = 0; k < qn_capacity_answer_count_states (answer); k++) {
    const QnCapacityState *s = &answer->states[k];
    qn_report_row (cells, units, "wwqqqqo", check_name ((QnCapacityCheck) k),
                   check_code ((QnCapacityCheck) k), QN_QUANTITY_LENGTH, s->capacity, 4,
                   QN_QUANTITY_NUMBER, s->acceleration, 4, QN_QUANTITY_TIME, s->period, 4,
                   QN_QUANTITY_LENGTH, s->demand, 4,
                   s->refused ? g_strdup (_ ("refused")) : dup_ratio (s->ratio));
  }
  return cells;
}

char *
qn_capacity_dup_basis (const QnCapacityState *state, QnCapacityCheck check)
{
  const char *name = check_name (check);
  const char *rests = check < QN_CAPACITY_SD
                        ? _ ("the secant to the capacity")
                        : _ ("the elastic rise of the curve up to its peak");
  if (isnan (state->softer))
    return qn_text_printf (
      _ ("%s: the period of %.4g s is that of %s; how far it rests on the "
         "stiffness of the joints is not known."),
      name, state->period, rests);
  return qn_text_printf (
    state->refused
      ? _ (
        "%s: refused. The period of %.4g s is that of %s, and rests on the stiffness of "
        "the joints: %.4g s with half of it.")
      : _ (
        "%s: the period of %.4g s is that of %s; %.4g s with half the stiffness of the "
        "joints."),
    name, state->period, rests, state->softer);
}

/* %, from where on a difference is more than 0.00. */
#define LEAST_SHOWN 0.005

/* What virtual work found, and how the collapse that was found differs. */
static void
tell_mechanism (GString *text, const QnCapacityAnswer *answer)
{
  const QnCapacity *c = &answer->capacity;
  const QnLinearCheck *linear = &answer->linear;
  qn_text_append (text,
                  _ ("\nalpha0 %.5f by virtual work: (weights %.6g + ties %.6g)/live "
                     "load %.6g, in N m per m"),
                  c->activation, c->works[QN_WORK_DEAD], c->works[QN_WORK_TIES],
                  c->works[QN_WORK_LIVE]);
  if (c->broken > 0)
    qn_text_append (text,
                    _ ("\nties break at d* %.4g m and take more than half of the largest "
                       "a* with them: SLV is there at most (C8.7.1.2.1.6)"),
                    c->broken);
  const double apart = 100 * (c->activation / c->found - 1);
  if (isfinite (c->found) && fabs (apart) < LEAST_SHOWN)
    qn_text_append (text, _ ("\nfull model: multiplier %.5f, that of alpha0"), c->found);
  else if (isfinite (c->found))
    qn_text_append (text, _ ("\nfull model: multiplier %.5f, alpha0 differs by %+.2f %%"),
                    c->found, apart);
  if (!answer->has_spectrum)
    return;
  g_autofree char *sld = dup_ratio (linear->sld), *slv = dup_ratio (linear->slv);
  qn_text_append (text,
                  _ ("\nlinear: a0* %.4g m/s2 with FC %.3g, demand %.4g m/s2; SLD "
                     "(C8.7.1.2.1.5) %s; SLV with q = 2 (C8.7.1.2.1.7) %s"),
                  linear->capacity, answer->confidence, linear->demand, sld, slv);
  if (answer->spectrum.floor.height > 0)
    qn_text_append (text,
                    _ ("\nEN 1998-1, 4.3.5.2: Sa g %.4g m/s2, ratio of alpha0 g/FC to it "
                       "%.3f with qa = 1, %.3f with qa = 2"),
                    linear->en_demand, linear->en_ratio, 2 * linear->en_ratio);
}

/* Very low seismicity, m/s2: EN 1998-1:2004, 3.2.1(5), 0.04 g. */
#define LEAST_AG (0.04 * QN_STANDARD_GRAVITY)

static void
tell_spectrum (GString *text, const QnSpectrum *spectrum)
{
  double largest = spectrum->ground_acceleration;
  if (spectrum->kind == QN_SPECTRUM_POINTS)
    for (gsize i = 0; i < spectrum->point_count; i++)
      largest = fmax (largest, spectrum->points[i].y);
  qn_text_append (text,
                  spectrum->kind == QN_SPECTRUM_POINTS ? _ (
                    "\nspectrum of the file: largest acceleration %.4g m/s2 (%.3g g)")
                  : spectrum->kind == QN_SPECTRUM_EN_1
                    ? _ ("\nspectrum of EN 1998-1, type 1: ag %.4g m/s2 (%.3g g)")
                    : _ ("\nspectrum of EN 1998-1, type 2: ag %.4g m/s2 (%.3g g)"),
                  largest, largest / QN_STANDARD_GRAVITY);
  if (spectrum->kind != QN_SPECTRUM_POINTS)
    g_string_append_printf (text, _ (", soil %c"), 'A' + (int) spectrum->soil);
  qn_text_append (text, _ (", damping %.3g"), spectrum->damping);
  if (spectrum->kind != QN_SPECTRUM_POINTS && largest < LEAST_AG)
    qn_text_append (text,
                    _ ("; the code need not be applied below %.2g m/s2: is this "
                       "number in g?"),
                    LEAST_AG);
  const QnFloor *f = &spectrum->floor;
  if (f->height > 0)
    qn_text_append (
      text,
      _ ("\nat z %.4g m of H %.4g m (C7.2.3): %d storeys, T1 %.4g s, damping "
         "of the building %.3g; a_Z %.4g m/s2"),
      f->height, f->building, f->storeys, f->period, f->damping,
      qn_spectrum_acceleration (spectrum, 0));
}

char *
qn_capacity_answer_dup_facts (const QnCapacityAnswer *answer, QnUnits units)
{
  const QnCapacity *c = &answer->capacity;
  const QnCapacityPoint *peak = &c->points[c->peak];
  GString *text = g_string_new (NULL);
  g_autofree char *end = qn_units_format_full (units, QN_QUANTITY_LENGTH, c->end, 4);
  g_autofree char *at =
    qn_units_format_full (units, QN_QUANTITY_LENGTH, peak->control, 4);
  g_autofree char *mean =
    qn_units_format_full (units, QN_QUANTITY_LENGTH, peak->displacement, 4);
  qn_text_append (text, _ ("Block %s: controlled by ux"), answer->block);
  qn_text_append (
    text,
    _ ("\nblocks that take part: %zu, %.6g kg; participating mass M* %.6g kg, e* %.4f"),
    c->participating, c->moving_mass, c->mass, c->share);
  if (c->left_out > 0)
    qn_text_append (text,
                    _ ("\n%.1f %% of the mass that is not fixed does not take part"),
                    100 * c->left_out / (c->left_out + c->moving_mass));
  if (c->kinematic)
    tell_mechanism (text, answer);
  else
    qn_text_append (text, _ ("\npeak: multiplier %.5f at %s; d* %s, a* %.4g m/s2"),
                    peak->multiplier, at, mean, peak->acceleration);
  if (c->reaches_zero)
    qn_text_append (text, _ ("\nmultiplier back at zero: d0* %s"), end);
  else
    qn_text_append (text,
                    _ ("\nthe curve ends at d* %s, multiplier %.5f, before zero: its end "
                       "is taken as d0*. %s"),
                    end, c->points[c->count - 1].multiplier,
                    answer->reason != NULL ? answer->reason : "");
  if (c->share < SMALL_SHARE)
    qn_text_append (
      text,
      _ ("\ne* is small: the blocks move very differently, and a* of the codes is %.1f "
         "times what virtual work gives, multiplier times g"),
      1 / c->share);
  if (answer->has_spectrum)
    tell_spectrum (text, &answer->spectrum);
  if (answer->has_spectrum && c->elastic_period > 0)
    qn_text_append (text,
                    _ ("\nstanding on elastic joints: period %.4g s of the mode with the "
                       "most mass along x, %.6g kg; spectrum there %.4g m/s2"),
                    c->elastic_period, c->elastic_mass,
                    qn_spectrum_acceleration (&answer->spectrum, c->elastic_period));
  return g_string_free (text, FALSE);
}

/* ---- the path ---- */

typedef struct Search {
  QnModel *model;
  const QnContacts *contacts;
  QnProgressFunc report;
  void *report_data;
  char **reason;
  QnDiag *diag;
  double highest; /* multiplier */
  bool at_zero;
} Search;

/* Why nothing is concluded from an analysis; NULL: it ended for a reason of the structure. */
static char *
dup_fault (const QnModel *model, const QnResult *result)
{
  if (result->stop == QN_STOP_FACTORIZATIONS)
    return qn_text_printf (
      _ ("the curve was not followed to its end: max_factorizations (%d) was reached"),
      model->analysis.max_factorizations);
  if (result->stop == QN_STOP_TIME)
    return qn_text_printf (
      _ ("the curve was not followed to its end: max_seconds (%.4g) was reached"),
      model->analysis.max_seconds);
  return result->stop == QN_STOP_CHECK || result->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE
           ? qn_outcome_dup_cause (model, result)
           : NULL;
}

/* Ends a path once its multiplier, which has been above zero, is there again: how a block comes to lie on its side
 * is not asked. */
static bool
until_zero (const QnProgress *progress, void *data)
{
  Search *search = data;
  search->highest = fmax (search->highest, progress->multiplier);
  search->at_zero = search->model->analysis.procedure == QN_PROCEDURE_DISPLACEMENT
                    && search->highest > 0 && progress->multiplier <= 0;
  return !search->at_zero
         && (search->report == NULL || search->report (progress, search->report_data));
}

/* The result is there where OK. */
static QnStatus
analyse (const Search *search, QnResult *result)
{
  Search own = *search;
  const QnBudget end = { .model = search->model, .spent = QN_STOP_ZERO };
  QnStatus status = qn_analysis_run (search->model, search->contacts, until_zero, &own,
                                     result, search->diag);
  if (status != QN_ERROR_CANCELLED && own.at_zero)
    status = qn_budget_conclude (&end, status, search->contacts, result, search->diag);
  if (status != QN_OK || result->outcome != QN_OUTCOME_CANCELLED)
    return status;
  qn_result_clear (result);
  return QN_ERROR_CANCELLED;
}

/* Height from the lowest to the highest vertex, m. */
static double
height_of (const QnModel *model)
{
  QnBox box = qn_box_of_points (model->vertices, model->vertex_count);
  return box.max.y - box.min.y;
}

/* A mechanism of limit analysis, or the reason why there is none. */
static QnStatus
find_collapse (const Search *search, QnResult *result)
{
  search->model->analysis.procedure = QN_PROCEDURE_LIMIT;
  QnStatus status = analyse (search, result);
  if (status != QN_OK || result->mechanism != NULL)
    return status;
  *search->reason = dup_fault (search->model, result);
  if (*search->reason == NULL)
    *search->reason =
      g_strdup (_ ("limit analysis found no mechanism: name a control block"));
  return QN_OK;
}

/* Controls the block that moves furthest along the load in the mechanism of limit analysis. */
static QnStatus
choose_control (const Search *search)
{
  QnModel *model = search->model;
  QnResult result;
  QnStatus status = find_collapse (search, &result);
  if (status != QN_OK)
    return status;
  double farthest = 0;
  for (gsize b = 0; b < model->block_count && result.mechanism != NULL; b++) {
    double ux = result.mechanism[QN_DOF_COUNT * b + QN_DOF_UX];
    if (fabs (ux) <= fabs (farthest))
      continue;
    farthest = ux;
    model->analysis.control.block = (QnId) b;
  }
  qn_result_clear (&result);
  if (farthest == 0 && *search->reason == NULL)
    *search->reason =
      g_strdup (_ ("limit analysis moves no block aside: name a control block"));
  model->analysis.control.target = copysign (height_of (model), farthest);
  return QN_OK;
}

/* The result is there where OK and no reason is told. */
static QnStatus
follow (const Search *search, QnId control, QnResult *result)
{
  QnAnalysisSettings *analysis = &search->model->analysis;
  QnStatus status = QN_OK;
  gboolean own = control == QN_NONE && analysis->procedure == QN_PROCEDURE_DISPLACEMENT
                 && analysis->control.block != QN_NONE
                 && analysis->control.dof == QN_DOF_UX;
  if (control != QN_NONE) {
    /* The block is moved along the live load by the height of the structure. */
    analysis->control.block = control;
    analysis->control.target =
      copysign (height_of (search->model), qn_capacity_direction (search->model));
  } else if (!own)
    status = choose_control (search);
  if (status != QN_OK || *search->reason != NULL)
    return status;
  if (!own)
    analysis->increments = MAX (analysis->increments, INCREMENTS);
  analysis->control.node = QN_NONE;
  analysis->control.dof = QN_DOF_UX;
  analysis->procedure = QN_PROCEDURE_DISPLACEMENT;
  analysis->geometry = QN_GEOMETRY_NONLINEAR;
  analysis->max_multiplier = INFINITY;
  status = analyse (search, result);
  if (status == QN_OK)
    *search->reason = dup_fault (search->model, result);
  return status;
}

/* The same path with half the stiffness of all joints: what periods rest on. Where it has no end of its own
 * that is not known. */
static QnStatus
follow_softer (const Search *search, QnCapacity *capacity)
{
  QnModel *model = search->model;
  QnResult result;
  for (gsize i = 0; i < model->law_count; i++) {
    model->laws[i].kn *= 0.5;
    model->laws[i].ks *= 0.5;
  }
  QnStatus status = analyse (search, &result);
  for (gsize i = 0; i < model->law_count; i++) {
    model->laws[i].kn *= 2;
    model->laws[i].ks *= 2;
  }
  if (status != QN_OK)
    return status;
  g_autofree char *fault = dup_fault (model, &result);
  /* freed by the core */
  capacity->softer = fault == NULL ? malloc (sizeof *capacity->softer) : NULL;
  if (capacity->softer != NULL
      && qn_capacity_init (capacity->softer, model, &result, capacity->block, NULL)
           != QN_OK)
    g_clear_pointer (&capacity->softer, free);
  qn_result_clear (&result);
  return QN_OK;
}

static QnStatus
find_mechanism (const Search *search, QnCapacityAnswer *answer)
{
  QnResult result = { 0 };
  const QnResult *collapse = answer->collapse != NULL ? answer->collapse : &result;
  QnStatus status = collapse == &result ? find_collapse (search, &result) : QN_OK;
  if (status == QN_OK && answer->reason == NULL) {
    status = qn_capacity_init_kinematic (&answer->capacity, search->model,
                                         search->contacts, collapse, answer->control,
                                         answer->tie_strain, search->diag);
    if (status == QN_OK && !answer->capacity.reaches_zero)
      *search->reason = g_strdup (_ ("the parts of the mechanism move no further"));
  }
  qn_result_clear (&result);
  return status;
}

static QnStatus
find_path (const Search *search, QnCapacityAnswer *answer)
{
  QnResult result = { 0 };
  QnStatus status = follow (search, answer->control, &result);
  if (status == QN_OK && answer->reason == NULL) {
    status = qn_capacity_init (&answer->capacity, search->model, &result,
                               search->model->analysis.control.block, search->diag);
    if (status == QN_OK && !answer->capacity.reaches_zero)
      *search->reason = qn_outcome_dup_cause (search->model, &result);
  }
  qn_result_clear (&result);
  /* Only a check has a period. */
  return answer->capacity.count > 0 && answer->has_spectrum
           ? follow_softer (search, &answer->capacity)
           : status;
}

/* How many modes the main one is looked for in. */
#define MODES 10

/* The period of the structure that stands. Where it has none, as with blocks without mass, that is not
 * known. */
static QnStatus
find_elastic (const Search *search, QnCapacity *capacity)
{
  QnModes modes;
  QnResult result;
  QnDiag diag = { 0 };
  QnStatus status =
    qn_modal_run (search->model, search->contacts, QN_MODAL_DEAD_LOAD, MODES,
                  search->report, search->report_data, &modes, &result, &diag);
  gboolean cancelled = status == QN_ERROR_CANCELLED
                       || (status == QN_OK && result.outcome == QN_OUTCOME_CANCELLED);
  gsize main = status == QN_OK ? qn_modes_main (&modes) : 0;
  if (status == QN_OK && main < modes.count) {
    capacity->elastic_period = 2 * G_PI / modes.omega[main];
    capacity->elastic_mass = modes.masses[3 * main + 1];
  }
  qn_modes_clear (&modes);
  qn_result_clear (&result);
  return cancelled ? QN_ERROR_CANCELLED : QN_OK;
}

QnStatus
qn_capacity_answer_find (QnCapacityAnswer *answer, QnModel *model,
                         const QnContacts *contacts, QnProgressFunc report,
                         void *report_data, QnDiag *diag)
{
  const Search search = { model,           contacts, report, report_data,
                          &answer->reason, diag,     0,      false };
  answer->capacity = (QnCapacity){ 0 };
  if (model->stage_count > 0)
    return qn_refuse (diag, QN_PROBLEM_CAPACITY_STAGES, QN_ENTITY_STAGE, 0);
  QnStatus status =
    answer->kinematic ? find_mechanism (&search, answer) : find_path (&search, answer);
  if (status != QN_OK || answer->capacity.count == 0)
    return status;
  answer->block = g_strdup (model->blocks[answer->capacity.block].name);
  return answer->has_spectrum ? find_elastic (&search, &answer->capacity) : QN_OK;
}

void
qn_capacity_answer_clear (QnCapacityAnswer *answer)
{
  qn_capacity_clear (&answer->capacity);
  g_clear_pointer (&answer->block, g_free);
  g_clear_pointer (&answer->reason, g_free);
}

void
qn_capacity_answer_check (QnCapacityAnswer *answer)
{
  const QnCapacity *c = &answer->capacity;
  if (!answer->has_spectrum)
    return;
  for (int i = 0; i < QN_NTC_STATE_COUNT; i++)
    answer->states[QN_CAPACITY_SLV + i] =
      qn_capacity_check_ntc (c, &answer->spectrum, answer->confidence, (QnNtcState) i);
  if (c->kinematic) {
    answer->linear = qn_capacity_check_linear (c, &answer->spectrum, answer->confidence,
                                               answer->part_period);
    return;
  }
  answer->en = qn_capacity_en_demand (c, &answer->spectrum);
  for (int i = 0; i < QN_EN_STATE_COUNT; i++)
    answer->states[QN_CAPACITY_SD + i] =
      qn_capacity_check_en (c, &answer->en, (QnEnState) i);
}

/* ---- in a thread ---- */

typedef struct CapacityWork {
  QnModel model;
  QnContacts contacts;
  QnCapacityAnswer answer;
  QnDiag diag;
} CapacityWork;

static void
capacity_work_free (gpointer data)
{
  CapacityWork *work = data;
  qn_capacity_answer_clear (&work->answer);
  qn_contacts_clear (&work->contacts);
  qn_model_clear (&work->model);
  g_free (work);
}

static void
find_in_thread (GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
  CapacityWork *work = data;
  QnStatus status = qn_contacts_detect (&work->model, &work->contacts, &work->diag);
  if (status == QN_OK)
    status = qn_contacts_require_sound (&work->model, &work->contacts, &work->diag);
  if (status == QN_OK)
    status = qn_capacity_answer_find (&work->answer, &work->model, &work->contacts,
                                      qn_job_may_go_on, cancellable, &work->diag);
  g_autofree char *refused =
    status != QN_OK ? qn_explain_diag (&work->model, &work->diag) : NULL;
  if (status == QN_ERROR_CANCELLED)
    g_task_return_new_error (task, G_IO_ERROR, G_IO_ERROR_CANCELLED, "%s",
                             _ ("Cancelled"));
  else if (refused != NULL || work->answer.capacity.count == 0)
    g_task_return_new_error (task, QN_EDIT_ERROR, 0, "%s",
                             refused != NULL ? refused : work->answer.reason);
  else
    g_task_return_boolean (task, TRUE);
}

void
qn_capacity_find_async (const QnModel *model, const QnCapacityAnswer *asked,
                        GCancellable *cancellable, GAsyncReadyCallback callback,
                        gpointer user_data)
{
  CapacityWork *work = g_new0 (CapacityWork, 1);
  g_autoptr (GTask) task = g_task_new (NULL, cancellable, callback, user_data);
  g_task_set_check_cancellable (task, FALSE);
  work->answer.control = asked->control;
  work->answer.kinematic = asked->kinematic;
  work->answer.tie_strain = asked->tie_strain;
  work->answer.has_spectrum = TRUE; /* one may be given later */
  g_task_set_task_data (task, work, capacity_work_free);
  if (qn_model_copy (model, &work->model, &work->diag) != QN_OK) {
    GError *error = NULL;
    qn_edit_refuse_diag (&error, model, &work->diag);
    g_task_return_error (task, error);
    return;
  }
  g_task_run_in_thread (task, find_in_thread);
}

gboolean
qn_capacity_find_finish (GAsyncResult *result, QnCapacityAnswer *answer, GError **error)
{
  CapacityWork *work = g_task_get_task_data (G_TASK (result));
  if (!g_task_propagate_boolean (G_TASK (result), error))
    return FALSE;
  answer->capacity = work->answer.capacity;
  answer->block = g_steal_pointer (&work->answer.block);
  answer->reason = g_steal_pointer (&work->answer.reason);
  work->answer.capacity = (QnCapacity){ 0 };
  return TRUE;
}

/* ---- output ---- */

/* Points of the spectrum, evenly spread over periods from 0 to LONGEST s; it is shown up to so many times the
 * end of the curve. */
#define PERIODS 800
#define LONGEST 10.0
#define BEYOND  1.3

/* Adds the spectrum up to this displacement; its largest acceleration. */
static double
add_spectrum (QnPlot *plot, const QnSpectrum *spectrum, double farthest)
{
  double *x = qn_plot_keep (plot, g_new (double, PERIODS)), highest = 0;
  double *y = qn_plot_keep (plot, g_new (double, PERIODS));
  gsize count = 0;
  for (gsize i = 0; i < PERIODS; i++) {
    double period = LONGEST * (double) i / (PERIODS - 1);
    x[count] = qn_spectrum_displacement (spectrum, period);
    y[count] = qn_spectrum_acceleration (spectrum, period);
    if (x[count] > farthest)
      continue;
    highest = fmax (highest, y[count]);
    count++;
  }
  qn_plot_mark (plot, QN_MARKS_LINE, _ ("elastic spectrum"), 1, x, y, count)->dash =
    QN_USUAL_DASH;
  return highest;
}

/* The demand ends the line from the origin whose slope is that of its period, cut at `highest`, where
 * curve and spectrum end; the capacity is a point of the curve. */
static void
add_state (QnPlot *plot, const QnCapacityAnswer *answer, int k, double highest)
{
  const QnCapacityState *state = &answer->states[k];
  const char *name = check_name ((QnCapacityCheck) k);
  double omega = 2 * G_PI / state->period;
  double *x = qn_plot_keep (plot, g_new0 (double, 3));
  double *y = qn_plot_keep (plot, g_new0 (double, 3));
  x[1] = fmin (state->demand, highest / (omega * omega));
  y[1] = omega * omega * x[1];
  x[2] = state->capacity;
  y[2] = qn_capacity_acceleration (&answer->capacity, state->capacity);
  qn_plot_mark (plot, QN_MARKS_LINE,
                qn_plot_keep (plot, qn_text_printf (_ ("%s: demand"), name)), 2 + k, x, y,
                2);
  qn_plot_mark (plot, QN_MARKS_POINTS,
                qn_plot_keep (plot, qn_text_printf (_ ("%s: capacity"), name)), 2 + k,
                x + 2, y + 2, 1);
}

QnPlot *
qn_capacity_answer_plot (const QnCapacityAnswer *answer)
{
  const QnCapacity *c = &answer->capacity;
  const gsize states = (gsize) qn_capacity_answer_count_states (answer);
  QnPlot *plot =
    qn_plot_new (_ ("Spectral displacement (m)"), _ ("Spectral acceleration (m/s²)"));
  double *x = qn_plot_keep (plot, g_new (double, c->count));
  double *y = qn_plot_keep (plot, g_new (double, c->count));
  double farthest = c->end, highest = 0;
  for (gsize i = 0; i < c->count; i++) {
    x[i] = c->points[i].displacement;
    y[i] = c->points[i].acceleration;
    highest = fmax (highest, y[i]);
  }
  for (gsize k = 0; k < states; k++)
    if (!answer->states[k].refused)
      farthest = fmax (farthest, answer->states[k].demand);
  qn_plot_mark (plot, QN_MARKS_LINE, _ ("capacity curve"), 0, x, y, c->count);
  if (answer->has_spectrum)
    highest = fmax (highest, add_spectrum (plot, &answer->spectrum, BEYOND * farthest));
  for (gsize k = 0; k < states; k++)
    if (!answer->states[k].refused)
      add_state (plot, answer, (int) k, highest);
  return plot;
}

gboolean
qn_capacity_answer_export (const QnCapacityAnswer *answer, const char *title,
                           const QnMetadata *metadata, const char *path, GError **error)
{
  QnOutput output;
  if (qn_is_table (path))
    return qn_capacity_answer_write_csv (answer, path, error);
  qn_output_init (&output);
  g_autoptr (QnPlot) plot = qn_capacity_answer_plot (answer);
  plot->title = title;
  return qn_plot_export (plot, path, &output, metadata, error);
}

gboolean
qn_capacity_answer_write_csv (const QnCapacityAnswer *answer, const char *path,
                              GError **error)
{
  const QnCapacity *c = &answer->capacity;
  QnFileWriter *out = qn_file_writer_open (path);
  qn_file_writer_puts (out, "load multiplier,control displacement [m],spectral "
                            "displacement [m],spectral acceleration [m/s2]\n");
  for (size_t i = 0; i < c->count; i++) {
    const QnCapacityPoint *p = &c->points[i];
    qn_file_writer_csv (out, "%g,%g,%g,%g\n", p->multiplier, p->control, p->displacement,
                        p->acceleration);
  }
  return qn_file_writer_commit (out, error);
}

char *
qn_capacity_answer_dup_json (const QnCapacityAnswer *answer, const QnProject *project,
                             gsize *length)
{
  const QnCapacity *c = &answer->capacity;
  const QnLinearCheck *linear = &answer->linear;
  const int states = qn_capacity_answer_count_states (answer);
  const QnEnDemand *en = &answer->en;
  QnFileWriter *out = qn_file_writer_new_in_memory ();
  qn_file_writer_json (
    out,
    "{\n  \"format\": \"quoin-capacity\", \"version\": 1,\n  \"generator\": %s,\n"
    "  \"model\": %s,\n  \"source\": %s,\n  \"control_block\": %s,\n  "
    "\"participating_blocks\": %zu,\n"
    "  \"moving_mass\": %f,\n  \"participating_mass\": %f,\n  \"mass_share\": %f,\n"
    "  \"mass_left_out\": %f,\n  \"displacement_ratio\": %f,\n"
    "  \"peak_multiplier\": %f,\n  \"end_displacement\": %f,\n  \"reaches_zero\": %i",
    "quoin " QN_VERSION, project->name, c->kinematic ? "mechanism" : "path",
    project->model.blocks[c->block].name, c->participating, c->moving_mass, c->mass,
    c->share, c->left_out, c->ratio, c->points[c->peak].multiplier, c->end,
    c->reaches_zero);
  if (c->kinematic)
    qn_file_writer_json (out,
                         ",\n  \"alpha0\": %f, \"collapse_multiplier\": %f,\n"
                         "  \"works\": { \"dead\": %f, \"ties\": %f, \"live\": %f }, "
                         "\"ties_break\": %f",
                         c->activation, c->found, c->works[QN_WORK_DEAD],
                         c->works[QN_WORK_TIES], c->works[QN_WORK_LIVE],
                         c->broken > 0 ? c->broken : NAN);
  if (answer->has_spectrum) {
    qn_file_writer_json (out, ",\n  \"confidence\": %g", answer->confidence);
    if (c->elastic_period > 0)
      qn_file_writer_json (
        out, ",\n  \"elastic\": { \"period\": %f, \"mass\": %f, \"acceleration\": %f }",
        c->elastic_period, c->elastic_mass,
        qn_spectrum_acceleration (&answer->spectrum, c->elastic_period));
    if (c->kinematic)
      qn_file_writer_json (out,
                           ",\n  \"linear\": { \"acceleration\": %f, \"demand\": %f, "
                           "\"sld_ratio\": %f, \"q\": %f, \"slv_ratio\": %f, "
                           "\"en_demand\": %f, \"en_ratio\": %f }",
                           linear->capacity, linear->demand, linear->sld,
                           QN_NTC_BEHAVIOUR_FACTOR, linear->slv, linear->en_demand,
                           linear->en_ratio);
    else if (states > QN_CAPACITY_SD)
      qn_file_writer_json (
        out,
        ",\n  \"en_demand\": { \"yield_acceleration\": %f, "
        "\"mechanism_displacement\": %f, \"energy\": %f, \"yield_displacement\": %f, "
        "\"period\": %f, \"elastic_demand\": %f, \"q\": %f, \"target\": %f }",
        en->yield_acceleration, en->mechanism, en->energy, en->yield, en->period,
        en->elastic, en->q, en->target);
    qn_file_writer_puts (out, ",\n  \"checks\": [");
    for (int i = 0; i < states; i++) {
      const QnCapacityState *s = &answer->states[i];
      qn_file_writer_json (
        out,
        ",\n    { \"code\": %s, \"state\": %s, \"capacity\": %f, \"acceleration\": %f, "
        "\"period\": %f, \"period_half_stiffness\": %f, \"demand\": %f, \"ratio\": "
        "%f, \"met\": ",
        check_code ((QnCapacityCheck) i), check_name ((QnCapacityCheck) i), s->capacity,
        s->acceleration, s->period, s->softer, s->demand, s->ratio);
      qn_file_writer_puts (out, s->refused      ? "null }"
                                : s->ratio >= 1 ? "true }"
                                                : "false }");
    }
    qn_file_writer_puts (out, "\n  ]");
  }
  qn_file_writer_puts (out, ",\n  \"curve\": [");
  for (size_t i = 0; i < c->count; i++) {
    const QnCapacityPoint *p = &c->points[i];
    qn_file_writer_json (out,
                         ",\n    { \"multiplier\": %f, \"control\": %f, "
                         "\"displacement\": %f, \"acceleration\": %f }",
                         p->multiplier, p->control, p->displacement, p->acceleration);
  }
  qn_file_writer_puts (out, "\n  ]\n}\n");
  return qn_file_writer_steal (out, length);
}
