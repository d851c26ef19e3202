#include "core/contact/contacts.h"
#include "stereotomy/masonry.h"
#include "stereotomy/ring.h"
#include "stereotomy/sound.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <glib.h>
#include <string.h>

static void
init (QnMasonry *masonry, QnMasonryKind kind)
{
  qn_masonry_init (masonry, kind, "m");
  masonry->unit_weight = 20000;
  masonry->law = 0;
  masonry->foundation = 0.3;
}

static const QnColumn a_column = { .height = 3,
                                   .bottom = 0.8,
                                   .top = 0.6,
                                   .drums = 5,
                                   .plinth_width = 1.1,
                                   .plinth_height = 0.2,
                                   .capital_width = 1,
                                   .capital_height = 0.25 };
static const QnPortal a_portal = { .bays = 3,
                                   .span = 2,
                                   .pier_width = 1,
                                   .pier_height = 2.4,
                                   .courses = 6,
                                   .arch = {
                                     .rise = 0.6, .ring = 0.35, .voussoirs = 11 } };
static const QnRubble a_rubble = {
  .width = 3, .top = 2.4, .height = 3, .stone = 0.4, .irregularity = 0.9, .seed = 7
};

/* Expands into a prepared model that is sound and can be analysed; returns the length of its
 * joints and, as `area`, what its blocks cover. */
static double
expand_sound (const QnMasonry *masonry, QnModel *model, double *area)
{
  QnDiag diag = { 0 };
  test_sound_init (model);
  if (qn_masonry_expand (masonry, 0, model, &diag) != QN_OK)
    g_error ("%s (%s)", qn_problem_text (diag.problem), diag.field);
  *area = 0;
  for (size_t i = 0; i < model->block_count; i++) {
    QnRing ring = { model->vertices + model->blocks[i].first_vertex,
                    (size_t) model->blocks[i].vertex_count };
    *area += qn_ring_area (&ring);
  }
  double joints = test_assert_sound (model, *area);
  g_auto (QnContacts) contacts;
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_require_sound (model, &contacts, &diag), ==, QN_OK);
  return joints;
}

static void
test_arch (void)
{
  const QnArch arches[] = {
    { .span = 4, .rise = 2, .ring = 0.4, .voussoirs = 15, .springer = 0.5 },
    { .span = 4, .rise = 0.8, .ring = 0.4, .voussoirs = 12, .springer = 0.5 },
    { .span = 4,
      .rise = 3,
      .ring = 0.4,
      .voussoirs = 15,
      .shape = QN_ARCH_POINTED,
      .sides = QN_SIDES_STRAIGHT },
    { .span = 4, .rise = 1, .ring = 0.4, .voussoirs = 14, .shape = QN_ARCH_ELLIPTIC }
  };
  for (size_t i = 0; i < G_N_ELEMENTS (arches); i++) {
    g_auto (QnMasonry) masonry;
    g_auto (QnModel) model;
    init (&masonry, QN_MASONRY_ARCH);
    masonry.arch = arches[i];
    masonry.rotation = 0.1 * (double) i;
    double area;
    expand_sound (&masonry, &model, &area);
    int springers = arches[i].springer > 0 ? 2 : 0;
    g_assert_cmpuint (model.block_count, ==,
                      (size_t) arches[i].voussoirs + 2 + springers);
    g_assert_cmpint (qn_model_find_block (&model, "m.v1"), !=, QN_NONE);
    QnId base = qn_model_find_block (&model, "m.base.right");
    g_assert_true (model.blocks[base].support[QN_DOF_UX]);
  }
}

static void
test_column (void)
{
  g_auto (QnMasonry) masonry;
  g_auto (QnModel) model;
  double area;
  init (&masonry, QN_MASONRY_COLUMN);
  masonry.column = a_column;
  double joints = expand_sound (&masonry, &model, &area);
  g_assert_cmpfloat_with_epsilon (area, 3 * 0.7 + 1.1 * 0.2 + 1 * 0.25 + 1.1 * 0.3,
                                  1e-12);
  /* Base and plinth, plinth and drum, four joints between drums, drum and capital. */
  g_assert_cmpfloat_with_epsilon (joints, 1.1 + 0.8 + (0.76 + 0.72 + 0.68 + 0.64) + 0.6,
                                  1e-9);
  g_assert_cmpint (qn_model_find_block (&model, "m.capital"), !=, QN_NONE);
}

