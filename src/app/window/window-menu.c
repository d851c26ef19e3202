/* The context menu of the drawing: of the block, joint, beam, load or opening under the pointer, and of
 * the empty paper. */
#include "app/tools/tools.h"
#include "app/widgets/builder.h"
#include "app/widgets/context-menu.h"
#include "app/window/window-private.h"

#include <glib/gi18n.h>

/* ---- menus, of ui/context-menus.ui ---- */

static GMenu *
get (GtkBuilder *builder, const char *id)
{
  return G_MENU (gtk_builder_get_object (builder, id));
}

/* For blocks and beams alike. */
static void
insert_turns (GtkBuilder *builder, GMenu *shape)
{
  g_menu_insert_submenu (shape, 2, _ ("Mirror and Ro_tate"),
                         G_MENU_MODEL (get (builder, "turns")));
}

static GMenu *
make_for_selection (QnWindow *self)
{
  QnSelection *selection = self->document->selection;
  const QnModel *model = &self->document->project.model;
  g_autoptr (GtkBuilder) builder = qn_builder_new ("context-menus");
  const char *id = "paper";
  const QnPick item = qn_selection_get_item (selection);
  const QnId block = qn_selection_get_one (selection, QN_PICK_BLOCK);
  if (selection->object != QN_NONE)
    id = "opening";
  else if (item.id != QN_NONE)
    return g_object_ref (get (builder, item.kind == QN_PICK_BAR   ? "bar"
                                       : item.kind == QN_PICK_TIE ? "tie"
                                                                  : "load"));
  else if (qn_selection_get_one (selection, QN_PICK_FACE) != QN_NONE) {
    id = "joint";
    for (gsize i = 0; i <= model->law_count; i++) {
      const char *name = i < model->law_count ? model->laws[i].name : "";
      qn_menu_add_target (get (builder, "joint-laws"),
                          *name != '\0' ? name : _ ("As its blocks"), "win.joint-law",
                          g_variant_new_string (name));
    }
  } else if (block >= 0 && (gsize) block < model->block_count) {
    id = "block";
    GMenu *shape = get (builder, "block-shape");
    insert_turns (builder, shape);
    if (model->blocks[block].masonry != QN_NONE || model->blocks[block].wall != QN_NONE)
      g_menu_append (shape, _ ("De_tach Wall into Free Blocks"), "win.detach");
  } else if (qn_selection_get_one (selection, QN_PICK_BEAM) != QN_NONE) {
    id = "beam";
    insert_turns (builder, get (builder, "beam-shape"));
  }
  GMenu *menu = g_object_ref (get (builder, id));
  if (!g_str_equal (id, "paper")) {
    gboolean solved = self->document->run != NULL;
    GMenu *panels = get (builder, solved ? "panels-with-result" : "panels");
    g_menu_append_section (menu, NULL, G_MENU_MODEL (panels));
  }
  return menu;
}

static GMenuModel *
make_menu (GtkWidget *widget, QnMenuPlace *place, gpointer data)
{
  QnWindow *self = data;
  if (self->canvas->in_gesture) {
    qn_canvas_cancel_gesture (self->canvas);
    return NULL;
  }
  QnVec2 low, high;
  if (!place->by_key)
    qn_tool_select_under (self->canvas, qn_vec2 (place->x, place->y));
  else if (qn_canvas_get_parts_box (self->canvas, &low, &high)) {
    QnVec2 s = qn_canvas_to_screen (self->canvas, qn_vec2_lerp (low, high, 0.5));
    place->x = CLAMP (s.x, 0.0, gtk_widget_get_width (GTK_WIDGET (self->canvas)));
    place->y = CLAMP (s.y, 0.0, gtk_widget_get_height (GTK_WIDGET (self->canvas)));
  }
  return G_MENU_MODEL (make_for_selection (self));
}

void
qn_window_add_context_menu (QnWindow *self)
{
  qn_context_menu_attach (GTK_WIDGET (self->canvas), make_menu, self);
}
