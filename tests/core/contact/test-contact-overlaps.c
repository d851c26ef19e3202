#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

#define MAX_VERTICES 8

typedef struct {
  const char *name;
  size_t a_count, b_count;
  QnVec2 a[MAX_VERTICES], b[MAX_VERTICES];
  double depth; /* exact where both are convex, at least this where not; 0 = none */
  bool exact;
} Case;

#define SQUARE(x, y, w, h)                                                               \
  {                                                                                      \
    { x, y }, { x + w, y }, { x + w, y + h },                                            \
    {                                                                                    \
      x, y + h                                                                           \
    }                                                                                    \
  }
#define L_SHAPE                                                                          \
  {                                                                                      \
    { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 3 },                                    \
    {                                                                                    \
      0, 3                                                                               \
    }                                                                                    \
  }
#define U_SHAPE                                                                          \
  {                                                                                      \
    { 0, 0 }, { 5, 0 }, { 5, 3 }, { 4, 3 }, { 4, 1 }, { 1, 1 }, { 1, 3 },                \
    {                                                                                    \
      0, 3                                                                               \
    }                                                                                    \
  }

static const Case cases[] = {
  { "side-by-side", 4, 4, SQUARE (0, 0, 1, 1), SQUARE (1, 0, 1, 1), 0, true },
  { "corner-to-corner", 4, 4, SQUARE (0, 0, 1, 1), SQUARE (1, 1, 1, 1), 0, true },
  { "pushed-in", 4, 4, SQUARE (0, 0, 1, 1), SQUARE (0.9, 0, 1, 1), 0.1, true },
  { "corner-in", 4, 4, SQUARE (0, 0, 1, 1), SQUARE (0.8, 0.7, 1, 1), 0.2, true },
  { "cross", 4, 4, SQUARE (-2, 0, 5, 1), SQUARE (0, -2, 1, 5), 3, true },
  { "equal", 4, 4, SQUARE (0, 0, 1, 1), SQUARE (0, 0, 1, 1), 1, true },
  { "contained", 4, 4, SQUARE (0, 0, 3, 3), SQUARE (1, 1, 1, 1), 2, true },
  { "contained-on-edge", 4, 4, SQUARE (0, 0, 3, 3), SQUARE (1, 0, 1, 1), 1, true },
  { "inscribed",
    4,
    4,
    SQUARE (-1, -1, 2, 2),
    { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } },
    0.5,
    false },
  { "beam-on-u", 8, 4, U_SHAPE, SQUARE (-1, 3, 7, 1), 0, false },
  { "block-in-u", 8, 4, U_SHAPE, SQUARE (1, 1, 3, 1), 0, false },
  { "block-loose-in-u", 8, 4, U_SHAPE, SQUARE (2, 1.5, 1, 1), 0, false },
  { "block-through-u", 8, 4, U_SHAPE, SQUARE (0.5, 1.5, 1, 1), 0.5, false },
  { "block-sunk-in-u", 8, 4, U_SHAPE, SQUARE (2, 0.8, 1, 1), 0.2, false },
  { "block-in-arm-of-u", 8, 4, U_SHAPE, SQUARE (4.25, 1.5, 0.5, 1), 0.25, false },
  { "block-in-corner", 6, 4, L_SHAPE, SQUARE (1, 1, 1, 1), 0, false },
  { "equal-l", 6, 6, L_SHAPE, L_SHAPE, 0.2, false },
  { "two-l",
    6,
    6,
    L_SHAPE,
    { { 4, 4 }, { 1, 4 }, { 1, 3 }, { 3, 3 }, { 3, 1 }, { 4, 1 } },
    0,
    false },
  { "far-apart-in-boxes", 6, 4, L_SHAPE, SQUARE (2, 2, 0.5, 0.5), 0, false },
};

static void
detect (const Case *c, QnModel *model, QnContacts *contacts, bool swapped, double angle,
        double scale)
{
  test_model_init (model);
  for (int i = 0; i < 2; i++) {
    bool first = (i == 0) != swapped;
    QnBlock *block = qn_model_add_block (model, first ? "a" : "b", first ? c->a : c->b,
                                         first ? c->a_count : c->b_count);
    block->thickness = 1;
    block->support[0] = true;
  }
  test_model_scale (model, scale);
  test_model_rotate (model, angle);
  test_detect (model, contacts);
}

