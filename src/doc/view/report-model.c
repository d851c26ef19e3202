/* Sections of a report on the project: model, materials, loads, findings. */
#include "doc/view/report-parts.h"

#include "core/model/bar.h"
#include "doc/text/explain.h"
#include "doc/text/law-text.h"
#include "doc/view/load-text.h"
#include "render/drawing/text.h"

#include <glib/gi18n-lib.h>
#include <math.h>

static char *
dup_quantity (QnUnits units, QnQuantity quantity, double value, int digits)
{
  return qn_label_power (qn_units_format_full (units, quantity, value, digits));
}

bool
qn_report_write_model (QnPages *pages, const QnReport *report, GError **error)
{
  const QnModel *model = &report->project->model;
  QnFigure figure;
  QnBox box = QN_BOX_EMPTY;
  double weight = 0; /* of the blocks that are free */
  qn_pages_heading (pages, _ ("Model"));
  for (size_t i = 0; i < model->vertex_count; i++)
    qn_box_add_point (&box, model->vertices[i]);
  for (size_t i = 0; i < model->node_count; i++)
    qn_box_add_point (&box, model->nodes[i].at);
  for (size_t b = 0; b < model->block_count; b++)
    weight += model->blocks[b].support[QN_DOF_UY] ? 0 : model->blocks[b].weight;
  const QnVec2 size =
    box.min.x <= box.max.x ? qn_vec2_sub (box.max, box.min) : qn_vec2 (0, 0);
  const QnCount counts[] = { { QN_COUNTED_BLOCKS, model->block_count },
                             { QN_COUNTED_FACES, report->contacts->face_count },
                             { QN_COUNTED_PAIRS, report->contacts->pair_count },
                             { QN_COUNTED_BEAMS, model->beam_count } };
  gsize first = model->block_count > 0 || model->beam_count == 0 ? 0 : 3;
  gsize end = G_N_ELEMENTS (counts) - (model->beam_count > 0 ? 0 : 1);
  g_autofree char *number = qn_counts_dup_text (counts + first, end - first, ", ");
  g_autofree char *width = dup_quantity (report->units, QN_QUANTITY_LENGTH, size.x, 5);
  g_autofree char *height = dup_quantity (report->units, QN_QUANTITY_LENGTH, size.y, 5);
  g_autofree char *force = dup_quantity (report->units, QN_QUANTITY_FORCE, weight, 5);
  g_autofree char *text =
    first > 0 ? g_strdup_printf (_ ("%s; %s wide, %s high: figure\u00a0%d."), number,
                                 width, height, qn_pages_next_figure (pages))
              : g_strdup_printf (
                _ ("%s; %s wide, %s high; free blocks weigh %s: figure\u00a0%d."), number,
                width, height, force, qn_pages_next_figure (pages));
  qn_pages_paragraph (pages, text);
  qn_figure_init (&figure, model, report->contacts, NULL, QN_VIEW_MODEL);
  figure.options.dimensions = figure.options.loads = true;
  figure.title = _ ("Model");
  figure.caption = "";
  return qn_pages_figures (pages, &figure, 1, 1, 0.55, error);
}

