/* Sections of a report on results: each, their independent check, and several beside each other. */
#include "doc/view/report-parts.h"

#include "core/result/curve-motion.h"
#include "doc/document/run.h"
#include "doc/text/explain.h"
#include "doc/view/ground-preview.h"
#include "doc/view/sheet.h"
#include "io/text/mechanism-text.h"
#include "io/text/outcome-text.h"
#include "render/drawing/text.h"
#include "render/scene/reading.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* The picture of a result: how it fails, or else how it has moved. */
bool
qn_report_choose_picture (QnFigure *figure, const QnReportRun *run)
{
  const QnResult *result = &run->file.result;
  if (result->mechanism == NULL && result->step_count == 0)
    return false;
  qn_figure_init (figure, &run->project->model, run->contacts, result,
                  qn_view_of_result (result));
  figure->title = run->name;
  return true;
}

static bool
take_curve (const QnReportRun *run, QnCurve *curve)
{
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file.result;
  QnCurveMotion motion = qn_result_curve_motion (model, result);
  if (motion.body == QN_NONE || result->step_count < 2 || result->limit.given)
    return false;
  qn_curve_from_result (curve, model, result, motion);
  curve->label = run->name;
  qn_curve_cut_runaway (curve);
  return true;
}

/* The figures of a result: named first, with the numbers that they will have, then drawn. */
typedef struct Pictures {
  QnPages *pages;
  const QnReportRun *run;
  GString *named; /* NULL: they are drawn */
  int number;     /* of the next that is named */
  GError **error;
} Pictures;

/* Whether the next one is only named. */
static bool
name_figure (Pictures *p, const char *title)
{
  if (p->named != NULL)
    g_string_append_printf (p->named, _ ("%s: figure\u00a0%d. "), title, p->number++);
  return p->named != NULL;
}

static bool
show_field (Pictures *p, QnView view, QnField field, int step, const char *title)
{
  QnFigure figure;
  if (name_figure (p, title))
    return true;
  qn_figure_init (&figure, &p->run->project->model, p->run->contacts,
                  &p->run->file.result, view);
  figure.options.field = field;
  if (step >= 0)
    figure.options.step = step;
  figure.title = title;
  return qn_pages_figures (p->pages, &figure, 1, 1, 0.42, p->error);
}

static bool
show_view (Pictures *p, QnView view, const char *title)
{
  return show_field (p, view, QN_FIELD_NONE, -1, title);
}

static void
show_plot (Pictures *p, QnPlot *plot, const char *title, double share)
{
  plot->title = title;
  if (!name_figure (p, title))
    qn_pages_plot (p->pages, plot, share);
}

/* Of members and walls of cells: stresses, and cracks where a law has them. */
static bool
show_cells (Pictures *p)
{
  const QnReportRun *run = p->run;
  const QnLaw *laws = run->project->model.laws;
  bool cells = false, cracks = false;
  for (size_t f = 0; f < run->contacts->face_count; f++) {
    const QnContactFace *face = &run->contacts->faces[f];
    const QnLaw *a = &laws[face->law_a], *b = &laws[face->law_b];
    bool inside = a->basis == QN_BASIS_MATERIAL && b->basis == QN_BASIS_MATERIAL;
    cells |= inside;
    cracks |= inside && (qn_law_softens (a->kind) || qn_law_softens (b->kind));
  }
  return !cells
         || (show_field (p, QN_VIEW_DEFORMED, QN_FIELD_PRINCIPAL, -1,
                         _ ("Principal stresses"))
             && (!cracks
                 || show_field (p, QN_VIEW_DEFORMED, QN_FIELD_CRACK, -1, _ ("Cracks"))));
}

/* The widest crack at a step. */
static QnCrack
find_crack (const QnReportRun *run, size_t step)
{
  g_autoptr (GArray) cracks =
    qn_result_cracks (&run->project->model, run->contacts, &run->file.result, step);
  return cracks->len > 0 ? g_array_index (cracks, QnCrack, 0) : (QnCrack){ 0 };
}

static void
tell_crack (QnPages *pages, const QnReportRun *run, QnCrack crack, const char *which,
            QnUnits units)
{
  const QnBlock *blocks = run->project->model.blocks;
  g_autofree char *size =
    qn_units_format_full (units, QN_QUANTITY_LENGTH, crack.width, 3);
  qn_report_say (pages, _ ("%s: %s, between %s and %s."), which, size,
                 blocks[crack.face->a].name, blocks[crack.face->b].name);
}

