/* What runs that are compared are called, their numbers as a table, their curves over each other. */
#include "app/pages/compare-private.h"

#include "app/widgets/shortened.h"
#include "app/widgets/text-unit.h"
#include "doc/document/document.h"
#include "doc/document/run.h"
#include "doc/text/explain.h"
#include "doc/text/units.h"
#include "render/figure/curve-plot.h"
#include <glib/gi18n.h>

QnDocument *
qn_compare_find_document (Compare *compare, QnRun *run)
{
  g_autoptr (GPtrArray) documents = qn_compare_list_documents (compare);
  for (guint i = 0; i < documents->len; i++) {
    QnDocument *document = documents->pdata[i];
    if (g_ptr_array_find (document->runs, run, NULL))
      return document;
  }
  return NULL;
}

/* How many of the runs on show are of that document. */
static guint
count_of (Compare *compare, QnDocument *document)
{
  guint count = 0;
  for (guint i = 0; i < compare->shown->len; i++)
    count += qn_compare_find_document (compare, compare->shown->pdata[i]) == document;
  return count;
}

char *
qn_compare_dup_title (Compare *compare, QnRun *run)
{
  QnDocument *document = qn_compare_find_document (compare, run);
  guint count = count_of (compare, document);
  if (count == compare->shown->len) {
    /* Labels tell the runs on show apart where each has another one. */
    g_autoptr (GHashTable) labels = g_hash_table_new (g_str_hash, g_str_equal);
    gboolean enough = TRUE;
    for (guint i = 0; enough && i < count; i++) {
      const QnRun *other = compare->shown->pdata[i];
      enough = other->label != NULL && g_hash_table_add (labels, other->label);
    }
    return g_strdup (enough ? run->label : run->name);
  }
  g_autofree char *project = document != NULL ? qn_document_dup_display_name (document)
                             : run->model.title != NULL ? g_strdup (run->model.title)
                                                        : g_strdup (_ ("Untitled"));
  return count > 1 ? g_strdup_printf (_ ("%s: %s"), project, run->name)
                   : g_steal_pointer (&project);
}

/* What the project of a run says otherwise than that of the first. */
static char *
dup_changes (Compare *compare, const QnRun *run)
{
  const QnRun *first = compare->shown->pdata[0];
  g_autoptr (GPtrArray) changes = run != first ? qn_run_list_changes (first, run) : NULL;
  if (changes == NULL || changes->len == 0)
    return g_strdup ("–");
  g_ptr_array_add (changes, NULL);
  return g_strjoinv (", ", (char **) changes->pdata);
}

/* Whether the runs are all of one project, and what changed is not just what they are called. */
static gboolean
tells_changes (Compare *compare)
{
  const GPtrArray *shown = compare->shown;
  gboolean any = FALSE;
  for (guint i = 1; i < shown->len && !any; i++) {
    g_autofree char *changes = dup_changes (compare, shown->pdata[i]);
    g_autofree char *title = qn_compare_dup_title (compare, shown->pdata[i]);
    any = !g_str_equal (changes, title);
  }
  return any
         && count_of (compare, qn_compare_find_document (compare, shown->pdata[0]))
              == shown->len;
}

enum { RUN, CHANGED, MULTIPLIER, PART, MOVED, STEPS, OUTCOME, COLUMNS };

/* What differs is told in place of the steps. */
static void
put_row (Compare *compare, int row, gboolean changed, const char *const texts[COLUMNS])
{
  for (int i = 0, column = 0; i < COLUMNS; i++) {
    if (i == (changed ? STEPS : CHANGED))
      continue;
    GtkWidget *label = gtk_label_new (texts[i]);
    gtk_label_set_xalign (GTK_LABEL (label), i <= CHANGED ? 0.0f : 1.0f);
    if (row == 0)
      gtk_widget_add_css_class (label, "heading");
    if (row > 0 && i <= CHANGED) {
      qn_shortened_set (GTK_LABEL (label), PANGO_ELLIPSIZE_END);
      gtk_label_set_max_width_chars (GTK_LABEL (label), 28);
      gtk_label_set_width_chars (GTK_LABEL (label), changed ? 12 : 18);
    }
    gtk_grid_attach (GTK_GRID (compare->table), label, column++, row, 1, 1);
  }
}

