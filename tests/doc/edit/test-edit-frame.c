/* Beams drawn, joined, parted, moved, copied, deleted: as a user would, undone to the byte. */
#include "doc/edit/edit-frame.h"
#include "doc/text/beam-summary.h"

#include "doc/fixture.h"
#include "support/room.h"

/* Two stones side by side on the ground, and room around them. */
static const char text[] =
  "{ \"format\": \"quoin\", \"version\": 1,"
  "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "    \"friction\": 0.6 } ],"
  "  \"blocks\": [ { \"name\": \"left\", \"vertices\": [[0,0],[1,0],[1,1],[0,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
  "    { \"name\": \"right\", \"vertices\": [[3,0],[4,0],[4,1],[3,1]],"
  "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] } ],"
  "  \"contact\": { \"law\": \"dry\" } }";

typedef struct Line {
  QnVec2 from, to;
  int elements;
} Line;

static gboolean
add (QnModel *model, gpointer data, GError **error)
{
  const Line *line = data;
  return qn_edit_add_beam (model, line->from, line->to,
                           (QnBeamStyle){ .element_count = line->elements }, error);
}

static const Line bridge = { { 1, 1 }, { 3, 1 }, 2 };
static const Line mast = { { 1, 1 }, { 1, 3 }, 1 };

/* Ends take the node that is there, the block that is there, or stand free. */
static void
test_add (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  const QnModel *model = edit (document, add, &bridge);
  g_assert_cmpuint (model->section_count, ==, 1);
  g_assert_cmpuint (model->beam_count, ==, 1);
  g_assert_cmpint (model->nodes[0].block, ==, qn_model_find_block (model, "left"));
  g_assert_cmpint (model->nodes[1].block, ==, qn_model_find_block (model, "right"));
  g_assert_cmpint (model->nodes[0].seat, ==, QN_SEAT_POINT);
  g_assert_cmpuint (model->element_count, ==, 2);
  model = edit (document, add, &mast);
  g_assert_cmpuint (model->section_count, ==, 1);
  g_assert_cmpint (model->beams[0].nodes[0], ==, model->beams[1].nodes[0]);
  const QnNode *top = &model->nodes[model->beams[1].nodes[1]];
  g_assert_cmpint (top->seat, ==, QN_SEAT_FREE);
  g_assert_cmpfloat (top->at.y, ==, 3);

  const Line point = { { 7, 7 }, { 7, 7 }, 1 };
  refuse (document, add, &point);
  const Line inside = { { 0.2, 0.2 }, { 0.8, 0.8 }, 1 }; /* both ends on one block */
  refuse (document, add, &inside);
  while (qn_document_undo (document))
    ;
  g_assert_cmpuint (document->project.model.beam_count, ==, 0);
  g_assert_cmpuint (document->project.model.node_count, ==, 0);
}

static gboolean
delete_first (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  const QnId first = 0;
  return qn_edit_delete_all (model, (QnPartSet){ .beams = { &first, 1 } }, error);
}

static gboolean
load_inner (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_add_node_force (model, qn_model_find_node (model, data), TRUE,
                                 qn_vec2 (0, -1000), error);
}

/* Nodes that another beam needs stay; those that nothing needs go, and their loads. */
static void
test_delete (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  edit (document, add, &bridge);
  edit (document, add, &mast);
  gsize live = document->project.model.live_load_count;
  const QnModel *model = edit (document, load_inner, "beam1.1");
  g_assert_cmpuint (model->live_load_count, ==, live + 1);
  g_autofree char *full = g_strdup (document->text->text);
  model = edit (document, delete_first, NULL);
  g_assert_cmpuint (model->beam_count, ==, 1);
  g_assert_cmpuint (model->node_count, ==, 2);
  g_assert_cmpuint (model->live_load_count, ==, live);
  model = edit (document, delete_first, NULL);
  g_assert_cmpuint (model->node_count, ==, 0);
  g_assert_true (qn_document_undo (document));
  g_assert_true (qn_document_undo (document));
  g_assert_cmpstr (document->text->text, ==, full);
}

