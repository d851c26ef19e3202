/* The laws: kind, basis, the numbers that the kind has, and how the law answers. */
#include "app/forms/form.h"
#include "app/forms/law-view.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "doc/text/law-points.h"
#include "doc/text/law-preset.h"
#include <glib/gi18n.h>
#include <stdlib.h>
#include <string.h>

#define LARGEST 1e18

/* What the number of a parameter is: it depends on the basis. */
typedef enum { IS_STIFFNESS, IS_NUMBER, IS_STRENGTH, IS_STRAIN, IS_ENERGY } Meaning;

static const QnQuantity quantities[][QN_BASIS_COUNT] = {
  [IS_STIFFNESS] = { QN_QUANTITY_STIFFNESS, QN_QUANTITY_SURFACE_STIFFNESS,
                     QN_QUANTITY_STRESS },
  [IS_NUMBER] = { QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER },
  [IS_STRENGTH] = { QN_QUANTITY_FORCE, QN_QUANTITY_STRESS, QN_QUANTITY_STRESS },
  [IS_STRAIN] = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH, QN_QUANTITY_NUMBER },
  [IS_ENERGY] = { QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER },
};

/* Numbers by the keys of project files; the first three belong to every law. */
static const struct {
  const char *key, *label;
  Meaning meaning;
} fields[] = {
  { "kn", N_ ("Normal stiffness"), IS_STIFFNESS },
  { "ks", N_ ("Shear stiffness"), IS_STIFFNESS },
  { "shear_factor", N_ ("Shear factor (0: 1)"), IS_NUMBER },
  { "friction", N_ ("Friction, tangent"), IS_NUMBER },
  { "cohesion", N_ ("Cohesion"), IS_STRENGTH },
  { "tension", N_ ("Tensile strength"), IS_STRENGTH },
  { "compression", N_ ("Compressive strength"), IS_STRENGTH },
  { "dilatancy", N_ ("Dilatancy, tangent"), IS_NUMBER },
  { "yield", N_ ("Yield"), IS_STRENGTH },
  { "hardening", N_ ("Hardening, part of stiffness"), IS_NUMBER },
  { "strength", N_ ("Strength"), IS_STRENGTH },
  { "ultimate_strain", N_ ("Ultimate strain"), IS_STRAIN },
  { "fracture_energy", N_ ("Fracture energy, J/m² (pair: J)"), IS_ENERGY },
  { "crushing_energy", N_ ("Crushing energy, J/m² (pair: J)"), IS_ENERGY },
};
enum { FIELD_COUNT = G_N_ELEMENTS (fields) };

typedef struct Form {
  QnCanvas *canvas;
  GtkDropDown *law, *kind, *basis;
  GtkWidget *name, *points, *view;
  QnQuantityEntry *entries[QN_BASIS_COUNT][FIELD_COUNT];
  QnId shown; /* law that the fields are about */
} Form;

/* The number of a law, or NULL where its kind has none of this key. */
static double *
number_of (QnLaw *law, int field)
{
  if (field == 0)
    return &law->kn;
  if (field == 1)
    return &law->ks;
  if (field == 2)
    return &law->shear_factor;
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
  for (size_t i = 0; i < count; i++) {
    if (strcmp (parameters[i].key, fields[field].key) == 0)
      return qn_law_at (law, &parameters[i]);
  }
  return NULL;
}

/* ---- changes ---- */

typedef struct Change {
  QnId law;
  int field; /* or -1 */
  double value;
  gboolean choices;
  QnLawKind kind;
  QnBasis basis;
  const char *name;
  const QnVec2 *points;
  int32_t point_count;
} Change;

static gboolean
edit_law (QnModel *model, gpointer data, GError **error)
{
  const Change *change = data;
  QnLaw *law = &model->laws[change->law];
  if (change->field >= 0)
    *number_of (law, change->field) = change->value;
  if (change->choices && change->kind != law->kind)
    qn_law_change_kind (law, change->kind);
  else if (change->choices)
    law->basis = change->basis;
  if (change->name != NULL) {
    char *name = strdup (change->name);
    if (name == NULL)
      return qn_edit_no_memory (error);
    free (law->name);
    law->name = name;
  }
  for (int32_t i = 0; i < change->point_count; i++)
    law->points[i] = change->points[i];
  if (change->point_count > 0)
    law->point_count = change->point_count;
  return TRUE;
}

