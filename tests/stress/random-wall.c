#include "stress/random-wall.h"

#include "core/contact/contacts.h"
#include "stereotomy/masonry.h"
#include "support/models.h"

#include <math.h>
#include <string.h>

/* What the dice decide before anything is laid. */
typedef struct Plan {
  GRand *random;
  QnMasonry masonry;
  const char *kind;
  int openings;
} Plan;

static double
between (Plan *plan, double least, double most)
{
  return g_rand_double_range (plan->random, least, most);
}

/* One draw at a time: in which order the arguments of a call are computed is the compiler's choice. */
static QnVec2
place_between (Plan *plan, QnVec2 least, QnVec2 most)
{
  double y = between (plan, least.y, most.y);
  return qn_vec2 (between (plan, least.x, most.x), y);
}

/* Evenly distributed powers of ten. */
static double
power_between (Plan *plan, double least, double most)
{
  return pow (10, between (plan, log10 (least), log10 (most)));
}

static bool
one_in (Plan *plan, int count)
{
  return g_rand_int_range (plan->random, 0, count) == 0;
}

static void
begin (Plan *plan, QnMasonryKind kind, const char *name)
{
  qn_masonry_init (&plan->masonry, kind, "w");
  plan->masonry.unit_weight = 20000;
  plan->masonry.foundation = 0.3;
  plan->kind = name;
}

static void
plan_opening (Plan *plan, int index, int count)
{
  QnMasonryWall *wall = &plan->masonry.wall;
  double length = wall->leaves[0].length, height = wall->height, part = length / count;
  QnOpening *opening = qn_masonry_add_opening (&plan->masonry);

  opening->width = between (plan, 0.3, 0.5) * part;
  opening->height = between (plan, 0.25, 0.45) * height;
  opening->at.y = one_in (plan, 2) ? 0 : between (plan, 0.1, 0.3) * height;
  opening->at.x = part * (index + between (plan, 0.25, 0.75)) - opening->width / 2;
  opening->depth = between (plan, 0.6, 1.2) * wall->leaves[0].unit.y;
  switch (g_rand_int_range (plan->random, 0, 4)) {
  case 0:
    opening->span = QN_SPAN_LINTEL;
    opening->bearing = between (plan, 0.3, 0.6) * wall->leaves[0].unit.x;
    break;
  case 1:
    opening->span = QN_SPAN_FLAT_ARCH;
    opening->voussoirs = 2 * g_rand_int_range (plan->random, 1, 4) + 1;
    opening->skew = between (plan, 0.1, 0.4);
    break;
  case 2:
    opening->head = QN_HEAD_SEGMENTAL;
    opening->rise = between (plan, 0.15, 0.4) * opening->width;
    opening->span = QN_SPAN_VOUSSOIRS;
    opening->voussoirs = 2 * g_rand_int_range (plan->random, 1, 4) + 1;
    opening->sides = one_in (plan, 2) ? QN_SIDES_STRAIGHT : QN_SIDES_CURVED;
    break;
  default: /* the fabric itself is cut and corbels over the opening */
    opening->width = fmin (opening->width, 0.9 * wall->leaves[0].unit.x);
    break;
  }
}

static void
plan_wall (Plan *plan)
{
  static const QnBond bonds[] = { QN_BOND_RUNNING, QN_BOND_RUNNING, QN_BOND_ENGLISH,
                                  QN_BOND_FLEMISH, QN_BOND_HEADER,  QN_BOND_STACK };
  static const char *const names[QN_BOND_COUNT] = { "running bond", "stack bond",
                                                    "header bond", "English bond",
                                                    "Flemish bond" };
  QnBond bond = bonds[g_rand_int_range (plan->random, 0, G_N_ELEMENTS (bonds))];

  begin (plan, QN_MASONRY_WALL, names[bond]);
  QnMasonryWall *wall = &plan->masonry.wall;
  QnLeaf *leaf = &wall->leaves[0];
  leaf->bond = bond;
  leaf->unit = place_between (plan, qn_vec2 (0.3, 0.12), qn_vec2 (0.6, 0.3));
  leaf->lap = one_in (plan, 3) ? between (plan, 0.2, 0.45) : 0.5;
  leaf->closer = (QnCloser) g_rand_int_range (plan->random, 0, QN_CLOSER_COUNT);
  leaf->length = between (plan, 2, 6) * leaf->unit.x;
  wall->height = g_rand_int_range (plan->random, 4, 12) * leaf->unit.y;
  wall->minimum_piece = 0.25;
  wall->left = one_in (plan, 4) ? QN_EDGE_TOOTHED : QN_EDGE_STRAIGHT;
  plan->openings = bond == QN_BOND_STACK ? 0 : g_rand_int_range (plan->random, 0, 3);
  for (int i = 0; i < plan->openings; i++)
    plan_opening (plan, i, plan->openings);
}

