/* Copies of what is selected: in a row, a column, or around a point. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "core/base/integer.h"
#include <glib/gi18n.h>

#define LARGEST 1e6 /* m */

typedef struct Form {
  QnCanvas *canvas;
  GtkWidget *box;
  QnQuantityEntry *copies, *right, *up, *turn;
} Form;

static void
on_make (Form *form)
{
  GVariant *value = g_variant_new (
    "(iddd)",
    (int) qn_to_integer (qn_quantity_entry_get_value (form->copies), 0, G_MAXINT32),
    qn_quantity_entry_get_value (form->right), qn_quantity_entry_get_value (form->up),
    qn_quantity_entry_get_value (form->turn));
  g_autoptr (GVariant) owned = g_variant_ref_sink (value);
  gtk_widget_activate_action_variant (GTK_WIDGET (form->canvas), "win.array", owned);
}

/* Numbers that are only read when the button is pressed. */
static void
on_number (QnQuantityEntry *entry, Form *form)
{
  (void) entry;
  (void) form;
}

static void
update (Form *form)
{
  guint blocks = 0, beams = 0;
  qn_selection_get_blocks (qn_canvas_get_selection (form->canvas), &blocks);
  qn_selection_get_beams (qn_canvas_get_selection (form->canvas), &beams);
  gtk_widget_set_visible (form->box, blocks + beams > 0);
}

GtkWidget *
qn_array_form_new (QnCanvas *canvas)
{
  Form *form = g_new0 (Form, 1);
  form->canvas = canvas;
  GtkWidget *grid = qn_form_new ();
  GtkWidget *expander = gtk_expander_new_with_mnemonic (_ ("Arra_y of Copies"));
  GCallback nothing = G_CALLBACK (on_number);
  form->copies = qn_form_add_quantity (grid, _ ("_Copies"), QN_QUANTITY_NUMBER, 1.0,
                                       1000.0, nothing, form);
  form->right =
    qn_form_add_quantity (grid, _ ("Each to the _right by"), QN_QUANTITY_LENGTH, -LARGEST,
                          LARGEST, nothing, form);
  form->up = qn_form_add_quantity (grid, _ ("Each _up by"), QN_QUANTITY_LENGTH, -LARGEST,
                                   LARGEST, nothing, form);
  form->turn = qn_form_add_quantity (grid, _ ("Each _turned by"), QN_QUANTITY_ANGLE,
                                     -10.0, 10.0, nothing, form);
  qn_quantity_entry_set_value (form->copies, 3.0);
  qn_quantity_entry_set_value (form->right, 1.0);
  GtkWidget *button = gtk_button_new_with_mnemonic (_ ("Make C_opies"));
  g_signal_connect_swapped (button, "clicked", G_CALLBACK (on_make), form);
  qn_form_add_wide (grid, button);
  gtk_expander_set_child (GTK_EXPANDER (expander), grid);
  gtk_widget_set_margin_start (expander, 12);
  gtk_widget_set_margin_end (expander, 12);
  form->box = expander;
  qn_own (expander, form);
  qn_watch (expander, qn_canvas_get_selection (canvas), "changed", G_CALLBACK (update),
            form);
  update (form);
  return expander;
}
