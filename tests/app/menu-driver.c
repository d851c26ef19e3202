#include "menu-driver.h"

#include "app/widgets/row.h"

/* An item of a menu, by its label without underlines. */
gboolean
menu_is_item (GtkWidget *widget, gconstpointer label)
{
  g_autofree char *text = NULL;
  if (!g_str_equal (G_OBJECT_TYPE_NAME (widget), "GtkModelButton")
      || !gtk_widget_get_mapped (widget))
    return FALSE;
  g_object_get (widget, "text", &text, NULL);
  g_auto (GStrv) parts = g_strsplit (text, "_", 2);
  g_autofree char *plain = g_strjoinv ("", parts);
  return g_str_equal (plain, label);
}

void
menu_expect (GtkWidget *inside)
{
  GtkWidget *widget = GTK_WIDGET (gtk_widget_get_root (inside));
  if (driver_find_widget (widget, driver_is_menu, NULL) == NULL) {
    driver_screenshot (widget, "menu-missing");
    g_error ("no menu of the %s", G_OBJECT_TYPE_NAME (inside));
  }
}

/* Opens the menu in the middle of a widget by the right button. */
void
menu_right_click (GtkWidget *widget)
{
  driver_point_at (widget, 0.5 * gtk_widget_get_width (widget),
                   0.5 * gtk_widget_get_height (widget));
  driver_press_button ("3");
  menu_expect (widget);
}

/* Clicks on an item of the menu that is open there. */
void
menu_choose (GtkWidget *widget, const char *label)
{
  driver_click_on (widget, menu_is_item, label);
}

/* Both keys open it where the focus is, and Escape closes it. */
void
menu_check_keys (GtkWidget *widget, const char *label)
{
  static const char *const keys[] = { "Menu", "shift+F10" };
  for (gsize i = 0; i < G_N_ELEMENTS (keys); i++) {
    driver_key (keys[i]);
    menu_expect (widget);
    g_assert_nonnull (driver_find_widget (widget, menu_is_item, label));
    driver_key ("Escape");
    g_assert_null (driver_find_widget (widget, driver_is_menu, NULL));
  }
}

gboolean
menu_is_row (GtkWidget *widget, gconstpointer name)
{
  g_autofree char *own =
    QN_IS_ROW (widget) && gtk_widget_get_mapped (widget)
      ? g_strdup (gtk_label_get_text (GTK_LABEL (qn_row_get_label (QN_ROW (widget)))))
      : NULL;
  return own != NULL && g_str_has_prefix (own, name);
}
