#include "doc/edit/edit-shape.h"
#include "doc/edit/edit-tie.h"

#include "doc/fixture.h"
#include "support/room.h"
#include <string.h>

static gboolean
add_force (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_add_force (model, 1, TRUE, qn_vec2 (10.0, -5.0), qn_vec2 (0.1, 0.2),
                            error);
}

static gboolean
delete_force (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_remove_item (model, QN_PICK_LIVE_LOAD, *(const QnId *) data, error);
}

static gboolean
set_weight (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_set_weight_load (model, TRUE, *(const QnVec2 *) data, error);
}

static gboolean
add_law (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_add_law (model, 0, data, error);
}

static gboolean
delete_law (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_delete_law (model, *(const QnId *) data, QN_NONE, error);
}

/* The first law; the last one stands in its place. */
static gboolean
replace_law (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_delete_law (model, 0, (QnId) model->law_count - 1, error);
}

static void
test_forces (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  gsize before = document->project.model.live_load_count;
  edit (document, add_force, NULL);
  const QnModel *model = &document->project.model;
  g_assert_cmpuint (model->live_load_count, ==, before + 1);
  const QnLoad *load = &model->live_loads[before];
  g_assert_cmpint (load->kind, ==, QN_LOAD_FORCE);
  g_assert_cmpint (load->block, ==, 1);
  g_assert_cmpfloat (load->vector.y, ==, -5.0);
  g_assert_true (load->has_at);
  g_assert_cmpfloat (load->at.y, ==, 0.2);

  QnId none = 99, force = (QnId) before;
  refuse (document, delete_force, &none);
  edit (document, delete_force, &force);
  g_assert_cmpuint (document->project.model.live_load_count, ==, before);
  g_assert_true (qn_document_undo (document));
  g_assert_cmpuint (document->project.model.live_load_count, ==, before + 1);
}

/* There is one load of own weight; no direction means none. */
static void
test_weight (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  QnVec2 left = qn_vec2 (-2.0, 0.0), none = qn_vec2 (0.0, 0.0);
  edit (document, set_weight, &left);
  const QnModel *model = &document->project.model;
  g_assert_cmpuint (model->live_load_count, ==, 1);
  g_assert_cmpfloat (model->live_loads[0].vector.x, ==, -2.0);
  edit (document, set_weight, &none);
  g_assert_cmpuint (document->project.model.live_load_count, ==, 0);
  edit (document, set_weight, &left);
  g_assert_cmpuint (document->project.model.live_load_count, ==, 1);
}

static void
test_laws (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  gsize before = document->project.model.law_count;
  edit (document, add_law, "mortar");
  const QnModel *model = &document->project.model;
  g_assert_cmpuint (model->law_count, ==, before + 1);
  g_assert_cmpstr (model->laws[before].name, ==, "mortar");
  g_assert_cmpfloat (model->laws[before].friction, ==, model->laws[0].friction);
  model = edit (document, add_law, "mortar"); /* a name counts once */
  g_assert_cmpstr (model->laws[before + 1].name, ==, "mortar 2");
  g_assert_true (qn_document_undo (document));

  QnId contact = document->project.model.contact.law, added = (QnId) before;
  refuse (document, delete_law, &contact); /* it is needed */
  edit (document, delete_law, &added);
  g_assert_cmpuint (document->project.model.law_count, ==, before);

  /* Another law takes its place everywhere. */
  edit (document, add_law, "mortar");
  guint uses = qn_edit_count_law_uses (&document->project.model, 0);
  g_assert_cmpuint (uses, >, 0);
  g_assert_cmpuint (qn_edit_count_law_uses (&document->project.model, (QnId) before), ==,
                    0);
  edit (document, replace_law, NULL);
  model = &document->project.model;
  g_assert_cmpuint (model->law_count, ==, before);
  g_assert_cmpstr (model->laws[model->contact.law].name, ==, "mortar");
  g_assert_cmpuint (qn_edit_count_law_uses (model, model->contact.law), ==, uses);
}

/* ---- loads on edges ---- */

/* A lower stone of one and an upper one of two by one, the upper carries 2 to 6 kN/m on its top, 1 kN/m
 * on three quarters of its left and top, and 3 kN/m along its right side, upwards. */
