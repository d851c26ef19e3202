/* The selected contact faces: their blocks, law and pairs, and the forces after a run. */
#include "app/forms/form.h"
#include "app/forms/joint-view.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "core/base/integer.h"
#include "doc/edit/edit-face.h"
#include "doc/text/count-text.h"
#include "doc/text/explain.h"
#include "doc/view/pair-text.h"
#include <glib/gi18n.h>
#include <math.h>
#include <stdlib.h>

#define LARGEST 1e6 /* m: limit of fields */

/* Pairs that are told in words; a joint with more has the diagram. */
#define MOST_TOLD_PAIRS 6

/* Rows of the list of placements: as all contacts, then those of QnPlacement. */
enum { ROW_AS_ALL };

typedef struct Form {
  QnCanvas *canvas;
  GtkWidget *box, *view, *reset, *positions;
  GtkLabel *title, *facts, *states;
  GtkDropDown *law, *placement;
  QnQuantityEntry *offset, *count;
} Form;

static QnDocument *
document_of (const Form *form)
{
  return qn_canvas_get_document (form->canvas);
}

/* ---- changes ---- */

typedef struct Change {
  GArray *faces; /* of QnContactFace */
  gboolean law_only;
  QnId law;
  const QnPairRule *rule;
} Change;

static gboolean
edit_faces (QnModel *model, gpointer data, GError **error)
{
  const Change *change = data;
  QnFaceSet set = { (const QnContactFace *) change->faces->data, change->faces->len };
  return change->law_only ? qn_edit_set_face_law (model, set, change->law, error)
                          : qn_edit_set_face_pairs (model, set, change->rule, error);
}

static gboolean
edit_reset (QnModel *model, gpointer data, GError **error)
{
  const Change *change = data;
  QnFaceSet set = { (const QnContactFace *) change->faces->data, change->faces->len };
  return qn_edit_set_face_law (model, set, QN_NONE, error)
         && qn_edit_set_face_pairs (model, set, NULL, error);
}

static void update (Form *form);

static void
apply (Form *form, const char *name, QnEditFunc func, Change change)
{
  const QnContacts *contacts = qn_document_get_contacts (document_of (form));
  guint count = 0;
  const QnId *ids =
    qn_selection_get_faces (qn_canvas_get_selection (form->canvas), &count);
  g_autoptr (GArray) faces = g_array_new (FALSE, FALSE, sizeof (QnContactFace));
  for (guint i = 0; i < count; i++) {
    if ((gsize) ids[i] < contacts->face_count)
      g_array_append_val (faces, contacts->faces[ids[i]]);
  }
  change.faces = faces;
  if (faces->len > 0 && !qn_canvas_edit (form->canvas, name, NULL, func, &change))
    update (form);
}

static void
on_law (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  apply (form, _ ("Set Law of Joints"), edit_faces,
         (Change){ .law_only = TRUE, .law = qn_form_get_law (choice) });
}

static void
change_pairs (Form *form)
{
  guint row = gtk_drop_down_get_selected (form->placement);
  QnPairRule rule = { 0 };
  if (row > ROW_AS_ALL) {
    rule.placement = (QnPlacement) (row - 1);
    rule.offset = rule.placement == QN_PLACEMENT_ENDS
                    ? qn_quantity_entry_get_value (form->offset)
                    : 0.0;
    rule.count =
      (int32_t) qn_to_integer (qn_quantity_entry_get_value (form->count), 1, G_MAXINT32);
  }
  if (row > ROW_AS_ALL && rule.placement == QN_PLACEMENT_EXPLICIT) {
    const char *positions = gtk_editable_get_text (GTK_EDITABLE (form->positions));
    if (!qn_pair_rule_parse (&rule, positions, "", NULL)) {
      gtk_widget_add_css_class (form->positions, "error");
      return;
    }
  }
  gtk_widget_remove_css_class (form->positions, "error");
  apply (form, _ ("Place Pairs"), edit_faces,
         (Change){ .rule = row > ROW_AS_ALL ? &rule : NULL });
}

static void
on_placement (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) choice;
  (void) pspec;
  change_pairs (form);
}

static void
on_quantity (QnQuantityEntry *entry, Form *form)
{
  (void) entry;
  change_pairs (form);
}

static void
on_positions (GtkEntry *entry, Form *form)
{
  (void) entry;
  change_pairs (form);
}

static void
on_reset (Form *form)
{
  apply (form, _ ("Forget Exceptions"), edit_reset, (Change){ 0 });
}

/* ---- what is shown ---- */

/* The run whose contacts are those on the screen, or NULL. */
static const QnRun *
current_run (Form *form)
{
  const QnRun *run = qn_document_get_run (document_of (form));
  return run != NULL && run->result.pairs != NULL
             && !qn_document_is_stale (document_of (form), run)
           ? run
           : NULL;
}

