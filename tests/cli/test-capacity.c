/* quoin-cli capacity: numbers, files, and what is refused. */
#include "cli-run.h"

#include "support/room.h"
#include "support/table.h"

#include <cJSON.h>
#include <math.h>
#include <string.h>

static const char block[] =
  "{ \"format\": \"quoin\", \"version\": 1,\n"
  "  \"laws\": [ { \"name\": \"j\", \"kind\": \"coulomb\", \"basis\": \"contact\", "
  "\"kn\": 1e10,\n"
  "    \"ks\": 1e10, \"friction\": 0.7 } ],\n"
  "  \"blocks\": [ { \"name\": \"ground\", \"vertices\": [[-1, -0.2], [1, -0.2], [1, 0], "
  "[-1, 0]],\n"
  "    \"thickness\": 1, \"density\": 2000, \"support\": [true, true, true] },\n"
  "    { \"name\": \"block\", \"vertices\": [[-0.3, 0], [0.3, 0], [0.3, 3], [-0.3, 3]],\n"
  "    \"thickness\": 1, \"density\": 2000 } ],\n"
  "  \"contact\": { \"law\": \"j\" },\n"
  "  \"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] } ],\n"
  "    \"live\": [ { \"kind\": \"weight\", \"direction\": [1, 0] } ] },\n"
  "  \"analysis\": { \"procedure\": \"load\" } }\n";

static double
number_after (const char *text, const char *key)
{
  const char *at = strstr (text, key);
  g_assert_nonnull (at);
  return g_ascii_strtod (at + strlen (key), NULL);
}

/* A gable from the side, ten courses that become lighter upwards: each moves by its height, and the lowest
 * counts though it moves by a twentieth. e* = (sum W h)^2 / (sum W sum W h^2). */
static void
test_gable (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  const char *courses = strstr (block, "{ \"name\": \"block\"");
  g_autoptr (GString) text = g_string_new_len (block, courses - block);
  double sum = 0, first = 0, second = 0;
  for (int i = 0; i < 10; i++) {
    double y = 0.3 * i, width = 5.7 - 0.6 * i, h = y + 0.15;
    g_string_append_printf (
      text,
      "%s{\"name\": \"c%d\", \"vertices\": [[0, %.1f], [0.3, %.1f], [0.3, %.1f], "
      "[0, %.1f]], \"thickness\": %.1f, \"density\": 2000}",
      i > 0 ? ", " : "", i, y, y, y + 0.3, y + 0.3, width);
    sum += width;
    first += width * h;
    second += width * h * h;
  }
  g_string_append (text, strstr (courses, " ],\n  \"contact\""));
  g_autofree char *model = cli_write (folder, "gable.quoin", text->str);
  g_autofree char *json = g_build_filename (folder, "c.json", NULL);
  cli_do ("capacity", model, "--json", json, NULL);
  g_autofree char *found = cli_read (json);
  g_assert_cmpfloat (number_after (found, "\"participating_blocks\": "), ==, 10);
  g_assert_cmpfloat (number_after (found, "\"mass_left_out\": "), ==, 0);
  g_assert_cmpfloat_with_epsilon (number_after (found, "\"mass_share\": "),
                                  first * first / (sum * second), 0.005);
}

/* The curve ends where its multiplier is zero. Beyond, where a rough block turns over its corner onto its side,
 * there is no end, but that is not asked for. */
static void
test_rough_block (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "block.quoin", block);
  g_autofree char *json = g_build_filename (folder, "c.json", NULL);
  cli_do ("capacity", model, "--spectrum", "type1", "--ag", "2.4525", "--soil", "C",
          "--set", "laws[0].friction=3", "--set", "analysis.max_factorizations=2000",
          "--json", json, NULL);
  g_autofree char *found = cli_read (json);
  g_assert_cmpfloat_with_epsilon (number_after (found, "\"end_displacement\": "), 0.3,
                                  1e-4);
  g_assert_nonnull (strstr (found, "\"reaches_zero\": true"));
  g_assert_cmpfloat_with_epsilon (number_after (found, "\"period_half_stiffness\": "),
                                  1.6958, 1e-3);
}