static void
plan_courses (Plan *plan)
{
  begin (plan, QN_MASONRY_WALL, "random courses");
  QnMasonryWall *wall = &plan->masonry.wall;
  double length = between (plan, 3, 6);
  int courses = g_rand_int_range (plan->random, 4, 12);

  wall->leaves[0].bond = QN_BOND_CUSTOM;
  wall->leaves[0].unit = place_between (plan, qn_vec2 (0.3, 0.12), qn_vec2 (0.6, 0.3));
  for (int course = 0; course < courses; course++) {
    double lengths[16], left = length;
    size_t count = 0;
    while (left > 1.7) {
      lengths[count] = between (plan, 0.6, 1.5);
      left -= lengths[count++];
    }
    lengths[count++] = left;
    g_assert_true (qn_wall_add_course (&wall->courses, lengths, count));
  }
}

static void
plan_rubble (Plan *plan)
{
  begin (plan, QN_MASONRY_RUBBLE, "rubble");
  QnRubble *rubble = &plan->masonry.rubble;
  rubble->stone = between (plan, 0.25, 0.5);
  rubble->width = between (plan, 2, 6) * rubble->stone;
  rubble->top = one_in (plan, 2) ? rubble->width : between (plan, 0.6, 1) * rubble->width;
  rubble->height = between (plan, 2, 7) * rubble->stone;
  rubble->irregularity = between (plan, 0, 1);
  rubble->seed = g_rand_int (plan->random);
}

static void
plan_arch (Plan *plan)
{
  begin (plan, QN_MASONRY_ARCH, "arch");
  QnArch *arch = &plan->masonry.arch;
  arch->shape = (QnArchShape) g_rand_int_range (plan->random, 0, QN_ARCH_SHAPE_COUNT);
  arch->span = between (plan, 2, 5);
  arch->rise = arch->span
               * (arch->shape == QN_ARCH_CIRCULAR  ? between (plan, 0.15, 0.5)
                  : arch->shape == QN_ARCH_POINTED ? between (plan, 0.55, 0.9)
                                                   : between (plan, 0.3, 0.6));
  arch->ring = between (plan, 0.1, 0.2) * arch->span;
  arch->voussoirs = g_rand_int_range (plan->random, 7, 30);
  arch->sides = one_in (plan, 2) ? QN_SIDES_STRAIGHT : QN_SIDES_CURVED;
  arch->springer = one_in (plan, 2) ? 0.3 : 0;
}

static void
plan_portal (Plan *plan)
{
  begin (plan, QN_MASONRY_PORTAL, "portal");
  QnPortal *portal = &plan->masonry.portal;
  portal->bays = g_rand_int_range (plan->random, 1, 4);
  portal->span = between (plan, 1, 2.5);
  portal->pier_width = between (plan, 0.6, 1.2);
  portal->pier_height = between (plan, 1, 3);
  portal->courses = g_rand_int_range (plan->random, 2, 8);
  if (one_in (plan, 2))
    portal->lintel_height = between (plan, 0.2, 0.5);
  portal->arch.rise = between (plan, 0.2, 0.5) * portal->span;
  portal->arch.ring = 0.45 * portal->pier_width;
  portal->arch.voussoirs = g_rand_int_range (plan->random, 5, 12);
}

static void
plan_buttress (Plan *plan)
{
  begin (plan, QN_MASONRY_BUTTRESS, "buttress");
  QnButtress *buttress = &plan->masonry.buttress;
  buttress->height = between (plan, 2, 6);
  buttress->bottom = between (plan, 0.8, 1.5);
  buttress->top = between (plan, 0.3, 0.8);
  buttress->courses = g_rand_int_range (plan->random, 8, 40);
  buttress->leans_right = one_in (plan, 2);
}

static void
plan_masonry (Plan *plan)
{
  int die = g_rand_int_range (plan->random, 0, 20);

  if (die < 9)
    plan_wall (plan);
  else if (die < 12)
    plan_courses (plan);
  else if (die < 17)
    plan_rubble (plan);
  else if (die < 18)
    plan_arch (plan);
  else if (die < 19)
    plan_portal (plan);
  else
    plan_buttress (plan);
  plan->masonry.law = 0;
}

