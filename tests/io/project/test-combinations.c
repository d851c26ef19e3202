/* Combinations of load cases: which there are, counted by hand, and what they make of a project. */
#include "io/project/combinations.h"

#include "io/project-text.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

/* A permanent case, one of rooms, one of snow, winds from two sides; `more` cases and settings. */
static GPtrArray *
make (const char *code, const char *more, QnProject *project, GError **error)
{
  g_autofree char *loads = g_strdup_printf (
    "\"loads\": { \"cases\": { \"g\": { \"factor\": 2, \"action\": \"permanent\" }, "
    "\"q\": { \"action\": \"category C\" }, \"s\": { \"action\": \"snow\" }%s }, "
    "\"combinations\": { \"code\": \"%s\", \"friction\": 1.25, \"strength\": 2, "
    "\"seismic_friction\": 1.1 }, ",
    more, code);
  g_autofree char *text = test_replace (test_project_text, "\"loads\": { ", loads);
  test_parse (text, project);
  return qn_combinations_make (project, error);
}

/* Of one permanent action with two factors: both, or one where they are equal, times the choices of two
 * variable actions (none, either, both with either leading: 5; without a leading one 4). */
static void
test_counts (void)
{
  static const struct {
    const char *code, *more;
    guint count;
  } cases[] = {
    { "en1990", "", 2 * 5 + 2 * 5 },
    /* g alone, with its favourable factor, is of 6.10a and of 6.10b, or of A1 and of A2: one */
    { "en1990 6.10a and b", "", 2 * 5 + 2 * 4 + 2 * 5 - 1 },
    { "ntc2018", "", 2 * 5 + 2 * 5 + 5 - 1 },
    /* psi2 of snow is 0; that of rooms always acts, or, by NTC, not where it helps */
    { "en1990", ", \"e\": { \"action\": \"seismic\" }", 20 + 1 },
    { "ntc2018", ", \"e\": { \"action\": \"seismic\" }", 24 + 2 },
    /* earthquakes exclude each other */
    { "en1990",
      ", \"e\": { \"action\": \"seismic\" }, \"f\": { \"action\": \"seismic\" }",
      20 + 2 },
    /* and so do winds: 5 choices without one; with one, 1 alone, 2 with rooms, 2 with snow, 3 with
     * both, by what leads */
    { "en1990", ", \"w\": { \"action\": \"wind\" }, \"x\": { \"action\": \"wind\" }",
      4 * (5 + 2 * 8) },
    { "en1990", ", \"other\": 3", 20 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnProject) project;
    g_autoptr (GError) error = NULL;
    g_autoptr (GPtrArray) list = make (cases[i].code, cases[i].more, &project, &error);
    g_assert_no_error (error);
    g_assert_cmpuint (list->len, ==, cases[i].count);
  }
}

static const QnCombination *
find (const GPtrArray *list, const char *name)
{
  for (guint i = 0; i < list->len; i++) {
    const QnCombination *of = list->pdata[i];
    g_assert_cmpstr (of->label, ==, of->name); /* in English */
    if (strcmp (of->name, name) == 0)
      return of;
  }
  g_error ("no combination %s", name);
}

/* Tables A1.1, A1.2(A), A1.2(B) of EN 1990, 2.5.I and 2.6.I of NTC 2018. */
static void
test_factors (void)
{
  g_auto (QnProject) project, italian;
  g_autoptr (GPtrArray) list =
    make ("en1990", ", \"e\": { \"action\": \"seismic\" }", &project, NULL);
  g_autoptr (GPtrArray) ntc =
    make ("ntc2018", ", \"n\": { \"action\": \"non-structural\" }", &italian, NULL);
  find (list, "EQU 6.10: 1.1 g + 1.05 q + 1.5 s");
  find (list, "EQU 6.10: 0.9 g + 1.5 q + 0.75 s");
  find (list, "STR 6.10: 1 g");
  find (ntc, "STR A1: 1 g + 1.5 q + 0.75 s + 0.8 n");
  find (ntc, "GEO A2: 1 g + 0.91 q + 1.3 s + 1.3 n");
  const QnCombination *str = find (list, "STR 6.10: 1.35 g + 1.5 q + 0.75 s");
  const QnCombination *seismic = find (list, "seismic 6.12b: 1 g + 0.6 q + 1 e");
  g_assert_cmpfloat (str->friction, ==, 1.25);
  g_assert_cmpfloat (str->strength, ==, 2);
  g_assert_cmpfloat (seismic->friction, ==, 1.1);
  g_assert_cmpfloat (seismic->strength, ==, 1);
}

