/* Ties: a list of them, and what the selected one is made of, how it is tensioned and where it ends. The
 * selected one is that of the drawing. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "core/model/bar.h"
#include "doc/edit/edit-tie.h"
#include "doc/view/view-state.h"
#include "io/text/mechanism-text.h"
#include <glib/gi18n.h>
#include <math.h>

/* Diameters are shown in whole micrometres: areas are given, not they. */
#define SHOWN 1e6

#define CHANGE N_ ("Change Tie")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TIES, "ties", NULL)                                                             \
  FIELD (EMPTY, "empty", NULL)                                                           \
  MEMBER (NAME, "name", N_ ("Rename Tie"), QnTie, name)                                  \
  FIELD (STEEL, "steel", CHANGE)                                                         \
  FIELD (ROUND, "round", CHANGE)                                                         \
  FIELD (DIAMETER, "diameter", CHANGE)                                                   \
  MEMBER (ELASTICITY, "elasticity", CHANGE, QnTie, elasticity)                           \
  MEMBER (YIELD, "yield", CHANGE, QnTie, yield)                                          \
  MEMBER (PRESTRESS, "prestress", CHANGE, QnTie, prestress)                              \
  MEMBER (SLACK, "slack", CHANGE, QnTie, slack)                                          \
  MEMBER (ANCHOR, "anchor", CHANGE, QnTie, anchor)                                       \
  MEMBER (PLATE, "plate", CHANGE, QnTie, plate.diameter)                                 \
  MEMBER (WALL, "wall", CHANGE, QnTie, plate.wall)                                       \
  MEMBER (SHEAR, "shear", CHANGE, QnTie, plate.shear)                                    \
  MEMBER (COMPRESSION, "compression", CHANGE, QnTie, plate.compression)                  \
  MEMBER (STRIP, "strip", CHANGE, QnTie, strip.width)                                    \
  FIELD (STRIP_THICKNESS, "strip_thickness", CHANGE)                                     \
  MEMBER (BOND, "bond", CHANGE, QnTie, strip.fracture_energy)                            \
  FIELD (GLUE, "glue", N_ ("Glue Strip to Blocks"))                                      \
  MEMBER (FIRST_X, "first_x", N_ ("Move Tie End"), QnTie, ends[0].at.x)                  \
  MEMBER (FIRST_Y, "first_y", N_ ("Move Tie End"), QnTie, ends[0].at.y)                  \
  MEMBER (SECOND_X, "second_x", N_ ("Move Tie End"), QnTie, ends[1].at.x)                \
  MEMBER (SECOND_Y, "second_y", N_ ("Move Tie End"), QnTie, ends[1].at.y)                \
  FIELD (FACTS, "facts", NULL)                                                           \
  FIELD (DUPLICATE, "duplicate", N_ ("Duplicate Tie"))                                   \
  FIELD (REMOVE, "remove", N_ ("Remove Tie"))
QN_FORM_FIELDS;

static char *
dup_row (const QnModel *model, gsize index)
{
  return qn_tie_dup_text (model, &model->ties[index], qn_settings_get_units ());
}

static void
show_steels (QnValue *value, const QnTie *tie)
{
  qn_value_add_row (value, _ ("Choose…"));
  value->number = 0;
  for (int i = 0; i < QN_TIE_STEELS; i++) {
    qn_value_add_row (value, qn_tie_steels[i].name);
    if (tie->elasticity == qn_tie_steels[i].elasticity
        && tie->yield == qn_tie_steels[i].yield)
      value->number = i + 1;
  }
}

static void
show_diameters (QnValue *value, const QnTie *tie)
{
  qn_value_add_row (value, _ ("Choose…"));
  value->number = 0;
  for (int i = 0; i < QN_TIE_DIAMETERS; i++) {
    g_autofree char *text = qn_units_format_full (
      qn_settings_get_units (), QN_QUANTITY_DIAMETER, qn_tie_diameters[i], 3);
    qn_value_take_row (value, g_strdup_printf ("Ø %s", text));
    if (tie->area == qn_bar_get_area (qn_tie_diameters[i]))
      value->number = i + 1;
  }
}

