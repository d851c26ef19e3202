/* quoin-cli figures and animate: the files they make, and what they refuse. */
#include "cli-run.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

static char *
with_figures (const char *figures)
{
  g_autofree char *member = g_strdup_printf ("{\n\"figures\": %s,", figures);
  return cli_replace (cli_sliding_block, "{", member);
}

static void
assert_begins (const char *path, const char *start)
{
  g_autofree char *bytes = NULL;
  gsize length = 0;
  g_assert_true (g_file_get_contents (path, &bytes, &length, NULL));
  g_assert_cmpuint (length, >, 500);
  g_assert_cmpint (memcmp (bytes, start, strlen (start)), ==, 0);
}

static void
test_figures (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text =
    with_figures ("[{\"name\": \"a\", \"view\": \"mechanism\", \"size\": \"300x200\"},"
                  "{\"name\": \"b\", \"view\": \"model\", \"file\": \"c.pdf\"}]");
  g_autofree char *model = cli_write (folder, "m.quoin", text);
  cli_do ("figures", model, NULL);
  g_autofree char *a = g_build_filename (folder, "a.png", NULL);
  g_autofree char *c = g_build_filename (folder, "c.pdf", NULL);
  assert_begins (a, "\x89PNG");
  assert_begins (c, "%PDF");

  /* Again gives the same bytes. */
  g_autofree char *first = NULL, *second = NULL;
  gsize lengths[2];
  g_assert_true (g_file_get_contents (a, &first, &lengths[0], NULL));
  cli_do ("figures", model, "--figure", "a", NULL);
  g_assert_true (g_file_get_contents (a, &second, &lengths[1], NULL));
  g_assert_cmpmem (first, lengths[0], second, lengths[1]);

  cli_says ("a\tmechanism\ta.png\tcurrent", "figures", model, "--list", NULL);

  cli_fails (2, "zebra", "figures", model, "--figure", "zebra", NULL);

  /* Neither of two takes the place of the other. */
  g_autofree char *twice = with_figures ("[{\"name\": \"d\"}, {\"name\": \"e\", "
                                         "\"file\": \"./d.png\"}]");
  g_autofree char *same = cli_write (folder, "same.quoin", twice);
  g_autofree char *d = g_build_filename (folder, "d.png", NULL);
  cli_fails (3, "the same file", "figures", same, NULL);
  g_assert_false (g_file_test (d, G_FILE_TEST_EXISTS));
  cli_do ("figures", same, "--figure", "e", NULL);
}

/* What a project names outside its folder is neither read nor written, unless that is allowed. */
static void
test_outside (void)
{
  static const char *const cases[][2] = {
    { "\"file\": \"../victim.png\"", "" },
    { "\"file\": \"out/victim.png\"", "" },
    { "\"result\": \"../victim.png\", \"view\": \"mechanism\"", "" },
    { "\"view\": \"model\"",
      "\"underlay\": {\"image\": \"../victim.png\", \"width\": 1}," },
  };
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *victim = cli_write (folder, "victim.png", "precious");
  g_autofree char *inner = g_build_filename (folder, "project", NULL);
  g_autofree char *link = g_build_filename (inner, "out", NULL);
  g_assert_cmpint (g_mkdir (inner, 0700), ==, 0);
  g_assert_cmpint (symlink ("..", link), ==, 0);
  for (guint i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *members = g_strdup_printf (
      "{%s\n\"figures\": [{\"name\": \"a\", %s}],", cases[i][1], cases[i][0]);
    g_autofree char *text = cli_replace (cli_sliding_block, "{", members);
    g_autofree char *model = cli_write (inner, "m.quoin", text);
    cli_fails (5, "outside the project's folder", "figures", model, NULL);
    g_autofree char *left = NULL;
    g_assert_true (g_file_get_contents (victim, &left, NULL, NULL));
    g_assert_cmpstr (left, ==, "precious");
  }
  g_autofree char *text = with_figures ("[{\"name\": \"a\", \"file\": \"../b.png\"}]");
  g_autofree char *model = cli_write (inner, "m.quoin", text);
  cli_do ("figures", model, "--allow-outside", NULL);
  g_autofree char *made = g_build_filename (folder, "b.png", NULL);
  assert_begins (made, "\x89PNG");
}

