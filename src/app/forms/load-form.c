/* Loads one by one: those that are constant, those that grow, and those of further sets; settlements in a
 * form of their own. The selected one is that of the drawing: its number is that in the model. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/tools/tools.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit-stage.h"
#include "doc/view/load-text.h"
#include "doc/view/pair-text.h"
#include "io/project/project-vehicle.h"
#include <glib/gi18n.h>

/* Lines of a list; of more loads the rest is only counted. */
#define MOST_SHOWN 200

/* The list of dead loads; 0 is that of live loads, those behind it are of the sets. */
#define DEAD_LOADS (-1)

typedef struct Form {
  QnForm base;
  int32_t shown;    /* list */
  gboolean settles; /* about settlements, not about the other loads */
} Form;

/* Of new loads on beams, N/m. */
#define USUAL_LINE_LOAD 1e4

#define CHANGE N_ ("Change Load")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (LIST, "list", NULL)                                                             \
  FIELD (NAME, "set_name", N_ ("Rename Set of Loads"))                                   \
  FIELD (ADD_SET, "add_set", N_ ("Add Set of Loads"))                                    \
  FIELD (REMOVE_SET, "remove_set", N_ ("Remove Set of Loads"))                           \
  FIELD (LOADS, "loads", NULL)                                                           \
  FIELD (EMPTY, "empty", NULL)                                                           \
  FIELD (ADD, "add", NULL)                                                               \
  FIELD (CHOOSE_EDGE, "choose_edge", NULL)                                               \
  MEMBER (CASE, "case", CHANGE, QnLoad, load_case)                                       \
  FIELD (WHERE, "where", CHANGE)                                                         \
  MEMBER (EDGE, "edge", CHANGE, QnLoad, edge)                                            \
  MEMBER (EDGE_COUNT, "edge_count", CHANGE, QnLoad, edge_count)                          \
  MEMBER (PART_FROM, "part_from", CHANGE, QnLoad, part[0])                               \
  MEMBER (PART_TO, "part_to", CHANGE, QnLoad, part[1])                                   \
  MEMBER (INTENSITY_FROM, "intensity_from", CHANGE, QnLoad, intensity[0])                \
  MEMBER (INTENSITY_TO, "intensity_to", CHANGE, QnLoad, intensity[1])                    \
  MEMBER (NORMAL, "normal", CHANGE, QnLoad, normal)                                      \
  MEMBER (X, "x", CHANGE, QnLoad, vector.x)                                              \
  MEMBER (Y, "y", CHANGE, QnLoad, vector.y)                                              \
  MEMBER (MOMENT, "moment", CHANGE, QnLoad, moment)                                      \
  MEMBER (COMPONENT, "component", CHANGE, QnLoad, dof)                                   \
  MEMBER (DISTANCE, "distance", CHANGE, QnLoad, value)                                   \
  MEMBER (SOIL_SIDE, "soil_side", CHANGE, QnLoad, side)                                  \
  MEMBER (FROM, "from", CHANGE, QnLoad, span[0])                                         \
  MEMBER (TO, "to", CHANGE, QnLoad, span[1])                                             \
  MEMBER (PRESSURE, "pressure", CHANGE, QnLoad, pressure)                                \
  MEMBER (UNIT_WEIGHT, "unit_weight", CHANGE, QnLoad, unit_weight)                       \
  MEMBER (LEVEL, "level", CHANGE, QnLoad, level)                                         \
  FIELD (EARTH, "earth", CHANGE)                                                         \
  MEMBER (COEFFICIENT, "coefficient", CHANGE, QnLoad, coefficient)                       \
  MEMBER (FRICTION_ANGLE, "friction_angle", CHANGE, QnLoad, friction_angle)              \
  FIELD (SURFACE, "surface", CHANGE)                                                     \
  MEMBER (MOBILISATION, "mobilisation", CHANGE, QnLoad, mobilisation)                    \
  MEMBER (SOIL_STIFFNESS, "soil_stiffness", CHANGE, QnLoad, stiffness)                   \
  FIELD (VEHICLE, "vehicle", CHANGE)                                                     \
  MEMBER (POSITION, "position", CHANGE, QnLoad, position)                                \
  MEMBER (REVERSED, "reversed", CHANGE, QnLoad, reversed)                                \
  MEMBER (CONVOY, "convoy", CHANGE, QnLoad, convoy)                                      \
  MEMBER (HEADWAY, "headway", CHANGE, QnLoad, headway)                                   \
  MEMBER (DISPERSAL, "dispersal", CHANGE, QnLoad, dispersal)                             \
  MEMBER (WIDTH, "width", CHANGE, QnLoad, width)                                         \
  MEMBER (EFFECTIVE, "effective_width", CHANGE, QnLoad, effective)                       \
  FIELD (ADD_WEIGHT, "add_weight", CHANGE)                                               \
  FIELD (ADD_FORCE, "add_force", CHANGE)                                                 \
  FIELD (ADD_LINE, "add_line", CHANGE)                                                   \
  FIELD (ADD_SETTLEMENT, "add_settlement", CHANGE)                                       \
  FIELD (ADD_EDGE, "add_edge", CHANGE)                                                   \
  FIELD (ADD_SURCHARGE, "add_surcharge", CHANGE)                                         \
  FIELD (ADD_BACKFILL, "add_backfill", CHANGE)                                           \
  FIELD (ADD_FILL, "add_fill", CHANGE)                                                   \
  FIELD (ADD_VEHICLE, "add_vehicle", CHANGE)                                             \
  FIELD (DUPLICATE, "duplicate", N_ ("Duplicate Load"))                                  \
  FIELD (UP, "up", N_ ("Move Load"))                                                     \
  FIELD (DOWN, "down", N_ ("Move Load"))                                                 \
  FIELD (REMOVE, "remove", N_ ("Remove Load"))
