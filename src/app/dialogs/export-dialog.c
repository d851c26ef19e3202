/* The figure dialog: what is shown, how and how large, with a live preview; then where to write
 * it, or a name under which the project keeps it. */
#include "app/dialogs/dialogs.h"

#include "app/forms/form.h"
#include "app/widgets/chooser.h"
#include "app/widgets/dialog.h"
#include "doc/view/figure-export.h"
#include "doc/view/figures.h"
#include <glib/gi18n.h>

enum { UNIT_PX, UNIT_MM };

typedef struct Dialog {
  GtkWindow *parent;
  QnViewState *state;
  QnFigureFunc write;
  QnTellFunc tell;
  GObject *chooser; /* on the screen, or NULL */
  GtkWidget *dialog, *preview;
  GtkDropDown *view, *diagram, *field, *format, *unit;
  QnQuantityEntry *width, *height, *dpi;
  GtkWidget *title, *caption, *name, *transparent;
  GtkWidget *switches[16]; /* as qn_view_switches */
  GtkLabel *trouble;
  char *refusal; /* why there is no preview; shown when the drawing is over */
  guint refusal_idle;
  QnRecipe *recipe; /* what the fields say */
} Dialog;

static void
dialog_free (gpointer data, GObject *where)
{
  (void) where;
  Dialog *dialog = data;
  g_clear_object (&dialog->chooser);
  g_clear_handle_id (&dialog->refusal_idle, g_source_remove);
  g_free (dialog->refusal);
  qn_recipe_free (dialog->recipe);
  g_free (dialog);
}

/* ---- the recipe ---- */

static const char *const endings[] = { "png", "svg", "pdf" };

/* What may be typed instead, by the format that is chosen. */
static const char *const typed_endings[][4] = { { ".png", ".svg", ".pdf" },
                                                { ".svg", ".png", ".pdf" },
                                                { ".pdf", ".png", ".svg" } };

static void
take_text (char **text, GtkWidget *entry)
{
  const char *typed = gtk_editable_get_text (GTK_EDITABLE (entry));
  g_free (*text);
  *text = *typed != '\0' ? g_strdup (typed) : NULL;
}

static void
take_output (const Dialog *dialog, QnOutput *output)
{
  qn_output_init (output);
  output->width = qn_quantity_entry_get_value (dialog->width);
  output->height = qn_quantity_entry_get_value (dialog->height);
  output->millimetres = gtk_drop_down_get_selected (dialog->unit) == UNIT_MM;
  output->dpi = output->millimetres ? qn_quantity_entry_get_value (dialog->dpi) : 0.0;
  output->transparent =
    gtk_check_button_get_active (GTK_CHECK_BUTTON (dialog->transparent));
}

static void
take_fields (Dialog *dialog)
{
  QnRecipe *recipe = dialog->recipe;
  recipe->view.view = (QnView) gtk_drop_down_get_selected (dialog->view);
  recipe->view.diagram = (QnDiagram) gtk_drop_down_get_selected (dialog->diagram);
  qn_form_set_row_visible (GTK_WIDGET (dialog->diagram),
                           recipe->view.view == QN_VIEW_DIAGRAMS);
  recipe->view.field = (QnField) gtk_drop_down_get_selected (dialog->field);
  for (gsize i = 0; qn_view_switches[i] != NULL; i++)
    *qn_view_switch (&recipe->view, qn_view_switches[i]) =
      gtk_check_button_get_active (GTK_CHECK_BUTTON (dialog->switches[i]));
  take_text (&recipe->title, dialog->title);
  take_text (&recipe->caption, dialog->caption);
  take_output (dialog, &recipe->output);
  const char *name = gtk_editable_get_text (GTK_EDITABLE (dialog->name));
  g_free (recipe->name);
  g_free (recipe->file);
  recipe->name = g_strdup (name);
  recipe->file =
    g_strdup_printf ("%s.%s", name, endings[gtk_drop_down_get_selected (dialog->format)]);
}

/* Where the fields start: what the window shows. */
static QnRecipe *
recipe_of_view (QnViewState *state)
{
  QnViewOptions shown = qn_view_state_get_options (state);
  g_autofree char *name = qn_document_dup_figure_name (qn_view_state_get_document (state),
                                                       qn_view_names[shown.view]);
  QnRecipe *recipe = qn_recipe_new (name, shown.view);
  recipe->view = shown;
  recipe->view.titles = true;
  recipe->view.onion = NULL;
  recipe->view.underlay = (QnUnderlay){ 0 };
  return recipe;
}

/* ---- preview ---- */

