/* Sets of loads and stages: added, filled, put in order, undone; what breaks a rule is refused. */
#include "doc/edit/edit-stage.h"
#include "doc/view/load-text.h"

#include "doc/fixture.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <string.h>

static const char text[] =
  "{ \"format\": \"quoin\", \"version\": 1,"
  "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "    \"friction\": 0.6 } ],"
  "  \"blocks\": [ { \"name\": \"ground\", \"vertices\": [[0,0],[2,0],[2,1],[0,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
  "    { \"name\": \"stone\", \"vertices\": [[0,1],[1,1],[1,2],[0,2]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4 } ],"
  "  \"contact\": { \"law\": \"dry\" },"
  "  \"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] } ],"
  "    \"live\": [ { \"kind\": \"weight\", \"direction\": [1, 0] } ] },"
  "  \"analysis\": { \"procedure\": \"load\", \"max_multiplier\": 0.25 } }";

static gboolean
add_set (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_add_load_list (model, FALSE, error);
}

static gboolean
rename_set (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_rename_load_list (model, FALSE, 1, data, error);
}

static gboolean
delete_set (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_delete_load_set (model, 1, error);
}

typedef struct Put {
  int32_t set; /* DEAD, 0 for live loads, or of a set */
  QnId id;
  QnLoad load;
} Put;

#define DEAD (-1)

static gboolean
append (QnModel *model, gpointer data, GError **error)
{
  const Put *put = data;
  QnLoad *added = qn_edit_new_load (model, put->set != DEAD, error);
  *added = put->load;
  added->set = MAX (put->set, 0);
  return TRUE;
}

static gboolean
replace (QnModel *model, gpointer data, GError **error)
{
  const Put *put = data;
  QnLoad *load = &qn_model_loads (model, put->set != DEAD, NULL)[put->id];
  (void) error;
  *load = put->load;
  load->set = MAX (put->set, 0);
  return TRUE;
}

static gboolean
remove_it (QnModel *model, gpointer data, GError **error)
{
  const Put *put = data;
  return qn_edit_remove_item (model, QN_PICK_LOAD (put->set != DEAD), put->id, error);
}

static gboolean
add_stage (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_add_stage (model, error);
}

typedef struct Order {
  gsize stage;
  int by;
} Order;

static gboolean
move_stage (QnModel *model, gpointer data, GError **error)
{
  const Order *order = data;
  return qn_edit_move_stage (model, order->stage, order->by, error) >= 0;
}

static gboolean
delete_stage (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_delete_stage (model, *(const gsize *) data, error);
}

static gboolean
rename_stage (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_rename_stage (model, 0, data, error);
}

typedef struct Settings {
  gsize stage;
  QnStage settings;
  double amplitudes[2];
  gsize count, cycles;
} Settings;

static gboolean
change_stage (QnModel *model, gpointer data, GError **error)
{
  const Settings *s = data;
  return qn_edit_change_stage (model, s->stage, &s->settings, s->amplitudes, s->count,
                               s->cycles, error);
}

static const QnLoad push = { .kind = QN_LOAD_FORCE,
                             .block = 1,
                             .node = QN_NONE,
                             .beam = QN_NONE,
                             .vector = { 0, -500 } };

static const QnLoad settlement = { .kind = QN_LOAD_SETTLEMENT,
                                   .block = 0,
                                   .node = QN_NONE,
                                   .beam = QN_NONE,
                                   .dof = QN_DOF_UY,
                                   .value = -0.01 };

/* Lists are independent of each other, whatever order their loads have in the model. */
static void
test_loads (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  const QnModel *model = edit (document, add_set, NULL);
  g_assert_cmpuint (model->load_set_count, ==, 1);
  model = edit (document, rename_set, "top");
  g_assert_cmpint (qn_model_find_load_set (model, "top"), ==, 1);
  refuse (document, rename_set, "live");
  refuse (document, rename_set, "");

  QnLoad force = push;
  edit (document, append, &(Put){ 1, 0, force });
  edit (document, append, &(Put){ DEAD, 0, force });
  edit (document, append, &(Put){ 0, 0, force });
  model = edit (document, append, &(Put){ 1, 0, settlement });
  const QnLoad *live = model->live_loads; /* set by set */
  g_assert_cmpuint (model->live_load_count, ==, 4);
  g_assert_cmpuint (qn_model_count_items (model, QN_PICK_DEAD_LOAD), ==, 2);
  for (int i = 0; i < 4; i++)
    g_assert_cmpint (live[i].set, ==, i / 2);
  g_assert_cmpint (live[3].kind, ==, QN_LOAD_SETTLEMENT);

  force.vector.y = -700;
  model = edit (document, replace, &(Put){ 1, 2, force });
  g_assert_cmpfloat (model->live_loads[2].vector.y, ==, -700);
  g_assert_cmpfloat (model->live_loads[1].vector.y, ==, -500);
  QnLoad wrong = settlement;
  wrong.block = 1; /* not fixed: nothing to give way */
  refuse (document, append, &(Put){ 1, 0, wrong });
  refuse (document, remove_it, &(Put){ 1, 7, force });
  model = edit (document, remove_it, &(Put){ 1, 2, force });
  g_assert_cmpint (model->live_loads[2].kind, ==, QN_LOAD_SETTLEMENT);
  g_autofree char *words = qn_load_dup_text (model, &model->live_loads[2], QN_UNITS_SI);
  g_assert_nonnull (strstr (words, "ground"));
  g_assert_nonnull (strstr (words, "-10\302\240mm"));

  model = edit (document, delete_set, NULL);
  g_assert_cmpuint (model->load_set_count, ==, 0);
  g_assert_cmpuint (model->live_load_count, ==, 2);
  while (qn_document_undo (document))
    ;
  g_assert_cmpuint (document->project.model.live_load_count, ==, 1);
}