QN_FORM_FIELDS;

static QnPickKind
kind_of (const Form *form)
{
  return QN_PICK_LOAD (form->shown != DEAD_LOADS);
}

static const QnLoad *
selected_load (const Form *form)
{
  return form->base.selected >= 0
           ? &qn_model_loads (qn_canvas_get_model (form->base.canvas),
                              form->shown != DEAD_LOADS, NULL)[form->base.selected]
           : NULL;
}

static void
select_load (const Form *form, QnId load)
{
  qn_selection_set_one (form->base.canvas->selection, kind_of (form), load);
}

/* Whether the list has a load. */
static gboolean
shows (const Form *form, const QnLoad *load)
{
  return (form->shown == DEAD_LOADS || load->set == form->shown)
         && (load->kind == QN_LOAD_SETTLEMENT) == form->settles;
}

/* The row of a load, or how many rows the loads before it have; the load of a row, or QN_NONE. */
static int
row_of (const Form *form, QnId load)
{
  const QnLoad *loads = qn_model_loads (qn_canvas_get_model (form->base.canvas),
                                        form->shown != DEAD_LOADS, NULL);
  int row = 0;
  for (QnId i = 0; i < load; i++)
    row += shows (form, &loads[i]);
  return row;
}

static QnId
load_of (const Form *form, int row)
{
  const QnModel *model = qn_canvas_get_model (form->base.canvas);
  gsize count;
  const QnLoad *loads = qn_model_loads (model, form->shown != DEAD_LOADS, &count);
  for (QnId i = 0; row >= 0 && i < (QnId) count; i++)
    if (shows (form, &loads[i]) && row-- == 0)
      return i;
  return QN_NONE;
}