/* The example by hand of docs/method/capacity.md, solved. */
static void
test_block (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "block.quoin", block);
  g_autofree char *json = g_build_filename (folder, "c.json", NULL);
  g_autofree char *csv = g_build_filename (folder, "c.csv", NULL);
  g_autofree char *svg = g_build_filename (folder, "c.svg", NULL);
  cli_says ("m/s2 (0.25 g), soil C, damping 0.05\nstanding", "capacity", model,
            "--spectrum", "type1", "--ag", "2.4525", "--soil", "C", "--json", json,
            "--csv", csv, "-o", svg, NULL);
  /* In g by Italian habit: ten times too little. */
  cli_says ("is this number in g?", "capacity", model, "--spectrum", "type2", "--ag",
            "0.25", "--soil", "C", NULL);
  g_autofree char *text = cli_read (json), *table = cli_read (csv),
                  *picture = cli_read (svg);
  const char *slv = strstr (text, "\"SLV\"");
  g_assert_nonnull (slv);
  g_assert_cmpfloat_with_epsilon (number_after (slv, "\"capacity\": "), 0.12, 1e-4);
  g_assert_cmpfloat_with_epsilon (number_after (slv, "\"period\": "), 1.6958, 1e-3);
  g_assert_cmpfloat_with_epsilon (number_after (slv, "\"demand\": "), 0.18172, 1e-4);
  g_assert_cmpfloat_with_epsilon (number_after (slv, "\"ratio\": "), 0.660, 1e-3);
  g_assert_nonnull (strstr (slv, "\"met\": false"));
  /* About its foot, sliding by u and turning by t on two pairs, each of two springs in series:
   * k u and 0.3^2 k t, k = 1e10, against m (u + 1.5 t) and 1.5 m u + (I + 1.5^2 m) t; the lower root. */
  const double m = 0.6 * 3 * 2000, inertia = m * (0.36 + 9) / 12;
  const double slides = 1e10, turns = 0.09 * 1e10;
  const double a = m * (inertia + 2.25 * m) - 2.25 * m * m,
               b = slides * (inertia + 2.25 * m) + turns * m, c = slides * turns;
  const double omega = sqrt ((b - sqrt (b * b - 4 * a * c)) / (2 * a));
  const char *elastic = strstr (text, "\"elastic\"");
  g_assert_nonnull (elastic);
  g_assert_cmpfloat_with_epsilon (number_after (elastic, "\"period\": ") * omega,
                                  2 * G_PI, 2e-3);
  /* On the way up to the plateau of type 1, soil C, TB = 0.2 s. */
  g_assert_cmpfloat_with_epsilon (number_after (elastic, "\"acceleration\": "),
                                  2.4525 * 1.15 * (1 + 1.5 * 2 * G_PI / omega / 0.2),
                                  0.01);
  /* The joints were chosen stiff: what EN 1998-3 makes of them says nothing. */
  g_assert_nonnull (strstr (strstr (text, "\"NC\""), "\"ratio\": null, \"met\": null"));
  g_assert_null (strstr (picture, "NC: demand"));
  g_assert_nonnull (strstr (text, "\"reaches_zero\": true"));
  g_assert_true (g_str_has_prefix (table, "load multiplier,control displacement [m],"));
  g_assert_nonnull (strstr (picture, "<svg"));

  /* The same spectrum as points gives the same at its points. */
  g_autofree char *points =
    cli_write (folder, "s.csv",
               "period [s],acceleration [m/s2]\n0.2,7.0509375\n0.6,7.0509375\n"
               "1.69577,2.494772\n2,2.11528\n4,0.52882\n");
  g_autofree char *frequencies =
    cli_write (folder, "f.csv", "Frequency [Hz],Sa [g]\n1,0.3\n2,0.2\n");
  cli_fails (3, "f.csv:1: a spectrum by frequencies", "capacity", model, "--spectrum",
             frequencies, NULL);
  CliRun run = cli_run ("capacity", model, "--spectrum", points, "--json", "-", NULL);
  cli_assert_done (&run);
  slv = strstr (run.out, "\"SLV\"");
  g_assert_cmpfloat_with_epsilon (number_after (slv, "\"demand\": "), 0.18172, 1e-4);
  cli_run_clear (&run);
}