/* Part of its collapse multiplier up to which a structure in linear geometry has not begun to move on. */
#define BEFORE_COLLAPSE 0.97

/* Of a settlement: what its support takes, and the widest crack, over all steps; of long paths at even
 * distances. */
static void
write_settlement (QnPages *pages, const QnReportRun *run, const QnLoad *settlement,
                  const QnCrack *cracks, QnUnits units)
{
  const QnResult *result = &run->file.result;
  const QnModel *model = &run->project->model;
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  QnCurveMotion motion = qn_result_curve_motion (model, result);
  const bool turns = motion.dof == QN_DOF_RZ;
  const QnQuantity moved = turns ? QN_QUANTITY_ANGLE : QN_QUANTITY_LENGTH;
  const QnQuantity taken = turns ? QN_QUANTITY_MOMENT : QN_QUANTITY_FORCE;
  size_t rows = MIN (result->step_count, QN_REPORT_ROWS);
  qn_report_row (cells, units, "uuuw", _ ("Settlement (%s)"), moved, _ ("Reaction (%s)"),
                 taken, _ ("Widest crack (%s)"), QN_QUANTITY_LENGTH, _ ("Between"));
  for (size_t r = 0; r < rows; r++) {
    size_t step = rows > 1 ? r * (result->step_count - 1) / (rows - 1) : 0;
    const QnCrack *crack = &cracks[step];
    qn_report_row (
      cells, units, "qqqo", moved, qn_curve_motion_at (result, motion, step), 4, taken,
      qn_result_settlement_reaction (model, result, settlement, step), 5,
      QN_QUANTITY_LENGTH, crack->width, 3,
      crack->face != NULL ? qn_report_dup_between (model, crack->face->a, crack->face->b)
                          : g_strdup ("–"));
  }
  qn_report_table (pages, cells, 4);
}

/* The widest of these cracks, below a sentence. */
static void
write_widest (QnPages *pages, const QnModel *model, const GArray *cracks,
              const char *sentence, QnUnits units)
{
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  qn_report_row (cells, units, "wuuuu", _ ("Between"), _ ("Widest crack (%s)"),
                 QN_QUANTITY_LENGTH, _ ("Mean (%s)"), QN_QUANTITY_LENGTH, _ ("x (%s)"),
                 QN_QUANTITY_LENGTH, _ ("y (%s)"), QN_QUANTITY_LENGTH);
  for (guint i = 0; i < MIN (cracks->len, QN_REPORT_CRACKS); i++) {
    const QnCrack *crack = &g_array_index (cracks, QnCrack, i);
    qn_report_row (cells, units, "oqqqq",
                   qn_report_dup_between (model, crack->face->a, crack->face->b),
                   QN_QUANTITY_LENGTH, crack->width, 3, QN_QUANTITY_LENGTH, crack->mean,
                   3, QN_QUANTITY_LENGTH, crack->at.x, 4, QN_QUANTITY_LENGTH, crack->at.y,
                   4);
  }
  qn_report_say (pages, "%s", sentence);
  qn_report_table (pages, cells, 5);
}

/* At a step, joint by joint, and where these are fewer by whole lines of joints. */
static void
write_joints (QnPages *pages, const QnReportRun *run, size_t step, QnUnits units)
{
  const QnModel *model = &run->project->model;
  g_autoptr (GArray) cracks =
    qn_result_cracks (model, run->contacts, &run->file.result, step);
  g_autoptr (GArray) lines = qn_cracks_by_line (run->contacts, cracks, NULL);
  g_autofree char *joints =
    g_strdup_printf (ngettext ("%u joint has opened:",
                               "%u joints have opened; the widest of them:", cracks->len),
                     cracks->len);
  g_autofree char *whole = g_strdup_printf (
    _ (
      "By whole lines of joints (%u): the widest crack of each, and the mean over all of "
      "its joints:"),
    lines->len);
  write_widest (pages, model, cracks, joints, units);
  if (lines->len < cracks->len)
    write_widest (pages, model, lines, whole, units);
}