static const char loaded[] =
  "{ \"format\": \"quoin\", \"version\": 1,"
  "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "    \"friction\": 0.6 } ],"
  "  \"blocks\": [ { \"name\": \"ground\", \"vertices\": [[0,0],[2,0],[2,1],[0,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
  "    { \"name\": \"stone\", \"vertices\": [[0,1],[2,1],[2,2],[0,2]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4 } ],"
  "  \"contact\": { \"law\": \"dry\" },"
  "  \"loads\": { \"dead\": ["
  "    { \"kind\": \"edge\", \"block\": \"stone\", \"side\": \"top\","
  "      \"intensity\": [6000, 2000] },"
  "    { \"kind\": \"edge\", \"block\": \"stone\", \"edge\": 2, \"count\": 2,"
  "      \"part\": [0.25, 1], \"intensity\": 1000 },"
  "    { \"kind\": \"edge\", \"block\": \"stone\", \"side\": \"right\","
  "      \"intensity\": 3000, \"direction\": [0, 1] } ] } }";

/* Force and moment about the origin of all loads on edges. */
typedef struct Sum {
  QnVec2 force;
  double moment;
  double length; /* loaded */
} Sum;

static Sum
sum_loads (const QnModel *model)
{
  Sum sum = { 0 };
  for (gsize i = 0; i < model->edge_force_count; i++) {
    const QnEdgeForce *force = &model->edge_forces[i];
    sum.force = qn_vec2_add (sum.force, force->force);
    sum.moment += qn_vec2_cross (force->at, force->force);
    sum.length += qn_vec2_length (qn_vec2_sub (force->ends[1], force->ends[0]));
  }
  return sum;
}

static void
check_sum (const QnModel *model, Sum expected)
{
  Sum sum = sum_loads (model);
  g_assert_cmpfloat_with_epsilon (sum.force.x, expected.force.x, 1e-6);
  g_assert_cmpfloat_with_epsilon (sum.force.y, expected.force.y, 1e-6);
  g_assert_cmpfloat_with_epsilon (sum.moment, expected.moment, 1e-6);
  g_assert_cmpfloat_with_epsilon (sum.length, expected.length, 1e-9);
}

static const QnId stone_id = 1;
static const QnBlockSet stone = { &stone_id, 1 };

static gboolean
cut (QnModel *model, gpointer data, GError **error)
{
  const QnVec2 *line = data;
  return qn_edit_cut_blocks (model, (QnBlockSet){ NULL, 0 }, line[0], line[1], error);
}

static gboolean
join_all_but_ground (QnModel *model, gpointer data, GError **error)
{
  QnId ids[] = { 1, 2 };
  (void) data;
  return qn_edit_join_blocks (model, (QnBlockSet){ ids, 2 }, error);
}

static gboolean
transform (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_transform_blocks (model, stone, *(const QnTransform *) data, error);
}

static gboolean
move_corner (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_move_corner (model, stone, qn_vec2 (0.0, 2.0), qn_vec2 (0.0, 2.5),
                              error);
}

static gboolean
delete_stone (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_delete_blocks (model, stone, error);
}

/* Cut and joined again, blocks carry the same: force, moment and loaded length, at every cut. */
static void
test_edges_cut (void)
{
  static const QnVec2 lines[][2] = { { { 0.7, 1.0 }, { 0.7, 2.1 } },
                                     { { -0.1, 1.2 }, { 2.1, 1.6 } },
                                     { { -0.1, 1.5 }, { 0.9, 2.1 } } };
  for (gsize i = 0; i < G_N_ELEMENTS (lines); i++) {
    g_autoptr (QnDocument) document = open_text (loaded);
    const Sum before = sum_loads (&document->project.model);
    g_assert_cmpfloat_with_epsilon (before.force.y, -8000.0 + 3000.0 - 1250.0, 1e-6);
    g_assert_cmpfloat_with_epsilon (before.force.x, 1000.0, 1e-6);
    const QnModel *model = edit (document, cut, lines[i]);
    g_assert_cmpuint (model->block_count, ==, 3);
    check_sum (model, before);
    model = edit (document, join_all_but_ground, NULL);
    g_assert_cmpuint (model->block_count, ==, 2);
    check_sum (model, before);
    check_state (document);
  }
}

/* Loads stay on the edges of a block that moves: what is at right angles turns with it, what has a
 * direction keeps that. */
