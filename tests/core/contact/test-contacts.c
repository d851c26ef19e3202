#include "core/base/polygon.h"
#include "support/contacts.h"
#include "support/models.h"
#include "support/room.h"
#include "support/walls.h"

#include <glib.h>

/* The six walls as published: blocks and faces. */
static void
test_published_walls (void)
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init_wall (&model, number, 0);
    test_detect (&model, &contacts);
    g_assert_cmpuint (model.block_count, ==, test_walls[number - 1].blocks + 1);
    g_assert_cmpuint (contacts.face_count, ==, test_walls[number - 1].faces);
    g_assert_cmpuint (contacts.pair_count, ==, 2 * contacts.face_count);
    g_assert_cmpuint (contacts.findings.count, ==, 0);
    g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, NULL), ==, QN_OK);
  }
}

/* One line per face, independent of the numbering: names in alphabetical order, middle, length
 * and normal, as seen before the model was scaled, turned by `angle` and moved by `shift`. */
typedef struct {
  const char *first, *second;
  QnVec2 middle, normal;
  double length;
} Line;

static int
compare_lines (const void *a, const void *b)
{
  const Line *l = a, *r = b;
  int order = g_strcmp0 (l->first, r->first);
  if (order == 0)
    order = g_strcmp0 (l->second, r->second);
  return order;
}

static Line *
describe (const QnModel *model, const QnContacts *contacts, double scale, double angle,
          QnVec2 shift)
{
  Line *lines = g_new0 (Line, contacts->face_count);
  for (size_t i = 0; i < contacts->face_count; i++) {
    const QnContactFace *face = &contacts->faces[i];
    const char *a = model->blocks[face->a].name, *b = model->blocks[face->b].name;
    bool ordered = g_strcmp0 (a, b) < 0;
    QnVec2 middle = qn_vec2_sub (qn_vec2_lerp (face->start, face->end, 0.5), shift);
    middle = qn_vec2_rotate (middle, cos (-angle), sin (-angle));
    lines[i].first = ordered ? a : b;
    lines[i].second = ordered ? b : a;
    lines[i].middle = qn_vec2_scale (1 / scale, middle);
    lines[i].normal = qn_vec2_rotate (qn_vec2_scale (ordered ? 1 : -1, face->normal),
                                      cos (-angle), sin (-angle));
    lines[i].length = face->length / scale;
  }
  qsort (lines, contacts->face_count, sizeof *lines, compare_lines);
  return lines;
}

typedef struct {
  double scale, angle;
  QnVec2 shift;
  bool renumber;
  double tolerance; /* that rounding at these coordinates leaves, m of the original */
} Motion;

/* Findings of the geometry: numbers are doubted by their size. */
static guint
count_places (const QnContacts *contacts)
{
  guint count = 0;
  for (size_t i = 0; i < contacts->findings.count; i++)
    count += contacts->findings.items[i].problem < QN_PROBLEM_DOUBT_TANGENT;
  return count;
}

static void
check_same_faces (const QnModel *original, const QnContacts *expected, const Line *lines,
                  const Motion *motion, unsigned seed)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_assert_cmpint (qn_model_copy (original, &model, NULL), ==, QN_OK);
  if (motion->renumber)
    test_model_renumber (&model, seed);
  test_model_scale (&model, motion->scale);
  test_model_rotate (&model, motion->angle);
  test_model_translate (&model, motion->shift.x, motion->shift.y);
  test_detect (&model, &contacts);

  g_assert_cmpuint (contacts.face_count, ==, expected->face_count);
  g_assert_cmpuint (count_places (&contacts), ==, count_places (expected));
  g_autofree Line *moved =
    describe (&model, &contacts, motion->scale, motion->angle, motion->shift);
  for (size_t i = 0; i < contacts.face_count; i++) {
    g_assert_cmpstr (moved[i].first, ==, lines[i].first);
    g_assert_cmpstr (moved[i].second, ==, lines[i].second);
    g_assert_cmpfloat (qn_vec2_length (qn_vec2_sub (moved[i].middle, lines[i].middle)), <,
                       motion->tolerance);
    g_assert_cmpfloat (qn_vec2_length (qn_vec2_sub (moved[i].normal, lines[i].normal)), <,
                       10 * motion->tolerance);
    g_assert_cmpfloat_with_epsilon (moved[i].length, lines[i].length, motion->tolerance);
  }
}

/* Walls with openings, turned by any angle, moved by a million metres, scaled, renumbered: the
 * same faces. */
