#include "io/text/mechanism-text.h"

#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Bodies named one by one; the rest are counted. */
#define BODIES_IN_WORDS 3

/* A mechanism has a direction where this part of its motion, block by block, has it. */
#define COMMON_SHARE 0.5

typedef enum { TO_THE_RIGHT, TO_THE_LEFT, UPWARDS, DOWNWARDS } Direction;

static Direction
direction_of (QnVec2 velocity)
{
  if (fabs (velocity.x) >= 0.5 * fabs (velocity.y))
    return velocity.x >= 0 ? TO_THE_RIGHT : TO_THE_LEFT;
  return velocity.y >= 0 ? UPWARDS : DOWNWARDS;
}

/* Whole phrases: languages do not build "to the right" into a sentence alike. Without one for its
 * direction a mechanism has that for none. */
#define NO_DIRECTION 4
static const char *const titles[QN_MECHANISM_KIND_COUNT][NO_DIRECTION + 1] = {
  [QN_MECHANISM_KIND_NONE] = { [NO_DIRECTION] = N_ ("Beams fail") }, /* no block moves */
  [QN_MECHANISM_KIND_OVERTURNING] = { [TO_THE_RIGHT] = N_ ("Overturning to the right"),
                                      [TO_THE_LEFT] = N_ ("Overturning to the left"),
                                      [NO_DIRECTION] = N_ ("Overturning") },
  [QN_MECHANISM_KIND_ROCKING] = { [TO_THE_RIGHT] = N_ ("Rocking to the right"),
                                  [TO_THE_LEFT] = N_ ("Rocking to the left"),
                                  [NO_DIRECTION] = N_ ("Rocking") },
  [QN_MECHANISM_KIND_SLIDING] = { [TO_THE_RIGHT] = N_ ("Sliding to the right"),
                                  [TO_THE_LEFT] = N_ ("Sliding to the left"),
                                  [UPWARDS] = N_ ("Sliding upwards"),
                                  [DOWNWARDS] = N_ ("Sliding downwards"),
                                  [NO_DIRECTION] = N_ ("Sliding") },
  [QN_MECHANISM_KIND_STEPPED] = { [TO_THE_RIGHT] =
                                    N_ ("Stepped crack, opening to the right"),
                                  [TO_THE_LEFT] =
                                    N_ ("Stepped crack, opening to the left"),
                                  [NO_DIRECTION] = N_ ("Stepped crack") },
  [QN_MECHANISM_KIND_ARCH] = { [NO_DIRECTION] = N_ ("Hinges as in an arch") },
  [QN_MECHANISM_KIND_FALLING] = { [UPWARDS] = N_ ("Lifting off"),
                                  [NO_DIRECTION] = N_ ("Falling") },
  [QN_MECHANISM_KIND_SWAYING] = { [TO_THE_RIGHT] = N_ ("Swaying to the right"),
                                  [TO_THE_LEFT] = N_ ("Swaying to the left"),
                                  [NO_DIRECTION] = N_ ("Swaying") },
  [QN_MECHANISM_KIND_MIXED] = { [TO_THE_RIGHT] = N_ ("Rocking and sliding to the right"),
                                [TO_THE_LEFT] = N_ ("Rocking and sliding to the left"),
                                [NO_DIRECTION] = N_ ("Rocking and sliding") },
};

char *
qn_mechanism_dup_title (const QnMechanism *mechanism)
{
  const char *const *phrases = titles[mechanism->kind];
  const char *title = NULL;
  QnVec2 sum = { 0, 0 };
  double apart = 0;
  for (size_t i = 0; i < mechanism->body_count; i++) {
    const QnMechanismBody *body = &mechanism->bodies[i];
    sum = qn_vec2_add_scaled (sum, body->block_count, body->velocity);
    apart += body->block_count * qn_vec2_length (body->velocity);
  }
  /* Parts that move against each other have no direction in common. */
  if (qn_vec2_length (sum) > COMMON_SHARE * apart)
    title = phrases[direction_of (sum)];
  return g_strdup (_ (title != NULL ? title : phrases[NO_DIRECTION]));
}

/* “w.3.1” or “w.3.1” … “w.7.4” (23 blocks) */
static char *
dup_blocks (const QnModel *model, const QnMechanism *mechanism, QnId body)
{
  const char *first = NULL, *last = NULL;
  int count = mechanism->bodies[body].block_count;
  for (size_t b = 0; b < mechanism->block_count; b++)
    if (mechanism->body_of_block[b] == body) {
      last = model->blocks[b].name;
      first = first != NULL ? first : last;
    }
  if (count == 1)
    return qn_text_printf (_ ("“%s”"), first);
  return qn_text_printf (
    ngettext ("“%s” … “%s” (%d block)", "“%s” … “%s” (%d blocks)", (gulong) count), first,
    last, count);
}

