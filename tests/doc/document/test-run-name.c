/* What runs are called: proposed from what differs, said by the user, kept with the project. */
#include "doc/document/document.h"

#include "doc/edit/edit.h"
#include "doc/fixture.h"
#include "io/project/project.h"
#include "support/edit-model.h"
#include "support/room.h"

static gboolean
set_friction (QnModel *model, gpointer data, GError **error)
{
  (void) error;
  model->laws[0].friction = *(const double *) data;
  return TRUE;
}

static void
vary (QnDocument *document, double friction)
{
  g_assert_true (edit_model (document, "Friction", NULL, set_friction, &friction, NULL));
}

static void
test_proposed (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  QnRun *first = solve_example (document);
  g_assert_cmpstr (first->name, ==, "Run 1, load control");
  vary (document, 0.25);
  QnRun *second = solve_example (document);
  g_assert_cmpstr (second->label, ==, "friction 0.25");
  g_autoptr (GPtrArray) changes = qn_run_list_changes (first, second);
  g_assert_cmpuint (changes->len, ==, 1);
  g_assert_cmpstr (changes->pdata[0], ==, "friction 0.25");

  /* The same again takes the place of what was there; another method stands beside it. */
  second = solve_example (document);
  g_assert_cmpuint (document->runs->len, ==, 2);
  g_assert_cmpstr (second->label, ==, "friction 0.25");
  g_assert_true (
    qn_document_analyse_with (document, QN_PROCEDURE_LIMIT, QN_FLOW_ASSOCIATIVE, NULL));
  wait_for_job (document);
  g_assert_cmpuint (document->runs->len, ==, 3);
  g_assert_cmpstr (document->run->name, ==, "friction 0.25, associative limit analysis");

  /* A third one is named by what differs from the first; from where that is too much, by number. */
  vary (document, 0.75);
  g_assert_cmpstr (solve_example (document)->label, ==, "friction 0.75");
}

static void
test_given (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  QnRun *first = solve_example (document);
  g_autofree char *before = g_strdup (document->text->text);
  g_assert_true (qn_document_rename_run (document, first, " as built ", NULL));
  g_assert_cmpstr (first->name, ==, "as built, load control");
  g_assert_cmpint (qn_document_get_run_age (document, first), ==, QN_RUN_CURRENT);
  g_autofree char *kept = g_strdup (document->text->text);

  qn_document_undo (document);
  g_assert_cmpstr (first->label, ==, "Run 1");
  g_assert_cmpstr (document->text->text, ==, before);
  qn_document_redo (document);
  g_assert_cmpstr (first->label, ==, "as built");

  /* The next who opens the project and solves it finds the name. */
  g_autoptr (QnDocument) again = open_text (kept);
  g_assert_cmpstr (solve_example (again)->label, ==, "as built");
  /* No name is what was proposed, and leaves nothing behind. */
  g_assert_true (qn_document_rename_run (again, again->run, "", NULL));
  g_assert_cmpstr (again->run->label, ==, "Run 1");
  g_autofree char *rest =
    qn_project_dup_extra (qn_document_get_project (again), QN_RUN_NAMES_MEMBER);
  g_assert_null (rest);
}

/* What differs, of every kind that a project may. */
static void
test_changes (void)
{
  static const struct {
    const char *from, *to, *words;
  } cases[] = {
    { "{\"laws\":[{\"name\":\"a\",\"friction\":0.5}]}",
      "{\"laws\":[{\"name\":\"a\",\"friction\":0.6,\"cohesion\":100}]}",
      "friction 0.6|cohesion 100" },
    { "{\"laws\":[{\"name\":\"a\",\"ks\":1},{\"name\":\"b\",\"ks\":1}]}",
      "{\"laws\":[{\"name\":\"a\",\"ks\":1},{\"name\":\"b\",\"ks\":2}]}", "b: ks 2" },
    { "{\"masonry\":[{\"unit\":[0.4,0.2]}],\"blocks\":[1]}",
      "{\"masonry\":[{\"unit\":[0.25,0.125]}],\"blocks\":[1]}", "brick 0.25 × 0.125 m" },
    { "{\"loads\":{\"live\":[{\"kind\":\"weight\"}]}}", "{\"loads\":{\"live\":[]}}",
      "growing loads none" },
    { "{\"laws\":[{}]}", "{\"laws\":[{},{}]}", "other laws of joints" },
    { "{\"analysis\":{\"geometry\":\"nonlinear\"}}", "{\"analysis\":{}}",
      "geometry none" },
    { "{\"analysis\":{\"procedure\":\"load\"}}",
      "{\"analysis\":{\"procedure\":\"work\"}}", "method work control" },
    { "{\"title\":\"a\",\"view\":{}}", "{\"title\":\"b\"}", "" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autoptr (QnRun) from = qn_run_new ("", NULL), to = qn_run_new ("", NULL);
    from->text = g_strdup (cases[i].from);
    to->text = g_strdup (cases[i].to);
    g_autoptr (GPtrArray) changes = qn_run_list_changes (from, to);
    g_ptr_array_add (changes, NULL);
    g_autofree char *words = g_strjoinv ("|", (char **) changes->pdata);
    g_assert_cmpstr (words, ==, cases[i].words);
  }
}

static gboolean
remove_block (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_delete_blocks (model, (QnBlockSet){ data, 1 }, error);
}

/* Blocks that are gone are counted where nothing else has changed. */
static void
test_removed (void)
{
  g_autoptr (QnDocument) document = open_example ("05-stack.quoin");
  QnRun *first = solve_example (document);
  QnId last = (QnId) first->model.block_count - 1;
  g_assert_true (edit_model (document, "Delete", NULL, remove_block, &last, NULL));
  g_assert_cmpstr (solve_example (document)->label, ==, "1 block removed");
}

QN_TESTS
{
  g_test_add_func ("/run-name/removed", test_removed);
  g_test_add_func ("/run-name/proposed", test_proposed);
  g_test_add_func ("/run-name/given", test_given);
  g_test_add_func ("/run-name/changes", test_changes);
}
