/* The figure dialog: what is shown, how and how large, with a live preview; then where to write
 * it, or a name under which the project keeps it. */
#include "app/dialogs/dialogs.h"

#include "app/forms/form.h"
#include "app/widgets/chooser.h"
#include "app/widgets/dialog.h"
#include "doc/view/figures.h"
#include <glib/gi18n.h>

typedef struct Dialog {
  QnForm base;
  GtkWindow *parent;
  QnViewState *state;
  QnFigureFunc write;
  QnTellFunc tell;
  guint format;  /* row */
  double dpi;    /* of sizes in mm */
  char *refusal; /* why there is no preview; shown when the drawing is over */
  guint refusal_idle;
  QnRecipe *recipe; /* what the fields say */
} Dialog;

#define FIELDS(FIELD, MEMBER)                                                            \
  MEMBER (VIEW, "view", NULL, QnRecipe, view.view)                                       \
  MEMBER (DIAGRAM, "diagram", NULL, QnRecipe, view.diagram)                              \
  MEMBER (COLOURS, "field", NULL, QnRecipe, view.field)                                  \
  MEMBER (TITLE, "title", NULL, QnRecipe, title)                                         \
  MEMBER (CAPTION, "caption", NULL, QnRecipe, caption)                                   \
  FIELD (SWITCH, "ghost", NULL) /* as qn_view_switches */                                \
  FIELD (SYMBOLS, "symbols", NULL)                                                       \
  FIELD (LOADS, "loads", NULL)                                                           \
  FIELD (DIMENSIONS, "dimensions", NULL)                                                 \
  FIELD (NAMES, "names", NULL)                                                           \
  FIELD (VALUES, "values", NULL)                                                         \
  FIELD (LEGEND, "legend", NULL)                                                         \
  FIELD (TITLES, "titles", NULL)                                                         \
  FIELD (MONOCHROME, "monochrome", NULL)                                                 \
  MEMBER (TRANSPARENT, "transparent", NULL, QnRecipe, output.transparent)                \
  MEMBER (FORMAT, "format", NULL, Dialog, format)                                        \
  MEMBER (UNIT, "unit", NULL, QnRecipe, output.millimetres)                              \
  MEMBER (WIDTH, "width", NULL, QnRecipe, output.width)                                  \
  MEMBER (HEIGHT, "height", NULL, QnRecipe, output.height)                               \
  MEMBER (DPI, "dpi", NULL, Dialog, dpi)                                                 \
  MEMBER (NAME, "name", NULL, QnRecipe, name)                                            \
  FIELD (TROUBLE, "trouble", NULL)                                                       \
  FIELD (PREVIEW, "preview", NULL)                                                       \
  FIELD (EXPORT, "export", NULL)                                                         \
  FIELD (STORE, "store", NULL)
QN_FORM_FIELDS;

static void
clear (QnForm *data)
{
  Dialog *dialog = (Dialog *) data;
  g_clear_handle_id (&dialog->refusal_idle, g_source_remove);
  g_free (dialog->refusal);
  qn_recipe_free (dialog->recipe);
}

/* ---- the recipe ---- */

static const char *const endings[] = { "png", "svg", "pdf" };

/* What may be typed instead, by the format that is chosen. */
static const char *const typed_endings[][4] = { { ".png", ".svg", ".pdf" },
                                                { ".svg", ".png", ".pdf" },
                                                { ".pdf", ".png", ".svg" } };

static void
take_text (char **text, gpointer dialog, guint field)
{
  char *typed = qn_form_dup_text (dialog, field);
  g_free (*text);
  *text = *typed != '\0' ? typed : NULL;
  if (*text == NULL)
    g_free (typed);
}

/* Entries count as they are, whether they have been left or not. */
static void
take_entries (Dialog *dialog)
{
  QnRecipe *recipe = dialog->recipe;
  g_autofree char *name = qn_form_dup_text (dialog, NAME);
  take_text (&recipe->title, dialog, TITLE);
  take_text (&recipe->caption, dialog, CAPTION);
  g_free (recipe->name);
  g_free (recipe->file);
  recipe->file = g_strdup_printf ("%s.%s", name, endings[dialog->format]);
  recipe->name = g_steal_pointer (&name);
}

/* ---- preview ---- */

static gboolean
on_refusal_idle (gpointer data)
{
  Dialog *dialog = data;
  dialog->refusal_idle = 0;
  gtk_label_set_text (GTK_LABEL (dialog->base.widgets[TROUBLE]), dialog->refusal);
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
  gboolean drawn = qn_figure_draw_page (cr, &page, &figure, &error);
  show_refusal (dialog, drawn ? "" : error->message);
}

static void
on_typed (Dialog *dialog)
{
  take_entries (dialog);
  gtk_widget_queue_draw (dialog->base.widgets[PREVIEW]);
}

