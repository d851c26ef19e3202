/* A disk that fails at every call that changes it, one after the other, and one that is full:
 * quoin-cli says so in one line and exit code 5, the old file is as it was, and nothing is left
 * beside it. And a kill at each of these calls: what bears a name is the old file or the new one,
 * whole, and the next run writes all of it. */
#include "cli/cli-run.h"
#include "support/room.h"

#include <errno.h>
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>

#define OLD "what was there before\n"

/* A command that writes OUTPUT; the other words in capitals stand for what it reads: a project, its
 * result, a study that was computed. */
typedef struct Writing {
  const char *name;
  const char *output; /* a folder where it ends in a slash */
  const char *arguments[14];
} Writing;

static const Writing writings[] = {
  { "project",
    "out.quoin",
    { "generate", "wall", "length=2", "height=1", "-o", "OUTPUT" } },
  { "import", "out.quoin", { "import", "DRAWING", "-o", "OUTPUT" } },
  { "result", "out.json", { "solve", "MODEL", "-q", "--no-timings", "-o", "OUTPUT" } },
  { "figures", "out/", { "figures", "FIGURES", "-o", "OUTPUT" } },
  { "curve-csv", "out.csv", { "solve", "MODEL", "-q", "--csv", "OUTPUT" } },
  { "contacts-csv",
    "out.csv",
    { "export", "MODEL", "-r", "RESULT", "--table", "contacts", "-o", "OUTPUT" } },
  { "modal-csv", "out.csv", { "modal", "BEAM", "-q", "--csv", "OUTPUT" } },
  { "law-csv", "out.csv", { "law", "coulomb", "--csv", "OUTPUT" } },
  { "limit-csv", "out.csv", { "limit", "MODEL", "-q", "--csv", "OUTPUT" } },
  { "modal-result",
    "out.json",
    { "modal", "BEAM", "-q", "--no-timings", "-o", "OUTPUT" } },
  { "capacity-json", "out.json", { "capacity", "ROCKING", "-q", "--json", "OUTPUT" } },
  { "capacity-svg",
    "out.svg",
    { "capacity", "ROCKING", "-q", "--size", "200x150", "-o", "OUTPUT" } },
  { "study-table", "out.csv", { "study", "table", "STUDY", "-o", "OUTPUT" } },
  { "study-svg",
    "out.svg",
    { "study", "plot", "STUDY", "--kind", "histogram", "--size", "200x150", "-o",
      "OUTPUT" } },
  { "report", "out.pdf", { "report", "MODEL", "-r", "RESULT", "-o", "OUTPUT" } },
  { "compare-pdf",
    "out.pdf",
    { "compare", "MODEL=RESULT", "--size", "200x150", "-o", "OUTPUT" } },
  { "dxf", "out.dxf", { "export", "MODEL", "-r", "RESULT", "-o", "OUTPUT" } },
  { "pvd", "out.pvd", { "export", "MODEL", "-r", "RESULT", "-o", "OUTPUT" } },
  { "png", "out.png", { "render", "MODEL", "--size", "200x150", "-o", "OUTPUT" } },
  { "svg", "out.svg", { "render", "MODEL", "--size", "200x150", "-o", "OUTPUT" } },
  { "pdf", "out.pdf", { "render", "MODEL", "--size", "200x150", "-o", "OUTPUT" } },
  { "curve",
    "out.png",
    { "curve", "MODEL=RESULT", "--size", "200x150", "-o", "OUTPUT" } },
  { "gif",
    "out.gif",
    { "animate", "MODEL", "-r", "RESULT", "-q", "--frames", "4", "--size", "160x120",
      "-o", "OUTPUT" } },
  { "frames",
    "out/",
    { "animate", "MODEL", "-r", "RESULT", "-q", "--frames", "4", "--size", "160x120",
      "-o", "OUTPUT" } },
  { "webm",
    "out.webm",
    { "animate", "MODEL", "-r", "RESULT", "-q", "--frames", "4", "--size", "160x120",
      "-o", "OUTPUT" } },
};