typedef struct Place {
  QnId load;
  int by; /* 0: a copy */
} Place;

static gboolean
move_or_copy (QnModel *model, gpointer data, GError **error)
{
  const Place *place = data;
  return place->by == 0
           ? qn_edit_duplicate_item (model, QN_PICK_LIVE_LOAD, place->load, error) >= 0
           : qn_edit_move_load (model, TRUE, place->load, place->by, error);
}

/* Loads change places within their set; a copy is behind its original. */
static void
test_load_order (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  QnLoad force = push;
  edit (document, add_set, NULL);
  edit (document, append, &(Put){ 1, 0, force });
  const QnModel *model = edit (document, append, &(Put){ 0, 0, force });
  g_assert_cmpuint (model->live_load_count, ==, 3);
  model = edit (document, move_or_copy, &(Place){ 1, -1 });
  g_assert_cmpint (model->live_loads[0].kind, ==, QN_LOAD_FORCE);
  g_assert_cmpint (model->live_loads[1].kind, ==, QN_LOAD_WEIGHT);
  g_assert_cmpint (model->live_loads[2].kind, ==, QN_LOAD_FORCE);
  refuse (document, move_or_copy, &(Place){ 0, -1 });
  refuse (document, move_or_copy,
          &(Place){ 1, 1 }); /* the next one is of the other set */
  refuse (document, move_or_copy, &(Place){ 9, 1 });
  refuse (document, move_or_copy,
          &(Place){ 3, -1 }); /* nor is one read behind the last */
  refuse (document, move_or_copy, &(Place){ 9, 0 });
  model = edit (document, move_or_copy, &(Place){ 0, 0 });
  g_assert_cmpuint (model->live_load_count, ==, 4);
  g_assert_cmpint (model->live_loads[1].kind, ==, QN_LOAD_FORCE);
  g_assert_cmpint (model->live_loads[2].kind, ==, QN_LOAD_WEIGHT);
}

static gboolean
shift_stone (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  const QnId stone = 1;
  return qn_edit_transform_blocks (model, (QnBlockSet){ &stone, 1 },
                                   qn_transform_translation (0.1, 0), error);
}

static gboolean
rename_stone (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_rename_block (model, 1, "rock", error);
}

/* Members that no layer uses stay with its load and its block through edits of all kinds. */
static void
test_unknown_members (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  QnLoad force = push;
  edit (document, append, &(Put){ DEAD, 0, force });
  g_auto (GStrv) parts = g_strsplit (document->text->text, "[0, -500]", 2);
  g_autofree char *marked =
    g_strjoin ("[0, -500], \"source\": \"site\"", parts[0], parts[1], NULL);
  g_auto (GStrv) halves = g_strsplit (marked, "\"name\": \"stone\"", 2);
  g_autofree char *whole =
    g_strjoin ("\"name\": \"stone\", \"colour\": \"red\"", halves[0], halves[1], NULL);
  g_assert_true (qn_document_load_recovered (document, whole, NULL, NULL));
  edit (document, shift_stone, NULL);
  edit (document, rename_stone, NULL);
  edit (document, remove_it, &(Put){ DEAD, 0, force }); /* the weight */
  force.vector.y = -800;
  force.note = document->project.model.dead_loads[0].note;
  edit (document, replace, &(Put){ DEAD, 0, force });
  const char *now = document->text->text;
  g_assert_nonnull (strstr (now, "[0, -800], \"source\": \"site\" }"));
  g_assert_nonnull (strstr (now, "\"name\": \"rock\""));
  g_assert_nonnull (strstr (now, "\"colour\": \"red\" }"));
}