static char *
dup_law_numbers (const QnLaw *law, QnUnits units)
{
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
  g_autoptr (GString) text = g_string_new (NULL);
  g_autofree char *kn =
    dup_quantity (units, qn_law_quantity ("kn", law->basis), law->kn, 6);
  g_autofree char *ks =
    dup_quantity (units, qn_law_quantity ("ks", law->basis), law->ks, 6);
  if (law->elasticity > 0) {
    g_autofree char *E = dup_quantity (units, qn_law_quantity ("elasticity", law->basis),
                                       law->elasticity, 6);
    g_string_append_printf (text,
                            law->arrangement == QN_ARRANGEMENT_GRID
                              ? _ ("E = %s, ν = %.6g, blocks in a grid: ")
                              : _ ("E = %s, ν = %.6g, blocks in a chain: "),
                            E, law->poisson);
  }
  g_string_append_printf (text, "kn = %s, ks = %s", kn, ks);
  for (size_t i = 0; i < count; i++) {
    double value = qn_law_get (law, &parameters[i]);
    if (!isfinite (value) || (value == 0 && parameters[i].positive))
      continue; /* not given, which is not 0 */
    g_autofree char *number =
      dup_quantity (units, qn_law_quantity (parameters[i].key, law->basis), value, 6);
    g_string_append_printf (text, "; %s: %s", _ (qn_law_number_word (parameters[i].key)),
                            number);
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
  g_autofree char *number = dup_quantity (units, quantity, value, 6);
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
  qn_report_row (cells, QN_UNITS_SI, "www", _ ("Section"), _ ("Beams"), _ ("Numbers"));
  for (size_t i = 0; i < model->section_count; i++) {
    size_t users = 0;
    for (size_t k = 0; k < model->beam_count; k++)
      users += model->beams[k].section == (QnId) i;
    qn_report_row (cells, QN_UNITS_SI, "wzo", model->sections[i].name, users,
                   dup_section_numbers (&model->sections[i]));
  }
  qn_report_table (pages, cells, 3);
}

static void
write_bars (QnPages *pages, const QnReport *report)
{
  const QnModel *model = &report->project->model;
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  if (model->bar_count == 0)
    return;
  qn_report_row (cells, report->units, "wwwuw", _ ("Reinforcing bars"),
                 _ ("Diameter (mm)"), _ ("Area (mm²)"), _ ("Length (%s)"),
                 QN_QUANTITY_LENGTH, _ ("Law"));
  for (size_t i = 0; i < model->bar_count; i++) {
    const QnBar *bar = &model->bars[i];
    double length = qn_bar_length (bar);
    qn_report_row (cells, report->units, "znnqw", i + 1, "%.4g",
                   1e3 * qn_bar_get_diameter (bar->area), "%.5g", 1e6 * bar->area,
                   QN_QUANTITY_LENGTH, length, 5, model->laws[bar->law].name);
  }
  qn_report_table (pages, cells, 5);
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
  append_number (text, C_ ("length", "slack"), QN_QUANTITY_LENGTH, tie->slack, "");
  append_number (text, _ ("anchor"), QN_QUANTITY_FORCE, tie->anchor, "");
  append_number (text, _ ("plate Ø"), QN_QUANTITY_LENGTH, tie->plate.diameter, "");
  append_number (text, _ ("wall"), QN_QUANTITY_LENGTH, tie->plate.wall, "");
  append_number (text, "fv", QN_QUANTITY_STRESS, tie->plate.shear, "");
  append_number (text, "fm", QN_QUANTITY_STRESS, tie->plate.compression, "");
  if (isfinite (qn_tie_plate_punching (&tie->plate)))
    append_number (text, _ ("punching fv π t (D + t)"), QN_QUANTITY_FORCE,
                   qn_tie_plate_punching (&tie->plate), "");
  if (isfinite (qn_tie_plate_bearing (&tie->plate)))
    append_number (text, _ ("bearing fm π D²/4"), QN_QUANTITY_FORCE,
                   qn_tie_plate_bearing (&tie->plate), "");
  append_number (text, _ ("strip of width b"), QN_QUANTITY_LENGTH, tie->strip.width, "");
  append_number (text, "Γ", QN_QUANTITY_SURFACE_ENERGY, tie->strip.fracture_energy, "");
  if (isfinite (qn_tie_debonding (tie)))
    append_number (text, _ ("debonding b √(2 E t Γ)"), QN_QUANTITY_FORCE,
                   qn_tie_debonding (tie), "");
  return g_strdup (text->str);
}

static void
write_ties (QnPages *pages, const QnReport *report)
{
  const QnModel *model = &report->project->model;
  g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
  if (model->tie_count == 0)
    return;
  qn_report_row (cells, report->units, "wwu", _ ("Tie"), _ ("Numbers"), _ ("Length (%s)"),
                 QN_QUANTITY_LENGTH);
  for (size_t i = 0; i < model->tie_count; i++) {
    const QnTie *tie = &model->ties[i];
    qn_report_row (cells, report->units, "woq", tie->name,
                   dup_tie_numbers (tie, report->units), QN_QUANTITY_LENGTH,
                   qn_tie_length (tie), 5);
  }
  qn_report_table (pages, cells, 3);
}

static gboolean
same_stuff (const QnBlock *a, const QnBlock *b)
{
  return a->thickness == b->thickness && a->unit_weight == b->unit_weight
         && a->law == b->law;
}

void
qn_report_write_materials (QnPages *pages, const QnReport *report)
{
  const QnModel *model = &report->project->model;
  g_autoptr (GPtrArray) laws = g_ptr_array_new_with_free_func (g_free);
  g_autoptr (GPtrArray) blocks = g_ptr_array_new_with_free_func (g_free);
  qn_pages_heading (pages, _ ("Materials"));
  qn_report_row (laws, report->units, "wwww", _ ("Law"), _ ("Kind"), _ ("Given per"),
                 _ ("Numbers"));
  for (size_t i = 0; i < model->law_count; i++) {
    const QnLaw *law = &model->laws[i];
    qn_report_row (laws, report->units, "wwwo", law->name,
                   _ (qn_law_kind_words[law->kind]), _ (qn_basis_words[law->basis]),
                   dup_law_numbers (law, report->units));
  }
  if (model->law_count > 0)
    qn_report_table (pages, laws, 4);

  qn_report_row (blocks, report->units, "wuuw", _ ("Blocks"), _ ("Thickness (%s)"),
                 QN_QUANTITY_LENGTH, _ ("Unit weight (%s)"), QN_QUANTITY_UNIT_WEIGHT,
                 _ ("Law"));
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
    qn_report_row (blocks, report->units, "zqqw", alike, QN_QUANTITY_LENGTH,
                   block->thickness, 5, QN_QUANTITY_UNIT_WEIGHT, block->unit_weight, 6,
                   block->law != QN_NONE ? model->laws[block->law].name
                                         : _ ("that of the contacts"));
  }
  if (model->block_count > 0)
    qn_report_table (pages, blocks, 4);
  write_sections (pages, model);
  write_bars (pages, report);
  write_ties (pages, report);
}

