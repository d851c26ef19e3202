/* A wall that is listed course by course: its place and unit, and the way to a parametric one. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-masonry.h"
#include <glib/gi18n.h>

#define LARGEST 1e6 /* m: limit of fields */

typedef struct Form {
  QnCanvas *canvas;
  GtkWidget *box;
  GtkLabel *title;
  QnQuantityEntry *x, *y, *unit_x, *unit_y;
  QnId wall;
} Form;

static gboolean
edit_wall (QnModel *model, gpointer data, GError **error)
{
  const Form *form = data;
  QnWall *wall = &model->walls[form->wall];
  wall->origin = qn_vec2 (qn_quantity_entry_get_value (form->x),
                          qn_quantity_entry_get_value (form->y));
  wall->unit = qn_vec2 (qn_quantity_entry_get_value (form->unit_x),
                        qn_quantity_entry_get_value (form->unit_y));
  return qn_edit_rebuild (model, NULL, error);
}

static gboolean
edit_convert (QnProject *draft, gpointer data, GError **error)
{
  const Form *form = data;
  return qn_edit_convert_wall (draft, form->wall, error);
}

static void update (Form *form);

static void
on_quantity (QnQuantityEntry *entry, Form *form)
{
  (void) entry;
  if (form->wall != QN_NONE
      && !qn_canvas_edit (form->canvas, _ ("Change Wall"), NULL, edit_wall, form))
    update (form);
}

static void
on_convert (Form *form)
{
  if (form->wall != QN_NONE)
    qn_canvas_edit_project (form->canvas, _ ("Make Wall Parametric"), NULL, edit_convert,
                            form);
}

static void
update (Form *form)
{
  const QnModel *model = qn_canvas_get_model (form->canvas);
  guint count = 0;
  const QnId *ids =
    qn_selection_get_blocks (qn_canvas_get_selection (form->canvas), &count);
  form->wall = count > 0 ? model->blocks[ids[0]].wall : QN_NONE;
  gtk_widget_set_visible (form->box, form->wall != QN_NONE);
  if (form->wall == QN_NONE)
    return;
  const QnWall *wall = &model->walls[form->wall];
  g_autofree char *title = g_strdup_printf (_ ("Wall %s"), wall->name);
  gtk_label_set_text (form->title, title);
  qn_quantity_entry_set_value (form->x, wall->origin.x);
  qn_quantity_entry_set_value (form->y, wall->origin.y);
  qn_quantity_entry_set_value (form->unit_x, wall->unit.x);
  qn_quantity_entry_set_value (form->unit_y, wall->unit.y);
}

GtkWidget *
qn_wall_form_new (QnCanvas *canvas)
{
  Form *form = g_new0 (Form, 1);
  form->canvas = canvas;
  GtkWidget *grid = form->box = qn_form_new ();
  GCallback changed = G_CALLBACK (on_quantity);
  form->title = GTK_LABEL (qn_form_add_heading (grid, ""));
  form->x = qn_form_add_quantity (grid, _ ("Left edge"), QN_QUANTITY_LENGTH, -LARGEST,
                                  LARGEST, changed, form);
  form->y = qn_form_add_quantity (grid, _ ("Lower edge"), QN_QUANTITY_LENGTH, -LARGEST,
                                  LARGEST, changed, form);
  form->unit_x = qn_form_add_quantity (grid, _ ("Block length"), QN_QUANTITY_LENGTH, 1e-4,
                                       LARGEST, changed, form);
  form->unit_y = qn_form_add_quantity (grid, _ ("Course height"), QN_QUANTITY_LENGTH,
                                       1e-4, LARGEST, changed, form);
  GtkWidget *convert = gtk_button_new_with_mnemonic (_ ("Edit _Bond and Openings"));
  g_signal_connect_swapped (convert, "clicked", G_CALLBACK (on_convert), form);
  gtk_widget_set_tooltip_text (
    convert, _ ("The wall is listed course by course; this makes it one with a bond and "
                "openings that can be moved"));
  qn_form_add_wide (grid, convert);
  qn_form_add_wide (grid, qn_detach_button_new ());
  qn_form_follow_canvas (grid, canvas, G_CALLBACK (update), form);
  update (form);
  return grid;
}
