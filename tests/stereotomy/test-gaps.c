#include "core/base/polygon.h"
#include "core/contact/contacts.h"
#include "stereotomy/gaps.h"
#include "stereotomy/masonry.h"
#include "stereotomy/polygon-ops.h"
#include "stereotomy/sound.h"
#include "support/room.h"

#include <glib.h>
#include <string.h>

/* Shorter joints between blocks may vanish in wide mortar. */
#define SHORT 0.05

typedef struct Joints {
  const char *name;
  double least, most; /* half a joint on either side, m */
  double turn;        /* of every block about its middle, at random up to this, rad */
} Joints;

static const Joints joints_of_mortar[] = {
  { "even", 0.005, 0.005, 0 },
  { "irregular", 0.0025, 0.01, 0 },
  { "by hand", 0.004, 0.008, 0.002 },
};

typedef struct Wall {
  QnModel model;
  QnContacts contacts;
  QnRings rings;
  double area; /* m2 */
} Wall;

static void
wall_clear (Wall *wall)
{
  qn_contacts_clear (&wall->contacts);
  qn_model_clear (&wall->model);
  qn_rings_clear (&wall->rings);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Wall, wall_clear)

/* Blocks that touch, and the same as rings. */
static void
lay (const QnMasonry *masonry, Wall *wall)
{
  QnDiag diag = { 0 };
  memset (wall, 0, sizeof *wall);
  test_sound_init (&wall->model);
  g_assert_cmpint (qn_masonry_expand (masonry, 0, &wall->model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_model_prepare (&wall->model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&wall->model, &wall->contacts, &diag), ==, QN_OK);
  for (size_t i = 0; i < wall->model.block_count; i++) {
    const QnBlock *block = &wall->model.blocks[i];
    qn_rings_add (&wall->rings, qn_model_block_vertices (&wall->model, (QnId) i),
                  (size_t) block->vertex_count);
    wall->area += block->area;
  }
}

static QnVec2
meet (QnVec2 a, QnVec2 along_a, QnVec2 b, QnVec2 along_b)
{
  double s =
    qn_vec2_cross (qn_vec2_sub (b, a), along_b) / qn_vec2_cross (along_a, along_b);
  return qn_vec2_add_scaled (a, s, along_a);
}

/* Whether a side of a block lies in a joint. */
static gboolean
is_joint (const Wall *wall, size_t block, QnVec2 from, QnVec2 to)
{
  for (size_t i = 0; i < wall->contacts.face_count; i++) {
    const QnContactFace *face = &wall->contacts.faces[i];
    QnVec2 middle = qn_vec2_lerp (face->start, face->end, 0.5);
    if (((size_t) face->a == block || (size_t) face->b == block)
        && qn_segment_distance (from, to, middle) < 1e-6)
      return TRUE;
  }
  return FALSE;
}

/* The same blocks as a survey draws them: without the mortar. */
static void
draw (const Wall *wall, const Joints *joints, GRand *rand, QnRings *drawn)
{
  memset (drawn, 0, sizeof *drawn);
  for (size_t i = 0; i < wall->rings.count; i++) {
    const QnRing *ring = &wall->rings.items[i];
    g_autofree QnVec2 *from = g_new (QnVec2, ring->count);
    g_autofree QnVec2 *along = g_new (QnVec2, ring->count);
    g_autofree QnVec2 *points = g_new (QnVec2, ring->count);
    QnVec2 middle = qn_ring_centroid (ring);
    double turn =
      joints->turn > 0 ? g_rand_double_range (rand, -joints->turn, joints->turn) : 0;
    for (size_t k = 0; k < ring->count; k++) {
      QnVec2 a = ring->points[k], b = ring->points[(k + 1) % ring->count];
      along[k] = qn_vec2_sub (b, a);
      double depth = joints->most > joints->least
                       ? g_rand_double_range (rand, joints->least, joints->most)
                       : joints->least;
      from[k] = a;
      if (is_joint (wall, i, a, b))
        from[k] = qn_vec2_add_scaled (a, depth / qn_vec2_length (along[k]),
                                      qn_vec2_perp (along[k]));
    }
    for (size_t k = 0; k < ring->count; k++) {
      size_t before = (k + ring->count - 1) % ring->count;
      points[k] = meet (from[before], along[before], from[k], along[k]);
      points[k] = qn_vec2_add (
        middle, qn_vec2_rotate (qn_vec2_sub (points[k], middle), cos (turn), sin (turn)));
    }
    qn_rings_add (drawn, points, ring->count);
  }
}

static double
area_of (const QnRings *rings)
{
  double area = 0;
  for (size_t i = 0; i < rings->count; i++)
    area += qn_ring_area (&rings->items[i]);
  return area;
}

/* The contacts of rings as blocks of a model; nothing may overlap. */
static void
touch (const QnRings *rings, Wall *wall)
{
  QnDiag diag = { 0 };
  memset (wall, 0, sizeof *wall);
  test_sound_init (&wall->model);
  for (size_t i = 0; i < rings->count; i++) {
    g_autofree char *name = g_strdup_printf ("b%zu", i);
    QnBlock *block = qn_model_add_block (&wall->model, name, rings->items[i].points,
                                         rings->items[i].count);
    block->thickness = 1;
  }
  if (qn_model_prepare (&wall->model, &diag) != QN_OK)
    g_error ("block %d: %s", diag.index, qn_problem_text (diag.problem));
  g_assert_cmpint (qn_contacts_detect (&wall->model, &wall->contacts, &diag), ==, QN_OK);
}

static double
length_between (const QnContacts *contacts, QnId a, QnId b)
{
  double length = 0;
  for (size_t i = 0; i < contacts->face_count; i++)
    if (contacts->faces[i].a == a && contacts->faces[i].b == b)
      length += contacts->faces[i].length;
  return length;
}

/* Faces of `wanted` of some length that are not among `got`. */
static size_t
count_missing (const QnContacts *wanted, const QnContacts *got, double shortest)
{
  size_t missing = 0;
  for (size_t i = 0; i < wanted->face_count; i++) {
    const QnContactFace *face = &wanted->faces[i];
    if (face->length > shortest
        && length_between (got, face->a, face->b) < 0.5 * face->length)
      missing++;
  }
  return missing;
}

/* The largest angle by which a bed turned, rad: of the joints that faced nearly `up`. */
static double
most_turned (const QnContacts *wanted, const QnContacts *got, QnVec2 up)
{
  double most = 0;
  for (size_t i = 0; i < wanted->face_count; i++)
    for (size_t k = 0; k < got->face_count; k++) {
      const QnContactFace *a = &wanted->faces[i], *b = &got->faces[k];
      if (a->a == b->a && a->b == b->b && a->length > SHORT && b->length > SHORT
          && fabs (qn_vec2_dot (a->normal, up)) > 0.99)
        most = fmax (most, fabs (asin (qn_vec2_cross (a->normal, b->normal))));
    }
  return most;
}

/* How many faces are missing and how far beds turned at most are held to what is given; nothing
 * overlaps. */
static void
close_and_compare (const char *name, const QnMasonry *masonry, const Joints *joints,
                   GRand *rand, size_t most_missing, double most_turn)
{
  g_auto (Wall) built, closed;
  g_auto (QnRings) drawn;
  QnGaps gaps;
  QnGapClosing closing;
  lay (masonry, &built);
  draw (&built, joints, rand, &drawn);
  double before = area_of (&drawn);
  qn_gaps_find (&drawn, 0.0005, 0.025, &gaps);
  closing = qn_gaps_close (&drawn, 0.0005, 0.025);
  touch (&drawn, &closed);
  size_t missing = count_missing (&built.contacts, &closed.contacts, SHORT);
  double turned =
    most_turned (&built.contacts, &closed.contacts,
                 qn_vec2 (-sin (masonry->rotation), cos (masonry->rotation)));
  g_test_message ("%s, %s: %zu faces, now %zu, missing %zu, turned %.2g, %zu gaps, left "
                  "%zu, area %.5f, %.5f, built %.5f",
                  name, joints->name, built.contacts.face_count,
                  closed.contacts.face_count, missing, turned, gaps.count, closing.left,
                  before, area_of (&drawn), built.area);
  g_assert_cmpuint (missing, <=, most_missing);
  g_assert_cmpuint (closing.left, <=, most_missing);
  g_assert_cmpuint (count_missing (&closed.contacts, &built.contacts, SHORT), ==, 0);
  g_assert_cmpfloat (turned, <=, most_turn);
  for (size_t i = 0; i < closed.contacts.findings.count; i++)
    g_assert_cmpint (closed.contacts.findings.items[i].problem, !=,
                     QN_PROBLEM_BLOCKS_OVERLAP);
  for (size_t i = 0; i < gaps.count; i++) {
    g_assert_cmpfloat (gaps.items[i].width, >=, 2 * joints->least - 0.002);
    g_assert_cmpfloat (gaps.items[i].width, <=, 2 * joints->most + 0.002);
  }
  g_assert_cmpfloat_with_epsilon (closing.grown, area_of (&drawn) - before, 1e-9);
  /* Blocks grow by what was between them. */
  double exact = joints->most > joints->least ? 1e-3 : 1e-9;
  g_assert_cmpfloat_with_epsilon (area_of (&drawn), built.area, exact * built.area);
  qn_gaps_clear (&gaps);
}

static void
make_wall (QnMasonry *masonry, QnBond bond, double rotation)
{
  qn_masonry_init (masonry, QN_MASONRY_WALL, "m");
  QnLeaf *leaf = masonry->wall.leaves;
  leaf->bond = bond;
  leaf->length = 3;
  leaf->unit = qn_vec2 (0.3, 0.15);
  masonry->wall.height = 2.4;
  masonry->law = 0;
  masonry->unit_weight = 20000;
  masonry->foundation = 0.3;
  masonry->rotation = rotation;
  QnOpening *opening = qn_masonry_add_opening (masonry);
  opening->at = qn_vec2 (1, 0.6);
  opening->width = 0.9;
  opening->height = 1.05;
  opening->span = QN_SPAN_LINTEL;
  opening->depth = 0.15;
  opening->bearing = 0.2;
}

static void
test_walls (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (1);
  const double most_turns[] = { 1e-9, 5e-3, 0.01 };
  for (int bond = 0; bond < QN_BOND_CUSTOM; bond++)
    for (size_t k = 0; k < G_N_ELEMENTS (joints_of_mortar); k++)
      for (int turn = 0; turn < 3; turn++) {
        g_auto (QnMasonry) masonry;
        make_wall (&masonry, (QnBond) bond, 0.35 * turn);
        close_and_compare (qn_bond_names[bond], &masonry, &joints_of_mortar[k], rand, 0,
                           most_turns[k]);
      }
}

static void
make_other (QnMasonry *masonry, QnMasonryKind kind)
{
  qn_masonry_init (masonry, kind, "m");
  masonry->law = 0;
  masonry->foundation = 0.3;
  masonry->arch =
    (QnArch){ .span = 4, .rise = 1.2, .ring = 0.4, .voussoirs = 15, .springer = 0.5 };
  masonry->column = (QnColumn){ .height = 3,
                                .bottom = 0.8,
                                .top = 0.6,
                                .drums = 5,
                                .plinth_width = 1.1,
                                .plinth_height = 0.2,
                                .capital_width = 1,
                                .capital_height = 0.25 };
  masonry->buttress =
    (QnButtress){ .height = 3, .bottom = 1.2, .top = 0.6, .courses = 6 };
  masonry->portal = (QnPortal){ .bays = 3,
                                .span = 2,
                                .pier_width = 1,
                                .pier_height = 2.4,
                                .courses = 6,
                                .arch = { .rise = 0.6, .ring = 0.35, .voussoirs = 11 } };
  masonry->rubble = (QnRubble){
    .width = 3, .top = 2.4, .height = 3, .stone = 0.4, .irregularity = 0.6, .seed = 7
  };
}

/* Of rubble with joints between 5 and 20 mm a stone may lose a neighbour at a corner. */
static void
test_others (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (1);
  for (int kind = QN_MASONRY_ARCH; kind < QN_MASONRY_KIND_COUNT; kind++)
    for (size_t k = 0; k < G_N_ELEMENTS (joints_of_mortar); k++) {
      g_auto (QnMasonry) masonry;
      make_other (&masonry, (QnMasonryKind) kind);
      close_and_compare (qn_masonry_kind_names[kind], &masonry, &joints_of_mortar[k],
                         rand, kind == QN_MASONRY_RUBBLE && k > 0 ? 2 : 0,
                         k > 0 ? 0.1 : 1e-9);
    }
}

static void
add_box (QnRings *rings, double x0, double y0, double x1, double y1)
{
  const QnVec2 corners[] = { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
  qn_rings_add (rings, corners, 4);
}

static double
common_area (const QnRings *rings)
{
  double area = 0;
  for (size_t i = 0; i < rings->count; i++)
    for (size_t k = 0; k < i; k++) {
      g_auto (QnRings) common = { 0 };
      qn_polygon_intersection (&rings->items[i], &rings->items[k], &common, NULL);
      area += area_of (&common);
    }
  return area;
}

/* Tapering and slanting faces: voussoirs under bricks that are cut along them, every corner at random. What
 * did not overlap does not, and no block leaves its half of the joints by more than they are wide. */
static void
test_wedges (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (11);
  for (int trial = 0; trial < 200; trial++) {
    g_auto (QnRings) rings = { 0 }, drawn = { 0 };
    double slope = g_rand_double_range (rand, -0.3, 0.3);
    for (int i = 0; i < 5; i++) {
      /* Tops lie under a slanting line, sides lean and taper. */
      QnVec2 p[4];
      for (int k = 0; k < 4; k++) {
        double x =
          0.09 * (i + (k == 1 || k == 2))
          + (k == 1 || k == 2 ? -1 : 1) * g_rand_double_range (rand, 0.003, 0.008);
        x *= k < 2 ? 0.8 : 1;
        p[k] = qn_vec2 (
          x, k < 2 ? 0 : 0.25 + slope * x - g_rand_double_range (rand, 0.003, 0.009));
      }
      qn_rings_add (&rings, p, 4);
    }
    for (int i = 0; i < 2; i++) {
      double a = 0.225 * i + 0.005, b = 0.225 * (i + 1) - 0.005;
      QnVec2 p[4] = { { a, 0.25 + slope * a + g_rand_double_range (rand, 0.003, 0.009) },
                      { b, 0.25 + slope * b + g_rand_double_range (rand, 0.003, 0.009) },
                      { b, 0.5 },
                      { a, 0.5 } };
      /* One brick is cut flat, as high as it must be. */
      if (i == trial % 2)
        p[0].y = p[1].y = fmax (p[0].y, p[1].y);
      qn_rings_add (&rings, p, 4);
    }
    for (size_t i = 0; i < rings.count; i++)
      qn_rings_add (&drawn, rings.items[i].points, 4);
    g_assert_cmpfloat (common_area (&rings), ==, 0);
    qn_gaps_close (&rings, 0.0003, 0.03);
    g_assert_cmpfloat (common_area (&rings), <, 1e-7);
    g_assert_cmpfloat (area_of (&rings), >, area_of (&drawn));
  }
}

/* What touches keeps every digit, also beside a gap that is too wide. */
static void
test_clean_stays (void)
{
  QnRings rings = { 0 }, before = { 0 };
  QnGapClosing closing;
  for (int row = 0; row < 4; row++)
    for (int i = 0; i < 5; i++) {
      double x = 0.1 * i + row % 2 * 0.05 + (i > 2 ? 0.02 : 0);
      add_box (&rings, x, 0.07 * row, x + 0.1, 0.07 * (row + 1));
    }
  for (size_t i = 0; i < rings.count; i++)
    qn_rings_add (&before, rings.items[i].points, rings.items[i].count);
  closing = qn_gaps_close (&rings, 1e-4, 0.015);
  g_assert_cmpuint (closing.left, ==, 0);
  for (size_t i = 0; i < rings.count; i++)
    g_assert_cmpmem (rings.items[i].points, rings.items[i].count * sizeof (QnVec2),
                     before.items[i].points, before.items[i].count * sizeof (QnVec2));
  qn_rings_clear (&rings);
  qn_rings_clear (&before);
}

/* A thin slate between two stones is no mortar. */
static void
test_slate (void)
{
  g_auto (QnRings) rings = { 0 };
  QnGaps gaps;
  add_box (&rings, 0, 0, 0.5, 0.2);
  add_box (&rings, 0, 0.202, 0.5, 0.214);
  add_box (&rings, 0, 0.216, 0.5, 0.4);
  qn_gaps_find (&rings, 1e-4, 0.03, &gaps);
  g_assert_cmpuint (gaps.count, ==, 2);
  for (size_t i = 0; i < gaps.count; i++)
    g_assert_cmpfloat_with_epsilon (gaps.items[i].width, 0.002, 1e-9);
  qn_gaps_clear (&gaps);
}

/* Bodies of mortar lie between the blocks and touch both. */
static void
test_fill (void)
{
  g_auto (QnRings) rings = { 0 };
  QnGaps gaps;
  g_auto (Wall) wall;
  add_box (&rings, 0, 0, 0.5, 0.2);
  add_box (&rings, 0.51, 0, 1, 0.2);
  add_box (&rings, 0.2, 0.212, 0.7, 0.4);
  qn_gaps_find (&rings, 1e-4, 0.02, &gaps);
  g_assert_cmpuint (gaps.count, ==, 3);
  qn_gaps_fill (&gaps, &rings);
  g_assert_cmpuint (rings.count, ==, 6);
  g_assert_cmpfloat_with_epsilon (
    area_of (&rings), 0.1 + 0.098 + 0.094 + 0.002 + 0.3 * 0.012 + 0.19 * 0.012, 1e-9);
  touch (&rings, &wall);
  g_assert_cmpuint (wall.contacts.face_count, ==, 6);
  qn_gaps_clear (&gaps);
}

QN_TESTS
{
  g_test_add_func ("/gaps/wedges", test_wedges);
  g_test_add_func ("/gaps/walls", test_walls);
  g_test_add_func ("/gaps/others", test_others);
  g_test_add_func ("/gaps/clean-stays", test_clean_stays);
  g_test_add_func ("/gaps/slate", test_slate);
  g_test_add_func ("/gaps/fill", test_fill);
}