/* Factors multiply those of the cases; joints lose friction, dilatancy and strengths. */
static void
test_overrides (void)
{
  g_auto (QnProject) project, combined;
  g_autoptr (GPtrArray) list = make ("en1990", "", &project, NULL);
  g_assert_nonnull (list);
  g_autoptr (GPtrArray) overrides = g_ptr_array_new_with_free_func (g_free);
  QnLaw *law = &project.model.laws[0];
  law->kind = QN_LAW_MOHR_COULOMB;
  law->friction = 0.5;
  law->residual_friction = 0.4;
  law->dilatancy = 0.25;
  law->cohesion = 100;
  law->compression = 5000;
  law->fracture_energy_tension = 7;
  qn_combination_add_overrides (find (list, "STR 6.10: 1.35 g + 1.5 q"), &project.model,
                                overrides);
  g_ptr_array_add (overrides, g_strdup ("laws[0].kind=mohr-coulomb"));
  g_ptr_array_add (overrides, NULL);
  g_assert_true (qn_project_parse (project.text, project.text_length, "wall.quoin",
                                   (const char *const *) overrides->pdata, &combined,
                                   NULL));
  law = &combined.model.laws[0];
  g_assert_cmpfloat (combined.model.load_cases[0].factor, ==, 2 * 1.35);
  g_assert_cmpfloat (combined.model.load_cases[1].factor, ==, 1.5);
  g_assert_cmpfloat (combined.model.load_cases[2].factor, ==, 0);
  g_assert_cmpfloat (law->friction, ==, 0.4);
  g_assert_cmpfloat (law->residual_friction, ==, 0.32);
  g_assert_cmpfloat (law->dilatancy, ==, 0.2);
  g_assert_cmpfloat (law->cohesion, ==, 50);
  g_assert_cmpfloat (law->compression, ==, 2500);
}

static void
test_refused (void)
{
  g_auto (QnProject) project, many;
  g_autoptr (GError) error = NULL;
  g_autoptr (GString) cases = g_string_new (NULL);
  test_parse (test_project_text, &project);
  g_assert_null (qn_combinations_make (&project, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_clear_error (&error);
  for (int i = 0; i < 9; i++)
    g_string_append_printf (cases, ", \"p%d\": { \"action\": \"permanent\" }", i);
  g_assert_null (make ("en1990", cases->str, &many, &error));
  g_assert_nonnull (strstr (error->message, "1,000"));
}

/* Loads that no combination changes are told, but only where a code combines. */
static void
test_left_as_they_are (void)
{
  g_auto (QnProject) project, plain;
  g_autoptr (GPtrArray) list = make ("en1990", "", &project, NULL);
  g_assert_nonnull (list);
  test_parse (test_project_text, &plain);
  guint told = 0;
  for (guint i = 0; i < project.warnings->len; i++)
    told += strstr (project.warnings->pdata[i], "loads.dead[0]: has no case") != NULL;
  g_assert_cmpuint (told, ==, 1);
  g_assert_cmpuint (project.warnings->len, >, plain.warnings->len);
  for (guint i = 0; i < plain.warnings->len; i++)
    g_assert_null (strstr (plain.warnings->pdata[i], "has no case"));
}

QN_TESTS
{
  g_test_add_func ("/io/combinations/counts", test_counts);
  g_test_add_func ("/io/combinations/factors", test_factors);
  g_test_add_func ("/io/combinations/overrides", test_overrides);
  g_test_add_func ("/io/combinations/left-as-they-are", test_left_as_they_are);
  g_test_add_func ("/io/combinations/refused", test_refused);
}