static void
write_cracks (QnPages *pages, const QnReportRun *run, QnUnits given)
{
  const QnResult *result = &run->file.result;
  QnUnits units = qn_units_of_motion (given);
  if (result->step_count == 0 || result->limit.given)
    return;
  g_autofree QnCrack *cracks = g_new (QnCrack, result->step_count);
  /* The last step of which displacements are not how far a mechanism was followed. */
  size_t end = result->step_count - 1;
  if (run->project->model.analysis.geometry == QN_GEOMETRY_LINEAR
      && result->outcome == QN_OUTCOME_COLLAPSE && result->has_collapse_multiplier)
    while (end > 0
           && result->steps[end].multiplier
                > BEFORE_COLLAPSE * result->collapse_multiplier)
      end--;
  QnCrack widest = { 0 }, *last = &cracks[end];
  for (size_t s = 0; s < result->step_count; s++) {
    cracks[s] = find_crack (run, s);
    if (s <= end && cracks[s].width > widest.width)
      widest = cracks[s];
  }
  if (last->width > 0)
    tell_crack (
      pages, run, *last,
      end + 1 == result->step_count
        ? _ ("Widest crack at the last step")
        : _ ("Widest crack before collapse, beyond which linear geometry sets no "
             "limit to the motion"),
      units);
  if (widest.width > last->width)
    tell_crack (pages, run, widest, _ ("Widest crack of all steps"), units);
  const QnLoad *settlement = qn_result_settlement (&run->project->model, result);
  if (settlement != NULL)
    write_settlement (pages, run, settlement, cracks, units);
  if (settlement != NULL && last->width > 0)
    write_joints (pages, run, end, units);
}

static void
add_stage (GPtrArray *cells, const char *name, const QnStageFigures *figures,
           gboolean ends)
{
  qn_report_row (cells, QN_UNITS_SI, "wnnnn", name, "%.5g",
                 ends ? figures->multiplier : (double) NAN, "%.5g", figures->lowest,
                 "%.5g", figures->highest, "%.5g", figures->work);
}

/* Where stages led, and what they took; the same of cycles. */
static void
write_stages (QnPages *pages, const QnReportRun *run)
{
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file.result;
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  for (int32_t i = 1; i <= result->stage && (size_t) i <= model->stage_count; i++) {
    QnStageFigures figures;
    int32_t start = qn_result_cycle_start (model, result, i);
    g_autofree char *name = qn_stage_dup_name (model, i);
    if (cells->len == 0)
      qn_report_row (cells, QN_UNITS_SI, "wwwww", _ ("Stage"), _ ("Ends at multiplier"),
                     _ ("Lowest"), _ ("Highest"), _ ("Work (J)"));
    if (qn_result_stage_figures (model, result, i, i, &figures))
      add_stage (cells, name, &figures, TRUE);
    if (start == 0 || !qn_result_stage_figures (model, result, start, i, &figures))
      continue;
    g_autofree char *cycle =
      g_strdup_printf (_ ("Cycle %d"), qn_stage_cycle (&model->stages[i - 1]));
    add_stage (cells, cycle, &figures, FALSE);
  }
  if (cells->len > 0)
    qn_report_table (pages, cells, 5);
}

/* The largest force of every tie, and what it uses of its strength. */
static void
write_tie_forces (QnPages *pages, const QnReportRun *run, QnUnits units)
{
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file.result;
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  if (model->tie_count == 0 || result->tie_count != model->tie_count)
    return;
  qn_report_row (cells, units, "wuuww", _ ("Tie"), _ ("Largest force (%s)"),
                 QN_QUANTITY_FORCE, _ ("Strength (%s)"), QN_QUANTITY_FORCE,
                 _ ("Used (%)"), _ ("State"));
  for (size_t i = 0; i < model->tie_count; i++) {
    const QnTie *tie = &model->ties[i];
    gssize step = qn_tie_worst_step (result, i);
    if (step < 0)
      return;
    const QnTieResult *at = &qn_result_step_ties (result, (gsize) step)[i];
    gboolean limited = isfinite (qn_tie_strength (tie));
    qn_report_row (cells, units, "wqqnw", tie->name, QN_QUANTITY_FORCE, at->force, 4,
                   QN_QUANTITY_FORCE, qn_tie_strength (tie), 4, "%.3g",
                   limited ? 100 * qn_tie_utilisation (tie, at->force) : (double) NAN,
                   qn_tie_state_text (at->state));
  }
  qn_report_table (pages, cells, 5);
}

