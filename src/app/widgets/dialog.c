#include "app/widgets/dialog.h"

#include "app/widgets/builder.h"
#include "app/widgets/help.h"

#include <glib/gi18n.h>

#define BEFORE   "qn-focus-before" /* a weak reference */
#define QUESTION "qn-question"

static void
close_all (GtkWidget *widget)
{
  for (GtkWidget *child = gtk_widget_get_first_child (widget), *next; child != NULL;
       child = next) {
    next = gtk_widget_get_next_sibling (child);
    close_all (child);
    if (GTK_IS_POPOVER (child))
      gtk_widget_set_visible (child, FALSE);
  }
}

static void
free_reference (gpointer reference)
{
  g_weak_ref_clear (reference);
  g_free (reference);
}

/* GTK 4.8 leaves the focus in a submenu that has closed, where no key is heard. It goes back to what had it
 * outside of popovers. */
static void
on_closed (GtkWidget *popover)
{
  GtkRoot *window = gtk_widget_get_root (popover);
  GtkWidget *focus = window != NULL ? gtk_root_get_focus (window) : NULL;
  if (focus == NULL || !gtk_widget_is_ancestor (focus, popover))
    return;
  g_autoptr (GtkWidget) back =
    g_weak_ref_get (g_object_get_data (G_OBJECT (window), BEFORE));
  if (back == NULL || !gtk_widget_get_mapped (back) || !gtk_widget_grab_focus (back))
    gtk_root_set_focus (window, NULL);
}

static void
on_focus (GtkWindow *window)
{
  GtkWidget *focus = gtk_window_get_focus (window);
  GtkWidget *popover =
    focus != NULL ? gtk_widget_get_ancestor (focus, GTK_TYPE_POPOVER) : NULL;
  if (popover == NULL)
    g_weak_ref_set (g_object_get_data (G_OBJECT (window), BEFORE), focus);
  else if (g_signal_handler_find (popover, G_SIGNAL_MATCH_FUNC, 0, 0, NULL, on_closed,
                                  NULL)
           == 0)
    g_signal_connect (popover, "closed", G_CALLBACK (on_closed), NULL);
}

void
qn_popovers_attend (GtkWidget *window)
{
  GWeakRef *before = g_new0 (GWeakRef, 1);
  g_weak_ref_init (before, NULL);
  g_object_set_data_full (G_OBJECT (window), BEFORE, before, free_reference);
  g_signal_connect (window, "unmap", G_CALLBACK (close_all), NULL);
  g_signal_connect (window, "notify::focus-widget", G_CALLBACK (on_focus), NULL);
}

void
qn_dialog_attend (GtkWidget *window)
{
  qn_popovers_attend (window);
  GtkEventController *keys = gtk_shortcut_controller_new ();
  gtk_shortcut_controller_add_shortcut (
    GTK_SHORTCUT_CONTROLLER (keys),
    gtk_shortcut_new (gtk_keyval_trigger_new (GDK_KEY_Escape, 0),
                      gtk_named_action_new ("window.close")));
  gtk_widget_add_controller (window, keys);
}

/* No larger than the screen, where what scrolls can be less. */
static void
fit_screen (GtkWidget *dialog, GtkWindow *parent)
{
  GtkWindow *window = GTK_WINDOW (dialog);
  GdkSurface *surface =
    parent != NULL ? gtk_native_get_surface (GTK_NATIVE (parent)) : NULL;
  GdkRectangle screen;
  int width, height, least, usual;
  if (surface == NULL)
    return;
  GdkDisplay *display = gdk_surface_get_display (surface);
  gdk_monitor_get_geometry (gdk_display_get_monitor_at_surface (display, surface),
                            &screen);
  gtk_window_get_default_size (window, &width, &height);
  gtk_widget_measure (dialog, GTK_ORIENTATION_HORIZONTAL, -1, &least, NULL, NULL, NULL);
  gtk_widget_measure (dialog, GTK_ORIENTATION_VERTICAL, MAX (width, least), NULL, &usual,
                      NULL, NULL);
  if (MAX (height, usual) > screen.height)
    height = screen.height;
  gtk_window_set_default_size (window, MIN (width, screen.width), height);
}

void
qn_dialog_present (GtkWidget *dialog, GtkWindow *parent, const char *help,
                   GtkWidget *accept)
{
  gtk_window_set_transient_for (GTK_WINDOW (dialog), parent);
  qn_help_set_page (dialog, help);
  fit_screen (dialog, parent);
  gtk_window_present (GTK_WINDOW (dialog));
  gtk_widget_grab_focus (accept);
}

/* ---- questions ---- */

typedef struct Question {
  QnAnswered answered;
  gpointer data;
} Question;

static void
give_answer (GtkWidget *dialog, QnAnswer answer)
{
  const Question question = *(Question *) g_object_get_data (G_OBJECT (dialog), QUESTION);
  gtk_window_destroy (GTK_WINDOW (dialog));
  question.answered (answer, question.data);
}

static void
on_button (GtkWidget *button, gpointer answer)
{
  give_answer (GTK_WIDGET (gtk_widget_get_root (button)),
               (QnAnswer) GPOINTER_TO_INT (answer));
}

static gboolean
on_close (GtkWidget *dialog)
{
  give_answer (dialog, QN_ANSWER_CANCEL);
  return GDK_EVENT_STOP;
}

void
qn_dialog_ask (GtkWindow *parent, const char *text, const char *consequence,
               const char *reject, const char *accept, GtkWidget *more,
               QnAnswered answered, gpointer data)
{
  const struct {
    const char *id, *label;
    QnAnswer answer;
  } answers[] = { { "reject", reject, QN_ANSWER_REJECT },
                  { "cancel", _ ("_Cancel"), QN_ANSWER_CANCEL },
                  { "accept", accept, QN_ANSWER_ACCEPT } };
  g_autoptr (GtkBuilder) builder = qn_builder_new ("question");
  GtkWidget *dialog = qn_builder_get_widget (builder, "question"), *last = NULL;
  GtkWidget *told = qn_builder_get_widget (builder, "consequence");
  Question *question = g_new (Question, 1);
  *question = (Question){ answered, data };
  g_object_set_data_full (G_OBJECT (dialog), QUESTION, question, g_free);
  gtk_accessible_update_property (GTK_ACCESSIBLE (dialog), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  text, -1);
  gtk_label_set_text (GTK_LABEL (qn_builder_get_widget (builder, "text")), text);
  gtk_label_set_text (GTK_LABEL (told), consequence);
  if (more != NULL)
    gtk_box_insert_child_after (GTK_BOX (gtk_widget_get_parent (told)), more, told);
  for (gsize i = 0; i < G_N_ELEMENTS (answers); i++) {
    GtkWidget *button = qn_builder_get_widget (builder, answers[i].id);
    gtk_widget_set_visible (button, answers[i].label != NULL);
    if (answers[i].label == NULL)
      continue;
    gtk_button_set_label (GTK_BUTTON (button), answers[i].label);
    g_signal_connect (button, "clicked", G_CALLBACK (on_button),
                      GINT_TO_POINTER (answers[i].answer));
    last = button;
  }
  gtk_window_set_default_widget (GTK_WINDOW (dialog), last);
  g_signal_connect (dialog, "close-request", G_CALLBACK (on_close), NULL);
  qn_dialog_present (dialog, parent, NULL, last);
}