/* No number of it is infinite, and none is missing but the answers that there are none of. */
static void
check_numbers (const cJSON *value)
{
  if (cJSON_IsNumber (value))
    g_assert_true (isfinite (value->valuedouble));
  const cJSON *child;
  cJSON_ArrayForEach (child, value) check_numbers (child);
}

/* With a tie of 4 kN at a height of 2.9 m the mechanism is checked by hand numbers: alpha0 = (W 0.3 + 4 2.9)/
 * (W 1.5), the same of limit analysis and of a path that ended; the table is read back; what the project keeps
 * counts. */
static void
test_mechanism (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *tied = cli_replace (
    block, "\"loads\"",
    "\"ties\": [ { \"name\": \"rod\", \"ends\": [ { \"block\": \"block\", \"at\": [-0.3, "
    "2.9] }, { \"at\": [-4, 2.9] } ],\n"
    "    \"area\": 1e-4, \"elasticity\": 2e11, \"anchor\": 4000 } ],\n"
    "  \"capacity\": { \"mechanism\": true, \"confidence\": 1.35 },\n  \"loads\"");
  g_autofree char *model = cli_write (folder, "tied.quoin", tied);
  g_autofree char *result = g_build_filename (folder, "r.json", NULL);
  const double weight = 0.6 * 3 * 2000 * 9.81;
  const double alpha0 = (weight * 0.3 + 4000 * 2.9) / (weight * 1.5);
  const double demand = 0.25 * 9.80665 * 1.15;
  cli_do ("solve", model, "-o", result, NULL);
  for (int ended = 0; ended < 2; ended++) {
    CliRun run =
      cli_run ("capacity", model, "--spectrum", "type1", "--ag", "0.25g", "--soil", "C",
               "--json", "-", "--mechanism", ended ? "-r" : NULL, result, NULL);
    cli_assert_done (&run);
    cJSON *root = cJSON_Parse (run.out);
    check_numbers (root);
    g_assert_cmpfloat_with_epsilon (number_after (run.out, "\"alpha0\": "), alpha0, 1e-6);
    g_assert_cmpfloat_with_epsilon (number_after (run.out, "\"collapse_multiplier\": "),
                                    alpha0, 1e-4);
    g_assert_cmpfloat_with_epsilon (number_after (run.out, "\"end_displacement\": "), 0.3,
                                    1e-4);
    const char *linear = strstr (run.out, "\"linear\"");
    g_assert_cmpfloat_with_epsilon (number_after (linear, "\"acceleration\": "),
                                    alpha0 * 9.81 / 1.35, 1e-5);
    g_assert_cmpfloat_with_epsilon (number_after (linear, "\"slv_ratio\": "),
                                    2 * alpha0 * 9.81 / 1.35 / demand, 1e-5);
    g_assert_nonnull (strstr (run.out, "\"SLC\""));
    g_assert_null (strstr (run.out, "EN 1998-3"));
    cJSON_Delete (root);
    cli_run_clear (&run);
  }
  cli_says ("alpha0 0.41898", "capacity", model, NULL);
}

/* What the project keeps is taken where no option says it. */
static void
test_kept (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *kept = cli_replace (
    block, "\"analysis\"",
    "\"capacity\": { \"control\": \"block\", \"spectrum\": \"type1\", \"ag\": 2.4525, "
    "\"soil\": \"C\", \"confidence\": 1.2 }, \"analysis\"");
  g_autofree char *wrong = cli_replace (kept, "\"C\"", "7");
  g_autofree char *plain = cli_write (folder, "block.quoin", block);
  g_autofree char *model = cli_write (folder, "kept.quoin", kept);
  g_autofree char *bad = cli_write (folder, "wrong.quoin", wrong);
  CliRun asked = cli_run ("capacity", plain, "--spectrum", "type1", "--ag", "2.4525",
                          "--soil", "C", "--confidence", "1.2", NULL);
  CliRun taken = cli_run ("capacity", model, NULL);
  cli_assert_done (&asked);
  cli_assert_done (&taken);
  const char *same = strchr (asked.out, '\n'), *found = strchr (taken.out, '\n');
  g_assert_nonnull (strstr (taken.out, "SLV"));
  g_assert_cmpstr (found, ==, same); /* but for the name of the file */
  cli_run_clear (&taken);
  taken = cli_run ("capacity", model, "--confidence", "1", NULL);
  g_assert_cmpstr (strchr (taken.out, '\n'), !=, same);
  cli_run_clear (&taken);
  cli_run_clear (&asked);
  taken = cli_run ("capacity", bad, NULL);
  g_assert_nonnull (strstr (taken.err, "capacity.soil: "));
  cli_run_clear (&taken);
}