/* A folder with an old file in the place of the output, and what commands read, beside it. */
typedef struct Place {
  const Writing *writing;
  char *inputs, *input, *result, *mark;
  char *folder, *output;
  char *old; /* the old file */
} Place;

static char *
fill_in (const Place *place, const char *argument)
{
  if (strcmp (argument, "OUTPUT") == 0)
    return g_strdup (place->output);
  if (strcmp (argument, "INPUT") == 0)
    return g_strdup (place->input);
  if (strcmp (argument, "RESULT") == 0)
    return g_strdup (place->result);
  if (strcmp (argument, "CURVES") == 0)
    return g_build_filename (place->folder, "curves.csv", NULL);
  if (strcmp (argument, "IN TIME") == 0)
    return cli_example ("40-rocking-in-time.quoin");
  if (strcmp (argument, "MODEL") == 0)
    return cli_example ("05-stack.quoin");
  if (strcmp (argument, "FIGURES") == 0)
    return g_build_filename (place->inputs, "figures.quoin", NULL);
  if (strcmp (argument, "ROCKING") == 0)
    return cli_example ("02-overturning-block.quoin");
  if (strcmp (argument, "STUDY") == 0)
    return g_build_filename (place->inputs, "study", NULL);
  if (strcmp (argument, "BEAM") == 0)
    return cli_example ("37-beam-vibrating.quoin");
  if (strcmp (argument, "DRAWING") == 0)
    return cli_example ("dxf/wall-clean.dxf");
  if (strcmp (argument, "MODEL=RESULT") == 0) {
    g_autofree char *model = cli_example ("05-stack.quoin");
    return g_strdup_printf ("%s=%s", model, place->result);
  }
  return g_strdup (argument);
}

static char **
command_of (const Place *place)
{
  g_autoptr (GStrvBuilder) builder = g_strv_builder_new ();
  g_strv_builder_add (builder, g_getenv ("QUOIN_CLI"));
  for (const char *const *a = place->writing->arguments; *a != NULL; a++) {
    g_autofree char *argument = fill_in (place, *a);
    g_strv_builder_add (builder, argument);
  }
  return g_strv_builder_end (builder);
}

/* A project with three pictures of its own, under the names of an animation's. */
static void
write_figures (const Place *place)
{
  static const char recipes[] =
    "{ \"figures\": [ { \"name\": \"a\", \"view\": \"model\", \"size\": \"200x150\", "
    "\"file\": \"frame-0001.png\" }, { \"name\": \"b\", \"view\": \"contacts\", "
    "\"size\": \"200x150\", \"file\": \"b.svg\" }, { \"name\": \"c\", \"view\": "
    "\"forces\", "
    "\"size\": \"200x150\", \"file\": \"c.pdf\" } ],";
  g_autofree char *example = cli_example ("05-stack.quoin");
  g_autofree char *text = cli_read (example);
  g_autofree char *changed = cli_replace (text, "{", recipes);
  g_free (cli_write (place->inputs, "figures.quoin", changed));
}

/* A study of two cases; the path of its file. Free with g_free(). */
static char *
write_study (const char *folder)
{
  static const char text[] =
    "{ \"format\": \"quoin-study\", \"version\": 1, \"model\": \"block.quoin\", "
    "\"run\": \"limit\", \"parameters\": [ { \"name\": \"friction\", "
    "\"path\": \"laws[0].friction\", \"distribution\": { \"kind\": \"uniform\", "
    "\"min\": 0.2, \"max\": 0.4 } } ], \"plan\": { \"kind\": \"monte-carlo\", "
    "\"count\": 2 }, \"outputs\": [ \"collapse_multiplier\" ] }";
  g_free (cli_write (folder, "block.quoin", cli_sliding_block));
  return cli_write (folder, "block.quoin-study", text);
}

/* A study that was computed, where a command reads one. */
static void
compute_study (const Place *place)
{
  g_autofree char *study = write_study (place->inputs);
  g_autofree char *folder = g_build_filename (place->inputs, "study", NULL);
  cli_do ("study", "run", study, "-q", "-o", folder, NULL);
}