/* How far the curve's point had moved at the last step; in time, how far any block ever went. */
static char *
dup_displacement (const QnRun *run)
{
  const QnUnits millimetres = { .length = QN_LENGTH_MM };
  const QnCurveMotion motion = qn_result_curve_motion (&run->model, &run->result);
  if (qn_run_is_in_time (run))
    return qn_units_format_full (millimetres, QN_QUANTITY_LENGTH,
                                 qn_result_peak (&run->result, NULL), 4);
  if (!qn_run_has_curve (run) || motion.body == QN_NONE || run->result.step_count == 0)
    return g_strdup ("–");
  return qn_units_format_full (
    millimetres, motion.dof == QN_DOF_RZ ? QN_QUANTITY_ROTATION : QN_QUANTITY_LENGTH,
    qn_curve_motion_at (&run->result, motion, run->result.step_count - 1), 4);
}

void
qn_compare_fill_table (Compare *compare)
{
  const char *const heads[COLUMNS] = { _ ("Run"),        _ ("Changed"),
                                       _ ("Multiplier"), _ ("Of the first"),
                                       _ ("Moved"),      _ ("Steps"),
                                       _ ("Outcome") };
  const gboolean changed = tells_changes (compare);
  GtkWidget *child;
  double first = NAN;
  while ((child = gtk_widget_get_first_child (compare->table)) != NULL)
    gtk_grid_remove (GTK_GRID (compare->table), child);
  put_row (compare, 0, changed, heads);
  for (guint i = 0; i < compare->shown->len; i++) {
    QnRun *run = compare->shown->pdata[i];
    gboolean given = run->kind == QN_RUN_ANALYSIS && run->result.has_collapse_multiplier;
    double value = given ? run->result.collapse_multiplier : NAN;
    if (i == 0)
      first = value;
    g_autofree char *title = qn_compare_dup_title (compare, run);
    g_autofree char *number = given ? g_strdup_printf ("%.4f", value) : g_strdup ("–");
    g_autofree char *part = isfinite (value / first)
                              ? g_strdup_printf ("%.1f %%", 100.0 * value / first)
                              : g_strdup ("–");
    g_autofree char *moved = dup_displacement (run);
    g_autofree char *steps = g_strdup_printf ("%zu", run->result.step_count);
    const char *outcome =
      run->kind == QN_RUN_ANALYSIS ? qn_explain_outcome_label (&run->result) : "–";
    g_autofree char *changes = changed ? dup_changes (compare, run) : NULL;
    const char *const cells[COLUMNS] = { title, changes, number, part,
                                         moved, steps,   outcome };
    put_row (compare, (int) i + 1, changed, cells);
  }
}

static guint
take_curves (Compare *compare, QnCurve *curves, GPtrArray *titles)
{
  guint count = 0;
  for (guint i = 0; i < compare->shown->len; i++) {
    QnRun *run = compare->shown->pdata[i];
    QnCurve *curve = &curves[count];
    if (!qn_run_has_curve (run))
      continue;
    qn_curve_from_result (curve, &run->model, &run->result,
                          qn_result_curve_motion (&run->model, &run->result));
    qn_curve_cut_runaway (curve);
    g_ptr_array_add (titles, qn_compare_dup_title (compare, run));
    curve->label = titles->pdata[titles->len - 1];
    count++;
  }
  return count;
}

void
qn_compare_draw_curves (GtkDrawingArea *area, cairo_t *cr, int width, int height,
                        gpointer data)
{
  Compare *compare = data;
  g_autoptr (GPtrArray) titles = g_ptr_array_new_with_free_func (g_free);
  g_autofree QnCurve *curves = g_new0 (QnCurve, compare->shown->len + 1);
  g_autofree QnCurve *alike = g_new0 (QnCurve, compare->shown->len + 1);
  g_autofree guint *group = g_new0 (guint, compare->shown->len + 1); /* from 1 */
  guint count = take_curves (compare, curves, titles), groups = 0;
  for (guint i = 0; i < count; i++) {
    for (guint k = 0; k < i && group[i] == 0; k++)
      group[i] = qn_curve_shares_axes (&curves[k], &curves[i]) ? group[k] : 0;
    if (group[i] == 0)
      group[i] = ++groups;
  }
  for (guint g = 1; g <= groups; g++) {
    double part = (double) height / groups;
    const QnFrame frame = { 6.0, (g - 1) * part + 6.0, width - 12.0, part - 12.0 };
    gsize found = 0;
    for (guint i = 0; i < count; i++)
      if (group[i] == g)
        alike[found++] = curves[i];
    g_autoptr (QnPlot) plot = qn_curve_plot (alike, found, NULL, 0);
    qn_plot_draw (plot, cr, qn_text_unit (GTK_WIDGET (area)), &frame, NULL);
  }
  for (guint i = 0; i < count; i++)
    qn_curve_clear (&curves[i]);
}
