/* quoin-cli report: pages, text that can be selected, sections, and what is refused. */
#include "cli-run.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

/* Which words a PDF has, and which it has not (nullable), by pdftotext where that is installed. */
static void
assert_words (const char *path, const char *const *there, const char *const *absent)
{
  g_autofree char *program = g_find_program_in_path ("pdftotext"), *text = NULL;
  const char *argv[] = { program, "-layout", path, "-", NULL };
  if (program == NULL) {
    g_test_skip ("pdftotext is not installed");
    return;
  }
  g_assert_true (
    g_spawn_sync (NULL, (char **) argv, NULL, 0, NULL, NULL, &text, NULL, NULL, NULL));
  g_autoptr (GRegex) blanks = g_regex_new ("\\s+", 0, 0, NULL); /* wherever lines break */
  g_autofree char *words = g_regex_replace_literal (blanks, text, -1, 0, " ", 0, NULL);
  for (; *there != NULL; there++)
    g_assert_nonnull (strstr (words, *there));
  for (; absent != NULL && *absent != NULL; absent++)
    g_assert_null (strstr (words, *absent));
}

#define WORDS(...) ((const char *const[]){ __VA_ARGS__, NULL })

static char *
report (const char *folder, const char *name, const char *option, const char *value)
{
  g_autofree char *model = cli_example ("06-arch.quoin");
  char *path = g_build_filename (folder, name, NULL);
  cli_do ("report", model, "-o", path, option, value, NULL);
  g_autofree char *bytes = cli_read (path);
  g_assert_true (g_str_has_prefix (bytes, "%PDF-"));
  return path;
}

/* Nothing is written beside the report: a machine without temporary files is no hindrance. */
static void
test_without_temporary (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("02-overturning-block.quoin");
  g_autofree char *path = g_build_filename (folder, "r.pdf", NULL);
  const char *arguments[] = { "report", model, "-o", path, NULL };
  cli_expect_done (cli_run_with (arguments, "TMPDIR", "/nonexistent"));
}

/* All sections of a project that is solved first; the same bytes each time. */
static void
test_whole (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_setenv ("SOURCE_DATE_EPOCH", "86400", TRUE); /* the day, on all days */
  g_autofree char *one = report (folder, "one.pdf", NULL, NULL);
  g_autofree char *two = report (folder, "two.pdf", NULL, NULL);
  g_autofree char *a = NULL, *b = NULL;
  gsize length_a, length_b;
  g_assert_true (g_file_get_contents (one, &a, &length_a, NULL));
  g_assert_true (g_file_get_contents (two, &b, &length_b, NULL));
  g_assert_cmpmem (a, length_a, b, length_b);
  assert_words (one,
                WORDS ("Semicircular arch", "Materials", "Loads and Analysis", "Findings",
                       "Contacts", "2 per joint, at the ends",
                       "Collapse at a load multiplier of 0.2864", "Hinges as in an arch",
                       "Mechanism", "Forces of joints: Analysis of the project",
                       "M (kN·m)", "e (mm)", "State", "Independent Check",
                       "Analysis of the project: passed", "Files and Versions",
                       "Joints of the table", "on 1970-01-02",
                       "the independent check is passed", "voussoir 2"),
                NULL);
}

/* The pages of a PDF as text; NULL where pdftotext is not installed. */
static char **
read_pages (const char *path)
{
  g_autofree char *program = g_find_program_in_path ("pdftotext"), *text = NULL;
  const char *argv[] = { program, "-layout", path, "-", NULL };
  if (program == NULL)
    return NULL;
  g_assert_true (
    g_spawn_sync (NULL, (char **) argv, NULL, 0, NULL, NULL, &text, NULL, NULL, NULL));
  return g_strsplit (text, "\f", -1);
}

/* The first page has the title, the picture, the answer, the hash and the version, and nothing else. What
 * follows a wide figure stands beneath it. */
static void
test_pages (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = report (folder, "report.pdf", NULL, NULL);
  g_auto (GStrv) pages = read_pages (path);
  gboolean beneath = FALSE;
  if (pages == NULL) {
    g_test_skip ("pdftotext is not installed");
    return;
  }
  static const char *const first[] = { "Semicircular arch", "Collapse at", "undeformed",
                                       "SHA-256", "quoin " };
  for (gsize i = 0; i < G_N_ELEMENTS (first); i++)
    g_assert_nonnull (strstr (pages[0], first[i]));
  g_assert_null (strstr (pages[0], "Model"));
  g_assert_true (g_str_has_prefix (pages[1], "Model"));
  for (char **page = pages; *page != NULL; page++)
    beneath |= strstr (*page, "Contacts\n") != NULL && strstr (*page, "Result:") != NULL
               && strstr (*page, "Mechanism") != NULL;
  g_assert_true (beneath);
}