/* What the tie is, and where a run is shown, what it does at the step. */
static char *
dup_facts (const QnForm *form, const QnTie *tie)
{
  const QnUnits units = qn_settings_get_units ();
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  g_autofree char *facts = qn_tie_dup_facts (tie, units);
  QnViewState *state = form->canvas->state;
  if (!qn_view_state_get_content (state, state->options.view, &model, &contacts, &result)
      || result == NULL)
    return g_steal_pointer (&facts);
  QnId id = qn_model_find_tie (model, tie->name);
  if (id == QN_NONE || (gsize) id >= result->tie_count)
    return g_steal_pointer (&facts);
  gssize step = qn_tie_worst_step (result, (gsize) id);
  if (step < 0)
    return g_steal_pointer (&facts);
  const QnTieResult *at = &qn_result_step_ties (result, (gsize) step)[id];
  g_autofree char *force = qn_units_format_full (units, QN_QUANTITY_FORCE, at->force, 4);
  return g_strdup_printf (_ ("%s\nLargest force %s (%s)"), facts, force,
                          qn_tie_state_text (at->state));
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  const QnTie *tie = qn_form_item (form, model);
  if (tie == NULL) {
    value->disabled = TRUE;
    return (field == DUPLICATE || field == REMOVE) && model->tie_count > 0;
  }
  switch (field) {
  case ELASTICITY:
  case PRESTRESS:
  case SLACK:
    value->disabled = model->analysis.procedure == QN_PROCEDURE_LIMIT;
    return TRUE;
  case STEEL:
    show_steels (value, tie);
    return TRUE;
  case ROUND:
    show_diameters (value, tie);
    return TRUE;
  case DIAMETER:
    value->number = round (qn_bar_get_diameter (tie->area) * SHOWN) / SHOWN;
    return TRUE;
  case FACTS:
    value->text = dup_facts (form, tie);
    return TRUE;
  case WALL:
  case SHEAR:
  case COMPRESSION:
    return tie->plate.diameter > 0;
  case STRIP_THICKNESS:
    value->number = tie->strip.width > 0 ? tie->area / tie->strip.width : 0;
    return tie->strip.width > 0;
  case BOND:
  case GLUE:
    return tie->strip.width > 0;
  }
  return TRUE;
}

static gboolean
take (QnForm *form, QnModel *model, guint field, const QnValue *value, GError **error)
{
  QnTie *tie = qn_form_item (form, model);
  const int row = qn_value_int (value);
  switch (field) {
  case NAME:
    return qn_edit_take_name (&tie->name, value->text, error);
  case STEEL:
    if (row < 1 || row > QN_TIE_STEELS)
      return FALSE;
    tie->elasticity = qn_tie_steels[row - 1].elasticity;
    tie->yield = qn_tie_steels[row - 1].yield;
    return TRUE;
  case ROUND:
    if (row < 1 || row > QN_TIE_DIAMETERS)
      return FALSE;
    tie->area = qn_bar_get_area (qn_tie_diameters[row - 1]);
    return TRUE;
  case DIAMETER:
    tie->area = qn_bar_get_area (value->number);
    return TRUE;
  case STRIP_THICKNESS:
    tie->area = value->number * tie->strip.width;
    return TRUE;
  case GLUE:
    return qn_edit_glue_tie (model, form->selected, error);
  case DUPLICATE:
    form->wanted = qn_edit_duplicate_item (model, QN_PICK_TIE, form->selected, error);
    return form->wanted >= 0;
  case REMOVE:
    return qn_edit_remove_item (model, QN_PICK_TIE, form->selected, error);
  case FIRST_X:
  case FIRST_Y:
  case SECOND_X:
  case SECOND_Y: {
    int end = field >= SECOND_X;
    return qn_edit_place_tie_end (model, form->selected, end, tie->ends[end].at, error);
  }
  default:
    return TRUE;
  }
}

static const QnFormList list =
  QN_FORM_LIST (TIES, EMPTY, ties, tie_count, dup_row, QN_PICK_TIE);

const QnFormKind qn_tie_form =
  QN_FORM_KIND ("tie-form", QnForm, .list = &list, .follows = QN_FOLLOW_SELECTION);
