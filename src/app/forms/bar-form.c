/* Reinforcing bars: a list of them, and what the selected one is made of and where it lies. The
 * selected one is that of the drawing. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit-tie.h"
#include "doc/view/pair-text.h"
#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

/* Diameters are shown in whole micrometres: areas are given, not they. */
#define SHOWN 1e6

#define CHANGE N_ ("Change Bar")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (BARS, "bars", NULL)                                                             \
  FIELD (EMPTY, "empty", NULL)                                                           \
  MEMBER (LAW, "law", CHANGE, QnBar, law)                                                \
  FIELD (DIAMETER, "diameter", CHANGE)                                                   \
  MEMBER (START_X, "start_x", CHANGE, QnBar, start.x)                                    \
  MEMBER (START_Y, "start_y", CHANGE, QnBar, start.y)                                    \
  MEMBER (END_X, "end_x", CHANGE, QnBar, end.x)                                          \
  MEMBER (END_Y, "end_y", CHANGE, QnBar, end.y)                                          \
  MEMBER (SPACING_X, "spacing_x", CHANGE, QnBar, spacing.x)                              \
  MEMBER (SPACING_Y, "spacing_y", CHANGE, QnBar, spacing.y)                              \
  FIELD (VIA, "via", CHANGE)                                                             \
  FIELD (ADD, "add", N_ ("Add Bar"))                                                     \
  FIELD (DUPLICATE, "duplicate", N_ ("Duplicate Bar"))                                   \
  FIELD (REMOVE, "remove", N_ ("Remove Bar"))
QN_FORM_FIELDS;

static char *
dup_row (const QnModel *model, gsize index)
{
  return qn_bar_dup_text (model, &model->bars[index], qn_settings_get_units ());
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  const QnBar *bar = qn_form_item (form, model);
  if (bar == NULL) {
    value->disabled = field != ADD;
    return field == ADD || (field > ADD && model->bar_count > 0);
  }
  if (field == LAW)
    qn_value_set_laws (value, model, NULL, bar->law);
  else if (field == DIAMETER)
    value->number = round (qn_bar_get_diameter (bar->area) * SHOWN) / SHOWN;
  else if (field == VIA)
    value->text = qn_points_dup_text (bar->via, bar->via_count);
  return TRUE;
}

static gboolean
take (QnForm *form, QnModel *model, guint field, const QnValue *value, GError **error)
{
  switch (field) {
  case DIAMETER:
    model->bars[form->selected].area = qn_bar_get_area (value->number);
    return TRUE;
  case VIA: {
    QnBar *bar = &model->bars[form->selected];
    QnVec2 points[QN_MAX_BAR_CORNERS];
    int32_t count = 0;
    if (value->text != NULL && *value->text != '\0'
        && !qn_points_parse (value->text, points, QN_MAX_BAR_CORNERS, &count))
      return qn_edit_refuse (error, _ ("Corners are pairs of numbers, x and y in m, "
                                       "a space between them, up to 30"));
    memcpy (bar->via, points, (gsize) count * sizeof points[0]);
    bar->via_count = count;
    return TRUE;
  }
  case ADD:
    if (!qn_edit_add_bar (model, form->parts.blocks, error))
      return FALSE;
    form->wanted = (int) model->bar_count - 1;
    return TRUE;
  case DUPLICATE:
    form->wanted = qn_edit_duplicate_item (model, QN_PICK_BAR, form->selected, error);
    return form->wanted >= 0;
  case REMOVE:
    return qn_edit_remove_item (model, QN_PICK_BAR, form->selected, error);
  }
  return TRUE;
}

static const QnFormList list =
  QN_FORM_LIST (BARS, EMPTY, bars, bar_count, dup_row, QN_PICK_BAR);

const QnFormKind qn_bar_form =
  QN_FORM_KIND ("bar-form", QnForm, .list = &list, .follows = QN_FOLLOW_SELECTION);
