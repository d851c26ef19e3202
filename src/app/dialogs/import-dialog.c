/* The import dialog: what a drawing of another program becomes, with its unit, its extents and
 * everything that was healed and left out, before any of it is taken over. */
#include "app/dialogs/dialogs.h"

#include "app/forms/form.h"
#include "app/widgets/dialog.h"
#include "app/widgets/settings.h"
#include "doc/document/import.h"
#include "io/exchange/drawing-import.h"
#include "render/backend/draw-cairo.h"
#include <glib/gi18n.h>

#define PREVIEW_MARGIN_PX 16.0

/* Rows of the choice of unit; the first leaves it to the file. */
static const char *const units[] = { NULL, "mm", "cm", "dm", "m", "in", "ft" };

typedef struct Dialog {
  GtkWindow *parent;
  QnImportFunc import;
  GtkWidget *dialog, *preview, *accept;
  char *path;
  GtkDropDown *unit;
  QnQuantityEntry *tolerance, *thickness, *unit_weight, *friction;
  GtkLabel *extents;
  GtkTextBuffer *report;
  QnProject project;
  gboolean has_project;
} Dialog;

static void
clear_project (Dialog *dialog)
{
  if (dialog->has_project)
    qn_project_clear (&dialog->project);
  dialog->has_project = FALSE;
}

static void
dialog_free (gpointer data, GObject *where)
{
  (void) where;
  Dialog *dialog = data;
  clear_project (dialog);
  g_free (dialog->path);
  g_free (dialog);
}

/* ---- what it would become ---- */

static QnBox
extents_of (const QnModel *model)
{
  QnBox box = { model->vertices[0], model->vertices[0] };
  for (gsize i = 1; i < model->vertex_count; i++) {
    box.min = qn_vec2 (MIN (box.min.x, model->vertices[i].x),
                       MIN (box.min.y, model->vertices[i].y));
    box.max = qn_vec2 (MAX (box.max.x, model->vertices[i].x),
                       MAX (box.max.y, model->vertices[i].y));
  }
  return box;
}

static void
show_extents (Dialog *dialog)
{
  if (!dialog->has_project) {
    gtk_label_set_text (dialog->extents, "");
    return;
  }
  QnBox box = extents_of (&dialog->project.model);
  QnUnits shown = qn_settings_get_units ();
  g_autofree char *width =
    qn_units_format_full (shown, QN_QUANTITY_LENGTH, box.max.x - box.min.x, 4);
  g_autofree char *height =
    qn_units_format_full (shown, QN_QUANTITY_LENGTH, box.max.y - box.min.y, 4);
  gsize count = dialog->project.model.block_count;
  g_autofree char *text =
    g_strdup_printf (ngettext ("%zu block, %s wide and %s high",
                               "%zu blocks, %s wide and %s high", (gulong) count),
                     count, width, height);
  gtk_label_set_text (dialog->extents, text);
}

static QnImportSettings
settings_of (const Dialog *dialog)
{
  QnImportSettings settings = QN_IMPORT_DEFAULTS;
  guint row = gtk_drop_down_get_selected (dialog->unit);
  if (row > 0 && row < G_N_ELEMENTS (units))
    settings.unit = qn_import_unit (units[row]);
  settings.tolerance = qn_quantity_entry_get_value (dialog->tolerance);
  settings.thickness = qn_quantity_entry_get_value (dialog->thickness);
  settings.unit_weight = qn_quantity_entry_get_value (dialog->unit_weight);
  settings.friction = qn_quantity_entry_get_value (dialog->friction);
  return settings;
}

