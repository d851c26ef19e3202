/* The selected blocks: what they are made of, and how they are held. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include <glib/gi18n.h>

#define LARGEST 1e6 /* m: limit of fields */

typedef struct Form {
  QnCanvas *canvas;
  GtkWidget *box, *name, *join;
  GtkLabel *title, *facts;
  QnQuantityEntry *thickness, *weight;
  GtkDropDown *law;
  GtkWidget *support[QN_DOF_COUNT];
} Form;

typedef enum {
  CHANGE_THICKNESS,
  CHANGE_WEIGHT,
  CHANGE_LAW,
  CHANGE_SUPPORT,
  CHANGE_NAME
} ChangeKind;

typedef struct Change {
  ChangeKind kind;
  QnBlockSet set;
  double value;
  QnId law;
  bool support[QN_DOF_COUNT];
  const char *name;
} Change;

static gboolean
edit_change (QnModel *model, gpointer data, GError **error)
{
  const Change *change = data;
  switch (change->kind) {
  case CHANGE_THICKNESS:
    return qn_edit_set_thickness (model, change->set, change->value, error);
  case CHANGE_WEIGHT:
    return qn_edit_set_unit_weight (model, change->set, change->value, error);
  case CHANGE_LAW:
    return qn_edit_set_law (model, change->set, change->law, error);
  case CHANGE_SUPPORT:
    return qn_edit_set_support (model, change->set, change->support, error);
  case CHANGE_NAME:
    return qn_edit_rename_block (model, change->set.ids[0], change->name, error);
  }
  return FALSE;
}

static void update (Form *form);

static void
apply (Form *form, const char *name, Change change)
{
  change.set = qn_canvas_dup_selected (form->canvas);
  if (change.set.count > 0
      && !qn_canvas_edit (form->canvas, name, NULL, edit_change, &change))
    update (form);
  g_free ((gpointer) change.set.ids);
}

static void
on_thickness (QnQuantityEntry *entry, Form *form)
{
  double value = qn_quantity_entry_get_value (entry);
  apply (form, _ ("Set Thickness"), (Change){ .kind = CHANGE_THICKNESS, .value = value });
}

static void
on_weight (QnQuantityEntry *entry, Form *form)
{
  double value = qn_quantity_entry_get_value (entry);
  apply (form, _ ("Set Unit Weight"), (Change){ .kind = CHANGE_WEIGHT, .value = value });
}

static void
on_law (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  apply (form, _ ("Set Law"),
         (Change){ .kind = CHANGE_LAW, .law = qn_form_get_law (choice) });
}

static void
on_support (GtkCheckButton *button, Form *form)
{
  (void) button;
  Change change = { .kind = CHANGE_SUPPORT };
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    change.support[dof] =
      gtk_check_button_get_active (GTK_CHECK_BUTTON (form->support[dof]));
  apply (form, _ ("Set Support"), change);
}

static void
on_name (GtkEntry *entry, Form *form)
{
  g_autofree char *name = g_strdup (gtk_editable_get_text (GTK_EDITABLE (entry)));
  apply (form, _ ("Rename Block"), (Change){ .kind = CHANGE_NAME, .name = name });
}

static void
build_supports (Form *form, GtkWidget *grid)
{
  static const char *const labels[QN_DOF_COUNT] = { N_ ("x"), N_ ("y"), N_ ("turn") };
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 6);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++) {
    form->support[dof] = gtk_check_button_new_with_label (_ (labels[dof]));
    g_signal_connect (form->support[dof], "toggled", G_CALLBACK (on_support), form);
    gtk_box_append (GTK_BOX (box), form->support[dof]);
  }
  qn_form_add_row (grid, _ ("Fixed"), box);
}

/* ---- what is shown ---- */