/* The analysis becomes the first stage with its end; what follows drives what waits. */
static void
test_stages (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  const QnModel *model = edit (document, add_stage, NULL);
  g_assert_cmpuint (model->stage_count, ==, 1);
  g_assert_true (model->stages[0].has_target);
  g_assert_cmpfloat (model->stages[0].target, ==, 0.25);
  g_assert_true (isinf (model->analysis.max_multiplier));
  model = edit (document, add_stage, NULL); /* on with the same loads, to collapse */
  g_assert_cmpuint (model->stages[1].sets, ==, 1);
  g_assert_false (model->stages[1].has_target);

  edit (document, add_set, NULL);
  edit (document, append, &(Put){ 1, 0, settlement });
  model = edit (document, add_stage, NULL);
  g_assert_cmpuint (model->stages[2].sets, ==, 2);
  g_assert_true (model->stages[1].has_target); /* an end, now that one follows */
  g_assert_cmpfloat (model->stages[1].target, ==, 1.25);
  model = edit (document, add_stage, NULL); /* and the settlement back */
  g_assert_cmpuint (model->stages[3].sets, ==, 2);
  g_assert_cmpfloat (model->stages[3].target, ==, 0.0);

  model = edit (document, rename_stage, "push");
  g_autofree char *words = qn_stage_dup_text (model, 0, QN_UNITS_SI);
  g_assert_nonnull (strstr (words, "push"));
  g_assert_nonnull (strstr (words, "0.25"));
  model = edit (document, rename_stage, "");
  g_assert_null (model->stages[0].name);

  const gsize third = 2, fourth = 3;
  refuse (document, delete_stage, &third); /* nothing left to come back from */
  model = edit (document, delete_stage, &fourth);
  g_assert_cmpuint (model->stage_count, ==, 3);
  /* With the set go the stages that drive nothing else. */
  model = edit (document, delete_set, NULL);
  g_assert_cmpuint (model->stage_count, ==, 2);
  while (qn_document_undo (document))
    ;
  g_assert_cmpuint (document->project.model.stage_count, ==, 0);
  g_assert_cmpfloat (document->project.model.analysis.max_multiplier, ==, 0.25);
}

/* The order changes; the stage without an end gets one where it is no longer the last. */
static void
test_order (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  edit (document, add_stage, NULL);
  edit (document, add_set, NULL);
  edit (document, append, &(Put){ 1, 0, settlement });
  const QnModel *model = edit (document, add_stage, NULL);
  g_assert_cmpuint (model->stages[1].sets, ==, 2);
  model = edit (document, move_stage, &(Order){ 1, -1 });
  g_assert_cmpuint (model->stages[0].sets, ==, 2);
  g_assert_cmpuint (model->stages[1].sets, ==, 1);
  refuse (document, move_stage, &(Order){ 1, 1 });
  refuse (document, move_stage, &(Order){ 0, -1 });

  /* A displacement ends it; both ends at once are refused, and no loads at all. */
  QnStage stage = model->stages[1];
  stage.control.block = 1;
  stage.control.dof = QN_DOF_UX;
  stage.control.target = 0.01;
  stage.has_target = true;
  stage.target = 1;
  refuse (document, change_stage, &(Settings){ 1, stage, { 0 }, 0, 1 });
  stage.has_target = false;
  model = edit (document, change_stage, &(Settings){ 1, stage, { 0 }, 0, 1 });
  g_assert_cmpint (qn_stage_get_end (&model->stages[1]), ==, QN_STAGE_END_DISPLACEMENT);
  stage = model->stages[1];
  stage.sets = 0;
  refuse (document, change_stage, &(Settings){ 1, stage, { 0 }, 0, 1 });
}

