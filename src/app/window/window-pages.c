/* The pages under the drawing, or in a window of their own: runs beside each other, capacity curve, study, figures.
 * Each is made when it is asked for, and stays until it is closed; Escape goes back to the drawing. */
#include "app/pages/pages.h"
#include "app/widgets/builder.h"
#include "app/widgets/text-unit.h"
#include "app/window/action-table.h"
#include "app/window/window-private.h"
#include "study/plan/study.h"
#include <glib/gi18n.h>

/* px of the window below which a page has the place of the drawing, with text of usual size. */
#define SHARED_HEIGHT 1200

/* ---- what is in sight ---- */

GtkWidget *
qn_window_get_page (QnWindow *self)
{
  gboolean apart = self->page_window != NULL;
  return gtk_widget_get_visible (self->page_box)
             && (!apart || gtk_window_is_active (GTK_WINDOW (self->page_window)))
           ? gtk_stack_get_visible_child (self->pages)
           : NULL;
}

void
qn_window_take_pages_back (QnWindow *self)
{
  GtkWidget *window = g_steal_pointer (&self->page_window);
  if (window == NULL)
    return;
  gtk_window_set_focus (GTK_WINDOW (window), NULL);
  g_object_ref (self->page_box);
  gtk_window_set_child (GTK_WINDOW (window), NULL);
  gtk_paned_set_end_child (self->middle, self->page_box);
  g_object_unref (self->page_box);
  gtk_widget_set_visible (GTK_WIDGET (self->fill_button), TRUE);
  gtk_window_destroy (GTK_WINDOW (window));
  qn_window_arrange (self);
}

void
qn_window_show_drawing (QnWindow *self, gboolean alone)
{
  if (!alone && !gtk_toggle_button_get_active (self->fill_button))
    return;
  qn_window_take_pages_back (self);
  gtk_widget_set_visible (self->page_box, FALSE);
  qn_window_arrange (self);
  gtk_widget_grab_focus (GTK_WIDGET (self->canvas));
}

static void
show_drawing (QnWindow *self, const char *name)
{
  qn_window_show_drawing (self, FALSE);
}

static gboolean
on_close_apart (QnWindow *self)
{
  qn_window_show_drawing (self, TRUE);
  return GDK_EVENT_STOP;
}

/* The pages with the actions and keys of this window, or back from there. */
static void
own_window (QnWindow *self, const char *name)
{
  if (self->page_window != NULL) {
    qn_window_take_pages_back (self);
    return;
  }
  g_autoptr (GtkBuilder) builder = qn_builder_new ("page-window");
  GtkWidget *window = qn_builder_get_widget (builder, "window");
  qn_action_complete_tooltips (window);
  gtk_window_set_application (GTK_WINDOW (window),
                              gtk_window_get_application (GTK_WINDOW (self)));
  gtk_widget_insert_action_group (window, "win", G_ACTION_GROUP (self));
  g_object_bind_property (self, "title", window, "title", G_BINDING_SYNC_CREATE);
  gtk_toggle_button_set_active (self->fill_button, FALSE);
  gtk_widget_set_visible (GTK_WIDGET (self->fill_button), FALSE);
  g_object_ref (self->page_box);
  gtk_paned_set_end_child (self->middle, NULL);
  gtk_window_set_child (GTK_WINDOW (window), self->page_box);
  g_object_unref (self->page_box);
  self->page_window = window;
  g_signal_connect_object (window, "close-request", G_CALLBACK (on_close_apart), self,
                           G_CONNECT_SWAPPED);
  g_signal_connect_object (window, "notify::is-active", G_CALLBACK (qn_window_arrange),
                           self, G_CONNECT_SWAPPED);
  qn_window_arrange (self);
  gtk_window_present (GTK_WINDOW (window));
  gtk_widget_child_focus (GTK_WIDGET (self->pages), GTK_DIR_TAB_FORWARD);
}