static gboolean
set_elements (QnModel *model, gpointer data, GError **error)
{
  const QnId first = 0;
  return qn_edit_set_beams (model, (QnBeamSet){ &first, 1 }, QN_BEAM_ELEMENTS,
                            GPOINTER_TO_INT (data), error);
}

/* The load in the middle stays in the middle, or as near as there is a node. */
static void
test_elements (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  edit (document, add, &bridge);
  edit (document, load_inner, "beam1.1");
  const QnModel *model = edit (document, set_elements, GINT_TO_POINTER (8));
  g_assert_cmpuint (model->element_count, ==, 8);
  const QnLoad *load = &model->live_loads[model->live_load_count - 1];
  g_assert_cmpstr (model->nodes[load->node].name, ==, "beam1.4");
  model = edit (document, set_elements, GINT_TO_POINTER (1));
  load = &model->live_loads[model->live_load_count - 1];
  g_assert_cmpint (load->kind, ==, QN_LOAD_NODE);
  g_assert_cmpint (model->nodes[load->node].beam, ==, QN_NONE);
  refuse (document, set_elements, GINT_TO_POINTER (0));
}

typedef struct Place {
  const char *node;
  QnVec2 at;
} Place;

static gboolean
place (QnModel *model, gpointer data, GError **error)
{
  const Place *p = data;
  return qn_edit_place_node (model, qn_model_find_node (model, p->node), p->at, error);
}

static gboolean
part_second (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_part_beam (model, 1, 0, error);
}

/* Off the block, onto another node, and apart again. */
static void
test_place (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  edit (document, add, &bridge);
  edit (document, add, &mast);
  const QnModel *model = edit (document, place, &(Place){ "n1", { 1.5, 2 } });
  QnId node = qn_model_find_node (model, "n1");
  g_assert_cmpint (model->nodes[node].block, ==, QN_NONE);
  model = edit (document, place, &(Place){ "n3", { 3, 1 } }); /* mast's top on n2 */
  g_assert_cmpint (qn_model_find_node (model, "n3"), ==, QN_NONE);
  g_assert_cmpint (model->beams[1].nodes[1], ==, qn_model_find_node (model, "n2"));
  g_assert_cmpuint (qn_model_node_beams (model, model->beams[1].nodes[1]), ==, 2);
  model = edit (document, part_second, NULL);
  g_assert_cmpint (model->beams[0].nodes[0], !=, model->beams[1].nodes[0]);
  g_assert_cmpfloat (model->nodes[model->beams[1].nodes[0]].at.x, ==, 1.5);
  refuse (document, part_second, NULL);                   /* nothing to part from */
  refuse (document, place, &(Place){ "n2", { 1.5, 2 } }); /* no length left */
}

typedef struct Seat {
  QnSeat seat;
  QnBlockSide side;
} Seat;

static gboolean
seat_first (QnModel *model, gpointer data, GError **error)
{
  const Seat *s = data;
  QnId block = qn_model_block_under (model, model->nodes[0].at);
  return qn_edit_set_node_seat (model, 0, s->seat, block, s->side, error);
}

static gboolean
fix_first (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  const bool all[QN_DOF_COUNT] = { true, true, true };
  return qn_edit_set_node_support (model, 0, all, error);
}

/* How a block holds a node; a node on a block has no support of its own. */
static void
test_seat (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  edit (document, add, &bridge);
  refuse (document, fix_first, NULL);
  const QnModel *model =
    edit (document, seat_first, &(Seat){ QN_SEAT_SIDE, QN_BLOCK_SIDE_TOP });
  g_assert_cmpfloat (model->nodes[0].at.x, ==, 0.5);
  g_assert_cmpfloat (model->nodes[0].at.y, ==, 1);
  model = edit (document, seat_first, &(Seat){ QN_SEAT_CENTROID, 0 });
  g_assert_cmpfloat (model->nodes[0].at.y, ==, 0.5);
  model = edit (document, seat_first, &(Seat){ QN_SEAT_FREE, 0 });
  g_assert_cmpint (model->nodes[0].block, ==, QN_NONE);
  model = edit (document, fix_first, NULL);
  g_assert_true (model->nodes[0].support[QN_DOF_RZ]);
  /* Back onto the block: the support goes. */
  model = edit (document, seat_first, &(Seat){ QN_SEAT_POINT, 0 });
  g_assert_false (model->nodes[0].support[QN_DOF_RZ]);
}

