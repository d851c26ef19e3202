/* Laws and bars: every kind read, written and read again; what is refused, with its place. */
#include "io/project-text.h"
#include "support/room.h"

#include <string.h>

/* The project with other laws; the first is called "joint". */
static char *
with_laws (const char *laws)
{
  return test_replace (test_project_text,
                       "{ \"name\": \"joint\", \"kind\": \"coulomb\", \"kn\": 1e7, "
                       "\"ks\": 1e7, \"friction\": 0.65 }",
                       laws);
}

static const char *const kinds[QN_LAW_KIND_COUNT] = {
  [QN_LAW_ELASTIC] =
    "{ \"name\": \"joint\", \"kind\": \"elastic\", \"kn\": 3e10, \"ks\": 1e10, "
    "\"basis\": \"material\", \"shear_factor\": 0.8 }",
  [QN_LAW_NO_TENSION] =
    "{ \"name\": \"joint\", \"kind\": \"no-tension\", \"kn\": 3, \"ks\": 2 }",
  [QN_LAW_COULOMB] = "{ \"name\": \"joint\", \"kind\": \"coulomb\", \"kn\": 3, \"ks\": "
                     "2, \"friction\": 0.5, "
                     "\"cohesion\": 4, \"tension\": 1, \"dilatancy\": 0.25 }",
  [QN_LAW_MOHR_COULOMB] =
    "{ \"name\": \"joint\", \"kind\": \"mohr-coulomb\", \"kn\": 3, \"ks\": 2, "
    "\"friction\": 0.5, \"compression\": 7, \"cohesion\": 4, \"tension\": 1, "
    "\"dilatancy\": 0.25 }",
  [QN_LAW_BILINEAR] = "{ \"name\": \"joint\", \"kind\": \"bilinear\", \"kn\": 3e10, "
                      "\"ks\": 1e10, \"yield\": "
                      "2e7, \"hardening\": 0.1 }",
  [QN_LAW_ELASTIC_PLASTIC] =
    "{ \"name\": \"joint\", \"kind\": \"elastic-plastic\", \"kn\": 3e10, \"ks\": 1e10, "
    "\"yield\": 2e7 }",
  [QN_LAW_CONCRETE] = "{ \"name\": \"joint\", \"kind\": \"concrete\", \"basis\": "
                      "\"material\", \"kn\": 3e10, "
                      "\"ks\": 1e10, \"strength\": 3e7, \"ultimate_strain\": 0.0035, "
                      "\"crushing_energy\": 9e4, "
                      "\"tension\": 3e6, \"fracture_energy\": 900 }",
  [QN_LAW_STEEL] =
    "{ \"name\": \"joint\", \"kind\": \"steel\", \"kn\": 2e11, \"ks\": 8e10, \"yield\": "
    "5e8, "
    "\"strength\": 5.4e8, \"ultimate_strain\": 0.05, \"fracture_energy\": 6e6 }",
  [QN_LAW_CURVE] =
    "{ \"name\": \"joint\", \"kind\": \"curve\", \"kn\": 100, \"ks\": 50, \"points\": "
    "[[-1, -20], [-0.2, -20], [0.1, 10], [0.3, 14], [0.5, 4]], \"fracture_energy\": 9 }",
};

static void
assert_same (const QnLaw *a, const QnLaw *b)
{
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (a->kind, &count);
  g_assert_cmpint (a->kind, ==, b->kind);
  g_assert_cmpint (a->basis, ==, b->basis);
  g_assert_true (a->kn == b->kn && a->ks == b->ks && a->shear_factor == b->shear_factor);
  for (size_t i = 0; i < count; i++)
    g_assert_true (qn_law_get (a, &parameters[i]) == qn_law_get (b, &parameters[i]));
  g_assert_cmpint (a->point_count, ==, b->point_count);
  g_assert_cmpmem (a->points, sizeof a->points, b->points, sizeof b->points);
}

/* kn and ks follow from the elasticity, and are written as it again. */
static void
test_elasticity (void)
{
  static const struct {
    const char *arrangement;
    double ks;
  } laws[] = { { "chain", 1.25e10 }, { "grid", 2.5e10 } };
  for (gsize i = 0; i < G_N_ELEMENTS (laws); i++) {
    g_auto (QnProject) project, again;
    g_autofree char *law = g_strdup_printf (
      "{ \"name\": \"joint\", \"kind\": \"elastic\", \"basis\": \"material\", "
      "\"elasticity\": 3e10, \"poisson\": 0.2, \"arrangement\": \"%s\" }",
      laws[i].arrangement);
    g_autofree char *text = with_laws (law);
    test_parse (text, &project);
    g_assert_cmpfloat (project.model.laws[0].kn, ==, 3e10);
    g_assert_cmpfloat_with_epsilon (project.model.laws[0].ks, laws[i].ks, 1);
    g_autofree char *written = qn_project_to_text (&project, NULL);
    g_assert_nonnull (strstr (written, laws[i].arrangement));
    g_assert_null (strstr (written, "\"ks\""));
    test_parse (written, &again);
    assert_same (&project.model.laws[0], &again.model.laws[0]);
  }
}