static void
show (QnWindow *self, GtkWidget *page)
{
  int height = gtk_widget_get_height (GTK_WIDGET (self));
  if (qn_window_is_blank (self))
    qn_window_show_work (self);
  if (!gtk_widget_get_visible (self->page_box)) {
    double text = qn_text_unit (GTK_WIDGET (self)) / QN_TEXT_UNIT;
    gtk_toggle_button_set_active (self->fill_button, height < SHARED_HEIGHT * text);
    gtk_paned_set_position (self->middle, height / 2);
    gtk_widget_set_visible (self->page_box, TRUE);
  }
  gtk_stack_set_visible_child (self->pages, page);
  gtk_widget_set_visible (self->info_bar, FALSE); /* about what was in sight before */
  if (self->page_window != NULL)
    gtk_window_present (GTK_WINDOW (self->page_window));
  else if (self->is_narrow)
    g_action_group_change_action_state (G_ACTION_GROUP (self), "side-panel",
                                        g_variant_new_boolean (FALSE));
  qn_window_arrange (self);
  gtk_widget_child_focus (page, GTK_DIR_TAB_FORWARD);
}

/* In place of the page of that name, if there is one. */
static void
add (QnWindow *self, const char *name, const char *title, GtkWidget *page)
{
  GtkWidget *before = gtk_stack_get_child_by_name (self->pages, name);
  GActionGroup *actions = g_object_get_data (G_OBJECT (page), QN_ACTIONS);
  if (before != NULL)
    gtk_stack_remove (self->pages, before);
  gtk_stack_add_titled (self->pages, page, name, title);
  if (actions != NULL)
    g_signal_connect_object (actions, "action-enabled-changed",
                             G_CALLBACK (qn_window_update_actions), self,
                             G_CONNECT_SWAPPED);
  show (self, page);
}

void
qn_window_remove_pages (QnWindow *self)
{
  GtkWidget *page;
  while ((page = gtk_widget_get_first_child (GTK_WIDGET (self->pages))) != NULL)
    gtk_stack_remove (self->pages, page);
}

/* Another one comes into sight, or the drawing alone. */
static void
close_page (QnWindow *self, const char *name)
{
  GtkWidget *page = gtk_stack_get_visible_child (self->pages), *other;
  if (page != NULL)
    gtk_stack_remove (self->pages, page);
  other = gtk_widget_get_first_child (GTK_WIDGET (self->pages));
  if (other != NULL)
    gtk_stack_set_visible_child (self->pages, other);
  else
    qn_window_show_drawing (self, TRUE);
}

/* ---- their own actions, in place of those of the window ---- */

static GActionGroup *
actions_of_page (QnWindow *self)
{
  GtkWidget *page = qn_window_get_page (self);
  return page != NULL ? g_object_get_data (G_OBJECT (page), QN_ACTIONS) : NULL;
}

gboolean
qn_window_page_has (QnWindow *self, const char *action)
{
  GActionGroup *actions = actions_of_page (self);
  return actions != NULL && g_action_group_has_action (actions, action);
}

gboolean
qn_window_page_can (QnWindow *self, const char *action)
{
  GActionGroup *actions = actions_of_page (self);
  return actions != NULL && g_action_group_get_action_enabled (actions, action);
}

gboolean
qn_window_page_does (QnWindow *self, const char *action)
{
  if (!qn_window_page_has (self, action))
    return FALSE;
  g_action_group_activate_action (actions_of_page (self), action, NULL);
  return TRUE;
}

/* ---- comparison, capacity, figures ---- */

static GPtrArray *
list_others (QnDocument *document)
{
  GPtrArray *documents = g_ptr_array_new ();
  GtkApplication *application = GTK_APPLICATION (g_application_get_default ());
  for (GList *l = gtk_application_get_windows (application); l != NULL; l = l->next)
    if (QN_IS_WINDOW (l->data) && qn_window_get_document (l->data) != document)
      g_ptr_array_add (documents, qn_window_get_document (l->data));
  return documents;
}