/* A gable 6 m up in a building of 9 m, with a tie that breaks: a_Z = 1.5 times that of the hand numbers in
 * docs/method/capacity.md. What is missing or contradicts is refused. */
static void
test_above_ground (void)
{
  g_autofree char *gable = cli_example ("47-gable-with-tie.quoin");
  CliRun run = cli_run ("capacity", gable, "--tie-strain", "0.05", "--height", "6",
                        "--building-height", "9", "--storeys", "3", "--building-period",
                        "0.3", NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "demand 3.876 m/s2"));
  g_assert_nonnull (strstr (run.out, "Sa g 3.6 m/s2"));
  g_assert_nonnull (strstr (run.out, "ties break at d* 0.097"));
  g_assert_nonnull (strstr (run.out, "z 6 m of H 9 m (C7.2.3): 3 storeys, T1 0.3 s"));
  cli_run_clear (&run);
  const char *const wrong[][2] = { { "--height", "height is at least" },
                                   { "--storeys", "storeys is a count" },
                                   { "--building-height", "height is missing" } };
  for (gsize i = 0; i < G_N_ELEMENTS (wrong); i++) {
    run =
      cli_run ("capacity", gable, wrong[i][0], i == 1 ? "2.5" : "6", "--building-period",
               "0.3", i == 0 ? "--storeys" : NULL, "3", "--building-height", "5", NULL);
    g_assert_cmpint (run.code, ==, 2);
    g_assert_nonnull (strstr (run.err, wrong[i][1]));
    cli_run_clear (&run);
  }
}

/* A corner that turns out along its crack, by hand with and without its tie. */
static void
test_corner_wedge (void)
{
  g_autofree char *example = cli_example ("64-corner-wedge.quoin");
  cli_says ("alpha0 0.69048", "capacity", example, NULL);
  cli_says ("alpha0 0.37048", "capacity", example, "--set", "ties=[]", NULL);
  cli_says ("between 0.69047619", "limit", example, NULL);
}

/* Strips of façades by the hand numbers of docs/method/capacity.md: about the foot, about a floor, bending
 * between floors. What no strip has is refused. */
