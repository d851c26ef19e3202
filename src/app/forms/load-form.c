/* Loads one by one: those that are constant, those that grow, and those of further sets. The selected
 * one is that of the drawing. */
#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include "app/tools/tools.h"
#include "app/widgets/settings.h"
#include "core/model/edge-load.h"
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
  int selected;  /* load of it, or -1: that of the selection */
  int wanted;    /* to be selected once an edit has added it; -1: nothing */
} Form;

/* Of new loads on beams, N/m. */
#define USUAL_LINE_LOAD 1e4

enum {
  LIST,
  NAME,
  ADD_SET,
  REMOVE_SET,
  LOADS,
  EMPTY,
  CHOOSE_EDGE,
  CASE,
  WHERE,
  EDGE,
  EDGE_COUNT,
  PART_FROM,
  PART_TO,
  INTENSITY_FROM,
  INTENSITY_TO,
  NORMAL,
  X,
  Y,
  MOMENT,
  COMPONENT,
  DISTANCE,
  SOIL_SIDE,
  FROM,
  TO,
  PRESSURE,
  UNIT_WEIGHT,
  LEVEL,
  EARTH,
  COEFFICIENT,
  FRICTION_ANGLE,
  ADD_WEIGHT,
  ADD_FORCE,
  ADD_LINE,
  ADD_SETTLEMENT,
  ADD_EDGE,
  ADD_SURCHARGE,
  ADD_BACKFILL,
  DUPLICATE,
  UP,
  DOWN,
  REMOVE
};

#define CHANGE(id)                                                                       \
  {                                                                                      \
    id, N_ ("Change Load"), NULL                                                         \
  }

static const QnFormField fields[] = {
  [LIST] = { .id = "list" },
  [NAME] = { .id = "set_name", .step = N_ ("Rename Set of Loads") },
  [ADD_SET] = { .id = "add_set", .step = N_ ("Add Set of Loads") },
  [REMOVE_SET] = { .id = "remove_set", .step = N_ ("Remove Set of Loads") },
  [LOADS] = { .id = "loads" },
  [EMPTY] = { .id = "empty" },
  [CHOOSE_EDGE] = { .id = "choose_edge" },
  [CASE] = CHANGE ("case"),
  [WHERE] = CHANGE ("where"),
  [EDGE] = CHANGE ("edge"),
  [EDGE_COUNT] = CHANGE ("edge_count"),
  [PART_FROM] = CHANGE ("part_from"),
  [PART_TO] = CHANGE ("part_to"),
  [INTENSITY_FROM] = CHANGE ("intensity_from"),
  [INTENSITY_TO] = CHANGE ("intensity_to"),
  [NORMAL] = CHANGE ("normal"),
  [X] = CHANGE ("x"),
  [Y] = CHANGE ("y"),
  [MOMENT] = CHANGE ("moment"),
  [COMPONENT] = CHANGE ("component"),
  [DISTANCE] = CHANGE ("distance"),
  [SOIL_SIDE] = CHANGE ("soil_side"),
  [FROM] = CHANGE ("from"),
  [TO] = CHANGE ("to"),
  [PRESSURE] = CHANGE ("pressure"),
  [UNIT_WEIGHT] = CHANGE ("unit_weight"),
  [LEVEL] = CHANGE ("level"),
  [EARTH] = CHANGE ("earth"),
  [COEFFICIENT] = CHANGE ("coefficient"),
  [FRICTION_ANGLE] = CHANGE ("friction_angle"),
  [ADD_WEIGHT] = { .id = "add_weight", .step = N_ ("Add Load") },
  [ADD_FORCE] = { .id = "add_force", .step = N_ ("Add Load") },
  [ADD_LINE] = { .id = "add_line", .step = N_ ("Add Load") },
  [ADD_SETTLEMENT] = { .id = "add_settlement", .step = N_ ("Add Load") },
  [ADD_EDGE] = { .id = "add_edge", .step = N_ ("Add Load") },
  [ADD_SURCHARGE] = { .id = "add_surcharge", .step = N_ ("Add Load") },
  [ADD_BACKFILL] = { .id = "add_backfill", .step = N_ ("Add Load") },
  [DUPLICATE] = { .id = "duplicate", .step = N_ ("Duplicate Load") },
  [UP] = { .id = "up", .step = N_ ("Move Load") },
  [DOWN] = { .id = "down", .step = N_ ("Move Load") },
  [REMOVE] = { .id = "remove", .step = N_ ("Remove Load") },
};

static const QnLoad *
selected_load (const Form *form)
{
  return form->selected >= 0 ? qn_model_get_load (qn_canvas_get_model (form->base.canvas),
                                                  form->shown, (gsize) form->selected)
                             : NULL;
}

