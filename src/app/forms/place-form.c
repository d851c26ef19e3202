/* Where the selection is, how large and how turned, by numbers; its centroid, area and weight. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit-place.h"
#include <glib/gi18n.h>

enum { TURN = QN_EXTENT_COUNT, FACTS };

static const QnFormField fields[] = {
  [QN_EXTENT_X] = { .id = "x", .step = N_ ("Move") },
  [QN_EXTENT_Y] = { .id = "y", .step = N_ ("Move") },
  [QN_EXTENT_WIDTH] = { .id = "width", .step = N_ ("Set Width") },
  [QN_EXTENT_HEIGHT] = { .id = "height", .step = N_ ("Set Height") },
  [QN_EXTENT_ANGLE] = { .id = "angle", .step = N_ ("Rotate") },
  [TURN] = { .id = "turn", .step = N_ ("Rotate") },
  [FACTS] = { .id = "facts" },
};

static gboolean
look (QnForm *form, const QnModel *model)
{
  return form->parts.blocks.count + form->parts.beams.count > 0;
}

static char *
dup_facts (const QnExtent *extent)
{
  QnUnits units = qn_settings_get_units ();
  g_autofree char *x = qn_units_format (units, QN_QUANTITY_LENGTH, extent->centroid.x, 5);
  g_autofree char *y =
    qn_units_format_full (units, QN_QUANTITY_LENGTH, extent->centroid.y, 5);
  g_autofree char *area =
    qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, extent->area, 5);
  g_autofree char *weight =
    qn_units_format_full (units, QN_QUANTITY_FORCE, extent->weight, 5);
  return g_strdup_printf (_ ("Centroid at %s; %s\nArea %s m², weight %s"), x, y, area,
                          weight);
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  QnPartSet set = form->parts;
  QnExtent extent;
  if (!qn_extent_find (model, set, &extent))
    return FALSE;
  QnVec2 size = qn_vec2_sub (extent.box.max, extent.box.min);
  value->disabled = (field == QN_EXTENT_WIDTH || field == QN_EXTENT_HEIGHT)
                    && !qn_extent_can_scale (model, set);
  switch (field) {
  case QN_EXTENT_X:
    value->number = extent.box.min.x;
    return TRUE;
  case QN_EXTENT_Y:
    value->number = extent.box.min.y;
    return TRUE;
  case QN_EXTENT_WIDTH:
    value->number = size.x;
    return TRUE;
  case QN_EXTENT_HEIGHT:
    value->number = size.y;
    return TRUE;
  case QN_EXTENT_ANGLE:
    value->number = extent.angle;
    return set.blocks.count == 1 && set.beams.count == 0;
  case TURN:
    return set.blocks.count != 1 || set.beams.count > 0;
  case FACTS:
    value->text = dup_facts (&extent);
    return set.blocks.count > 0;
  default:
    return FALSE;
  }
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  QnExtentField what = field == TURN ? QN_EXTENT_ANGLE : (QnExtentField) field;
  return qn_edit_set_extent (data->draft, data->parts, what, value->number, error);
}

const QnFormKind qn_place_form =
  QN_FORM_KIND ("place-form", QnForm, .look = look, .follows = QN_FOLLOW_SELECTION);
