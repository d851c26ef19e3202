/* What is fixed: blocks and nodes of beams. The buttons of the file are actions on what is selected. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include <glib/gi18n.h>

/* Lines of the list; of more supports the rest is only counted. */
#define MOST_SHOWN 200

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (SUPPORTS, "supports", NULL)                                                     \
  FIELD (EMPTY, "empty", NULL)
QN_FORM_FIELDS;

static char *
dup_row (const char *name, const bool support[QN_DOF_COUNT])
{
  const char *const words[] = { "x", "y", _ ("turn") };
  g_autoptr (GString) in = g_string_new (NULL);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    if (support[dof])
      g_string_append_printf (in, "%s%s", in->len > 0 ? ", " : "", words[dof]);
  return qn_support_is_full (support)
           ? g_strdup_printf (_ ("%s: fixed"), name)
           : g_strdup_printf (_ ("%s: fixed in %s"), name, in->str);
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  guint count = 0;
  value->number = -1;
  for (gsize i = 0; i < model->block_count + model->node_count; i++) {
    const gboolean block = i < model->block_count;
    const QnNode *node = block ? NULL : &model->nodes[i - model->block_count];
    const bool *support = block ? model->blocks[i].support : node->support;
    if (!qn_support_is_any (support))
      continue;
    if (block && form->parts.blocks.count == 1 && form->parts.blocks.ids[0] == (QnId) i)
      value->number = count;
    if (count++ < MOST_SHOWN && field == SUPPORTS)
      qn_value_take_row (value,
                         dup_row (block ? model->blocks[i].name : node->name, support));
  }
  if (field == SUPPORTS && count > MOST_SHOWN)
    qn_value_take_row (value, g_strdup_printf (_ ("and %u more"), count - MOST_SHOWN));
  if (field == EMPTY)
    value->text = g_strdup (_ ("Nothing is fixed: the structure would fall as a whole. "
                               "Select blocks and fix them here."));
  return field != EMPTY || count == 0;
}

/* The support that was clicked is selected in the drawing, of a node a beam that ends there. */
static gboolean
take (QnForm *form, QnModel *model, guint field, const QnValue *value, GError **error)
{
  int row = (int) value->number;
  for (QnId i = 0; i < (QnId) model->block_count; i++)
    if (qn_support_is_any (model->blocks[i].support) && row-- == 0)
      qn_selection_set (form->canvas->selection, QN_PICK_BLOCK, &i, 1);
  for (QnId node = 0; node < (QnId) model->node_count; node++)
    if (qn_support_is_any (model->nodes[node].support) && row-- == 0)
      for (QnId i = 0; i < (QnId) model->beam_count; i++)
        if (model->beams[i].nodes[0] == node || model->beams[i].nodes[1] == node)
          qn_selection_set (form->canvas->selection, QN_PICK_BEAM, &i, 1);
  return TRUE;
}

const QnFormKind qn_support_form =
  QN_FORM_KIND ("support-form", QnForm, .follows = QN_FOLLOW_SELECTION);
