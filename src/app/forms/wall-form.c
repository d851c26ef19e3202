/* A wall that is listed course by course: its place and unit, and the way to a parametric one. */
#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-masonry.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnBoundForm base;
  QnId wall;
} Form;

enum { TITLE, X, Y, UNIT_X, UNIT_Y, CONVERT };

static const QnFormField fields[] = {
  [TITLE] = { .id = "title" },
  [X] = { .id = "x", .step = N_ ("Change Wall") },
  [Y] = { .id = "y", .step = N_ ("Change Wall") },
  [UNIT_X] = { .id = "unit_x", .step = N_ ("Change Wall") },
  [UNIT_Y] = { .id = "unit_y", .step = N_ ("Change Wall") },
  [CONVERT] = { .id = "convert", .step = N_ ("Make Wall Parametric") },
};

static gboolean
look (gpointer data)
{
  Form *form = data;
  QnBlockSet set = qn_canvas_get_selected (form->base.canvas);
  form->wall = set.count > 0
                 ? qn_canvas_get_model (form->base.canvas)->blocks[set.ids[0]].wall
                 : QN_NONE;
  return form->wall != QN_NONE;
}

static QnBound
bound_of (QnWall *wall, guint field)
{
  const QnBound all[G_N_ELEMENTS (fields)] = { [X] = QN_BOUND (&wall->origin.x),
                                               [Y] = QN_BOUND (&wall->origin.y),
                                               [UNIT_X] = QN_BOUND (&wall->unit.x),
                                               [UNIT_Y] = QN_BOUND (&wall->unit.y) };
  return all[field];
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const Form *form = data;
  QnWall *wall = &qn_canvas_get_model (form->base.canvas)->walls[form->wall];
  if (field == TITLE)
    value->text = g_strdup_printf (_ ("Wall %s"), wall->name);
  qn_value_show (value, bound_of (wall, field));
  return TRUE;
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  const Form *form = data;
  if (field == CONVERT)
    return qn_edit_convert_wall (draft, form->wall, error);
  qn_value_take (value, bound_of (&draft->model.walls[form->wall], field));
  return qn_edit_rebuild (&draft->model, NULL, error);
}

GtkWidget *
qn_wall_form_new (QnCanvas *canvas)
{
  static const QnFormKind kind = QN_FORM_KIND ("wall-form", Form, QN_FOLLOW_SELECTION);
  return qn_bound_form_show (qn_bound_form_new (&kind, canvas));
}
