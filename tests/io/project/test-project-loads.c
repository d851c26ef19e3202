/* Contact, loads and analysis: what is refused, with its place. */
#include "io/project-text.h"
#include "support/room.h"

#include <string.h>

/* The project with one line put in place of its line 8 or 9, and the expected message. */
typedef struct Case {
  const char *line, *message;
} Case;

static void
expect_errors (const char *replaced, const Case *cases, gsize count)
{
  for (gsize i = 0; i < count; i++) {
    g_autofree char *text = test_replace (test_project_text, replaced, cases[i].line);
    g_autofree char *message = test_parse_error (text, NULL);
    g_assert_cmpstr (message, ==, cases[i].message);
  }
}

static void
test_contact (void)
{
  static const Case cases[] = {
    { "\"c\": {}", "1:1: contact: required key is missing" },
    { "\"contact\": {}", "8:14: contact.law: required key is missing" },
    { "\"contact\": []", "8:14: contact: expected an object, found an array" },
    { "\"contact\": { \"law\": \"glue\" }",
      "8:23: contact.law: no law has this name: \"glue\"" },
    { "\"contact\": { \"law\": \"joint\", \"tolerance\": -1 }",
      "8:45: contact.tolerance: number must not be negative" },
    { "\"contact\": { \"law\": \"joint\", \"pairs\": { \"placement\": \"middle\" } }",
      "8:56: contact.pairs.placement: \"middle\" is not one of default, ends, "
      "gauss-lobatto, uniform, gauss, explicit" },
    { "\"contact\": { \"law\": \"joint\", \"pairs\": { \"placement\": \"gauss-lobatto\", "
      "\"count\": 2 } }",
      "8:82: contact.pairs.count: gauss-lobatto has 3 to 9 contact pairs on a face" },
    { "\"contact\": { \"law\": \"joint\", \"pairs\": { \"placement\": \"gauss-lobatto\", "
      "\"offset\": -0.1 } }",
      "8:83: contact.pairs.offset: number must not be negative" },
    { "\"contact\": { \"law\": \"joint\", \"pairs\": { \"offset\": -0.1 } }",
      "8:53: contact.pairs.offset: number must not be negative" },
    { "\"contact\": { \"law\": \"joint\", \"pairs\": { \"placement\": \"uniform\" } }",
      "8:41: contact.pairs.count: required key is missing" },
    { "\"contact\": { \"law\": \"joint\", \"pairs\": { \"placement\": \"uniform\", "
      "\"count\": 0 } }",
      "8:76: contact.pairs.count: expected a whole number from 1 to 1000" },
    { "\"contact\": { \"law\": \"joint\", \"pairs\": { \"placement\": \"uniform\", "
      "\"count\": 1e9 } }",
      "8:76: contact.pairs.count: expected a whole number from 1 to 1000" },
    { "\"contact\": { \"law\": \"joint\", \"faces\": [{ \"blocks\": [\"base\"] }] }",
      "8:54: contact.faces[0].blocks: expected the names of two blocks" },
    { "\"contact\": { \"law\": \"joint\", \"faces\": [{ \"blocks\": [\"base\", \"x\"] }] "
      "}",
      "8:63: contact.faces[0].blocks[1]: no block has this name: \"x\"" },
    { "\"contact\": { \"law\": \"joint\", \"faces\": [{ \"blocks\": [\"base\", 1] }] }",
      "8:63: contact.faces[0].blocks[1]: expected the name of a block" },
    { "\"contact\": { \"law\": \"joint\", \"faces\": [{ \"blocks\": [\"top\", \"top\"] "
      "}] }",
      "8:54: contact.faces[0].blocks: a block has no contact with itself" },
  };
  expect_errors ("\"contact\": { \"law\": \"joint\" }", cases, G_N_ELEMENTS (cases));
}