static void
test_changed_model_is_said (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text = with_figures (
    "[{\"name\": \"a\", \"size\": \"300x200\", \"model_digest\": \"0123\"}]");
  g_autofree char *model = cli_write (folder, "m.quoin", text);
  CliRun run = cli_run ("figures", model, NULL);
  g_assert_cmpint (run.code, ==, 0);
  g_assert_nonnull (strstr (run.err, "the model changed"));
  cli_run_clear (&run);
}

static void
test_wrong_recipe (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text = with_figures ("[{\"name\": \"a\", \"view\": \"round\"}]");
  g_autofree char *model = cli_write (folder, "m.quoin", text);
  cli_fails (3, "figures[0].view", "figures", model, NULL);
}

static void
test_animate (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "m.quoin", cli_sliding_block);
  g_autofree char *result = g_build_filename (folder, "r.json", NULL);
  g_autofree char *gif = g_build_filename (folder, "a.gif", NULL);
  g_autofree char *frames = g_build_filename (folder, "frames/", NULL);
  cli_do ("solve", model, "-q", "-o", result, NULL);

  const char *const views[] = { "mechanism", "deformed" };
  for (size_t i = 0; i < G_N_ELEMENTS (views); i++) {
    cli_do ("animate", model, "--result", result, "--view", views[i], "--frames", "4",
            "--size", "200x150", "-o", gif, NULL);
    assert_begins (gif, "GIF89a");
  }
  cli_do ("animate", model, "--result", result, "--frames", "3", "--size", "200x150",
          "-o", frames, NULL);
  g_autofree char *third = g_build_filename (frames, "frame-0003.png", NULL);
  assert_begins (third, "\x89PNG");

  cli_fails (2, "a.mp4", "animate", model, "--result", result, "-o", "a.mp4", NULL);
  cli_fails (2, "1000000", "animate", model, "--result", result, "--size",
             "1000000x1000000", "-o", gif, NULL);
  /* Too small for the encoder, or no encoder: said in either case, with nothing left behind. */
  g_autofree char *webm = g_build_filename (folder, "a.webm", NULL);
  CliRun run =
    cli_run ("animate", model, "--result", result, "--size", "1x1", "-o", webm, NULL);
  g_assert_cmpint (run.code, >, 0);
  g_assert_cmpint (run.code, <, 128);
  g_assert_nonnull (strstr (run.err, "WebM"));
  g_assert_false (g_file_test (webm, G_FILE_TEST_EXISTS));
  cli_run_clear (&run);
  cli_fails (5, "/nonexistent/a.gif", "animate", model, "--result", result, "-o",
             "/nonexistent/a.gif", NULL);
}

/* What has no result is solved, with the values of --set and the files of --allow-outside, whatever
 * shows it. */