static void
test_invariance (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (3);
  for (unsigned seed = 1; seed <= 12; seed++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_bond_init (&model, TEST_UNIT, 6 + (int) seed, 15, (int) seed / 2, seed);
    test_detect (&model, &contacts);
    g_autofree Line *lines = describe (&model, &contacts, 1, 0, qn_vec2 (0, 0));

    double any = g_rand_double_range (random, 0, 2 * G_PI);
    const Motion motions[] = {
      { 1, any, { 0, 0 }, false, 1e-12 },
      { 1, G_PI / 4, { 0, 0 }, false, 1e-12 },
      { 1, 3 * G_PI / 4, { 0, 0 }, false, 1e-12 },
      { 1, 0, { 1e6, -1e6 }, false, 1e-8 },
      { 1, any, { -1e6, 1e6 }, true, 1e-8 },
      { 1e-3, 0, { 0, 0 }, false, 1e-12 },
      { 1e3, 0, { 0, 0 }, false, 1e-12 },
      { 1e-3, any, { 1e3, 0 }, true, 1e-8 },
      { 1e-3, any, { 1e6, 1e6 }, true, 1e-5 }, /* bricks of 0.4 mm in kilometres */
      { 1e3, any, { 1e6, 0 }, true, 1e-10 },
      { 1, 0, { 0, 0 }, true, 1e-12 },
    };
    for (size_t i = 0; i < G_N_ELEMENTS (motions); i++)
      check_same_faces (&model, &contacts, lines, &motions[i], seed);
  }
}

/* A rectangle cut by random straight lines, cell after cell, into convex pieces that fill it:
 * T-joints at every angle, slivers, corners of many valences. */
typedef struct {
  QnVec2 v[64];
  size_t count;
} Piece;

/* The part of a piece to the left of the line through `p` along `u`. */
static Piece
part_left_of (const Piece *piece, QnVec2 p, QnVec2 u)
{
  Piece part = { .count = 0 };
  for (size_t i = 0; i < piece->count; i++) {
    QnVec2 from = piece->v[i], to = piece->v[(i + 1) % piece->count];
    double left_from = qn_vec2_cross (u, qn_vec2_sub (from, p));
    double left_to = qn_vec2_cross (u, qn_vec2_sub (to, p));
    if (left_from >= 0)
      part.v[part.count++] = from;
    if ((left_from > 0 && left_to < 0) || (left_from < 0 && left_to > 0))
      part.v[part.count++] = qn_vec2_lerp (from, to, left_from / (left_from - left_to));
  }
  return part;
}

static void
fill_with_pieces (QnModel *model, size_t wanted, GRand *random)
{
  g_autofree Piece *pieces = g_new0 (Piece, wanted);
  pieces[0] = (Piece){ { { 0, 0 }, { 10, 0 }, { 10, 6 }, { 0, 6 } }, 4 };
  for (size_t count = 1; count < wanted; count++) {
    size_t i = (size_t) g_rand_int_range (random, 0, (gint32) count);
    QnVec2 middle = { 0, 0 };
    for (size_t v = 0; v < pieces[i].count; v++)
      middle =
        qn_vec2_add_scaled (middle, 1.0 / (double) pieces[i].count, pieces[i].v[v]);
    double angle = g_rand_double_range (random, 0, G_PI);
    QnVec2 u = { cos (angle), sin (angle) };
    Piece whole = pieces[i];
    pieces[i] = part_left_of (&whole, middle, u);
    pieces[count] = part_left_of (&whole, middle, qn_vec2_scale (-1, u));
  }
  for (size_t i = 0; i < wanted; i++) {
    g_autofree char *name = g_strdup_printf ("p%zu", i);
    QnBlock *block = qn_model_add_block (model, name, pieces[i].v, pieces[i].count);
    block->thickness = 1;
    block->support[QN_DOF_UY] = i == 0;
  }
}

/* Pieces that fill a rectangle: every piece of boundary is a joint of two blocks or outside, so
 * the faces account for all perimeters; nothing overlaps, gapes, floats or stands on a point. */
static void
test_faces_account_for_all_boundaries (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (17);
  for (int round = 0; round < 40; round++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    test_model_init (&model);
    model.contact.tolerance = 1e-9; /* pieces may be small against the median */
    fill_with_pieces (&model, 150, random);
    test_model_rotate (&model, round);
    test_detect (&model, &contacts);

    double joints = 0, perimeters = 0;
    for (size_t i = 0; i < contacts.face_count; i++)
      joints += contacts.faces[i].length;
    for (size_t i = 0; i < model.block_count; i++) {
      const QnVec2 *v = qn_model_block_vertices (&model, (QnId) i);
      size_t count = (size_t) model.blocks[i].vertex_count;
      for (size_t j = 0; j < count; j++)
        perimeters += qn_vec2_length (qn_vec2_sub (v[(j + 1) % count], v[j]));
    }
    g_assert_cmpfloat_with_epsilon (2 * joints + 32, perimeters, 1e-6);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCKS_OVERLAP), ==, 0);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_NEAR_MISS_OVERLAP), ==,
                      0);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_POINT_CONTACT), ==, 0);
    g_assert_cmpuint (test_count_findings (&contacts, QN_PROBLEM_BLOCK_FLOATING), ==, 0);
  }
}

