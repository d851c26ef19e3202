/* Loads one by one: those that are constant, those that grow, and those of further sets. */
#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit-stage.h"
#include "doc/view/load-text.h"
#include <glib/gi18n.h>

/* Lines of a list; of more loads the rest is only counted. */
#define MOST_SHOWN 200

/* Rows of the choice of list before the sets. */
enum { ROW_DEAD, ROW_LIVE };

typedef struct Form {
  QnBoundForm base;
  int32_t shown; /* list */
  int selected;  /* load of it, or -1 */
} Form;

enum {
  LIST,
  NAME,
  ADD_SET,
  REMOVE_SET,
  LOADS,
  X,
  Y,
  MOMENT,
  COMPONENT,
  DISTANCE,
  ADD_WEIGHT,
  ADD_FORCE,
  ADD_SETTLEMENT,
  REMOVE
};

static const QnFormField fields[] = {
  [LIST] = { .id = "list" },
  [NAME] = { .id = "name", .step = N_ ("Rename Set of Loads") },
  [ADD_SET] = { .id = "add_set", .step = N_ ("Add Set of Loads") },
  [REMOVE_SET] = { .id = "remove_set", .step = N_ ("Remove Set of Loads") },
  [LOADS] = { .id = "loads" },
  [X] = { .id = "x", .step = N_ ("Change Load") },
  [Y] = { .id = "y", .step = N_ ("Change Load") },
  [MOMENT] = { .id = "moment", .step = N_ ("Change Load") },
  [COMPONENT] = { .id = "component", .step = N_ ("Change Load") },
  [DISTANCE] = { .id = "distance", .step = N_ ("Change Load") },
  [ADD_WEIGHT] = { .id = "add_weight", .step = N_ ("Add Load") },
  [ADD_FORCE] = { .id = "add_force", .step = N_ ("Add Load") },
  [ADD_SETTLEMENT] = { .id = "add_settlement", .step = N_ ("Add Load") },
  [REMOVE] = { .id = "remove", .step = N_ ("Remove Load") },
};

static const QnLoad *
selected_load (const Form *form)
{
  return form->selected >= 0 ? qn_model_get_load (qn_canvas_get_model (form->base.canvas),
                                                  form->shown, (gsize) form->selected)
                             : NULL;
}

static gboolean
look (gpointer data)
{
  Form *form = data;
  if (form->shown > (int32_t) qn_canvas_get_model (form->base.canvas)->load_set_count)
    form->shown = 0;
  if (selected_load (form) == NULL)
    form->selected = -1;
  return TRUE;
}

/* ---- what is shown ---- */

static char **
dup_lists (const QnModel *model)
{
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  g_strv_builder_add (names, _ ("Constant"));
  g_strv_builder_add (names, _ ("Growing"));
  for (gsize i = 0; i < model->load_set_count; i++)
    g_strv_builder_add (names, model->load_sets[i]);
  return g_strv_builder_end (names);
}

static char **
dup_loads (const QnModel *model, int32_t list)
{
  g_autoptr (GStrvBuilder) lines = g_strv_builder_new ();
  gsize count = qn_model_count_loads (model, list);
  for (gsize i = 0; i < MIN (count, MOST_SHOWN); i++) {
    g_autofree char *line = qn_load_dup_text (model, qn_model_get_load (model, list, i),
                                              qn_settings_get_units ());
    g_strv_builder_add (lines, line);
  }
  if (count > MOST_SHOWN) {
    g_autofree char *rest =
      g_strdup_printf (_ ("and %u more"), (guint) (count - MOST_SHOWN));
    g_strv_builder_add (lines, rest);
  }
  return g_strv_builder_end (lines);
}

static gboolean
show_load (const Form *form, guint field, QnValue *value)
{
  const QnLoad *load = selected_load (form);
  GtkWidget *widget = form->base.widgets[field];
  gboolean settles = load != NULL && load->kind == QN_LOAD_SETTLEMENT;
  if (load == NULL)
    return FALSE;
  switch (field) {
  case X:
  case Y:
    value->number = field == X ? load->vector.x : load->vector.y;
    g_object_set (widget, "quantity",
                  load->kind == QN_LOAD_WEIGHT ? QN_QUANTITY_NUMBER
                  : load->kind == QN_LOAD_LINE ? QN_QUANTITY_STIFFNESS
                                               : QN_QUANTITY_FORCE,
                  NULL);
    return !settles;
  case MOMENT:
    value->number = load->moment;
    return load->kind == QN_LOAD_FORCE || load->kind == QN_LOAD_NODE;
  case COMPONENT:
    value->number = settles ? (double) load->dof : 0.0;
    return settles;
  default:
    value->number = load->value;
    g_object_set (widget, "quantity",
                  load->dof == QN_DOF_RZ ? QN_QUANTITY_ANGLE : QN_QUANTITY_LENGTH, NULL);
    return settles;
  }
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  const Form *form = data;
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  switch (field) {
  case LIST:
    value->rows = dup_lists (model);
    value->number = form->shown + ROW_LIVE;
    return TRUE;
  case NAME:
    if (form->shown > 0)
      value->text = g_strdup (model->load_sets[form->shown - 1]);
    return form->shown > 0;
  case REMOVE_SET:
    value->disabled = form->shown <= 0;
    return TRUE;
  case LOADS:
    value->rows = dup_loads (model, form->shown);
    value->number = form->selected;
    return TRUE;
  case REMOVE:
    value->disabled = selected_load (form) == NULL;
    return TRUE;
  case ADD_SET:
  case ADD_WEIGHT:
  case ADD_FORCE:
  case ADD_SETTLEMENT:
    return TRUE;
  default:
    return show_load (form, field, value);
  }
}

