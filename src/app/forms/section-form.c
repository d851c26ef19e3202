/* The section of the selected beams; a change concerns every beam that has it. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnCanvas *canvas;
  GtkWidget *box, *name, *unused;
  GtkLabel *title, *users;
  GtkDropDown *shape;
  QnQuantityEntry *fields[QN_SECTION_FIELD_COUNT];
  QnId section; /* that the form is about, or QN_NONE */
} Form;

static const struct {
  const char *label;
  QnQuantity quantity;
  double least, most;
} rows[QN_SECTION_FIELD_COUNT] = {
  [QN_SECTION_YOUNG] = { N_ ("Young's modulus"), QN_QUANTITY_STRESS, 1e-6, 1e15 },
  [QN_SECTION_SHEAR_MODULUS] = { N_ ("Shear modulus"), QN_QUANTITY_STRESS, 1e-6, 1e15 },
  [QN_SECTION_POISSON] = { N_ ("Poisson's ratio"), QN_QUANTITY_NUMBER, -0.999, 0.5 },
  [QN_SECTION_WIDTH] = { N_ ("Width"), QN_QUANTITY_LENGTH, 1e-6, 1e6 },
  [QN_SECTION_HEIGHT] = { N_ ("Height"), QN_QUANTITY_LENGTH, 1e-6, 1e6 },
  [QN_SECTION_AREA] = { N_ ("Area (m²)"), QN_QUANTITY_NUMBER, 1e-12, 1e12 },
  [QN_SECTION_INERTIA] = { N_ ("Moment of inertia (m⁴)"), QN_QUANTITY_NUMBER, 1e-18,
                           1e12 },
  [QN_SECTION_SHEAR_FACTOR] = { N_ ("Shear factor"), QN_QUANTITY_NUMBER, 1e-6, 1e6 },
  [QN_SECTION_YIELD] = { N_ ("Yield (0: none)"), QN_QUANTITY_STRESS, 0.0, 1e15 },
  [QN_SECTION_PLASTIC_MOMENT] = { N_ ("Plastic moment (0: none)"), QN_QUANTITY_MOMENT,
                                  0.0, 1e15 },
  [QN_SECTION_UNIT_WEIGHT] = { N_ ("Unit weight"), QN_QUANTITY_UNIT_WEIGHT, 0.0, 1e9 },
};

/* ---- changes ---- */

typedef struct Change {
  QnId section;
  QnSectionField field;
  double value;
  gboolean rectangle;
  const char *name;
  QnBeamSet beams;
} Change;

static gboolean
edit_field (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_set_section_field (model, c->section, c->field, c->value, error);
}

static gboolean
edit_shape (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_set_section_shape (model, c->section, c->rectangle, error);
}

static gboolean
edit_name (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_rename_section (model, c->section, c->name, error);
}

/* The selected beams get a section of their own, like the one they have. */
static gboolean
edit_add (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_add_section (model, c->section, error)
         && qn_edit_set_beam_section (model, c->beams, (QnId) model->section_count - 1,
                                      error);
}

static gboolean
edit_remove_unused (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  qn_edit_remove_unused_sections (model);
  return TRUE;
}

static void update (Form *form);

static void
apply (Form *form, const char *name, QnEditFunc func, Change change)
{
  QnPartSet parts = qn_canvas_dup_parts (form->canvas);
  change.section = form->section;
  change.beams = parts.beams;
  if (form->section == QN_NONE
      || !qn_canvas_edit (form->canvas, name, NULL, func, &change))
    update (form);
  qn_part_set_clear (&parts);
}

static void
on_field (QnQuantityEntry *entry, Form *form)
{
  for (int field = 0; field < QN_SECTION_FIELD_COUNT; field++) {
    if (form->fields[field] != entry)
      continue;
    g_autofree char *name = g_strdup_printf (_ ("Change %s"), _ (rows[field].label));
    apply (form, name, edit_field,
           (Change){ .field = (QnSectionField) field,
                     .value = qn_quantity_entry_get_value (entry) });
    return;
  }
}

static void
on_shape (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  apply (form, _ ("Change Section"), edit_shape,
         (Change){ .rectangle = gtk_drop_down_get_selected (choice) == 0 });
}

static void
on_name (GtkEntry *entry, Form *form)
{
  g_autofree char *name = g_strdup (gtk_editable_get_text (GTK_EDITABLE (entry)));
  apply (form, _ ("Rename Section"), edit_name, (Change){ .name = name });
}

