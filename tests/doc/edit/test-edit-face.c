#include "doc/edit/edit.h"

#include "doc/fixture.h"
#include "support/edit-model.h"
#include "support/room.h"

typedef struct Change {
  QnFaceSet set;
  QnId law;
  const QnPairRule *rule;
} Change;

static gboolean
set_law (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_set_faces (model, c->set, &c->law, NULL, error);
}

static gboolean
set_pairs (QnModel *model, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_set_faces (model, c->set, NULL, c->rule, error);
}

static gboolean
add_law (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_add_law (model, 0, "rough", error);
}

static QnDocument *
open_stack (void)
{
  QnDocument *document = open_example ("05-stack.quoin");
  edit (document, add_law, NULL);
  return document;
}

static void
apply (QnDocument *document, ModelEdit func, Change change)
{
  edit (document, func, &change);
}

static QnFaceSet
first_faces (QnDocument *document, guint count)
{
  const QnContacts *contacts = &document->contacts;
  g_assert_cmpuint (contacts->face_count, >=, count);
  static const QnId ids[] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 };
  g_assert_cmpuint (count, <=, G_N_ELEMENTS (ids));
  return (QnFaceSet){ contacts, ids, count };
}

static void
test_law (void)
{
  g_autoptr (QnDocument) document = open_stack ();
  apply (document, set_law, (Change){ first_faces (document, 2), 1, NULL });
  const QnContacts *contacts = &document->contacts;
  g_assert_cmpuint (document->project.model.override_count, ==, 2);
  g_assert_cmpint (contacts->faces[0].law_a, ==, 1);
  g_assert_cmpint (contacts->faces[1].law_b, ==, 1);
  /* None of its own again: no exception is left behind. */
  apply (document, set_law, (Change){ first_faces (document, 2), QN_NONE, NULL });
  g_assert_cmpuint (document->project.model.override_count, ==, 0);
}

/* All placements, one after the other; the law that was given before stays. */
static void
test_pairs (void)
{
  g_autoptr (QnDocument) document = open_stack ();
  apply (document, set_law, (Change){ first_faces (document, 1), 1, NULL });
  const QnPairRule rules[] = {
    { .placement = QN_PLACEMENT_ENDS, .offset = 0.01 },
    { .placement = QN_PLACEMENT_UNIFORM, .count = 5 },
    { .placement = QN_PLACEMENT_GAUSS, .count = 4 },
    { .placement = QN_PLACEMENT_EXPLICIT,
      .count = 3,
      .positions = { 0.1, 0.5, 0.9 },
      .weights = { 0.25, 0.5, 0.25 } },
  };
  const int32_t expected[] = { 2, 5, 4, 3 };
  for (gsize i = 0; i < G_N_ELEMENTS (rules); i++) {
    apply (document, set_pairs,
           (Change){ first_faces (document, 1), QN_NONE, &rules[i] });
    const QnContactFace *face = &document->contacts.faces[0];
    g_assert_cmpint (face->pair_count, ==, expected[i]);
    g_assert_cmpint (face->law_a, ==, 1);
    g_assert_cmpuint (document->project.model.override_count, ==, 1);
  }
  apply (document, set_pairs, (Change){ first_faces (document, 1), QN_NONE, NULL });
  g_assert_nonnull (
    qn_model_find_override (&document->project.model, &document->contacts.faces[0]));
  apply (document, set_law, (Change){ first_faces (document, 1), QN_NONE, NULL });
  g_assert_cmpuint (document->project.model.override_count, ==, 0);
}

/* The selection keeps its faces across an edit that numbers them anew. */
static void
test_selection (void)
{
  g_autoptr (QnDocument) document = open_stack ();
  QnSelection *selection = document->selection;
  const QnId faces[] = { 0, 1 };
  qn_selection_set (selection, QN_PICK_FACE, faces, 2);
  apply (document, set_law, (Change){ first_faces (document, 2), 1, NULL });
  guint count = 0;
  qn_selection_get (selection, QN_PICK_FACE, &count);
  g_assert_cmpuint (count, ==, 2);
  qn_selection_select_faces_like (selection, &document->contacts, 0, QN_LIKE_LAW);
  qn_selection_get (selection, QN_PICK_FACE, &count);
  g_assert_cmpuint (count, ==, 2);
  qn_selection_select_faces_like (selection, &document->contacts, 0, QN_LIKE_LINE);
  qn_selection_get (selection, QN_PICK_FACE, &count);
  g_assert_cmpuint (count, ==, 1);
  qn_selection_select_faces_like (selection, &document->contacts, 0, QN_LIKE_DIRECTION);
  qn_selection_get (selection, QN_PICK_FACE, &count);
  g_assert_cmpuint (count, ==, document->contacts.face_count);
}

QN_TESTS
{
  g_test_add_func ("/doc/edit-face/law", test_law);
  g_test_add_func ("/doc/edit-face/pairs", test_pairs);
  g_test_add_func ("/doc/edit-face/selection", test_selection);
}