/* A load that is selected in the drawing is shown in its list. */
static gboolean
look (QnForm *data, const QnModel *model)
{
  Form *form = (Form *) data;
  if (form->shown > (int32_t) model->load_set_count)
    form->shown = 0;
  if (form->base.wanted >= 0
      && (gsize) form->base.wanted < qn_model_count_items (model, kind_of (form)))
    select_load (form, form->base.wanted);
  const int before = form->base.selected;
  form->base.wanted = form->base.selected = -1;
  for (int live = 0; live < 2; live++) {
    QnId id = qn_selection_get_one (form->base.canvas->selection, QN_PICK_LOAD (live));
    gsize count;
    const QnLoad *loads = qn_model_loads (model, live, &count);
    if (id == QN_NONE || (gsize) id >= count
        || (loads[id].kind == QN_LOAD_SETTLEMENT) != form->settles)
      continue;
    form->shown = live ? loads[id].set : DEAD_LOADS;
    form->base.selected = id;
    if (id != before)
      qn_form_reveal (form);
  }
  return TRUE;
}

/* ---- what is shown ---- */

static void
add_loads (const Form *form, QnValue *value, const QnModel *model)
{
  static const char *const icons[QN_LOAD_KIND_COUNT] = {
    [QN_LOAD_WEIGHT] = "quoin-rectangle-symbolic",
    [QN_LOAD_FORCE] = "quoin-force-symbolic",
    [QN_LOAD_NODE] = "quoin-force-symbolic",
    [QN_LOAD_LINE] = "quoin-edge-load-symbolic",
    [QN_LOAD_SETTLEMENT] = "quoin-support-symbolic",
    [QN_LOAD_EDGE] = "quoin-edge-load-symbolic",
    [QN_LOAD_SURCHARGE] = "quoin-edge-load-symbolic",
    [QN_LOAD_BACKFILL] = "quoin-displace-symbolic",
    [QN_LOAD_FILL] = "quoin-arch-symbolic",
    [QN_LOAD_VEHICLE] = "quoin-beam-symbolic",
  };
  gsize count;
  const QnLoad *loads = qn_model_loads (model, form->shown != DEAD_LOADS, &count);
  const int rows = row_of (form, (QnId) count);
  int row = 0;
  for (const QnLoad *load = loads; row < MIN (rows, MOST_SHOWN); load++) {
    if (!shows (form, load))
      continue;
    row++;
    g_autofree char *what = qn_load_dup_text (model, load, qn_settings_get_units ());
    if (load->load_case > 0)
      qn_value_take_row (
        value,
        g_strdup_printf ("%s: %s", model->load_cases[load->load_case - 1].name, what));
    else
      qn_value_take_row (value, g_steal_pointer (&what));
    qn_value_set_icon (value, icons[load->kind]);
  }
  if (rows > MOST_SHOWN) {
    qn_value_take_row (value,
                       g_strdup_printf (_ ("and %u more"), (guint) (rows - MOST_SHOWN)));
    qn_value_set_icon (value, NULL);
  }
}

static gpointer
subject (QnForm *data, QnModel *model, guint field)
{
  const Form *form = (const Form *) data;
  return form->base.selected >= 0
           ? &qn_model_loads (model, form->shown != DEAD_LOADS, NULL)[form->base.selected]
           : NULL;
}

#define KIND(kind) (1u << QN_LOAD_##kind)

/* Which loads have a number, and those behind it up to the next one here. */
static const struct {
  guint field, kinds;
} numbers[] = {
  { WHERE, KIND (EDGE) },
  { X, KIND (WEIGHT) | KIND (FORCE) | KIND (NODE) | KIND (LINE) | KIND (EDGE) },
  { MOMENT, KIND (FORCE) | KIND (NODE) },
  { COMPONENT, KIND (SETTLEMENT) },
  { SOIL_SIDE, KIND (BACKFILL) },
  { FROM, KIND (SURCHARGE) | KIND (BACKFILL) },
  { UNIT_WEIGHT, KIND (SURCHARGE) | KIND (BACKFILL) | KIND (FILL) },
  { LEVEL, KIND (SURCHARGE) },
  { EARTH, KIND (BACKFILL) },
  { FRICTION_ANGLE, KIND (BACKFILL) | KIND (FILL) },
  { SURFACE, KIND (FILL) },
  { VEHICLE, KIND (VEHICLE) },
};