static void
on_add (Form *form)
{
  apply (form, _ ("Add Section"), edit_add, (Change){ 0 });
}

static void
on_remove_unused (Form *form)
{
  apply (form, _ ("Remove Unused Sections"), edit_remove_unused, (Change){ 0 });
}

/* ---- what is shown ---- */

static QnId
selected_section (Form *form)
{
  guint count = 0;
  const QnId *ids =
    qn_selection_get_beams (qn_canvas_get_selection (form->canvas), &count);
  return count > 0 ? qn_canvas_get_model (form->canvas)->beams[ids[0]].section : QN_NONE;
}

static void
update_users (Form *form, const QnModel *model)
{
  guint users = 0;
  g_autofree gboolean *used = g_new0 (gboolean, model->section_count + 1);
  gboolean unused = FALSE;
  for (gsize i = 0; i < model->beam_count; i++) {
    used[model->beams[i].section] = TRUE;
    users += model->beams[i].section == form->section;
  }
  for (gsize i = 0; i < model->section_count; i++)
    unused = unused || !used[i];
  g_autofree char *text =
    g_strdup_printf (ngettext ("Of %u beam", "Of %u beams", users), users);
  gtk_label_set_text (form->users, text);
  gtk_widget_set_visible (form->unused, unused);
}

static void
update (Form *form)
{
  const QnModel *model = qn_canvas_get_model (form->canvas);
  form->section = selected_section (form);
  gtk_widget_set_visible (form->box, form->section != QN_NONE);
  if (form->section == QN_NONE)
    return;
  const QnSection *section = &model->sections[form->section];
  g_autofree char *title = g_strdup_printf (_ ("Section %s"), section->name);
  gtk_label_set_text (form->title, title);
  gtk_editable_set_text (GTK_EDITABLE (form->name), section->name);
  qn_form_set_choice (form->shape, section->height > 0.0 ? 0 : 1, form);
  for (int field = 0; field < QN_SECTION_FIELD_COUNT; field++) {
    gboolean has = qn_section_has_field (section, (QnSectionField) field);
    qn_form_set_row_visible (GTK_WIDGET (form->fields[field]), has);
    if (has)
      qn_quantity_entry_set_value (
        form->fields[field], qn_section_get_field (section, (QnSectionField) field));
  }
  update_users (form, model);
}

static void
build_buttons (Form *form, GtkWidget *grid)
{
  GtkWidget *add = gtk_button_new_with_mnemonic (_ ("_Section of Their Own"));
  gtk_widget_set_tooltip_text (
    add, _ ("Gives the selected beams a new section that starts like this one"));
  g_signal_connect_swapped (add, "clicked", G_CALLBACK (on_add), form);
  qn_form_add_wide (grid, add);
  form->unused = gtk_button_new_with_mnemonic (_ ("_Remove Unused Sections"));
  g_signal_connect_swapped (form->unused, "clicked", G_CALLBACK (on_remove_unused), form);
  qn_form_add_wide (grid, form->unused);
}

GtkWidget *
qn_section_form_new (QnCanvas *canvas)
{
  const char *const shapes[] = { _ ("Rectangle"), _ ("Area and inertia"), NULL };
  Form *form = g_new0 (Form, 1);
  form->canvas = canvas;
  form->section = QN_NONE;
  GtkWidget *grid = form->box = qn_form_new ();
  form->title = GTK_LABEL (qn_form_add_heading (grid, ""));
  form->users = qn_form_add_text (grid);
  gtk_widget_add_css_class (GTK_WIDGET (form->users), "dim-label");
  form->name = qn_form_add_entry (grid, _ ("_Name"), 10, G_CALLBACK (on_name), form);
  form->shape =
    qn_form_add_choice (grid, _ ("S_hape"), shapes, G_CALLBACK (on_shape), form);
  for (int field = 0; field < QN_SECTION_FIELD_COUNT; field++)
    form->fields[field] = qn_form_add_quantity (
      grid, _ (rows[field].label), rows[field].quantity, rows[field].least,
      rows[field].most, G_CALLBACK (on_field), form);
  build_buttons (form, grid);
  qn_form_follow_canvas (grid, canvas, G_CALLBACK (update), form);
  update (form);
  return grid;
}