static void
test_loads (void)
{
  static const Case cases[] = {
    { "{ \"kind\": \"wind\" }",
      "9:34: loads.dead[0].kind: \"wind\" is not one of weight, "
      "force, settlement, line, edge, surcharge, backfill, fill, vehicle" },
    { "{ \"kind\": \"weight\" }",
      "9:24: loads.dead[0].direction: required key is missing" },
    { "{ \"kind\": \"weight\", \"direction\": [0] }",
      "9:57: loads.dead[0].direction: expected two numbers" },
    { "{ \"kind\": \"force\", \"value\": [0, 1] }",
      "9:24: loads.dead[0].block: required key is missing" },
    { "{ \"kind\": \"force\", \"block\": \"x\", \"value\": [0, 1] }",
      "9:52: loads.dead[0].block: no block has this name: \"x\"" },
    { "{ \"kind\": \"force\", \"block\": \"top\" }",
      "9:24: loads.dead[0].value: required key is missing" },
    { "{ \"kind\": \"force\", \"block\": \"top\", \"value\": [0, 1], \"moment\": true }",
      "9:86: loads.dead[0].moment: expected a number, found true or false" },
    { "3", "9:24: loads.dead[0]: expected an object, found a number" },
  };
  expect_errors ("{ \"kind\": \"weight\", \"direction\": [0, -1] }", cases,
                 G_N_ELEMENTS (cases));
}