static gboolean
on_refusal_idle (gpointer data)
{
  Dialog *dialog = data;
  dialog->refusal_idle = 0;
  gtk_label_set_text (dialog->trouble, dialog->refusal);
  return G_SOURCE_REMOVE;
}

/* Labels must not change while the window is being drawn. */
static void
show_refusal (Dialog *dialog, const char *message)
{
  if (g_strcmp0 (dialog->refusal, message) == 0)
    return;
  g_free (dialog->refusal);
  dialog->refusal = g_strdup (message);
  if (dialog->refusal_idle == 0)
    dialog->refusal_idle = g_idle_add (on_refusal_idle, dialog);
}

static void
draw_preview (GtkDrawingArea *area, cairo_t *cr, int width, int height, gpointer data)
{
  (void) area;
  Dialog *dialog = data;
  QnFigure figure;
  QnPage page;
  g_autoptr (GError) error = NULL;
  if (!qn_output_page (&dialog->recipe->output, &page, &error)
      || !qn_view_state_get_figure_as (dialog->state, dialog->recipe, &figure, &error)) {
    show_refusal (dialog, error->message);
    return;
  }
  double scale = MIN (width / page.width, height / page.height);
  cairo_translate (cr, 0.5 * (width - scale * page.width),
                   0.5 * (height - scale * page.height));
  cairo_scale (cr, scale, scale);
  cairo_rectangle (cr, 0.0, 0.0, page.width, page.height);
  cairo_clip (cr);
  cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
  cairo_paint (cr);
  QnFrame frame = { 0.0, 0.0, page.width, page.height, 0.0 };
  gboolean drawn = qn_figure_draw (&figure, cr, &page, &frame, NULL, &error);
  show_refusal (dialog, drawn ? "" : error->message);
}

static void
redraw (Dialog *dialog)
{
  take_fields (dialog);
  qn_form_set_row_visible (GTK_WIDGET (dialog->dpi), dialog->recipe->output.millimetres);
  gtk_widget_queue_draw (dialog->preview);
}

static void
on_quantity (QnQuantityEntry *entry, Dialog *dialog)
{
  (void) entry;
  redraw (dialog);
}

static void
on_choice (GtkDropDown *choice, GParamSpec *pspec, Dialog *dialog)
{
  (void) choice;
  (void) pspec;
  redraw (dialog);
}

static void
on_unit (GtkDropDown *unit, GParamSpec *pspec, Dialog *dialog)
{
  (void) pspec;
  gboolean mm = gtk_drop_down_get_selected (unit) == UNIT_MM;
  qn_quantity_entry_set_value (dialog->width, mm ? 160.0 : 1600.0);
  qn_quantity_entry_set_value (dialog->height, mm ? 120.0 : 1200.0);
  redraw (dialog);
}

/* ---- export ---- */

static void
on_file_chosen (GtkNativeDialog *chooser, int response, Dialog *dialog)
{
  g_autoptr (GError) error = NULL;
  g_autofree char *path = NULL;
  if (response == GTK_RESPONSE_ACCEPT) {
    const char *const *known = typed_endings[gtk_drop_down_get_selected (dialog->format)];
    path = qn_dialog_dup_chosen_path (chooser, known, &error);
  }
  g_clear_object (&dialog->chooser);
  if (response != GTK_RESPONSE_ACCEPT)
    return;
  if (path != NULL)
    dialog->write (dialog->parent, path, g_steal_pointer (&dialog->recipe));
  else
    dialog->tell (dialog->parent, error->message, TRUE);
  gtk_window_destroy (GTK_WINDOW (dialog->dialog));
}

static void
on_export (Dialog *dialog)
{
  GtkFileChooserNative *chooser =
    qn_chooser_begin (GTK_WINDOW (dialog->dialog), &dialog->chooser,
                      GTK_FILE_CHOOSER_ACTION_SAVE, _ ("Export Figure"), _ ("_Export"));
  take_fields (dialog);
  g_autofree char *name =
    qn_document_dup_display_name (qn_view_state_get_document (dialog->state));
  g_autofree char *proposed = g_strdup_printf ("%s – %s", name, dialog->recipe->file);
  gtk_file_chooser_set_current_name (GTK_FILE_CHOOSER (chooser),
                                     g_strdelimit (proposed, "/", '-'));
  g_signal_connect (chooser, "response", G_CALLBACK (on_file_chosen), dialog);
  gtk_native_dialog_show (GTK_NATIVE_DIALOG (chooser));
}