static void
check_case (const Case *c, bool swapped, double angle, double scale)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnDiag diag;
  detect (c, &model, &contacts, swapped, angle, scale);
  if (c->depth == 0) {
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCKS_OVERLAP), ==, 0);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_NEAR_MISS_OVERLAP), ==,
                      0);
  } else {
    const QnFinding *overlap = test_the_finding (&contacts, QN_PROBLEM_BLOCKS_OVERLAP);
    g_assert_cmpint (overlap->block_a, ==, 0);
    g_assert_cmpint (overlap->block_b, ==, 1);
    if (c->exact)
      g_assert_cmpfloat_with_epsilon (overlap->value, c->depth * scale, 1e-9 * scale);
    else
      g_assert_cmpfloat (overlap->value, >, c->depth * scale / 2);

    /* The place lies in both blocks. */
    QnVec2 place =
      qn_vec2_scale (1 / scale, qn_vec2_rotate (overlap->at, cos (-angle), sin (-angle)));
    const QnVec2 *shapes[] = { c->a, c->b };
    const size_t counts[] = { c->a_count, c->b_count };
    for (int i = 0; i < 2; i++) {
      QnVec2 low = shapes[i][0], high = low;
      for (size_t v = 1; v < counts[i]; v++) {
        low = qn_vec2 (fmin (low.x, shapes[i][v].x), fmin (low.y, shapes[i][v].y));
        high = qn_vec2 (fmax (high.x, shapes[i][v].x), fmax (high.y, shapes[i][v].y));
      }
      g_assert_true (place.x > low.x - 1e-9 && place.x < high.x + 1e-9
                     && place.y > low.y - 1e-9 && place.y < high.y + 1e-9);
    }
    g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, &diag), ==,
                     QN_ERROR_INVALID);
    g_assert_cmpint (diag.problem, ==, QN_PROBLEM_BLOCKS_OVERLAP);
    g_assert_cmpint (diag.index, ==, 0);
    g_assert_cmpint (diag.other, ==, 1);
  }
}

static void
test_case (const void *data)
{
  const Case *c = data;
  for (int turn = 0; turn < 8; turn++) {
    check_case (c, false, turn * G_PI / 4, 1);
    check_case (c, true, turn * 0.7, 1);
  }
  check_case (c, false, 0.2, 1e-3);
  check_case (c, false, 0.2, 1e3);
}

/* Within the tolerance nothing, within ten of them a word, beyond an error. */
static void
test_thresholds (void)
{
  const double depths[] = { 0.9e-6, 5e-6, 20e-6 };
  for (int i = 0; i < 3; i++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init (&model);
    test_model_add_base (&model, 0, 0, 1, 1);
    test_model_add_rectangle (&model, "b", 1 - depths[i], 0, 1, 1);
    test_detect (&model, &contacts);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_NEAR_MISS_OVERLAP), ==,
                      i == 1);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCKS_OVERLAP), ==,
                      i == 2);
    g_assert_cmpuint (contacts.face_count, ==, i == 0);
  }
}

/* Random convex and concave blocks at random places: every overlap that a dense sample of points
 * knows of is found, and no other is reported. */
static void
test_against_sampling (void)
{
  GRand *random = g_rand_new_with_seed (11);
  for (int round = 0; round < 60; round++) {
    Case c = { .a_count = 6, .b_count = 6 };
    const QnVec2 l[] = L_SHAPE;
    double angle_a = g_rand_double_range (random, 0, 6), angle_b = angle_a + round;
    QnVec2 shift = { g_rand_double_range (random, -3, 3),
                     g_rand_double_range (random, -3, 3) };
    for (int i = 0; i < 6; i++) {
      c.a[i] = qn_vec2_rotate (l[i], cos (angle_a), sin (angle_a));
      c.b[i] = qn_vec2_add (shift, qn_vec2_rotate (l[i], cos (angle_b), sin (angle_b)));
    }

    bool sampled = false;
    for (double x = 0.01; x < 3 && !sampled; x += 0.02) {
      for (double y = 0.01; y < 3; y += 0.02) {
        if (x > 1 && y > 1)
          continue;
        QnVec2 p = qn_vec2_rotate (qn_vec2 (x, y), cos (angle_a), sin (angle_a));
        QnVec2 q =
          qn_vec2_rotate (qn_vec2_sub (p, shift), cos (-angle_b), sin (-angle_b));
        sampled =
          sampled || (q.x > 0 && q.y > 0 && q.x < 3 && q.y < 3 && (q.x < 1 || q.y < 1));
      }
    }

    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    detect (&c, &model, &contacts, false, 0, 1);
    size_t found = test_count_findings (&contacts, QN_PROBLEM_BLOCKS_OVERLAP);
    if (sampled)
      g_assert_cmpuint (found, ==, 1);
    else if (found > 0) /* too small for the sample's raster of 0.02 */
      g_assert_cmpfloat (test_the_finding (&contacts, QN_PROBLEM_BLOCKS_OVERLAP)->value,
                         <, 0.03);
  }
  g_rand_free (random);
}