/* What shakes the structure, how it stands when it has moved farthest, and its energies. */
static bool
show_history (Pictures *p)
{
  const QnModel *model = &p->run->project->model;
  const QnResult *result = &p->run->file.result;
  for (size_t i = 0; i < model->ground_count; i++) {
    QnGroundPreview ground;
    qn_ground_preview_init (&ground, model, i, QN_GROUND_ACCELERATION);
    if (ground.count > 0) {
      g_autoptr (QnPlot) plot = qn_ground_preview_plot (&ground, QN_GROUND_ACCELERATION);
      show_plot (p, plot, _ ("Ground motion"), 0.25);
    }
    qn_ground_preview_clear (&ground);
  }
  if (isfinite (result->history.peak_time) && result->step_count > 0
      && !show_field (p, QN_VIEW_DEFORMED, QN_FIELD_NONE,
                      qn_result_step_at (result, result->history.peak_time),
                      _ ("At its largest displacement")))
    return false;
  if (result->history.row_count > 0) {
    const char *unit;
    g_autoptr (QnPlot) energies = qn_energy_plot (&result->history, &unit);
    show_plot (p, energies, _ ("Energies"), 0.3);
  }
  return true;
}

static bool
show_pictures (Pictures *p)
{
  const QnResult *result = &p->run->file.result;
  const bool mode = result->vibration.mode > 0 || result->stability == QN_STABILITY_LOST;
  QnCurve curve;
  if (result->mechanism != NULL
      && !show_view (p, QN_VIEW_MECHANISM, mode ? _ ("Mode") : _ ("Mechanism")))
    return false;
  if (result->mechanism == NULL && result->step_count > 0
      && !show_view (p, QN_VIEW_DEFORMED, _ ("Displacements")))
    return false;
  if (take_curve (p->run, &curve)) {
    g_autoptr (QnPlot) plot = qn_curve_plot (&curve, 1, NULL, 0);
    show_plot (p, plot,
               curve.in_time   ? _ ("Displacement in time")
               : curve.settles ? _ ("Reaction over settlement")
                               : _ ("Load–displacement curve"),
               0.4);
    qn_curve_clear (&curve);
  }
  return (result->history.width == 0 || show_history (p))
         && (result->beam_forces == NULL
             || show_view (p, QN_VIEW_DIAGRAMS, _ ("Section forces")))
         && (!qn_report_has_forces (p->run) || p->run->contacts->face_count == 0
             || (show_view (p, QN_VIEW_FORCES, _ ("Contact forces"))
                 && (result->limit.given || show_cells (p))));
}

bool
qn_report_write_result (QnPages *pages, const QnReportRun *run, QnUnits units,
                        GError **error)
{
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file.result;
  g_autofree char *title = g_strdup_printf (_ ("Result: %s"), run->name);
  qn_pages_heading (pages, title);
  g_autofree char *overrides =
    run->file.overrides != NULL ? g_strjoinv (", ", run->file.overrides) : NULL;
  if (overrides != NULL) {
    qn_report_say (pages, _ ("Computed with %s."), overrides);
  }
  g_autofree char *outcome = qn_explain_outcome (model, result);
  qn_pages_paragraph (pages, outcome);
  g_autofree char *interval = qn_outcome_dup_interval (model, result);
  if (interval != NULL)
    qn_pages_paragraph (pages, interval);
  write_stages (pages, run);
  write_cracks (pages, run, units);
  write_tie_forces (pages, run, units);
  g_autofree char *words = qn_explain_mechanism (model, run->contacts, result);
  if (words != NULL)
    qn_pages_paragraph (pages, words);
  for (size_t i = 0; result->history.width > 0 && i < model->ground_count; i++)
    qn_report_write_ground_motion (pages, &model->ground[i]);
  Pictures pictures = { pages, run, g_string_new (NULL), qn_pages_next_figure (pages),
                        error };
  g_autoptr (GString) named = pictures.named;
  show_pictures (&pictures);
  if (named->len > 0)
    qn_pages_paragraph (pages, named->str);
  pictures.named = NULL;
  return show_pictures (&pictures);
}

