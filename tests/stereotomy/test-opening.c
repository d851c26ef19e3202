#include "stereotomy/masonry.h"
#include "stereotomy/sound.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <glib.h>

#define LENGTH 4.0
#define HEIGHT 3.0

static void
init_wall (QnMasonry *masonry, QnBond bond)
{
  qn_masonry_init (masonry, QN_MASONRY_WALL, "w");
  masonry->wall.height = HEIGHT;
  masonry->wall.leaves[0].length = LENGTH;
  masonry->wall.leaves[0].unit = qn_vec2 (0.5, 0.25);
  masonry->wall.leaves[0].bond = bond;
  masonry->unit_weight = 20000;
  masonry->law = 0;
}

/* Area and perimeter of a hole within the wall, from closed forms. */
static void
measure_hole (const QnOpening *opening, double *area, double *perimeter)
{
  double w = opening->width, h = opening->height;
  if (opening->head == QN_HEAD_FLAT) {
    *area = w * h;
    *perimeter = 2 * (w + h);
    return;
  }
  double rise = opening->head == QN_HEAD_SEGMENTAL ? opening->rise : w / 2;
  double radius = (w * w / 4 + rise * rise) / (2 * rise);
  double angle = atan2 (w / 2, radius - rise);
  /* Segment of a regular polygon in the circle: as many chords as the program says it takes. */
  int parts = opening->span == QN_SPAN_VOUSSOIRS ? opening->voussoirs : 12;
  int chords = opening->span == QN_SPAN_VOUSSOIRS && opening->sides == QN_SIDES_STRAIGHT
                 ? 1
                 : (int) ceil (2 * angle / parts / (2 * acos (1 - 0.002)));
  double n = parts * chords;
  *area = n / 2 * radius * radius * sin (2 * angle / n) - w / 2 * (radius - rise)
          + w * (h - rise);
  *perimeter = n * 2 * radius * sin (angle / n) + w + 2 * (h - rise);
}

/* A wall with one opening inside: the joints are half of what the perimeters of the blocks exceed
 * the boundary by. */
static void
assert_wall_sound (QnModel *model, const QnOpening *opening)
{
  double area, perimeter;
  measure_hole (opening, &area, &perimeter);
  double joints = test_assert_sound (model, LENGTH * HEIGHT - area);
  double boundary = 2 * (LENGTH + HEIGHT) + perimeter;
  g_assert_cmpfloat_with_epsilon (joints, (test_sound_perimeters (model) - boundary) / 2,
                                  1e-8);
}

static void
test_kinds (void)
{
  const QnOpening kinds[] = {
    { .width = 1.03, .height = 1.2 },
    { .width = 1.03,
      .height = 1.2,
      .span = QN_SPAN_LINTEL,
      .depth = 0.3,
      .bearing = 0.2 },
    { .width = 1.03,
      .height = 1.2,
      .span = QN_SPAN_FLAT_ARCH,
      .depth = 0.3,
      .voussoirs = 7,
      .skew = 0.3,
      .sill_height = 0.1,
      .sill_bearing = 0.07 },
    { .width = 1.03, .height = 1.2, .head = QN_HEAD_SEGMENTAL, .rise = 0.2 },
    { .width = 1.03,
      .height = 1.2,
      .head = QN_HEAD_SEGMENTAL,
      .rise = 0.2,
      .span = QN_SPAN_VOUSSOIRS,
      .depth = 0.25,
      .voussoirs = 7 },
    { .width = 1.03,
      .height = 1.2,
      .head = QN_HEAD_SEMICIRCULAR,
      .span = QN_SPAN_VOUSSOIRS,
      .depth = 0.25,
      .voussoirs = 9,
      .sides = QN_SIDES_STRAIGHT },
    { .width = 0.8, .height = 0.4, .head = QN_HEAD_SEMICIRCULAR },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_auto (QnMasonry) masonry;
    g_auto (QnModel) model;
    init_wall (&masonry, QN_BOND_RUNNING);
    QnOpening *opening = qn_masonry_add_opening (&masonry);
    *opening = kinds[i];
    opening->at = qn_vec2 (1.37, 0.61);
    test_sound_init (&model);
    g_assert_cmpint (qn_masonry_expand (&masonry, 0, &model, NULL), ==, QN_OK);
    if (opening->span == QN_SPAN_LINTEL)
      g_assert_cmpint (qn_model_find_block (&model, "w.o1.lintel"), !=, QN_NONE);
    if (opening->span >= QN_SPAN_FLAT_ARCH)
      g_assert_cmpint (qn_model_find_block (&model, "w.o1.v7"), !=, QN_NONE);
    if (opening->sill_height > 0)
      g_assert_cmpint (qn_model_find_block (&model, "w.o1.sill"), !=, QN_NONE);
    assert_wall_sound (&model, opening);
  }
}

