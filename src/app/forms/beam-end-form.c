/* One end of the selected beam: where its node is and what holds it. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnForm base;
  int end;
  QnId beam, node; /* that the form is about */
} Form;

#define CHANGE N_ ("Set Support")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TITLE, "title", NULL)                                                           \
  FIELD (X, "x", N_ ("Move Beam End"))                                                   \
  FIELD (Y, "y", N_ ("Move Beam End"))                                                   \
  FIELD (SEAT, "seat", N_ ("Join Beam to Block"))                                        \
  FIELD (SUPPORTS, "supports", NULL)                                                     \
  FIELD (SUPPORT, "support_x", CHANGE)                                                   \
  FIELD (SUPPORT_Y, "support_y", CHANGE)                                                 \
  FIELD (SUPPORT_TURN, "support_turn", CHANGE)                                           \
  FIELD (FACTS, "facts", NULL)                                                           \
  FIELD (PART, "part", N_ ("Disconnect Beams"))
QN_FORM_FIELDS;

/* Rows of the choice: free, at the centroid, at a point, and the sides. */
static const struct {
  QnSeat seat;
  QnBlockSide side;
} seats[] = { { QN_SEAT_FREE, 0 },
              { QN_SEAT_CENTROID, 0 },
              { QN_SEAT_POINT, 0 },
              { QN_SEAT_SIDE, QN_BLOCK_SIDE_LEFT },
              { QN_SEAT_SIDE, QN_BLOCK_SIDE_RIGHT },
              { QN_SEAT_SIDE, QN_BLOCK_SIDE_BOTTOM },
              { QN_SEAT_SIDE, QN_BLOCK_SIDE_TOP } };

static gboolean
look (QnForm *data, const QnModel *model)
{
  Form *form = (Form *) data;
  if (form->base.parts.beams.count != 1)
    return FALSE;
  form->beam = form->base.parts.beams.ids[0];
  form->node = model->beams[form->beam].nodes[form->end];
  return TRUE;
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Form *form = (const Form *) data;
  const QnNode *node = &model->nodes[form->node];
  guint beams = qn_model_node_beams (model, form->node);
  switch (field) {
  case TITLE:
    value->text = g_strdup (form->end == 0 ? _ ("First End") : _ ("Second End"));
    return TRUE;
  case X:
  case Y:
    value->number = field == X ? node->at.x : node->at.y;
    value->disabled = node->seat == QN_SEAT_CENTROID || node->seat == QN_SEAT_SIDE;
    return TRUE;
  case SEAT:
    for (guint i = 0; i < G_N_ELEMENTS (seats); i++)
      if (seats[i].seat == node->seat
          && (node->seat != QN_SEAT_SIDE || seats[i].side == node->side))
        value->number = i;
    return TRUE;
  case SUPPORTS:
    return node->block == QN_NONE;
  case FACTS: {
    g_autofree char *others =
      beams > 1 ? g_strdup_printf (
        ngettext ("%u other beam ends here.", "%u other beams end here.", beams - 1),
        beams - 1)
                : g_strdup ("");
    value->text =
      g_strchomp (node->block != QN_NONE
                    ? g_strdup_printf (_ ("Node %s, on block %s. %s"), node->name,
                                       model->blocks[node->block].name, others)
                    : g_strdup_printf (_ ("Node %s. %s"), node->name, others));
    return TRUE;
  }
  case PART:
    return beams > 1;
  default:
    value->number = node->support[field - SUPPORT];
    return TRUE;
  }
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  const Form *form = (const Form *) data;
  const QnNode *node = &model->nodes[form->node];
  QnVec2 at = node->at;
  bool support[QN_DOF_COUNT];
  switch (field) {
  case X:
  case Y:
    *(field == X ? &at.x : &at.y) = value->number;
    return qn_edit_place_node (model, form->node, at, error);
  case SEAT:
    return qn_edit_set_node_seat (
      model, form->node, seats[(guint) value->number].seat,
      node->block != QN_NONE ? node->block : qn_model_block_under (model, at),
      seats[(guint) value->number].side, error);
  case PART:
    return qn_edit_part_beam (model, form->beam, form->end, error);
  default:
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      support[dof] = node->support[dof];
    support[field - SUPPORT] = value->number != 0.0;
    return qn_edit_set_node_support (model, form->node, support, error);
  }
}

static void
init_second (QnForm *form)
{
  ((Form *) form)->end = 1;
}

const QnFormKind qn_first_end_form =
  QN_FORM_KIND ("beam-end-form", Form, .look = look, .follows = QN_FOLLOW_SELECTION);
const QnFormKind qn_second_end_form =
  QN_FORM_KIND ("beam-end-form", Form, .look = look, .follows = QN_FOLLOW_SELECTION,
                .init = init_second);
