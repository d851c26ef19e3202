#include "doc/view/report.h"

#include "core/base/integer.h"
#include "core/model/bar.h"
#include "doc/text/count-text.h"
#include "doc/text/explain.h"
#include "doc/text/law-text.h"
#include "doc/view/energy-plot.h"
#include "doc/view/ground-preview.h"
#include "doc/view/inspect.h"
#include "doc/view/load-text.h"
#include "doc/view/pair-text.h"
#include "io/text/outcome-text.h"
#include "io/text/tie-text.h"
#include "render/drawing/camera.h"
#include "render/drawing/text.h"
#include "render/figure/curve-plot.h"
#include "render/scene/motion.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

/* Rows of a table of joints unless all are requested; the others are counted. */
#define MOST_ROWS 120

/* A table that grows by cells. */
static void
add_cell (GPtrArray *cells, char *text)
{
  g_ptr_array_add (cells, text);
}

static void
add_number (GPtrArray *cells, const char *format, double value)
{
  add_cell (cells, isfinite (value) ? qn_label_number (format, value) : g_strdup ("–"));
}

static void
write_table (QnPages *pages, GPtrArray *cells, size_t columns)
{
  qn_pages_table (pages, (const char *const *) cells->pdata, cells->len / columns,
                  columns);
}

static const char *
title_of (const QnProject *project)
{
  return project->model.title != NULL && *project->model.title != '\0'
           ? project->model.title
           : project->name;
}

static char *
dup_quantity (const QnReport *report, QnQuantity quantity, double value)
{
  return qn_label_power (qn_units_format_full (report->units, quantity, value, 5));
}

/* Box around the blocks and the weight of those that are free. */
static void
measure (const QnModel *model, QnVec2 *size, double *weight)
{
  QnBox box = QN_BOX_EMPTY;
  *weight = 0;
  for (size_t i = 0; i < model->vertex_count; i++)
    qn_box_add_point (&box, model->vertices[i]);
  for (size_t i = 0; i < model->node_count; i++)
    qn_box_add_point (&box, model->nodes[i].at);
  for (size_t b = 0; b < model->block_count; b++)
    *weight += model->blocks[b].support[QN_DOF_UY] ? 0 : model->blocks[b].weight;
  *size = box.min.x <= box.max.x ? qn_vec2_sub (box.max, box.min) : qn_vec2 (0, 0);
}

/* ---- sections of the project ---- */

/* The picture of a result: how it fails, or else how it has moved. */
static bool
choose_picture (QnFigure *figure, const QnReportRun *run)
{
  const QnResult *result = &run->file->result;
  if (result->mechanism == NULL && result->step_count == 0)
    return false;
  qn_figure_init (figure, &run->project->model, run->contacts, result,
                  result->mechanism != NULL ? QN_VIEW_MECHANISM : QN_VIEW_DEFORMED);
  figure->title = run->name;
  return true;
}

/* The day, of SOURCE_DATE_EPOCH where it is set: then equal input gives equal bytes on all days. */
static char *
dup_date (void)
{
  const char *epoch = g_getenv ("SOURCE_DATE_EPOCH");
  g_autoptr (GDateTime) now =
    epoch != NULL ? g_date_time_new_from_unix_utc (g_ascii_strtoll (epoch, NULL, 10))
                  : g_date_time_new_now_local ();
  return now != NULL ? g_date_time_format (now, "%Y-%m-%d") : g_strdup ("–");
}

/* Whether two runs are one, computed twice: the same project and settings, and the same last step. */
static gboolean
same_run (const QnReportRun *a, const QnReportRun *b)
{
  const QnResult *x = &a->file->result, *y = &b->file->result;
  gsize rows = QN_DOF_COUNT * qn_result_body_count (x);
  const char *const none[] = { NULL };
  char **p = a->file->overrides, **q = b->file->overrides;
  return g_strcmp0 (a->file->model_sha256, b->file->model_sha256) == 0
         && g_strv_equal (p != NULL ? (const char *const *) p : none,
                          q != NULL ? (const char *const *) q : none)
         && x->outcome == y->outcome && x->step_count == y->step_count
         && x->limit.given == y->limit.given && x->limit.flow == y->limit.flow
         && rows == QN_DOF_COUNT * qn_result_body_count (y)
         && (x->step_count == 0
             || memcmp (qn_result_step_displacements (x, x->step_count - 1),
                        qn_result_step_displacements (y, y->step_count - 1),
                        rows * sizeof (double))
                  == 0);
}