static void
test_buttress (void)
{
  for (int side = 0; side < 2; side++) {
    g_auto (QnMasonry) masonry;
    g_auto (QnModel) model;
    double area;
    init (&masonry, QN_MASONRY_BUTTRESS);
    masonry.buttress = (QnButtress){
      .height = 3, .bottom = 1.6, .top = 0.6, .courses = 8, .leans_right = side == 1
    };
    expand_sound (&masonry, &model, &area);
    g_assert_cmpfloat_with_epsilon (area, 3 * 1.1 + 1.6 * 0.3, 1e-12);
    const QnVec2 *top =
      qn_model_block_vertices (&model, qn_model_find_block (&model, "m.8"));
    double least = INFINITY, most = -INFINITY;
    for (int i = 0; i < 4; i++) {
      least = fmin (least, top[i].x);
      most = fmax (most, top[i].x);
    }
    g_assert_cmpfloat (side == 1 ? least : most, ==, 0);
  }
}

static void
test_portal (void)
{
  g_auto (QnMasonry) masonry;
  QnModel model;
  double area;
  init (&masonry, QN_MASONRY_PORTAL);
  masonry.portal = a_portal;
  expand_sound (&masonry, &model, &area);
  g_assert_cmpuint (model.block_count, ==, 4 * 7 + 4 + 33);
  g_assert_cmpint (qn_model_find_block (&model, "m.arch3.v11"), !=, QN_NONE);
  qn_model_clear (&model);

  masonry.portal.lintel_height = 0.5;
  expand_sound (&masonry, &model, &area);
  g_assert_cmpfloat_with_epsilon (area, 4 * 2.7 + 10 * 0.5, 1e-12);
  qn_model_clear (&model);
}

/* Rings divide the ring radially: their blocks cover the same, and a law of their own lies between
 * them alone. Backing fills the space above the piers without a gap. */
static void
test_bridge (void)
{
  static const QnArchShape shapes[] = { QN_ARCH_CIRCULAR, QN_ARCH_ELLIPTIC,
                                        QN_ARCH_PARABOLIC, QN_ARCH_THREE_CENTRED };
  for (size_t s = 0; s < G_N_ELEMENTS (shapes); s++) {
    g_auto (QnMasonry) masonry;
    double areas[2], joints[2];
    init (&masonry, QN_MASONRY_PORTAL);
    masonry.portal = a_portal;
    masonry.portal.arch.shape = shapes[s];
    masonry.portal.backing = 0.55;
    for (int rings = 1; rings <= 3; rings += 2) {
      g_auto (QnModel) model;
      g_auto (QnContacts) contacts;
      masonry.portal.arch.rings = rings;
      joints[rings / 2] = expand_sound (&masonry, &model, &areas[rings / 2]);
      g_assert_cmpint (qn_model_find_block (&model, "m.backing4"), !=, QN_NONE);
      QnLaw *law = qn_model_add_law (&model, "rings");
      char *name = law->name;
      *law = model.laws[0];
      law->name = name;
      for (size_t b = 0; b < model.block_count; b++)
        model.blocks[b].ring_law = model.blocks[b].ring > 0 ? 1 : QN_NONE;
      g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
      size_t between = 0;
      for (size_t f = 0; f < contacts.face_count; f++) {
        const QnContactFace *face = &contacts.faces[f];
        int a = model.blocks[face->a].ring, b = model.blocks[face->b].ring;
        bool radial = a > 0 && b > 0 && a != b;
        g_assert_cmpint (qn_model_side_law (&model, face->a, face->b), ==,
                         radial ? 1 : model.contact.law);
        between += radial;
      }
      g_assert_cmpint (between > 0, ==, rings > 1);
    }
    g_assert_cmpfloat_with_epsilon (areas[0], areas[1], 1e-9);
    g_assert_cmpfloat (joints[1], >, joints[0]);
  }
}

/* Bays with numbers of their own: those that are not listed are as usual, the mirror image covers the same,
 * and numbers that say what is so anyway change nothing. Piers of 1, 0.9, 1.3 and 1 m, spans of 1.5, 2 and
 * 3 m: the last pier begins at 9.7 m. */
