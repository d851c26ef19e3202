/* Context menus: opened by the right button, by the Menu key and by Shift+F10. */
#pragma once

#include <gtk/gtk.h>

/* What a menu is about: the place that was clicked, px of the widget, or by_key where keys have
 * opened it; the function then sets x and y to where it belongs. Returns the menu, which is taken
 * over, or NULL for none. */
typedef struct QnMenuPlace {
  gboolean by_key;
  double x, y;
} QnMenuPlace;

typedef GMenuModel *(*QnMenuFunc) (GtkWidget *widget, QnMenuPlace *place, gpointer data);

/* Gives the widget a context menu that is made anew each time. `data` must live as long as the widget
 * does. */
void qn_context_menu_attach (GtkWidget *widget, QnMenuFunc func, gpointer data);

/* Opens, as the keys do, the menu of a widget, or the first that something inside of it has, such as
 * the row of a list; FALSE where there is none. */
gboolean qn_context_menu_open (GtkWidget *widget);

/* Appends an item of which the target is no constant. */
void qn_menu_add_target (GMenu *menu, const char *label, const char *action,
                         GVariant *target);

/* Appends a section that is taken over, if it has items. */
void qn_menu_add_section (GMenu *menu, GMenu *section);
