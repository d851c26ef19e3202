#include "doc/edit/edit-bar.h"

#include "doc/fixture.h"
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
  return qn_edit_delete_load (model, TRUE, *(const QnId *) data, error);
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
  gsize before = qn_document_get_model (document)->live_load_count;
  edit (document, add_force, NULL);
  const QnModel *model = qn_document_get_model (document);
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
  g_assert_cmpuint (qn_document_get_model (document)->live_load_count, ==, before);
  g_assert_true (qn_document_undo (document));
  g_assert_cmpuint (qn_document_get_model (document)->live_load_count, ==, before + 1);
}

/* There is one load of own weight; no direction means none. */
static void
test_weight (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  QnVec2 left = qn_vec2 (-2.0, 0.0), none = qn_vec2 (0.0, 0.0);
  edit (document, set_weight, &left);
  const QnModel *model = qn_document_get_model (document);
  g_assert_cmpuint (model->live_load_count, ==, 1);
  g_assert_cmpfloat (model->live_loads[0].vector.x, ==, -2.0);
  edit (document, set_weight, &none);
  g_assert_cmpuint (qn_document_get_model (document)->live_load_count, ==, 0);
  edit (document, set_weight, &left);
  g_assert_cmpuint (qn_document_get_model (document)->live_load_count, ==, 1);
}

static void
test_laws (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  gsize before = qn_document_get_model (document)->law_count;
  edit (document, add_law, "mortar");
  const QnModel *model = qn_document_get_model (document);
  g_assert_cmpuint (model->law_count, ==, before + 1);
  g_assert_cmpstr (model->laws[before].name, ==, "mortar");
  g_assert_cmpfloat (model->laws[before].friction, ==, model->laws[0].friction);
  refuse (document, add_law, "mortar"); /* a name counts once */

  QnId contact = qn_document_get_model (document)->contact.law, added = (QnId) before;
  refuse (document, delete_law, &contact); /* it is needed */
  edit (document, delete_law, &added);
  g_assert_cmpuint (qn_document_get_model (document)->law_count, ==, before);

  /* Another law takes its place everywhere. */
  edit (document, add_law, "mortar");
  guint uses = qn_edit_count_law_uses (qn_document_get_model (document), 0);
  g_assert_cmpuint (uses, >, 0);
  g_assert_cmpuint (
    qn_edit_count_law_uses (qn_document_get_model (document), (QnId) before), ==, 0);
  edit (document, replace_law, NULL);
  model = qn_document_get_model (document);
  g_assert_cmpuint (model->law_count, ==, before);
  g_assert_cmpstr (model->laws[model->contact.law].name, ==, "mortar");
  g_assert_cmpuint (qn_edit_count_law_uses (model, model->contact.law), ==, uses);
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
  return qn_edit_remove_bar (model, *(const QnId *) data, error);
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
    const QnModel *model = qn_document_get_model (document);
    gsize laws = model->law_count, blocks = model->block_count;
    g_autofree QnId *ids = g_new (QnId, blocks);
    for (gsize i = 0; i < blocks; i++)
      ids[i] = (QnId) i;
    gsize pairs = qn_document_get_contacts (document)->pair_count;
    gsize faces = qn_document_get_contacts (document)->face_count;
    QnBlockSet none = { NULL, 0 }, all = { ids, (guint) blocks };
    QnId unknown = 99, last = (QnId) cases[c].bars;
    g_assert_cmpuint (model->bar_count, ==, cases[c].bars);
    refuse (document, add_bar, &none);
    edit (document, add_bar, &all);
    model = qn_document_get_model (document);
    g_assert_cmpuint (model->bar_count, ==, cases[c].bars + 1);
    g_assert_cmpuint (model->law_count, ==, laws + cases[c].laws);
    g_assert_cmpuint (qn_document_get_contacts (document)->pair_count, ==, pairs + faces);
    g_assert_cmpfloat_with_epsilon (qn_bar_get_diameter (model->bars[last].area), 0.016,
                                    1e-12);
    g_autofree char *text = qn_bar_dup_text (model, &model->bars[last], QN_UNITS_SI);
    g_assert_nonnull (strstr (text, "0.016"));
    refuse (document, turn_bar, &last);
    refuse (document, remove_bar, &unknown);
    edit (document, remove_bar, &last);
    g_assert_cmpuint (qn_document_get_model (document)->bar_count, ==, cases[c].bars);
    g_assert_true (qn_document_undo (document));
    g_assert_cmpuint (qn_document_get_model (document)->bar_count, ==, cases[c].bars + 1);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/doc/edit-load/forces", test_forces);
  g_test_add_func ("/doc/edit-load/weight", test_weight);
  g_test_add_func ("/doc/edit-load/laws", test_laws);
  g_test_add_func ("/doc/edit-load/bars", test_bars);
  return g_test_run ();
}
