/* The import dialog: what a drawing of another program becomes, with its unit, its extents and
 * everything that was healed and left out, before any of it is taken over. */
#include "app/dialogs/dialogs.h"

#include "app/canvas/gap-marks.h"
#include "app/forms/form.h"
#include "app/widgets/dialog.h"
#include "app/widgets/preview.h"
#include "app/widgets/settings.h"
#include "io/exchange/drawing-import.h"
#include <glib/gi18n.h>

/* Rows of the choice of unit; the first leaves it to the file. */
static const char *const units[] = { NULL, "mm", "cm", "dm", "m", "in", "ft" };

typedef struct Dialog {
  QnForm base;
  GtkWindow *parent;
  QnImportFunc import;
  char *path;
  guint unit; /* row */
  QnImportSettings settings;
  QnProject project;
  QnImportReport report;
  guint layer; /* row */
  gboolean has_project;
} Dialog;

#define FIELDS(FIELD, MEMBER)                                                            \
  MEMBER (UNIT, "unit", NULL, Dialog, unit)                                              \
  MEMBER (LAYER, "layer", NULL, Dialog, layer)                                           \
  FIELD (ROLE, "role", NULL)                                                             \
  FIELD (EXTENTS, "extents", NULL)                                                       \
  MEMBER (TOLERANCE, "tolerance", NULL, Dialog, settings.tolerance)                      \
  MEMBER (GAP_WIDTH, "gap_width", NULL, Dialog, settings.gap_width)                      \
  MEMBER (THICKNESS, "thickness", NULL, Dialog, settings.thickness)                      \
  MEMBER (UNIT_WEIGHT, "unit_weight", NULL, Dialog, settings.unit_weight)                \
  MEMBER (FRICTION, "friction", NULL, Dialog, settings.friction)                         \
  MEMBER (GAPS, "gaps", NULL, Dialog, settings.gaps)                                     \
  FIELD (REPORT, "report", NULL)                                                         \
  FIELD (PREVIEW, "preview", NULL)                                                       \
  FIELD (CANCEL, "cancel", NULL)                                                         \
  FIELD (ACCEPT, "accept", NULL)
QN_FORM_FIELDS;

static void
clear_project (Dialog *dialog)
{
  if (dialog->has_project)
    qn_project_clear (&dialog->project);
  qn_import_report_clear (&dialog->report);
  dialog->has_project = FALSE;
}

static void
clear (QnForm *data)
{
  Dialog *dialog = (Dialog *) data;
  clear_project (dialog);
  g_strfreev (dialog->settings.layers);
  g_free (dialog->path);
}

/* ---- what it would become ---- */

static void
try_import (Dialog *dialog)
{
  const QnImportReport *report = &dialog->report;
  g_autoptr (GError) error = NULL;
  GString *text = g_string_new (NULL);
  clear_project (dialog);
  dialog->has_project = qn_import_file (dialog->path, &dialog->settings, &dialog->project,
                                        &dialog->report, &error);
  if (!dialog->has_project)
    g_string_append_printf (text, "⚠ %s\n", error->message);
  for (guint i = 0; report->lines != NULL && i < report->warnings->len; i++)
    g_string_append_printf (text, "⚠ %s\n", (char *) report->warnings->pdata[i]);
  for (guint i = 0; report->lines != NULL && i < report->lines->len; i++) {
    const char *line = report->lines->pdata[i];
    if (!g_ptr_array_find_with_equal_func (report->warnings, line, g_str_equal, NULL))
      g_string_append_printf (text, "%s\n", line);
  }
  gtk_text_buffer_set_text (
    gtk_text_view_get_buffer (GTK_TEXT_VIEW (dialog->base.widgets[REPORT])), text->str,
    -1);
  g_string_free (text, TRUE);
  gtk_widget_queue_draw (dialog->base.widgets[PREVIEW]);
}

static void
draw_preview (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  const Dialog *dialog = data;
  QnCamera camera;
  if (!dialog->has_project)
    return;
  qn_preview_draw (&dialog->project.model, FALSE, cr, width, height, &camera);
  qn_gap_marks_draw (&dialog->report.gaps, &camera, cr);
}

/* ---- fields ---- */

