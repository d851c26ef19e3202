/* Writers that are killed or interrupted, again and again: what bears the name is always one whole
 * version, and no half of another lies beside it. */
#include "cli/cli-run.h"
#include "io/project/project.h"
#include "io/result/result-file.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#define KILLS 60

static guint
count_entries (const char *folder)
{
  guint count = 0;
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  while (g_dir_read_name (dir) != NULL)
    count++;
  return count;
}

/* The hidden files of a folder; they are removed. Each must hold `lengths` bytes: a kill in the
 * moment between naming and exchanging leaves a whole file under a hidden name. */
static guint
remove_hidden (const char *folder, const gsize lengths[2])
{
  guint count = 0;
  const char *name;
  GDir *dir = g_dir_open (folder, 0, NULL);
  while ((name = g_dir_read_name (dir)) != NULL) {
    g_autofree char *path = g_build_filename (folder, name, NULL), *content = NULL;
    gsize length;
    if (name[0] != '.')
      continue;
    g_assert_true (g_file_get_contents (path, &content, &length, NULL));
    g_assert_true (length == lengths[0] || length == lengths[1]);
    g_assert_cmpint (g_unlink (path), ==, 0);
    count++;
  }
  g_dir_close (dir);
  return count;
}

/* Saves two versions in turn until somebody ends it. */
static void
save_for_ever (const QnProject versions[2], const char *path)
{
  for (int i = 0;; i = 1 - i)
    if (!qn_project_save (&versions[i], path, NULL))
      _exit (1);
}

static void
test_kill_while_saving (void)
{
  static const char *const examples[] = { "13-aqueduct.quoin", "05-stack.quoin" };
  QnProject versions[2];
  char *texts[2];
  gsize lengths[2];
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "wall.quoin", NULL);
  GRand *random = g_rand_new_with_seed (7);
  guint hidden = 0;

  for (int i = 0; i < 2; i++) {
    g_autofree char *example = cli_example (examples[i]);
    g_assert_true (qn_project_load (example, NULL, &versions[i], NULL));
    texts[i] = qn_project_to_text (&versions[i], &lengths[i]);
  }
  g_assert_true (qn_project_save (&versions[0], path, NULL));
  for (int kill_number = 0; kill_number < KILLS; kill_number++) {
    int status;
    pid_t writer = fork ();
    g_assert_cmpint (writer, >=, 0);
    if (writer == 0)
      save_for_ever (versions, path);
    g_usleep ((gulong) g_rand_int_range (random, 500, 20000));
    g_assert_cmpint (kill (writer, SIGKILL), ==, 0);
    g_assert_cmpint (waitpid (writer, &status, 0), ==, writer);
    g_assert_true (WIFSIGNALED (status));

    g_autofree char *content = cli_read (path);
    g_assert_true (strcmp (content, texts[0]) == 0 || strcmp (content, texts[1]) == 0);
    hidden += remove_hidden (folder, lengths);
    g_assert_cmpuint (count_entries (folder), ==, 1);
  }
  g_test_message ("%d kills left %u whole files under hidden names", KILLS, hidden);
  g_rand_free (random);
  for (int i = 0; i < 2; i++) {
    g_free (texts[i]);
    qn_project_clear (&versions[i]);
  }
}

/* Starts quoin-cli, sends it signals after so long, and gives its exit code. */
static int
interrupt (char **command, int delay, int signal_number, int times)
{
  GPid child;
  int status;
  g_autoptr (GError) error = NULL;
  g_spawn_async (NULL, command, NULL,
                 G_SPAWN_DO_NOT_REAP_CHILD | G_SPAWN_STDOUT_TO_DEV_NULL
                   | G_SPAWN_STDERR_TO_DEV_NULL,
                 NULL, NULL, &child, &error);
  g_assert_no_error (error);
  g_usleep ((gulong) delay);
  for (int i = 0; i < times; i++)
    kill (child, signal_number);
  g_assert_cmpint (waitpid (child, &status, 0), ==, child);
  return WIFEXITED (status) ? WEXITSTATUS (status) : 128 + WTERMSIG (status);
}

typedef struct Interruption {
  int signal_number, times;
} Interruption;

/* Ctrl+C, pressed once or twice, and what a system that shuts down sends. */
static void
test_interrupt_solve (gconstpointer data)
{
  const Interruption *how = data;
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("12-facade.quoin");
  g_autofree char *output = g_build_filename (folder, "result.json", NULL);
  char *command[] = {
    (char *) g_getenv ("QUOIN_CLI"), "solve", model, "-q", "-o", output, NULL
  };
  int seen[256] = { 0 };

  for (int delay = 1000; delay < 3000000; delay += delay / 3) {
    int code = interrupt (command, delay, how->signal_number, how->times);
    gboolean there = g_file_test (output, G_FILE_TEST_EXISTS);
    seen[code]++;
    if (code != 0 && code != 130)
      g_assert_cmpint (code, ==, 128 + how->signal_number);
    g_assert_cmpuint (count_entries (folder), ==, there ? 1 : 0);
    if (there) {
      QnResultFile file;
      GError *error = NULL;
      qn_result_file_read (output, &file, &error);
      g_assert_no_error (error);
      qn_result_file_clear (&file);
      g_unlink (output);
    }
    if (code == 0)
      break;
  }
  g_test_message ("done: %d, cancelled: %d", seen[0], seen[130]);
  if (how->times == 1 && how->signal_number == SIGINT)
    g_assert_cmpint (seen[130], >, 0);
}

/* An animation asks after every frame, and leaves nothing. */
static void
test_interrupt_animation (gconstpointer data)
{
  const char *name = data;
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("ferris-tin-loi/wall3.quoin");
  g_autofree char *result = g_build_filename (folder, "result.json", NULL);
  g_autofree char *output = g_build_filename (folder, name, NULL);
  cli_do ("solve", model, "-q", "-o", result, NULL);
  char *command[] = { (char *) g_getenv ("QUOIN_CLI"),
                      "animate",
                      model,
                      "-r",
                      result,
                      "-q",
                      "--size",
                      "320x240",
                      "-o",
                      output,
                      NULL };
  int cancelled = 0;

  for (int delay = 20000; delay < 20000000; delay += delay / 2) {
    int code = interrupt (command, delay, SIGINT, 1);
    if (code == 0)
      break;
    g_assert_cmpint (code, ==, 130); /* before the handler stands: 128 + SIGINT as well */
    g_assert_cmpuint (count_entries (folder), ==, 1);
    cancelled++;
  }
  g_test_message ("cancelled %d times", cancelled);
  g_assert_cmpint (cancelled, >, 0);
}

QN_TESTS
{
  static const Interruption once = { SIGINT, 1 }, twice = { SIGINT, 2 };
  static const Interruption end = { SIGTERM, 1 };
  g_test_add_func ("/faults/kill/while-saving", test_kill_while_saving);
  g_test_add_data_func ("/faults/kill/interrupt-solve", &once, test_interrupt_solve);
  g_test_add_data_func ("/faults/kill/interrupt-solve-twice", &twice,
                        test_interrupt_solve);
  g_test_add_data_func ("/faults/kill/terminate-solve", &end, test_interrupt_solve);
  g_test_add_data_func ("/faults/kill/interrupt-gif", "a.gif", test_interrupt_animation);
  g_test_add_data_func ("/faults/kill/interrupt-frames", "a/", test_interrupt_animation);
  g_test_add_data_func ("/faults/kill/interrupt-webm", "a.webm",
                        test_interrupt_animation);
}