static void update (Form *form);

static void
apply (Form *form, const char *name, Change change)
{
  change.law = form->shown;
  if (form->shown == QN_NONE
      || !qn_canvas_edit (form->canvas, name, NULL, edit_law, &change))
    update (form);
}

static void
on_number (QnQuantityEntry *entry, Form *form)
{
  for (int field = 0; field < FIELD_COUNT; field++) {
    for (int basis = 0; basis < QN_BASIS_COUNT; basis++) {
      if (form->entries[basis][field] == entry)
        apply (form, _ ("Change Law"),
               (Change){ .field = field, .value = qn_quantity_entry_get_value (entry) });
    }
  }
}

static void
on_choice (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) choice;
  (void) pspec;
  apply (form, _ ("Change Law"),
         (Change){ .field = -1,
                   .choices = TRUE,
                   .kind = (QnLawKind) gtk_drop_down_get_selected (form->kind),
                   .basis = (QnBasis) gtk_drop_down_get_selected (form->basis) });
}

static void
on_name (GtkEntry *entry, Form *form)
{
  g_autofree char *name = g_strdup (gtk_editable_get_text (GTK_EDITABLE (entry)));
  apply (form, _ ("Rename Law"), (Change){ .field = -1, .name = name });
}

static void
on_points (GtkEntry *entry, Form *form)
{
  QnVec2 points[QN_MAX_CURVE_POINTS];
  int32_t count;
  if (!qn_law_points_parse (gtk_editable_get_text (GTK_EDITABLE (entry)), points,
                            &count)) {
    gtk_widget_add_css_class (form->points, "error");
    return;
  }
  gtk_widget_remove_css_class (form->points, "error");
  apply (form, _ ("Change Law"),
         (Change){ .field = -1, .points = points, .point_count = count });
}

static void
on_law (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  form->shown = (QnId) gtk_drop_down_get_selected (choice);
  update (form);
}

/* ---- adding and removing ---- */

static gboolean
edit_add (QnModel *model, gpointer data, GError **error)
{
  const Form *form = data;
  for (guint number = (guint) model->law_count + 1;; number++) {
    g_autofree char *name = g_strdup_printf (_ ("law %u"), number);
    if (qn_model_find_law (model, name) == QN_NONE)
      return qn_edit_add_law (model, form->shown, name, error);
  }
}

static void
on_add (Form *form)
{
  if (form->shown == QN_NONE)
    return;
  if (qn_canvas_edit (form->canvas, _ ("Add Law"), NULL, edit_add, form)) {
    form->shown = (QnId) qn_canvas_get_model (form->canvas)->law_count - 1;
    update (form);
  }
}

static gboolean
edit_remove (QnModel *model, gpointer data, GError **error)
{
  const Form *form = data;
  return qn_edit_delete_law (model, form->shown, error);
}

static void
on_remove (Form *form)
{
  if (form->shown != QN_NONE)
    qn_canvas_edit (form->canvas, _ ("Remove Law"), NULL, edit_remove, form);
}

/* ---- what is shown ---- */

static void
fill_laws (Form *form, const QnModel *model)
{
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  for (gsize i = 0; i < model->law_count; i++)
    g_strv_builder_add (names, model->laws[i].name);
  g_auto (GStrv) strings = g_strv_builder_end (names);
  qn_form_fill_choice (form->law, (const char *const *) strings, (guint) form->shown,
                       form);
}

static void
update_points (Form *form, const QnLaw *law)
{
  qn_form_set_row_visible (form->points, law->kind == QN_LAW_CURVE);
  g_autofree char *text = qn_law_points_dup_text (law->points, law->point_count);
  gtk_editable_set_text (GTK_EDITABLE (form->points), text);
  gtk_widget_remove_css_class (form->points, "error");
}

