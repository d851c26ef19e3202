/* A wall that is listed course by course: its place and unit, and the way to a parametric one. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-masonry.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnForm base;
  QnId wall;
} Form;

#define CHANGE N_ ("Change Wall")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TITLE, "title", NULL)                                                           \
  MEMBER (X, "x", CHANGE, QnWall, origin.x)                                              \
  MEMBER (Y, "y", CHANGE, QnWall, origin.y)                                              \
  MEMBER (UNIT_X, "unit_x", CHANGE, QnWall, unit.x)                                      \
  MEMBER (UNIT_Y, "unit_y", CHANGE, QnWall, unit.y)                                      \
  FIELD (CONVERT, "convert", N_ ("Make Wall Parametric"))
QN_FORM_FIELDS;

static gboolean
look (QnForm *data, const QnModel *model)
{
  Form *form = (Form *) data;
  QnBlockSet set = form->base.parts.blocks;
  form->wall = set.count > 0 ? model->blocks[set.ids[0]].wall : QN_NONE;
  return form->wall != QN_NONE;
}

static gpointer
subject (QnForm *form, QnModel *model, guint field)
{
  return &model->walls[((const Form *) form)->wall];
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Form *form = (const Form *) data;
  if (field == TITLE)
    value->text = g_strdup_printf (_ ("Wall %s"), model->walls[form->wall].name);
  return TRUE;
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  const Form *form = (const Form *) data;
  return field != CONVERT || qn_edit_convert_wall (data->draft, form->wall, error);
}

const QnFormKind qn_wall_form = QN_FORM_KIND (
  "wall-form", Form, .subject = subject, .look = look, .follows = QN_FOLLOW_SELECTION);