/* The output folder with the old file alone. */
static void
put_old (const Place *place)
{
  if (g_str_has_suffix (place->writing->output, "/"))
    g_mkdir (place->output, 0777);
  g_assert_true (g_file_set_contents (place->old, OLD, -1, NULL));
}

static void
place_init (Place *place, const Writing *writing)
{
  *place = (Place){ .writing = writing };
  place->inputs = test_scratch_new ();
  place->result = g_build_filename (place->inputs, "result.json", NULL);
  place->mark = g_build_filename (place->inputs, "mark", NULL);
  g_autofree char *model = cli_example ("05-stack.quoin");
  cli_do ("solve", model, "-q", "-o", place->result, NULL);

  place->folder = test_scratch_new ();
  place->output = g_build_filename (place->folder, writing->output, NULL);
  place->old = g_strdup (place->output);
  if (g_str_has_suffix (writing->output, "/")) {
    g_free (place->old);
    place->old = g_build_filename (place->output, "frame-0001.png", NULL);
  }
  put_old (place);
  write_figures (place);
  if (g_strv_contains (writing->arguments, "STUDY"))
    compute_study (place);
}

static void
place_clear (Place *place)
{
  test_scratch_free (place->inputs);
  test_scratch_free (place->folder);
  g_free (place->input);
  g_free (place->result);
  g_free (place->mark);
  g_free (place->output);
  g_free (place->old);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Place, place_clear)

static guint
count_entries (const char *folder)
{
  guint count = 0;
  const char *name;
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  g_assert_nonnull (dir);
  while ((name = g_dir_read_name (dir)) != NULL) {
    g_test_message ("%s/%s", folder, name);
    count++;
  }
  return count;
}

static void
check_untouched (const Place *place)
{
  g_autofree char *content = cli_read (place->old);
  g_assert_cmpstr (content, ==, OLD);
  g_assert_cmpuint (count_entries (place->folder), ==, 1);
  if (place->old[strlen (place->output)] != '\0')
    g_assert_cmpuint (count_entries (place->output), ==, 1);
}

static void
limit_size (gpointer bytes)
{
  const struct rlimit limit = { GPOINTER_TO_SIZE (bytes), GPOINTER_TO_SIZE (bytes) };
  setrlimit (RLIMIT_FSIZE, &limit);
}

/* Runs the command with more in its environment; at most `bytes` in a file where not 0. */
static CliRun
run_in (const Place *place, char **environment, gsize bytes)
{
  CliRun run = { 0 };
  int status;
  g_autoptr (GError) error = NULL;
  g_auto (GStrv) command = command_of (place);
  g_spawn_sync (NULL, command, environment, G_SPAWN_DEFAULT,
                bytes > 0 ? limit_size : NULL, GSIZE_TO_POINTER (bytes), &run.out,
                &run.err, &status, &error);
  g_assert_no_error (error);
  run.code = WIFEXITED (status) ? WEXITSTATUS (status) : 128 + WTERMSIG (status);
  return run;
}

/* All was written although a call failed: one that is of no consequence, as closing what is given up. A
 * ParaView collection has files beside it. */
static void
check_written (const Place *place)
{
  g_autofree char *content = cli_read (place->old);
  g_assert_cmpstr (content, !=, OLD);
  g_assert_true (count_entries (place->folder) == 1
                 || g_str_has_suffix (place->old, ".pvd"));
  test_scratch_empty (place->folder);
  put_old (place);
}

/* The environment in which call `number` fails. */
static char **
dup_environment (const Place *place, int number, int code, gboolean named)
{
  g_autofree char *fault = g_strdup_printf ("%d:%d", number, code);
  char **environment = g_get_environ ();
  environment =
    g_environ_setenv (environment, "LD_PRELOAD", g_getenv ("QUOIN_FAILING_DISK"), TRUE);
  /* The address sanitizer has to be loaded first, which nothing here needs. */
  const char *options = g_getenv ("ASAN_OPTIONS");
  g_autofree char *asan =
    g_strconcat (options != NULL ? options : "", ":verify_asan_link_order=0", NULL);
  environment = g_environ_setenv (environment, "ASAN_OPTIONS", asan, TRUE);
  environment = g_environ_setenv (environment, "QUOIN_DISK_FAULT", fault, TRUE);
  environment = g_environ_setenv (environment, "QUOIN_DISK_MARK", place->mark, TRUE);
  if (named)
    environment = g_environ_setenv (environment, "QUOIN_DISK_NAMED", "1", TRUE);
  return environment;
}

