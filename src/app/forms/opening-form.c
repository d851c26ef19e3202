/* The selected opening of a wall: place, size, and what spans it. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-masonry.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnForm base;
  QnId object;
  int number;
} Form;

#define CHANGE N_ ("Change Opening")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TITLE, "title", NULL)                                                           \
  FIELD (HEAD, "head", CHANGE)                                                           \
  FIELD (SPAN, "span", CHANGE)                                                           \
  FIELD (SIDES, "sides", CHANGE)
QN_FORM_FIELDS;

/* What spans flat heads, in the order of the list. */
static const QnSpan spans[] = { QN_SPAN_NONE, QN_SPAN_LINTEL, QN_SPAN_FLAT_ARCH,
                                QN_SPAN_VOUSSOIRS };

static gboolean
look (QnForm *data, const QnModel *model)
{
  Form *form = (Form *) data;
  const QnMasonries *list = qn_canvas_get_masonry (form->base.canvas);
  form->object = form->base.canvas->selection->object;
  form->number = form->base.canvas->selection->opening;
  return form->object != QN_NONE && (gsize) form->object < list->count
         && (gsize) form->number < list->items[form->object].wall.opening_count;
}

static QnFieldInfo
row_info (guint row)
{
  QnFieldInfo info = qn_masonry_field_info (QN_MASONRY_FIELDS + row);
  info.step = row < QN_OPENING_PLACE_FIELDS ? N_ ("Move Opening") : CHANGE;
  return info;
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Form *form = (const Form *) data;
  const QnMasonry *wall = &qn_canvas_get_masonry (form->base.canvas)->items[form->object];
  const QnOpening *opening = &wall->wall.openings[form->number];
  const guint number = QN_MASONRY_FIELDS + field - FIELD_COUNT;
  switch (field) {
  case TITLE:
    value->text = opening->name != NULL
                    ? g_strdup_printf (_ ("Opening %s"), opening->name)
                    : g_strdup_printf (_ ("Opening %d"), form->number + 1);
    return TRUE;
  case HEAD:
    value->number = opening->head;
    return TRUE;
  case SPAN:
    for (guint i = 0; i < G_N_ELEMENTS (spans); i++)
      if (spans[i] == opening->span)
        value->number = i;
    return TRUE;
  case SIDES:
    value->number = opening->sides;
    return opening->span == QN_SPAN_VOUSSOIRS;
  default:
    if (!qn_masonry_has_field (wall, form->number, number))
      return FALSE;
    value->number = qn_masonry_get_field (wall, form->number, number);
    return TRUE;
  }
}

typedef struct Change {
  guint field;
  double number;
  int opening;
  QnHead head;
  QnSpan span;
} Change;

static gboolean
change_opening (QnMasonry *masonry, gpointer data, GError **error)
{
  const Change *change = data;
  QnOpening *opening = &masonry->wall.openings[change->opening];
  if (change->field >= FIELD_COUNT)
    qn_masonry_set_field (masonry, change->opening,
                          QN_MASONRY_FIELDS + change->field - FIELD_COUNT,
                          change->number);
  else if (change->field == SIDES)
    opening->sides = (QnSides) change->number;
  else
    qn_opening_set_head (opening, change->head, change->span,
                         masonry->wall.leaves[0].unit.y);
  return TRUE;
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  const Form *form = (const Form *) data;
  Change change = {
    .field = field,
    .number = value->number,
    .opening = form->number,
    .head = (QnHead) qn_form_get_number (data, HEAD),
    .span = spans[(guint) qn_form_get_number (data, SPAN)],
  };
  return qn_edit_change_masonry (data->draft, form->object, change_opening, &change,
                                 error);
}

const QnFormKind qn_opening_form =
  QN_FORM_KIND ("opening-form", Form, .look = look, .follows = QN_FOLLOW_SELECTION,
                .row_info = row_info, .row_count = QN_OPENING_FIELDS);
