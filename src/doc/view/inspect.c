#include "doc/view/inspect.h"

#include "doc/text/explain.h"
#include "render/scene/thrust.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#define DIGITS 4

/* Values below this share of the field's largest value are rounding. */
#define NOISE 1e-9

gboolean
qn_step_view_init (QnStepView *view, QnViewState *state)
{
  *view = (QnStepView){ 0 };
  if (!qn_view_state_get_content (state, state->options.view, &view->model,
                                  &view->contacts, &view->result))
    return FALSE;
  QnDocument *document = state->document;
  const QnRun *run = document->run;
  /* The contacts of the same model are the same. */
  if (view->result == NULL && run != NULL && !qn_document_is_stale (document, run))
    view->result = &run->result;
  if (view->result == NULL || view->result->step_count == 0)
    return TRUE;
  view->step = qn_view_state_get_shown_step (state);
  view->pairs = qn_step_pairs (view->contacts, view->result, view->step);
  view->touches =
    qn_step_touches (view->model, view->result, view->step, &view->touch_count);
  /* Limit analysis knows forces and velocities alone. */
  if (!view->result->limit.given)
    view->motion = qn_step_motion (view->model, view->result, view->step);
  for (gsize i = 0; view->pairs != NULL && i < view->contacts->pair_count; i++)
    view->force =
      fmax (view->force, hypot (view->pairs[i].normal_force, view->pairs[i].shear_force));
  for (gsize i = 0; i < view->touch_count; i++)
    view->force = fmax (view->force, qn_vec2_length (view->touches[i].on[0]));
  for (gsize b = 0; b < view->model->block_count; b++) {
    view->force = fmax (view->force, view->model->blocks[b].weight);
    for (int dof = QN_DOF_UX; view->motion.displacements != NULL && dof < QN_DOF_RZ;
         dof++)
      view->length = fmax (
        view->length, fabs (view->motion.displacements[b * QN_DOF_COUNT + (gsize) dof]));
  }
  return TRUE;
}

void
qn_step_view_clear (QnStepView *view)
{
  g_clear_pointer (&view->pairs, g_free);
  g_clear_pointer (&view->touches, g_free);
}

static gboolean
is_there (const QnStepView *view, QnPick what)
{
  gsize count = what.kind == QN_PICK_FACE    ? view->contacts->face_count
                : what.kind == QN_PICK_BLOCK ? view->model->block_count
                : view->result != NULL       ? view->result->found_count
                                             : 0;
  return what.id >= 0 && (gsize) what.id < count;
}

char *
qn_inspect_dup_title (const QnStepView *view, QnPick what)
{
  if (!is_there (view, what))
    return NULL;
  const QnBlock *blocks = view->model->blocks;
  if (what.kind == QN_PICK_BLOCK)
    return g_strdup_printf (_ ("Block %s"), blocks[what.id].name);
  if (what.kind == QN_PICK_FOUND) {
    const QnFoundContact *contact = &view->result->found[what.id].contact;
    return g_strdup_printf (_ ("Contact %s – %s"), blocks[contact->block].name,
                            blocks[contact->other].name);
  }
  const QnContactFace *face = &view->contacts->faces[what.id];
  return g_strdup_printf (_ ("Joint %s – %s"), blocks[face->a].name,
                          blocks[face->b].name);
}

/* ---- lines ---- */

/* Values below those of `noise` are shown as 0. */
typedef struct Lines {
  GString *text;
  double noise[QN_QUANTITY_COUNT];
} Lines;

static void
add_text (Lines *lines, const char *name, const char *value)
{
  g_string_append_printf (lines->text, "%s%s\t%s", lines->text->len > 0 ? "\n" : "", name,
                          value);
}

static double
quiet (const Lines *lines, QnQuantity quantity, double value)
{
  return fabs (value) < lines->noise[quantity] ? 0.0 : value;
}

static void
add_value (Lines *lines, QnUnits units, const char *name, QnQuantity quantity,
           double value)
{
  g_autofree char *number =
    qn_units_format_full (units, quantity, quiet (lines, quantity, value), DIGITS);
  add_text (lines, name, number);
}

/* Two values on one line, the unit behind the second. */
static void
add_pair (Lines *lines, QnUnits units, const char *name, QnQuantity quantity, double a,
          double b)
{
  const QnVec2 pair = { quiet (lines, quantity, a), quiet (lines, quantity, b) };
  g_autofree char *both = qn_units_format_pair (units, quantity, pair, DIGITS);
  add_text (lines, name, both);
}