/* Whether call `number` was made, and failed. */
static gboolean
fail_call (Place *place, int number, int code, gboolean named, int *harmless)
{
  g_auto (GStrv) environment = dup_environment (place, number, code, named);
  CliRun run = run_in (place, environment, 0);

  gboolean failed = g_remove (place->mark) == 0;
  g_test_message ("call %d: %s, exit code %d, %s", number, failed ? "failed" : "not made",
                  run.code, run.err);
  if (failed && run.code == 0) {
    check_written (place);
    ++*harmless;
  } else if (failed) {
    /* GStreamer has words of its own. */
    gboolean ours = !g_str_has_suffix (place->output, ".webm");
    cli_assert_failed (&run, 5, ours ? g_strerror (code) : NULL);
    check_untouched (place);
  } else {
    cli_assert_done (&run);
  }
  cli_run_clear (&run);
  return failed;
}

static void
fail_every_call (const Writing *writing, int code, gboolean named)
{
  g_auto (Place) place;
  int number = 1, harmless = 0;
  place_init (&place, writing);
  while (!g_test_failed () && fail_call (&place, number, code, named, &harmless))
    number++;
  g_test_message ("%d calls failed, %d without harm", number - 1, harmless);
  g_assert_cmpint (number, >=, 4);
  /* SQLite goes on where a study can be read only; ORC, which GStreamer uses, without a file of machine code;
   * several files are gathered in a folder, which is emptied file by file. */
  int most = 1;
  if (g_strv_contains (writing->arguments, "STUDY"))
    most = 3;
  else if (g_str_has_suffix (writing->output, ".webm"))
    most = 4;
  else if (g_str_has_suffix (writing->output, ".pvd")
           || g_str_has_suffix (writing->output, "/"))
    most = 12;
  g_assert_cmpint (harmless, <=, most);
}

static void
test_every_call (gconstpointer data)
{
  fail_every_call (data, ENOSPC, FALSE);
}

/* As on file systems where every file has a name. */
static void
test_every_call_named (gconstpointer data)
{
  fail_every_call (data, EIO, TRUE);
}

/* What stands under a name in a folder and those below it: contents by path. Hidden files and folders
 * are none. */
static void
collect (const char *folder, GHashTable *files)
{
  const char *name;
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  g_assert_nonnull (dir);
  while ((name = g_dir_read_name (dir)) != NULL) {
    char *path = g_build_filename (folder, name, NULL), *content;
    gsize length;
    if (name[0] == '.') {
      g_free (path);
    } else if (g_file_test (path, G_FILE_TEST_IS_DIR)) {
      collect (path, files);
      g_free (path);
    } else {
      g_assert_true (g_file_get_contents (path, &content, &length, NULL));
      g_hash_table_insert (files, path, g_bytes_new_take (content, length));
    }
  }
}

static GHashTable *
files_of (const Place *place)
{
  GHashTable *files = g_hash_table_new_full (g_str_hash, g_str_equal, g_free,
                                             (GDestroyNotify) g_bytes_unref);
  collect (place->folder, files);
  return files;
}

/* Every file is the old one or that of an undisturbed run. */
static void
check_whole (const Place *place, GHashTable *expected)
{
  g_autoptr (GHashTable) files = files_of (place);
  g_autoptr (GBytes) old = g_bytes_new_static (OLD, strlen (OLD));
  GHashTableIter iter;
  gpointer path, content;
  g_assert_true (g_hash_table_contains (files, place->old));
  g_hash_table_iter_init (&iter, files);
  while (g_hash_table_iter_next (&iter, &path, &content)) {
    GBytes *whole = g_hash_table_lookup (expected, path);
    if (strcmp (path, place->old) == 0 && g_bytes_equal (content, old))
      continue;
    g_test_message ("%s", (char *) path);
    g_assert_nonnull (whole);
    /* A WebM file has random numbers of its own in it, each in as few bytes as it takes, up to 8. */
    if (!g_str_has_suffix (path, ".webm"))
      g_assert_true (g_bytes_equal (content, whole));
    else
      g_assert_cmpfloat_with_epsilon ((double) g_bytes_get_size (content),
                                      (double) g_bytes_get_size (whole), 32);
  }
}