/* Rounding leaves 1e-13 where 0 is meant: nothing to show to a reader. */
static double
legible (double coordinate, const QnMechanismBody *body)
{
  double size = qn_box_diagonal (body->box);
  return fabs (coordinate) < 1e-4 * size ? 0 : coordinate;
}

static char *
dup_body (const QnModel *model, const QnMechanism *mechanism, QnId id)
{
  const QnMechanismBody *body = &mechanism->bodies[id];
  g_autofree char *blocks = dup_blocks (model, mechanism, id);
  const Direction way = direction_of (body->velocity);
  if (!body->turns)
    return qn_text_printf (way == TO_THE_RIGHT  ? _ ("%s: to the right")
                           : way == TO_THE_LEFT ? _ ("%s: to the left")
                           : way == UPWARDS     ? _ ("%s: upwards")
                                                : _ ("%s: downwards"),
                           blocks);
  return qn_text_printf (
    body->rotation < 0 ? _ ("%s: turns clockwise about (%.3g, %.3g) m")
                       : _ ("%s: turns counter-clockwise about (%.3g, %.3g) m"),
    blocks, legible (body->centre.x, body), legible (body->centre.y, body));
}

static void G_GNUC_PRINTF (2, 3) append_count (GString *text, const char *format, ...)
{
  va_list arguments;
  g_string_append (text, text->len > 0 ? _ (", ") : "");
  va_start (arguments, format);
  g_string_append_vprintf (text, format, arguments);
  va_end (arguments);
}

/* "2 joints hinge, 4 slide" */
static char *
dup_joints (const QnMechanism *mechanism)
{
  int hinges =
    mechanism->counts[QN_JOINT_HINGE_START] + mechanism->counts[QN_JOINT_HINGE_END];
  int slides = mechanism->sliding_count, opens = mechanism->counts[QN_JOINT_OPENING];
  GString *text = g_string_new (NULL);
  if (hinges > 0)
    append_count (text, ngettext ("%d joint hinges", "%d joints hinge", (gulong) hinges),
                  hinges);
  if (slides > 0)
    append_count (text, ngettext ("%d joint slides", "%d joints slide", (gulong) slides),
                  slides);
  if (opens > 0)
    append_count (text, ngettext ("%d joint opens", "%d joints open", (gulong) opens),
                  opens);
  return g_string_free (text, FALSE);
}

char *
qn_mechanism_dup_sentence (const QnMechanism *mechanism)
{
  g_autofree char *title = qn_mechanism_dup_title (mechanism);
  g_autofree char *joints = dup_joints (mechanism);
  return joints[0] != '\0' ? qn_text_printf (_ ("%s: %s."), title, joints)
                           : qn_text_printf ("%s.", title);
}

char *
qn_mechanism_dup_text (const QnModel *model, const QnMechanism *mechanism)
{
  g_autofree char *title = qn_mechanism_dup_title (mechanism);
  g_autofree char *joints = dup_joints (mechanism);
  GString *text = g_string_new (title);
  g_string_append_c (text, '.');
  for (size_t i = 0; i < mechanism->body_count && i < BODIES_IN_WORDS; i++) {
    g_autofree char *body = dup_body (model, mechanism, (QnId) i);
    qn_text_append (text, " %s.", body);
  }
  if (mechanism->body_count > BODIES_IN_WORDS) {
    int more = (int) mechanism->body_count - BODIES_IN_WORDS;
    g_string_append (text, " ");
    qn_text_append (
      text, ngettext ("%d more body moves.", "%d more bodies move.", (gulong) more),
      more);
  }
  if (joints[0] != '\0')
    qn_text_append (text, " %s.", joints);
  return g_string_free (text, FALSE);
}

char *
qn_collapse_dup_words (const QnModel *model, const QnContacts *contacts,
                       const QnResult *result,
                       char *(*dup_words) (const QnMechanism *mechanism))
{
  QnMechanism mechanism;
  if (result->mechanism == NULL
      || qn_mechanism_of_result (&mechanism, model, contacts, result, NULL) != QN_OK)
    return NULL;
  char *words = dup_words (&mechanism);
  qn_mechanism_clear (&mechanism);
  return words;
}