static void
try_import (Dialog *dialog)
{
  QnImportSettings settings = settings_of (dialog);
  QnImportReport report = { 0 };
  g_autoptr (GError) error = NULL;
  GString *text = g_string_new (NULL);
  clear_project (dialog);
  dialog->has_project =
    qn_import_file (dialog->path, &settings, &dialog->project, &report, &error);
  if (!dialog->has_project)
    g_string_append (text, error->message);
  for (guint i = 0; dialog->has_project && i < report.warnings->len; i++)
    g_string_append_printf (text, "⚠ %s\n", (char *) report.warnings->pdata[i]);
  for (guint i = 0; dialog->has_project && i < report.lines->len; i++) {
    const char *line = report.lines->pdata[i];
    if (!g_ptr_array_find_with_equal_func (report.warnings, line, g_str_equal, NULL))
      g_string_append_printf (text, "%s\n", line);
  }
  if (dialog->has_project)
    qn_import_report_clear (&report);
  gtk_text_buffer_set_text (dialog->report, text->str, -1);
  g_string_free (text, TRUE);
  show_extents (dialog);
  gtk_widget_set_sensitive (dialog->accept, dialog->has_project);
  gtk_widget_queue_draw (dialog->preview);
}

static void
draw_preview (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  (void) area;
  const Dialog *dialog = data;
  cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
  cairo_paint (cr);
  if (!dialog->has_project)
    return;
  QnContacts contacts = { 0 };
  QnViewOptions options;
  qn_view_options_init (&options, QN_VIEW_MODEL);
  options.loads = false;
  QnScene *scene =
    qn_scene_build (&dialog->project.model, &contacts, NULL, &options, NULL);
  if (scene == NULL)
    return;
  QnCamera camera = { .width = width, .height = height, .scale = 1.0, .unit = 1.0 };
  qn_camera_fit (&camera, scene->box, PREVIEW_MARGIN_PX);
  qn_draw_cairo (scene, &camera, QN_LAYERS_ALL, true, cr, NULL);
  qn_scene_free (scene);
}

/* ---- answers ---- */

static void
accept (Dialog *dialog)
{
  if (!dialog->has_project)
    return;
  dialog->import (dialog->parent, &dialog->project);
  gtk_window_destroy (GTK_WINDOW (dialog->dialog));
}

static void
on_choice (GtkDropDown *choice, GParamSpec *pspec, Dialog *dialog)
{
  (void) choice;
  (void) pspec;
  try_import (dialog);
}

static void
on_quantity (QnQuantityEntry *entry, Dialog *dialog)
{
  (void) entry;
  try_import (dialog);
}

/* ---- building ---- */

static GtkWidget *
build_report (Dialog *dialog)
{
  GtkWidget *view = gtk_text_view_new ();
  gtk_text_view_set_editable (GTK_TEXT_VIEW (view), FALSE);
  gtk_text_view_set_cursor_visible (GTK_TEXT_VIEW (view), FALSE);
  gtk_text_view_set_wrap_mode (GTK_TEXT_VIEW (view), GTK_WRAP_WORD_CHAR);
  gtk_text_view_set_left_margin (GTK_TEXT_VIEW (view), 6);
  gtk_text_view_set_top_margin (GTK_TEXT_VIEW (view), 6);
  gtk_accessible_update_property (GTK_ACCESSIBLE (view), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  _ ("What was healed and left out"), -1);
  dialog->report = gtk_text_view_get_buffer (GTK_TEXT_VIEW (view));
  GtkWidget *scroller = gtk_scrolled_window_new ();
  gtk_scrolled_window_set_min_content_height (GTK_SCROLLED_WINDOW (scroller), 130);
  gtk_scrolled_window_set_child (GTK_SCROLLED_WINDOW (scroller), view);
  gtk_widget_add_css_class (scroller, "frame");
  gtk_widget_set_vexpand (scroller, TRUE);
  return scroller;
}

