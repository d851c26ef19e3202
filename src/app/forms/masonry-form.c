/* The parameters of the masonry that the selected blocks belong to. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit-masonry.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnForm base;
  QnId object; /* that the form is about */
} Form;

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TITLE, "title", NULL)                                                           \
  FIELD (BOND, "bond", N_ ("Change Bond"))                                               \
  FIELD (CLOSER, "closer", N_ ("Change Closers"))                                        \
  FIELD (SHAPE, "shape", N_ ("Change Arch"))                                             \
  FIELD (SIDES, "sides", N_ ("Change Arch"))                                             \
  FIELD (LAW, "law", N_ ("Set Law"))                                                     \
  FIELD (RING_LAW, "ring_law", N_ ("Set Law"))                                           \
  FIELD (SPANS, "spans", N_ ("Change %s"))                                               \
  FIELD (RISES, "rises", N_ ("Change %s"))                                               \
  FIELD (RINGS, "rings", N_ ("Change %s"))                                               \
  FIELD (PIERS, "piers", N_ ("Change %s"))                                               \
  FIELD (OPENINGS, "openings", NULL)
QN_FORM_FIELDS;

/* The object of the selected blocks, or of the selected opening. */
static gboolean
look (QnForm *data, const QnModel *model)
{
  Form *form = (Form *) data;
  QnBlockSet set = form->base.parts.blocks;
  if (set.count > 0)
    form->object = model->blocks[set.ids[0]].masonry;
  else
    form->object = form->base.canvas->selection->object;
  return form->object >= 0
         && (gsize) form->object < qn_canvas_get_masonry (form->base.canvas)->count;
}

static char *
dup_title (const QnMasonry *masonry)
{
  static const char *const titles[QN_MASONRY_KIND_COUNT] = {
    [QN_MASONRY_WALL] = N_ ("Wall %s"),     [QN_MASONRY_ARCH] = N_ ("Arch %s"),
    [QN_MASONRY_COLUMN] = N_ ("Column %s"), [QN_MASONRY_BUTTRESS] = N_ ("Buttress %s"),
    [QN_MASONRY_PORTAL] = N_ ("Portal %s"), [QN_MASONRY_RUBBLE] = N_ ("Rubble %s"),
  };
  g_auto (GStrv) parts = g_strsplit (_ (titles[masonry->kind]), "%s", 2);
  return g_strjoinv (masonry->name, parts);
}

static char *
dup_openings (guint count)
{
  if (count == 0)
    return g_strdup (_ ("No openings: cut some with the opening tool."));
  return g_strdup_printf (ngettext ("%u opening: click it in the drawing to change it.",
                                    "%u openings: click one in the drawing to change it.",
                                    count),
                          count);
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Form *form = (const Form *) data;
  const QnMasonry *masonry =
    &qn_canvas_get_masonry (form->base.canvas)->items[form->object];
  const QnArch *arch = qn_masonry_get_arch (masonry);
  const QnLeaf *leaf = &masonry->wall.leaves[0];
  gboolean wall = masonry->kind == QN_MASONRY_WALL;
  switch (field) {
  case TITLE:
    value->text = dup_title (masonry);
    return TRUE;
  case BOND:
    value->number = wall ? leaf->bond : 0;
    return wall;
  case CLOSER:
    if (!wall || (leaf->bond != QN_BOND_ENGLISH && leaf->bond != QN_BOND_FLEMISH))
      return FALSE;
    value->number = leaf->closer;
    return TRUE;
  case SHAPE:
    value->number = arch != NULL ? arch->shape : 0;
    return arch != NULL;
  case SIDES:
    value->number = arch != NULL ? arch->sides : 0;
    return arch != NULL;
  case RING_LAW:
    qn_value_set_laws (value, model, _ ("As all contacts"), masonry->ring_law);
    return arch != NULL && arch->rings > 1;
  case LAW:
    qn_value_set_laws (value, model, _ ("As all contacts"), masonry->law);
    return TRUE;
  case SPANS:
  case RISES:
  case RINGS:
  case PIERS:
    value->text = qn_portal_dup_list (&masonry->portal, (QnPortalList) (field - SPANS),
                                      qn_settings_get_units ());
    return masonry->kind == QN_MASONRY_PORTAL
           && (field == SPANS || field == PIERS || arch != NULL);
  case OPENINGS:
    value->text = dup_openings ((guint) masonry->wall.opening_count);
    return wall;
  default:
    if (!qn_masonry_has_field (masonry, QN_NO_OPENING, field - FIELD_COUNT))
      return FALSE;
    value->number = qn_masonry_get_field (masonry, QN_NO_OPENING, field - FIELD_COUNT);
    return TRUE;
  }
}

typedef struct Change {
  guint field;
  const QnValue *value;
} Change;

static gboolean
change_masonry (QnMasonry *masonry, gpointer data, GError **error)
{
  const Change *change = data;
  double number = change->value->number;
  QnLeaf *leaf = &masonry->wall.leaves[0];
  switch (change->field) {
  case BOND:
    qn_masonry_set_bond (masonry, (QnBond) number, leaf->lap);
    break;
  case CLOSER:
    leaf->closer = (QnCloser) number;
    break;
  case SHAPE:
    qn_masonry_get_arch (masonry)->shape = (QnArchShape) number;
    break;
  case SIDES:
    qn_masonry_get_arch (masonry)->sides = (QnSides) number;
    break;
  case RING_LAW:
    masonry->ring_law = qn_value_get_law (change->value);
    break;
  case LAW:
    masonry->law = qn_value_get_law (change->value);
    break;
  case SPANS:
  case RISES:
  case RINGS:
  case PIERS:
    return qn_portal_take_list (&masonry->portal, (QnPortalList) (change->field - SPANS),
                                qn_settings_get_units (), change->value->text, error);
  default:
    qn_masonry_set_field (masonry, QN_NO_OPENING, change->field - FIELD_COUNT, number);
    break;
  }
  return TRUE;
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  const Form *form = (const Form *) data;
  Change change = { field, value };
  if (field == BOND && (QnBond) value->number == QN_BOND_CUSTOM)
    return FALSE;
  return qn_edit_change_masonry (data->draft, form->object, change_masonry, &change,
                                 error);
}

const QnFormKind qn_masonry_form =
  QN_FORM_KIND ("masonry-form", Form, .look = look, .follows = QN_FOLLOW_SELECTION,
                .row_info = qn_masonry_field_info, .row_count = QN_MASONRY_FIELDS);
