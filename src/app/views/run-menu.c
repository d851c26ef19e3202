/* The context menu of the choice of runs: what can be done with the one that is shown. */
#include "app/forms/panel.h"
#include "app/widgets/context-menu.h"
#include <glib/gi18n.h>

static GMenuModel *
make_menu (GtkWidget *runs, QnMenuPlace *place, gpointer data)
{
  (void) place;
  (void) data;
  if (gtk_drop_down_get_selected_item (GTK_DROP_DOWN (runs)) == NULL)
    return NULL;
  GMenu *menu = g_menu_new (), *exports = g_menu_new (), *removal = g_menu_new ();
  g_menu_append (exports, _ ("_Export Figure…"), "win.export");
  g_menu_append (exports, _ ("Export Result _File…"), "win.export-result::result");
  g_menu_append (exports, _ ("Export _Curve as Table…"), "win.export-result::curve");
  g_menu_append (removal, _ ("_Remove Run"), "win.remove-run");
  qn_menu_add_section (menu, exports);
  qn_menu_add_section (menu, removal);
  return G_MENU_MODEL (menu);
}

void
qn_run_menu_attach (GtkWidget *runs)
{
  qn_context_menu_attach (runs, make_menu, NULL);
}