/* Of the selected layer; NULL where there is none. */
static const QnImportLayer *
layer_of (const Dialog *dialog)
{
  return dialog->report.layers != NULL && dialog->layer < dialog->report.layers->len
           ? &g_array_index (dialog->report.layers, QnImportLayer, dialog->layer)
           : NULL;
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  Dialog *dialog = (Dialog *) data;
  gboolean about_gaps = field == GAPS || field == GAP_WIDTH;
  if (about_gaps && dialog->report.gaps.count == 0 && !(dialog->settings.gap_width > 0))
    return FALSE;
  if ((field == LAYER || field == ROLE) && layer_of (dialog) == NULL)
    return FALSE;
  if (field == LAYER)
    for (guint i = 0; i < dialog->report.layers->len; i++) {
      const QnImportLayer *layer =
        &g_array_index (dialog->report.layers, QnImportLayer, i);
      qn_value_take_row (value, g_strdup_printf ("%s (%u)", layer->name, layer->count));
    }
  else if (field == ROLE)
    value->number = layer_of (dialog)->role;
  else if (field == EXTENTS && !dialog->has_project)
    value->text = g_strdup ("");
  else if (field == EXTENTS) {
    const QnModel *read = &dialog->project.model;
    const QnBox box = qn_box_of_points (read->vertices, read->vertex_count);
    const QnUnits shown = qn_settings_get_units ();
    g_autofree char *width =
      qn_units_format_full (shown, QN_QUANTITY_LENGTH, box.max.x - box.min.x, 4);
    g_autofree char *height =
      qn_units_format_full (shown, QN_QUANTITY_LENGTH, box.max.y - box.min.y, 4);
    const gsize count = read->block_count;
    value->text =
      g_strdup_printf (ngettext ("%zu block, %s wide and %s high",
                                 "%zu blocks, %s wide and %s high", (gulong) count),
                       count, width, height);
  } else if (field == ACCEPT)
    value->disabled = !dialog->has_project;
  return TRUE;
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  Dialog *dialog = (Dialog *) data;
  if (field == ACCEPT && dialog->has_project)
    dialog->import (dialog->parent, &dialog->project);
  if (field == ACCEPT || field == CANCEL) {
    gtk_window_destroy (GTK_WINDOW (dialog->base.root));
    return TRUE;
  }
  if (field == ROLE) {
    /* What was said of the layer before no longer counts. */
    static const char *const roles[] = { "block", "support", "opening", "ignored" };
    g_autoptr (GStrvBuilder) entries = g_strv_builder_new ();
    g_autofree char *entry =
      g_strdup_printf ("%s=%s", layer_of (dialog)->name, roles[qn_value_int (value)]);
    g_strv_builder_add (entries, entry);
    if (dialog->settings.layers != NULL)
      g_strv_builder_addv (entries, (const char **) dialog->settings.layers);
    g_strfreev (dialog->settings.layers);
    dialog->settings.layers = g_strv_builder_end (entries);
  } else if (field == UNIT)
    dialog->settings.unit =
      dialog->unit > 0 ? qn_import_unit (units[dialog->unit]) : QN_IMPORT_DEFAULTS.unit;
  if (field != LAYER)
    try_import (dialog);
  return TRUE;
}

void
qn_import_dialog_show (GtkWindow *parent, const char *path, gboolean adds,
                       QnImportFunc import)
{
  static const QnFormKind kind = QN_FORM_KIND ("import-dialog", Dialog, .clear = clear);
  Dialog *dialog = qn_form_new (&kind, NULL);
  g_autofree char *base = g_path_get_basename (path);
  g_autofree char *title = g_strdup_printf (_ ("Import %s"), base);
  dialog->parent = parent;
  dialog->import = import;
  dialog->path = g_strdup (path);
  dialog->settings = QN_IMPORT_DEFAULTS;
  if (adds)
    gtk_button_set_label (GTK_BUTTON (dialog->base.widgets[ACCEPT]),
                          _ ("_Add to Drawing"));
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (dialog->base.widgets[PREVIEW]),
                                  draw_preview, dialog, NULL);
  gtk_window_set_title (GTK_WINDOW (dialog->base.root), title);
  try_import (dialog);
  /* What is drawn with mortar is meant to stand: closed unless the user says otherwise. */
  if (dialog->report.gaps.count > 0) {
    dialog->settings.gaps = QN_GAPS_CLOSED;
    try_import (dialog);
  }
  qn_dialog_present (qn_form_show (dialog), parent, "import",
                     dialog->base.widgets[ACCEPT]);
}