/* So it does for the answers of three results. */
static void
test_first_page_of_three (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("ferris-tin-loi/wall3.quoin");
  g_autofree char *path = g_build_filename (folder, "path.json", NULL);
  g_autofree char *bound = g_build_filename (folder, "associative.json", NULL);
  g_autofree char *least = g_build_filename (folder, "non-associative.json", NULL);
  g_autofree char *pdf = g_build_filename (folder, "three.pdf", NULL);
  cli_do ("solve", model, "-q", "-o", path, NULL);
  cli_do ("limit", model, "-q", "-o", bound, NULL);
  cli_do ("limit", model, "-q", "--set", "analysis.flow=\"non-associative\"", "-o", least,
          NULL);
  cli_do ("report", model, "-r", path, "-r", bound, "-r", least, "-o", pdf, NULL);
  g_auto (GStrv) pages = read_pages (pdf);
  if (pages == NULL) {
    g_test_skip ("pdftotext is not installed");
    return;
  }
  g_assert_nonnull (strstr (pages[0], "non-associative.json: Collapse"));
  g_assert_nonnull (strstr (pages[0], "SHA-256"));
  g_assert_true (g_str_has_prefix (pages[1], "Model"));
}

/* A report of this page alone says on it what was assumed; its picture still has a caption. */
static void
test_first_page_alone (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("02-overturning-block.quoin");
  g_autofree char *pdf = g_build_filename (folder, "four.pdf", NULL);
  char *results[4];
  for (int i = 0; i < 4; i++) {
    g_autofree char *steps = g_strdup_printf ("analysis.increments=%d", 10 * (i + 1));
    g_autofree char *name = g_strdup_printf ("%d.json", i);
    results[i] = g_build_filename (folder, name, NULL);
    cli_do ("solve", model, "-q", "--set", steps, "-o", results[i], NULL);
  }
  cli_do ("report", model, "-r", results[0], "-r", results[1], "-r", results[2], "-r",
          results[3], "--sections", "title,results", "--demand", "0.1", "-o", pdf, NULL);
  for (int i = 0; i < 4; i++)
    g_free (results[i]);
  g_auto (GStrv) pages = read_pages (pdf);
  if (pages == NULL) {
    g_test_skip ("pdftotext is not installed");
    return;
  }
  g_assert_nonnull (strstr (pages[0], "Figure 1: 0.json"));
  g_assert_nonnull (strstr (pages[0], "3.json: Collapse"));
  g_assert_nonnull (strstr (pages[0], "SHA-256"));
}

/* Chosen sections and paper. */
static void
test_sections (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = report (folder, "part.pdf", "--sections", "title,materials");
  g_free (report (folder, "letter.pdf", "--paper", "Letter"));
  assert_words (path, WORDS ("Materials"),
                WORDS ("Independent Check", "Forces of joints"));
}

/* Several results of one project are compared. */
static void
test_results (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("06-arch.quoin");
  g_autofree char *path = g_build_filename (folder, "path.json", NULL);
  g_autofree char *limit = g_build_filename (folder, "limit.json", NULL);
  g_autofree char *pdf = g_build_filename (folder, "both.pdf", NULL);
  cli_do ("solve", model, "-q", "-o", path, NULL);
  cli_do ("limit", model, "-q", "-o", limit, NULL);
  cli_do ("report", model, "-r", path, "-r", limit, "-o", pdf, NULL);
  assert_words (pdf,
                WORDS ("Comparison", "path.json: passed", "limit.json: passed",
                       "Question: which multiple of the live load",
                       "no equilibrium above 0.2864, the associative bound",
                       "Associative bound", "Widest crack before collapse",
                       "joints that neither slide nor open are left out"),
                NULL);
  /* What was computed twice is told once, and every joint on request. */
  g_autofree char *again = g_build_filename (folder, "again.json", NULL);
  g_autofree char *twice = g_build_filename (folder, "twice.pdf", NULL);
  cli_do ("solve", model, "-q", "-o", again, NULL);
  cli_do ("report", model, "-r", path, "-r", again, "-o", twice, NULL);
  assert_words (twice, WORDS ("path.json: passed"), WORDS ("Comparison", "again.json"));
  cli_do ("report", model, "-r", path, "--sections", "joints", "-o", twice, NULL);
  assert_words (twice, WORDS ("Forces of joints"), WORDS ("left out"));
  /* Their pictures stand beside each other, titles in one line. */
  g_auto (GStrv) pages = read_pages (pdf);
  gboolean beside = pages == NULL;
  for (char **page = pages; page != NULL && *page != NULL; page++) {
    g_auto (GStrv) lines = g_strsplit (*page, "\n", -1);
    for (char **line = lines; *line != NULL; line++)
      beside |=
        strstr (*line, "path.json  ") != NULL && strstr (*line, "limit.json") != NULL;
  }
  g_assert_true (beside);
}

