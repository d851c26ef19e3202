/* The picture behind the drawing: opacity, size, place and angle; only there when it is. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "doc/document/picture.h"
#include "io/text/io-error.h"
#include <glib/gi18n.h>

typedef struct Panel {
  QnCanvas *canvas;
  GtkWidget *form;
  GtkLabel *trouble;
  GtkWidget *opacity, *allow;
  QnQuantityEntry *width, *x, *y, *angle;
} Panel;

static void
place (Panel *panel, const char *name, const char *key, const QnUnderlay *underlay)
{
  g_autoptr (GError) error = NULL;
  if (!qn_document_place_picture (qn_canvas_get_document (panel->canvas), name, key,
                                  underlay, &error))
    g_signal_emit_by_name (panel->canvas, "failed", error->message);
}

static QnUnderlay
present (const Panel *panel)
{
  return *qn_view_state_get_underlay (qn_canvas_get_state (panel->canvas));
}

static void
on_quantity (QnQuantityEntry *entry, Panel *panel)
{
  (void) entry;
  QnUnderlay underlay = present (panel);
  underlay.width = qn_quantity_entry_get_value (panel->width);
  underlay.origin = qn_vec2 (qn_quantity_entry_get_value (panel->x),
                             qn_quantity_entry_get_value (panel->y));
  underlay.angle = qn_quantity_entry_get_value (panel->angle);
  place (panel, _ ("Place Picture"), NULL, &underlay);
}

static void
on_opacity (GtkRange *range, Panel *panel)
{
  QnUnderlay underlay = present (panel);
  underlay.opacity = gtk_range_get_value (range);
  place (panel, _ ("Fade Picture"), "picture-opacity", &underlay);
}

static void
update (Panel *panel)
{
  QnViewState *state = qn_canvas_get_state (panel->canvas);
  const QnUnderlay *underlay = qn_view_state_get_underlay (state);
  const GError *error = qn_view_state_get_underlay_error (state);
  gtk_widget_set_visible (panel->form, underlay->image != NULL || error != NULL);
  gtk_label_set_text (panel->trouble, error != NULL ? error->message : "");
  gtk_widget_set_visible (GTK_WIDGET (panel->trouble), error != NULL);
  gtk_widget_set_visible (panel->allow,
                          g_error_matches (error, QN_IO_ERROR, QN_IO_ERROR_OUTSIDE));
  g_signal_handlers_block_by_func (panel->opacity, on_opacity, panel);
  gtk_range_set_value (GTK_RANGE (panel->opacity), underlay->opacity);
  g_signal_handlers_unblock_by_func (panel->opacity, on_opacity, panel);
  qn_quantity_entry_set_value (panel->width, underlay->width);
  qn_quantity_entry_set_value (panel->x, underlay->origin.x);
  qn_quantity_entry_set_value (panel->y, underlay->origin.y);
  qn_quantity_entry_set_value (panel->angle, underlay->angle);
}

static void
on_allow (Panel *panel)
{
  QnViewState *state = qn_canvas_get_state (panel->canvas);
  qn_document_allow_picture (qn_canvas_get_document (panel->canvas));
  qn_view_state_refresh_underlay (state);
}

static GtkWidget *
make_button (const char *label, const char *action, const char *target)
{
  GtkWidget *button = gtk_button_new_with_mnemonic (label);
  gtk_actionable_set_action_name (GTK_ACTIONABLE (button), action);
  if (target != NULL)
    gtk_actionable_set_action_target (GTK_ACTIONABLE (button), "s", target);
  gtk_widget_set_hexpand (button, TRUE);
  return button;
}

GtkWidget *
qn_picture_panel_new (QnCanvas *canvas)
{
  Panel *panel = g_new0 (Panel, 1);
  GtkWidget *form = qn_form_new ();
  GCallback quantity = G_CALLBACK (on_quantity);
  panel->canvas = canvas;
  panel->form = form;
  qn_form_add_heading (form, _ ("Picture behind the Drawing"));
  panel->trouble = qn_form_add_text (form);
  panel->allow = gtk_button_new_with_mnemonic (_ ("_Show It All the Same"));
  g_signal_connect_swapped (panel->allow, "clicked", G_CALLBACK (on_allow), panel);
  qn_form_add_wide (form, panel->allow);
  panel->opacity = gtk_scale_new_with_range (GTK_ORIENTATION_HORIZONTAL, 0.0, 1.0, 0.05);
  gtk_widget_set_hexpand (panel->opacity, TRUE);
  g_signal_connect (panel->opacity, "value-changed", G_CALLBACK (on_opacity), panel);
  qn_form_add_row (form, _ ("O_pacity"), panel->opacity);
  panel->width = qn_form_add_quantity (form, _ ("Wi_dth"), QN_QUANTITY_LENGTH, 1e-6, 1e6,
                                       quantity, panel);
  panel->x = qn_form_add_quantity (form, _ ("Left edge"), QN_QUANTITY_LENGTH, -1e6, 1e6,
                                   quantity, panel);
  panel->y = qn_form_add_quantity (form, _ ("Lower edge"), QN_QUANTITY_LENGTH, -1e6, 1e6,
                                   quantity, panel);
  panel->angle = qn_form_add_quantity (form, _ ("An_gle"), QN_QUANTITY_ANGLE, -10.0, 10.0,
                                       quantity, panel);
  GtkWidget *buttons = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 6);
  gtk_box_append (GTK_BOX (buttons),
                  make_button (_ ("_Move and Scale"), "win.tool", "picture"));
  gtk_box_append (GTK_BOX (buttons),
                  make_button (_ ("_Remove"), "win.remove-picture", NULL));
  qn_form_add_wide (form, buttons);
  qn_own (form, panel);
  qn_watch (form, qn_canvas_get_state (canvas), "changed", G_CALLBACK (update), panel);
  update (panel);
  return form;
}