char *
qn_collapse_dup_text (const QnModel *model, const QnContacts *contacts,
                      const QnResult *result)
{
  QnMechanism mechanism;
  if (result->mechanism == NULL
      || qn_mechanism_of_result (&mechanism, model, contacts, result, NULL) != QN_OK)
    return NULL;
  g_autofree char *hinges = qn_hinges_dup_text (model, result);
  gboolean blocks_move = mechanism.body_count > 0;
  g_autofree char *text = qn_mechanism_dup_text (model, &mechanism);
  qn_mechanism_clear (&mechanism);
  if (hinges == NULL)
    return g_steal_pointer (&text);
  return blocks_move ? qn_text_printf ("%s %s", text, hinges) : g_steal_pointer (&hinges);
}

static void
write_body (QnFileWriter *writer, const QnMechanism *mechanism, QnId id)
{
  const QnMechanismBody *body = &mechanism->bodies[id];
  gboolean first = TRUE;
  qn_file_writer_puts (writer, id > 0 ? "," : "");
  qn_file_writer_puts (writer, "\n      { \"blocks\": [");
  for (size_t b = 0; b < mechanism->block_count; b++)
    if (mechanism->body_of_block[b] == id) {
      qn_file_writer_printf (writer, first ? "%d" : ", %d", (int) b);
      first = FALSE;
    }
  qn_file_writer_json (
    writer, "], \"velocity\": [%g, %g], \"rotation\": %g, \"centre\": ", body->velocity.x,
    body->velocity.y, body->rotation);
  if (body->turns)
    qn_file_writer_json (writer, "[%g, %g] }", body->centre.x, body->centre.y);
  else
    qn_file_writer_puts (writer, "null }");
}

void
qn_mechanism_write (QnFileWriter *writer, const QnContacts *contacts,
                    const QnMechanism *mechanism)
{
  qn_file_writer_json (writer, "{\n    \"kind\": %s,\n    \"bodies\": [",
                       qn_mechanism_kind_names[mechanism->kind]);
  for (size_t i = 0; i < mechanism->body_count; i++)
    write_body (writer, mechanism, (QnId) i);
  qn_file_writer_puts (writer, "],\n    \"joints\": [");
  for (size_t f = 0; f < mechanism->joint_count; f++) {
    const QnJointMotion *joint = &mechanism->joints[f];
    if (joint->kind == QN_JOINT_CLOSED)
      continue;
    QnId face = (QnId) f;
    QnVec2 start, end;
    qn_joint_corners (contacts, face, &start, &end);
    qn_file_writer_json (writer, ",\n      { \"face\": %d, \"kind\": %s, \"slides\": %i",
                         face, qn_joint_kind_names[joint->kind], joint->slides);
    if (joint->kind == QN_JOINT_HINGE_END)
      start = end;
    if (joint->kind == QN_JOINT_HINGE_START || joint->kind == QN_JOINT_HINGE_END)
      qn_file_writer_json (writer, ", \"hinge\": [%g, %g]", start.x, start.y);
    qn_file_writer_json (writer, ", \"opening\": [%g, %g], \"slip\": %g }",
                         joint->opening_start, joint->opening_end, joint->slip);
  }
  qn_file_writer_puts (writer, "]\n  }");
}

/* ---- ties and plastic hinges ---- */

/* Ties named one by one; the rest are counted. */
#define TIES_IN_WORDS 4

const char *
qn_tie_state_text (QnTieState state)
{
  static const char *const words[QN_TIE_STATE_COUNT] = {
    [QN_TIE_SLACK] = N_ ("slack"),
    [QN_TIE_ELASTIC] = N_ ("elastic"),
    [QN_TIE_YIELDS] = N_ ("yields"),
    [QN_TIE_ANCHOR] = N_ ("anchor gives"),
  };
  return _ (words[state]);
}

gssize
qn_tie_worst_step (const QnResult *result, gsize tie)
{
  gssize worst = -1;
  double most = -INFINITY;
  for (gsize s = 0; s < result->step_count; s++) {
    const QnTieResult *ties = qn_result_step_ties (result, s);
    if (ties != NULL && ties[tie].force > most) {
      most = ties[tie].force;
      worst = (gssize) s;
    }
  }
  return worst;
}

double
qn_tie_utilisation (const QnTie *tie, double force)
{
  return force / qn_tie_strength (tie);
}

typedef struct Worst {
  const QnTie *tie;
  QnTieResult at;
} Worst;