static void
test_analysis (void)
{
  static const Case cases[] = {
    { "\"analysis\": 3,", "9:15: analysis: expected an object, found a number" },
    { "\"analysis\": { \"procedure\": \"fast\" },",
      "9:30: analysis.procedure: \"fast\" is not one of load, displacement, work, "
      "arc-length, "
      "limit, dynamic" },
    { "\"analysis\": { \"increments\": 0 },",
      "9:31: analysis.increments: expected a whole number from 1 to 2147483647" },
    { "\"analysis\": { \"increments\": 1.5 },",
      "9:31: analysis.increments: expected a whole number from 1 to 2147483647" },
    { "\"analysis\": { \"max_multiplier\": -1 },",
      "9:35: analysis.max_multiplier: number must not be negative" },
    { "\"analysis\": { \"snap\": \"go\" },",
      "9:25: analysis.snap: \"go\" is not one of jump, stop" },
    { "\"analysis\": { \"control\": { \"component\": \"ux\", \"target\": 1 } },",
      "9:28: analysis.control.block: required key is missing" },
    { "\"analysis\": { \"control\": { \"block\": \"top\", \"component\": \"uz\", "
      "\"target\": 1 } },",
      "9:59: analysis.control.component: \"uz\" is not one of ux, uy, rz" },
    { "\"analysis\": { \"control\": { \"block\": \"top\", \"component\": \"ux\", "
      "\"target\": 0 } },",
      "9:75: analysis.control.target: control target is zero" },
    { "\"analysis\": { \"control\": { \"block\": \"base\", \"component\": \"ux\", "
      "\"target\": 1 } },",
      "9:60: analysis.control.component: controlled degree of freedom is fixed" },
    { "\"analysis\": { \"procedure\": \"displacement\" },",
      "9:15: analysis.control: procedure needs a control block and target" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    Case padded = cases[i];
    g_autofree char *line = g_strconcat (cases[i].line, " \"loads\": {", NULL);
    padded.line = line;
    expect_errors ("\"loads\": {", &padded, 1);
  }
}

/* Loads on edges and cases: what is refused, and where. */
static void
test_edge_loads (void)
{
#define EDGE   "\"kind\": \"edge\", \"block\": \"top\", \"intensity\": 1"
#define FILL   "\"kind\": \"surcharge\", \"pressure\": 1"
#define SOIL   "\"kind\": \"backfill\", \"side\": \"left\", \"unit_weight\": 1"
#define SOIL_K SOIL ", \"coefficient\": 0.3"
  static const struct {
    const char *load, *message;
  } wrong[] = {
    { EDGE, "loads.live[0].edge: " },
    { EDGE ", \"edge\": 4", "loads.live[0].edge: block “top” has edges 0 to 3" },
    { EDGE ", \"edge\": 1.5", "loads.live[0].edge: block “top” has edges 0 to 3" },
    { EDGE ", \"edge\": -1", "loads.live[0].edge: " },
    { EDGE ", \"edge\": 1, \"count\": 5",
      "loads.live[0].count: block “top” has 4 edges" },
    { EDGE ", \"edge\": 1, \"count\": 0", "loads.live[0].count: " },
    { EDGE ", \"edge\": 1, \"side\": \"top\"", "loads.live[0].edge: side excludes" },
    { EDGE ", \"side\": \"above\"", "loads.live[0].side: " },
    { EDGE ", \"edge\": 1, \"part\": [0.5, 0.5]", "loads.live[0].part: loaded part" },
    { EDGE ", \"edge\": 1, \"part\": [-1, 1]", "loads.live[0].part: number must lie" },
    { EDGE ", \"edge\": 1, \"direction\": [1]", "loads.live[0].direction: " },
    { EDGE ", \"edge\": 1, \"case\": \"wind\"", "loads.live[0].case: no load case" },
    { EDGE ", \"edge\": 1, \"case\": 3", "loads.live[0].case: " },
    { "\"kind\": \"edge\", \"block\": \"top\", \"edge\": 1, \"intensity\": [1, 2, 3]",
      "loads.live[0].intensity: " },
    { "\"kind\": \"edge\", \"block\": \"top\", \"edge\": 1, \"intensity\": 1e308",
      "loads.live[0].intensity: " },
    { "\"kind\": \"edge\", \"block\": \"none\", \"edge\": 1, \"intensity\": 1",
      "loads.live[0].block: no block" },
    { FILL ", \"from\": 2, \"to\": 1", "loads.live[0].from: loaded part" },
    { FILL ", \"from\": NaN", "6:" },
    { FILL ", \"unit_weight\": 1", "loads.live[0].level: " },
    { "\"kind\": \"surcharge\", \"pressure\": -1", "loads.live[0].pressure: " },
    { "\"kind\": \"surcharge\"", "loads.live[0].pressure: " },
    { SOIL_K, "loads.live[0].top: " },
    { SOIL ", \"top\": 1", "loads.live[0].coefficient: " },
    { SOIL ", \"top\": 1, \"coefficient\": -0.1", "loads.live[0].coefficient: " },
    { SOIL_K ", \"top\": 1, \"bottom\": 2", "loads.live[0].bottom: loaded part" },
    { SOIL_K ", \"top\": 1, \"friction_angle\": 0.5", "loads.live[0].coefficient: " },
    { SOIL ", \"top\": 1, \"friction_angle\": 1.6", "loads.live[0].friction_angle: " },
    { SOIL ", \"top\": 1, \"friction_angle\": 0.5, \"earth\": \"passive\"",
      "loads.live[0].earth: " },
    { SOIL ", \"top\": 1, \"friction_angle\": 0.5, \"earth\": \"given\"",
      "loads.live[0].earth: " },
    { "\"kind\": \"backfill\", \"side\": \"top\"", "loads.live[0].side: " },
    { "\"kind\": \"fill\", \"unit_weight\": 1", "loads.live[0].surface: required" },
    { "\"kind\": \"fill\", \"unit_weight\": 1, \"surface\": [[0, 1], [1, 1]]",
      "loads.live[0].kind: fill is a dead load" },
    { "\"kind\": \"vehicle\", \"vehicle\": \"tram\", \"position\": 1",
      "loads.live[0].vehicle: no vehicle has this name" },
    { "\"kind\": \"vehicle\", \"vehicle\": \"LM71\"", "loads.live[0].position: " },
    { "\"kind\": \"vehicle\", \"vehicle\": \"LM71\", \"position\": 1, \"convoy\": 21",
      "loads.live[0].convoy: " },
    { "\"kind\": \"vehicle\", \"vehicle\": \"LM71\", \"position\": 1, "
      "\"dispersal\": \"3:1\"",
      "loads.live[0].dispersal: " },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (wrong); i++) {
    g_autofree char *load = g_strdup_printf ("\"live\": [ { %s },", wrong[i].load);
    g_autofree char *text = test_replace (test_project_text, "\"live\": [", load);
    g_autofree char *message = test_parse_error (text, NULL);
    if (strstr (message, wrong[i].message) == NULL)
      g_error ("'%s' is not in '%s'", wrong[i].message, message);
  }

  static const char *const cases[][2] = {
    { "\"a\": -1", "loads.cases.a: " },
    { "\"a\": \"x\"", "loads.cases.a: expected a number" },
    { "\"a\": 1e300", "loads.cases.a: " },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *line =
      g_strdup_printf ("\"loads\": { \"cases\": { %s },", cases[i][0]);
    g_autofree char *text = test_replace (test_project_text, "\"loads\": {", line);
    g_autofree char *message = test_parse_error (text, NULL);
    if (strstr (message, cases[i][1]) == NULL)
      g_error ("'%s' is not in '%s'", cases[i][1], message);
  }
}

/* Sets of loads, stages, and what is controlled: what is refused. */
static void
test_sets_and_stages (void)
{
  static const struct {
    const char *analysis, *sets, *message;
  } wrong[] = {
    { "\"procedure\": \"load\"", "\"live\": []", "loads.sets.live: " },
    { "\"procedure\": \"load\"", "\"dead\": []", "loads.sets.dead: " },
    { "\"procedure\": \"load\"", "\"a\": 3", "loads.sets.a: expected an array" },
    { "\"stages\": [ { \"name\": \"s\", \"loads\": [3] } ]", "\"a\": []",
      "expected the name of a load set" },
    { "\"stages\": [ { \"name\": \"s\", \"loads\": [\"a\", \"a\"] } ]", "\"a\": []",
      "load set is named twice" },
    { "\"stages\": [ { \"name\": \"s\", \"loads\": \"b\" } ]", "\"a\": []",
      "analysis.stages[0].loads" },
    { "\"stages\": [ { \"loads\": \"live\", \"target\": 1 }, { \"loads\": \"live\", "
      "\"amplitudes\": [1, 0] } ]",
      "\"a\": []", "analysis.stages[1].amplitudes[1]: an amplitude is not 0" },
    { "\"stages\": [ { \"loads\": \"live\", \"amplitudes\": [] } ]", "\"a\": []",
      "analysis.stages[0].amplitudes: expected at least one" },
    { "\"stages\": [ { \"loads\": \"live\", \"amplitudes\": [1], \"target\": 1 } ]",
      "\"a\": []", "target and amplitudes exclude each other" },
    { "\"stages\": [ { \"loads\": \"live\", \"target\": 1, \"cycles\": 2 } ]",
      "\"a\": []", "analysis.stages[0].cycles: needs amplitudes" },
    { "\"stages\": [ { \"loads\": \"live\", \"amplitudes\": [1, 2], \"cycles\": 200 } ]",
      "\"a\": []", "analysis.stages[0].cycles: more than 1000 stages" },
    { "\"stages\": [ 3 ]", "\"a\": []", "analysis.stages[0]: expected an object" },
    { "\"control\": { \"block\": \"top\", \"node\": \"n\", \"component\": \"ux\", "
      "\"target\": 1 }",
      "\"a\": []", "analysis.control.block: block and node exclude each other" },
    { "\"control\": { \"node\": \"n\", \"component\": \"ux\", \"target\": 1 }",
      "\"a\": []", "analysis.control.node: " },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (wrong); i++) {
    g_autofree char *line =
      g_strdup_printf ("\"analysis\": { %s }, \"loads\": { \"sets\": { %s }, ",
                       wrong[i].analysis, wrong[i].sets);
    g_autofree char *text = test_replace (test_project_text, "\"loads\": {", line);
    g_autofree char *message = test_parse_error (text, NULL);
    if (strstr (message, wrong[i].message) == NULL)
      g_error ("'%s' is not in '%s'", wrong[i].message, message);
  }

  g_autoptr (GString) many = g_string_new ("\"loads\": { \"sets\": { \"s\": []");
  for (int i = 0; i < QN_MAX_LOAD_SETS; i++)
    g_string_append_printf (many, ", \"s%d\": []", i);
  g_string_append (many, " }, ");
  g_autofree char *text = test_replace (test_project_text, "\"loads\": {", many->str);
  g_autofree char *message = test_parse_error (text, NULL);
  g_assert_nonnull (strstr (message, "load sets with names"));
}

static void
test_no_effect (void)
{
  g_auto (QnProject) project;
  char *text = test_replace (test_project_text, "\"law\": \"joint\" }",
                             "\"law\": \"joint\", \"pairs\": { \"count\": 3 } }");
  test_parse (text, &project);
  g_assert_cmpuint (project.warnings->len, ==, 1);
  g_assert_cmpstr (
    g_ptr_array_index (project.warnings, 0), ==,
    "wall.quoin:8:52: contact.pairs.count: has no effect with this placement");
  g_free (text);
}

QN_TESTS
{
  g_test_add_func ("/project-loads/contact", test_contact);
  g_test_add_func ("/project-loads/loads", test_loads);
  g_test_add_func ("/project-loads/analysis", test_analysis);
  g_test_add_func ("/project-loads/no-effect", test_no_effect);
  g_test_add_func ("/project-loads/sets-and-stages", test_sets_and_stages);
  g_test_add_func ("/project-loads/edge-loads", test_edge_loads);
}