/* What is asked of a project. */
static const char *
question (const QnModel *model)
{
  if (model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    return _ ("Question: how does the structure move in time, and does it overturn?");
  if (model->stage_count == 0 && !qn_model_sets_have_force (model, 1))
    return _ ("Question: what do the settlements of the supports do to the structure?");
  return _ ("Question: which multiple of the live load does the structure carry?");
}

/* By what an answer was found, and whether it was checked. */
static char *
dup_basis (const QnReportRun *run)
{
  const QnModel *model = &run->project->model;
  const char *geometry =
    model->analysis.geometry == QN_GEOMETRY_LINEAR ? _ ("linear") : _ ("nonlinear");
  const char *check = run->check == NULL ? _ ("not checked")
                      : run->passes      ? _ ("the independent check is passed")
                                         : _ ("the independent check fails");
  return g_strdup_printf (
    _ ("It rests on %s in %s geometry, on the laws and the pairs of the "
       "joints as given below; %s."),
    qn_explain_procedure (&model->analysis), geometry, check);
}

/* The answer of a run, with the range that it lies in. */
static void
write_answer (QnPages *pages, const QnReportRun *run)
{
  const QnResult *result = &run->file->result;
  g_autofree char *text = qn_explain_outcome (&run->project->model, result);
  g_autofree char *line = g_strdup_printf ("%s: %s", run->name, text);
  g_autofree char *interval = qn_outcome_dup_interval (&run->project->model, result);
  g_autofree char *basis = dup_basis (run);
  qn_pages_paragraph (pages, line);
  if (interval != NULL)
    qn_pages_paragraph (pages, interval);
  qn_pages_paragraph (pages, basis);
}

/* A page of its own: title, author, question and picture, the answers, and of what, by what and when it was
 * made. */
static bool
write_title (QnPages *pages, const QnReport *report, GError **error)
{
  QnFigure figure;
  qn_pages_title (pages, title_of (report->project));
  if (report->plan.author != NULL)
    qn_pages_paragraph (pages, report->plan.author);
  if (report->plan.text != NULL)
    qn_pages_paragraph (pages, report->plan.text);
  if (report->run_count > 0)
    qn_pages_paragraph (pages, question (&report->project->model));
  if (report->run_count == 0 || !choose_picture (&figure, &report->runs[0])) {
    qn_figure_init (&figure, &report->project->model, report->contacts, NULL,
                    QN_VIEW_MODEL);
    figure.title = "";
  }
  if (!qn_pages_figure (pages, &figure, 0.5, error))
    return false;
  for (size_t i = 0; i < report->run_count; i++)
    write_answer (pages, &report->runs[i]);
  g_autofree char *name = g_path_get_basename (report->project->name);
  g_autofree char *date = dup_date ();
  g_autofree char *by =
    g_strdup_printf (_ ("%s, made by %s on %s"), name, report->generator, date);
  g_autofree char *foot =
    report->project->sha256 != NULL
      ? g_strdup_printf ("%s\nSHA-256 %s", by, report->project->sha256)
      : g_strdup (by);
  qn_pages_foot (pages, foot);
  return true;
}

static bool
write_model (QnPages *pages, const QnReport *report, GError **error)
{
  const QnModel *model = &report->project->model;
  QnFigure figure;
  QnVec2 size;
  double weight;
  qn_pages_heading (pages, _ ("Model"));
  measure (model, &size, &weight);
  const QnCount counts[] = { { QN_COUNTED_BLOCKS, model->block_count },
                             { QN_COUNTED_FACES, report->contacts->face_count },
                             { QN_COUNTED_PAIRS, report->contacts->pair_count },
                             { QN_COUNTED_BEAMS, model->beam_count } };
  gsize first = model->block_count > 0 || model->beam_count == 0 ? 0 : 3;
  gsize end = G_N_ELEMENTS (counts) - (model->beam_count > 0 ? 0 : 1);
  g_autofree char *number = qn_counts_dup_text (counts + first, end - first, ", ");
  g_autofree char *width = dup_quantity (report, QN_QUANTITY_LENGTH, size.x);
  g_autofree char *height = dup_quantity (report, QN_QUANTITY_LENGTH, size.y);
  g_autofree char *force = dup_quantity (report, QN_QUANTITY_FORCE, weight);
  g_autofree char *text =
    first > 0 ? g_strdup_printf (_ ("%s; %s wide, %s high."), number, width, height)
              : g_strdup_printf (_ ("%s; %s wide, %s high; free blocks weigh %s."),
                                 number, width, height, force);
  qn_pages_paragraph (pages, text);
  qn_figure_init (&figure, model, report->contacts, NULL, QN_VIEW_MODEL);
  figure.options.dimensions = figure.options.loads = true;
  figure.title = "";
  figure.caption = "";
  return qn_pages_figure (pages, &figure, 0.55, error);
}

static char *
dup_law_numbers (const QnLaw *law, QnUnits units)
{
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
  g_autoptr (GString) text = g_string_new (NULL);
  g_autofree char *kn = qn_label_power (
    qn_units_format_full (units, qn_law_quantity ("kn", law->basis), law->kn, 6));
  g_autofree char *ks = qn_label_power (
    qn_units_format_full (units, qn_law_quantity ("ks", law->basis), law->ks, 6));
  if (law->elasticity > 0) {
    g_autofree char *E = qn_label_power (qn_units_format_full (
      units, qn_law_quantity ("elasticity", law->basis), law->elasticity, 6));
    g_string_append_printf (text,
                            law->arrangement == QN_ARRANGEMENT_GRID
                              ? _ ("E = %s, ν = %.6g, blocks in a grid: ")
                              : _ ("E = %s, ν = %.6g, blocks in a chain: "),
                            E, law->poisson);
  }
  g_string_append_printf (text, "kn = %s, ks = %s", kn, ks);
  for (size_t i = 0; i < count; i++) {
    double value = qn_law_get (law, &parameters[i]);
    if (!isfinite (value))
      continue;
    g_autofree char *number = qn_units_format_full (
      units, qn_law_quantity (parameters[i].key, law->basis), value, 6);
    number = qn_label_power (number);
    g_string_append_printf (text, ", %s = %s", parameters[i].key, number);
  }
  return g_strdup (text->str);
}

/* ", E = 30000 MPa": what a section has that is not 0. */
static void
append_number (GString *text, const char *symbol, QnQuantity quantity, double value,
               const char *unit)
{
  /* Strengths in MPa, sides in mm, moments in kN·m. */
  const QnUnits units = { .length = QN_LENGTH_MM,
                          .force = QN_FORCE_KN,
                          .stress = QN_STRESS_MPA };
  if (value == 0)
    return;
  g_autofree char *number =
    qn_label_power (qn_units_format_full (units, quantity, value, 6));
  g_string_append_printf (text, "%s%s = %s%s", text->len > 0 ? ", " : "", symbol, number,
                          unit);
}

static char *
dup_section_numbers (const QnSection *section)
{
  g_autoptr (GString) text = g_string_new (NULL);
  append_number (text, "E", QN_QUANTITY_STRESS, section->young, "");
  append_number (text, "G", QN_QUANTITY_STRESS, section->shear_modulus, "");
  if (section->shear_modulus == 0)
    append_number (text, "ν", QN_QUANTITY_NUMBER, section->poisson, "");
  append_number (text, "b", QN_QUANTITY_LENGTH, section->width, "");
  append_number (text, "h", QN_QUANTITY_LENGTH, section->height, "");
  append_number (text, "A", QN_QUANTITY_NUMBER, section->area, "\u00a0m²");
  append_number (text, "I", QN_QUANTITY_NUMBER, section->inertia, "\u00a0m⁴");
  append_number (text, "k", QN_QUANTITY_NUMBER, section->shear_factor, "");
  append_number (text, "fy", QN_QUANTITY_STRESS, section->yield, "");
  append_number (text, "Mp", QN_QUANTITY_MOMENT, qn_section_plastic_moment (section), "");
  append_number (text, "γ", QN_QUANTITY_UNIT_WEIGHT, section->unit_weight, "");
  return g_strdup (text->str);
}

static void
write_sections (QnPages *pages, const QnModel *model)
{
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  if (model->beam_count == 0)
    return;
  add_cell (cells, g_strdup (_ ("Section")));
  add_cell (cells, g_strdup (_ ("Beams")));
  add_cell (cells, g_strdup (_ ("Numbers")));
  for (size_t i = 0; i < model->section_count; i++) {
    size_t users = 0;
    for (size_t k = 0; k < model->beam_count; k++)
      users += model->beams[k].section == (QnId) i;
    add_cell (cells, g_strdup (model->sections[i].name));
    add_cell (cells, g_strdup_printf ("%zu", users));
    add_cell (cells, dup_section_numbers (&model->sections[i]));
  }
  write_table (pages, cells, 3);
}

static void
write_bars (QnPages *pages, const QnReport *report)
{
  const QnModel *model = &report->project->model;
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  if (model->bar_count == 0)
    return;
  add_cell (cells, g_strdup (_ ("Reinforcing bars")));
  add_cell (cells, g_strdup (_ ("Diameter (mm)")));
  add_cell (cells, g_strdup (_ ("Area (mm²)")));
  add_cell (cells, g_strdup_printf (_ ("Length (%s)"),
                                    qn_units_symbol (report->units, QN_QUANTITY_LENGTH)));
  add_cell (cells, g_strdup (_ ("Law")));
  for (size_t i = 0; i < model->bar_count; i++) {
    const QnBar *bar = &model->bars[i];
    double length = qn_vec2_length (qn_vec2_sub (bar->end, bar->start));
    add_cell (cells, g_strdup_printf ("%zu", i + 1));
    add_number (cells, "%.4g", 1e3 * qn_bar_get_diameter (bar->area));
    add_number (cells, "%.5g", 1e6 * bar->area);
    add_cell (cells, qn_units_format (report->units, QN_QUANTITY_LENGTH, length, 5));
    add_cell (cells, g_strdup (model->laws[bar->law].name));
  }
  write_table (pages, cells, 5);
}

/* "Ø 20 mm, E 200 GPa, fy 235 MPa, prestress 10 kN, anchor 30 kN" */
static char *
dup_tie_numbers (const QnTie *tie, QnUnits units)
{
  g_autofree char *diameter = qn_units_format_full (units, QN_QUANTITY_DIAMETER,
                                                    qn_bar_get_diameter (tie->area), 3);
  g_autoptr (GString) text = g_string_new (NULL);
  g_string_printf (text, "Ø %s", diameter);
  append_number (text, "E", QN_QUANTITY_STRESS, tie->elasticity, "");
  append_number (text, "fy", QN_QUANTITY_STRESS, tie->yield, "");
  append_number (text, _ ("prestress"), QN_QUANTITY_FORCE, tie->prestress, "");
  append_number (text, _ ("slack"), QN_QUANTITY_LENGTH, tie->slack, "");
  append_number (text, _ ("anchor"), QN_QUANTITY_FORCE, tie->anchor, "");
  return g_strdup (text->str);
}

static void
write_ties (QnPages *pages, const QnReport *report)
{
  const QnModel *model = &report->project->model;
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  if (model->tie_count == 0)
    return;
  add_cell (cells, g_strdup (_ ("Tie")));
  add_cell (cells, g_strdup (_ ("Numbers")));
  add_cell (cells, g_strdup_printf (_ ("Length (%s)"),
                                    qn_units_symbol (report->units, QN_QUANTITY_LENGTH)));
  for (size_t i = 0; i < model->tie_count; i++) {
    const QnTie *tie = &model->ties[i];
    add_cell (cells, g_strdup (tie->name));
    add_cell (cells, dup_tie_numbers (tie, report->units));
    add_cell (
      cells, qn_units_format (report->units, QN_QUANTITY_LENGTH, qn_tie_length (tie), 5));
  }
  write_table (pages, cells, 3);
}

/* The largest force of every tie, and what it uses of its strength. */
static void
write_tie_forces (QnPages *pages, const QnReportRun *run, QnUnits units)
{
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file->result;
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  if (model->tie_count == 0 || result->tie_count != model->tie_count)
    return;
  add_cell (cells, g_strdup (_ ("Tie")));
  add_cell (cells, g_strdup_printf (_ ("Largest force (%s)"),
                                    qn_units_symbol (units, QN_QUANTITY_FORCE)));
  add_cell (cells, g_strdup_printf (_ ("Strength (%s)"),
                                    qn_units_symbol (units, QN_QUANTITY_FORCE)));
  add_cell (cells, g_strdup (_ ("Used (%)")));
  add_cell (cells, g_strdup (_ ("State")));
  for (size_t i = 0; i < model->tie_count; i++) {
    const QnTie *tie = &model->ties[i];
    gssize step = qn_tie_worst_step (result, i);
    if (step < 0)
      return;
    const QnTieResult *at = &qn_result_step_ties (result, (gsize) step)[i];
    gboolean limited = isfinite (qn_tie_strength (tie));
    add_cell (cells, g_strdup (tie->name));
    add_cell (cells, qn_units_format (units, QN_QUANTITY_FORCE, at->force, 4));
    add_cell (cells, limited ? qn_units_format (units, QN_QUANTITY_FORCE,
                                                qn_tie_strength (tie), 4)
                             : g_strdup ("–"));
    add_number (cells, "%.3g",
                limited ? 100 * qn_tie_utilisation (tie, at->force) : (double) NAN);
    add_cell (cells, g_strdup (qn_tie_state_text (at->state)));
  }
  write_table (pages, cells, 5);
}

static gboolean
same_stuff (const QnBlock *a, const QnBlock *b)
{
  return a->thickness == b->thickness && a->unit_weight == b->unit_weight
         && a->law == b->law;
}

static void
write_materials (QnPages *pages, const QnReport *report)
{
  const QnModel *model = &report->project->model;
  g_autoptr (GPtrArray) laws = g_ptr_array_new_with_free_func (g_free);
  g_autoptr (GPtrArray) blocks = g_ptr_array_new_with_free_func (g_free);
  qn_pages_heading (pages, _ ("Materials"));
  const char *const head[] = { _ ("Law"), _ ("Kind"), _ ("Given per"), _ ("Numbers") };
  for (gsize i = 0; i < G_N_ELEMENTS (head); i++)
    add_cell (laws, g_strdup (head[i]));
  for (size_t i = 0; i < model->law_count; i++) {
    const QnLaw *law = &model->laws[i];
    add_cell (laws, g_strdup (law->name));
    add_cell (laws, g_strdup (_ (qn_law_kind_words[law->kind])));
    add_cell (laws, g_strdup (_ (qn_basis_words[law->basis])));
    add_cell (laws, dup_law_numbers (law, report->units));
  }
  if (model->law_count > 0)
    write_table (pages, laws, G_N_ELEMENTS (head));

  g_autofree char *thickness = g_strdup_printf (
    _ ("Thickness (%s)"), qn_units_symbol (report->units, QN_QUANTITY_LENGTH));
  g_autofree char *weight = g_strdup_printf (
    _ ("Unit weight (%s)"), qn_units_symbol (report->units, QN_QUANTITY_UNIT_WEIGHT));
  const char *const block_head[] = { _ ("Blocks"), thickness, weight, _ ("Law") };
  for (gsize i = 0; i < G_N_ELEMENTS (block_head); i++)
    add_cell (blocks, g_strdup (block_head[i]));
  for (size_t b = 0; b < model->block_count; b++) {
    size_t alike = 0;
    gboolean told = FALSE;
    for (size_t k = 0; k < model->block_count && !told; k++) {
      gboolean same = same_stuff (&model->blocks[k], &model->blocks[b]);
      told = same && k < b;
      alike += same;
    }
    if (told)
      continue;
    const QnBlock *block = &model->blocks[b];
    add_cell (blocks, g_strdup_printf ("%zu", alike));
    add_cell (blocks,
              qn_units_format (report->units, QN_QUANTITY_LENGTH, block->thickness, 5));
    add_cell (blocks, qn_units_format (report->units, QN_QUANTITY_UNIT_WEIGHT,
                                       block->unit_weight, 6));
    add_cell (blocks, g_strdup (block->law != QN_NONE ? model->laws[block->law].name
                                                      : _ ("that of the contacts")));
  }
  if (model->block_count > 0)
    write_table (pages, blocks, G_N_ELEMENTS (block_head));
  write_sections (pages, model);
  write_bars (pages, report);
  write_ties (pages, report);
}

static void
write_ground_motion (QnPages *pages, const QnGroundMotion *motion)
{
  g_autofree char *x = qn_label_number ("%.4g", motion->direction.x);
  g_autofree char *y = qn_label_number ("%.4g", motion->direction.y);
  g_autofree char *scale = qn_label_number ("%.4g", motion->scale);
  g_autofree char *peak = qn_label_number ("%.4g", motion->pulse.amplitude);
  g_autofree char *length = qn_label_number ("%.4g", motion->pulse.duration);
  g_autofree char *signal =
    motion->kind == QN_SIGNAL_PULSE
      ? g_strdup_printf (_ ("pulse of %s m/s² and %s s"), peak, length)
    : motion->record != NULL ? g_strdup (motion->record)
                             : g_strdup_printf (_ ("%zu points"), motion->point_count);
  g_autofree char *line = g_strdup_printf (
    _ ("Ground motion: %s, factor %s, along (%s; %s)"), signal, scale, x, y);
  qn_pages_paragraph (pages, line);
}

/* A block that starts elsewhere than at rest, or moves when the motion begins. */
static void
write_initial_motion (QnPages *pages, const QnReport *report,
                      const QnInitialMotion *motion)
{
  const char *block = report->project->model.blocks[motion->block].name;
  const double *u = motion->displacement, *v = motion->velocity;
  QnUnits units = qn_units_of_motion (report->units);
  if (u[QN_DOF_UX] != 0 || u[QN_DOF_UY] != 0 || u[QN_DOF_RZ] != 0) {
    g_autofree char *x =
      qn_units_format_full (units, QN_QUANTITY_LENGTH, u[QN_DOF_UX], 4);
    g_autofree char *y =
      qn_units_format_full (units, QN_QUANTITY_LENGTH, u[QN_DOF_UY], 4);
    g_autofree char *turn =
      qn_units_format_full (units, QN_QUANTITY_ANGLE, u[QN_DOF_RZ], 4);
    g_autofree char *line =
      g_strdup_printf (_ ("Initial displacement of %s: %s; %s; %s"), block, x, y, turn);
    qn_pages_paragraph (pages, line);
  }
  if (v[QN_DOF_UX] != 0 || v[QN_DOF_UY] != 0 || v[QN_DOF_RZ] != 0) {
    g_autofree char *x = qn_label_number ("%.4g", v[QN_DOF_UX]);
    g_autofree char *y = qn_label_number ("%.4g", v[QN_DOF_UY]);
    g_autofree char *turn = qn_label_number ("%.4g", v[QN_DOF_RZ]);
    g_autofree char *line = g_strdup_printf (
      _ ("Initial velocity of %s: %s; %s m/s; %s rad/s"), block, x, y, turn);
    qn_pages_paragraph (pages, line);
  }
}

static void
write_dynamic (QnPages *pages, const QnReport *report)
{
  const QnModel *model = &report->project->model;
  const QnDynamicSettings *dynamic = &model->analysis.dynamic;
  for (size_t i = 0; i < model->initial_count; i++)
    write_initial_motion (pages, report, &model->initial[i]);
  double end = qn_model_duration (model);
  g_autofree char *duration = qn_label_number ("%.4g", end);
  g_autofree char *line = end > 0
                            ? g_strdup_printf (_ ("Duration: %s s"), duration)
                            : g_strdup (_ ("Duration: to the end of the ground motion"));
  qn_pages_paragraph (pages, line);
  g_autofree char *mass = qn_label_number ("%.4g", dynamic->mass_damping);
  g_autofree char *joints = qn_label_number ("%.4g", dynamic->joint_damping);
  g_autofree char *damping = g_strdup_printf (
    _ ("Damping: %s 1/s times the mass, %s s times the stiffness"), mass, joints);
  qn_pages_paragraph (pages, damping);
}

/* "Live load, traffic × 1.5: Backfill on the left: …" */
static void
write_load (QnPages *pages, const QnReport *report, const QnLoad *load, bool dead)
{
  const QnModel *model = &report->project->model;
  g_autofree char *text = qn_load_dup_text (model, load, report->units);
  g_autofree char *where =
    dead             ? g_strdup (_ ("Dead load"))
    : load->set == 0 ? g_strdup (_ ("Live load"))
                     : g_strdup_printf (_ ("Set “%s”"), model->load_sets[load->set - 1]);
  g_autofree char *factor = qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER,
                                             qn_model_load_factor (model, load), 6);
  g_autofree char *line =
    load->load_case > 0
      ? g_strdup_printf (_ ("%s, %s × %s: %s"), where,
                         model->load_cases[load->load_case - 1].name, factor, text)
      : g_strdup_printf (_ ("%s: %s"), where, text);
  qn_pages_paragraph (pages, line);
}

