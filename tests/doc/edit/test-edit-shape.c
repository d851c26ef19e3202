#include "doc/edit/edit-shape.h"

#include "doc/edit/edit-dynamic.h"
#include "doc/fixture.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <math.h>

static const char project[] =
  "{ \"format\": \"quoin\", \"version\": 1,"
  "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "    \"friction\": 0.6 } ],"
  "  \"blocks\": [ { \"name\": \"a\", \"vertices\": [[0,0],[2,0],[2,1],[0,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
  "    { \"name\": \"b\", \"vertices\": [[2,0],[3,0],[3,1],[2,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4 } ],"
  "  \"contact\": { \"law\": \"dry\" },"
  "  \"loads\": { \"live\": [ { \"kind\": \"force\", \"block\": \"a\", \"value\": [1, 0],"
  "    \"at\": [1.75, 0.5] } ] } }";

typedef struct Shape {
  QnBlockSet set;
  QnVec2 a, b;
} Shape;

static gboolean
cut (QnModel *model, gpointer data, GError **error)
{
  const Shape *s = data;
  return qn_edit_cut_blocks (model, s->set, s->a, s->b, error);
}

static gboolean
join (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_join_blocks (model, ((const Shape *) data)->set, error);
}

static gboolean
move (QnModel *model, gpointer data, GError **error)
{
  const Shape *s = data;
  return qn_edit_move_corner (model, s->set, s->a, s->b, error);
}

static double
area_of (QnDocument *document, const char *name)
{
  const QnModel *model = &document->project.model;
  QnId id = qn_model_find_block (model, name);
  g_assert_cmpint (id, !=, QN_NONE);
  return model->blocks[id].area;
}

/* The larger part keeps the name, the load goes with the part that it acts on, supports with
 * both. */
static void
test_cut (void)
{
  g_autoptr (QnDocument) document = open_text (project);
  edit (document, cut, &(Shape){ { NULL, 0 }, { 1.5, -1.0 }, { 1.5, 2.0 } });
  const QnModel *model = &document->project.model;
  g_assert_cmpuint (model->block_count, ==, 3);
  g_assert_cmpfloat_with_epsilon (area_of (document, "a"), 1.5, 1e-12);
  g_assert_cmpuint (document->contacts.face_count, ==, 2);
  const QnLoad *load = &model->live_loads[0];
  g_assert_cmpfloat (load->at.x, ==, 1.75);
  g_assert_cmpfloat_with_epsilon (model->blocks[load->block].centroid.x, 1.75, 1e-12);
  g_assert_true (model->blocks[load->block].support[0]);
}

static gboolean
track (QnModel *model, gpointer data, GError **error)
{
  const QnId block = *(const QnId *) data;
  QnTrack *tracked = qn_model_add_track (model);
  QnInitialMotion *motion = qn_model_add_initial_motion (model);
  g_assert_true (tracked != NULL && motion != NULL);
  tracked->block = block;
  motion->block = block;
  motion->velocity[QN_DOF_UX] = 1.0;
  return qn_edit_choose_dynamic (model, error);
}

/* Whatever else speaks of a block that is cut speaks of the part with its name. */
static void
test_cut_keeps (void)
{
  g_autoptr (QnDocument) document = open_text (project);
  const QnId b = 1;
  edit (document, track, &b);
  edit (document, cut, &(Shape){ { &b, 1 }, { 2.4, -1.0 }, { 2.4, 2.0 } });
  const QnModel *model = &document->project.model;
  g_assert_cmpuint (model->initial_count, ==, 1);
  g_assert_cmpuint (model->track_count, ==, 1);
  g_assert_cmpstr (model->blocks[model->initial[0].block].name, ==, "b");
  g_assert_cmpfloat_with_epsilon (area_of (document, "b"), 0.6, 1e-12);
}