/* Number in the model of a load of the list; QN_NONE for none. */
static QnId
id_of (const Form *form, int index)
{
  return index >= 0 ? qn_model_get_load_id (qn_canvas_get_model (form->base.canvas),
                                            form->shown, (gsize) index)
                    : QN_NONE;
}

static void
select_load (const Form *form, int index)
{
  qn_selection_set_item (qn_canvas_get_selection (form->base.canvas),
                         form->shown == QN_DEAD_LOADS ? QN_ITEM_DEAD_LOAD
                                                      : QN_ITEM_LIVE_LOAD,
                         id_of (form, index));
}

/* A load that is selected in the drawing is shown in its list. */
static gboolean
look (gpointer data)
{
  Form *form = data;
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  QnSelection *selection = qn_canvas_get_selection (form->base.canvas);
  if (form->shown > (int32_t) model->load_set_count)
    form->shown = 0;
  if (form->wanted >= 0
      && (gsize) form->wanted < qn_model_count_loads (model, form->shown))
    select_load (form, form->wanted);
  const int before = form->selected;
  form->wanted = form->selected = -1;
  for (int live = 0; live < 2; live++) {
    QnId id =
      qn_selection_get_item (selection, live ? QN_ITEM_LIVE_LOAD : QN_ITEM_DEAD_LOAD);
    gsize index, count;
    qn_model_loads (model, live, &count);
    if (id == QN_NONE || (gsize) id >= count)
      continue;
    qn_model_place_load (model, live, id, &form->shown, &index);
    form->selected = (int) index;
    if (form->selected != before)
      qn_bound_form_reveal (form);
  }
  return TRUE;
}

/* ---- what is shown ---- */

static void
add_loads (QnValue *value, const QnModel *model, int32_t list)
{
  const gsize count = qn_model_count_loads (model, list);
  for (gsize i = 0; i < MIN (count, MOST_SHOWN); i++) {
    const QnLoad *load = qn_model_get_load (model, list, i);
    g_autofree char *what = qn_load_dup_text (model, load, qn_settings_get_units ());
    if (load->load_case > 0)
      qn_value_take_row (
        value,
        g_strdup_printf ("%s: %s", model->load_cases[load->load_case - 1].name, what));
    else
      qn_value_take_row (value, g_steal_pointer (&what));
  }
  if (count > MOST_SHOWN)
    qn_value_take_row (value,
                       g_strdup_printf (_ ("and %u more"), (guint) (count - MOST_SHOWN)));
}

/* The numbers of loads on edges; NULL for what a load of its kind does not have. */
static double *
edge_number (QnLoad *load, guint field)
{
  const gboolean edge = load->kind == QN_LOAD_EDGE, soil = load->kind == QN_LOAD_BACKFILL;
  const gboolean fill = soil || load->kind == QN_LOAD_SURCHARGE;
  switch (field) {
  case PART_FROM:
  case PART_TO:
    return edge ? &load->part[field - PART_FROM] : NULL;
  case INTENSITY_FROM:
  case INTENSITY_TO:
    return edge ? &load->intensity[field - INTENSITY_FROM] : NULL;
  case FROM:
  case TO:
    return fill ? &load->span[field - FROM] : NULL;
  case PRESSURE:
    return fill ? &load->pressure : NULL;
  case UNIT_WEIGHT:
    return fill ? &load->unit_weight : NULL;
  case LEVEL:
    return fill && !soil ? &load->level : NULL;
  case COEFFICIENT:
    return soil && load->earth == QN_EARTH_GIVEN ? &load->coefficient : NULL;
  default:
    return soil && load->earth != QN_EARTH_GIVEN ? &load->friction_angle : NULL;
  }
}