static GtkWidget *
new_compare (QnDocument *document)
{
  return qn_compare_page_new (document, list_others);
}

/* The page of that name, made where it is not there. */
static void
show_or_add (QnWindow *self, const char *wanted)
{
  static const struct {
    const char *name, *title;
    GtkWidget *(*make) (QnDocument *document);
  } pages[] = { { "compare", N_ ("Comparison"), new_compare },
                { "capacity", N_ ("Capacity Curve"), qn_capacity_page_new },
                { "envelope", N_ ("Moving Load"), qn_envelope_page_new },
                { "figures", N_ ("Figures of the Project"), qn_figures_page_new } };
  GtkWidget *page = gtk_stack_get_child_by_name (self->pages, wanted);
  qn_window_commit_entry (self);
  if (page != NULL)
    show (self, page);
  for (gsize i = 0; page == NULL && i < G_N_ELEMENTS (pages); i++)
    if (g_str_equal (pages[i].name, wanted))
      add (self, wanted, _ (pages[i].title), pages[i].make (self->document));
}

/* ---- the study: numbers that vary, loads that move ---- */

/* Its page, or NULL where the window says why not; where that is that the project has no file, the action is done
 * once it has been saved. */
static GtkWidget *
show_study (QnWindow *self, const char *path, const char *action, GVariant *parameter)
{
  GtkWidget *page = gtk_stack_get_child_by_name (self->pages, "study");
  g_autoptr (GError) error = NULL;
  if (page != NULL
      && (path == NULL || g_str_equal (qn_study_page_get_path (page), path))) {
    show (self, page);
    return page;
  }
  page = qn_study_page_new (self->state, path, &error);
  if (page != NULL)
    add (self, "study", _ ("Study"), page);
  else
    qn_window_show_error (self, error->message);
  if (page == NULL && self->document->path == NULL) {
    gtk_widget_activate_action (GTK_WIDGET (self), "win.save-as", NULL);
    self->after_save = g_action_print_detailed_name (action, parameter);
  }
  return page;
}

static void
study (QnWindow *self, const char *name)
{
  show_study (self, NULL, "study", NULL);
}

/* (path in the project, its number) */
static void
vary (QnWindow *self, GVariant *parameter)
{
  const char *path;
  double number;
  g_variant_get (parameter, "(&sd)", &path, &number);
  GtkWidget *page = show_study (self, NULL, "vary", parameter);
  if (page != NULL)
    qn_study_page_vary (page, path, number);
}

gboolean
qn_window_open_study (QnWindow *self, const char *path)
{
  QnStudy opened;
  g_autoptr (GError) error = NULL;
  if (!qn_study_read (path, NULL, &opened, &error)) {
    qn_window_show_error (self, error->message);
    return FALSE;
  }
  g_autofree char *project = g_strdup (opened.project.path);
  qn_study_clear (&opened);
  if (project == NULL || !qn_window_open_path (self, project))
    return FALSE;
  qn_window_remember_recent (path);
  return show_study (self, path, "study", NULL) != NULL;
}

const QnWindowAction qn_window_page_actions[] = {
  { "compare", NULL, { show_or_add }, 0 },
  { "envelope", NULL, { show_or_add }, QN_NEEDS_DRAWN },
  { "capacity", NULL, { show_or_add }, QN_NEEDS_SOLVABLE },
  { "figures", NULL, { show_or_add }, QN_NEEDS_WORK },
  { "study", NULL, { study }, QN_NEEDS_DRAWN },
  { "vary", "(sd)", { .take = vary }, QN_NEEDS_DRAWN },
  { "close-page", NULL, { close_page }, 0 },
  { "show-drawing", NULL, { show_drawing }, 0 },
  { "own-window", NULL, { own_window }, 0 },
  { .name = NULL },
};