/* A segment that ends inside a block still parts it; one that only touches does not. */
static void
test_crossing (void)
{
  g_autoptr (QnDocument) document = open_text (project);
  const QnModel *model = &document->project.model;
  g_assert_true (qn_block_is_crossed (model, 0, qn_vec2 (1, -1), qn_vec2 (1, 0.5)));
  g_assert_false (qn_block_is_crossed (model, 0, qn_vec2 (-1, 0), qn_vec2 (3, 0)));
  g_assert_false (qn_block_is_crossed (model, 0, qn_vec2 (2, -1), qn_vec2 (2, 2)));
  g_assert_false (qn_block_is_crossed (model, 1, qn_vec2 (1, -1), qn_vec2 (1, 2)));

  Shape beside = { { NULL, 0 }, { 5, 5 }, { 6, 6 } };
  g_autoptr (GError) error = NULL;
  g_assert_false (edit_model (document, "Cut", NULL, cut, &beside, &error));
  g_assert_error (error, QN_EDIT_ERROR, 0);
}

static void
test_join (void)
{
  g_autoptr (QnDocument) document = open_text (project);
  const QnId both[] = { 0, 1 };
  edit (document, join, &(Shape){ { both, 2 }, { 0, 0 }, { 0, 0 } });
  const QnModel *model = &document->project.model;
  g_assert_cmpuint (model->block_count, ==, 1);
  g_assert_cmpint (model->blocks[0].vertex_count, ==, 4);
  g_assert_cmpfloat_with_epsilon (area_of (document, "a"), 3.0, 1e-12);
  g_assert_cmpint (model->live_loads[0].block, ==, 0);

  /* Blocks apart from each other do not become one. */
  g_autoptr (QnDocument) apart = open_text (project);
  const QnId one = 1;
  edit (apart, move, &(Shape){ { &one, 1 }, { 2, 0 }, { 2.5, 0 } });
  edit (apart, move, &(Shape){ { &one, 1 }, { 2, 1 }, { 2.5, 1 } });
  Shape shape = { { both, 2 }, { 0, 0 }, { 0, 0 } };
  g_autoptr (GError) error = NULL;
  g_assert_false (edit_model (apart, "Join", NULL, join, &shape, &error));
  g_assert_error (error, QN_EDIT_ERROR, 0);
}

/* Both blocks follow a corner that they share, so that the joint stays closed. */
static void
test_corner (void)
{
  g_autoptr (QnDocument) document = open_text (project);
  edit (document, move, &(Shape){ { NULL, 0 }, { 2, 1 }, { 2.2, 1.1 } });
  const QnContacts *contacts = &document->contacts;
  g_assert_cmpuint (contacts->face_count, ==, 1);
  g_assert_cmpfloat_with_epsilon (contacts->faces[0].length, hypot (0.2, 1.1), 1e-12);
}

static gboolean
join_bodies (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_join_bodies (model, data, error);
}

/* The wall of a façade that turns about its foot becomes one block with its tie, and the same multiplier. */
static void
test_bodies (void)
{
  g_autoptr (QnDocument) document = open_example ("47-gable-with-tie.quoin");
  const QnRun *run = solve_example (document);
  const double found = run->result.collapse_multiplier;
  QnMechanism mechanism;
  g_assert_cmpint (
    qn_mechanism_of_result (&mechanism, &run->model, &run->contacts, &run->result, NULL),
    ==, QN_OK);
  g_assert_cmpuint (mechanism.body_count, ==, 1);
  const QnModel *model = edit (document, join_bodies, &mechanism);
  g_assert_cmpuint (model->block_count, ==,
                    1 + 1 + 4); /* the courses of the gable differ */
  g_assert_cmpuint (model->tie_count, ==, 1);
  qn_mechanism_clear (&mechanism);
  g_assert_cmpfloat_with_epsilon (solve_example (document)->result.collapse_multiplier,
                                  found, 1e-6);
}

QN_TESTS
{
  g_test_add_func ("/doc/edit-shape/cut", test_cut);
  g_test_add_func ("/doc/edit-shape/cut-keeps", test_cut_keeps);
  g_test_add_func ("/doc/edit-shape/bodies", test_bodies);
  g_test_add_func ("/doc/edit-shape/crossing", test_crossing);
  g_test_add_func ("/doc/edit-shape/join", test_join);
  g_test_add_func ("/doc/edit-shape/corner", test_corner);
}