static void
assert_refused (const QnOpening *openings, size_t count, QnProblem problem,
                const char *field, QnId sub)
{
  g_auto (QnMasonry) masonry;
  g_auto (QnModel) model;
  QnDiag diag = { 0 };
  init_wall (&masonry, QN_BOND_RUNNING);
  for (size_t i = 0; i < count; i++)
    *qn_masonry_add_opening (&masonry) = openings[i];
  test_sound_init (&model);
  g_assert_cmpint (qn_masonry_expand (&masonry, 3, &model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, problem);
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_MASONRY);
  g_assert_cmpint (diag.index, ==, 3);
  g_assert_cmpint (diag.sub, ==, sub);
  g_assert_cmpstr (diag.field, ==, field);
}

static void
test_refuses (void)
{
  QnOpening door = { .at = { 1, 0 }, .width = 1, .height = 2 };
  QnOpening other = { .at = { 1.9, 1 }, .width = 1, .height = 1 };
  assert_refused ((QnOpening[]){ door, other }, 2, QN_PROBLEM_OPENINGS_OVERLAP,
                  "openings", 1);
  QnOpening bad = door;
  bad.width = -1;
  assert_refused (&bad, 1, QN_PROBLEM_NOT_POSITIVE, "width", 0);
  bad = door;
  bad.at.x = NAN;
  assert_refused (&bad, 1, QN_PROBLEM_NOT_FINITE, "at", 0);
  bad = door;
  bad.height = 1e300;
  assert_refused (&bad, 1, QN_PROBLEM_TOO_LARGE, "height", 0);
  bad = door;
  bad.span = QN_SPAN_VOUSSOIRS;
  assert_refused (&bad, 1, QN_PROBLEM_OPENING_SPAN, "span", 0);
  bad = door;
  bad.head = QN_HEAD_SEGMENTAL;
  bad.rise = 0.6;
  assert_refused (&bad, 1, QN_PROBLEM_ARCH_SHAPE, "rise", 0);
  bad = door;
  bad.span = QN_SPAN_LINTEL;
  bad.depth = 0.2;
  bad.bearing = 1.2;
  assert_refused (&bad, 1, QN_PROBLEM_OPENING_OUTSIDE, "openings", 0);
  for (int side = 0; side < 4;
       side++) { /* beside, below and above: touching, it cuts nothing */
    bad = door;
    bad.at = (QnVec2[]){ { -1, 0 }, { 100, 0 }, { 1, -2 }, { 1, 100 } }[side];
    assert_refused (&bad, 1, QN_PROBLEM_OPENING_MISSES, "openings", 0);
  }
  bad = door;
  bad.span = QN_SPAN_FLAT_ARCH;
  bad.depth = 0.2;
  bad.voussoirs = 0;
  assert_refused (&bad, 1, QN_PROBLEM_NOT_POSITIVE, "voussoirs", 0);
}

/* Two windows side by side and a door up to the edge of the wall. */
static void
test_neighbours (void)
{
  g_auto (QnMasonry) masonry;
  g_auto (QnModel) model;
  init_wall (&masonry, QN_BOND_FLEMISH);
  *qn_masonry_add_opening (&masonry) =
    (QnOpening){ .at = { 1, 1 }, .width = 0.5, .height = 1 };
  *qn_masonry_add_opening (&masonry) =
    (QnOpening){ .at = { 1.5, 1 }, .width = 0.5, .height = 1 };
  *qn_masonry_add_opening (&masonry) =
    (QnOpening){ .at = { 3.3, -1 }, .width = 2, .height = 2 };
  test_sound_init (&model);
  g_assert_cmpint (qn_masonry_expand (&masonry, 0, &model, NULL), ==, QN_OK);
  test_assert_sound (&model, LENGTH * HEIGHT - 1 - 0.7);
}