static void
test_round_trip (void)
{
  for (int kind = 0; kind < QN_LAW_KIND_COUNT; kind++) {
    g_auto (QnProject) project, again;
    g_autofree char *text = with_laws (kinds[kind]);
    test_parse (text, &project);
    g_assert_cmpuint (project.warnings->len, ==, 0);
    g_assert_cmpint (project.model.laws[0].kind, ==, kind);
    g_autofree char *written = qn_project_to_text (&project, NULL);
    test_parse (written, &again);
    g_assert_cmpuint (again.warnings->len, ==, 0);
    assert_same (&project.model.laws[0], &again.model.laws[0]);
  }
}

static void
test_values (void)
{
  QnProject project;
  g_autofree char *text = with_laws (kinds[QN_LAW_CONCRETE]);
  test_parse (text, &project);
  const QnLaw *law = &project.model.laws[0];
  g_assert_cmpfloat (law->strength, ==, 3e7);
  g_assert_cmpfloat (law->ultimate_strain, ==, 0.0035);
  g_assert_cmpfloat (law->crushing_energy, ==, 9e4);
  g_assert_cmpfloat (law->tension, ==, 3e6);
  g_assert_cmpfloat (law->fracture_energy, ==, 900);
  qn_project_clear (&project);

  g_autofree char *curve = with_laws (kinds[QN_LAW_CURVE]);
  test_parse (curve, &project);
  law = &project.model.laws[0];
  g_assert_cmpint (law->point_count, ==, 5);
  g_assert_cmpfloat (law->points[3].x, ==, 0.3);
  g_assert_cmpfloat (law->points[3].y, ==, 14);
  qn_project_clear (&project);
}

/* A key of another kind and a key of none are warnings, each of its own sort. */
static void
test_warnings (void)
{
  g_auto (QnProject) project;
  g_autofree char *text =
    with_laws ("{ \"name\": \"joint\", \"kind\": \"elastic\", \"kn\": "
               "1, \"ks\": 1, \"yield\": 3, \"yeld\": 3 }");
  test_parse (text, &project);
  g_assert_cmpuint (project.warnings->len, ==, 2);
  g_assert_true (g_str_has_suffix (g_ptr_array_index (project.warnings, 0),
                                   "laws[0].yield: has no effect for this kind of law"));
  g_assert_true (
    g_str_has_suffix (g_ptr_array_index (project.warnings, 1),
                      "laws[0].yeld: unknown key; the nearest known one is \"yield\""));
}

/* An energy of slip without that of opening is told where the joint has a strength to lose by it. */
static void
test_brittle (void)
{
  static const struct {
    const char *parameters;
    guint warnings;
  } cases[] = {
    { "\"tension\": 1, \"cohesion\": 1", 1 },
    { "\"tension\": 1, \"cohesion\": 1, \"fracture_energy_tension\": 1", 0 },
    { "\"cohesion\": 1", 0 },
    { "\"tension\": 1", 0 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnProject) project;
    g_autofree char *law = g_strdup_printf (
      "{ \"name\": \"joint\", \"kind\": \"coulomb\", \"kn\": 1, \"ks\": 1, \"friction\": "
      "0.5, \"fracture_energy_shear\": 2, %s }",
      cases[i].parameters);
    g_autofree char *text = with_laws (law);
    test_parse (text, &project);
    g_assert_cmpuint (project.warnings->len, ==, cases[i].warnings);
    if (cases[i].warnings > 0)
      g_assert_nonnull (strstr (g_ptr_array_index (project.warnings, 0),
                                "laws[0].fracture_energy_shear: counts in compression"));
  }
}

static void
assert_error (const char *text, const char *end)
{
  g_autofree char *message = test_parse_error (text, NULL);
  if (!g_str_has_suffix (message, end))
    g_error ("“%s” does not end in “%s”", message, end);
}

