#include "app/widgets/dialog.h"

#include "app/widgets/shortened.h"

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

GtkWidget *
qn_dialog_new (GtkWindow *parent, const char *title, int width, int height)
{
  GtkWidget *dialog = gtk_window_new ();
  gtk_window_set_title (GTK_WINDOW (dialog), title);
  gtk_window_set_transient_for (GTK_WINDOW (dialog), parent);
  gtk_window_set_modal (GTK_WINDOW (dialog), TRUE);
  gtk_window_set_destroy_with_parent (GTK_WINDOW (dialog), TRUE);
  gtk_window_set_default_size (GTK_WINDOW (dialog), width, height);
  GtkWidget *header = gtk_header_bar_new ();
  qn_shortened_tell (header);
  gtk_window_set_titlebar (GTK_WINDOW (dialog), header);
  qn_dialog_attend (dialog);
  return dialog;
}

/* No larger than the screen, where what scrolls can be less. */
static void
fit_screen (GtkWidget *dialog)
{
  GtkWindow *window = GTK_WINDOW (dialog),
            *parent = gtk_window_get_transient_for (window);
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
qn_dialog_present (GtkWidget *dialog, GtkWidget *accept)
{
  fit_screen (dialog);
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

static GtkWidget *
add_text (GtkWidget *box, const char *text, const char *style)
{
  GtkWidget *label = gtk_label_new (text);
  gtk_label_set_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_max_width_chars (GTK_LABEL (label), 50);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  gtk_widget_add_css_class (label, style);
  gtk_box_append (GTK_BOX (box), label);
  return label;
}

void
qn_dialog_ask (GtkWindow *parent, const char *text, const char *consequence,
               const char *reject, const char *accept, GtkWidget *more,
               QnAnswered answered, gpointer data)
{
  const struct {
    const char *label, *style;
    QnAnswer answer;
  } answers[] = { { reject, "destructive-action", QN_ANSWER_REJECT },
                  { _ ("_Cancel"), "cancel", QN_ANSWER_CANCEL },
                  { accept, "suggested-action", QN_ANSWER_ACCEPT } };
  GtkWidget *dialog = qn_dialog_new (parent, NULL, -1, -1), *last = NULL;
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 12);
  GtkWidget *buttons = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 6);
  Question *question = g_new (Question, 1);
  *question = (Question){ answered, data };
  g_object_set_data_full (G_OBJECT (dialog), QUESTION, question, g_free);
  gtk_widget_set_name (dialog, "question");
  GtkWidget *no_title = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 0);
  gtk_widget_set_visible (no_title, FALSE);
  gtk_window_set_titlebar (GTK_WINDOW (dialog), no_title);
  gtk_window_set_resizable (GTK_WINDOW (dialog), FALSE);
  gtk_accessible_update_property (GTK_ACCESSIBLE (dialog), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                  text, -1);
  add_text (box, text, "title-4");
  add_text (box, consequence, "body");
  if (more != NULL)
    gtk_box_append (GTK_BOX (box), more);
  gtk_box_set_homogeneous (GTK_BOX (buttons), TRUE);
  for (gsize i = 0; i < G_N_ELEMENTS (answers); i++) {
    if (answers[i].label == NULL)
      continue;
    last = gtk_button_new_with_mnemonic (answers[i].label);
    gtk_widget_add_css_class (last, answers[i].style);
    g_signal_connect (last, "clicked", G_CALLBACK (on_button),
                      GINT_TO_POINTER (answers[i].answer));
    gtk_box_append (GTK_BOX (buttons), last);
  }
  gtk_box_append (GTK_BOX (box), buttons);
  gtk_widget_add_css_class (box, "question");
  gtk_window_set_child (GTK_WINDOW (dialog), box);
  gtk_window_set_default_widget (GTK_WINDOW (dialog), last);
  g_signal_connect (dialog, "close-request", G_CALLBACK (on_close), NULL);
  qn_dialog_present (dialog, last);
}
