/* The figures of the project: which there are, whether the model has changed since they were
 * stored, and all of them made again. */
#include "app/pages/pages.h"

#include "app/widgets/builder.h"
#include "app/widgets/dialog.h"
#include "app/widgets/help.h"
#include "doc/view/figures.h"
#include "io/text/io-error.h"
#include <glib/gi18n.h>

typedef struct Figures {
  QnDocument *document;
  GtkWidget *page, *list;
  gboolean waiting;  /* for an analysis, before the figures are made */
  const char *asked; /* the figure that is asked about, or NULL */
} Figures;

static void
tell (Figures *figures, const char *text)
{
  gtk_label_set_text (qn_part (figures->page, "message"), text);
  gtk_widget_set_visible (qn_part (figures->page, "message"), *text != '\0');
}

/* ---- making them ---- */

static void make_all (Figures *figures);

static void
on_allowed (QnAnswer answer, gpointer data)
{
  Figures *figures = data;
  g_autoptr (GPtrArray) recipes = qn_document_get_figures (figures->document, NULL);
  gboolean allowed = FALSE;
  for (guint i = 0; answer == QN_ANSWER_REJECT && recipes != NULL && i < recipes->len;
       i++) {
    const QnRecipe *recipe = g_ptr_array_index (recipes, i);
    if (!g_str_equal (recipe->name, figures->asked))
      continue;
    qn_document_allow_figure (figures->document, recipe);
    allowed = TRUE;
  }
  if (allowed)
    make_all (figures);
}

static void
make_all (Figures *figures)
{
  g_autoptr (GError) error = NULL;
  g_autoptr (GPtrArray) recipes = qn_document_get_figures (figures->document, &error);
  g_autoptr (GPtrArray) made = g_ptr_array_new ();
  if (recipes != NULL)
    qn_recipes_check_files (recipes, NULL, &error);
  for (guint i = 0; error == NULL && i < recipes->len; i++) {
    const QnRecipe *recipe = g_ptr_array_index (recipes, i);
    if (qn_document_export_figure (figures->document, recipe, &error))
      g_ptr_array_add (made, recipe->file);
    /* A project from elsewhere may name any file: the user decides about each figure. */
    if (g_error_matches (error, QN_IO_ERROR, QN_IO_ERROR_OUTSIDE)) {
      figures->asked = g_intern_string (recipe->name);
      qn_dialog_ask (GTK_WINDOW (gtk_widget_get_root (figures->list)),
                     _ ("Use files outside the project's folder?"), error->message,
                     _ ("_Allow for This Figure"), NULL, NULL, on_allowed, figures);
    }
  }
  if (error != NULL) {
    tell (figures, error->message);
    return;
  }
  g_ptr_array_add (made, NULL);
  g_autofree char *files = g_strjoinv (", ", (char **) made->pdata);
  g_autofree char *text = g_strdup_printf (_ ("Written to %s"), files);
  tell (figures, text);
}

static gboolean
any_waits (Figures *figures)
{
  g_autoptr (GPtrArray) recipes = qn_document_get_figures (figures->document, NULL);
  for (guint i = 0; recipes != NULL && i < recipes->len; i++) {
    if (qn_document_figure_waits (figures->document, g_ptr_array_index (recipes, i)))
      return TRUE;
  }
  return FALSE;
}

/* One analysis serves all figures that need one. */
static void
on_export_all (Figures *figures)
{
  g_autoptr (GError) error = NULL;
  if (!any_waits (figures)) {
    make_all (figures);
    return;
  }
  figures->waiting = qn_document_analyse (figures->document, &error);
  tell (figures, figures->waiting ? _ ("Solving first…") : error->message);
}

static void
on_job_changed (Figures *figures)
{
  if (!figures->waiting || figures->document->job != NULL)
    return;
  figures->waiting = FALSE;
  const GError *error = figures->document->job_error;
  if (error != NULL)
    tell (figures, error->message);
  else if (any_waits (figures))
    tell (figures, _ ("The analysis was cancelled; no figure has been made."));
  else
    make_all (figures);
}

/* ---- the list ---- */

static void
on_remove (GtkButton *button, Figures *figures)
{
  g_autofree char *name = g_strdup (g_object_get_data (G_OBJECT (button), "qn-name"));
  g_autoptr (GError) error = NULL;
  if (!qn_document_remove_figure (figures->document, name, &error))
    tell (figures, error->message);
}

static void
update (Figures *figures)
{
  GtkWidget *child;
  while ((child = gtk_widget_get_first_child (figures->list)) != NULL)
    gtk_list_box_remove (GTK_LIST_BOX (figures->list), child);
  g_autoptr (GError) error = NULL;
  g_autoptr (GPtrArray) recipes = qn_document_get_figures (figures->document, &error);
  guint count = recipes != NULL ? recipes->len : 0;
  for (guint i = 0; i < count; i++) {
    const QnRecipe *recipe = g_ptr_array_index (recipes, i);
    gboolean stale =
      qn_recipe_is_stale (recipe, qn_document_get_project (figures->document));
    g_autoptr (GtkBuilder) row = qn_builder_new ("figure-row");
    g_autofree char *text = g_strdup_printf (
      "%s → %s%s%s", qn_view_names[recipe->view.view], recipe->file, stale ? " · " : "",
      stale ? _ ("the model has changed since") : "");
    gtk_label_set_text (GTK_LABEL (qn_builder_get_widget (row, "name")), recipe->name);
    gtk_label_set_text (GTK_LABEL (qn_builder_get_widget (row, "what")), text);
    GtkWidget *remove = qn_builder_get_widget (row, "remove");
    g_object_set_data_full (G_OBJECT (remove), "qn-name", g_strdup (recipe->name),
                            g_free);
    g_signal_connect (remove, "clicked", G_CALLBACK (on_remove), figures);
    gtk_list_box_append (GTK_LIST_BOX (figures->list),
                         qn_builder_take_widget (row, "row"));
  }
  gtk_widget_set_visible (figures->list, count > 0);
  gtk_widget_set_sensitive (qn_part (figures->page, "export_all"), count > 0);
  if (error != NULL)
    tell (figures, error->message);
  else
    tell (figures, count > 0
                     ? ""
                     : _ ("No figure is stored yet. Store one with Export Figure: "
                          "what it shows is kept in the project and can be made "
                          "again after every change, here and with quoin-cli "
                          "figures."));
}

GtkWidget *
qn_figures_page_new (QnDocument *document)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("figures-page");
  GtkWidget *page = qn_builder_take_widget (builder, "content");
  Figures *figures = g_new (Figures, 1);
  *figures = (Figures){ document, page, qn_part (page, "list"), FALSE, NULL };
  g_signal_connect_swapped (qn_part (figures->page, "export_all"), "clicked",
                            G_CALLBACK (on_export_all), figures);
  qn_help_set_page (page, "export");
  qn_own (page, figures);
  qn_watch (page, document, "changed", G_CALLBACK (update), figures);
  qn_watch (page, document, "job-changed", G_CALLBACK (on_job_changed), figures);
  update (figures);
  return page;
}