static void
test_refused (void)
{
  static const struct {
    QnLawKind kind;
    const char *what, *by, *message;
  } cases[] = {
    { QN_LAW_BILINEAR, ", \"hardening\": 0.1", ", \"hardening\": 1",
      "laws[0].hardening: hardening must be less than 1" },
    { QN_LAW_MOHR_COULOMB, "\"compression\": 7, ", "",
      "laws[0].compression: required key is missing" },
    { QN_LAW_MOHR_COULOMB, "\"compression\": 7", "\"compression\": 0",
      "laws[0].compression: number must be positive" },
    { QN_LAW_MOHR_COULOMB, "0.25", "0.6",
      "laws[0].dilatancy: dilatancy exceeds friction" },
    { QN_LAW_BILINEAR, "\"yield\": 2e7, ", "", "laws[0].yield: required key is missing" },
    { QN_LAW_STEEL, "5.4e8", "4e8", "laws[0].strength: strength is below yield" },
    { QN_LAW_CONCRETE, ", \"fracture_energy\": 900", "",
      "laws[0].fracture_energy: a law that softens needs an energy here" },
    { QN_LAW_CURVE, "[-0.2, -20]", "[-0.2, 20]",
      "laws[0].points[1]: force of the point acts against its elongation" },
    { QN_LAW_CURVE, "[0.1, 10]", "[0.1, 10.1]",
      "laws[0].points[2]: curve rises more steeply than kn" },
    { QN_LAW_CURVE, "[0.3, 14]", "[0.3]", "laws[0].points[3]: expected two numbers" },
    { QN_LAW_ELASTIC, "0.8", "0", "laws[0].shear_factor: number must be positive" },
    { QN_LAW_ELASTIC, "\"ks\": 1e10", "\"elasticity\": 1e10",
      "laws[0].kn: elasticity excludes kn and ks" },
    { QN_LAW_ELASTIC, "\"kn\": 3e10, \"ks\": 1e10",
      "\"elasticity\": 3e10, \"poisson\": 0.5",
      "laws[0].poisson: Poisson's ratio of a law must be at least 0 and below 0.5" },
    { QN_LAW_ELASTIC, "\"ks\": 1e10", "\"ks\": 1e10, \"arrangement\": \"grid\"",
      "laws[0].arrangement: this belongs to elasticity, which is missing" },
    { QN_LAW_NO_TENSION, "\"kn\": 3, \"ks\": 2", "\"elasticity\": 3",
      "laws[0].elasticity: elasticity needs the basis \"material\"" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text = with_laws (kinds[cases[i].kind]);
    g_autofree char *changed = test_replace (text, cases[i].what, cases[i].by);
    assert_error (changed, cases[i].message);
  }
}

/* Placement through a round trip: absent it stays absent. */
static void
test_pair_rules (void)
{
  static const struct {
    const char *pairs;
    QnPlacement placement;
    double offset;
    int count;
    const char *written; /* NULL: nothing */
  } cases[] = {
    { "", QN_PLACEMENT_DEFAULT, 0, 0, NULL },
    { ", \"pairs\": { }", QN_PLACEMENT_DEFAULT, 0, 0, NULL },
    { ", \"pairs\": { \"offset\": 0.02 }", QN_PLACEMENT_DEFAULT, 0.02, 0, "\"default\"" },
    { ", \"pairs\": { \"placement\": \"ends\" }", QN_PLACEMENT_ENDS, 0, 0, "\"ends\"" },
    { ", \"pairs\": { \"placement\": \"gauss-lobatto\" }", QN_PLACEMENT_LOBATTO, 0, 0,
      "\"gauss-lobatto\", \"offset\": 0 }" },
    { ", \"pairs\": { \"placement\": \"gauss-lobatto\", \"offset\": 0.02, \"count\": 9 }",
      QN_PLACEMENT_LOBATTO, 0.02, 9,
      "\"gauss-lobatto\", \"offset\": 0.02, \"count\": 9 }" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnProject project, again;
    g_autofree char *text = with_laws (kinds[QN_LAW_ELASTIC]);
    g_autofree char *by =
      g_strdup_printf ("\"contact\": { \"law\": \"joint\"%s }", cases[i].pairs);
    g_autofree char *full =
      test_replace (text, "\"contact\": { \"law\": \"joint\" }", by);
    test_parse (full, &project);
    g_assert_cmpuint (project.warnings->len, ==, 0);
    g_autofree char *written = qn_project_to_text (&project, NULL);
    g_assert_true (strstr (written, cases[i].written != NULL ? cases[i].written : "law")
                   != NULL);
    g_assert_true ((strstr (written, "\"pairs\"") != NULL) == (cases[i].written != NULL));
    test_parse (written, &again);
    const QnModel *models[] = { &project.model, &again.model };
    for (int k = 0; k < 2; k++) {
      const QnPairRule *rule = &models[k]->contact.pairs;
      g_assert_cmpint (rule->placement, ==, cases[i].placement);
      g_assert_cmpfloat (rule->offset, ==, cases[i].offset);
      g_assert_cmpint (rule->count, ==, cases[i].count);
    }
    qn_project_clear (&again);
    qn_project_clear (&project);
  }
}

/* Bars, and pairs placed one by one, through a round trip. */
static void
test_bars_and_pairs (void)
{
  QnProject project, again;
  g_autofree char *text = with_laws (kinds[QN_LAW_ELASTIC]);
  g_autofree char *full = test_replace (
    text, "\"contact\": { \"law\": \"joint\" }",
    "\"bars\": [ { \"law\": \"joint\", \"area\": 3e-4, \"start\": [0.5, -0.5], \"end\": "
    "[0.5, 0.5], \"via\": [[0.4, 0], [0.5, 0.25]] }, { \"law\": \"joint\", \"area\": "
    "1e-4, "
    "\"start\": [0.25, -0.5], \"end\": [0.75, 0.5], \"spacing\": [0.25, 0] } ], "
    "\"contact\": { \"law\": \"joint\", \"pairs\": { \"placement\": "
    "\"explicit\", \"positions\": [0, 0.5, 1], \"weights\": [0.25, 0.5, 0.25] } }");
  test_parse (full, &project);
  g_assert_cmpuint (project.warnings->len, ==, 0);
  g_autofree char *written = qn_project_to_text (&project, NULL);
  test_parse (written, &again);
  const QnModel *models[] = { &project.model, &again.model };
  for (int i = 0; i < 2; i++) {
    const QnPairRule *rule = &models[i]->contact.pairs;
    g_assert_cmpuint (models[i]->bar_count, ==, 2);
    g_assert_cmpint (models[i]->bars[0].via_count, ==, 2);
    g_assert_cmpfloat (models[i]->bars[0].via[1].y, ==, 0.25);
    g_assert_cmpfloat (models[i]->bars[1].spacing.x, ==, 0.25);
    g_assert_cmpfloat (models[i]->bars[0].area, ==, 3e-4);
    g_assert_cmpint (models[i]->bars[0].law, ==, 0);
    g_assert_cmpfloat (models[i]->bars[0].end.y, ==, 0.5);
    g_assert_cmpint (rule->placement, ==, QN_PLACEMENT_EXPLICIT);
    g_assert_cmpint (rule->count, ==, 3);
    g_assert_cmpfloat (rule->positions[1], ==, 0.5);
    g_assert_cmpfloat (rule->weights[2], ==, 0.25);
  }
  qn_project_clear (&again);
  qn_project_clear (&project);

  static const struct {
    const char *what, *by, *message;
  } cases[] = {
    { "\"area\": 3e-4, ", "", "bars[0].area: required key is missing" },
    { "[0.5, 0.5], \"via\"", "[0.5, 0.5], \"via\": [[0.5]], \"w\"",
      "bars[0].via[0]: expected two numbers" },
    { "[0.4, 0]", "[0.5, -0.5]", "bars[0].end: bar has no length" },
    { "[0.25, 0.5, 0.25]", "[0.25, 0.75]",
      "contact.pairs.weights: there must be as many weights as positions" },
    { "[0.25, 0.5, 0.25]", "[0.25, 0.5, 0.5]",
      "contact.pairs.weights: weights must be positive and add up to 1" },
    { "[0, 0.5, 1]", "[0, 1, 0.5]",
      "contact.pairs.positions: positions must increase from 0 to 1" },
    { "[0, 0.5, 1]", "[0, 0.5, 1.5]",
      "contact.pairs.positions: positions must increase from 0 to 1" },
    { "\"basis\": \"material\", ", "",
      "bars[0].law: a bar needs a law by area: basis surface or material" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *changed = test_replace (full, cases[i].what, cases[i].by);
    assert_error (changed, cases[i].message);
  }
}

/* A law by points takes as many as it has room for. */
static void
test_too_many_points (void)
{
  g_autoptr (GString) law =
    g_string_new ("{ \"name\": \"joint\", \"kind\": \"curve\", \"kn\": 1e7, \"ks\": 1e7, "
                  "\"points\": [[-1, -1]");
  for (int i = 0; i < QN_MAX_CURVE_POINTS; i++)
    g_string_append_printf (law, ", [%d, 0]", i);
  g_string_append (law, "] }");
  g_autofree char *text = with_laws (law->str);
  g_autofree char *message = test_parse_error (text, NULL);
  if (strstr (message, "laws[0].points: ") == NULL)
    g_error ("%s", message);
}

QN_TESTS
{
  g_test_add_func ("/project-law/round-trip", test_round_trip);
  g_test_add_func ("/project-law/elasticity", test_elasticity);
  g_test_add_func ("/project-law/values", test_values);
  g_test_add_func ("/project-law/warnings", test_warnings);
  g_test_add_func ("/project-law/brittle", test_brittle);
  g_test_add_func ("/project-law/refused", test_refused);
  g_test_add_func ("/project-law/pair-rules", test_pair_rules);
  g_test_add_func ("/project-law/bars-and-pairs", test_bars_and_pairs);
  g_test_add_func ("/project-law/too-many-points", test_too_many_points);
}