static void
on_store (Dialog *dialog)
{
  g_autoptr (GError) error = NULL;
  take_fields (dialog);
  if (qn_document_store_figure (qn_view_state_get_document (dialog->state),
                                dialog->recipe, &error)) {
    g_autofree char *message =
      g_strdup_printf (_ ("Figure “%s” is kept in the project"), dialog->recipe->name);
    dialog->tell (dialog->parent, message, FALSE);
    gtk_window_destroy (GTK_WINDOW (dialog->dialog));
  } else
    gtk_label_set_text (dialog->trouble, error->message);
}

/* ---- building ---- */

static GtkWidget *
add_entry (Dialog *dialog, GtkWidget *form, const char *label, const char *placeholder)
{
  GtkWidget *entry = gtk_entry_new ();
  gtk_entry_set_placeholder_text (GTK_ENTRY (entry), placeholder);
  g_signal_connect_swapped (entry, "changed", G_CALLBACK (redraw), dialog);
  qn_form_add_row (form, label, entry);
  return entry;
}

static void
add_content (Dialog *dialog, GtkWidget *form)
{
  const char *const views[] = { _ ("Model"),
                                _ ("Contacts"),
                                _ ("Deformed"),
                                _ ("Mechanism"),
                                _ ("Forces"),
                                _ ("Diagrams"),
                                NULL };
  const char *const diagrams[] = { _ ("Bending moments"), _ ("Shear forces"),
                                   _ ("Normal forces"), NULL };
  const char *const fields[] = {
    C_ ("colours", "None"),       _ ("Displacement"),      _ ("Displacement, horizontal"),
    _ ("Displacement, vertical"), _ ("Rotation"),          _ ("Stress"),
    _ ("Opening of joints"),      _ ("Sliding of joints"), NULL
  };
  GCallback chosen = G_CALLBACK (on_choice);
  dialog->view = qn_form_add_choice (form, _ ("_View"), views, chosen, dialog);
  qn_form_set_choice (dialog->view, (guint) dialog->recipe->view.view, dialog);
  dialog->diagram = qn_form_add_choice (form, _ ("D_iagram"), diagrams, chosen, dialog);
  qn_form_set_choice (dialog->diagram, (guint) dialog->recipe->view.diagram, dialog);
  dialog->field = qn_form_add_choice (form, _ ("_Colours"), fields, chosen, dialog);
  qn_form_set_choice (dialog->field, (guint) dialog->recipe->view.field, dialog);
  dialog->title = add_entry (dialog, form, _ ("T_itle"), _ ("as the project"));
  dialog->caption = add_entry (dialog, form, _ ("Ca_ption"), _ ("by itself"));
}

static GtkWidget *
make_check (Dialog *dialog, const char *label, gboolean active)
{
  GtkWidget *check = gtk_check_button_new_with_mnemonic (label);
  gtk_check_button_set_active (GTK_CHECK_BUTTON (check), active);
  g_signal_connect_swapped (check, "toggled", G_CALLBACK (redraw), dialog);
  return check;
}

/* Words for the switches, in two columns. */
static void
add_switches (Dialog *dialog, GtkWidget *form)
{
  static const char *const words[][2] = {
    { "ghost", N_ ("_Undeformed ghost") },
    { "symbols", N_ ("Joint s_ymbols") },
    { "loads", N_ ("_Loads") },
    { "dimensions", N_ ("_Dimensions") },
    { "names", N_ ("Block _names") },
    { "legend", N_ ("Le_gend") },
    { "titles", N_ ("Title and multiplier") },
    { "monochrome", N_ ("_Black and white") },
  };
  GtkWidget *grid = gtk_grid_new ();
  gtk_grid_set_column_spacing (GTK_GRID (grid), 12);
  int shown = 0;
  for (gsize i = 0; qn_view_switches[i] != NULL; i++) {
    const char *label = qn_view_switches[i];
    for (gsize k = 0; k < G_N_ELEMENTS (words); k++)
      if (g_str_equal (words[k][0], qn_view_switches[i]))
        label = _ (words[k][1]);
    dialog->switches[i] = make_check (
      dialog, label, *qn_view_switch (&dialog->recipe->view, qn_view_switches[i]));
    gtk_grid_attach (GTK_GRID (grid), dialog->switches[i], shown % 2, shown / 2, 1, 1);
    shown++;
  }
  dialog->transparent = make_check (dialog, _ ("_Transparent ground"), FALSE);
  gtk_grid_attach (GTK_GRID (grid), dialog->transparent, shown % 2, shown / 2, 1, 1);
  qn_form_add_wide (form, grid);
}