static gboolean
has_number (const QnLoad *load, guint field)
{
  const gboolean given = load->earth == QN_EARTH_GIVEN;
  gsize i = G_N_ELEMENTS (numbers);
  while (i > 0 && numbers[i - 1].field > field)
    i--;
  return i > 0 && (numbers[i - 1].kinds & 1u << load->kind) != 0
         && !((field == EDGE || field == EDGE_COUNT) && load->has_side)
         && !((field == X || field == Y) && load->kind == QN_LOAD_EDGE && load->normal)
         && !(field == FRICTION_ANGLE && load->kind == QN_LOAD_BACKFILL && given)
         && !(field == COEFFICIENT && !given);
}

static gboolean
show_load (const Form *form, const QnModel *model, guint field, QnValue *value)
{
  const QnLoad *load = selected_load (form);
  GtkWidget *widget = form->base.widgets[field];
  if (load == NULL)
    return FALSE;
  switch (field) {
  case CASE:
    qn_value_add_row (value, _ ("none"));
    for (gsize i = 0; i < model->load_case_count; i++)
      qn_value_add_row (value, model->load_cases[i].name);
    return model->load_case_count > 0;
  case WHERE:
    value->number = load->has_side ? load->side : QN_BLOCK_SIDE_COUNT;
    break;
  case SURFACE:
    value->text = qn_points_dup_text (load->surface, load->surface_count);
    break;
  case VEHICLE: {
    g_auto (GStrv) list = qn_dup_vehicle_names (model);
    for (gsize i = 0; list[i] != NULL; i++)
      qn_value_add_row (value, list[i]);
    value->number = load->vehicle;
    break;
  }
  case EARTH:
    value->number = load->earth;
    break;
  case X:
  case Y:
    g_object_set (widget, "quantity",
                  load->kind == QN_LOAD_WEIGHT || load->kind == QN_LOAD_EDGE
                    ? QN_QUANTITY_NUMBER
                  : load->kind == QN_LOAD_LINE ? QN_QUANTITY_STIFFNESS
                                               : QN_QUANTITY_FORCE,
                  NULL);
    break;
  case DISTANCE:
    g_object_set (widget, "quantity",
                  load->dof == QN_DOF_RZ ? QN_QUANTITY_ROTATION : QN_QUANTITY_LENGTH,
                  NULL);
    break;
  }
  return has_number (load, field);
}

static gboolean
show (QnForm *data, const QnModel *model, guint field, QnValue *value)
{
  const Form *form = (const Form *) data;
  switch (field) {
  case LIST:
    qn_value_add_row (value, _ ("Constant"));
    qn_value_add_row (value, _ ("Growing"));
    for (gsize i = 0; i < model->load_set_count; i++)
      qn_value_add_row (value, model->load_sets[i]);
    value->number = form->shown - DEAD_LOADS;
    return TRUE;
  case NAME:
    if (form->shown > 0)
      value->text = g_strdup (model->load_sets[form->shown - 1]);
    return form->shown > 0 && !form->settles;
  case ADD_SET:
    return !form->settles;
  case REMOVE_SET:
    value->disabled = form->shown <= 0;
    return !form->settles;
  case LOADS:
    if (load_of (form, 0) != QN_NONE)
      add_loads (form, value, model);
    value->number = form->base.selected >= 0 ? row_of (form, form->base.selected) : -1;
    return TRUE;
  case EMPTY:
    value->text = g_strdup (
      form->settles ? _ ("No support settles in this list. Select one and add it below.")
                    : _ ("No loads in this list. Add one below, or draw a force or an "
                         "edge load."));
    return load_of (form, 0) == QN_NONE;
  case ADD:
    return !form->settles;
  case CHOOSE_EDGE:
    return selected_load (form) != NULL && selected_load (form)->kind == QN_LOAD_EDGE;
  case UP:
  case DOWN:
    value->disabled = form->base.selected < 0
                      || qn_model_load_beside (model, form->shown != DEAD_LOADS,
                                               form->base.selected, field == UP ? -1 : 1)
                           == QN_NONE;
    return TRUE;
  case DUPLICATE:
  case REMOVE:
    value->disabled = selected_load (form) == NULL;
    return TRUE;
  case ADD_SETTLEMENT:
    return form->settles;
  default:
    return field >= ADD_WEIGHT || show_load (form, model, field, value);
  }
}