/* A ground of thousands of vertices under thousands of stones, some of them sunk: found as among
 * few, and in no time (all pairs would be 1e8). */
static void
test_rough_ground (void)
{
  enum { TEETH = 2500, STONES = 2500 };
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_autofree QnVec2 *ground = g_new (QnVec2, 4 * TEETH + 2);
  /* Teeth 1 wide and 0.5 high, 1 apart, from right to left. */
  for (int i = 0; i < TEETH; i++) {
    double x = 2.0 * (TEETH - 1 - i);
    ground[4 * i] = qn_vec2 (x + 1.5, 0);
    ground[4 * i + 1] = qn_vec2 (x + 1.5, 0.5);
    ground[4 * i + 2] = qn_vec2 (x + 0.5, 0.5);
    ground[4 * i + 3] = qn_vec2 (x + 0.5, 0);
  }
  ground[4 * TEETH] = qn_vec2 (0, -5);
  ground[4 * TEETH + 1] = qn_vec2 (2.0 * TEETH, -5);

  test_model_init (&model);
  QnBlock *block = qn_model_add_block (&model, "ground", ground, 4 * TEETH + 2);
  block->thickness = 1;
  block->support[0] = true;
  for (int i = 0; i < STONES; i++) {
    char name[16];
    g_snprintf (name, sizeof name, "s%d", i);
    double sunk = i % 10 == 0 ? 0.1 : 0;
    test_model_add_rectangle (&model, name, 2.0 * i + 0.6, 0.5 - sunk, 0.8, 0.4);
  }
  test_detect (&model, &contacts);

  g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCKS_OVERLAP), ==,
                    STONES / 10);
  g_assert_cmpuint (contacts.face_count, ==, STONES - STONES / 10);
  for (size_t i = 0; i < contacts.findings.count; i++) {
    if (contacts.findings.items[i].problem == QN_PROBLEM_BLOCKS_OVERLAP)
      g_assert_cmpfloat_with_epsilon (contacts.findings.items[i].value, 0.1, 1e-12);
  }
}

/* Of places that are equally deep it is always the same one that is reported: a block far away,
 * which makes another tree of all boxes, changes nothing. */
static void
test_place_of_ties (void)
{
  enum { MANY = 80 };
  QnVec2 places[2];
  for (int far = 0; far < 2; far++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init (&model);
    for (int disc = 0; disc < 2; disc++) {
      QnVec2 v[MANY];
      for (int i = 0; i < MANY; i++)
        v[i] = qn_vec2 ((1 - 0.8 * disc) * cos (2 * G_PI * i / MANY),
                        (1 - 0.8 * disc) * sin (2 * G_PI * i / MANY));
      qn_model_add_block (&model, disc == 0 ? "large" : "small", v, MANY)->thickness = 1;
    }
    if (far)
      for (int i = 0; i < MANY; i++) {
        g_autofree char *name = g_strdup_printf ("far%d", i);
        test_model_add_rectangle (&model, name, 40 + 2 * i, -90 + 3 * i, 1, 1);
      }
    test_detect (&model, &contacts);
    places[far] = test_the_finding (&contacts, QN_PROBLEM_BLOCKS_OVERLAP)->at;
  }
  g_assert_cmpfloat (places[0].x, ==, places[1].x);
  g_assert_cmpfloat (places[0].y, ==, places[1].y);
}

QN_TESTS
{
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *path = g_strconcat ("/contact-overlaps/", cases[i].name, NULL);
    g_test_add_data_func (path, &cases[i], test_case);
  }
  g_test_add_func ("/contact-overlaps/thresholds", test_thresholds);
  g_test_add_func ("/contact-overlaps/rough-ground", test_rough_ground);
  g_test_add_func ("/contact-overlaps/place-of-ties", test_place_of_ties);
  g_test_add_func ("/contact-overlaps/against-sampling", test_against_sampling);
}
