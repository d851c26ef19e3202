#include "doc/edit/repair.h"

#include "doc/fixture.h"
#include "io/text/text-format.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <string.h>

typedef struct Fix {
  QnFinding finding;
  QnRepair repair;
} Fix;

static gboolean
repair (QnModel *model, gpointer data, GError **error)
{
  const Fix *fix = data;
  return qn_edit_repair (model, &fix->finding, fix->repair, error);
}

static gboolean
repair_all (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_repair_all (model, data, error);
}

/* A fixed block of 1 x 0.5 m, and another one above it that begins at `bottom`. */
static QnDocument *
open_pair (double bottom)
{
  char y0[G_ASCII_DTOSTR_BUF_SIZE];
  g_ascii_dtostr (y0, sizeof y0, bottom);
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin\", \"version\": 1,"
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": 0.6 } ],"
    "  \"blocks\": [ { \"name\": \"below\", \"vertices\": [[0,0],[1,0],[1,0.5],[0,0.5]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
    "    { \"name\": \"above\", \"vertices\": [[0,%s],[1,%s],[1,1.2],[0,1.2]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4 } ],"
    "  \"contact\": { \"law\": \"dry\" } }",
    y0, y0);
  return open_text (text);
}

static QnFinding
finding_of (QnDocument *document, QnProblem problem)
{
  const QnFindings *findings = &document->contacts.findings;
  for (gsize i = 0; i < findings->count; i++) {
    if (findings->items[i].problem == problem)
      return findings->items[i];
  }
  g_assert_not_reached ();
}

/* Every choice for a finding leaves a model without it, in one step that can be undone. */
static void
check_every_choice (QnDocument *opened, QnProblem problem, guint expected)
{
  g_autoptr (QnDocument) document = opened;
  QnFinding finding = finding_of (document, problem);
  QnRepair choices[QN_REPAIR_COUNT];
  guint count =
    qn_repair_get_choices (&document->project.model, &finding, FALSE, choices);
  g_assert_cmpuint (count, ==, expected);
  g_autofree char *before = g_strdup (document->text->text);
  for (guint i = 0; i < count; i++) {
    g_autofree char *what =
      qn_repair_explain (&document->project.model, &finding, choices[i]);
    g_assert_true (choices[i] == QN_REPAIR_CLOSE || strstr (what, "above") != NULL
                   || strstr (what, "these 2 blocks") != NULL);
    Fix fix = { finding, choices[i] };
    g_autoptr (GError) error = NULL;
    edit_model (document, qn_repair_words[choices[i]].step, NULL, repair, &fix, &error);
    g_assert_no_error (error);
    const QnContacts *contacts = &document->contacts;
    for (gsize k = 0; k < contacts->findings.count; k++)
      g_assert_cmpint (contacts->findings.items[k].problem, !=, problem);
    if (choices[i] == QN_REPAIR_CLOSE || choices[i] == QN_REPAIR_SNAP
        || choices[i] == QN_REPAIR_TRIM || choices[i] == QN_REPAIR_MOVE)
      g_assert_cmpuint (contacts->face_count, ==, 1);
    g_assert_true (qn_document_undo (document));
    g_assert_cmpstr (document->text->text, ==, before);
  }
}

static void
test_gap (void)
{
  check_every_choice (open_pair (0.5004), QN_PROBLEM_NEAR_MISS_GAP, 4);
}

static void
test_overlap (void)
{
  check_every_choice (open_pair (0.4), QN_PROBLEM_BLOCKS_OVERLAP, 3);
}

static void
test_loose (void)
{
  check_every_choice (open_pair (0.8), QN_PROBLEM_BLOCK_FLOATING, 2);
}

/* A thin course on top of twelve others is repaired as a whole. */
static void
test_thin_course (void)
{
  GString *text = g_string_new (
    "{ \"format\": \"quoin\", \"version\": 1,"
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": 0.6 } ], \"contact\": { \"law\": \"dry\" }, \"blocks\": [");
  for (int i = 0; i < 26; i++) {
    const int x = i % 2, low = i / 2 * 50, high = low + (i < 24 ? 50 : 3);
    g_string_append_printf (
      text,
      "%s{ \"name\": \"b%d\", \"vertices\": "
      "[[%d,%de-2],[%d,%de-2],[%d,%de-2],[%d,%de-2]],"
      "  \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [%s] }",
      i == 0 ? "" : ",", i, x, low, x + 1, low, x + 1, high, x, high,
      i < 2 ? "true, true, true" : "false, false, false");
  }
  g_string_append (text, "] }");
  check_every_choice (open_text (text->str), QN_PROBLEM_BLOCK_SLIVER, 2);
  g_string_free (text, TRUE);
}

/* The supported block stays where it is; the free one comes to it. */
static void
test_who_moves (void)
{
  g_autoptr (QnDocument) document = open_pair (0.5004);
  Fix fix = { finding_of (document, QN_PROBLEM_NEAR_MISS_GAP), QN_REPAIR_SNAP };
  g_assert_true (edit_model (document, "Snap", NULL, repair, &fix, NULL));
  const QnModel *model = &document->project.model;
  QnId below = qn_model_find_block (model, "below");
  QnId above = qn_model_find_block (model, "above");
  g_assert_cmpfloat_with_epsilon (model->blocks[below].area, 0.5, 1e-15);
  g_assert_cmpfloat_with_epsilon (model->blocks[above].area, 0.7, 1e-12);
}