static void
update_facts (Form *form, QnBlockSet set)
{
  const QnModel *model = qn_canvas_get_model (form->canvas);
  const QnBlock *block = &model->blocks[set.ids[0]];
  QnUnits units = qn_settings_get_units ();
  double weight = 0.0;
  for (guint i = 0; i < set.count; i++)
    weight += model->blocks[set.ids[i]].weight;
  g_autofree char *force = qn_units_format_full (units, QN_QUANTITY_FORCE, weight, 4);
  g_autofree char *x = qn_units_format (units, QN_QUANTITY_LENGTH, block->centroid.x, 5);
  g_autofree char *y =
    qn_units_format_full (units, QN_QUANTITY_LENGTH, block->centroid.y, 5);
  g_autofree char *facts =
    set.count == 1 ? g_strdup_printf (_ ("Weight %s, centroid at %s; %s"), force, x, y)
                   : g_strdup_printf (_ ("Weight %s in all"), force);
  gtk_label_set_text (form->facts, facts);
}

static void
update (Form *form)
{
  const QnModel *model = qn_canvas_get_model (form->canvas);
  QnBlockSet set = { 0 };
  set.ids = qn_selection_get_blocks (qn_canvas_get_selection (form->canvas), &set.count);
  gtk_widget_set_visible (form->box, set.count > 0);
  if (set.count == 0)
    return;
  const QnBlock *block = &model->blocks[set.ids[0]];
  g_autofree char *title =
    set.count == 1
      ? g_strdup_printf (_ ("Block %s"), block->name)
      : g_strdup_printf (ngettext ("%u Block", "%u Blocks", set.count), set.count);
  gboolean alone = block->wall == QN_NONE && block->masonry == QN_NONE;
  gboolean masonry = TRUE;
  for (guint i = 0; i < set.count; i++)
    masonry = masonry && model->blocks[set.ids[i]].masonry != QN_NONE;
  gtk_label_set_text (form->title, title);
  gtk_editable_set_text (GTK_EDITABLE (form->name), block->name);
  qn_form_set_row_visible (form->name, set.count == 1 && alone);
  gtk_widget_set_visible (form->join, set.count > 1);
  qn_quantity_entry_set_value (form->thickness, block->thickness);
  qn_quantity_entry_set_value (form->weight, block->unit_weight);
  qn_form_fill_laws (form->law, model, _ ("As all contacts"), block->law, form);
  /* What masonry is made of is told by its own form. */
  qn_form_set_row_visible (GTK_WIDGET (form->thickness), !masonry);
  qn_form_set_row_visible (GTK_WIDGET (form->weight), !masonry);
  qn_form_set_row_visible (GTK_WIDGET (form->law), !masonry);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++) {
    gboolean mixed = FALSE;
    for (guint i = 0; i < set.count; i++)
      mixed = mixed || model->blocks[set.ids[i]].support[dof] != block->support[dof];
    qn_form_set_check (form->support[dof], block->support[dof] && !mixed, form);
    gtk_check_button_set_inconsistent (GTK_CHECK_BUTTON (form->support[dof]), mixed);
  }
  update_facts (form, set);
}

GtkWidget *
qn_block_form_new (QnCanvas *canvas)
{
  const char *const none[] = { NULL };
  Form *form = g_new0 (Form, 1);
  form->canvas = canvas;
  GtkWidget *grid = form->box = qn_form_new ();
  form->title = GTK_LABEL (qn_form_add_heading (grid, ""));
  form->name = qn_form_add_entry (grid, _ ("_Name"), 10, G_CALLBACK (on_name), form);
  form->thickness = qn_form_add_quantity (grid, _ ("_Thickness"), QN_QUANTITY_LENGTH,
                                          1e-6, LARGEST, G_CALLBACK (on_thickness), form);
  form->weight = qn_form_add_quantity (grid, _ ("Unit _weight"), QN_QUANTITY_UNIT_WEIGHT,
                                       0.0, 1e9, G_CALLBACK (on_weight), form);
  form->law = qn_form_add_choice (grid, _ ("_Law"), none, G_CALLBACK (on_law), form);
  build_supports (form, grid);
  form->facts = qn_form_add_text (grid);
  form->join = gtk_button_new_with_mnemonic (_ ("_Join into One Block"));
  gtk_actionable_set_action_name (GTK_ACTIONABLE (form->join), "win.join");
  qn_form_add_wide (grid, form->join);
  qn_form_follow_canvas (grid, canvas, G_CALLBACK (update), form);
  update (form);
  return grid;
}
