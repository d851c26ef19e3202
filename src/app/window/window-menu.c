/* The context menu of the drawing: of the block, joint, beam, load or opening under the pointer, and of
 * the empty paper. */
#include "app/tools/tools.h"
#include "app/widgets/context-menu.h"
#include "app/window/window-private.h"

#include "app/canvas/gesture.h"
#include "doc/masonry/masonry-shape.h"
#include <glib/gi18n.h>

/* ---- parts ---- */

static GMenu *
make_clipboard (void)
{
  GMenu *menu = g_menu_new ();
  g_menu_append (menu, _ ("Cu_t"), "win.cut");
  g_menu_append (menu, _ ("_Copy"), "win.copy");
  g_menu_append (menu, _ ("_Paste"), "win.paste");
  g_menu_append (menu, _ ("_Duplicate"), "win.duplicate");
  g_menu_append (menu, _ ("De_lete"), "win.delete");
  return menu;
}

static GMenu *
make_turns (void)
{
  GMenu *menu = g_menu_new ();
  g_menu_append (menu, _ ("Mirror _Left and Right"), "win.mirror::vertical");
  g_menu_append (menu, _ ("Mirror _Up and Down"), "win.mirror::horizontal");
  g_menu_append (menu, _ ("Turn by 90° to the L_eft"), "win.rotate(90.0)");
  g_menu_append (menu, _ ("Turn by 90° to the R_ight"), "win.rotate(-90.0)");
  return menu;
}

static GMenu *
make_arrange (void)
{
  GMenu *menu = g_menu_new (), *align = g_menu_new (), *spread = g_menu_new ();
  g_menu_append (align, _ ("_Left Sides"), "win.align::left");
  g_menu_append (align, _ ("_Middles Above Each Other"), "win.align::center");
  g_menu_append (align, _ ("_Right Sides"), "win.align::right");
  g_menu_append (align, _ ("_Upper Sides"), "win.align::top");
  g_menu_append (align, _ ("M_iddles Beside Each Other"), "win.align::middle");
  g_menu_append (align, _ ("L_ower Sides"), "win.align::bottom");
  g_menu_append (spread, _ ("_Equal Gaps from Left to Right"), "win.distribute::gaps-x");
  g_menu_append (spread, _ ("Equal _Gaps Upwards"), "win.distribute::gaps-y");
  g_menu_append (spread, _ ("Middles at Equal _Distances from Left to Right"),
                 "win.distribute::centers-x");
  g_menu_append (spread, _ ("Middles at Equal Dis_tances Upwards"),
                 "win.distribute::centers-y");
  qn_menu_add_section (menu, align);
  qn_menu_add_section (menu, spread);
  return menu;
}

static GMenu *
make_supports (void)
{
  GMenu *menu = g_menu_new ();
  g_menu_append (menu, _ ("_Fixed"), "win.support::fixed");
  g_menu_append (menu, _ ("_Held in x and y, Free to Turn"), "win.support::pinned");
  g_menu_append (menu, _ ("Held in _y Alone"), "win.support::roller");
  g_menu_append (menu, _ ("F_ree"), "win.support::free");
  return menu;
}

static GMenu *
make_panels (QnWindow *self)
{
  GMenu *menu = g_menu_new ();
  g_menu_append (menu, _ ("P_roperties"), "win.show-panel::properties");
  if (qn_document_get_run (self->document) != NULL)
    g_menu_append (menu, _ ("_Values of the Result"), "win.show-panel::result");
  return menu;
}

/* ---- menus ---- */

static GMenu *
make_block_menu (QnWindow *self, QnId block)
{
  const QnBlock *b = &qn_document_get_model (self->document)->blocks[block];
  GMenu *menu = g_menu_new (), *like = g_menu_new (), *shape = g_menu_new ();
  g_menu_append (like, _ ("Whole _Course"), "win.select-like::course");
  g_menu_append (like, _ ("Whole _Wall"), "win.select-like::wall");
  g_menu_append (like, _ ("Same _Law"), "win.select-like::law");
  qn_menu_add_section (menu, make_clipboard ());
  qn_menu_add_submenu (shape, _ ("_Select"), like);
  qn_menu_add_submenu (shape, _ ("S_upport"), make_supports ());
  qn_menu_add_submenu (shape, _ ("Mirror and T_urn"), make_turns ());
  qn_menu_add_submenu (shape, _ ("Ali_gn and Distribute"), make_arrange ());
  g_menu_append (shape, _ ("J_oin into One Block"), "win.join");
  if (b->masonry != QN_NONE || b->wall != QN_NONE)
    g_menu_append (shape, _ ("De_tach Wall into Free Blocks"), "win.detach");
  qn_menu_add_section (menu, shape);
  qn_menu_add_section (menu, make_panels (self));
  return menu;
}

static GMenu *
make_beam_menu (QnWindow *self)
{
  GMenu *menu = g_menu_new (), *shape = g_menu_new ();
  g_menu_append (shape, _ ("_Duplicate"), "win.duplicate");
  g_menu_append (shape, _ ("De_lete"), "win.delete");
  qn_menu_add_submenu (shape, _ ("Mirror and T_urn"), make_turns ());
  qn_menu_add_submenu (shape, _ ("Ali_gn and Distribute"), make_arrange ());
  qn_menu_add_section (menu, shape);
  qn_menu_add_section (menu, make_panels (self));
  return menu;
}