static void
add_size (Dialog *dialog, GtkWidget *form)
{
  const char *const units[] = { _ ("Pixels"), _ ("Millimetres"), NULL };
  const char *const formats[] = { "PNG", "SVG", "PDF", NULL };
  GCallback changed = G_CALLBACK (on_quantity);
  dialog->format =
    qn_form_add_choice (form, _ ("_Format"), formats, G_CALLBACK (on_choice), dialog);
  dialog->unit =
    qn_form_add_choice (form, _ ("_Size in"), units, G_CALLBACK (on_unit), dialog);
  dialog->width = qn_form_add_quantity (form, _ ("_Width"), QN_QUANTITY_NUMBER, 1.0,
                                        32000.0, changed, dialog);
  dialog->height = qn_form_add_quantity (form, _ ("_Height"), QN_QUANTITY_NUMBER, 1.0,
                                         32000.0, changed, dialog);
  dialog->dpi = qn_form_add_quantity (form, _ ("D_ots per inch"), QN_QUANTITY_NUMBER,
                                      10.0, 2400.0, changed, dialog);
  qn_quantity_entry_set_value (dialog->width, dialog->recipe->output.width);
  qn_quantity_entry_set_value (dialog->height, dialog->recipe->output.height);
  qn_quantity_entry_set_value (dialog->dpi, 300.0);
}

static GtkWidget *
build_form (Dialog *dialog)
{
  GtkWidget *form = qn_form_new ();
  add_content (dialog, form);
  add_switches (dialog, form);
  add_size (dialog, form);
  dialog->name = gtk_entry_new ();
  gtk_editable_set_text (GTK_EDITABLE (dialog->name), dialog->recipe->name);
  qn_form_add_row (form, _ ("Na_me in the project"), dialog->name);
  dialog->trouble = qn_form_add_text (form);
  return form;
}

static GtkWidget *
build_header (Dialog *dialog)
{
  GtkWidget *header = gtk_header_bar_new ();
  GtkWidget *store = gtk_button_new_with_mnemonic (_ ("_Keep in Project"));
  gtk_widget_set_tooltip_text (
    store, _ ("Keeps what the figure shows, so that it can be made again after changes"));
  g_signal_connect_swapped (store, "clicked", G_CALLBACK (on_store), dialog);
  GtkWidget *export = gtk_button_new_with_mnemonic (_ ("_Export…"));
  gtk_widget_add_css_class (export, "suggested-action");
  g_signal_connect_swapped (export, "clicked", G_CALLBACK (on_export), dialog);
  gtk_header_bar_pack_end (GTK_HEADER_BAR (header), export);
  gtk_header_bar_pack_end (GTK_HEADER_BAR (header), store);
  return header;
}

static GtkWidget *
build_preview (Dialog *dialog)
{
  dialog->preview = gtk_drawing_area_new ();
  gtk_widget_set_size_request (dialog->preview, 420, 320);
  gtk_widget_set_hexpand (dialog->preview, TRUE);
  gtk_widget_set_vexpand (dialog->preview, TRUE);
  gtk_widget_set_margin_start (dialog->preview, 12);
  gtk_widget_set_margin_top (dialog->preview, 12);
  gtk_widget_set_margin_bottom (dialog->preview, 12);
  gtk_accessible_update_property (GTK_ACCESSIBLE (dialog->preview),
                                  GTK_ACCESSIBLE_PROPERTY_LABEL, _ ("Preview"), -1);
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (dialog->preview), draw_preview,
                                  dialog, NULL);
  return dialog->preview;
}

void
qn_export_dialog_show (GtkWindow *parent, QnViewState *state, QnFigureFunc write,
                       QnTellFunc tell)
{
  Dialog *dialog = g_new0 (Dialog, 1);
  dialog->parent = parent;
  dialog->state = state;
  dialog->write = write;
  dialog->tell = tell;
  dialog->recipe = recipe_of_view (state);
  dialog->dialog = qn_dialog_new (parent, _ ("Export Figure"), 960, 620);
  gtk_window_set_titlebar (GTK_WINDOW (dialog->dialog), build_header (dialog));

  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 12);
  gtk_box_append (GTK_BOX (box), build_preview (dialog));
  GtkWidget *form = build_form (dialog);
  gtk_widget_set_hexpand (form, FALSE);
  GtkWidget *scroller = gtk_scrolled_window_new ();
  gtk_scrolled_window_set_policy (GTK_SCROLLED_WINDOW (scroller), GTK_POLICY_NEVER,
                                  GTK_POLICY_AUTOMATIC);
  gtk_scrolled_window_set_child (GTK_SCROLLED_WINDOW (scroller), form);
  gtk_box_append (GTK_BOX (box), scroller);
  gtk_window_set_child (GTK_WINDOW (dialog->dialog), box);
  g_object_weak_ref (G_OBJECT (box), dialog_free, dialog);
  redraw (dialog);
  gtk_window_present (GTK_WINDOW (dialog->dialog));
}