static gboolean
show_edge_load (const Form *form, QnLoad load, guint field, QnValue *value)
{
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  const gboolean edge = load.kind == QN_LOAD_EDGE, soil = load.kind == QN_LOAD_BACKFILL;
  switch (field) {
  case CASE:
    qn_value_add_row (value, _ ("none"));
    for (gsize i = 0; i < model->load_case_count; i++)
      qn_value_add_row (value, model->load_cases[i].name);
    value->number = load.load_case;
    return model->load_case_count > 0;
  case WHERE:
    value->number = load.has_side ? load.side : QN_BLOCK_SIDE_COUNT;
    return edge;
  case EDGE:
    value->number = load.edge;
    return edge && !load.has_side;
  case EDGE_COUNT:
    value->number = load.edge_count;
    return edge && !load.has_side;
  case NORMAL:
    value->number = load.normal;
    return edge;
  case SOIL_SIDE:
    value->number = load.side;
    return soil;
  case EARTH:
    value->number = load.earth;
    return soil;
  default: {
    const double *number = edge_number (&load, field);
    value->number = number != NULL ? *number : 0.0;
    return number != NULL;
  }
  }
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
                  load->kind == QN_LOAD_WEIGHT || load->kind == QN_LOAD_EDGE
                    ? QN_QUANTITY_NUMBER
                  : load->kind == QN_LOAD_LINE ? QN_QUANTITY_STIFFNESS
                                               : QN_QUANTITY_FORCE,
                  NULL);
    return load->kind == QN_LOAD_EDGE ? !load->normal
                                      : !settles && !qn_load_is_on_edges (load->kind);
  case MOMENT:
    value->number = load->moment;
    return load->kind == QN_LOAD_FORCE || load->kind == QN_LOAD_NODE;
  case COMPONENT:
    value->number = settles ? (double) load->dof : 0.0;
    return settles;
  default:
    return show_edge_load (form, *load, field, value);
  case DISTANCE:
    value->number = load->value;
    g_object_set (widget, "quantity",
                  load->dof == QN_DOF_RZ ? QN_QUANTITY_ROTATION : QN_QUANTITY_LENGTH,
                  NULL);
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
    qn_value_add_row (value, _ ("Constant"));
    qn_value_add_row (value, _ ("Growing"));
    for (gsize i = 0; i < model->load_set_count; i++)
      qn_value_add_row (value, model->load_sets[i]);
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
    add_loads (value, model, form->shown);
    value->number = form->selected;
    return TRUE;
  case EMPTY:
    value->text =
      g_strdup (_ ("No loads in this list. Add one below, or draw a force or an "
                   "edge load."));
    return qn_model_count_loads (model, form->shown) == 0;
  case CHOOSE_EDGE:
    return selected_load (form) != NULL && selected_load (form)->kind == QN_LOAD_EDGE;
  case UP:
    value->disabled = form->selected <= 0;
    return TRUE;
  case DOWN:
    value->disabled =
      form->selected < 0
      || (gsize) form->selected + 1 >= qn_model_count_loads (model, form->shown);
    return TRUE;
  case DUPLICATE:
  case REMOVE:
    value->disabled = selected_load (form) == NULL;
    return TRUE;
  case ADD_SET:
  case ADD_WEIGHT:
  case ADD_FORCE:
  case ADD_LINE:
  case ADD_SETTLEMENT:
  case ADD_EDGE:
  case ADD_SURCHARGE:
  case ADD_BACKFILL:
    return TRUE;
  default:
    return show_load (form, field, value);
  }
}

/* ---- changes ---- */

/* What a new load acts on: the selected blocks, or the block of the selected load. */
static QnBlockSet
loaded_blocks (const Form *form)
{
  QnBlockSet set = qn_canvas_get_selected (form->base.canvas);
  const QnLoad *load = selected_load (form);
  if (set.count == 0 && load != NULL && load->block != QN_NONE)
    set = (QnBlockSet){ &load->block, 1 };
  return set;
}

/* On the first of the selected blocks, or the second end of the first of the beams. */
static gboolean
make_force (const Form *form, const QnModel *model, QnLoad *load, GError **error)
{
  guint beams = 0;
  QnBlockSet set = loaded_blocks (form);
  const QnId *beam =
    qn_selection_get (qn_canvas_get_selection (form->base.canvas), QN_PART_BEAM, &beams);
  load->vector.y = -qn_canvas_get_tool_settings (form->base.canvas)->force;
  load->kind = set.count > 0 ? QN_LOAD_FORCE : QN_LOAD_NODE;
  if (set.count > 0)
    load->block = set.ids[0];
  else if (beams > 0)
    load->node = model->beams[beam[0]].nodes[1];
  else
    return qn_edit_refuse_nothing (
      error, _ ("Select the block or the beam that the force acts on"));
  return TRUE;
}

/* Down, on the first of the selected beams. */
static gboolean
make_line (const Form *form, QnLoad *load, GError **error)
{
  guint beams = 0;
  const QnId *beam =
    qn_selection_get (qn_canvas_get_selection (form->base.canvas), QN_PART_BEAM, &beams);
  if (beams == 0)
    return qn_edit_refuse_nothing (error, _ ("Select the beam that the load lies on"));
  load->kind = QN_LOAD_LINE;
  load->beam = beam[0];
  load->vector.y = -USUAL_LINE_LOAD;
  return TRUE;
}