static void
test_solved_alike (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *inner = g_build_filename (folder, "inner", NULL);
  g_autofree char *recipes =
    with_figures ("[{\"name\": \"f\", \"file\": \"f.png\", \"view\": \"deformed\", "
                  "\"size\": \"90x90\"}]");
  g_assert_cmpint (g_mkdir (inner, 0700), ==, 0);
  g_autofree char *model = cli_write (inner, "m.quoin", recipes);
  g_free (cli_write (folder, "r.csv", "0, 0\n0.01, 0.5\n0.02, 0\n"));
  const char *const in_time =
    "analysis={\"procedure\":\"dynamic\",\"geometry\":\"nonlinear\",\"dynamic\":{"
    "\"time_step\":0.01,\"ground\":[{\"record\":\"../"
    "r.csv\",\"unit\":\"m/s2\",\"direction\":[1,0]}]}}";
  static const char *const commands[][4] = {
    { "report", "o.pdf" },
    { "figures", "" },
    { "curve", "o.csv" },
    { "compare", "o.csv" },
    { "animate", "o.gif", "--frames", "4" },
    { "render", "o.svg", "--view", "deformed" },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (commands); i++) {
    const char *const *c = commands[i];
    g_autofree char *output = g_build_filename (inner, c[1], NULL);
    cli_fails (2, "laws[0].frictoin", c[0], model, "-o", output, "--set",
               "laws[0].frictoin=0.3", c[2], c[3], NULL);
    cli_fails (3, "loads.live", c[0], model, "-o", output, "--set", "loads.live=[]", c[2],
               c[3], NULL);
    cli_fails (5, "--allow-outside", c[0], model, "-o", output, "--set", in_time, c[2],
               c[3], NULL);
    cli_do (c[0], model, "-o", output, "--set", in_time, "--allow-outside", c[2], c[3],
            NULL);
    cli_do (c[0], model, "-o", output, "--set", "laws[0].friction=0.3", c[2], c[3], NULL);
    if (g_str_has_suffix (output, ".csv")) {
      g_autofree char *table = cli_read (output);
      g_assert_nonnull (strstr (table, ",0.3"));
      g_assert_null (strstr (table, ",0.4"));
    }
  }
  cli_fails (2, ".csv", "curve", model, "-o", "o.txt", NULL);
}

/* Three seconds at five pictures a second, in real time and four times slower. */
static void
test_speed (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("40-rocking-in-time.quoin");
  g_autofree char *result = g_build_filename (folder, "r.json", NULL);
  cli_do ("solve", model, "-q", "-o", result, NULL);
  const struct {
    const char *speed, *last, *beyond;
  } cases[] = { { "1", "one/frame-0016.png", "one/frame-0017.png" },
                { "0.25", "slow/frame-0061.png", "slow/frame-0062.png" } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *last = g_build_filename (folder, cases[i].last, NULL);
    g_autofree char *beyond = g_build_filename (folder, cases[i].beyond, NULL);
    g_autofree char *into = g_path_get_dirname (last);
    g_autofree char *frames = g_strconcat (into, "/", NULL);
    cli_do ("animate", model, "--result", result, "--speed", cases[i].speed, "--rate",
            "5", "--size", "120x90", "-o", frames, NULL);
    g_assert_true (g_file_test (last, G_FILE_TEST_EXISTS));
    g_assert_false (g_file_test (beyond, G_FILE_TEST_EXISTS));
  }
  cli_fails (2, "pictures", "animate", model, "--result", result, "--speed", "1e-5", "-o",
             "a.gif", NULL);
  cli_fails (2, "--speed", "animate", model, "--result", result, "--speed", "-1", "-o",
             "a.gif", NULL);
  cli_fails (2, "--frames", "animate", model, "--result", result, "--speed", "1",
             "--frames", "9", "-o", "a.gif", NULL);
  g_autofree char *still = cli_write (folder, "m.quoin", cli_sliding_block);
  g_autofree char *path = g_build_filename (folder, "still.json", NULL);
  cli_do ("solve", still, "-q", "-o", path, NULL);
  cli_fails (2, "--speed", "animate", still, "--result", path, "--speed", "1", "-o",
             "a.gif", NULL);
}

QN_TESTS
{
  g_test_add_func ("/cli/figures/made", test_figures);
  g_test_add_func ("/cli/figures/outside", test_outside);
  g_test_add_func ("/cli/figures/changed-model", test_changed_model_is_said);
  g_test_add_func ("/cli/figures/wrong-recipe", test_wrong_recipe);
  g_test_add_func ("/cli/figures/solved-alike", test_solved_alike);
  g_test_add_func ("/cli/animate", test_animate);
  g_test_add_func ("/cli/animate/speed", test_speed);
}
