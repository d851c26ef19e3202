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

enum {
  BARS,
  EMPTY,
  LAW,
  DIAMETER,
  START_X,
  START_Y,
  END_X,
  END_Y,
  ADD,
  DUPLICATE,
  REMOVE
};

static const QnFormField fields[] = {
  [BARS] = { .id = "bars" },
  [EMPTY] = { .id = "empty" },
  [LAW] = { .id = "law", .step = N_ ("Change Bar") },
  [DIAMETER] = { .id = "diameter", .step = N_ ("Change Bar") },
  [START_X] = { .id = "start_x", .step = N_ ("Change Bar") },
  [START_Y] = { .id = "start_y", .step = N_ ("Change Bar") },
  [END_X] = { .id = "end_x", .step = N_ ("Change Bar") },
  [END_Y] = { .id = "end_y", .step = N_ ("Change Bar") },
  [ADD] = { .id = "add", .step = N_ ("Add Bar") },
  [DUPLICATE] = { .id = "duplicate", .step = N_ ("Duplicate Bar") },
  [REMOVE] = { .id = "remove", .step = N_ ("Remove Bar") },
};

static gboolean
look (gpointer data)
{
  Form *form = data;
  form->selected = qn_bound_form_follow_item (
    form, QN_ITEM_BAR, qn_canvas_get_model (form->base.canvas)->bar_count, form->selected,
    &form->wanted);
  return TRUE;
}

/* The coordinate of a bar that a field shows. */
static QnBound
bound_of (QnBar *bar, guint field)
{
  const QnBound all[G_N_ELEMENTS (fields)] = { [START_X] = QN_BOUND (&bar->start.x),
                                               [START_Y] = QN_BOUND (&bar->start.y),
                                               [END_X] = QN_BOUND (&bar->end.x),
                                               [END_Y] = QN_BOUND (&bar->end.y) };
  return all[field];
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const Form *form = data;
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  gboolean any = form->selected >= 0;
  QnBar bar = any ? model->bars[form->selected] : (QnBar){ 0 };
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
      qn_value_set_laws (value, model, NULL, bar.law);
    return any;
  case DIAMETER:
    value->number = round (qn_bar_get_diameter (bar.area) * SHOWN) / SHOWN;
    return any;
  case ADD:
    return TRUE;
  case DUPLICATE:
  case REMOVE:
    value->disabled = !any;
    return TRUE;
  default:
    qn_value_show (value, bound_of (&bar, field));
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
    qn_value_take (value, bound_of (&model->bars[form->selected], field));
    return TRUE;
  }
}

GtkWidget *
qn_bar_form_new (QnCanvas *canvas)
{
  static const QnFormKind kind = QN_FORM_KIND ("bar-form", Form, QN_FOLLOW_SELECTION);
  Form *form = qn_bound_form_new (&kind, canvas);
  form->selected = form->wanted = -1;
  return qn_bound_form_show (form);
}