/* ---- changes ---- */

/* On the first of the selected blocks, or the second end of the first of the beams. */
static gboolean
make_force (const Form *form, const QnModel *model, QnLoad *load, GError **error)
{
  guint blocks = 0, beams = 0;
  QnSelection *selection = qn_canvas_get_selection (form->base.canvas);
  const QnId *ids = qn_selection_get_blocks (selection, &blocks);
  const QnId *beam = qn_selection_get_beams (selection, &beams);
  load->vector.y = -qn_canvas_get_tool_settings (form->base.canvas)->force;
  load->kind = blocks > 0 ? QN_LOAD_FORCE : QN_LOAD_NODE;
  if (blocks > 0)
    load->block = ids[0];
  else if (beams > 0)
    load->node = model->beams[beam[0]].nodes[1];
  else {
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING,
                         _ ("Select the block or the beam that the force acts on"));
    return FALSE;
  }
  return TRUE;
}

/* Down, where the block is fixed so, by a hundredth of the structure's size. */
static gboolean
make_settlement (const Form *form, const QnModel *model, QnLoad *load, GError **error)
{
  guint count = 0;
  const QnId *ids =
    qn_selection_get_blocks (qn_canvas_get_selection (form->base.canvas), &count);
  int dof = QN_DOF_UY;
  while (count > 0 && dof < QN_DOF_UY + QN_DOF_COUNT
         && !model->blocks[ids[0]].support[dof % QN_DOF_COUNT])
    dof++;
  if (count == 0 || dof == QN_DOF_UY + QN_DOF_COUNT) {
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING,
                         _ ("Select the fixed block that settles"));
    return FALSE;
  }
  load->kind = QN_LOAD_SETTLEMENT;
  load->block = ids[0];
  load->dof = (QnDof) (dof % QN_DOF_COUNT);
  load->value = -qn_magnet_round_distance (0.01 * model->characteristic_length);
  return TRUE;
}

static gboolean
add (Form *form, QnModel *model, guint field, GError **error)
{
  gboolean dead = form->shown == QN_DEAD_LOADS;
  QnLoad load = { .kind = QN_LOAD_WEIGHT,
                  .vector = { dead ? 0.0 : 1.0, dead ? -1.0 : 0.0 },
                  .block = QN_NONE,
                  .node = QN_NONE,
                  .beam = QN_NONE };
  if (field != ADD_WEIGHT)
    load.vector = qn_vec2 (0.0, 0.0);
  if ((field == ADD_FORCE && !make_force (form, model, &load, error))
      || (field == ADD_SETTLEMENT && !make_settlement (form, model, &load, error))
      || !qn_edit_append_load (model, form->shown, load, error))
    return FALSE;
  form->selected = (int) qn_model_count_loads (model, form->shown) - 1;
  return TRUE;
}

static gboolean
change (const Form *form, QnModel *model, guint field, const QnValue *value,
        GError **error)
{
  QnLoad load = *selected_load (form);
  switch (field) {
  case X:
    load.vector.x = value->number;
    break;
  case Y:
    load.vector.y = value->number;
    break;
  case MOMENT:
    load.moment = value->number;
    break;
  case COMPONENT:
    load.dof = (QnDof) value->number;
    break;
  default:
    load.value = value->number;
    break;
  }
  return qn_edit_replace_load (model, form->shown, (gsize) form->selected, load, error);
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  Form *form = data;
  QnModel *model = draft != NULL ? &draft->model : NULL;
  switch (field) {
  case LIST:
    form->shown = (int32_t) value->number - ROW_LIVE;
    form->selected = -1;
    return TRUE;
  case LOADS:
    form->selected = (int) value->number;
    return TRUE;
  case NAME:
    return qn_edit_rename_load_set (model, form->shown, value->text, error);
  case ADD_SET:
    if (!qn_edit_add_load_set (model, error))
      return FALSE;
    form->shown = (int32_t) model->load_set_count;
    form->selected = -1;
    return TRUE;
  case REMOVE_SET:
    return qn_edit_delete_load_set (model, form->shown, error);
  case REMOVE:
    return qn_edit_remove_load (model, form->shown, (gsize) form->selected, error);
  case ADD_WEIGHT:
  case ADD_FORCE:
  case ADD_SETTLEMENT:
    return add (form, model, field, error);
  default:
    return change (form, model, field, value, error);
  }
}

GtkWidget *
qn_load_form_new (QnCanvas *canvas)
{
  static const QnFormKind kind = QN_FORM_KIND ("load-form", Form, 0);
  Form *form = qn_bound_form_new (&kind, canvas);
  form->shown = QN_DEAD_LOADS;
  form->selected = -1;
  return qn_bound_form_show (form);
}
