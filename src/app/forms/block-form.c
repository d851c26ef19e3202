/* The selected blocks: what they are made of, and how they are held. */
#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include <glib/gi18n.h>

enum { TITLE, NAME, THICKNESS, WEIGHT, LAW, SUPPORTS, SUPPORT, JOIN = SUPPORT + 3 };

static const QnFormField fields[] = {
  [TITLE] = { .id = "title" },
  [NAME] = { .id = "name", .step = N_ ("Rename Block") },
  [THICKNESS] = { .id = "thickness", .step = N_ ("Set Thickness") },
  [WEIGHT] = { .id = "weight", .step = N_ ("Set Unit Weight") },
  [LAW] = { .id = "law", .step = N_ ("Set Law") },
  [SUPPORTS] = { .id = "supports" },
  [SUPPORT + QN_DOF_UX] = { .id = "support_x", .step = N_ ("Set Support") },
  [SUPPORT + QN_DOF_UY] = { .id = "support_y", .step = N_ ("Set Support") },
  [SUPPORT + QN_DOF_RZ] = { .id = "support_turn", .step = N_ ("Set Support") },
  [JOIN] = { .id = "join" },
};

static gboolean
look (gpointer data)
{
  const QnBoundForm *form = data;
  return qn_canvas_get_selected (form->canvas).count > 0;
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const QnBoundForm *form = data;
  const QnModel *model = qn_canvas_get_model (form->canvas);
  QnBlockSet set = qn_canvas_get_selected (form->canvas);
  const QnBlock *block = &model->blocks[set.ids[0]];
  /* What masonry is made of is told by its own form. */
  gboolean masonry = TRUE;
  for (guint i = 0; i < set.count; i++)
    masonry = masonry && model->blocks[set.ids[i]].masonry != QN_NONE;
  gboolean free_block =
    set.count == 1 && block->wall == QN_NONE && block->masonry == QN_NONE;
  switch (field) {
  case TITLE:
    value->text =
      set.count == 1
        ? g_strdup_printf (_ ("Block %s"), block->name)
        : g_strdup_printf (ngettext ("%u Block", "%u Blocks", set.count), set.count);
    return TRUE;
  case NAME:
    value->text = g_strdup (block->name);
    return free_block;
  case THICKNESS:
    value->number = block->thickness;
    return !masonry;
  case WEIGHT:
    value->number = block->unit_weight;
    return !masonry;
  case LAW:
    qn_value_set_laws (value, model, _ ("As all contacts"), block->law);
    return !masonry;
  case SUPPORTS:
    return TRUE;
  case JOIN:
    return set.count > 1;
  default:
    value->number = block->support[field - SUPPORT];
    for (guint i = 0; i < set.count; i++)
      value->mixed |=
        model->blocks[set.ids[i]].support[field - SUPPORT] != (value->number != 0.0);
    return TRUE;
  }
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  QnModel *model = &draft->model;
  QnBlockSet set = qn_canvas_get_selected (((const QnBoundForm *) data)->canvas);
  bool support[QN_DOF_COUNT];
  switch (field) {
  case NAME:
    return qn_edit_rename_block (model, set.ids[0], value->text, error);
  case THICKNESS:
    return qn_edit_set_thickness (model, set, value->number, error);
  case WEIGHT:
    return qn_edit_set_unit_weight (model, set, value->number, error);
  case LAW:
    return qn_edit_set_law (model, set, qn_value_get_law (value), error);
  default:
    for (guint dof = 0; dof < QN_DOF_COUNT; dof++)
      support[dof] = qn_bound_form_get_number (data, SUPPORT + dof) != 0.0;
    return qn_edit_set_support (model, set, support, error);
  }
}

GtkWidget *
qn_block_form_new (QnCanvas *canvas)
{
  static const QnFormKind kind =
    QN_FORM_KIND ("block-form", QnBoundForm, QN_FOLLOW_SELECTION);
  return qn_bound_form_show (qn_bound_form_new (&kind, canvas));
}