static QnOpening
random_opening (GRand *rand)
{
  QnOpening opening = { .at = { g_rand_double_range (rand, 0.5, 2.3),
                                g_rand_double_range (rand, 0.2, 1.2) },
                        .width = g_rand_double_range (rand, 0.2, 1.2),
                        .head = (QnHead) g_rand_int_range (rand, 0, QN_HEAD_COUNT),
                        .depth = g_rand_double_range (rand, 0.1, 0.4),
                        .bearing = g_rand_double_range (rand, 0, 0.4),
                        .voussoirs = g_rand_int_range (rand, 2, 14),
                        .skew = g_rand_double_range (rand, 0, 0.5),
                        .sides = (QnSides) g_rand_int_range (rand, 0, QN_SIDES_COUNT) };
  opening.height = g_rand_double_range (rand, opening.width / 2 + 0.01, 1.3);
  opening.rise = g_rand_double_range (rand, 0.05, 0.49) * opening.width;
  if (g_rand_boolean (rand))
    opening.span = opening.head != QN_HEAD_FLAT ? QN_SPAN_VOUSSOIRS
                   : g_rand_boolean (rand)      ? QN_SPAN_LINTEL
                                                : QN_SPAN_FLAT_ARCH;
  if (g_rand_boolean (rand)) {
    opening.sill_height = g_rand_double_range (rand, 0.02, 0.2);
    opening.sill_bearing = g_rand_double_range (rand, 0, 0.3);
  }
  return opening;
}

/* Dimensions as people give them meet joints and each other exactly, or but for rounding. */
static void
round_opening (QnOpening *opening)
{
  double *numbers[] = { &opening->at.x,  &opening->at.y,       &opening->width,
                        &opening->depth, &opening->height,     &opening->bearing,
                        &opening->rise,  &opening->sill_height };
  for (size_t i = 0; i < G_N_ELEMENTS (numbers); i++)
    *numbers[i] = fmax (1, round (*numbers[i] / 0.05)) * 0.05;
  opening->width = fmax (opening->width, 0.4);
  opening->height = fmax (opening->height, opening->width / 2 + 0.05);
  opening->rise = fmin (opening->rise, opening->width / 4);
  opening->skew = 0.25;
}

/* Random openings in random bonds: 250 places quickly, 10,000 in the slow suite. Every other one
 * has round dimensions. */
static void
test_random (void)
{
  int count = g_test_slow () ? 10000 : 250;
  g_autoptr (GRand) rand = g_rand_new_with_seed (20011115);
  for (int i = 0; i < count; i++) {
    g_auto (QnMasonry) masonry;
    g_auto (QnModel) model;
    init_wall (&masonry, (QnBond) g_rand_int_range (rand, 0, QN_BOND_CUSTOM));
    QnLeaf *leaf = &masonry.wall.leaves[0];
    leaf->unit = qn_vec2 (g_rand_double_range (rand, 0.2, 0.7),
                          g_rand_double_range (rand, 0.1, 0.35));
    leaf->lap = g_rand_double_range (rand, 0.2, 0.8);
    leaf->closer = (QnCloser) g_rand_int_range (rand, 0, QN_CLOSER_COUNT);
    masonry.wall.minimum_piece = g_rand_double_range (rand, 0, 0.4);
    QnOpening *opening = qn_masonry_add_opening (&masonry);
    *opening = random_opening (rand);
    if (i % 2 == 0) {
      round_opening (opening);
      leaf->unit = qn_vec2 (0.4, i % 4 == 0 ? 0.2 : 0.1);
      leaf->lap = 0.5;
    }
    test_sound_init (&model);
    QnDiag diag = { 0 };
    QnStatus status = qn_masonry_expand (&masonry, 0, &model, &diag);
    if (status != QN_OK)
      g_error ("place %d: %s (%s)", i, qn_problem_text (diag.problem),
               diag.field != NULL ? diag.field : "");
    assert_wall_sound (&model, opening);
  }
}

QN_TESTS
{
  g_test_add_func ("/opening/kinds", test_kinds);
  g_test_add_func ("/opening/refuses", test_refuses);
  g_test_add_func ("/opening/neighbours", test_neighbours);
  g_test_add_func ("/opening/random", test_random);
}
