/* The selected beams: what they are, what they carry, and their section forces after a run. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "core/base/integer.h"
#include "doc/text/beam-summary.h"
#include <glib/gi18n.h>

#define LARGEST_LOAD 1e12 /* N/m: limit of fields */

typedef struct Form {
  QnCanvas *canvas;
  GtkWidget *box, *name;
  GtkLabel *title, *facts, *forces;
  GtkDropDown *kind, *section;
  GtkWidget *hinges[2];
  QnQuantityEntry *elements;
  QnQuantityEntry *loads[2][2]; /* constant and growing, horizontal and vertical */
} Form;

static QnDocument *
document_of (const Form *form)
{
  return qn_canvas_get_document (form->canvas);
}

/* ---- changes ---- */

typedef enum {
  CHANGE_NAME,
  CHANGE_KIND,
  CHANGE_SECTION,
  CHANGE_HINGE,
  CHANGE_ELEMENTS,
  CHANGE_LOAD
} ChangeKind;

typedef struct Change {
  ChangeKind kind;
  QnBeamSet set;
  const char *name;
  guint choice;
  int end;
  gboolean on;
  double value;
  QnVec2 load;
} Change;

static gboolean
edit_change (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  switch (c->kind) {
  case CHANGE_NAME:
    return qn_edit_rename_beam (model, c->set.ids[0], c->name, error);
  case CHANGE_KIND:
    return qn_edit_set_beam_kind (model, c->set, (QnBeamKind) c->choice, error);
  case CHANGE_SECTION:
    return qn_edit_set_beam_section (model, c->set, (QnId) c->choice, error);
  case CHANGE_HINGE:
    return qn_edit_set_beam_hinge (model, c->set, c->end, c->on, error);
  case CHANGE_ELEMENTS:
    return qn_edit_set_beam_elements (
      model, c->set, (int32_t) qn_to_integer (c->value, 1, G_MAXINT32), error);
  case CHANGE_LOAD:
    return qn_edit_set_line_load (model, c->set, c->on, c->load, error);
  }
  return FALSE;
}

static void update (Form *form);

static void
apply (Form *form, const char *name, Change change)
{
  QnPartSet parts = qn_canvas_dup_parts (form->canvas);
  change.set = parts.beams;
  if (change.set.count > 0
      && !qn_canvas_edit (form->canvas, name, NULL, edit_change, &change))
    update (form);
  qn_part_set_clear (&parts);
}

static void
on_name (GtkEntry *entry, Form *form)
{
  g_autofree char *name = g_strdup (gtk_editable_get_text (GTK_EDITABLE (entry)));
  apply (form, _ ("Rename Beam"), (Change){ .kind = CHANGE_NAME, .name = name });
}

static void
on_kind (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  apply (form, _ ("Change Kind of Beam"),
         (Change){ .kind = CHANGE_KIND, .choice = gtk_drop_down_get_selected (choice) });
}

static void
on_section (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  guint row = gtk_drop_down_get_selected (choice);
  if (row != GTK_INVALID_LIST_POSITION)
    apply (form, _ ("Set Section"), (Change){ .kind = CHANGE_SECTION, .choice = row });
}

static void
on_hinge (GtkCheckButton *button, Form *form)
{
  int end = GTK_WIDGET (button) == form->hinges[1];
  apply (form, _ ("Set Hinge"),
         (Change){ .kind = CHANGE_HINGE,
                   .end = end,
                   .on = gtk_check_button_get_active (button) });
}

static void
on_elements (QnQuantityEntry *entry, Form *form)
{
  apply (
    form, _ ("Cut Beam into Elements"),
    (Change){ .kind = CHANGE_ELEMENTS, .value = qn_quantity_entry_get_value (entry) });
}

static void
on_load (QnQuantityEntry *entry, Form *form)
{
  gboolean live = entry == form->loads[1][0] || entry == form->loads[1][1];
  apply (form, _ ("Set Load along Beam"),
         (Change){ .kind = CHANGE_LOAD,
                   .on = live,
                   .load = { qn_quantity_entry_get_value (form->loads[live][0]),
                             qn_quantity_entry_get_value (form->loads[live][1]) } });
}

/* ---- what is shown ---- */

static void
update_forces (Form *form)
{
  QnDocument *document = document_of (form);
  const QnRun *run = qn_document_get_run (document);
  QnViewState *state = qn_canvas_get_state (form->canvas);
  guint count = 0;
  const QnId *ids =
    qn_selection_get_beams (qn_canvas_get_selection (form->canvas), &count);
  QnBeamSummary summary;
  int step = qn_view_state_get_step (state);
  gboolean there =
    count == 1 && run != NULL && run->result.step_count > 0
    && !qn_document_is_stale (document, run) && (gsize) ids[0] < run->model.beam_count
    && qn_beam_summary_fill (
      &summary, &run->model, &run->result,
      step == QN_STEP_LAST ? run->result.step_count - 1 : (gsize) step, ids[0]);
  gtk_widget_set_visible (GTK_WIDGET (form->forces), there);
  if (!there)
    return;
  g_autofree char *text = qn_beam_summary_dup_text (&summary, qn_settings_get_units ());
  gtk_label_set_text (form->forces, text);
}

static void
update_facts (Form *form, const QnModel *model, QnBeamSet set)
{
  QnUnits units = qn_settings_get_units ();
  double length = 0.0, weight = 0.0;
  for (guint i = 0; i < set.count; i++) {
    double own = qn_model_beam_length (model, set.ids[i]);
    length += own;
    weight +=
      own * qn_section_weight (&model->sections[model->beams[set.ids[i]].section]);
  }
  g_autofree char *l = qn_units_format_full (units, QN_QUANTITY_LENGTH, length, 5);
  g_autofree char *w = qn_units_format_full (units, QN_QUANTITY_FORCE, weight, 4);
  g_autofree char *facts = g_strdup_printf (_ ("Length %s, weight %s"), l, w);
  gtk_label_set_text (form->facts, facts);
}