static void
test_edges_moved (void)
{
  g_autoptr (QnDocument) document = open_text (loaded);
  const Sum before = sum_loads (&document->project.model);
  QnTransform t = qn_transform_translation (0.5, 0.0);
  Sum after = before;
  after.moment += 0.5 * before.force.y;
  check_sum (edit (document, transform, &t), after);
  g_assert_true (qn_document_undo (document));

  /* About the middle, upside down: 8 kN up, 1.25 kN up, 1 kN to the left; 3 kN up stays. */
  t = qn_transform_rotation (qn_vec2 (1.0, 1.5), G_PI);
  const QnModel *model = edit (document, transform, &t);
  check_sum (model,
             (Sum){ { -1000.0, 8000.0 + 1250.0 + 3000.0 },
                    /* The largest intensity is on the left now. */
                    9250.0 * 2.0 - (8000.0 * (7.0 / 6.0) + 1250.0 * 0.625) + 1000.0 * 1.5,
                    before.length });
  g_assert_true (qn_document_undo (document));

  /* Mirrored about its middle: the pressure from the left is one from the right, and along the left
   * side 3 kN go up. */
  t = qn_transform_mirror (qn_vec2 (1.0, 0.0), qn_vec2 (1.0, 1.0));
  model = edit (document, transform, &t);
  check_sum (model,
             (Sum){ { -1000.0, -6250.0 },
                    -8000.0 * (2.0 - 7.0 / 6.0) - 1250.0 * (2.0 - 0.625) + 1000.0 * 1.5,
                    before.length });
  check_state (document);
  t = qn_transform_mirror (qn_vec2 (1.0, 0.0), qn_vec2 (1.0, 1.0));
  check_sum (edit (document, transform, &t), before); /* and back */
}

/* A corner that moves takes its edges along; with the block go its loads. */
static void
test_edges_changed (void)
{
  g_autoptr (QnDocument) document = open_text (loaded);
  const QnModel *model = edit (document, move_corner, NULL);
  const double top = hypot (2.0, 0.5);
  g_assert_cmpfloat_with_epsilon (sum_loads (model).length,
                                  top + 0.75 * (top + 1.5) + 1.0, 1e-9);
  g_assert_cmpuint (model->dead_load_count, ==, 3);
  model = edit (document, delete_stone, NULL);
  g_assert_cmpuint (model->dead_load_count, ==, 0);
  g_assert_cmpuint (model->edge_force_count, ==, 0);
}

static gboolean
detach_all (QnModel *model, gpointer data, GError **error)
{
  g_autofree QnId *ids = g_new (QnId, model->block_count);
  (void) data;
  for (gsize i = 0; i < model->block_count; i++)
    ids[i] = (QnId) i;
  return qn_edit_detach (model, (QnBlockSet){ ids, (guint) model->block_count }, error);
}

static gboolean
load_top (QnModel *model, gpointer data, GError **error)
{
  QnEdgeChain chain = qn_model_find_edge (model, *(const QnVec2 *) data, 0.01, QN_NONE);
  return qn_edit_add_edge_load (model, chain, FALSE, 5000.0, error);
}

/* A wall that is taken apart keeps the loads of its blocks, and so does one that is cut. */
static void
test_edges_dissolved (void)
{
  g_autoptr (QnDocument) document = open_example ("27-retaining-wall.quoin");
  const QnVec2 top = qn_vec2 (0.3, 3.0), line[] = { { 0.5, 3.5 }, { 0.5, 1.0 } };
  edit (document, load_top, &top);
  const Sum before = sum_loads (&document->project.model);
  check_sum (edit (document, detach_all, NULL), before);
  check_sum (edit (document, cut, line), before);
  check_state (document);
}

/* The nearest edge; of two that lie on each other that of the block that the point is in; the way
 * round the outline that passes fewer edges. */
static void
test_find_edge (void)
{
  g_autoptr (QnDocument) document = open_text (loaded);
  const QnModel *model = &document->project.model;
  static const struct {
    QnVec2 at;
    QnId block, edge;
  } cases[] = { { { 1.0, 2.01 }, 1, 2 },  { { 1.0, 1.98 }, 1, 2 },
                { { 1.0, 1.001 }, 1, 0 }, { { 1.0, 0.999 }, 0, 2 },
                { { 2.02, 1.5 }, 1, 1 },  { { 1.0, 1.5 }, QN_NONE, 0 } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnEdgeChain found = qn_model_find_edge (model, cases[i].at, 0.1, QN_NONE);
    g_assert_cmpint (found.block, ==, cases[i].block);
    g_assert_cmpint (found.first, ==, cases[i].edge);
  }
  QnEdgeChain left = { 1, 3, 1 }, bottom = { 1, 0, 1 }, right = { 1, 1, 1 };
  QnEdgeChain both = qn_model_join_edges (model, left, bottom);
  g_assert_cmpint (both.first, ==, 3);
  g_assert_cmpint (both.count, ==, 2);
  both = qn_model_join_edges (model, right, left);
  g_assert_cmpint (both.first, ==, 1);
  g_assert_cmpint (both.count, ==, 3);
}

