#include "app/widgets/context-menu.h"

#define HOOK    "qn-menu-hook"
#define POPOVER "qn-menu-popover"

typedef struct Hook {
  QnMenuFunc func;
  gpointer data;
} Hook;

void
qn_menu_add_target (GMenu *menu, const char *label, const char *action, GVariant *target)
{
  g_autoptr (GMenuItem) item = g_menu_item_new (label, NULL);
  g_menu_item_set_action_and_target_value (item, action, target);
  g_menu_append_item (menu, item);
}

void
qn_menu_add_section (GMenu *menu, GMenu *section)
{
  if (g_menu_model_get_n_items (G_MENU_MODEL (section)) > 0)
    g_menu_append_section (menu, NULL, G_MENU_MODEL (section));
  g_object_unref (section);
}

static void
forget_popover (GtkWidget *widget)
{
  GtkWidget *popover = g_object_steal_data (G_OBJECT (widget), POPOVER);
  if (popover != NULL)
    gtk_widget_unparent (popover);
}

static gboolean
on_idle (gpointer data)
{
  GtkWidget *popover = data;
  GtkWidget *widget = gtk_widget_get_parent (popover);
  if (widget != NULL && g_object_get_data (G_OBJECT (widget), POPOVER) == popover)
    forget_popover (widget);
  g_object_unref (popover);
  return G_SOURCE_REMOVE;
}

/* The item that was chosen is carried out after the menu has closed: it goes later. */
static void
on_closed (GtkPopover *popover)
{
  g_idle_add (on_idle, g_object_ref (popover));
}

static gboolean
is_nowhere (GBinding *binding, const GValue *parent, GValue *nowhere, gpointer data)
{
  g_value_set_boolean (nowhere, g_value_get_object (parent) == NULL);
  return TRUE;
}

/* A submenu comes at once: while one page follows upon the other in a menu that has closed, GTK 4.8 looks for
 * the pointer there, and crashes. */
static void
show_at_once (GtkWidget *widget)
{
  if (GTK_IS_STACK (widget))
    gtk_stack_set_transition_type (GTK_STACK (widget), GTK_STACK_TRANSITION_TYPE_NONE);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    show_at_once (child);
}

/* GTK puts the lines between sections in later, and a menu that is open does not grow by them. */
static gboolean
pop_up (gpointer popover)
{
  if (gtk_widget_get_parent (popover) != NULL)
    gtk_popover_popup (popover);
  g_object_unref (popover);
  return G_SOURCE_REMOVE;
}

static gboolean
open_menu (GtkWidget *widget, QnMenuPlace *place)
{
  const Hook *hook = g_object_get_data (G_OBJECT (widget), HOOK);
  if (hook == NULL || !gtk_widget_get_mapped (widget))
    return FALSE;
  g_autoptr (GMenuModel) menu = hook->func (widget, place, hook->data);
  if (menu == NULL)
    return FALSE;
  forget_popover (widget);
  GtkWidget *popover = gtk_popover_menu_new_from_model (menu);
  gtk_popover_set_has_arrow (GTK_POPOVER (popover), FALSE);
  gtk_widget_set_halign (popover, GTK_ALIGN_START);
  show_at_once (popover);
  gtk_popover_set_pointing_to (GTK_POPOVER (popover),
                               &(GdkRectangle){ (int) place->x, (int) place->y, 1, 1 });
  gtk_widget_set_parent (popover, widget);
  g_object_set_data (G_OBJECT (widget), POPOVER, popover);
  g_signal_connect (popover, "closed", G_CALLBACK (on_closed), NULL);
  /* What is around the menu does not scroll to the item under the pointer, which would move the menu
   * away from it, as long as the menu has a place there. */
  for (GtkWidget *around = widget; around != NULL;
       around = gtk_widget_get_parent (around))
    if (GTK_IS_VIEWPORT (around))
      g_object_bind_property_full (popover, "parent", around, "scroll-to-focus",
                                   G_BINDING_SYNC_CREATE, is_nowhere, NULL, NULL, NULL);
  g_idle_add (pop_up, g_object_ref (popover));
  return TRUE;
}

gboolean
qn_context_menu_open (GtkWidget *widget)
{
  QnMenuPlace place = { TRUE, 0.5 * gtk_widget_get_width (widget),
                        0.5 * gtk_widget_get_height (widget) };
  gboolean opened = open_menu (widget, &place);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL && !opened;
       child = gtk_widget_get_next_sibling (child))
    opened = qn_context_menu_open (child);
  return opened;
}

static void
on_pressed (GtkGestureClick *gesture, int count, double x, double y, GtkWidget *widget)
{
  QnMenuPlace place = { FALSE, x, y };
  if (open_menu (widget, &place))
    gtk_gesture_set_state (GTK_GESTURE (gesture), GTK_EVENT_SEQUENCE_CLAIMED);
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, GtkWidget *widget)
{
  gboolean shift = (modifiers & GDK_SHIFT_MASK) != 0;
  return (keyval == GDK_KEY_Menu || (keyval == GDK_KEY_F10 && shift))
         && qn_context_menu_open (widget);
}

void
qn_context_menu_attach (GtkWidget *widget, QnMenuFunc func, gpointer data)
{
  Hook *hook = g_new (Hook, 1);
  *hook = (Hook){ func, data };
  g_object_set_data_full (G_OBJECT (widget), HOOK, hook, g_free);
  GtkGesture *click = gtk_gesture_click_new ();
  gtk_gesture_single_set_button (GTK_GESTURE_SINGLE (click), GDK_BUTTON_SECONDARY);
  g_signal_connect (click, "pressed", G_CALLBACK (on_pressed), widget);
  gtk_widget_add_controller (widget, GTK_EVENT_CONTROLLER (click));
  GtkEventController *key = gtk_event_controller_key_new ();
  g_signal_connect (key, "key-pressed", G_CALLBACK (on_key), widget);
  gtk_widget_add_controller (widget, key);
  g_signal_connect (widget, "destroy", G_CALLBACK (forget_popover), NULL);
}