typedef struct Motion {
  QnPartSet set;
  QnTransform transform;
  int copies;
} Motion;

static gboolean
move_parts (QnProject *draft, gpointer data, GError **error)
{
  const Motion *m = data;
  return qn_edit_transform_all (draft, m->set, m->transform, error);
}

static gboolean
copy_parts (QnProject *draft, gpointer data, GError **error)
{
  const Motion *m = data;
  return qn_edit_copy_all (draft, m->set, m->transform, m->copies, error);
}

static const QnModel *
edit_parts (QnDocument *document, QnEditFunc func, Motion motion)
{
  g_autoptr (GError) error = NULL;
  qn_document_edit (document, "parts", NULL, func, &motion, &error);
  g_assert_no_error (error);
  return &document->project.model;
}

/* Everything once, whether its block or its beam takes it along. */
static void
test_move (void)
{
  const QnId all[] = { 0, 1 };
  g_autoptr (QnDocument) document = open_text (text);
  edit (document, add, &bridge);
  edit (document, add, &mast);
  Motion motion = { { { all, 2 }, { all, 2 } }, qn_transform_translation (10, 0), 1 };
  const QnModel *model = edit_parts (document, move_parts, motion);
  g_assert_cmpfloat (model->nodes[qn_model_find_node (model, "n1")].at.x, ==, 11);
  g_assert_cmpfloat (model->nodes[qn_model_find_node (model, "n3")].at.x, ==, 11);
  g_assert_cmpfloat (model->blocks[0].centroid.x, ==, 10.5);
  /* The mast alone: its free top goes, and its foot over the block. */
  motion =
    (Motion){ { { NULL, 0 }, { all + 1, 1 } }, qn_transform_translation (0, -0.25), 1 };
  model = edit_parts (document, move_parts, motion);
  g_assert_cmpfloat (model->nodes[qn_model_find_node (model, "n3")].at.y, ==, 2.75);
  g_assert_cmpfloat (model->nodes[qn_model_find_node (model, "n1")].at.y, ==, 0.75);
  g_assert_cmpint (model->nodes[qn_model_find_node (model, "n1")].seat, ==,
                   QN_SEAT_POINT);
}

/* Copies are joined as the originals are, and to what lies where they come to be. */
static void
test_copy (void)
{
  const QnId all[] = { 0, 1 };
  g_autoptr (QnDocument) document = open_text (text);
  edit (document, add, &bridge);
  edit (document, add, &mast);
  Motion motion = { { { all, 2 }, { all, 2 } }, qn_transform_translation (0, 10), 2 };
  const QnModel *model = edit_parts (document, copy_parts, motion);
  g_assert_cmpuint (model->block_count, ==, 6);
  g_assert_cmpuint (model->beam_count, ==, 6);
  g_assert_cmpint (model->beams[2].nodes[0], ==, model->beams[3].nodes[0]);
  const QnNode *foot = &model->nodes[model->beams[4].nodes[0]];
  g_assert_cmpint (foot->seat, ==, QN_SEAT_POINT);
  g_assert_cmpfloat (model->blocks[foot->block].centroid.y, ==, 20.5);
  g_assert_true (qn_document_undo (document));
  g_assert_cmpuint (document->project.model.beam_count, ==, 2);
}

static gboolean
set_shape (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_set_section_shape (model, 0, GPOINTER_TO_INT (data), error);
}

static gboolean
set_young (QnModel *model, gpointer data, GError **error)
{
  (void) error;
  model->sections[0].young = *(const double *) data;
  return TRUE;
}

static gboolean
own_section (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  const QnId first = 0;
  return qn_edit_add_section (model, 0, error)
         && qn_edit_set_beams (model, (QnBeamSet){ &first, 1 }, QN_BEAM_SECTION, 1,
                               error);
}

static gboolean
remove_unused (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  qn_edit_remove_unused_sections (model);
  return TRUE;
}