static char *
dup_states (const QnJointPlot *plot)
{
  QnUnits units = qn_settings_get_units ();
  GString *text = g_string_new (NULL);
  guint counts[QN_PAIR_STATE_COUNT] = { 0 };
  gboolean told = plot->count <= MOST_TOLD_PAIRS;
  for (gsize i = 0; i < plot->count; i++) {
    const QnJointPoint *point = &plot->points[i];
    counts[point->state]++;
    if (!told)
      continue;
    g_autofree char *n =
      qn_units_format_full (units, QN_QUANTITY_FORCE, point->normal, 4);
    g_autofree char *t = qn_units_format_full (units, QN_QUANTITY_FORCE, point->shear, 4);
    g_string_append_printf (text, _ ("%s%s %d: %s, N %s, T %s"), i > 0 ? "\n" : "",
                            _ ("Pair"), (int) i + 1, qn_explain_pair_state (point->state),
                            n, t);
  }
  for (int state = 0; state < QN_PAIR_STATE_COUNT && !told; state++)
    g_string_append_printf (text, _ ("%s%s: %u"), state > 0 ? ", " : "",
                            qn_explain_pair_state ((QnPairState) state), counts[state]);
  return g_string_free (text, FALSE);
}

static void
update_forces (Form *form, QnId id)
{
  const QnRun *run = id != QN_NONE ? current_run (form) : NULL;
  QnJointPlot plot = { 0 };
  gboolean there = run != NULL && (gsize) id < run->contacts.face_count
                   && qn_joint_plot_fill (
                     &plot, &run->model, &run->contacts, &run->result,
                     qn_view_state_get_step (qn_canvas_get_state (form->canvas)), id);
  gtk_widget_set_visible (form->view, there);
  gtk_widget_set_visible (GTK_WIDGET (form->states), there);
  if (!there)
    return;
  g_autofree char *states = dup_states (&plot);
  qn_joint_view_set_plot (form->view, &plot);
  gtk_label_set_text (form->states, states);
}

static void
update_facts (Form *form, const QnId *ids, guint count)
{
  const QnModel *model = qn_document_get_model (document_of (form));
  const QnContacts *contacts = qn_document_get_contacts (document_of (form));
  const QnContactFace *face = &contacts->faces[ids[0]];
  double length = 0.0;
  int pairs = 0;
  for (guint i = 0; i < count; i++) {
    length += contacts->faces[ids[i]].length;
    pairs += contacts->faces[ids[i]].pair_count;
  }
  g_autofree char *size =
    qn_units_format_full (qn_settings_get_units (), QN_QUANTITY_LENGTH, length, 5);
  g_autofree char *title =
    count == 1
      ? g_strdup_printf (_ ("Contact Face %d"), ids[0])
      : g_strdup_printf (ngettext ("%u Contact Face", "%u Contact Faces", count), count);
  const QnCount of_pairs = { QN_COUNTED_PAIRS, (gsize) pairs };
  g_autofree char *contents = qn_counts_dup_text (&of_pairs, 1, "");
  const char *a = model->blocks[face->a].name, *b = model->blocks[face->b].name;
  const char *law_a = model->laws[face->law_a].name;
  const char *law_b = model->laws[face->law_b].name;
  g_autofree char *facts =
    count > 1 ? g_strdup_printf (_ ("%s long in all, %s"), size, contents)
    : face->law_a == face->law_b
      ? g_strdup_printf (_ ("%s – %s, %s long, %s; law “%s”"), a, b, size, contents,
                         law_a)
      : g_strdup_printf (_ ("%s – %s, %s long, %s; laws “%s” and “%s”"), a, b, size,
                         contents, law_a, law_b);
  gtk_label_set_text (form->title, title);
  gtk_label_set_text (form->facts, facts);
}

static void
update_positions (Form *form, const QnPairRule *rule)
{
  if (rule->placement != QN_PLACEMENT_EXPLICIT)
    return;
  g_autofree char *text = qn_pair_rule_dup_positions (rule);
  gtk_editable_set_text (GTK_EDITABLE (form->positions), text);
}

static void
update_exception (Form *form, const QnContactFace *face)
{
  const QnModel *model = qn_document_get_model (document_of (form));
  const QnFaceOverride *override = qn_model_find_override (model, face);
  gboolean own = override != NULL && override->has_pairs;
  const QnPairRule *rule = own ? &override->pairs : &model->contact.pairs;
  guint row = own ? (guint) rule->placement + 1 : ROW_AS_ALL;
  qn_form_fill_laws (form->law, model, _ ("As its blocks"),
                     override != NULL ? override->law : QN_NONE, form);
  qn_form_set_choice (form->placement, row, form);
  qn_quantity_entry_set_value (form->offset, rule->offset);
  qn_quantity_entry_set_value (form->count, MAX (rule->count, 2));
  update_positions (form, rule);
  qn_form_set_row_visible (GTK_WIDGET (form->offset),
                           own && rule->placement == QN_PLACEMENT_ENDS);
  qn_form_set_row_visible (GTK_WIDGET (form->count),
                           own
                             && (rule->placement == QN_PLACEMENT_UNIFORM
                                 || rule->placement == QN_PLACEMENT_GAUSS));
  qn_form_set_row_visible (form->positions,
                           own && rule->placement == QN_PLACEMENT_EXPLICIT);
  gtk_widget_set_visible (form->reset, override != NULL);
}