static GtkWidget *
build_form (Dialog *dialog)
{
  const char *const names[] = { _ ("As the file says"), "mm",       "cm", "dm", "m",
                                _ ("inches"),           _ ("feet"), NULL };
  const QnImportSettings defaults = QN_IMPORT_DEFAULTS;
  GCallback changed = G_CALLBACK (on_quantity);
  GtkWidget *form = qn_form_new ();
  dialog->unit =
    qn_form_add_choice (form, _ ("Drawing _unit"), names, G_CALLBACK (on_choice), dialog);
  dialog->extents = qn_form_add_text (form);
  gtk_widget_add_css_class (GTK_WIDGET (dialog->extents), "heading");
  dialog->tolerance =
    qn_form_add_quantity (form, _ ("Close _gaps up to (0: automatic)"),
                          QN_QUANTITY_LENGTH, 0.0, 10.0, changed, dialog);
  dialog->thickness = qn_form_add_quantity (form, _ ("_Thickness"), QN_QUANTITY_LENGTH,
                                            1e-6, 1e4, changed, dialog);
  dialog->unit_weight = qn_form_add_quantity (
    form, _ ("Unit _weight"), QN_QUANTITY_UNIT_WEIGHT, 0.0, 1e9, changed, dialog);
  dialog->friction = qn_form_add_quantity (form, _ ("_Friction"), QN_QUANTITY_NUMBER, 0.0,
                                           1e3, changed, dialog);
  qn_quantity_entry_set_value (dialog->tolerance, defaults.tolerance);
  qn_quantity_entry_set_value (dialog->thickness, defaults.thickness);
  qn_quantity_entry_set_value (dialog->unit_weight, defaults.unit_weight);
  qn_quantity_entry_set_value (dialog->friction, defaults.friction);
  qn_form_add_wide (form, build_report (dialog));
  return form;
}

static GtkWidget *
build_preview (Dialog *dialog)
{
  dialog->preview = gtk_drawing_area_new ();
  gtk_widget_set_size_request (dialog->preview, 380, 320);
  gtk_widget_set_hexpand (dialog->preview, TRUE);
  gtk_widget_set_vexpand (dialog->preview, TRUE);
  gtk_accessible_update_property (GTK_ACCESSIBLE (dialog->preview),
                                  GTK_ACCESSIBLE_PROPERTY_LABEL, _ ("Preview"), -1);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (dialog->preview), draw_preview,
                                  dialog, NULL);
  return dialog->preview;
}

static GtkWidget *
build_header (Dialog *dialog, gboolean adds)
{
  GtkWidget *header = gtk_header_bar_new ();
  gtk_header_bar_set_show_title_buttons (GTK_HEADER_BAR (header), FALSE);
  GtkWidget *cancel = gtk_button_new_with_mnemonic (_ ("_Cancel"));
  g_signal_connect_swapped (cancel, "clicked", G_CALLBACK (gtk_window_destroy),
                            dialog->dialog);
  gtk_header_bar_pack_start (GTK_HEADER_BAR (header), cancel);
  dialog->accept =
    gtk_button_new_with_mnemonic (adds ? _ ("_Add to Drawing") : _ ("_Import"));
  gtk_widget_add_css_class (dialog->accept, "suggested-action");
  g_signal_connect_swapped (dialog->accept, "clicked", G_CALLBACK (accept), dialog);
  gtk_header_bar_pack_end (GTK_HEADER_BAR (header), dialog->accept);
  return header;
}

void
qn_import_dialog_show (GtkWindow *parent, const char *path, gboolean adds,
                       QnImportFunc import)
{
  Dialog *dialog = g_new0 (Dialog, 1);
  dialog->parent = parent;
  dialog->import = import;
  dialog->path = g_strdup (path);
  g_autofree char *base = g_path_get_basename (path);
  g_autofree char *title = g_strdup_printf (_ ("Import %s"), base);
  dialog->dialog = qn_dialog_new (parent, title, 860, 520);
  gtk_window_set_titlebar (GTK_WINDOW (dialog->dialog), build_header (dialog, adds));

  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 0);
  gtk_box_append (GTK_BOX (box), build_preview (dialog));
  GtkWidget *form = build_form (dialog);
  gtk_widget_set_size_request (form, 380, -1);
  gtk_widget_set_hexpand (form, FALSE);
  gtk_box_append (GTK_BOX (box), form);
  gtk_window_set_child (GTK_WINDOW (dialog->dialog), box);
  g_object_weak_ref (G_OBJECT (box), dialog_free, dialog);
  try_import (dialog);
  gtk_window_present (GTK_WINDOW (dialog->dialog));
}