void
qn_report_write_ground_motion (QnPages *pages, const QnGroundMotion *motion)
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
  qn_report_say (pages, _ ("Ground motion: %s, factor %s, along (%s; %s)"), signal, scale,
                 x, y);
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
    qn_report_say (pages, _ ("Initial displacement of %s: %s; %s; %s"), block, x, y,
                   turn);
  }
  if (v[QN_DOF_UX] != 0 || v[QN_DOF_UY] != 0 || v[QN_DOF_RZ] != 0) {
    g_autofree char *x = qn_label_number ("%.4g", v[QN_DOF_UX]);
    g_autofree char *y = qn_label_number ("%.4g", v[QN_DOF_UY]);
    g_autofree char *turn = qn_label_number ("%.4g", v[QN_DOF_RZ]);
    qn_report_say (pages, _ ("Initial velocity of %s: %s; %s m/s; %s rad/s"), block, x, y,
                   turn);
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
  qn_report_say (pages, _ ("Damping: %s 1/s times the mass, %s s times the stiffness"),
                 mass, joints);
  if (dynamic->of == QN_DAMPING_IMPACT)
    qn_report_say (pages, "%s",
                   _ ("Joints lose what the impact of a rocking block does"));
}

void
qn_report_write_loads (QnPages *pages, const QnReport *report)
{
  const QnModel *model = &report->project->model;
  qn_pages_heading (pages, _ ("Loads and Analysis"));
  qn_report_say (pages, _ ("Procedure: %s, in %s geometry."), qn_report_procedure (model),
                 qn_report_geometry (model));
  g_autoptr (GString) list = g_string_new (NULL);
  for (size_t i = 0; i < qn_model_load_count (model); i++) {
    /* "Live load, traffic × 1.5: Backfill on the left: …" */
    const QnLoad *load = qn_model_load (model, i);
    g_autofree char *text = qn_load_dup_text (model, load, report->units);
    g_autofree char *where =
      i < model->dead_load_count ? g_strdup (_ ("Dead load"))
      : load->set == 0
        ? g_strdup (_ ("Live load"))
        : g_strdup_printf (_ ("Set “%s”"), model->load_sets[load->set - 1]);
    g_autofree char *factor = qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER,
                                               qn_model_load_factor (model, load), 6);
    g_string_append (list, list->len > 0 ? "\n" : "");
    if (load->load_case > 0)
      g_string_append_printf (list, _ ("%s, %s × %s: %s"), where,
                              model->load_cases[load->load_case - 1].name, factor, text);
    else
      g_string_append_printf (list, _ ("%s: %s"), where, text);
  }
  if (list->len > 0)
    qn_pages_paragraph (pages, list->str);
  for (size_t i = 0; i < model->stage_count; i++) {
    g_autofree char *text = qn_stage_dup_text (model, i, report->units);
    if (*text != '\0')
      qn_report_say (pages, _ ("Stage %zu: %s"), i + 1, text);
  }
  for (size_t i = 0; i < model->ground_count; i++)
    qn_report_write_ground_motion (pages, &model->ground[i]);
  if (model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    write_dynamic (pages, report);
}

void
qn_report_write_findings (QnPages *pages, const QnReport *report)
{
  const QnFindings *findings = &report->contacts->findings;
  if (report->project->model.block_count == 0)
    return;
  qn_pages_heading (pages, _ ("Findings"));
  const GPtrArray *warnings = report->project->warnings;
  for (guint i = 0; i < warnings->len; i++)
    qn_pages_paragraph (pages, g_ptr_array_index (warnings, i));
  if (findings->count == 0)
    qn_pages_paragraph (pages, _ ("Contact detection has found nothing unusual."));
  for (size_t i = 0; i < findings->count && i < QN_REPORT_ROWS; i++) {
    g_autofree char *text =
      qn_explain_finding (&report->project->model, &findings->items[i]);
    qn_pages_paragraph (pages, text);
  }
  if (findings->count > QN_REPORT_ROWS) {
    qn_report_say (pages, _ ("and %zu more"), findings->count - QN_REPORT_ROWS);
  }
}