static void
write_loads (QnPages *pages, const QnReport *report)
{
  const QnModel *model = &report->project->model;
  qn_pages_heading (pages, _ ("Loads and Analysis"));
  for (size_t i = 0; i < qn_model_load_count (model); i++)
    write_load (pages, report, qn_model_load (model, i), i < model->dead_load_count);
  for (size_t i = 0; i < model->stage_count; i++) {
    g_autofree char *text = qn_stage_dup_text (model, i, report->units);
    g_autofree char *line = g_strdup_printf (_ ("Stage %zu: %s"), i + 1, text);
    qn_pages_paragraph (pages, line);
  }
  for (size_t i = 0; i < model->ground_count; i++)
    write_ground_motion (pages, &model->ground[i]);
  if (model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    write_dynamic (pages, report);
  g_autofree char *analysis = g_strdup_printf (
    _ ("Procedure: %s, in %s geometry."), qn_explain_procedure (&model->analysis),
    model->analysis.geometry == QN_GEOMETRY_LINEAR ? _ ("linear") : _ ("nonlinear"));
  qn_pages_paragraph (pages, analysis);
}

static void
write_findings (QnPages *pages, const QnReport *report)
{
  const QnFindings *findings = &report->contacts->findings;
  if (report->project->model.block_count == 0)
    return;
  qn_pages_heading (pages, _ ("Findings"));
  if (findings->count == 0)
    qn_pages_paragraph (pages, _ ("Contact detection has found nothing unusual."));
  for (size_t i = 0; i < findings->count && i < MOST_ROWS; i++) {
    g_autofree char *text =
      qn_explain_finding (&report->project->model, &findings->items[i]);
    qn_pages_paragraph (pages, text);
  }
  if (findings->count > MOST_ROWS) {
    g_autofree char *more =
      g_strdup_printf (_ ("and %zu more"), findings->count - MOST_ROWS);
    qn_pages_paragraph (pages, more);
  }
}

/* ---- joints ---- */

/* A column of numbers with the same decimals, so that the largest has four digits; or
 * `least_largest` would have, where all are smaller. */
static void
set_column (char **cells, size_t rows, size_t columns, size_t column,
            const double *values, double least_largest)
{
  double largest = least_largest;
  for (size_t r = 0; r < rows; r++)
    if (isfinite (values[r]))
      largest = fmax (largest, fabs (values[r]));
  int decimals =
    largest > 0 ? (int) qn_to_integer (3 - floor (log10 (largest)), 0, 9) : 0;
  g_autofree char *format = g_strdup_printf ("%%.%df", decimals);
  double least = 0.5 * pow (10, -decimals); /* no "-0" */
  for (size_t r = 0; r < rows; r++)
    cells[(r + 1) * columns + column] =
      isfinite (values[r])
        ? qn_label_number (format, fabs (values[r]) < least ? 0 : values[r])
        : g_strdup ("–");
}

static size_t
count_rows (const QnReport *report, size_t joints)
{
  return report->plan.every_joint ? joints : MIN (joints, MOST_ROWS);
}

static void
tell_rest (QnPages *pages, size_t joints, size_t rows)
{
  if (joints == rows)
    return;
  g_autofree char *more = g_strdup_printf (_ ("and %zu more"), joints - rows);
  qn_pages_paragraph (pages, more);
}

static char *
dup_between (const QnModel *model, QnId a, QnId b)
{
  return g_strdup_printf ("%s – %s", model->blocks[a].name, model->blocks[b].name);
}

/* Joints of a project that nothing was computed of. */
static void
write_faces (QnPages *pages, const QnReport *report)
{
  enum { JOINT, BETWEEN, LENGTH, COLUMNS };
  const QnContacts *contacts = report->contacts;
  size_t rows = count_rows (report, contacts->face_count);
  g_auto (GStrv) cells = g_new0 (char *, (rows + 1) * COLUMNS + 1);
  g_autofree double *lengths = g_new (double, rows + 1);
  cells[JOINT] = g_strdup (_ ("Joint"));
  cells[BETWEEN] = g_strdup (_ ("Between"));
  cells[LENGTH] = g_strdup_printf (_ ("Length (%s)"),
                                   qn_units_symbol (report->units, QN_QUANTITY_LENGTH));
  for (size_t r = 0; r < rows; r++) {
    const QnContactFace *face = &contacts->faces[r];
    cells[(r + 1) * COLUMNS + JOINT] = g_strdup_printf ("%zu", r);
    cells[(r + 1) * COLUMNS + BETWEEN] =
      dup_between (&report->project->model, face->a, face->b);
    lengths[r] = face->length / qn_units_factor (report->units, QN_QUANTITY_LENGTH);
  }
  set_column (cells, rows, COLUMNS, LENGTH, lengths, 0);
  qn_pages_table (pages, (const char *const *) cells, rows + 1, COLUMNS);
  tell_rest (pages, contacts->face_count, rows);
}

static bool
has_forces (const QnReportRun *run)
{
  const QnResult *result = &run->file->result;
  return result->step_count > 0 && result->pairs != NULL
         && result->pair_count == run->contacts->pair_count;
}

/* The joints that a table has: those of which a pair does not stick; all where they are requested. */
static size_t
list_joints (const QnReport *report, const QnReportRun *run, const QnPairResult *pairs,
             size_t *shown)
{
  const QnContacts *contacts = run->contacts;
  size_t count = 0;
  for (size_t f = 0; f < contacts->face_count; f++) {
    const QnContactFace *face = &contacts->faces[f];
    bool moves = report->plan.every_joint;
    for (int32_t i = 0; i < face->pair_count && !moves; i++)
      moves = pairs[face->first_pair + i].state != QN_PAIR_STICK;
    if (moves)
      shown[count++] = f;
  }
  return count;
}

/* The forces of joints at the last step, then of contacts that were found on the way. */
static void
write_joints (QnPages *pages, const QnReport *report, const QnReportRun *run)
{
  enum { JOINT, BETWEEN, LENGTH, N, T, M, E, STATE, COLUMNS };
  static const QnQuantity quantities[COLUMNS] = {
    [LENGTH] = QN_QUANTITY_LENGTH, [N] = QN_QUANTITY_FORCE,  [T] = QN_QUANTITY_FORCE,
    [M] = QN_QUANTITY_MOMENT,      [E] = QN_QUANTITY_LENGTH,
  };
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file->result;
  const QnContacts *contacts = run->contacts;
  size_t step = result->step_count - 1, touch_count;
  g_autofree QnPairResult *pairs = qn_step_pairs (contacts, result, step);
  const QnFoundForce *touches = qn_step_found (result, step, &touch_count);
  g_autofree size_t *shown = g_new (size_t, contacts->face_count + 1);
  size_t faces = list_joints (report, run, pairs, shown);
  size_t joints = faces + touch_count, rows = count_rows (report, joints);
  if (rows == 0)
    return;
  g_auto (GStrv) cells = g_new0 (char *, (rows + 1) * COLUMNS + 1);
  g_autofree double *values = g_new (double, rows *COLUMNS + 1); /* by column */
  double force = 0, length = 0; /* the largest, N and m */
  QnUnits units = qn_units_of_motion (report->units);
  const char *const names[COLUMNS] = { _ ("Joint"), _ ("Between"), _ ("Length"), "N", "T",
                                       "M",         "e",           _ ("State") };
  for (int c = 0; c < COLUMNS; c++)
    cells[c] =
      c >= LENGTH && c <= E
        ? g_strdup_printf ("%s (%s)", names[c], qn_units_symbol (units, quantities[c]))
        : g_strdup (names[c]);
  for (size_t r = 0; r < rows; r++) {
    char **row = cells + (r + 1) * COLUMNS;
    bool found = r >= faces;
    const QnFoundForce *touch = &touches[found ? r - faces : 0];
    const QnFoundContact *contact = found ? &result->found[touch->found].contact : NULL;
    size_t number = found ? 0 : shown[r];
    const QnContactFace *face = found ? NULL : &contacts->faces[number];
    QnJointReading reading = { 0 };
    if (face != NULL)
      reading = qn_joint_reading (contacts, (QnId) number, pairs, NULL);
    row[JOINT] = found ? g_strdup (_ ("found")) : g_strdup_printf ("%zu", number);
    row[BETWEEN] = found ? dup_between (model, contact->block, contact->other)
                         : dup_between (model, face->a, face->b);
    row[STATE] = found ? g_strdup (qn_explain_pair_state (touch->state))
                       : qn_inspect_dup_state (&reading);
    bool pressed = reading.place != QN_PLACE_NOWHERE;
    const double numbers[COLUMNS] = {
      [LENGTH] = found ? (double) NAN : face->length,
      [N] = found ? touch->normal : reading.normal,
      [T] = found ? touch->shear : reading.shear,
      [M] = found ? (double) NAN : reading.moment,
      [E] = pressed ? reading.eccentricity : (double) NAN,
    };
    for (int c = LENGTH; c <= E; c++)
      values[(size_t) c * rows + r] = numbers[c] / qn_units_factor (units, quantities[c]);
    force = fmax (force, fmax (fabs (numbers[N]), fabs (numbers[T])));
    length = fmax (length, numbers[LENGTH]);
  }
  /* A value that is small beside the others is shown as small, without digits of rounding. */
  const double least[COLUMNS] = {
    [T] = 0.01 * force, [M] = 0.01 * force * length, [E] = 0.1 * length
  };
  for (size_t c = LENGTH; c <= E; c++)
    set_column (cells, rows, COLUMNS, c, values + c * rows,
                least[c] / qn_units_factor (units, quantities[c]));
  g_autofree char *heading = g_strdup_printf (_ ("Forces of joints: %s"), run->name);
  qn_pages_heading (pages, heading);
  qn_pages_table (pages, (const char *const *) cells, rows + 1, COLUMNS);
  tell_rest (pages, joints, rows);
  if (faces < contacts->face_count) {
    gsize still = contacts->face_count - faces;
    g_autofree char *line = g_strdup_printf (
      ngettext ("%zu joint that neither slides nor opens is left out.",
                "%zu joints that neither slide nor open are left out.", (gulong) still),
      still);
    qn_pages_paragraph (pages, line);
  }
  qn_pages_paragraph (
    pages,
    _ ("At the last step. N: normal force, compression negative; T: shear; M: moment "
       "about the middle of the joint; e: eccentricity of N."));
}

/* Where contact pairs lie, by the laws of the joints, and how many joints have exceptions. */
static void
write_pairs (QnPages *pages, const QnReport *report)
{
  const QnModel *model = &report->project->model;
  const QnContacts *contacts = report->contacts;
  unsigned long own = 0;
  for (size_t law = 0; law < model->law_count; law++) {
    bool used = false;
    for (size_t i = 0; i < contacts->face_count && !used; i++)
      used = (size_t) contacts->faces[i].law_a == law;
    if (!used)
      continue;
    g_autofree char *rule =
      qn_pair_rule_dup_text (&model->contact.pairs, &model->laws[law], report->units);
    g_autofree char *line = g_strdup_printf (_ ("Contact pairs of joints “%s”: %s."),
                                             model->laws[law].name, rule);
    qn_pages_paragraph (pages, line);
  }
  for (size_t i = 0; i < model->override_count; i++)
    own += model->overrides[i].has_pairs;
  if (own == 0)
    return;
  g_autofree char *line =
    g_strdup_printf (ngettext ("%lu exception for the pairs between two blocks.",
                               "%lu exceptions for the pairs between two blocks.", own),
                     own);
  qn_pages_paragraph (pages, line);
}

static bool
write_contacts (QnPages *pages, const QnReport *report, GError **error)
{
  QnFigure figure;
  qn_pages_heading (pages, _ ("Contacts"));
  qn_figure_init (&figure, &report->project->model, report->contacts, NULL,
                  QN_VIEW_CONTACTS);
  figure.title = "";
  figure.caption = "";
  if (!qn_pages_figure (pages, &figure, 0.45, error))
    return false;
  write_pairs (pages, report);
  if (report->run_count == 0)
    write_faces (pages, report);
  return true;
}

/* ---- results ---- */

static bool
take_curve (const QnReportRun *run, QnCurve *curve)
{
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file->result;
  QnCurveMotion motion = qn_result_curve_motion (model, result);
  if (motion.body == QN_NONE || result->step_count < 2 || result->limit.given)
    return false;
  if (!qn_curve_from_result (curve, model, result, motion))
    return false;
  curve->label = run->name;
  qn_curve_cut_runaway (curve);
  return true;
}

static bool
write_figure (QnPages *pages, const QnReportRun *run, QnView view, const char *title,
              GError **error)
{
  QnFigure figure;
  qn_figure_init (&figure, &run->project->model, run->contacts, &run->file->result, view);
  figure.title = title;
  return qn_pages_figure (pages, &figure, 0.42, error);
}

/* The widest crack at the last step, by what the pairs of joints have opened. */
static void
write_crack (QnPages *pages, const QnReportRun *run, QnUnits units)
{
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file->result;
  const QnContactFace *widest = NULL;
  double width = 0;
  if (result->step_count == 0 || result->limit.given)
    return;
  const QnMotion motion = { .model = model,
                            .displacements = qn_result_step_displacements (
                              result, result->step_count - 1),
                            .linear = model->analysis.geometry == QN_GEOMETRY_LINEAR,
                            .scale = 1 };
  for (size_t f = 0; f < run->contacts->face_count; f++) {
    const QnJoint joint = qn_motion_joint (&motion, &run->contacts->faces[f]);
    double opens = fmax (joint.opening_start, joint.opening_end);
    if (opens > width) {
      width = opens;
      widest = &run->contacts->faces[f];
    }
  }
  if (widest == NULL)
    return;
  g_autofree char *size =
    qn_units_format_full (qn_units_of_motion (units), QN_QUANTITY_LENGTH, width, 3);
  g_autofree char *line =
    g_strdup_printf (_ ("Widest crack at the last step: %s, between %s and %s."), size,
                     model->blocks[widest->a].name, model->blocks[widest->b].name);
  qn_pages_paragraph (pages, line);
}

static void
draw_energies (const void *data, cairo_t *cr, double width, double height)
{
  qn_energy_plot_draw (data, TRUE, cr, width, height, 1, NULL);
}

/* What draws the acceleration of one motion of the ground. */
static void
draw_ground (const void *data, cairo_t *cr, double width, double height)
{
  qn_ground_preview_draw (data, QN_GROUND_ACCELERATION, cr, width, height, 1);
}

/* The step that is nearest to a time. */
static size_t
step_at (const QnResult *result, double time)
{
  size_t best = 0;
  for (size_t i = 1; i < result->step_count; i++)
    if (fabs (result->steps[i].time - time) < fabs (result->steps[best].time - time))
      best = i;
  return best;
}

/* What shakes the structure, how it stands when it has moved farthest, and its energies. */
static bool
write_history (QnPages *pages, const QnReportRun *run, GError **error)
{
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file->result;
  QnEnergyPlot energies;
  for (size_t i = 0; i < model->ground_count; i++) {
    QnGroundPreview ground;
    qn_ground_preview_init (&ground, model, i, QN_GROUND_ACCELERATION);
    if (ground.count > 0) {
      write_ground_motion (pages, &model->ground[i]);
      qn_pages_drawing (pages, draw_ground, &ground, 0.25);
    }
    qn_ground_preview_clear (&ground);
  }
  if (isfinite (result->history.peak_time) && result->step_count > 0) {
    QnFigure figure;
    size_t step = step_at (result, result->history.peak_time);
    qn_figure_init (&figure, model, run->contacts, result, QN_VIEW_DEFORMED);
    figure.options.step = (int) step;
    figure.title = _ ("At its largest displacement");
    if (!qn_pages_figure (pages, &figure, 0.42, error))
      return false;
  }
  qn_energy_plot_init (&energies, &result->history);
  if (energies.count > 0)
    qn_pages_drawing (pages, draw_energies, &energies, 0.3);
  qn_energy_plot_clear (&energies);
  return true;
}

static bool
write_result (QnPages *pages, const QnReportRun *run, QnUnits units, GError **error)
{
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file->result;
  QnCurve curve;
  g_autofree char *title = g_strdup_printf (_ ("Result: %s"), run->name);
  qn_pages_heading (pages, title);
  g_autofree char *overrides =
    run->file->overrides != NULL ? g_strjoinv (", ", run->file->overrides) : NULL;
  if (overrides != NULL) {
    g_autofree char *line = g_strdup_printf (_ ("Computed with %s."), overrides);
    qn_pages_paragraph (pages, line);
  }
  g_autofree char *outcome = qn_explain_outcome (model, result);
  qn_pages_paragraph (pages, outcome);
  g_autofree char *interval = qn_outcome_dup_interval (model, result);
  if (interval != NULL)
    qn_pages_paragraph (pages, interval);
  write_crack (pages, run, units);
  write_tie_forces (pages, run, units);
  g_autofree char *words = qn_explain_mechanism (model, run->contacts, result);
  if (words != NULL)
    qn_pages_paragraph (pages, words);
  bool mode = result->vibration.mode > 0 || result->stability == QN_STABILITY_LOST;
  if (result->mechanism != NULL
      && !write_figure (pages, run, QN_VIEW_MECHANISM,
                        mode ? _ ("Mode") : _ ("Mechanism"), error))
    return false;
  if (result->mechanism == NULL && result->step_count > 0
      && !write_figure (pages, run, QN_VIEW_DEFORMED, _ ("Displacements"), error))
    return false;
  if (take_curve (run, &curve)) {
    const QnCurvePlot plot = { .title = curve.in_time   ? _ ("Displacement in time")
                                        : curve.settles ? _ ("Reaction over settlement")
                                                        : _ ("Load–displacement curve"),
                               .curves = &curve,
                               .curve_count = 1 };
    qn_pages_curve (pages, &plot, 0.4);
    qn_curve_clear (&curve);
  }
  if (result->history.width > 0 && !write_history (pages, run, error))
    return false;
  if (result->beam_forces != NULL
      && !write_figure (pages, run, QN_VIEW_DIAGRAMS, _ ("Section forces"), error))
    return false;
  return !has_forces (run) || run->contacts->face_count == 0
         || write_figure (pages, run, QN_VIEW_FORCES, _ ("Contact forces"), error);
}

static void
write_certificate (QnPages *pages, const QnReport *report)
{
  qn_pages_heading (pages, _ ("Independent Check"));
  qn_pages_paragraph (
    pages,
    _ ("Of the forces in the files alone, without the solver: free blocks and nodes "
       "in equilibrium, joints and sections within their strength."));
  for (size_t i = 0; i < report->run_count; i++) {
    const QnReportRun *run = &report->runs[i];
    g_autofree char *text = NULL;
    if (run->check == NULL) {
      text = g_strdup_printf (_ ("%s: not checked: %s"), run->name, run->unchecked);
    } else {
      g_autofree char *multiplier = qn_label_number ("%.6g", run->check->multiplier);
      g_autofree char *balance = qn_label_number ("%.1e", run->check->out_of_balance);
      g_autofree char *excess = qn_label_number ("%.1e", run->check->yield_violation);
      text = g_strdup_printf (
        run->passes ? _ ("%s: passed at a load multiplier of %s; out of balance by %s of "
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

/* Those that share axes in one plot, where there are several. */
static void
write_curves (QnPages *pages, const QnCurve *curves, size_t count)
{
  g_autofree QnCurve *alike = g_new0 (QnCurve, count + 1);
  for (size_t first = 0; first < count; first++) {
    QnCurvePlot plot = { .title = curves[first].in_time ? _ ("Displacement in time")
                                  : curves[first].settles
                                    ? _ ("Reactions over settlement")
                                    : _ ("Load–displacement curves"),
                         .curves = alike };
    bool told = false;
    for (size_t i = 0; i < count; i++)
      if (qn_curve_shares_axes (&curves[i], &curves[first])) {
        told |= i < first;
        alike[plot.curve_count++] = curves[i];
      }
    if (plot.curve_count > 1 && !told)
      qn_pages_curve (pages, &plot, 0.45);
  }
}

static bool
write_comparison (QnPages *pages, const QnReport *report, GError **error)
{
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  g_autofree QnCurve *curves = g_new0 (QnCurve, report->run_count);
  size_t count = 0;
  const char *const head[] = { _ ("Result"),           _ ("Outcome"),
                               _ ("Multiplier"),       _ ("First limit"),
                               _ ("Lower bound"),      _ ("Upper bound"),
                               _ ("Associative bound") };
  qn_pages_heading (pages, _ ("Comparison"));
  for (gsize i = 0; i < G_N_ELEMENTS (head); i++)
    add_cell (cells, g_strdup (head[i]));
  for (size_t i = 0; i < report->run_count; i++) {
    const QnResult *r = &report->runs[i].file->result;
    add_cell (cells, g_strdup (report->runs[i].name));
    add_cell (cells, g_strdup (qn_explain_outcome_label (r)));
    add_number (cells, "%.6g",
                r->has_collapse_multiplier ? r->collapse_multiplier : (double) NAN);
    add_number (cells, "%.6g",
                r->has_first_limit_multiplier ? r->first_limit_multiplier : (double) NAN);
    add_number (cells, "%.6g", r->limit.given ? r->limit.lower_bound : (double) NAN);
    add_number (cells, "%.6g", r->limit.given ? r->limit.upper_bound : (double) NAN);
    add_number (cells, "%.6g",
                r->has_associative_bound ? r->associative_bound : (double) NAN);
    count += take_curve (&report->runs[i], &curves[count]);
  }
  write_table (pages, cells, G_N_ELEMENTS (head));
  write_curves (pages, curves, count);
  for (size_t i = 0; i < count; i++)
    qn_curve_clear (&curves[i]);

  g_autofree QnFigure *figures = g_new0 (QnFigure, report->run_count);
  size_t drawn = 0;
  for (size_t i = 0; i < report->run_count; i++)
    drawn += choose_picture (&figures[drawn], &report->runs[i]);
  return qn_pages_figures (pages, figures, drawn, 2, 0.35, error);
}

static void
write_files (QnPages *pages, const QnReport *report)
{
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  g_autofree char *project = g_path_get_basename (report->project->name);
  qn_pages_heading (pages, _ ("Files and Versions"));
  add_cell (cells, g_strdup (_ ("File")));
  add_cell (cells, g_strdup (_ ("Made by")));
  add_cell (cells, g_strdup (_ ("SHA-256 of the project")));
  add_cell (cells, g_steal_pointer (&project));
  add_cell (cells, g_strdup ("–"));
  add_cell (cells,
            g_strdup (report->project->sha256 != NULL ? report->project->sha256 : "–"));
  for (size_t i = 0; i < report->run_count; i++) {
    const QnResultFile *file = report->runs[i].file;
    add_cell (cells, g_strdup (report->runs[i].name));
    add_cell (cells, g_strdup (file->generator != NULL ? file->generator : "–"));
    add_cell (cells, g_strdup (file->model_sha256 != NULL ? file->model_sha256 : "–"));
  }
  write_table (pages, cells, 3);
  g_autofree char *made =
    g_strdup_printf (_ ("This report was made by %s."), report->generator);
  qn_pages_paragraph (pages, made);
}

static bool
write_all (QnPages *pages, const QnReport *report, GError **error)
{
  const bool *wanted = report->plan.sections;
  if (wanted[QN_REPORT_TITLE] && !write_title (pages, report, error))
    return false;
  if (wanted[QN_REPORT_MODEL] && !write_model (pages, report, error))
    return false;
  if (wanted[QN_REPORT_MATERIALS])
    write_materials (pages, report);
  if (wanted[QN_REPORT_LOADS])
    write_loads (pages, report);
  if (wanted[QN_REPORT_FINDINGS])
    write_findings (pages, report);
  if (wanted[QN_REPORT_CONTACTS] && report->contacts->face_count > 0
      && !write_contacts (pages, report, error))
    return false;
  for (size_t i = 0; wanted[QN_REPORT_RESULTS] && i < report->run_count; i++)
    if (!write_result (pages, &report->runs[i], report->units, error))
      return false;
  for (size_t i = 0; wanted[QN_REPORT_JOINTS] && i < report->run_count; i++)
    if (has_forces (&report->runs[i]) && report->runs[i].contacts->face_count > 0)
      write_joints (pages, report, &report->runs[i]);
  if (wanted[QN_REPORT_CERTIFICATE] && report->run_count > 0)
    write_certificate (pages, report);
  if (wanted[QN_REPORT_COMPARISON] && report->run_count > 1
      && !write_comparison (pages, report, error))
    return false;
  if (wanted[QN_REPORT_FILES])
    write_files (pages, report);
  return true;
}

GBytes *
qn_report_encode (const QnReport *given, GError **error)
{
  g_autofree QnReportRun *runs = g_new (QnReportRun, given->run_count + 1);
  QnReport once = *given;
  const QnReport *report = &once;
  QnMetadata metadata;
  once.runs = runs;
  once.run_count = 0;
  for (size_t i = 0; i < given->run_count; i++) {
    gboolean told = FALSE;
    for (size_t k = 0; k < once.run_count; k++)
      told |= same_run (&runs[k], &given->runs[i]);
    if (!told)
      runs[once.run_count++] = given->runs[i];
  }
  g_autofree char *name = g_path_get_basename (report->project->name);
  qn_metadata_init (&metadata);
  metadata.title = title_of (report->project);
  metadata.generator = report->generator;
  metadata.model = name;
  metadata.model_sha256 = report->project->sha256;
  g_autofree char *footer =
    g_strdup_printf ("%s · %s", title_of (report->project), report->generator);
  QnPages *pages = qn_pages_new (report->plan.paper, footer, &metadata);
  bool done = write_all (pages, report, error);
  g_autoptr (GBytes) bytes = qn_pages_finish (pages, done ? error : NULL);
  return done ? g_steal_pointer (&bytes) : NULL;
}