/* Killed at every call that changes the disk, then run again undisturbed. */
static void
kill_every_call (const Writing *writing, gboolean named)
{
  g_auto (Place) place;
  int number = 1, code;
  place_init (&place, writing);
  CliRun run = run_in (&place, NULL, 0);
  cli_assert_done (&run);
  cli_run_clear (&run);
  g_autoptr (GHashTable) expected = files_of (&place);
  do {
    test_scratch_empty (place.folder);
    put_old (&place);
    g_auto (GStrv) environment = dup_environment (&place, number, 0, named);
    run = run_in (&place, environment, 0);
    code = run.code;
    cli_run_clear (&run);
    g_remove (place.mark);
    check_whole (&place, expected);
    number++;
  } while (code == 128 + SIGKILL);
  g_assert_cmpint (code, ==, 0);
  g_test_message ("killed at %d calls", number - 2);
  g_assert_cmpint (number, >=, 5);

  g_autoptr (GHashTable) files = files_of (&place);
  g_assert_cmpuint (g_hash_table_size (files), ==, g_hash_table_size (expected));
}

static void
test_kill (gconstpointer data)
{
  kill_every_call (data, FALSE);
}

static void
test_kill_named (gconstpointer data)
{
  kill_every_call (data, TRUE);
}

static char *
study_table (const Place *place)
{
  CliRun run = cli_run ("study", "table", place->output, NULL);
  cli_assert_done (&run);
  char *table = g_steal_pointer (&run.out);
  cli_run_clear (&run);
  return table;
}

static char *
read_curves (const Place *place)
{
  g_autofree char *path = fill_in (place, "CURVES");
  return cli_read (path);
}

/* Commands that go on where they were interrupted, each with a file that it reads and what all of its
 * work comes to. */
typedef struct LongRun {
  Writing writing;
  char *(*write_input) (const char *folder);
  char *(*table) (const Place *place);
  int stride; /* of so many calls one is struck, unless the test is to be thorough */
} LongRun;

static char *
write_record (const char *folder)
{
  return cli_write (folder, "pulse.csv",
                    "time [s],acceleration [m/s2]\n0,0\n0.1,1\n0.2,0\n");
}

static const LongRun long_runs[] = {
  { { "study-run", "out/", { "study", "run", "INPUT", "-q", "-j", "1", "-o", "OUTPUT" } },
    write_study,
    study_table,
    1 },
  { { "ida",
      "out/",
      { "ida", "IN TIME", "--set=analysis.dynamic.duration=0.2", "--record", "INPUT",
        "--scale=1:2:1", "-q", "--jobs=1", "-o", "OUTPUT", "--csv", "CURVES" } },
    write_record,
    read_curves,
    3 },
};

/* Whether the curves that a run has left, if it has come to them, are those of an undisturbed one. */
static void
check_curves (const Place *place, const char *expected)
{
  g_autofree char *path = fill_in (place, "CURVES");
  g_autofree char *content = NULL;
  if (g_file_get_contents (path, &content, NULL, NULL))
    g_assert_cmpstr (content, ==, expected);
}

/* Struck at every call, with an error or, where `code` is 0, a kill: the same command goes on with what
 * is there, and what comes of it is that of an undisturbed run. */
