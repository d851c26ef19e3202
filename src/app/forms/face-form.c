/* The selected contact faces: their blocks, law and pairs. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit.h"
#include "doc/text/explain.h"
#include "doc/view/pair-text.h"
#include <glib/gi18n.h>

/* Rows of the list of placements: as all contacts, then those of QnPlacement. */
enum { ROW_AS_ALL };

#define CHANGE N_ ("Place Pairs")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TITLE, "title", NULL)                                                           \
  FIELD (FACTS, "facts", NULL)                                                           \
  FIELD (LAW, "law", N_ ("Set Law of Joints"))                                           \
  FIELD (PLACEMENT, "placement", CHANGE)                                                 \
  FIELD (OFFSET, "offset", CHANGE)                                                       \
  FIELD (COUNT, "count", CHANGE)                                                         \
  FIELD (POSITIONS, "positions", CHANGE)                                                 \
  FIELD (RESET, "reset", N_ ("Remove Exceptions"))
QN_FORM_FIELDS;

static const QnId *
selected (const QnForm *form, guint *count)
{
  return qn_selection_get (form->canvas->selection, QN_PICK_FACE, count);
}

static const QnContacts *
contacts_of (const QnForm *form)
{
  return &form->canvas->document->contacts;
}

static gboolean
look (QnForm *form, const QnModel *model)
{
  guint count = 0;
  const QnId *ids = selected (form, &count);
  for (guint i = 0; i < count; i++)
    if ((gsize) ids[i] >= contacts_of (form)->face_count)
      return FALSE;
  return count > 0;
}

/* ---- what is shown ---- */

static char *
dup_facts (const QnForm *form, const QnModel *model, const QnId *ids, guint count)
{
  const QnContactFace *faces = contacts_of (form)->faces, *face = &faces[ids[0]];
  double length = 0.0;
  int pairs = 0;
  for (guint i = 0; i < count; i++) {
    length += faces[ids[i]].length;
    pairs += faces[ids[i]].pair_count;
  }
  g_autofree char *size =
    qn_units_format_full (qn_settings_get_units (), QN_QUANTITY_LENGTH, length, 5);
  const QnCount of_pairs = { QN_COUNTED_PAIRS, (gsize) pairs };
  g_autofree char *contents = qn_counts_dup_text (&of_pairs, 1, "");
  const char *a = model->blocks[face->a].name, *b = model->blocks[face->b].name;
  const char *law_a = model->laws[face->law_a].name;
  const char *law_b = model->laws[face->law_b].name;
  if (count > 1)
    return g_strdup_printf (_ ("%s long in all, %s"), size, contents);
  if (face->law_a == face->law_b)
    return g_strdup_printf (_ ("%s – %s, %s long, %s; law “%s”"), a, b, size, contents,
                            law_a);
  return g_strdup_printf (_ ("%s – %s, %s long, %s; laws “%s” and “%s”"), a, b, size,
                          contents, law_a, law_b);
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  guint count = 0;
  const QnId *ids = selected (form, &count);
  const QnFaceOverride *override =
    qn_model_find_override (model, &contacts_of (form)->faces[ids[0]]);
  gboolean own = override != NULL && override->has_pairs;
  const QnPairRule *rule = own ? &override->pairs : &model->contact.pairs;
  switch (field) {
  case TITLE:
    value->text = count == 1
                    ? g_strdup_printf (_ ("Contact Face %d"), ids[0])
                    : g_strdup_printf (
                      ngettext ("%u Contact Face", "%u Contact Faces", count), count);
    return TRUE;
  case FACTS:
    value->text = dup_facts (form, model, ids, count);
    return TRUE;
  case LAW:
    qn_value_set_laws (value, model, _ ("As its blocks"),
                       override != NULL ? override->law : QN_NONE);
    return TRUE;
  case PLACEMENT:
    value->number = own ? (int) rule->placement + 1 : ROW_AS_ALL;
    return TRUE;
  case OFFSET:
  case COUNT:
  case POSITIONS:
    return qn_value_set_pairs (value, model, rule,
                               contacts_of (form)->faces[ids[0]].law_a,
                               (QnPairField) (field - PLACEMENT))
           && own;
  default:
    return override != NULL;
  }
}

/* ---- changes ---- */

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  guint count = 0;
  const QnId *ids = selected (data, &count);
  const QnFaceSet set = { contacts_of (data), ids, count };
  const QnId law = field == LAW ? qn_value_get_law (value) : QN_NONE;
  int row = (int) qn_form_get_number (data, PLACEMENT);
  if ((field == LAW || field == RESET)
      && !qn_edit_set_faces (model, set, &law, NULL, error))
    return FALSE;
  if (field == LAW)
    return TRUE;
  if (field == RESET || row == ROW_AS_ALL)
    return qn_edit_set_faces (model, set, NULL, NULL, error);
  QnPairRule rule = { .placement = (QnPlacement) (row - 1) };
  g_autofree char *positions = qn_form_dup_text (data, POSITIONS);
  QnValue pairs = { .number = qn_form_get_number (data, COUNT) };
  if (rule.placement <= QN_PLACEMENT_LOBATTO)
    rule.offset = qn_form_get_number (data, OFFSET);
  if (rule.placement != QN_PLACEMENT_LOBATTO || field == COUNT)
    rule.count = MAX (qn_value_int (&pairs), 1);
  return (rule.placement != QN_PLACEMENT_EXPLICIT
          || qn_pair_rule_parse (&rule, positions, "", error))
         && qn_edit_set_faces (model, set, NULL, &rule, error);
}

const QnFormKind qn_face_form =
  QN_FORM_KIND ("face-form", QnForm, .look = look, .follows = QN_FOLLOW_SELECTION);