static void
update_loads (Form *form, const QnModel *model, QnId beam)
{
  for (int live = 0; live < 2; live++) {
    QnVec2 load = qn_model_line_load (model, beam, live);
    qn_quantity_entry_set_value (form->loads[live][0], load.x);
    qn_quantity_entry_set_value (form->loads[live][1], load.y);
  }
}

static void
fill_sections (Form *form, const QnModel *model, QnId section)
{
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  for (gsize i = 0; i < model->section_count; i++)
    g_strv_builder_add (names, model->sections[i].name);
  g_auto (GStrv) strings = g_strv_builder_end (names);
  qn_form_fill_choice (form->section, (const char *const *) strings, (guint) section,
                       form);
}

static void
update (Form *form)
{
  const QnModel *model = qn_document_get_model (document_of (form));
  QnBeamSet set = { 0 };
  set.ids = qn_selection_get_beams (qn_canvas_get_selection (form->canvas), &set.count);
  gtk_widget_set_visible (form->box, set.count > 0);
  if (set.count == 0)
    return;
  const QnBeam *beam = &model->beams[set.ids[0]];
  g_autofree char *title =
    set.count == 1
      ? g_strdup_printf (_ ("Beam %s"), beam->name)
      : g_strdup_printf (ngettext ("%u Beam", "%u Beams", set.count), set.count);
  gtk_label_set_text (form->title, title);
  gtk_editable_set_text (GTK_EDITABLE (form->name), beam->name);
  qn_form_set_row_visible (form->name, set.count == 1);
  qn_form_set_choice (form->kind, beam->kind, form);
  fill_sections (form, model, beam->section);
  for (int end = 0; end < 2; end++) {
    gboolean mixed = FALSE;
    for (guint i = 0; i < set.count; i++)
      mixed = mixed || model->beams[set.ids[i]].hinge[end] != beam->hinge[end];
    qn_form_set_check (form->hinges[end], beam->hinge[end] && !mixed, form);
    gtk_check_button_set_inconsistent (GTK_CHECK_BUTTON (form->hinges[end]), mixed);
  }
  qn_quantity_entry_set_value (form->elements, beam->element_count);
  update_loads (form, model, set.ids[0]);
  update_facts (form, model, set);
  update_forces (form);
}

/* ---- building ---- */

static void
build_loads (Form *form, GtkWidget *grid)
{
  const char *const labels[2][2] = {
    { _ ("Constant, horizontal"), _ ("Constant, vertical") },
    { _ ("Growing, horizontal"), _ ("Growing, vertical") },
  };
  qn_form_add_heading (grid, _ ("Load along the Beam"));
  for (int live = 0; live < 2; live++)
    for (int axis = 0; axis < 2; axis++)
      form->loads[live][axis] =
        qn_form_add_quantity (grid, labels[live][axis], QN_QUANTITY_STIFFNESS,
                              -LARGEST_LOAD, LARGEST_LOAD, G_CALLBACK (on_load), form);
}

static void
build_rows (Form *form, GtkWidget *grid)
{
  const char *const kinds[] = { _ ("Timoshenko"), _ ("Euler–Bernoulli"), NULL };
  const char *const none[] = { NULL };
  form->title = GTK_LABEL (qn_form_add_heading (grid, ""));
  form->name = qn_form_add_entry (grid, _ ("_Name"), 10, G_CALLBACK (on_name), form);
  form->section =
    qn_form_add_choice (grid, _ ("_Section"), none, G_CALLBACK (on_section), form);
  form->kind =
    qn_form_add_choice (grid, _ ("_Theory"), kinds, G_CALLBACK (on_kind), form);
  form->elements =
    qn_form_add_quantity (grid, _ ("_Elements"), QN_QUANTITY_NUMBER, 1.0,
                          QN_MAX_BEAM_ELEMENTS, G_CALLBACK (on_elements), form);
  form->hinges[0] = qn_form_add_check (grid, _ ("Hinge at the _first end"), FALSE,
                                       G_CALLBACK (on_hinge), form);
  form->hinges[1] = qn_form_add_check (grid, _ ("Hinge at the se_cond end"), FALSE,
                                       G_CALLBACK (on_hinge), form);
  form->facts = qn_form_add_text (grid);
  form->forces = qn_form_add_text (grid);
  gtk_widget_add_css_class (GTK_WIDGET (form->forces), "numeric");
  gtk_accessible_update_property (GTK_ACCESSIBLE (form->forces),
                                  GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                  _ ("Section forces at the step that is shown"), -1);
  build_loads (form, grid);
}

GtkWidget *
qn_beam_form_new (QnCanvas *canvas)
{
  Form *form = g_new0 (Form, 1);
  form->canvas = canvas;
  GtkWidget *grid = form->box = qn_form_new ();
  build_rows (form, grid);
  qn_own (grid, form);
  qn_watch (grid, document_of (form), "changed", G_CALLBACK (update), form);
  qn_watch (grid, document_of (form), "runs-changed", G_CALLBACK (update_forces), form);
  qn_watch (grid, qn_canvas_get_state (canvas), "changed", G_CALLBACK (update_forces),
            form);
  qn_watch (grid, qn_canvas_get_selection (canvas), "changed", G_CALLBACK (update), form);
  update (form);
  return grid;
}