static void
test_all (void)
{
  g_autoptr (QnDocument) document = open_pair (0.5004);
  guint count = 0;
  g_assert_true (edit_model (document, "All", NULL, repair_all, &count, NULL));
  g_assert_cmpuint (count, ==, 1);
  g_assert_cmpuint (document->contacts.findings.count, ==, 0);
  g_assert_cmpuint (document->history->steps->len, ==, 1);
  g_autoptr (GError) error = NULL;
  g_assert_false (edit_model (document, "All", NULL, repair_all, &count, &error));
  g_assert_error (error, QN_EDIT_ERROR, 0);
}

/* A course of three blocks with mortar on a fixed one; the last has a corner cut off. */
static QnDocument *
open_mortar (void)
{
  return open_text (
    "{ \"format\": \"quoin\", \"version\": 1,"
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": 0.6 } ],"
    "  \"blocks\": [ { \"name\": \"base\", \"vertices\": "
    "[[0,0],[1.52,0],[1.52,0.3],[0,0.3]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
    "    { \"name\": \"a\", \"vertices\": [[0,0.31],[0.5,0.31],[0.5,0.6],[0,0.6]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4 },"
    "    { \"name\": \"b\", \"vertices\": [[0.51,0.312],[1,0.312],[1,0.6],[0.51,0.6]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4 },"
    "    { \"name\": \"c\", \"vertices\": "
    "[[1.02,0.308],[1.52,0.308],[1.52,0.5],[1.4,0.6],"
    "    [1.02,0.6]], \"thickness\": 1, \"unit_weight\": 1e4 } ],"
    "  \"contact\": { \"law\": \"dry\" } }");
}

static gboolean
close_gaps (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_close_gaps (model, *(const double *) data, error);
}

/* Joints that are equally wide when they are written have one width. */
static void
test_widths (void)
{
  g_autofree char *alike = qn_widths_dup_text (0.012, 0.012, 0.0120001);
  g_autofree char *apart = qn_widths_dup_text (0.012, 0.01203, 0.0121);
  g_autofree char *begins = qn_widths_dup_text (0.001, 0.008, 0.012);
  g_assert_cmpstr (alike, ==, "12 mm");
  g_assert_cmpstr (apart, ==, "12 to 12.1 mm (mean 12 mm)");
  g_assert_cmpstr (begins, ==, "1 to 12 mm (mean 8 mm)");
}

/* Blocks that mortar parts from the ground are not fixed to it: the gaps are closed, all in one step,
 * and the bed stays level. */
static void
test_mortar (void)
{
  g_autoptr (QnDocument) document = open_mortar ();
  g_autofree char *before = g_strdup (document->text->text);
  QnGaps gaps;
  qn_model_find_gaps (&document->project.model, 0, &gaps);
  g_assert_cmpuint (gaps.count, ==, 5);
  g_autofree char *text = qn_gaps_dup_text (&gaps);
  g_assert_cmpstr (text, ==, "5 joints of mortar, 8 to 20 mm (mean 12 mm) wide");
  qn_gaps_clear (&gaps);

  QnFinding finding = finding_of (document, QN_PROBLEM_BLOCK_FLOATING);
  QnRepair choices[QN_REPAIR_COUNT];
  guint count = qn_repair_get_choices (&document->project.model, &finding, TRUE, choices);
  g_assert_cmpuint (count, ==, 2);
  g_assert_cmpint (choices[0], ==, QN_REPAIR_CLOSE);
  g_assert_cmpint (choices[1], ==, QN_REPAIR_DELETE);
  Fix fix = { finding, QN_REPAIR_CLOSE };
  double widths[] = { 0.001, 0.025 };
  g_autoptr (GError) error = NULL;
  g_assert_false (edit_model (document, "Close", NULL, close_gaps, &widths[0], &error));
  g_assert_error (error, QN_EDIT_ERROR, 0);
  for (int way = 0; way < 3; way++) {
    guint repaired = 0;
    const ModelEdit edits[] = { repair, close_gaps, repair_all };
    gpointer data[] = { &fix, &widths[1], &repaired };
    g_assert_true (edit_model (document, "Close", NULL, edits[way], data[way], NULL));
    const QnContacts *contacts = &document->contacts;
    const QnModel *model = &document->project.model;
    g_assert_cmpuint (contacts->face_count, ==, 5);
    g_assert_cmpuint (contacts->findings.count, ==, 0);
    g_assert_cmpuint (document->history->steps->len, ==, 1);
    for (gsize i = 0; i < contacts->face_count; i++)
      if (model->blocks[contacts->faces[i].a].support[0]
          || model->blocks[contacts->faces[i].b].support[0])
        g_assert_cmpfloat (contacts->faces[i].start.y, ==, contacts->faces[i].end.y);
    g_assert_true (qn_document_undo (document));
    g_assert_cmpstr (document->text->text, ==, before);
  }
}

QN_TESTS
{
  g_test_add_func ("/doc/repair/gap", test_gap);
  g_test_add_func ("/doc/repair/overlap", test_overlap);
  g_test_add_func ("/doc/repair/loose", test_loose);
  g_test_add_func ("/doc/repair/thin-course", test_thin_course);
  g_test_add_func ("/doc/repair/who-moves", test_who_moves);
  g_test_add_func ("/doc/repair/all", test_all);
  g_test_add_func ("/doc/repair/mortar", test_mortar);
  g_test_add_func ("/doc/repair/widths", test_widths);
}
