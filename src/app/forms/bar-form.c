/* Reinforcing bars: a list of them, and what the selected one is made of and where it lies. The
 * selected one is that of the drawing. */
#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit-bar.h"
#include <glib/gi18n.h>
#include <math.h>

/* Diameters are shown in whole micrometres: areas are given, not they. */
#define SHOWN 1e6

typedef struct Form {
  QnBoundForm base;
  int selected; /* bar, or -1: that of the selection */
  int wanted;   /* to be selected once an edit has added it; -1: nothing */
} Form;

#define CHANGE N_ ("Change Bar")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (BARS, "bars", NULL)                                                             \
  FIELD (EMPTY, "empty", NULL)                                                           \
  FIELD (LAW, "law", CHANGE)                                                             \
  FIELD (DIAMETER, "diameter", CHANGE)                                                   \
  MEMBER (START_X, "start_x", CHANGE, QnBar, start.x)                                    \
  MEMBER (START_Y, "start_y", CHANGE, QnBar, start.y)                                    \
  MEMBER (END_X, "end_x", CHANGE, QnBar, end.x)                                          \
  MEMBER (END_Y, "end_y", CHANGE, QnBar, end.y)                                          \
  FIELD (ADD, "add", N_ ("Add Bar"))                                                     \
  FIELD (DUPLICATE, "duplicate", N_ ("Duplicate Bar"))                                   \
  FIELD (REMOVE, "remove", N_ ("Remove Bar"))
QN_FORM_FIELDS;

static gboolean
look (gpointer data)
{
  Form *form = data;
  form->selected = qn_bound_form_follow_item (
    form, QN_ITEM_BAR, qn_canvas_get_model (form->base.canvas)->bar_count, form->selected,
    &form->wanted);
  return TRUE;
}

static gpointer
subject (gpointer form, QnModel *model, guint field)
{
  const int selected = ((const Form *) form)->selected;
  return selected >= 0 ? &model->bars[selected] : NULL;
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const Form *form = data;
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  gboolean any = form->selected >= 0;
  switch (field) {
  case BARS:
    for (gsize i = 0; i < model->bar_count; i++)
      qn_value_take_row (
        value, qn_bar_dup_text (model, &model->bars[i], qn_settings_get_units ()));
    value->number = form->selected;
    return model->bar_count > 0;
  case EMPTY:
    value->text =
      g_strdup (_ ("No bars yet. Draw one with the tool Reinforcing Bar (E), or "
                   "select blocks and add one through them."));
    return model->bar_count == 0;
  case LAW:
    if (any)
      qn_value_set_laws (value, model, NULL, model->bars[form->selected].law);
    return any;
  case DIAMETER:
    if (any)
      value->number =
        round (qn_bar_get_diameter (model->bars[form->selected].area) * SHOWN) / SHOWN;
    return any;
  case ADD:
    return TRUE;
  case DUPLICATE:
  case REMOVE:
    value->disabled = !any;
    return TRUE;
  default:
    return any;
  }
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  Form *form = data;
  QnModel *model = draft != NULL ? &draft->model : NULL;
  switch (field) {
  case BARS:
    qn_selection_set_item (qn_canvas_get_selection (form->base.canvas), QN_ITEM_BAR,
                           (QnId) value->number);
    return TRUE;
  case LAW:
    model->bars[form->selected].law = (QnId) value->number;
    return TRUE;
  case DIAMETER:
    model->bars[form->selected].area = qn_bar_get_area (value->number);
    return TRUE;
  case ADD:
    if (!qn_edit_add_bar (model, qn_canvas_get_selected (form->base.canvas), error))
      return FALSE;
    form->wanted = (int) model->bar_count - 1;
    return TRUE;
  case DUPLICATE:
    form->wanted = (int) model->bar_count;
    return qn_edit_duplicate_bar (model, form->selected, error);
  case REMOVE:
    return qn_edit_remove_bar (model, form->selected, error);
  default:
    return TRUE;
  }
}

GtkWidget *
qn_bar_form_new (QnCanvas *canvas)
{
  static const QnFormKind kind = QN_FORM_KIND (
    "bar-form", Form, .subject = subject, .look = look, .follows = QN_FOLLOW_SELECTION);
  Form *form = qn_bound_form_new (&kind, canvas);
  form->selected = form->wanted = -1;
  return qn_bound_form_show (form);
}