/* ---- bars ---- */

static gboolean
add_bar (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_add_bar (model, *(const QnBlockSet *) data, error);
}

static gboolean
remove_bar (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_remove_item (model, QN_PICK_BAR, *(const QnId *) data, error);
}

static gboolean
duplicate_bar (QnModel *model, gpointer data, GError **error)
{
  g_assert_cmpint (
    qn_edit_duplicate_item (model, QN_PICK_BAR, (QnId) model->bar_count, NULL), ==, -1);
  return qn_edit_duplicate_item (model, QN_PICK_BAR, *(const QnId *) data, error) >= 0;
}

static gboolean
turn_bar (QnModel *model, gpointer data, GError **error)
{
  (void) error;
  QnVec2 *end = &model->bars[*(const QnId *) data].end;
  *end = qn_vec2_add (*end, qn_vec2 (0.2, 0.2));
  return TRUE;
}

/* A bar goes through the blocks, along them, makes a pair on every joint that it crosses, and has a law
 * of a metal: the model's own, or a new one. What does not cross at a right angle is refused. */
static void
test_bars (void)
{
  static const struct {
    const char *example;
    gsize bars, laws; /* before; laws that are added */
  } cases[] = { { "09-reinforced-cantilever.quoin", 2, 0 },
                { "01-sliding-block.quoin", 0, 1 } };
  for (gsize c = 0; c < G_N_ELEMENTS (cases); c++) {
    g_autoptr (QnDocument) document = open_example (cases[c].example);
    const QnModel *model = &document->project.model;
    gsize laws = model->law_count, blocks = model->block_count;
    g_autofree QnId *ids = g_new (QnId, blocks);
    for (gsize i = 0; i < blocks; i++)
      ids[i] = (QnId) i;
    gsize pairs = document->contacts.pair_count;
    gsize faces = document->contacts.face_count;
    QnBlockSet none = { NULL, 0 }, all = { ids, (guint) blocks };
    QnId unknown = 99, last = (QnId) cases[c].bars;
    g_assert_cmpuint (model->bar_count, ==, cases[c].bars);
    refuse (document, add_bar, &none);
    edit (document, add_bar, &all);
    model = &document->project.model;
    g_assert_cmpuint (model->bar_count, ==, cases[c].bars + 1);
    g_assert_cmpuint (model->law_count, ==, laws + cases[c].laws);
    g_assert_cmpuint (document->contacts.pair_count, ==, pairs + faces);
    g_assert_cmpfloat_with_epsilon (qn_bar_get_diameter (model->bars[last].area), 0.016,
                                    1e-12);
    g_autofree char *text = qn_bar_dup_text (model, &model->bars[last], QN_UNITS_SI);
    g_assert_nonnull (strstr (text, "Ø 16"));
    refuse (document, turn_bar, &last);
    refuse (document, duplicate_bar, &unknown);
    const QnBar bar = model->bars[last];
    model = edit (document, duplicate_bar, &last);
    g_assert_cmpuint (model->bar_count, ==, cases[c].bars + 2);
    g_assert_cmpfloat_with_epsilon (
      qn_vec2_length (qn_vec2_sub (model->bars[last + 1].start, bar.start)), 0.064,
      1e-12);
    g_assert_true (qn_document_undo (document));
    refuse (document, remove_bar, &unknown);
    edit (document, remove_bar, &last);
    g_assert_cmpuint (document->project.model.bar_count, ==, cases[c].bars);
    g_assert_true (qn_document_undo (document));
    g_assert_cmpuint (document->project.model.bar_count, ==, cases[c].bars + 1);
  }
}

QN_TESTS
{
  g_test_add_func ("/doc/edit-load/forces", test_forces);
  g_test_add_func ("/doc/edit-load/weight", test_weight);
  g_test_add_func ("/doc/edit-load/laws", test_laws);
  g_test_add_func ("/doc/edit-load/edges-cut", test_edges_cut);
  g_test_add_func ("/doc/edit-load/edges-moved", test_edges_moved);
  g_test_add_func ("/doc/edit-load/edges-changed", test_edges_changed);
  g_test_add_func ("/doc/edit-load/edges-dissolved", test_edges_dissolved);
  g_test_add_func ("/doc/edit-load/find-edge", test_find_edge);
  g_test_add_func ("/doc/edit-load/bars", test_bars);
}