static int
compare_worst (gconstpointer a, gconstpointer b)
{
  const Worst *x = a, *y = b;
  double u = qn_tie_utilisation (x->tie, x->at.force),
         v = qn_tie_utilisation (y->tie, y->at.force);
  if (u != v)
    return u > v ? -1 : 1;
  return (x->at.force < y->at.force) - (x->at.force > y->at.force);
}

char *
qn_ties_dup_text (const QnModel *model, const QnResult *result)
{
  g_autoptr (GArray) all = g_array_new (FALSE, FALSE, sizeof (Worst));
  for (gsize i = 0;
       result->tie_count == qn_model_tie_count (model) && i < model->tie_count; i++) {
    gssize step = qn_tie_worst_step (result, i);
    if (step < 0)
      break;
    Worst worst = { &model->ties[i], qn_result_step_ties (result, (gsize) step)[i] };
    g_array_append_val (all, worst);
  }
  /* How much of the soil has its mobilised strength at the last step; NULL where that is
   * not known. */
  const QnTieResult *ties =
    result->step_count > 0 && result->tie_count == qn_model_tie_count (model)
      ? qn_result_step_ties (result, result->step_count - 1)
      : NULL;
  guint full = 0;
  for (gsize i = 0; ties != NULL && i < model->soil_tie_count; i++)
    full += ties[model->tie_count + i].state == QN_TIE_YIELDS;
  g_autofree char *soil =
    ties != NULL && model->soil_tie_count > 0
      ? g_strdup_printf (_ ("The soil presses %u of %u faces with all of its "
                            "mobilised pressure."),
                         full, (guint) model->soil_tie_count)
      : NULL;
  if (all->len == 0)
    return g_steal_pointer (&soil);
  g_array_sort (all, compare_worst);
  g_autoptr (GString) text = g_string_new (NULL);
  for (guint i = 0; i < MIN (all->len, TIES_IN_WORDS); i++) {
    const Worst *worst = &g_array_index (all, Worst, i);
    g_string_append (text, text->len > 0 ? _ (", ") : "");
    g_string_append_printf (text, _ ("“%s” %.5g kN"), worst->tie->name,
                            1e-3 * worst->at.force);
    double used = qn_tie_utilisation (worst->tie, worst->at.force);
    if (used > 0)
      g_string_append_printf (text, _ (", %.0f %% of its strength"), 100 * used);
    if (worst->at.state >= QN_TIE_YIELDS)
      g_string_append_printf (text, " (%s)", qn_tie_state_text (worst->at.state));
  }
  if (all->len > TIES_IN_WORDS)
    g_string_append (text, "…");
  g_autofree char *largest = g_strdup_printf (
    ngettext ("Largest force of the tie: %s.", "Ties at most: %s.", all->len), text->str);
  return g_strjoin (soil != NULL ? " " : NULL, largest, soil, NULL);
}

/* Hinges named one by one; the rest are counted. */
#define HINGES_IN_WORDS 4

/* A moment within this part of the plastic one is that of a plastic hinge. */
#define YIELDS 1e-3

static gboolean
yields_at (const QnModel *model, const QnBeamForces *forces, size_t element, int end)
{
  const QnBeamElement *e = &model->elements[element];
  double plastic =
    qn_section_plastic_moment (&model->sections[model->beams[e->beam].section]);
  return e->yields[end] && !e->hinge[end] && isfinite (plastic)
         && fabs (forces[element].moment[end]) >= (1 - YIELDS) * plastic;
}

char *
qn_hinges_dup_text (const QnModel *model, const QnResult *result)
{
  const QnBeamForces *forces =
    result->step_count > 0 ? qn_result_step_beam_forces (result, result->step_count - 1)
                           : NULL;
  if (forces == NULL || result->element_count != model->element_count)
    return NULL;
  g_autoptr (GString) places = g_string_new (NULL);
  int count = 0;
  for (size_t i = 0; i < model->element_count; i++)
    for (int end = 0; end < 2; end++)
      if (yields_at (model, forces, i, end) && count++ < HINGES_IN_WORDS) {
        const QnBeamElement *e = &model->elements[i];
        g_string_append (places, places->len > 0 ? _ (", ") : "");
        qn_text_append (places, _ ("“%s” at “%s”"), model->beams[e->beam].name,
                        model->nodes[e->nodes[end]].name);
      }
  if (count == 0)
    return NULL;
  if (count > HINGES_IN_WORDS)
    g_string_append (places, "…");
  return qn_text_printf (
    ngettext ("%d plastic hinge: %s.", "%d plastic hinges: %s.", (gulong) count), count,
    places->str);
}
