/* One end of the selected beam: where its node is and what holds it. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include <glib/gi18n.h>

#define LARGEST 1e6 /* m: limit of fields */

typedef struct Form {
  QnCanvas *canvas;
  int end;
  GtkWidget *box, *supports, *part;
  GtkLabel *title, *facts;
  QnQuantityEntry *x, *y;
  GtkDropDown *seat;
  GtkWidget *support[QN_DOF_COUNT];
  QnId beam, node; /* that the form is about, or QN_NONE */
} Form;

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

/* ---- changes ---- */

typedef struct Change {
  QnId beam, node, block;
  int end;
  QnVec2 at;
  guint seat;
  bool support[QN_DOF_COUNT];
} Change;

static gboolean
edit_place (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_place_node (model, c->node, c->at, error);
}

static gboolean
edit_seat (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_set_node_seat (model, c->node, seats[c->seat].seat, c->block,
                                seats[c->seat].side, error);
}

static gboolean
edit_support (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_set_node_support (model, c->node, c->support, error);
}

static gboolean
edit_part (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_part_beam (model, c->beam, c->end, error);
}

static void update (Form *form);

static void
apply (Form *form, const char *name, QnEditFunc func, Change change)
{
  change.beam = form->beam;
  change.node = form->node;
  change.end = form->end;
  if (form->node == QN_NONE || !qn_canvas_edit (form->canvas, name, NULL, func, &change))
    update (form);
}

static void
on_place (QnQuantityEntry *entry, Form *form)
{
  (void) entry;
  apply (form, _ ("Move Beam End"), edit_place,
         (Change){ .at = { qn_quantity_entry_get_value (form->x),
                           qn_quantity_entry_get_value (form->y) } });
}

static void
on_seat (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  if (form->node == QN_NONE)
    return;
  const QnNode *node = &qn_canvas_get_model (form->canvas)->nodes[form->node];
  QnId under = qn_model_block_under (qn_canvas_get_model (form->canvas), node->at, 1e-9);
  apply (form, _ ("Join Beam to Block"), edit_seat,
         (Change){ .block = node->block != QN_NONE ? node->block : under,
                   .seat = gtk_drop_down_get_selected (choice) });
}

static void
on_support (GtkCheckButton *button, Form *form)
{
  (void) button;
  Change change = { 0 };
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    change.support[dof] =
      gtk_check_button_get_active (GTK_CHECK_BUTTON (form->support[dof]));
  apply (form, _ ("Set Support"), edit_support, change);
}

static void
on_part (Form *form)
{
  apply (form, _ ("Part Beams"), edit_part, (Change){ 0 });
}

/* ---- what is shown ---- */

static guint
row_of_seat (const QnNode *node)
{
  for (guint i = 0; i < G_N_ELEMENTS (seats); i++) {
    if (seats[i].seat == node->seat
        && (node->seat != QN_SEAT_SIDE || seats[i].side == node->side))
      return i;
  }
  return 0;
}

static void
update_facts (Form *form, const QnModel *model, const QnNode *node)
{
  guint beams = qn_model_node_beams (model, form->node);
  g_autofree char *others =
    beams > 1 ? g_strdup_printf (
      ngettext ("%u other beam ends here.", "%u other beams end here.", beams - 1),
      beams - 1)
              : g_strdup ("");
  g_autofree char *facts =
    node->block != QN_NONE ? g_strdup_printf (_ ("Node %s, on block %s. %s"), node->name,
                                              model->blocks[node->block].name, others)
                           : g_strdup_printf (_ ("Node %s. %s"), node->name, others);
  gtk_label_set_text (form->facts, g_strchomp (facts));
  gtk_widget_set_visible (form->part, beams > 1);
}

static void
update (Form *form)
{
  const QnModel *model = qn_canvas_get_model (form->canvas);
  guint count = 0;
  const QnId *ids =
    qn_selection_get_beams (qn_canvas_get_selection (form->canvas), &count);
  form->beam = count == 1 ? ids[0] : QN_NONE;
  form->node =
    form->beam != QN_NONE ? model->beams[form->beam].nodes[form->end] : QN_NONE;
  gtk_widget_set_visible (form->box, form->node != QN_NONE);
  if (form->node == QN_NONE)
    return;
  const QnNode *node = &model->nodes[form->node];
  gboolean by_block = node->seat == QN_SEAT_CENTROID || node->seat == QN_SEAT_SIDE;
  qn_quantity_entry_set_value (form->x, node->at.x);
  qn_quantity_entry_set_value (form->y, node->at.y);
  gtk_widget_set_sensitive (GTK_WIDGET (form->x), !by_block);
  gtk_widget_set_sensitive (GTK_WIDGET (form->y), !by_block);
  qn_form_set_choice (form->seat, row_of_seat (node), form);
  qn_form_set_row_visible (form->supports, node->block == QN_NONE);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    qn_form_set_check (form->support[dof], node->support[dof], form);
  update_facts (form, model, node);
}

/* ---- building ---- */

static void
build_supports (Form *form, GtkWidget *grid)
{
  static const char *const labels[QN_DOF_COUNT] = { N_ ("x"), N_ ("y"), N_ ("turn") };
  form->supports = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 6);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++) {
    form->support[dof] = gtk_check_button_new_with_label (_ (labels[dof]));
    g_signal_connect (form->support[dof], "toggled", G_CALLBACK (on_support), form);
    gtk_box_append (GTK_BOX (form->supports), form->support[dof]);
  }
  qn_form_add_row (grid, _ ("Fixed"), form->supports);
}

GtkWidget *
qn_beam_end_form_new (QnCanvas *canvas, int end)
{
  const char *const choices[] = { _ ("Stands free"),
                                  _ ("Centre of the block"),
                                  _ ("Point of the block"),
                                  _ ("Left side of the block"),
                                  _ ("Right side of the block"),
                                  _ ("Bottom of the block"),
                                  _ ("Top of the block"),
                                  NULL };
  Form *form = g_new0 (Form, 1);
  *form = (Form){ .canvas = canvas, .end = end, .beam = QN_NONE, .node = QN_NONE };
  GtkWidget *grid = form->box = qn_form_new ();
  form->title =
    GTK_LABEL (qn_form_add_heading (grid, end == 0 ? _ ("First End") : _ ("Second End")));
  form->x = qn_form_add_quantity (grid, "x", QN_QUANTITY_LENGTH, -LARGEST, LARGEST,
                                  G_CALLBACK (on_place), form);
  form->y = qn_form_add_quantity (grid, "y", QN_QUANTITY_LENGTH, -LARGEST, LARGEST,
                                  G_CALLBACK (on_place), form);
  form->seat =
    qn_form_add_choice (grid, _ ("Held at"), choices, G_CALLBACK (on_seat), form);
  build_supports (form, grid);
  form->facts = qn_form_add_text (grid);
  form->part = gtk_button_new_with_mnemonic (_ ("_Part from the Other Beams"));
  g_signal_connect_swapped (form->part, "clicked", G_CALLBACK (on_part), form);
  qn_form_add_wide (grid, form->part);
  qn_form_follow_canvas (grid, canvas, G_CALLBACK (update), form);
  update (form);
  return grid;
}