/* A section keeps area, inertia and plastic moment in another shape; wrong numbers are refused. */
static void
test_section (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  const QnModel *model = edit (document, add, &bridge);
  double area = model->sections[0].area, inertia = model->sections[0].inertia;
  model = edit (document, set_shape, GINT_TO_POINTER (FALSE));
  g_assert_cmpfloat (model->sections[0].height, ==, 0);
  g_assert_cmpfloat_with_epsilon (model->sections[0].inertia, inertia, 1e-15);
  model = edit (document, set_shape, GINT_TO_POINTER (TRUE));
  g_assert_cmpfloat_with_epsilon (model->sections[0].area, area, 1e-12);
  g_assert_cmpfloat_with_epsilon (model->sections[0].height, 0.2, 1e-12);
  const double wrong = -1;
  refuse (document, set_young, &wrong);
  model = edit (document, own_section, NULL);
  g_assert_cmpint (model->beams[0].section, ==, 1);
  model = edit (document, remove_unused, NULL);
  g_assert_cmpuint (model->section_count, ==, 1);
  g_assert_cmpint (model->beams[0].section, ==, 0);
}

static gboolean
set_line (QnModel *model, gpointer data, GError **error)
{
  const QnId first = 0;
  return qn_edit_set_line_load (model, (QnBeamSet){ &first, 1 }, FALSE,
                                *(const QnVec2 *) data, error);
}

/* One load along a beam, replaced, not added; the fixed beam carries it by q L^2 / 12 at its ends
 * and q L^2 / 24 in its middle. */
static void
test_line_load (void)
{
  g_autoptr (QnDocument) document = open_text (text);
  edit (document, add, &bridge);
  const QnVec2 first = { 0, -500 }, second = { 0, -1200 }, none = { 0, 0 };
  edit (document, set_line, &first);
  const QnModel *model = edit (document, set_line, &second);
  g_assert_cmpfloat (qn_model_line_load (model, 0, FALSE).y, ==, -1200);
  g_assert_cmpfloat (qn_model_line_load (model, 0, TRUE).y, ==, 0);

  QnBeamForces forces[2] = { { { 0, 0 }, { 1200, 0 }, { -400, 200 } },
                             { { 0, 0 }, { 0, -1200 }, { 200, -400 } } };
  double displacements[5 * QN_DOF_COUNT] = { 0 };
  QnResult result;
  g_assert_cmpint (qn_result_init (&result, 2, 0, NULL), ==, QN_OK);
  result.node_count = 3;
  result.element_count = 2;
  g_assert_true (qn_result_add_step (&result, (QnStep){ 0 }, displacements));
  g_assert_true (qn_result_add_beam_forces (&result, forces));
  g_assert_null (qn_beam_dup_summary (model, &result, 1, 0, QN_UNITS_SI));
  g_autofree char *words = qn_beam_dup_summary (model, &result, 0, 0, QN_UNITS_SI);
  g_assert_cmpstr (words, ==,
                   "N: 0 to 0\u00a0N, largest 0\u00a0N at 0\u00a0m\n"
                   "V: 1200 to -1200\u00a0N, largest 1200\u00a0N at 0\u00a0m\n"
                   "M: -400 to -400\u00a0N·m, largest -400\u00a0N·m at 0\u00a0m");
  qn_result_clear (&result);

  model = edit (document, set_line, &none);
  g_assert_cmpuint (model->dead_load_count, ==, 0);
}

QN_TESTS
{
  g_test_add_func ("/doc/edit-frame/add", test_add);
  g_test_add_func ("/doc/edit-frame/delete", test_delete);
  g_test_add_func ("/doc/edit-frame/elements", test_elements);
  g_test_add_func ("/doc/edit-frame/place", test_place);
  g_test_add_func ("/doc/edit-frame/seat", test_seat);
  g_test_add_func ("/doc/edit-frame/move", test_move);
  g_test_add_func ("/doc/edit-frame/copy", test_copy);
  g_test_add_func ("/doc/edit-frame/section", test_section);
  g_test_add_func ("/doc/edit-frame/line-load", test_line_load);
}
