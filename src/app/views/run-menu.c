/* The context menu of the choice of runs: what can be done with the one that is shown. */
#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/context-menu.h"

static GMenuModel *
make_menu (GtkWidget *runs, QnMenuPlace *place, gpointer data)
{
  if (gtk_drop_down_get_selected_item (GTK_DROP_DOWN (runs)) == NULL)
    return NULL;
  g_autoptr (GtkBuilder) builder = qn_builder_new ("context-menus");
  return G_MENU_MODEL (g_object_ref (gtk_builder_get_object (builder, "run")));
}

void
qn_run_menu_attach (GtkWidget *runs)
{
  qn_context_menu_attach (runs, make_menu, NULL);
}