/* Blocks thrown together: sizes over nine decades, polygons of any kind, heaps of them at one
 * place. Nothing is known of the answer but that there is one, and that it keeps its rules. */
static void
test_survives_anything (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (41);
  for (int trial = 0; trial < 300; trial++) {
    g_auto (QnModel) model;
    QnContacts contacts;
    test_model_init (&model);
    double far = trial % 5 == 0 ? 1e9 : 0;
    int count = g_rand_int_range (random, 1, 40);
    for (int i = 0; i < count; i++) {
      QnVec2 v[8];
      int corners = g_rand_int_range (random, 3, 9);
      double size = pow (10, g_rand_double_range (random, -6, trial % 3));
      QnVec2 place = { far + 3 * g_rand_double (random), 3 * g_rand_double (random) };
      bool snapped = g_rand_boolean (random);
      for (int k = 0; k < corners; k++) {
        double angle = 2 * G_PI * k / corners, radius = size * g_rand_double (random);
        v[k] = qn_vec2_add (place, qn_vec2 (radius * cos (angle), radius * sin (angle)));
        if (snapped)
          v[k] = qn_vec2 (round (v[k].x * 8) / 8, round (v[k].y * 8) / 8);
      }
      g_autofree char *name = g_strdup_printf ("b%d", i);
      if (qn_polygon_check (v, (size_t) corners).problem == QN_PROBLEM_NONE)
        qn_model_add_block (&model, name, v, (size_t) corners)->thickness = 1;
    }
    if (model.block_count > 0) {
      test_detect (&model, &contacts);
      qn_contacts_clear (&contacts);
    }
  }
}

static void
test_repeatable (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) first, second;
  test_model_init_wall (&model, 6, 0);
  test_model_rotate (&model, 0.3);
  test_detect (&model, &first);
  test_detect (&model, &second);
  test_assert_same_faces (&first, &second);
}

/* A drawing that has just been begun has no contacts, and no answer either. */
static void
test_empty_model (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnDiag diag;
  test_model_init (&model);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpuint (contacts.face_count + contacts.findings.count, ==, 0);
  g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, &diag), ==,
                   QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NO_BLOCKS);
}

/* Several problems at once: overlaps are told first, then missing supports, then loose blocks. */
static void
test_require_sound_order (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnDiag diag;
  test_model_init_stack (&model, 2, 1, 0.5);
  test_model_add_rectangle (&model, "loose", 10, 0, 1, 1);
  test_model_add_rectangle (&model, "intruder", 0.5, 0.25, 1, 1);
  test_detect (&model, &contacts);
  g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, &diag), ==,
                   QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_BLOCKS_OVERLAP);
  g_assert_cmpstr (model.blocks[diag.index].name, ==, "b1");
  g_assert_cmpstr (model.blocks[diag.other].name, ==, "intruder");
  g_assert_cmpfloat_with_epsilon (diag.value, 0.25, 1e-12);
}

static void
test_hundred_thousand_blocks (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  test_bond_init (&model, TEST_UNIT, 250, 400, 0, 0);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpuint (model.block_count, ==, 100201);
  /* perpends; beds of each block on two others; the lowest course on the base */
  size_t perpends = 200 * 249 + 200 * 250, beds = 399 * 500 + 250;
  g_assert_cmpuint (contacts.face_count, ==, perpends + beds);
}

QN_TESTS
{
  g_test_add_func ("/contacts/published-walls", test_published_walls);
  g_test_add_func ("/contacts/invariance", test_invariance);
  g_test_add_func ("/contacts/all-boundaries", test_faces_account_for_all_boundaries);
  g_test_add_func ("/contacts/survives-anything", test_survives_anything);
  g_test_add_func ("/contacts/repeatable", test_repeatable);
  g_test_add_func ("/contacts/empty-model", test_empty_model);
  g_test_add_func ("/contacts/require-sound-order", test_require_sound_order);
  g_test_add_func ("/contacts/hundred-thousand-blocks", test_hundred_thousand_blocks);
}