/* Down, where the block is fixed so, by a hundredth of the structure's size. */
static gboolean
make_settlement (const Form *form, const QnModel *model, QnLoad *load, GError **error)
{
  QnBlockSet set = loaded_blocks (form);
  int dof = QN_DOF_UY;
  while (set.count > 0 && dof < QN_DOF_UY + QN_DOF_COUNT
         && !model->blocks[set.ids[0]].support[dof % QN_DOF_COUNT])
    dof++;
  if (set.count == 0 || dof == QN_DOF_UY + QN_DOF_COUNT)
    return qn_edit_refuse_nothing (error, _ ("Select the fixed block that settles"));
  load->kind = QN_LOAD_SETTLEMENT;
  load->block = set.ids[0];
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
  if (field >= ADD_EDGE
      && !qn_edit_make_edge_load (model,
                                  (QnLoadKind) (QN_LOAD_EDGE + (int) (field - ADD_EDGE)),
                                  loaded_blocks (form), &load, error))
    return FALSE;
  if ((field == ADD_FORCE && !make_force (form, model, &load, error))
      || (field == ADD_LINE && !make_line (form, &load, error))
      || (field == ADD_SETTLEMENT && !make_settlement (form, model, &load, error))
      || !qn_edit_append_load (model, form->shown, load, error))
    return FALSE;
  form->wanted = (int) qn_model_count_loads (model, form->shown) - 1;
  return TRUE;
}

static gboolean
change (const Form *form, QnModel *model, guint field, const QnValue *value,
        GError **error)
{
  const QnLoad before = *selected_load (form);
  QnLoad load = before;
  double *number = edge_number (&load, field);
  switch (field) {
  case CASE:
    load.load_case = qn_value_int (value);
    break;
  case WHERE:
    load.has_side = value->number < QN_BLOCK_SIDE_COUNT;
    if (load.has_side)
      load.side = (QnBlockSide) qn_value_int (value);
    else
      qn_load_chain (model, &before, &load.edge, &load.edge_count);
    break;
  case EDGE:
    load.edge = qn_value_int (value);
    break;
  case EDGE_COUNT:
    load.edge_count = qn_value_int (value);
    break;
  case NORMAL:
    load.normal = value->number != 0.0;
    if (!load.normal && load.vector.x == 0.0 && load.vector.y == 0.0)
      load.vector = qn_vec2 (0.0, -1.0);
    break;
  case SOIL_SIDE:
    load.side = (QnBlockSide) qn_value_int (value);
    break;
  case EARTH:
    load.coefficient = qn_load_earth_coefficient (&before);
    load.earth = (QnEarth) qn_value_int (value);
    break;
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
  case DISTANCE:
    load.value = value->number;
    break;
  default:
    if (number != NULL)
      *number = value->number;
    break;
  }
  return qn_edit_replace_load (model, form->shown, (gsize) form->selected, load, error);
}

/* What is selected in another list is let go of. */
static void
show_list (Form *form, int32_t list)
{
  if (form->selected >= 0)
    select_load (form, -1);
  form->shown = list;
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  Form *form = data;
  QnModel *model = draft != NULL ? &draft->model : NULL;
  const int selected = form->selected;
  switch (field) {
  case LIST:
    show_list (form, (int32_t) value->number - ROW_LIVE);
    return TRUE;
  case LOADS:
    select_load (form, (int) value->number);
    return TRUE;
  case CHOOSE_EDGE:
    qn_tool_edge_load_choose (form->base.canvas);
    return TRUE;
  case NAME:
    return qn_edit_rename_load_set (model, form->shown, value->text, error);
  case ADD_SET:
    if (!qn_edit_add_load_set (model, error))
      return FALSE;
    show_list (form, (int32_t) model->load_set_count);
    return TRUE;
  case REMOVE_SET:
    return qn_edit_delete_load_set (model, form->shown, error);
  case REMOVE:
    select_load (form, -1); /* an equal one would take its place */
    return qn_edit_remove_load (model, form->shown, (gsize) selected, error);
  case DUPLICATE:
    form->wanted = form->selected + 1;
    return qn_edit_duplicate_load (model, form->shown != QN_DEAD_LOADS,
                                   id_of (form, form->selected), error);
  case UP:
  case DOWN:
    return qn_edit_move_load (model, form->shown != QN_DEAD_LOADS,
                              id_of (form, form->selected), field == UP ? -1 : 1, error);
  case ADD_WEIGHT:
  case ADD_FORCE:
  case ADD_LINE:
  case ADD_SETTLEMENT:
  case ADD_EDGE:
  case ADD_SURCHARGE:
  case ADD_BACKFILL:
    return add (form, model, field, error);
  default:
    return change (form, model, field, value, error);
  }
}

GtkWidget *
qn_load_form_new (QnCanvas *canvas)
{
  static const QnFormKind kind = QN_FORM_KIND ("load-form", Form, QN_FOLLOW_SELECTION);
  Form *form = qn_bound_form_new (&kind, canvas);
  form->shown = QN_DEAD_LOADS;
  form->selected = form->wanted = -1;
  return qn_bound_form_show (form);
}