/* ---- joints ---- */

static const char *
place_word (QnPressurePlace place)
{
  static const char *const texts[QN_PLACE_COUNT] = {
    [QN_PLACE_KERN] = N_ ("within the kern"),
    [QN_PLACE_INSIDE] = N_ ("outside the kern"),
    [QN_PLACE_EDGE] = N_ ("at the edge"),
    [QN_PLACE_OUTSIDE] = N_ ("outside the joint"),
  };
  return texts[place] != NULL ? _ (texts[place]) : "";
}

/* "e 83 mm, outside the kern (±67 mm; edge ±200 mm)" */
static void
add_eccentricity (Lines *lines, QnUnits units, const QnContactFace *face,
                  const QnJointReading *reading, gboolean brief)
{
  QnUnits mm = qn_units_of_motion (units);
  if (reading->place == QN_PLACE_NOWHERE) {
    add_text (lines, _ ("Eccentricity"), _ ("no compression"));
    return;
  }
  g_autofree char *e =
    qn_units_format_full (mm, QN_QUANTITY_LENGTH, reading->eccentricity, DIGITS);
  g_autofree char *kern = qn_units_format (mm, QN_QUANTITY_LENGTH, face->length / 6.0, 3);
  g_autofree char *edge =
    qn_units_format_full (mm, QN_QUANTITY_LENGTH, face->length / 2.0, 3);
  g_autofree char *bounds = g_strdup_printf (_ ("kern ±%s, edge ±%s"), kern, edge);
  g_autofree char *where = g_strdup_printf ("%s, %s", e, place_word (reading->place));
  add_text (lines, _ ("Eccentricity"), where);
  if (!brief)
    add_text (lines, "", bounds);
}

/* Where a joint is one of a row, what passes through the whole row: the force of the line of thrust. */
static void
tell_row (Lines *lines, const QnStepView *view, QnId id, QnUnits units)
{
  QnThrust thrust;
  int alike = 0;
  qn_thrust_find (&thrust, view->model, view->contacts, view->pairs, view->touches,
                  view->touch_count);
  const QnCut *cut = &thrust.cuts[thrust.cut_of[id]];
  for (gsize f = 0; f < view->contacts->face_count; f++)
    alike += thrust.cut_of[f] == thrust.cut_of[id];
  if (alike > 1 && (cut->next[0] != QN_NONE || cut->next[1] != QN_NONE)) {
    g_autofree char *force = qn_units_format_full (units, QN_QUANTITY_FORCE,
                                                   qn_vec2_length (cut->force), DIGITS);
    g_autofree char *e = qn_units_format_full (
      qn_units_of_motion (units), QN_QUANTITY_LENGTH, cut->eccentricity, DIGITS);
    g_autofree char *both = g_strdup_printf (_ ("%s, e = %s"), force, e);
    add_text (lines, _ ("Whole row"), both);
  }
  qn_thrust_clear (&thrust);
}

static void
tell_joint (Lines *lines, const QnStepView *view, QnId id, QnUnits units, gboolean brief)
{
  const QnContactFace *face = &view->contacts->faces[id];
  const double thickness =
    fmin (view->model->blocks[face->a].thickness, view->model->blocks[face->b].thickness);
  lines->noise[QN_QUANTITY_MOMENT] = NOISE * view->force * face->length;
  lines->noise[QN_QUANTITY_STRESS] = NOISE * view->force / (face->length * thickness);
  if (view->pairs != NULL) {
    QnJointReading reading = qn_joint_reading (view->contacts, id, view->pairs);
    if (fabs (reading.eccentricity) < NOISE * face->length)
      reading.eccentricity = 0.0;
    add_value (lines, units, "N", QN_QUANTITY_FORCE, reading.normal);
    add_value (lines, units, "T", QN_QUANTITY_FORCE, reading.shear);
    add_value (lines, units, "M", QN_QUANTITY_MOMENT, reading.moment);
    add_eccentricity (lines, units, face, &reading, brief);
    add_value (lines, units, _ ("Greatest pressure"), QN_QUANTITY_STRESS,
               -reading.pressure);
    tell_row (lines, view, id, units);
    g_autofree char *state = qn_explain_pairs (reading.states);
    add_text (lines, _ ("State"), state);
  } else if (view->result != NULL)
    add_text (lines, _ ("Forces"), _ ("not kept of this step"));
  if (view->motion.displacements != NULL) {
    const QnJointMotion joint = qn_motion_joint (&view->motion, face);
    QnUnits mm = qn_units_of_motion (units);
    add_pair (lines, mm, _ ("Opening at its ends"), QN_QUANTITY_LENGTH,
              joint.opening_start, joint.opening_end);
    add_value (lines, mm, _ ("Slip"), QN_QUANTITY_LENGTH, joint.slip);
  }
  if (brief && view->result != NULL)
    return;
  add_value (lines, units, _ ("Length"), QN_QUANTITY_LENGTH, face->length);
  const char *law_a = view->model->laws[face->law_a].name;
  const char *law_b = view->model->laws[face->law_b].name;
  g_autofree char *laws = face->law_a == face->law_b
                            ? g_strdup (law_a)
                            : g_strdup_printf ("%s, %s", law_a, law_b);
  add_text (lines, _ ("Law"), laws);
}