/* Loads are told with their case and its factor. */
static void
test_cases (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("27-retaining-wall.quoin");
  g_autofree char *pdf = g_build_filename (folder, "loads.pdf", NULL);
  cli_do ("report", model, "--sections", "loads,materials", "-o", pdf, NULL);
  assert_words (
    pdf,
    WORDS ("Dead load: Own weight", "Live load, soil × 1: Backfill on the left",
           "Live load, traffic × 1.5: Backfill on the left", "kn = ", " kN/m, "),
    WORDS ("SI units", "residual_friction", "dilation_end", "fracture_energy"));
}

/* Sections of beams, reinforcing bars and the start of a motion are told; a frame has no blocks to
 * count and no contacts to find anything about. */
static void
test_members (void)
{
  static const struct {
    const char *example;
    const char *there[6], *absent[4];
  } cases[] = {
    { "32-frame-beams.quoin",
      { "3 beams; 3 m wide, 3 m high", "Section", "E = 30000 MPa", "63.496 kN·m" },
      { "0 blocks", "Findings", "weigh" } },
    { "09-reinforced-cantilever.quoin",
      { "Reinforcing bars", "Diameter (mm)", "22.57", "400", "30000 MPa" },
      { "e+07", "e-" } },
    { "40-rocking-in-time.quoin",
      { "Initial displacement of block: -49.76 mm; 8.652 mm; 5.655°",
        "0.0001 s times the stiffness", "in time, in nonlinear geometry" },
      { "dynamic" } },
  };
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *pdf = g_build_filename (folder, "report.pdf", NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *model = cli_example (cases[i].example);
    cli_do ("report", model, "--sections", "model,materials,loads,findings", "-o", pdf,
            NULL);
    assert_words (pdf, cases[i].there, cases[i].absent);
  }
}

/* The first page says whether a demand is met, by what is proved alone. */
static void
test_demand (void)
{
  static const struct {
    const char *example, *command, *set, *demand, *there;
  } cases[] = {
    { "06-arch.quoin", "solve", NULL, "0.2", "met. 0.2864 is carried, 1.432 times" },
    { "06-arch.quoin", "solve", NULL, "0.4", "not met. 0.2864 is carried, 0.7159 times" },
    { "06-arch.quoin", "solve", "analysis.max_multiplier=0.1", "0.2",
      "not decided, for the path was not followed so far" },
    { "06-arch.quoin", "solve", "analysis.max_multiplier=0.1", "0.1",
      "met. 0.1 is carried" },
    { "06-arch.quoin", "limit", NULL, "0.2", "not decided, for the associative bound" },
    { "06-arch.quoin", "limit", NULL, "0.4", "not met. 0.2864" },
    { "06-arch.quoin", "limit", "analysis.geometry=nonlinear", "0.4",
      "It rests on associative limit analysis in linear geometry" },
    { "24-rocking-block.quoin", "solve", NULL, "0.2",
      "met. 0." }, /* of an earlier stage */
    { "24-rocking-block.quoin", "solve", NULL, "0.9", "not met. 0." },
    { "35-beam-column.quoin", "solve", NULL, "650", "not met. 617.4 is carried, 0.9498" },
    { "18-spreading-arch.quoin", "solve", NULL, "1",
      "not decided, for the question is another one" },
    { "40-rocking-in-time.quoin", "solve", NULL, "1",
      "not decided, for the question is another one" },
  };
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *result = g_build_filename (folder, "result.json", NULL);
  g_autofree char *pdf = g_build_filename (folder, "report.pdf", NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *model = cli_example (cases[i].example);
    cli_do (cases[i].command, model, "-q", "-o", result,
            cases[i].set != NULL ? "--set" : NULL, cases[i].set, NULL);
    cli_do ("report", model, "-r", result, "--sections", "title", "--demand",
            cases[i].demand, "-o", pdf, NULL);
    assert_words (pdf, WORDS (cases[i].there), NULL);
  }
  g_autofree char *slope = cli_example ("04-block-on-slope.quoin");
  CliRun unstable = cli_run ("report", slope, "--set", "laws[0].friction=0.1",
                             "--sections", "title", "--demand", "0.2", "-o", pdf, NULL);
  cli_assert_done (&unstable);
  cli_run_clear (&unstable);
  assert_words (pdf, WORDS ("not met. 0 is carried"), NULL);
  /* Every stage has its own procedure. */
  g_autofree char *rocking = cli_example ("24-rocking-block.quoin");
  cli_do ("report", rocking, "--sections", "title,loads", "-o", pdf, NULL);
  assert_words (pdf, WORDS ("It rests on load stages", "Procedure: load stages"),
                WORDS ("load control"));
  /* Or the project asks for it. */
  g_autofree char *model = cli_example ("06-arch.quoin");
  cli_do ("report", model, "--set", "report.demand=0.4", "--sections", "title", "-o", pdf,
          NULL);
  assert_words (pdf,
                WORDS ("Demand, a load multiplier of 0.4: not met", "The answer: figure",
                       "Assumptions: The structure, its loads",
                       "What Was Not Checked: Forces and motion out of"),
                NULL);
  cli_fails (2, "--demand", "report", model, "--demand", "-1", "-o", pdf, NULL);
}