static void
test_facade_strip (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = g_build_filename (folder, "strip.quoin", NULL);
  g_autofree char *example = cli_example ("60-facade-strip.quoin");
  cli_do ("generate", "facade-strip", "storeys=3.2x3", "thickness=0.5x0.4",
          "floors=12000x8000", "floor-friction=0.3", "ties=0x4000", "thrust=1500",
          "parapet=0.6x0.3", "-o", model, NULL);
  cli_says ("alpha0 0.23808", "capacity", model, NULL);
  cli_says ("alpha0 0.23808", "capacity", example, NULL);
  cli_do ("generate", "facade-strip", "storeys=3.2x3", "thickness=0.5x0.4",
          "floors=12000x8000", "floor-friction=0.3", "ties=0x4000", "flanks=5000x3000",
          "thrust=1500", "parapet=0.6x0.3", "-o", model, NULL);
  cli_says ("alpha0 0.32419", "capacity", model, NULL);
  const char *const kept =
    "capacity={\"tie_strain\": 0.05, \"part_period\": 0.1, \"height\": 6, "
    "\"building_height\": 9, \"storeys\": 3, \"building_period\": 0.3, "
    "\"building_damping\": 0.08, \"mechanism\": true, \"spectrum\": \"type1\", "
    "\"ag\": 1.5, \"soil\": \"B\"}";
  CliRun known = cli_run ("capacity", example, "--set", kept, NULL);
  cli_assert_done (&known);
  g_assert_cmpstr (known.err, ==, "");
  g_assert_nonnull (strstr (known.out, "damping of the building 0.08"));
  cli_run_clear (&known);

  /* What only a mechanism has is told without one. */
  known = cli_run ("capacity", example, "--set", "capacity.mechanism=false", "--set",
                   "capacity.part_period=0.1", NULL);
  g_assert_nonnull (strstr (known.err, "capacity.tie_strain: changes nothing without"));
  g_assert_nonnull (strstr (known.err, "capacity.part_period: changes nothing without"));
  cli_run_clear (&known);
  known = cli_run ("capacity", example, "--set", "capacity.mechanism=false",
                   "--tie-strain", "0.1", NULL);
  g_assert_cmpint (known.code, ==, 2);
  g_assert_nonnull (strstr (known.err, "belong to --mechanism"));
  cli_run_clear (&known);
  known = cli_run ("capacity", example, "--set", "capacity={\"tie_strain\": 0.05}",
                   "--mechanism", NULL);
  cli_assert_done (&known);
  g_assert_cmpstr (known.err, ==, "");
  g_assert_nonnull (strstr (known.out, "alpha0 0.23808"));
  cli_run_clear (&known);
  cli_do ("generate", "facade-strip", "storeys=3x3", "thickness=0.5x0.4",
          "floors=12000x8000", "ties=60000x0", "-o", model, NULL);
  cli_says ("alpha0 0.11915", "capacity", model, NULL);
  cli_do ("generate", "facade-strip", "storeys=3", "thickness=0.3", "floors=20000",
          "bearing=0.3", "held=1", "unit-weight=10000", "courses=10", "-o", model, NULL);
  cli_says ("alpha0 2.73800", "capacity", model, NULL);
  const char *const wrong[][2] = {
    { "bering=0.2", "the nearest known one is \"bearing\"" },
    { "thickness=0.1", "more than the thickness" },
    { "storeys=3xhigh", "storeys: expected a number" },
    { "courses=0", "courses: number must be positive" },
    { "courses=3.5", "courses: expected a whole number" },
    { "courses=101", "from 1 to 100" },
    { "width=1x2", "width: expected up to 1 numbers" },
    { "floors=1x2x3", "floors: expected up to 2 numbers" },
    { "held=3", "held: expected a whole number from 1 to 2" },
    { "parapet=1", "parapet: expected two numbers" },
    { "parapet=0x1", "parapet: expected two numbers" }
  };
  for (gsize i = 0; i < G_N_ELEMENTS (wrong); i++) {
    CliRun run = cli_run ("generate", "facade-strip", wrong[i][0], "-o", model, NULL);
    g_assert_cmpint (run.code, ==, 2);
    g_assert_nonnull (strstr (run.err, wrong[i][1]));
    cli_run_clear (&run);
  }
}

/* File and table are read again and say the same, for a curve that comes back to zero, for one that does
 * not, with a spectrum and without. */
static void
test_read_back (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *sound = cli_write (folder, "block.quoin", block);
  g_autofree char *short_text =
    cli_replace (block, "\"load\" }", "\"load\", \"max_factorizations\": 3 }");
  g_autofree char *cut = cli_write (folder, "short.quoin", short_text);
  g_autofree char *arch = cli_example ("06-arch.quoin");
  const struct {
    const char *model, *spectrum;
    int code;
  } rows[] = {
    { sound, "type1", 0 }, { sound, NULL, 0 }, { arch, "type2", 0 }, { cut, NULL, 4 }
  };
  for (gsize i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autofree char *json = g_strdup_printf ("%s/%zu.json", folder, i);
    g_autofree char *csv = g_strdup_printf ("%s/%zu.csv", folder, i);
    CliRun run = cli_run ("capacity", rows[i].model, "-q", "--json", json, "--csv", csv,
                          rows[i].spectrum != NULL ? "--spectrum" : NULL,
                          rows[i].spectrum, "--ag", "0.25g", "--soil", "B", NULL);
    g_assert_cmpint (run.code, ==, rows[i].code);
    cli_run_clear (&run);
    if (rows[i].code != 0) {
      g_assert_false (g_file_test (json, G_FILE_TEST_EXISTS));
      g_assert_false (g_file_test (csv, G_FILE_TEST_EXISTS));
      continue;
    }
    g_autofree char *text = cli_read (json), *csv_text = cli_read (csv);
    cJSON *root = cJSON_Parse (text);
    check_numbers (root);
    const cJSON *curve = cJSON_GetObjectItem (root, "curve");
    g_autoptr (GPtrArray) table = test_table_read (csv_text);
    g_assert_cmpint (cJSON_GetArraySize (curve), ==, (int) table->len - 1);
    for (guint k = 1; k < table->len; k++) {
      const cJSON *point = cJSON_GetArrayItem (curve, (int) k - 1);
      g_assert_cmpfloat (cJSON_GetObjectItem (point, "multiplier")->valuedouble, ==,
                         test_table_number (table, k, "load multiplier"));
    }
    cJSON_Delete (root);
  }
}