/* ---- changes ---- */

/* What a new load acts on: the selected blocks, or the block of the selected load. */
static QnBlockSet
loaded_blocks (const Form *form)
{
  QnBlockSet set = form->base.parts.blocks;
  const QnLoad *load = selected_load (form);
  if (set.count == 0 && load != NULL && load->block != QN_NONE)
    set = (QnBlockSet){ &load->block, 1 };
  return set;
}

/* On the first of the selected blocks, or the second end of the first of the beams. */
static gboolean
make_force (const Form *form, const QnModel *model, QnLoad *load, GError **error)
{
  QnBlockSet set = loaded_blocks (form);
  load->vector.y = -form->base.canvas->settings->force;
  load->kind = set.count > 0 ? QN_LOAD_FORCE : QN_LOAD_NODE;
  if (set.count > 0)
    load->block = set.ids[0];
  else if (form->base.parts.beams.count > 0)
    load->node = model->beams[form->base.parts.beams.ids[0]].nodes[1];
  else
    return qn_edit_refuse (error,
                           _ ("Select the block or the beam that the force acts on"));
  return TRUE;
}

/* Down, on the first of the selected beams. */
static gboolean
make_line (const Form *form, QnLoad *load, GError **error)
{
  if (form->base.parts.beams.count == 0)
    return qn_edit_refuse (error, _ ("Select the beam that the load lies on"));
  load->kind = QN_LOAD_LINE;
  load->beam = form->base.parts.beams.ids[0];
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
    return qn_edit_refuse (error, _ ("Select the fixed block that settles"));
  load->kind = QN_LOAD_SETTLEMENT;
  load->block = set.ids[0];
  load->dof = (QnDof) (dof % QN_DOF_COUNT);
  load->value = -qn_magnet_round_distance (0.01 * model->characteristic_length);
  return TRUE;
}

/* What is selected in another list is let go of. */
static void
show_list (Form *form, int32_t list)
{
  if (form->base.selected >= 0)
    select_load (form, -1);
  form->shown = list;
}

/* The sideways weight that new drawings grow by goes where it is alone: a vehicle is not meant to grow with it.
 * Whether it went. */
static gboolean
make_room (QnModel *model)
{
  QnId only = QN_NONE;
  int count = 0;
  for (QnId i = 0; i < (QnId) model->live_load_count; i++)
    if (model->live_loads[i].set == 0 && count++ == 0)
      only = i;
  const QnLoad *load = count == 1 ? &model->live_loads[only] : NULL;
  return load != NULL && load->kind == QN_LOAD_WEIGHT && load->vector.x == 1.0
         && load->vector.y == 0.0
         && qn_edit_remove_item (model, QN_PICK_LIVE_LOAD, only, NULL);
}