/* Supports move by millimetres, as blocks do; reaction and cracks are told of all steps. */
static void
test_settlement (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("19-settling-wall.quoin");
  g_autofree char *pdf = g_build_filename (folder, "loads.pdf", NULL);
  cli_do ("report", model, "--sections", "loads", "-o", pdf, NULL);
  assert_words (pdf, WORDS ("uy: -15"), WORDS ("-0.015"));
  cli_do ("report", model, "--sections", "results", "-o", pdf, NULL);
  assert_words (pdf,
                WORDS ("Widest crack at the last step: 9.5", "Settlement (mm)",
                       "Reaction (kN)", "Widest crack (mm)", "w.1.5 – w.2.5"),
                NULL);
}

/* Two walls part as a foundation moves by 3 mm and turns by 2 mrad about a point 0.15 m below: 3 + 2 (y + 0.15) mm
 * at the height y, joint by joint in the report and in a table. */
static void
test_cracks (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_example ("51-parting-walls.quoin");
  g_autofree char *pdf = g_build_filename (folder, "r.pdf", NULL);
  g_autofree char *result = g_build_filename (folder, "r.json", NULL);
  g_autofree char *csv = g_build_filename (folder, "c.csv", NULL);
  cli_do ("solve", model, "-q", "-o", result, NULL);
  cli_do ("export", model, "--result", result, "--table", "cracks", "-o", csv, NULL);
  g_autofree char *text = cli_read (csv);
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
  g_assert_cmpstr (lines[0], ==,
                   "face,block a,block b,width [m],mean [m],x [m],y [m],line");
  const double widths[][2] = { { 7.3e-3, 6.3e-3 }, { 5.3e-3, 4.3e-3 } };
  for (gsize i = 0; i < G_N_ELEMENTS (widths); i++) {
    g_auto (GStrv) cells = g_strsplit (lines[i + 1], ",", -1);
    g_assert_cmpstr (cells[1], ==, i == 0 ? "\"l2\"" : "\"l1\"");
    g_assert_cmpfloat (fabs (g_ascii_strtod (cells[3], NULL) - widths[i][0]), <, 1e-5);
    g_assert_cmpfloat (fabs (g_ascii_strtod (cells[4], NULL) - widths[i][1]), <, 1e-5);
    g_assert_cmpfloat (fabs (g_ascii_strtod (cells[6], NULL) - (2 - (double) i)), <,
                       1e-9);
    g_assert_cmpstr (cells[7], ==, "1");
  }
  cli_do ("report", model, "--sections", "results", "-o", pdf, NULL);
  assert_words (
    pdf, WORDS ("joints have opened", "Mean (mm)", "6.3", "all of its joints"), NULL);
}

/* The page on a mechanism has the hand numbers of docs/method/capacity.md; a project that does not ask for it
 * has none, and one whose joints slide says why it is not checked. */