/* ---- contacts found on the way ---- */

static void
tell_found (Lines *lines, const QnStepView *view, QnId id, QnUnits units)
{
  gsize count;
  const QnFoundForce *forces = qn_step_found (view->result, view->step, &count);
  for (gsize i = 0; i < count; i++) {
    if (forces[i].found != id)
      continue;
    add_value (lines, units, "N", QN_QUANTITY_FORCE, forces[i].normal);
    add_value (lines, units, "T", QN_QUANTITY_FORCE, forces[i].shear);
    add_text (lines, _ ("State"), qn_explain_pair_state (forces[i].state));
  }
  double at = view->result->found[id].time;
  if (view->result->history.width > 0) {
    add_value (lines, units, _ ("Found at"), QN_QUANTITY_TIME, at);
  } else {
    g_autofree char *step = g_strdup_printf ("%.0f", at);
    add_text (lines, _ ("Found at step"), step);
  }
}

/* ---- blocks ---- */

static void
tell_block (Lines *lines, const QnStepView *view, QnId id, QnUnits units, gboolean brief)
{
  const QnBlock *block = &view->model->blocks[id];
  const double size = sqrt (block->area);
  lines->noise[QN_QUANTITY_STRESS] = NOISE * view->force / (size * block->thickness);
  lines->noise[QN_QUANTITY_ROTATION] = NOISE * view->length / size;
  if (view->motion.displacements != NULL) {
    const double *u = view->motion.displacements + (size_t) id * QN_DOF_COUNT;
    QnUnits mm = qn_units_of_motion (units);
    add_pair (lines, mm, _ ("Displacement x; y"), QN_QUANTITY_LENGTH, u[QN_DOF_UX],
              u[QN_DOF_UY]);
    add_value (lines, units, _ ("Rotation"), QN_QUANTITY_ROTATION, u[QN_DOF_RZ]);
    add_value (lines, mm, _ ("Largest displacement"), QN_QUANTITY_LENGTH,
               qn_motion_of_block (&view->motion, id));
  }
  if (view->pairs != NULL) {
    double factors[QN_MAX_LOAD_SETS];
    qn_result_load_factors (view->model, view->result, view->step, factors);
    g_autofree QnBlockReading *all =
      qn_block_readings (view->model, view->contacts, view->pairs, view->touches,
                         view->touch_count, factors);
    add_pair (lines, units, _ ("Principal stresses"), QN_QUANTITY_STRESS,
              all[id].principal[0], all[id].principal[1]);
    add_pair (lines, units, _ ("Force of its joints x; y"), QN_QUANTITY_FORCE,
              all[id].force.x, all[id].force.y);
  } else if (view->result != NULL)
    add_text (lines, _ ("Forces"), _ ("not kept of this step"));
  if (brief && view->result != NULL)
    return;
  add_value (lines, units, _ ("Weight"), QN_QUANTITY_FORCE, block->weight);
  add_pair (lines, units, _ ("Centroid x; y"), QN_QUANTITY_LENGTH, block->centroid.x,
            block->centroid.y);
}

char *
qn_inspect_dup_values (const QnStepView *view, QnPick what, QnUnits units, gboolean brief)
{
  if (!is_there (view, what))
    return NULL;
  Lines lines = { g_string_new (NULL),
                  { [QN_QUANTITY_FORCE] = NOISE * view->force,
                    [QN_QUANTITY_LENGTH] = NOISE * view->length } };
  if (what.kind == QN_PICK_FACE)
    tell_joint (&lines, view, what.id, units, brief);
  else if (what.kind == QN_PICK_FOUND)
    tell_found (&lines, view, what.id, units);
  else
    tell_block (&lines, view, what.id, units, brief);
  return g_string_free (lines.text, FALSE);
}