static void
update (Form *form)
{
  const QnContacts *contacts = qn_document_get_contacts (document_of (form));
  guint count = 0;
  const QnId *ids =
    qn_selection_get_faces (qn_canvas_get_selection (form->canvas), &count);
  gboolean valid = count > 0;
  for (guint i = 0; i < count; i++)
    valid = valid && (gsize) ids[i] < contacts->face_count;
  gtk_widget_set_visible (form->box, valid);
  if (!valid)
    return;
  update_facts (form, ids, count);
  update_exception (form, &contacts->faces[ids[0]]);
  update_forces (form, count == 1 ? ids[0] : QN_NONE);
}

/* Another step of the run is looked at: only the forces are others. */
static void
update_step (Form *form)
{
  guint count = 0;
  const QnId *ids =
    qn_selection_get_faces (qn_canvas_get_selection (form->canvas), &count);
  if (count == 1)
    update_forces (form, ids[0]);
}

/* ---- construction ---- */

static void
add_likeness_buttons (GtkWidget *grid)
{
  static const struct {
    const char *label, *action;
  } buttons[] = { { N_ ("_Line"), "win.select-faces-like::line" },
                  { N_ ("D_irection"), "win.select-faces-like::direction" },
                  { N_ ("La_w"), "win.select-faces-like::law" } };
  static const char *const hints[] = { N_ ("Select all joints on this line"),
                                       N_ ("Select all joints in this direction"),
                                       N_ ("Select all joints of the same laws") };
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 0);
  gtk_widget_add_css_class (box, "linked");
  for (gsize i = 0; i < G_N_ELEMENTS (buttons); i++) {
    GtkWidget *button = gtk_button_new_with_mnemonic (_ (buttons[i].label));
    gtk_actionable_set_detailed_action_name (GTK_ACTIONABLE (button), buttons[i].action);
    gtk_widget_set_tooltip_text (button, _ (hints[i]));
    gtk_box_append (GTK_BOX (box), button);
  }
  qn_form_add_row (grid, _ ("Select same"), box);
}

GtkWidget *
qn_face_form_new (QnCanvas *canvas)
{
  const char *const none[] = { NULL };
  const char *const placements[] = { _ ("As all contacts"), _ ("At the ends"),
                                     _ ("Uniform"),         _ ("Gauss"),
                                     _ ("One by one"),      NULL };
  Form *form = g_new0 (Form, 1);
  form->canvas = canvas;
  GtkWidget *grid = form->box = qn_form_new ();
  form->title = GTK_LABEL (qn_form_add_heading (grid, ""));
  form->facts = qn_form_add_text (grid);
  add_likeness_buttons (grid);
  form->law = qn_form_add_choice (grid, _ ("_Law"), none, G_CALLBACK (on_law), form);
  form->placement =
    qn_form_add_choice (grid, _ ("_Pairs"), placements, G_CALLBACK (on_placement), form);
  form->offset = qn_form_add_quantity (grid, _ ("_Offset"), QN_QUANTITY_LENGTH, 0.0,
                                       LARGEST, G_CALLBACK (on_quantity), form);
  form->count = qn_form_add_quantity (grid, _ ("_Number"), QN_QUANTITY_NUMBER, 1.0,
                                      1000.0, G_CALLBACK (on_quantity), form);
  form->positions =
    qn_form_add_entry (grid, _ ("_At"), 10, G_CALLBACK (on_positions), form);
  gtk_widget_set_tooltip_text (form->positions,
                               _ ("Parts of the length of the joint from 0 to 1, with "
                                  "semicolons between"));
  form->reset = gtk_button_new_with_mnemonic (_ ("_Forget Exception"));
  g_signal_connect_swapped (form->reset, "clicked", G_CALLBACK (on_reset), form);
  qn_form_add_wide (grid, form->reset);
  form->view = qn_joint_view_new ();
  qn_form_add_wide (grid, form->view);
  form->states = qn_form_add_text (grid);
  qn_own (grid, form);
  qn_watch (grid, document_of (form), "changed", G_CALLBACK (update), form);
  qn_watch (grid, document_of (form), "runs-changed", G_CALLBACK (update), form);
  qn_watch (grid, qn_canvas_get_state (canvas), "changed", G_CALLBACK (update_step),
            form);
  qn_watch (grid, qn_canvas_get_selection (canvas), "changed", G_CALLBACK (update), form);
  update (form);
  return grid;
}