static void
test_mechanism (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *gable = cli_example ("47-gable-with-tie.quoin");
  g_autofree char *sliding = cli_example ("01-sliding-block.quoin");
  g_autofree char *pdf = g_build_filename (folder, "r.pdf", NULL);
  cli_do ("report", gable, "--sections", "mechanism", "-o", pdf, NULL);
  assert_words (pdf,
                WORDS ("Mechanism by code", "alpha0 0.18226", "e* 0.7469", "a0* 1.773",
                       "0.985 – not met", "d0* 0.3341 m", "9 blocks", "NTC 2018"),
                WORDS ("EN 1998-3"));
  cli_do ("report", gable, "--set", "capacity.mechanism=false", "-o", pdf, NULL);
  assert_words (pdf, WORDS ("Result:"), WORDS ("Mechanism by code"));
  cli_do ("report", sliding, "--set", "capacity.mechanism=true", "-o", pdf, NULL);
  assert_words (pdf, WORDS ("Not checked: ", "joints slide"), NULL);
}

/* Every combination of load cases with its multiplier: (42.4 x 0.3 + 0.3 x 8 x 0.15)/8.58 of the seismic one. A
 * project whose cases have no code has no such page; one whose cases have no action says so. */
static void
test_combinations (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *wall = cli_example ("50-wall-in-combinations.quoin");
  g_autofree char *arch = cli_example ("28-arch-under-fill.quoin");
  g_autofree char *pdf = g_build_filename (folder, "r.pdf", NULL);
  cli_do ("report", wall, "--sections", "combinations", "-o", pdf, NULL);
  assert_words (pdf,
                WORDS ("65 combinations by EN 1990", "The worst: seismic 6.12b", "1.524",
                       "EQU 6.10: 0.9 self + 0.9 floor", "stands"),
                WORDS ("no equilibrium"));
  cli_do ("report", arch, "-o", pdf, NULL);
  assert_words (pdf, WORDS ("Result:"), WORDS ("combinations by"));
  cli_do ("report", arch, "--set", "loads.combinations={\"code\":\"ntc2018\"}", "-o", pdf,
          NULL);
  assert_words (pdf, WORDS ("Not checked: ", "nothing to combine"), NULL);
}

/* Assumptions and what nobody has checked follow from the project, and figures are numbered as the words say. */
static void
test_assumptions (void)
{
  static const struct {
    const char *example;
    const char *there[7], *absent[5];
  } cases[] = {
    { "38-tied-walls.quoin",
      { "Joints carry no tension", "without dilation", "undeformed structure",
        "do not settle", "Ties carry tension alone", "joints of “dry joint”" },
      { "Anchors of ties", "Soil", "ground moves" } },
    { "47-gable-with-tie.quoin", { "Ties carry", "Figure 1: Model" }, { "Soil" } },
    { "19-settling-wall.quoin", { "but for the settlements" }, { "live load grows" } },
    { "26-crushing-tower.quoin", { "that slide open" }, { "any compression" } },
    { "46-cyclic-panel.quoin", { "tension and cohesion" }, { "no tension" } },
    { "27-retaining-wall.quoin", { "Soil loads and presses" }, { "Ties" } },
    { "40-rocking-in-time.quoin",
      { "of the deformed structure" },
      { "effect of displacements", "ground moves" } },
    { "42-arch-pulse.quoin", { "ground moves as one" }, { "live load grows" } },
    { "50-wall-in-combinations.quoin", { "out of the plane" }, { "partial factors" } },
  };
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *pdf = g_build_filename (folder, "r.pdf", NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *model = cli_example (cases[i].example);
    cli_do ("report", model, "--sections", "assumptions,model", "-o", pdf, NULL);
    assert_words (pdf, cases[i].there, cases[i].absent);
  }
  g_autofree char *bridge = cli_example ("53-arch-bridge.quoin");
  cli_do ("report", bridge, "--sections", "results,joints", "-o", pdf, NULL);
  /* Few cells of the table wrap, so that many do not. */
  assert_words (pdf,
                WORDS ("Mechanism: figure", "b.arch1.v24 – b.arch1.r2.v24",
                       "Load–displacement curve: figure", "Figure 1: Mechanism",
                       "Figure 2: Load", "-2.0"),
                WORDS ("-200"));
}

