#include "app/form.h"
#include "app/panel.h"
#include <glib/gi18n.h>

enum { KN, KS, FRICTION, COHESION, TENSION, DILATANCY, FIELD_COUNT };

typedef struct Form {
  QnCanvas *canvas;
  GtkDropDown *law, *kind, *basis;
  QnQuantityEntry *fields[QN_BASIS_COUNT][FIELD_COUNT];
  QnId shown; /* law that the fields are about */
} Form;

static const struct {
  const char *label;
  double least;
  /* kn, cohesion … are per pair, per area or moduli according to the basis */
  QnQuantity quantity[QN_BASIS_COUNT];
} fields[FIELD_COUNT] = {
  [KN] = { N_ ("Normal stiffness"),
           1e-12,
           { QN_QUANTITY_STIFFNESS, QN_QUANTITY_SURFACE_STIFFNESS, QN_QUANTITY_STRESS } },
  [KS] = { N_ ("Shear stiffness"),
           1e-12,
           { QN_QUANTITY_STIFFNESS, QN_QUANTITY_SURFACE_STIFFNESS, QN_QUANTITY_STRESS } },
  [FRICTION] = { N_ ("Friction, tangent"),
                 0.0,
                 { QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER } },
  [COHESION] = { N_ ("Cohesion"),
                 0.0,
                 { QN_QUANTITY_FORCE, QN_QUANTITY_STRESS, QN_QUANTITY_STRESS } },
  [TENSION] = { N_ ("Tensile strength"),
                0.0,
                { QN_QUANTITY_FORCE, QN_QUANTITY_STRESS, QN_QUANTITY_STRESS } },
  [DILATANCY] = { N_ ("Dilatancy, tangent"),
                  0.0,
                  { QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER } },
};

static double *
field_of (QnLaw *law, int field)
{
  switch (field) {
  case KN:
    return &law->kn;
  case KS:
    return &law->ks;
  case FRICTION:
    return &law->friction;
  case COHESION:
    return &law->cohesion;
  case TENSION:
    return &law->tension;
  default:
    return &law->dilatancy;
  }
}

static const QnModel *
model_of (const Form *form)
{
  return qn_document_get_model (qn_canvas_get_document (form->canvas));
}

static gboolean
edit_law (QnModel *model, gpointer data, GError **error)
{
  (void) error;
  Form *form = data;
  QnLaw *law = &model->laws[form->shown];
  for (int i = 0; i < FIELD_COUNT; i++)
    *field_of (law, i) = qn_quantity_entry_get_value (form->fields[law->basis][i]);
  law->kind = (QnLawKind) gtk_drop_down_get_selected (form->kind);
  law->basis = (QnBasis) gtk_drop_down_get_selected (form->basis);
  return TRUE;
}

static void update (Form *form);

static void
apply (Form *form)
{
  if (form->shown == QN_NONE)
    return;
  if (!qn_canvas_edit (form->canvas, _ ("Change Law"), NULL, edit_law, form))
    update (form);
}

static void
on_quantity (QnQuantityEntry *entry, Form *form)
{
  (void) entry;
  apply (form);
}

static void
on_choice (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) choice;
  (void) pspec;
  apply (form);
}

static void
on_law (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  form->shown = (QnId) gtk_drop_down_get_selected (choice);
  update (form);
}

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
    form->shown = (QnId) model_of (form)->law_count - 1;
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

static void
fill_laws (Form *form, const QnModel *model)
{
  g_autoptr (GtkStringList) names = gtk_string_list_new (NULL);
  for (gsize i = 0; i < model->law_count; i++)
    gtk_string_list_append (names, model->laws[i].name);
  g_signal_handlers_block_matched (form->law, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL,
                                   form);
  gtk_drop_down_set_model (form->law, G_LIST_MODEL (names));
  gtk_drop_down_set_selected (form->law, (guint) form->shown);
  g_signal_handlers_unblock_matched (form->law, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL,
                                     form);
}

static void
update (Form *form)
{
  const QnModel *model = model_of (form);
  if (form->shown < 0 || (gsize) form->shown >= model->law_count)
    form->shown = model->law_count > 0 ? 0 : QN_NONE;
  fill_laws (form, model);
  if (form->shown == QN_NONE)
    return;
  QnLaw *law = &model->laws[form->shown];
  qn_form_set_choice (form->kind, law->kind, form);
  qn_form_set_choice (form->basis, law->basis, form);
  for (int basis = 0; basis < QN_BASIS_COUNT; basis++) {
    for (int i = 0; i < FIELD_COUNT; i++) {
      gboolean visible =
        basis == (int) law->basis && (i <= KS || law->kind == QN_LAW_COULOMB);
      qn_quantity_entry_set_value (form->fields[basis][i], *field_of (law, i));
      qn_form_set_row_visible (GTK_WIDGET (form->fields[basis][i]), visible);
    }
  }
}

static void
build_fields (Form *form, GtkWidget *grid)
{
  for (int i = 0; i < FIELD_COUNT; i++) {
    for (int basis = 0; basis < QN_BASIS_COUNT; basis++)
      form->fields[basis][i] =
        qn_form_add_quantity (grid, _ (fields[i].label), fields[i].quantity[basis],
                              fields[i].least, 1e18, G_CALLBACK (on_quantity), form);
  }
}

GtkWidget *
qn_law_form_new (QnCanvas *canvas)
{
  const char *const none[] = { NULL };
  const char *const kinds[] = { _ ("Elastic"), _ ("No tension"), _ ("Coulomb"), NULL };
  const char *const bases[] = { _ ("Contact pair"), _ ("Surface"), _ ("Material"), NULL };
  Form *form = g_new0 (Form, 1);
  form->canvas = canvas;
  GtkWidget *grid = qn_form_new ();
  qn_form_add_heading (grid, _ ("Laws"));
  form->law = qn_form_add_choice (grid, _ ("La_w"), none, G_CALLBACK (on_law), form);
  form->kind =
    qn_form_add_choice (grid, _ ("_Kind"), kinds, G_CALLBACK (on_choice), form);
  form->basis =
    qn_form_add_choice (grid, _ ("_Basis"), bases, G_CALLBACK (on_choice), form);
  build_fields (form, grid);

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