void
qn_report_write_certificate (QnPages *pages, const QnReport *report)
{
  qn_pages_heading (pages, _ ("Independent Check"));
  qn_pages_paragraph (
    pages,
    _ ("Of the forces in the files alone, without the solver: free blocks and nodes "
       "in equilibrium, joints and sections within their strength."));
  for (size_t i = 0; i < report->run_count; i++) {
    const QnReportRun *run = &report->runs[i];
    g_autofree char *text = NULL;
    if (run->unchecked != NULL) {
      text = g_strdup_printf (_ ("%s: not checked: %s"), run->name, run->unchecked);
    } else {
      const QnLastForces *last = &run->faults.last;
      g_autofree char *multiplier = qn_label_number ("%.6g", last->multiplier);
      g_autofree char *balance = qn_label_number ("%.1e", last->out_of_balance);
      g_autofree char *excess = qn_label_number ("%.1e", last->yield_violation);
      text = g_strdup_printf (
        run->faults.count == 0
          ? _ ("%s: passed at a load multiplier of %s; out of balance by %s of "
               "the largest force, strength exceeded by %s of the largest "
               "contact force.")
          : _ ("%s: failed at a load multiplier of %s; out of balance by %s of "
               "the largest force, strength exceeded by %s of the largest "
               "contact force."),
        run->name, multiplier, balance, excess);
    }
    qn_pages_paragraph (pages, text);
  }
}

bool
qn_report_write_comparison (QnPages *pages, const QnReport *report, GError **error)
{
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  g_autofree QnCurve *curves = g_new0 (QnCurve, report->run_count);
  size_t count = 0;
  qn_pages_heading (pages, _ ("Comparison"));
  qn_report_row (cells, QN_UNITS_SI, "wwwwwww", _ ("Result"), _ ("Outcome"),
                 _ ("Multiplier"), _ ("First limit"), _ ("Lower bound"),
                 _ ("Upper bound"), _ ("Associative bound"));
  for (size_t i = 0; i < report->run_count; i++) {
    const QnResult *r = &report->runs[i].file.result;
    qn_report_row (
      cells, QN_UNITS_SI, "wwnnnnn", report->runs[i].name, qn_explain_outcome_label (r),
      "%.6g", r->has_collapse_multiplier ? r->collapse_multiplier : (double) NAN, "%.6g",
      r->has_first_limit_multiplier ? r->first_limit_multiplier : (double) NAN, "%.6g",
      r->limit.given ? r->limit.lower_bound : (double) NAN, "%.6g",
      r->limit.given ? r->limit.upper_bound : (double) NAN, "%.6g",
      r->has_associative_bound ? r->associative_bound : (double) NAN);
    count += take_curve (&report->runs[i], &curves[count]);
  }
  qn_report_table (pages, cells, 2 + 5);
  qn_report_say (pages, _ ("Pictures: from figure\u00a0%d on."),
                 qn_pages_next_figure (pages));
  /* Those that share axes in one plot, where there are several. */
  g_autofree QnCurve *alike = g_new0 (QnCurve, count + 1);
  for (size_t first = 0; first < count; first++) {
    size_t found = 0;
    bool told = false;
    for (size_t i = 0; i < count; i++)
      if (qn_curve_shares_axes (&curves[i], &curves[first])) {
        told |= i < first;
        alike[found++] = curves[i];
      }
    if (found < 2 || told)
      continue;
    g_autoptr (QnPlot) plot = qn_curve_plot (alike, found, NULL, 0);
    plot->title = curves[first].in_time   ? _ ("Displacement in time")
                  : curves[first].settles ? _ ("Reactions over settlement")
                                          : _ ("Load–displacement curves");
    qn_pages_plot (pages, plot, 0.45);
  }
  for (size_t i = 0; i < count; i++)
    qn_curve_clear (&curves[i]);

  g_autofree QnFigure *figures = g_new0 (QnFigure, report->run_count);
  size_t drawn = 0;
  for (size_t i = 0; i < report->run_count; i++)
    drawn += qn_report_choose_picture (&figures[drawn], &report->runs[i]);
  return qn_pages_figures (pages, figures, drawn, 2, 0.35, error);
}
