/* Sections of a report on joints: their pairs, and the forces in them. */
#include "doc/view/report-parts.h"

#include "core/base/integer.h"
#include "doc/text/explain.h"
#include "doc/view/pair-text.h"
#include "render/drawing/text.h"
#include "render/scene/reading.h"

#include <glib/gi18n-lib.h>
#include <math.h>

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
  return report->plan.every_joint ? joints : MIN (joints, QN_REPORT_ROWS);
}

static void
tell_rest (QnPages *pages, size_t joints, size_t rows)
{
  if (joints == rows)
    return;
  qn_report_say (pages, _ ("and %zu more"), joints - rows);
}

char *
qn_report_dup_between (const QnModel *model, QnId a, QnId b)
{
  return g_strdup_printf ("%s – %s", model->blocks[a].name, model->blocks[b].name);
}

bool
qn_report_has_forces (const QnReportRun *run)
{
  const QnResult *result = &run->file.result;
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

/* Where the joints of a table are. */
static bool
write_numbered (QnPages *pages, const QnReportRun *run, const size_t *shown, size_t count,
                GError **error)
{
  g_autofree bool *numbered = g_new0 (bool, run->contacts->face_count + 1);
  QnFigure figure;
  for (size_t r = 0; r < count; r++)
    numbered[shown[r]] = true;
  qn_figure_init (&figure, &run->project->model, run->contacts, NULL, QN_VIEW_MODEL);
  figure.options.loads = figure.options.dimensions = figure.options.legend = false;
  figure.options.numbered = numbered;
  figure.title = _ ("Joints of the table");
  figure.caption = "";
  return qn_pages_figures (pages, &figure, 1, 1, 0.5, error);
}

/* The forces of joints at the last step, then of contacts that were found on the way. */
bool
qn_report_write_joints (QnPages *pages, const QnReport *report, const QnReportRun *run,
                        GError **error)
{
  enum { JOINT, BETWEEN, LENGTH, N, T, M, E, STATE, COLUMNS };
  static const QnQuantity quantities[COLUMNS] = {
    [LENGTH] = QN_QUANTITY_LENGTH, [N] = QN_QUANTITY_FORCE,  [T] = QN_QUANTITY_FORCE,
    [M] = QN_QUANTITY_MOMENT,      [E] = QN_QUANTITY_LENGTH,
  };
  const QnModel *model = &run->project->model;
  const QnResult *result = &run->file.result;
  const QnContacts *contacts = run->contacts;
  size_t step = result->step_count - 1, touch_count;
  g_autofree QnPairResult *pairs = qn_step_pairs (contacts, result, step);
  const QnFoundForce *touches = qn_step_found (result, step, &touch_count);
  g_autofree size_t *shown = g_new (size_t, contacts->face_count + 1);
  size_t faces = list_joints (report, run, pairs, shown);
  size_t joints = faces + touch_count, rows = count_rows (report, joints);
  if (rows == 0)
    return true;
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
      reading = qn_joint_reading (contacts, (QnId) number, pairs);
    row[JOINT] = found ? g_strdup (_ ("found")) : g_strdup_printf ("%zu", number);
    row[BETWEEN] = found ? qn_report_dup_between (model, contact->block, contact->other)
                         : qn_report_dup_between (model, face->a, face->b);
    row[STATE] = found ? g_strdup (qn_explain_pair_state (touch->state))
                       : qn_explain_pairs (reading.states);
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
  int figure = qn_pages_next_figure (pages);
  if (contacts->face_count > 1
      && !write_numbered (pages, run, shown, MIN (rows, faces), error))
    return false;
  qn_pages_table (pages, (const char *const *) cells, rows + 1, COLUMNS);
  tell_rest (pages, joints, rows);
  if (contacts->face_count > 1)
    qn_report_say (pages, _ ("Figure\u00a0%d shows where the numbers are."), figure);
  if (faces < contacts->face_count) {
    gsize still = contacts->face_count - faces;
    qn_report_say (pages,
                   ngettext ("%zu joint that neither slides nor opens is left out.",
                             "%zu joints that neither slide nor open are left out.",
                             (gulong) still),
                   still);
  }
  qn_pages_paragraph (
    pages,
    _ ("At the last step. N: normal force, compression negative; T: shear; M: moment "
       "about the middle of the joint; e: eccentricity of N."));
  return true;
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
    qn_report_say (pages, _ ("Contact pairs of joints “%s”: %s."), model->laws[law].name,
                   rule);
  }
  for (size_t i = 0; i < model->override_count; i++)
    own += model->overrides[i].has_pairs;
  if (own == 0)
    return;
  qn_report_say (pages,
                 ngettext ("%lu exception for the pairs between two blocks.",
                           "%lu exceptions for the pairs between two blocks.", own),
                 own);
}

bool
qn_report_write_contacts (QnPages *pages, const QnReport *report, GError **error)
{
  QnFigure figure;
  qn_pages_heading (pages, _ ("Contacts"));
  qn_figure_init (&figure, &report->project->model, report->contacts, NULL,
                  QN_VIEW_CONTACTS);
  figure.title = _ ("Contact faces and pairs");
  figure.caption = "";
  write_pairs (pages, report);
  qn_report_say (pages, _ ("Where they are: figure\u00a0%d."),
                 qn_pages_next_figure (pages));
  if (!qn_pages_figures (pages, &figure, 1, 1, 0.45, error))
    return false;
  if (report->run_count == 0) {
    /* Joints of a project that nothing was computed of. */
    const QnContacts *contacts = report->contacts;
    const size_t rows = count_rows (report, contacts->face_count);
    g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
    qn_report_row (cells, report->units, "wwu", _ ("Joint"), _ ("Between"),
                   _ ("Length (%s)"), QN_QUANTITY_LENGTH);
    for (size_t r = 0; r < rows; r++) {
      const QnContactFace *face = &contacts->faces[r];
      qn_report_row (cells, report->units, "zoq", r,
                     qn_report_dup_between (&report->project->model, face->a, face->b),
                     QN_QUANTITY_LENGTH, face->length, 4);
    }
    qn_report_table (pages, cells, 3);
    tell_rest (pages, contacts->face_count, rows);
  }
  return true;
}