static void
test_unequal (void)
{
  double areas[2], area;
  g_auto (QnModel) plain = { 0 };
  g_auto (QnModel) same = { 0 };
  g_auto (QnMasonry) masonry;
  init (&masonry, QN_MASONRY_PORTAL);
  masonry.portal = a_portal;
  masonry.portal.backing = 0.5;
  expand_sound (&masonry, &plain, &area);
  for (int i = 0; i < 3; i++) {
    masonry.portal.spans[i] = 2;
    masonry.portal.rings[i] = 0.35;
    masonry.portal.rises[i] = 0.6;
    masonry.portal.piers[i] = 1;
  }
  expand_sound (&masonry, &same, &area);
  g_assert_cmpuint (plain.vertex_count, ==, same.vertex_count);
  for (size_t v = 0; v < plain.vertex_count; v++)
    g_assert_cmpfloat_with_epsilon (plain.vertices[v].x, same.vertices[v].x, 1e-12);

  for (int mirrored = 0; mirrored < 2; mirrored++) {
    static const double spans[] = { 1.5, 2, 3 }, rises[] = { 0.7, 0.6, 0.9 },
                        rings[] = { 0.3, 0.35, 0.45 };
    static const double piers[] = { 1, 0.9, 1.3, 1 };
    g_auto (QnModel) model = { 0 };
    for (int i = 0; i < 4; i++) {
      masonry.portal.piers[mirrored ? 3 - i : i] = piers[i];
      if (i == 3)
        continue;
      masonry.portal.spans[mirrored ? 2 - i : i] = spans[i];
      masonry.portal.rises[mirrored ? 2 - i : i] = rises[i];
      masonry.portal.rings[mirrored ? 2 - i : i] = rings[i];
    }
    expand_sound (&masonry, &model, &areas[mirrored]);
    const QnId last = qn_model_find_block (&model, "m.pier4.1");
    g_assert_cmpfloat_with_epsilon (qn_model_block_vertices (&model, last)[0].x, 9.7,
                                    1e-12);
  }
  g_assert_cmpfloat_with_epsilon (areas[0], areas[1], 1e-9);

  QnDiag diag;
  masonry.portal.piers[1] = 0.7; /* rings of 0.45 and 0.35 m on it */
  g_assert_cmpint (qn_masonry_expand (&masonry, 0, &plain, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_PIER_TOO_NARROW);
  masonry.portal.piers[1] = (double) INFINITY;
  g_assert_cmpint (qn_masonry_expand (&masonry, 0, &plain, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpstr (diag.field, ==, "piers");
}

/* What no arch of several rings, and no backing, can be. */
static void
test_bridge_refused (void)
{
  g_auto (QnMasonry) masonry;
  g_auto (QnModel) model = { 0 };
  QnDiag diag;
  init (&masonry, QN_MASONRY_PORTAL);
  masonry.portal = a_portal;
  const double backings[] = { 0.05, 0.95, NAN };
  for (size_t i = 0; i < G_N_ELEMENTS (backings); i++) {
    masonry.portal.backing = backings[i];
    g_assert_cmpint (qn_masonry_expand (&masonry, 0, &model, &diag), ==,
                     QN_ERROR_INVALID);
    g_assert_cmpstr (diag.field, ==, "backing");
  }
  masonry.portal.backing = 0;
  masonry.portal.arch.shape = QN_ARCH_POINTED;
  masonry.portal.arch.rise = 1.5;
  masonry.portal.arch.rings = 2;
  g_assert_cmpint (qn_masonry_expand (&masonry, 0, &model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_POINTED_RINGS);
  masonry.portal.arch.shape = QN_ARCH_THREE_CENTRED;
  masonry.portal.arch.rise = 0.2;
  g_assert_cmpint (qn_masonry_expand (&masonry, 0, &model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_ARCH_SHAPE);
}

static void
test_rubble (void)
{
  g_auto (QnMasonry) masonry;
  QnModel model, again;
  double area;
  init (&masonry, QN_MASONRY_RUBBLE);
  for (uint32_t seed = 0; seed < 20; seed++) {
    masonry.rubble = a_rubble;
    masonry.rubble.seed = seed;
    expand_sound (&masonry, &model, &area);
    g_assert_cmpfloat_with_epsilon (area, 3 * 2.7 + 3 * 0.3, 1e-9);
    g_assert_cmpuint (model.block_count, >, 50);
    qn_model_clear (&model);
  }
  /* The same seed gives the same stones, bit for bit; another one does not. */
  expand_sound (&masonry, &model, &area);
  expand_sound (&masonry, &again, &area);
  g_assert_cmpmem (model.vertices, model.vertex_count * sizeof (QnVec2), again.vertices,
                   again.vertex_count * sizeof (QnVec2));
  qn_model_clear (&again);
  masonry.rubble.seed = 99;
  expand_sound (&masonry, &again, &area);
  g_assert_true (memcmp (model.vertices, again.vertices, 10 * sizeof (QnVec2)) != 0);
  qn_model_clear (&again);
  qn_model_clear (&model);
  /* A single stone is the outline. */
  masonry.rubble.stone = 10;
  expand_sound (&masonry, &model, &area);
  g_assert_cmpuint (model.block_count, ==, 2);
  qn_model_clear (&model);
  /* As many stones as the program handles, however flat a row is. */
  masonry.rubble = a_rubble;
  masonry.rubble.width = masonry.rubble.top = 2147483648.;
  masonry.rubble.height = 1e-5;
  QnDiag diag = { 0 };
  qn_model_init (&model);
  g_assert_cmpint (qn_masonry_expand (&masonry, 0, &model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_TOO_MANY_BLOCKS);
  qn_model_clear (&model);
}

/* Every number of every kind set to nonsense: a named error or blocks, never a crash. */
static void
test_nonsense (void)
{
  const double values[] = { NAN, INFINITY, -INFINITY, -1, 0, 1e-300, 1e300, 1e13, 1e9 };
  for (int kind = 0; kind < QN_MASONRY_KIND_COUNT; kind++) {
    g_auto (QnMasonry) masonry;
    init (&masonry, (QnMasonryKind) kind);
    masonry.wall.height = 1;
    masonry.wall.leaves[0].length = 2;
    masonry.wall.leaves[0].unit = qn_vec2 (0.5, 0.25);
    masonry.arch =
      (QnArch){ .span = 4, .rise = 2, .ring = 0.4, .voussoirs = 5, .springer = 0.5 };
    masonry.column = a_column;
    masonry.portal = a_portal;
    masonry.rubble = a_rubble;
    masonry.buttress =
      (QnButtress){ .height = 3, .bottom = 1.6, .top = 0.6, .courses = 8 };
    double *numbers[] = { &masonry.origin.x,
                          &masonry.rotation,
                          &masonry.thickness,
                          &masonry.foundation,
                          &masonry.wall.height,
                          &masonry.wall.minimum_piece,
                          &masonry.wall.leaves[0].length,
                          &masonry.wall.leaves[0].unit.x,
                          &masonry.wall.leaves[0].unit.y,
                          &masonry.wall.leaves[0].lap,
                          &masonry.wall.leaves[0].header,
                          &masonry.arch.span,
                          &masonry.arch.rise,
                          &masonry.arch.ring,
                          &masonry.arch.springer,
                          &masonry.column.height,
                          &masonry.column.top,
                          &masonry.column.plinth_width,
                          &masonry.buttress.height,
                          &masonry.buttress.bottom,
                          &masonry.portal.span,
                          &masonry.portal.pier_width,
                          &masonry.portal.pier_height,
                          &masonry.portal.lintel_height,
                          &masonry.rubble.width,
                          &masonry.rubble.top,
                          &masonry.rubble.height,
                          &masonry.rubble.stone,
                          &masonry.rubble.irregularity };
    for (size_t i = 0; i < G_N_ELEMENTS (numbers); i++)
      for (size_t k = 0; k < G_N_ELEMENTS (values); k++) {
        double kept = *numbers[i];
        *numbers[i] = values[k];
        QnModel model;
        QnDiag diag = { 0 };
        qn_model_init (&model);
        QnStatus status = qn_masonry_expand (&masonry, 0, &model, &diag);
        if (status != QN_OK)
          g_assert_cmpint (diag.problem, !=, QN_PROBLEM_NONE);
        for (size_t v = 0; v < model.vertex_count; v++)
          g_assert_true (isfinite (model.vertices[v].x)
                         && isfinite (model.vertices[v].y));
        qn_model_clear (&model);
        *numbers[i] = kept;
      }
  }
}

static void
test_refuses (void)
{
  QnMasonry masonry;
  g_auto (QnModel) model;
  QnDiag diag = { 0 };
  qn_model_init (&model);
  init (&masonry, QN_MASONRY_ARCH);
  masonry.arch = (QnArch){ .span = 4, .rise = 2.5, .ring = 0.4, .voussoirs = 5 };
  g_assert_cmpint (qn_masonry_expand (&masonry, 4, &model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_ARCH_SHAPE);
  g_assert_cmpint (diag.index, ==, 4);
  g_assert_cmpstr (diag.field, ==, "rise");
  g_free (g_steal_pointer (&masonry.name));
  g_assert_cmpint (qn_masonry_expand (&masonry, 0, &model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NAME_MISSING);
  qn_masonry_clear (&masonry);

  init (&masonry, QN_MASONRY_PORTAL);
  masonry.portal = a_portal;
  masonry.portal.pier_width = 0.6;
  g_assert_cmpint (qn_masonry_expand (&masonry, 0, &model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_PIER_TOO_NARROW);
  qn_masonry_clear (&masonry);
}

QN_TESTS
{
  g_test_add_func ("/masonry/arch", test_arch);
  g_test_add_func ("/masonry/column", test_column);
  g_test_add_func ("/masonry/buttress", test_buttress);
  g_test_add_func ("/masonry/portal", test_portal);
  g_test_add_func ("/masonry/bridge", test_bridge);
  g_test_add_func ("/masonry/unequal", test_unequal);
  g_test_add_func ("/masonry/bridge-refused", test_bridge_refused);
  g_test_add_func ("/masonry/rubble", test_rubble);
  g_test_add_func ("/masonry/nonsense", test_nonsense);
  g_test_add_func ("/masonry/refuses", test_refuses);
}