/* ---- export ---- */

static gboolean
use_chosen (gpointer data, const char *path, GError **error)
{
  Dialog *dialog = data;
  dialog->write (dialog->parent, path, g_steal_pointer (&dialog->recipe));
  gtk_window_destroy (GTK_WINDOW (dialog->base.root));
  return TRUE;
}

static void
refuse (gpointer data, const char *message)
{
  gtk_label_set_text (GTK_LABEL (((Dialog *) data)->base.widgets[TROUBLE]), message);
}

static void
on_export (Dialog *dialog)
{
  take_entries (dialog);
  g_autofree char *name = qn_document_dup_display_name (dialog->state->document);
  g_autofree char *proposed = g_strdup_printf ("%s – %s", name, dialog->recipe->file);
  const QnFileQuestion question = { .title = _ ("Export Figure"),
                                    .accept = _ ("_Export"),
                                    .name = g_strdelimit (proposed, "/", '-'),
                                    .endings = typed_endings[dialog->format],
                                    .use = use_chosen,
                                    .failed = refuse };
  qn_chooser_ask (GTK_WIDGET (dialog->base.root), &question, dialog);
}

static void
on_store (Dialog *dialog)
{
  g_autoptr (GError) error = NULL;
  take_entries (dialog);
  if (qn_document_store_figure (dialog->state->document, dialog->recipe, &error)) {
    g_autofree char *message =
      g_strdup_printf (_ ("Figure “%s” is kept in the project"), dialog->recipe->name);
    dialog->tell (dialog->parent, message);
    gtk_window_destroy (GTK_WINDOW (dialog->base.root));
  } else
    refuse (dialog, error->message);
}

/* ---- fields ---- */

static gpointer
subject (QnForm *data, QnModel *model, guint field)
{
  Dialog *dialog = (Dialog *) data;
  return field == FORMAT || field == DPI ? (gpointer) data : dialog->recipe;
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Dialog *dialog = (const Dialog *) data;
  QnRecipe *recipe = dialog->recipe;
  switch (field) {
  case DIAGRAM:
    return recipe->view.view == QN_VIEW_DIAGRAMS;
  case DPI:
    return recipe->output.millimetres;
  case TROUBLE:
    value->text = g_strdup (dialog->refusal);
    return TRUE;
  case PREVIEW:
    gtk_widget_queue_draw (dialog->base.widgets[PREVIEW]);
    return TRUE;
  default:
    if (field >= SWITCH && field < TRANSPARENT)
      value->number = *qn_view_switch (&recipe->view, fields[field].id);
    return TRUE;
  }
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  Dialog *dialog = (Dialog *) data;
  QnRecipe *recipe = dialog->recipe;
  QnOutput *output = &recipe->output;
  gboolean on = value->number != 0.0;
  switch (field) {
  case UNIT:
    output->width = on ? 160.0 : 1600.0;
    output->height = on ? 120.0 : 1200.0;
    break;
  case EXPORT:
    on_export (dialog);
    return TRUE;
  case STORE:
    on_store (dialog);
    return TRUE;
  default:
    if (field >= SWITCH && field < TRANSPARENT)
      *qn_view_switch (&recipe->view, fields[field].id) = on;
    break;
  }
  output->dpi = output->millimetres ? dialog->dpi : 0.0;
  take_entries (dialog);
  return TRUE;
}

void
qn_export_dialog_show (GtkWindow *parent, QnViewState *state, QnFigureFunc write,
                       QnTellFunc tell)
{
  static const QnFormKind kind =
    QN_FORM_KIND ("export-dialog", Dialog, .clear = clear, .subject = subject);
  Dialog *dialog = qn_form_new (&kind, NULL);
  GtkWidget **widgets = dialog->base.widgets;
  dialog->parent = parent;
  dialog->state = state;
  dialog->write = write;
  dialog->tell = tell;
  dialog->dpi = 300.0;
  /* The fields start with what the window shows. */
  QnViewOptions shown = qn_view_state_get_options (state);
  g_autofree char *name =
    qn_document_dup_figure_name (state->document, qn_view_names[shown.view]);
  dialog->recipe = qn_recipe_new (name, shown.view);
  dialog->recipe->view = shown;
  dialog->recipe->view.titles = true;
  dialog->recipe->view.onion = NULL;
  dialog->recipe->view.underlay = (QnUnderlay){ 0 };
  gtk_drawing_area_set_draw_func (GTK_DRAWING_AREA (widgets[PREVIEW]), draw_preview,
                                  dialog, NULL);
  qn_form_show (dialog);
  take_entries (dialog);
  for (guint field = TITLE; field <= CAPTION; field++)
    g_signal_connect_swapped (widgets[field], "changed", G_CALLBACK (on_typed), dialog);
  qn_dialog_present (dialog->base.root, parent, "export", widgets[EXPORT]);
}