/* A cyclic protocol is moved, changed, named and deleted as a whole. */
static void
test_cycles (void)
{
  static const gsize first = 0;
  g_auto (GStrv) parts = g_strsplit (text, "\"max_multiplier\": 0.25", 2);
  g_autofree char *cyclic = g_strjoinv (
    "\"stages\": [ { \"loads\": \"live\", \"amplitudes\": [0.1, 0.2] } ]", parts);
  g_autoptr (QnDocument) document = open_text (cyclic);
  const QnModel *model = &document->project.model;
  g_assert_cmpuint (model->stage_count, ==, 6);
  g_assert_cmpint (model->stages[5].leg, ==, 6);
  Settings settings = { 0, model->stages[0], { 0.1, 0.3 }, 2, 2 };
  settings.settings.increments = 7;
  model = edit (document, change_stage, &settings);
  g_assert_cmpuint (model->stage_count, ==, 12);
  for (gsize i = 0; i < 12; i++) {
    static const double ends[] = {
      0.1, -0.1, 0, 0.1, -0.1, 0, 0.3, -0.3, 0, 0.3, -0.3, 0
    };
    g_assert_cmpint (model->stages[i].leg, ==, (int) i + 1);
    g_assert_cmpint (model->stages[i].increments, ==, 7);
    g_assert_cmpfloat (model->stages[i].target, ==, ends[i]);
  }
  settings.amplitudes[1] = 0;
  refuse (document, change_stage, &settings);
  settings.amplitudes[1] = 1;
  settings.cycles = 167; /* 1,002 stages */
  refuse (document, change_stage, &settings);
  model = edit (document, rename_stage, "swing");
  g_assert_cmpstr (model->stages[11].name, ==, "swing");
  model = edit (document, add_stage, NULL);
  model = edit (document, move_stage, &(Order){ 12, -1 });
  g_assert_cmpint (model->stages[0].leg, ==, 0);
  g_assert_cmpint (model->stages[12].leg, ==, 12);
  refuse (document, move_stage, &(Order){ 1, 1 });
  model = edit (document, move_stage, &(Order){ 0, 1 });
  g_assert_cmpint (model->stages[11].leg, ==, 12);
  settings = (Settings){ 0, model->stages[0], { 0 }, 0, 1 };
  model = edit (document, change_stage, &settings);
  g_assert_cmpuint (model->stage_count, ==, 2);
  g_assert_true (qn_document_undo (document));
  model = edit (document, delete_stage, (gpointer) &first);
  g_assert_cmpuint (model->stage_count, ==, 1);
  g_assert_cmpint (model->stages[0].leg, ==, 0);
}

/* Loads on edges begin and end at whole centimetres about the blocks, wherever these stand; a block that is on
 * them already stays in between. */
static void
test_whole_centimetres (void)
{
  static const QnVec2 corners[] = {
    { 0.1234, 0.0561 }, { 1.4567, 0.0561 }, { 1.4567, 2.0002 }, { 0.1234, 2.0002 }
  };
  static const QnVec2 round_ones[] = {
    { 0.1, 0.3 }, { 0.7, 0.3 }, { 0.7, 1.1 }, { 0.1, 1.1 }
  };
  static const struct {
    const QnVec2 *corners;
    QnBox box;
  } cases[] = { { corners, { { 0.12, 0.05 }, { 1.46, 2.01 } } },
                { round_ones, { { 0.1, 0.3 }, { 0.7, 1.1 } } } };
  for (guint i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnModel) model = { 0 };
    qn_model_init (&model);
    g_assert_nonnull (qn_model_add_block (&model, "stone", cases[i].corners, 4));
    const QnBox box = cases[i].box;
    QnLoad load;
    g_assert_true (
      qn_edit_make_edge_load (&model, QN_LOAD_SURCHARGE, (QnBlockSet){ 0 }, &load, NULL));
    g_assert_cmpfloat_with_epsilon (load.span[0], box.min.x, 1e-12);
    g_assert_cmpfloat_with_epsilon (load.span[1], box.max.x, 1e-12);
    g_assert_true (
      qn_edit_make_edge_load (&model, QN_LOAD_FILL, (QnBlockSet){ 0 }, &load, NULL));
    g_assert_cmpfloat_with_epsilon (load.span[0], box.min.y, 1e-12);
    g_assert_cmpfloat_with_epsilon (load.span[1], box.max.y, 1e-12);
    g_assert_cmpfloat_with_epsilon (load.surface[0].x, box.min.x, 1e-12);
    g_assert_cmpfloat_with_epsilon (load.surface[1].x, box.max.x, 1e-12);
    g_assert_cmpfloat_with_epsilon (load.surface[0].y, box.max.y + 0.3, 1e-12);
    g_assert_true (
      qn_edit_make_edge_load (&model, QN_LOAD_BACKFILL, (QnBlockSet){ 0 }, &load, NULL));
    g_assert_cmpfloat_with_epsilon (load.span[0], box.min.y, 1e-12);
    g_assert_cmpfloat_with_epsilon (load.span[1], box.max.y, 1e-12);
  }
}

QN_TESTS
{
  g_test_add_func ("/doc/edit-stage/loads", test_loads);
  g_test_add_func ("/doc/edit-stage/load-order", test_load_order);
  g_test_add_func ("/doc/edit-stage/unknown-members", test_unknown_members);
  g_test_add_func ("/doc/edit-stage/stages", test_stages);
  g_test_add_func ("/doc/edit-stage/order", test_order);
  g_test_add_func ("/doc/edit-stage/cycles", test_cycles);
  g_test_add_func ("/doc/edit-stage/whole-centimetres", test_whole_centimetres);
}