static gboolean
add (Form *form, QnModel *model, guint field, GError **error)
{
  /* A vehicle comes and goes, whichever list is looked at. */
  const int32_t list = field == ADD_VEHICLE ? MAX (form->shown, 0) : form->shown;
  const gboolean dead = list == DEAD_LOADS;
  QnLoad load = { .kind = QN_LOAD_WEIGHT,
                  .vector = { dead ? 0.0 : 1.0, dead ? -1.0 : 0.0 },
                  .block = QN_NONE,
                  .node = QN_NONE,
                  .beam = QN_NONE };
  QnLoad *added;
  if (field != ADD_WEIGHT)
    load.vector = qn_vec2 (0.0, 0.0);
  if (field >= ADD_EDGE
      && !qn_edit_make_edge_load (model,
                                  (QnLoadKind) (QN_LOAD_EDGE + (int) (field - ADD_EDGE)),
                                  loaded_blocks (form), &load, error))
    return FALSE;
  if ((field == ADD_FORCE && !make_force (form, model, &load, error))
      || (field == ADD_LINE && !make_line (form, &load, error))
      || (field == ADD_SETTLEMENT && !make_settlement (form, model, &load, error)))
    return FALSE;
  if (field == ADD_VEHICLE && list == 0 && make_room (model))
    form->base.told = _ ("The vehicle takes the place of the sideways weight; Undo "
                         "brings the weight back.");
  if ((added = qn_edit_new_load (model, !dead, error)) == NULL)
    return FALSE;
  *added = load;
  added->set = MAX (list, 0);
  if (list != form->shown)
    show_list (form, list);
  form->base.wanted = (int) qn_model_count_items (model, QN_PICK_LOAD (!dead)) - 1;
  return TRUE;
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  Form *form = (Form *) data;
  const int selected = form->base.selected;
  QnLoad *load = subject (data, model, field);
  switch (field) {
  case LIST:
    show_list (form, (int32_t) value->number + DEAD_LOADS);
    return TRUE;
  case LOADS:
    select_load (form, load_of (form, (int) value->number));
    return TRUE;
  case CHOOSE_EDGE:
    qn_tool_edge_load_choose (form->base.canvas);
    return TRUE;
  case NAME:
    return qn_edit_rename_load_list (model, FALSE, form->shown, value->text, error);
  case ADD_SET:
    if (!qn_edit_add_load_list (model, FALSE, error))
      return FALSE;
    show_list (form, (int32_t) model->load_set_count);
    return TRUE;
  case REMOVE_SET:
    return qn_edit_delete_load_set (model, form->shown, error);
  case REMOVE:
    select_load (form, -1); /* an equal one would take its place */
    return qn_edit_remove_item (model, kind_of (form), selected, error);
  case DUPLICATE:
    form->base.wanted = qn_edit_duplicate_item (model, kind_of (form), selected, error);
    return form->base.wanted >= 0;
  case UP:
  case DOWN:
    return qn_edit_move_load (model, form->shown != DEAD_LOADS, selected,
                              field == UP ? -1 : 1, error);
  case WHERE:
    if (value->number >= QN_BLOCK_SIDE_COUNT)
      qn_load_chain (model, load, &load->edge, &load->edge_count);
    load->has_side = value->number < QN_BLOCK_SIDE_COUNT;
    if (load->has_side)
      load->side = (QnBlockSide) qn_value_int (value);
    return TRUE;
  case SURFACE:
    return qn_points_parse (value->text, load->surface, QN_MAX_SURFACE_POINTS,
                            &load->surface_count)
           || qn_edit_refuse (
             error, _ ("Expected pairs of numbers with semicolons between them"));
  case VEHICLE: {
    g_auto (GStrv) list = qn_dup_vehicle_names (model);
    load->vehicle = qn_model_take_vehicle (model, list[qn_value_int (value)]);
    return TRUE;
  }
  case NORMAL:
    if (!load->normal && load->vector.x == 0.0 && load->vector.y == 0.0)
      load->vector = qn_vec2 (0.0, -1.0);
    return TRUE;
  case EARTH:
    load->coefficient = qn_load_earth_coefficient (load);
    load->earth = (QnEarth) qn_value_int (value);
    return TRUE;
  default:
    return field < ADD_WEIGHT || add (form, model, field, error);
  }
}

/* As it is before anything is shown. */
static void
init (QnForm *data)
{
  ((Form *) data)->shown = DEAD_LOADS;
}

static void
init_settlements (QnForm *data)
{
  ((Form *) data)->settles = TRUE;
}

const QnFormKind qn_load_form =
  QN_FORM_KIND ("load-form", Form, .subject = subject, .look = look,
                .follows = QN_FOLLOW_SELECTION, .init = init);
const QnFormKind qn_settlement_form =
  QN_FORM_KIND ("load-form", Form, .subject = subject, .look = look,
                .follows = QN_FOLLOW_SELECTION, .init = init_settlements);