static void
update (Form *form)
{
  const QnModel *model = qn_canvas_get_model (form->canvas);
  if (form->shown < 0 || (gsize) form->shown >= model->law_count)
    form->shown = model->law_count > 0 ? 0 : QN_NONE;
  fill_laws (form, model);
  if (form->shown == QN_NONE)
    return;
  QnLaw law = model->laws[form->shown];
  gtk_editable_set_text (GTK_EDITABLE (form->name), law.name);
  qn_form_set_choice (form->kind, law.kind, form);
  qn_form_set_choice (form->basis, law.basis, form);
  for (int basis = 0; basis < QN_BASIS_COUNT; basis++) {
    for (int field = 0; field < FIELD_COUNT; field++) {
      const double *number = number_of (&law, field);
      QnQuantityEntry *entry = form->entries[basis][field];
      if (number != NULL)
        qn_quantity_entry_set_value (entry, *number);
      qn_form_set_row_visible (GTK_WIDGET (entry),
                               basis == (int) law.basis && number != NULL);
    }
  }
  update_points (form, &law);
  qn_law_view_set_law (form->view, &law);
}

/* ---- construction ---- */

static void
build_fields (Form *form, GtkWidget *grid)
{
  for (int field = 0; field < FIELD_COUNT; field++) {
    for (int basis = 0; basis < QN_BASIS_COUNT; basis++)
      form->entries[basis][field] = qn_form_add_quantity (
        grid, _ (fields[field].label), quantities[fields[field].meaning][basis],
        fields[field].meaning == IS_STIFFNESS ? 1e-12 : 0.0, LARGEST,
        G_CALLBACK (on_number), form);
  }
  form->points = qn_form_add_entry (grid, _ ("Points"), 12, G_CALLBACK (on_points), form);
  gtk_widget_set_tooltip_text (
    form->points, _ ("Elongation and force, or strain and stress, in SI units, a space "
                     "between the two and semicolons between points, from compression "
                     "to tension"));
}

static void
build_choices (Form *form, GtkWidget *grid)
{
  const char *const none[] = { NULL };
  const char *const kinds[] = { [QN_LAW_ELASTIC] = _ ("Elastic"),
                                [QN_LAW_NO_TENSION] = _ ("No tension"),
                                [QN_LAW_COULOMB] = _ ("Coulomb"),
                                [QN_LAW_MOHR_COULOMB] = _ ("Coulomb, crushing"),
                                [QN_LAW_BILINEAR] = _ ("Bilinear, hardening"),
                                [QN_LAW_ELASTIC_PLASTIC] = _ ("Elastic and plastic"),
                                [QN_LAW_CONCRETE] = _ ("Concrete"),
                                [QN_LAW_STEEL] = _ ("Steel"),
                                [QN_LAW_CURVE] = _ ("By points"),
                                [QN_LAW_KIND_COUNT] = NULL };
  const char *const bases[] = { _ ("Contact pair"), _ ("Surface"), _ ("Material"), NULL };
  form->law = qn_form_add_choice (grid, _ ("La_w"), none, G_CALLBACK (on_law), form);
  form->name = qn_form_add_entry (grid, _ ("Na_me"), 10, G_CALLBACK (on_name), form);
  form->kind =
    qn_form_add_choice (grid, _ ("_Kind"), kinds, G_CALLBACK (on_choice), form);
  form->basis =
    qn_form_add_choice (grid, _ ("_Basis"), bases, G_CALLBACK (on_choice), form);
}

GtkWidget *
qn_law_form_new (QnCanvas *canvas)
{
  Form *form = g_new0 (Form, 1);
  form->canvas = canvas;
  GtkWidget *grid = qn_form_new ();
  qn_form_add_heading (grid, _ ("Laws"));
  build_choices (form, grid);
  build_fields (form, grid);
  form->view = qn_law_view_new ();
  qn_form_add_wide (grid, form->view);

  GtkWidget *buttons = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 6);
  GtkWidget *add = gtk_button_new_with_mnemonic (_ ("_Add Law"));
  GtkWidget *remove = gtk_button_new_with_mnemonic (_ ("Remo_ve Law"));
  g_signal_connect_swapped (add, "clicked", G_CALLBACK (on_add), form);
  g_signal_connect_swapped (remove, "clicked", G_CALLBACK (on_remove), form);
  gtk_box_append (GTK_BOX (buttons), add);
  gtk_box_append (GTK_BOX (buttons), remove);
  qn_form_add_wide (grid, buttons);

  qn_own (grid, form);
  qn_watch (grid, qn_canvas_get_document (canvas), "changed", G_CALLBACK (update), form);
  update (form);
  return grid;
}