static GMenu *
make_joint_menu (QnWindow *self)
{
  const QnModel *model = qn_document_get_model (self->document);
  GMenu *menu = g_menu_new (), *like = g_menu_new (), *laws = g_menu_new ();
  g_menu_append (like, _ ("_Joints on the Same Line"), "win.select-faces-like::line");
  g_menu_append (like, _ ("Joints in the Same _Direction"),
                 "win.select-faces-like::direction");
  g_menu_append (like, _ ("Joints of the Same La_w"), "win.select-faces-like::law");
  for (gsize i = 0; i <= model->law_count; i++) {
    const char *name = i < model->law_count ? model->laws[i].name : "";
    g_autoptr (GMenuItem) item =
      g_menu_item_new (*name != '\0' ? name : _ ("As its blocks"), NULL);
    g_menu_item_set_action_and_target (item, "win.joint-law", "s", name);
    g_menu_append_item (laws, item);
  }
  GMenu *law = g_menu_new ();
  qn_menu_add_section (menu, like);
  qn_menu_add_submenu (law, _ ("_Law"), laws);
  qn_menu_add_section (menu, law);
  qn_menu_add_section (menu, make_panels (self));
  return menu;
}

static GMenu *
make_opening_menu (QnWindow *self)
{
  GMenu *menu = g_menu_new (), *edit = g_menu_new ();
  g_menu_append (edit, _ ("_Fill the Opening"), "win.delete");
  qn_menu_add_section (menu, edit);
  qn_menu_add_section (menu, make_panels (self));
  return menu;
}

static GMenu *
make_load_menu (gboolean live, QnId load)
{
  GMenu *menu = g_menu_new (), *edit = g_menu_new (), *panel = g_menu_new ();
  g_autoptr (GMenuItem) item = g_menu_item_new (_ ("De_lete Load"), NULL);
  g_menu_item_set_action_and_target (item, "win.delete-load", "(bi)", live, (int) load);
  g_menu_append_item (edit, item);
  g_menu_append (panel, _ ("_All Loads"), "win.show-panel::analysis");
  g_menu_append (panel, _ ("_Hide Loads"), "win.loads");
  qn_menu_add_section (menu, edit);
  qn_menu_add_section (menu, panel);
  return menu;
}

static GMenu *
make_paper_menu (void)
{
  GMenu *menu = g_menu_new (), *edit = g_menu_new (), *view = g_menu_new ();
  GMenu *shown = g_menu_new (), *solve = g_menu_new ();
  g_menu_append (edit, _ ("_Paste"), "win.paste");
  g_menu_append (edit, _ ("Select _All"), "win.select-all");
  g_menu_append (view, _ ("_Fit"), "win.fit");
  g_menu_append (view, _ ("_Grid"), "win.grid");
  g_menu_append (view, _ ("S_nap"), "win.snap");
  g_menu_append (shown, _ ("_Block Names"), "win.names");
  g_menu_append (shown, _ ("_Loads"), "win.loads");
  g_menu_append (shown, _ ("_Dimensions"), "win.dimensions");
  qn_menu_add_submenu (view, _ ("S_how"), shown);
  g_menu_append (solve, _ ("So_lve"), "win.run");
  g_menu_append (solve, _ ("_Export Figure…"), "win.export");
  qn_menu_add_section (menu, edit);
  qn_menu_add_section (menu, view);
  qn_menu_add_section (menu, solve);
  return menu;
}

/* ---- what it is about ---- */

static GMenu *
make_for_selection (QnWindow *self)
{
  QnSelection *selection = qn_document_get_selection (self->document);
  const QnModel *model = qn_document_get_model (self->document);
  guint blocks = 0, beams = 0;
  QnId object;
  int opening;
  const QnId *ids = qn_selection_get_blocks (selection, &blocks);
  qn_selection_get_beams (selection, &beams);
  if (qn_selection_get_opening (selection, &object, &opening))
    return make_opening_menu (self);
  if (qn_selection_get_face (selection) != QN_NONE)
    return make_joint_menu (self);
  if (blocks > 0 && (gsize) ids[0] < model->block_count)
    return make_block_menu (self, ids[0]);
  return beams > 0 ? make_beam_menu (self) : make_paper_menu ();
}

/* Where a menu of the selection opens by key. */
static void
place_by_selection (QnWindow *self, QnMenuPlace *place)
{
  QnVec2 low, high;
  if (!qn_canvas_get_parts_box (self->canvas, &low, &high))
    return;
  QnVec2 s = qn_canvas_to_screen (self->canvas, qn_vec2_lerp (low, high, 0.5));
  place->x = CLAMP (s.x, 0.0, gtk_widget_get_width (GTK_WIDGET (self->canvas)));
  place->y = CLAMP (s.y, 0.0, gtk_widget_get_height (GTK_WIDGET (self->canvas)));
}

static GMenuModel *
make_menu (GtkWidget *widget, QnMenuPlace *place, gpointer data)
{
  QnWindow *self = data;
  (void) widget;
  if (qn_canvas_is_in_gesture (self->canvas)) {
    qn_canvas_cancel_gesture (self->canvas);
    return NULL;
  }
  if (place->by_key) {
    place_by_selection (self, place);
    return G_MENU_MODEL (make_for_selection (self));
  }
  QnVec2 at = qn_vec2 (place->x, place->y);
  QnPick load =
    qn_canvas_pick (self->canvas, at, 1u << QN_PICK_DEAD_LOAD | 1u << QN_PICK_LIVE_LOAD);
  if (load.kind != QN_PICK_NOTHING && load.id != QN_NONE
      && !qn_view_needs_result (qn_view_state_get_view (self->state)))
    return G_MENU_MODEL (make_load_menu (load.kind == QN_PICK_LIVE_LOAD, load.id));
  qn_tool_select_under (self->canvas, at);
  return G_MENU_MODEL (make_for_selection (self));
}

void
qn_window_add_context_menu (QnWindow *self)
{
  qn_context_menu_attach (GTK_WIDGET (self->canvas), make_menu, self);
}
