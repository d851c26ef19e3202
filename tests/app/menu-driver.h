/* Context menus in tests of the window. */
#pragma once

#include "driver.h"

/* An item of a menu, by its label without underlines; for driver_find_widget. */
gboolean menu_is_item (GtkWidget *widget, gconstpointer label);

/* Fails where no menu is open inside the widget's window. */
void menu_expect (GtkWidget *inside);

/* Opens the menu in the middle of a widget by the right button. */
void menu_right_click (GtkWidget *widget);

/* Clicks on an item of the menu that is open there. */
void menu_choose (GtkWidget *widget, const char *label);

/* Menu and Shift+F10 open it where the focus is, with this item, and Escape closes it. */
void menu_check_keys (GtkWidget *widget, const char *label);

/* A row of a form, by how its name begins. */
gboolean menu_is_row (GtkWidget *widget, gconstpointer name);