static void
test_refused (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "block.quoin", block);
  g_autofree char *zero = cli_write (folder, "z.csv", "T [s],S [g]\n0.1,1\n0.2,0\n");
  cli_fails (2, "--ag", "capacity", model, "--spectrum", "type1", "--soil", "A", NULL);
  cli_fails (2, "--ag", "capacity", model, "--spectrum", "type1", "--ag", "0.2 g",
             "--soil", "A", NULL);
  cli_fails (2, "--soil", "capacity", model, "--spectrum", "type1", "--ag", "1", "--soil",
             "F", NULL);
  cli_fails (2, "--spectrum is missing", "capacity", model, "--ag", "1", NULL);
  cli_fails (2, "--confidence", "capacity", model, "--confidence", "0.9", NULL);
  cli_fails (3, "nobody", "capacity", model, "--control", "nobody", NULL);
  cli_fails (3, "must be positive", "capacity", model, "--spectrum", zero, NULL);
  cli_fails (5, "nowhere.csv", "capacity", model, "--spectrum", "nowhere.csv", NULL);
  g_autofree char *sliding = cli_example ("01-sliding-block.quoin");
  g_autofree char *result = g_build_filename (folder, "r.json", NULL);
  cli_do ("solve", model, "--set", "analysis.max_multiplier=0.01", "-o", result, NULL);
  cli_fails (3, "needs a mechanism of collapse", "capacity", model, "--mechanism", "-r",
             result, NULL);
  cli_fails (3, "joints slide", "capacity", sliding, "--mechanism", NULL);
  cli_fails (2, "--result belongs to --mechanism", "capacity", model, "-r", result, NULL);
  cli_fails (3, "horizontal weights", "capacity", model, "--set",
             "loads.live[0].direction=[1,1]", NULL);
}

/* A curve that was not followed to its end is none, whichever of its analyses was cut short; a path that
 * ends before zero for a reason of its own says which. */
static void
test_ends (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "block.quoin", block);
  const struct {
    const char *set, *reason;
  } rows[] = {
    { "analysis.max_factorizations=3", "max_factorizations (3) was reached" },
    { "analysis.max_factorizations=12", "max_factorizations (12) was reached" },
    { "analysis.max_seconds=1e-6", "max_seconds (1e-06) was reached" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (rows); i++)
    cli_fails (4, rows[i].reason, "capacity", model, "--set", rows[i].set, NULL);
  g_autofree char *sliding = cli_example ("01-sliding-block.quoin");
  CliRun run = cli_run ("capacity", sliding, NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "before zero"));
  g_assert_nonnull (strstr (run.out, "has reached its target of 0.7 m"));
  cli_run_clear (&run);
}

QN_TESTS
{
  g_test_add_func ("/capacity/block", test_block);
  g_test_add_func ("/capacity/rough-block", test_rough_block);
  g_test_add_func ("/capacity/above-ground", test_above_ground);
  g_test_add_func ("/capacity/facade-strip", test_facade_strip);
  g_test_add_func ("/capacity/corner-wedge", test_corner_wedge);
  g_test_add_func ("/capacity/gable", test_gable);
  g_test_add_func ("/capacity/mechanism", test_mechanism);
  g_test_add_func ("/capacity/kept", test_kept);
  g_test_add_func ("/capacity/read back", test_read_back);
  g_test_add_func ("/capacity/ends", test_ends);
  g_test_add_func ("/capacity/refused", test_refused);
}