static void
strike (const LongRun *job, int code)
{
  g_auto (Place) place = { .writing = &job->writing };
  int number = 0, struck = 0, stride = g_test_thorough () ? 1 : job->stride;
  place.inputs = test_scratch_new ();
  place.input = job->write_input (place.inputs);
  place.mark = g_build_filename (place.inputs, "mark", NULL);
  place.folder = test_scratch_new ();
  place.output = g_build_filename (place.folder, "out", NULL);
  CliRun run = run_in (&place, NULL, 0);
  cli_assert_done (&run);
  cli_run_clear (&run);
  g_autofree char *expected = job->table (&place);

  do {
    test_scratch_empty (place.folder);
    g_auto (GStrv) environment = dup_environment (&place, number += stride, code, FALSE);
    run = run_in (&place, environment, 0);
    struck = g_remove (place.mark) == 0;
    if (struck && code == 0)
      g_assert_cmpint (run.code, !=, 0);
    else if (!struck || run.code == 0)
      cli_assert_done (&run);
    g_test_message ("call %d: exit code %d, %s", number, run.code, run.err);
    cli_run_clear (&run);
    check_curves (&place, expected);

    run = run_in (&place, NULL, 0);
    cli_assert_done (&run);
    cli_run_clear (&run);
    g_autofree char *table = job->table (&place);
    g_assert_cmpstr (table, ==, expected);
  } while (struck && !g_test_failed ());
  g_test_message ("struck at %d calls", number / stride - 1);
  g_assert_cmpint (number, >, 20);
}

static void
test_long_run_kill (gconstpointer data)
{
  strike (data, 0);
}

static void
test_long_run_full (gconstpointer data)
{
  strike (data, ENOSPC);
}

/* No file may be larger than a few bytes: the system sends a signal that ends programs. */
static void
test_no_room (gconstpointer data)
{
  g_auto (Place) place;
  place_init (&place, data);
  CliRun run = run_in (&place, NULL, 64);
  cli_assert_failed (&run, 5, NULL);
  check_untouched (&place);
}

/* Text that a script reads. */
static void
test_full_standard_output (void)
{
  g_autofree char *model = cli_example ("05-stack.quoin");
  g_autofree char *line =
    g_strdup_printf ("'%s' check '%s' >/dev/full", g_getenv ("QUOIN_CLI"), model);
  const char *const command[] = { "/bin/sh", "-c", line, NULL };
  CliRun run = { 0 };
  int status;
  g_assert_true (g_spawn_sync (NULL, (char **) command, NULL, G_SPAWN_DEFAULT, NULL, NULL,
                               &run.out, &run.err, &status, NULL));
  run.code = WEXITSTATUS (status);
  cli_assert_failed (&run, 5, "standard output");
}

QN_TESTS
{
  for (size_t i = 0; i < G_N_ELEMENTS (writings); i++) {
    static const struct {
      const char *name;
      GTestDataFunc function;
    } faults[] = { { "every-call", test_every_call },
                   { "every-call-named", test_every_call_named },
                   { "kill", test_kill },
                   { "kill-named", test_kill_named },
                   { "no-room", test_no_room } };
    for (size_t k = 0; k < G_N_ELEMENTS (faults); k++) {
      /* One file and several: names do not depend on what is in them. */
      gboolean for_names = faults[k].function == test_every_call_named
                           || faults[k].function == test_kill_named;
      if (for_names && i > 0 && strcmp (writings[i].name, "frames") != 0)
        continue;
      /* Every figure is a file by itself: those before the one that fails are there. */
      if (strcmp (writings[i].name, "figures") == 0 && faults[k].function != test_kill)
        continue;
      g_autofree char *path =
        g_strdup_printf ("/faults/disk/%s/%s", writings[i].name, faults[k].name);
      g_test_add_data_func (path, &writings[i], faults[k].function);
    }
  }
  for (size_t i = 0; i < G_N_ELEMENTS (long_runs); i++) {
    const char *name = long_runs[i].writing.name;
    g_autofree char *kill = g_strdup_printf ("/faults/disk/%s/kill", name);
    g_autofree char *full = g_strdup_printf ("/faults/disk/%s/every-call", name);
    g_test_add_data_func (kill, &long_runs[i], test_long_run_kill);
    g_test_add_data_func (full, &long_runs[i], test_long_run_full);
  }
  g_test_add_func ("/faults/disk/standard-output", test_full_standard_output);
}