/* A project that is shaken is solved with its record, and tells what has moved. */
static void
test_record (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *example = cli_example ("43-shaken-wall.quoin");
  g_autofree char *record = cli_example ("43-synthetic-record.csv");
  g_autofree char *text = cli_read (example);
  g_autofree char *points = cli_read (record);
  g_autofree char *model = g_build_filename (folder, "model.quoin", NULL);
  g_autofree char *copy = g_build_filename (folder, "43-synthetic-record.csv", NULL);
  g_autofree char *pdf = g_build_filename (folder, "report.pdf", NULL);
  g_autoptr (GString) project = g_string_new (text);
  g_string_replace (project, "\"duration\": 10, ", "", 1);
  g_auto (GStrv) samples = g_strsplit (points, "\n", 22); /* to 0.1 s */
  points[strlen (points) - strlen (samples[21])] = '\0';
  g_assert_true (g_file_set_contents (model, project->str, -1, NULL));
  g_assert_true (g_file_set_contents (copy, points, -1, NULL));
  cli_do ("report", model, "-o", pdf, NULL);
  assert_words (pdf,
                WORDS ("Ground motion: 43-synthetic-record.csv", "Displacement in time",
                       "Displacement ux", "At its largest displacement", "Energy (",
                       "Acceleration (m/s", "Question: how does the structure move"),
                NULL);
}

/* The project's template: sections, author and introduction; options overrule it. */
static void
test_template (void)
{
  char *folder = test_scratch_new ();
  g_autofree char *example = cli_example ("06-arch.quoin");
  g_autofree char *text = cli_read (example);
  g_autofree char *model = g_build_filename (folder, "model.quoin", NULL);
  g_autofree char *pdf = g_build_filename (folder, "report.pdf", NULL);
  g_autoptr (GString) project = g_string_new (text);
  g_string_replace (project, "{",
                    "{ \"report\": { \"sections\": [\"title\", \"loads\"], \"paper\": "
                    "\"letter\", \"author\": \"A. Mason\", \"text\": \"Of an arch.\" },",
                    1);
  g_assert_true (g_file_set_contents (model, project->str, -1, NULL));
  cli_do ("report", model, "-o", pdf, NULL);
  assert_words (pdf, WORDS ("A. Mason", "Of an arch.", "Loads and Analysis"),
                WORDS ("Materials", "Independent Check"));
  cli_do ("report", model, "-o", pdf, "--sections", "materials", NULL);
  assert_words (pdf, WORDS ("Materials"), WORDS ("A. Mason", "Loads and Analysis"));
  g_string_replace (project, "\"loads\"], \"paper\"", "\"poem\"], \"paper\"", 1);
  g_assert_true (g_file_set_contents (model, project->str, -1, NULL));
  CliRun run = cli_run ("report", model, "-o", pdf, NULL);
  cli_assert_failed (&run, 3, "report.sections[1]");
  test_scratch_free (folder);
}

static void
test_refused (void)
{
  g_autofree char *model = cli_example ("06-arch.quoin");
  cli_fails (2, "-o is missing", "report", model, NULL);
  cli_fails (2, "a3", "report", model, "-o", "x.pdf", "--paper", "a3", NULL);
  cli_fails (2, "poem", "report", model, "-o", "x.pdf", "--sections", "title,poem", NULL);
  cli_fails (5, "nowhere.quoin", "report", "nowhere.quoin", "-o", "x.pdf", NULL);
  cli_fails (5, NULL, "report", model, "-o", "/nowhere/x.pdf", NULL);
}

QN_TESTS
{
  g_test_add_func ("/cli/report/without-temporary", test_without_temporary);
  g_test_add_func ("/cli/report/whole", test_whole);
  g_test_add_func ("/cli/report/pages", test_pages);
  g_test_add_func ("/cli/report/first-page-of-three", test_first_page_of_three);
  g_test_add_func ("/cli/report/first-page-alone", test_first_page_alone);
  g_test_add_func ("/cli/report/sections", test_sections);
  g_test_add_func ("/cli/report/results", test_results);
  g_test_add_func ("/cli/report/cases", test_cases);
  g_test_add_func ("/cli/report/members", test_members);
  g_test_add_func ("/cli/report/demand", test_demand);
  g_test_add_func ("/cli/report/settlement", test_settlement);
  g_test_add_func ("/cli/report/cracks", test_cracks);
  g_test_add_func ("/cli/report/mechanism", test_mechanism);
  g_test_add_func ("/cli/report/combinations", test_combinations);
  g_test_add_func ("/cli/report/assumptions", test_assumptions);
  g_test_add_func ("/cli/report/record", test_record);
  g_test_add_func ("/cli/report/template", test_template);
  g_test_add_func ("/cli/report/refused", test_refused);
}