static void
plan_joints (Plan *plan, QnModel *model)
{
  QnLaw *law = &model->laws[0];
  double weight = 20000 * 0.4 * 0.2; /* of a common block */

  law->kn = power_between (plan, 1e6, 1e10);
  law->ks = law->kn * power_between (plan, 0.1, 1);
  law->friction = between (plan, 0.3, 1.1);
  if (one_in (plan, 5)) {
    law->cohesion = power_between (plan, 0.01, 1) * weight;
    law->tension = one_in (plan, 2) ? between (plan, 0, 1) * law->cohesion : 0;
  }
  if (one_in (plan, 6)) {
    model->contact.pairs.placement =
      one_in (plan, 2) ? QN_PLACEMENT_UNIFORM : QN_PLACEMENT_GAUSS;
    model->contact.pairs.count = g_rand_int_range (plan->random, 2, 5);
  }
}

static void
plan_loads (Plan *plan, QnModel *model)
{
  double slope = one_in (plan, 4) ? between (plan, -0.5, 0.5) : 0;

  test_model_add_weight_loads (model, one_in (plan, 2) ? 1 : -1);
  model->live_loads[0].vector.y = slope;
  if (one_in (plan, 6)) {
    QnLoad *load = qn_model_add_live_load (model);
    load->kind = QN_LOAD_FORCE;
    load->block = (QnId) model->block_count - 1 - (QnId) one_in (plan, 2);
    load->vector = place_between (plan, qn_vec2 (-2000, -4000), qn_vec2 (2000, 0));
  }
  model->analysis.increments = 10;
}

/* The blocks stand on their own: nothing else is known of the object they came from. */
static void
forget_masonry (QnModel *model)
{
  for (size_t i = 0; i < model->block_count; i++)
    model->blocks[i].masonry = QN_NONE;
}

/* Whether this is a structure to be analysed, and of the size that is wanted. */
static bool
is_sound (const QnModel *model)
{
  QnModel copy;
  QnContacts contacts = { 0 };
  bool sound = model->block_count >= STRESS_FEWEST_BLOCKS
               && model->block_count <= STRESS_MOST_BLOCKS
               && qn_model_copy (model, &copy, NULL) == QN_OK;

  if (!sound)
    return false;
  sound = qn_model_prepare (&copy, NULL) == QN_OK
          && qn_contacts_detect (&copy, &contacts, NULL) == QN_OK
          && qn_contacts_require_sound (&copy, &contacts, NULL) == QN_OK;
  qn_contacts_clear (&contacts);
  qn_model_clear (&copy);
  return sound;
}

/* One draw. False where the dice fell so that nothing can be laid, or too much. */
static bool
draw (Plan *plan, QnModel *model, GString *text)
{
  double lean = one_in (plan, 4) ? between (plan, -0.15, 0.15) : 0;
  double turn = one_in (plan, 4) ? between (plan, -G_PI, G_PI) : 0;

  test_model_init (model);
  plan_masonry (plan);
  plan->masonry.rotation = lean;
  bool laid = qn_masonry_expand (&plan->masonry, 0, model, NULL) == QN_OK;
  forget_masonry (model);
  if (laid) {
    plan_joints (plan, model);
    plan_loads (plan, model);
    if (turn != 0)
      test_model_rotate (model, turn);
    laid = is_sound (model);
  }
  g_string_append (text, plan->kind);
  if (plan->openings > 0)
    g_string_append_printf (text, ", %d opening%s", plan->openings,
                            plan->openings > 1 ? "s" : "");
  if (lean != 0)
    g_string_append_printf (text, ", leaning by %.3g", lean);
  if (turn != 0)
    g_string_append_printf (text, ", turned by %.3g", turn);
  qn_masonry_clear (&plan->masonry);
  return laid;
}

void
stress_random_wall (guint32 seed, QnModel *model, char *description, gsize size)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (seed);
  g_autoptr (GString) text = g_string_new (NULL);

  for (int attempt = 0; attempt < 100; attempt++) {
    Plan plan = { .random = random };
    g_string_truncate (text, 0);
    if (draw (&plan, model, text)) {
      g_strlcpy (description, text->str, size);
      return;
    }
    qn_model_clear (model);
  }
  g_error ("seed %u: nothing that can be laid in a hundred draws", seed);
}
