#include "doc/document/recovery.h"
#include "support/edit-model.h"

#include <glib/gstdio.h>
#include <unistd.h>

static gboolean
add_block (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  const QnVec2 v[] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 } };
  QnBlock *block = qn_model_add_block (model, "b", v, 3);
  block->thickness = 1.0;
  block->unit_weight = 1e4;
  return TRUE;
}

static guint
count_files (void)
{
  g_autofree char *folder = qn_recovery_dup_folder ();
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  guint count = 0;
  while (dir != NULL && g_dir_read_name (dir) != NULL)
    count++;
  return count;
}

static void
test_life (void)
{
  g_autoptr (QnDocument) document = qn_document_new ();
  QnRecovery *recovery = qn_recovery_watch (document);
  g_assert_cmpuint (count_files (), ==, 0);
  edit_model (document, "Add", NULL, add_block, NULL, NULL);
  qn_recovery_flush (recovery);
  g_assert_cmpuint (count_files (), ==, 1);
  /* Nothing is offered while the program that wrote it runs. */
  g_autoptr (GPtrArray) none = qn_recovery_list ();
  g_assert_cmpuint (none->len, ==, 0);

  /* Undone: nothing to recover. */
  qn_document_undo (document);
  g_assert_cmpuint (count_files (), ==, 0);
  qn_document_redo (document);
  qn_recovery_flush (recovery);
  g_assert_cmpuint (count_files (), ==, 1);
  qn_recovery_end (recovery);
  g_assert_cmpuint (count_files (), ==, 0);
}

/* What a crashed program left is found, read and removed; the user's file stays untouched. */
static void
test_after_a_crash (void)
{
  if (g_test_subprocess ()) {
    QnDocument *document = qn_document_new ();
    QnRecovery *recovery = qn_recovery_watch (document);
    edit_model (document, "Add", NULL, add_block, NULL, NULL);
    qn_recovery_flush (recovery);
    _exit (0);
  }
  g_test_trap_subprocess (NULL, 0, G_TEST_SUBPROCESS_DEFAULT);
  g_test_trap_assert_passed ();
  /* A program of the same process number, as every start in a sandbox has, or a file of another one
   * after a reboot: the name says nothing. */
  g_autoptr (GPtrArray) found = qn_recovery_list ();
  g_assert_cmpuint (found->len, ==, 1);
  g_autofree char *folder = qn_recovery_dup_folder ();
  g_autofree char *mine = g_strdup_printf ("%s/%d-x.recovery", folder, (int) getpid ());
  g_assert_cmpint (g_rename (g_ptr_array_index (found, 0), mine), ==, 0);
  g_ptr_array_unref (found);
  found = qn_recovery_list ();
  g_assert_cmpuint (found->len, ==, 1);
  const char *path = g_ptr_array_index (found, 0);

  g_autofree char *text = NULL, *original = NULL;
  g_assert_true (qn_recovery_read (path, &text, &original, NULL));
  g_assert_null (original);
  g_autoptr (QnDocument) document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  qn_document_load_recovered (document, text, NULL, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (document->project.model.block_count, ==, 1);
  g_assert_true (qn_document_is_modified (document));
  g_unlink (path);
  g_autoptr (GPtrArray) after = qn_recovery_list ();
  g_assert_cmpuint (after->len, ==, 0);
}

static void
test_damaged (void)
{
  g_autofree char *folder = qn_recovery_dup_folder ();
  g_autofree char *path = g_build_filename (folder, "0-x.recovery", NULL);
  g_mkdir_with_parents (folder, 0700);
  g_assert_true (g_file_set_contents (path, "", -1, NULL));
  g_autofree char *text = NULL, *original = NULL;
  g_assert_true (qn_recovery_read (path, &text, &original, NULL));
  g_autoptr (QnDocument) document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_document_load_recovered (document, text, NULL, &error));
  g_assert_nonnull (error);
  g_unlink (path);
  g_assert_false (qn_recovery_read (path, &text, &original, NULL));
}

/* A state folder of our own: GLib's isolated folders are never freed, as the leak check reports. The crashing program of a test inherits it. */
static char *
isolate (void)
{
  if (g_getenv ("QUOIN_TEST_ISOLATED") != NULL)
    return NULL;
  char *home = g_dir_make_tmp ("quoin-test-XXXXXX", NULL);
  g_assert_nonnull (home);
  g_setenv ("XDG_STATE_HOME", home, TRUE);
  g_setenv ("QUOIN_TEST_ISOLATED", "1", TRUE);
  return home;
}

int
main (int argc, char **argv)
{
  g_autofree char *home = isolate ();
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/doc/recovery/life", test_life);
  g_test_add_func ("/doc/recovery/after-a-crash", test_after_a_crash);
  g_test_add_func ("/doc/recovery/damaged", test_damaged);
  int status = g_test_run ();
  if (home != NULL) {
    g_autofree char *recovery = qn_recovery_dup_folder ();
    g_autofree char *quoin = g_path_get_dirname (recovery);
    g_rmdir (recovery);
    g_rmdir (quoin);
    g_rmdir (home);
  }
  return status;
}
