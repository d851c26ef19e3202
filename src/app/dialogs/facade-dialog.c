/* The strip of a façade by its numbers, with a picture of what it becomes: the keys of
 * `quoin-cli generate facade-strip`. Lists go from the bottom storey upwards. */
#include "app/dialogs/dialogs.h"

#include "app/widgets/builder.h"
#include "app/widgets/dialog.h"
#include "app/widgets/preview.h"
#include "app/widgets/settings.h"
#include "doc/text/units.h"
#include "io/project/project-generate.h"
#include "io/text/text-format.h"

#include <glib/gi18n.h>

#define MOST_NUMBERS 20

/* The last is no key: friction of the joints. */
static const struct {
  const char *key;
  QnQuantity quantity;
  double usual[2];
  gsize count; /* of them; 0: empty */
} fields[] = {
  { "storeys", QN_QUANTITY_LENGTH, { 3, 3 }, 2 },
  { "thickness", QN_QUANTITY_LENGTH, { 0.5 }, 1 },
  { "floors", QN_QUANTITY_FORCE, { 0 }, 1 },
  { "bearing", QN_QUANTITY_LENGTH, { 0.2 }, 1 },
  { "floor-friction", QN_QUANTITY_NUMBER, { 0 }, 1 },
  { "floor-inertia", QN_QUANTITY_NUMBER, { 1 }, 1 },
  { "held", QN_QUANTITY_NUMBER, { 0 }, 0 },
  { "ties", QN_QUANTITY_FORCE, { 0 }, 1 },
  { "flanks", QN_QUANTITY_FORCE, { 0 }, 1 },
  { "thrust", QN_QUANTITY_FORCE, { 0 }, 1 },
  { "parapet", QN_QUANTITY_LENGTH, { 0 }, 0 },
  { "courses", QN_QUANTITY_NUMBER, { 4 }, 1 },
  { "width", QN_QUANTITY_LENGTH, { 1 }, 1 },
  { "unit-weight", QN_QUANTITY_UNIT_WEIGHT, { 18000 }, 1 },
  { "friction", QN_QUANTITY_NUMBER, { 0.65 }, 1 },
};
#define KEYS (G_N_ELEMENTS (fields) - 1)

typedef struct Dialog {
  GtkWindow *window, *parent;
  GtkEditable *entries[G_N_ELEMENTS (fields)];
  GtkWidget *preview, *accept;
  GtkLabel *report;
  QnImportFunc import;
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

/* The numbers of an entry; NULL with an error that the entry shows. */
static char *
dup_key (const Dialog *dialog, gsize i, double *values, GError **error)
{
  GtkWidget *entry = GTK_WIDGET (dialog->entries[i]);
  GString *text = g_string_new (NULL);
  gsize count;
  gboolean done = qn_units_parse_list (qn_settings_get_units (), fields[i].quantity,
                                       gtk_editable_get_text (dialog->entries[i]), values,
                                       MOST_NUMBERS, &count, error);
  g_string_append_printf (text, "%s=[", fields[i].key);
  for (gsize k = 0; done && k < count; k++) {
    char number[QN_NUMBER_TEXT_SIZE];
    g_string_append_printf (text, "%s%s", k > 0 ? "," : "",
                            qn_number_text (values[k], number));
  }
  /* An empty entry is none: 0. */
  g_string_append (text, count > 0 ? "]" : "0]");
  if (done)
    gtk_widget_remove_css_class (entry, "error");
  else
    gtk_widget_add_css_class (entry, "error");
  return g_string_free (text, !done);
}

static gboolean
generate (Dialog *dialog, GError **error)
{
  g_autoptr (GPtrArray) given = g_ptr_array_new_with_free_func (g_free);
  double friction = 0;
  for (gsize i = 0; i < G_N_ELEMENTS (fields); i++) {
    double values[MOST_NUMBERS] = { 0 };
    char *key = dup_key (dialog, i, values, error);
    if (key == NULL)
      return FALSE;
    g_ptr_array_add (given, key);
    friction = values[0];
  }
  g_ptr_array_set_size (given, KEYS);
  g_ptr_array_add (given, NULL);
  return qn_project_generate ("facade-strip", (const char *const *) given->pdata,
                              friction, &dialog->project, error);
}

static void
update (Dialog *dialog)
{
  g_autoptr (GError) error = NULL;
  clear_project (dialog);
  dialog->has_project = generate (dialog, &error);
  gtk_label_set_text (dialog->report, error != NULL ? error->message : "");
  gtk_widget_set_sensitive (dialog->accept, dialog->has_project);
  gtk_widget_queue_draw (dialog->preview);
}

static void
draw_preview (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  const Dialog *dialog = data;
  if (dialog->has_project)
    qn_preview_draw (&dialog->project.model, TRUE, cr, width, height, NULL);
}

static void
on_accept (Dialog *dialog)
{
  dialog->import (dialog->parent, &dialog->project);
  gtk_window_destroy (dialog->window);
}

void
qn_facade_dialog_show (GtkWindow *parent, QnImportFunc import)
{
  Dialog *dialog = g_new0 (Dialog, 1);
  g_autoptr (GtkBuilder) builder = qn_builder_new ("facade-dialog");
  dialog->parent = parent;
  dialog->import = import;
  dialog->window = GTK_WINDOW (qn_builder_get_widget (builder, "form"));
  dialog->preview = qn_builder_get_widget (builder, "preview");
  dialog->accept = qn_builder_get_widget (builder, "accept");
  dialog->report = GTK_LABEL (qn_builder_get_widget (builder, "report"));
  for (gsize i = 0; i < G_N_ELEMENTS (fields); i++) {
    g_autofree char *text = qn_units_format_list (
      qn_settings_get_units (), fields[i].quantity, fields[i].usual, fields[i].count, 15);
    dialog->entries[i] = GTK_EDITABLE (qn_builder_get_widget (builder, fields[i].key));
    gtk_editable_set_text (dialog->entries[i], text);
    g_signal_connect_swapped (dialog->entries[i], "changed", G_CALLBACK (update), dialog);
  }
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (dialog->preview), draw_preview,
                                  dialog, NULL);
  qn_own (GTK_WIDGET (dialog->window), dialog);
  g_signal_connect_swapped (dialog->window, "unrealize", G_CALLBACK (clear_project),
                            dialog);
  g_signal_connect_swapped (dialog->accept, "clicked", G_CALLBACK (on_accept), dialog);
  g_signal_connect_swapped (qn_builder_get_widget (builder, "cancel"), "clicked",
                            G_CALLBACK (gtk_window_destroy), dialog->window);
  update (dialog);
  qn_dialog_present (GTK_WIDGET (dialog->window), parent, "earthquakes", dialog->accept);
}
