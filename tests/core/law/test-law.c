#include "core/law/law.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* A law of each kind that breaks no rule. */
static QnLaw
sound_law (QnLawKind kind)
{
  QnLaw law = { .name = "law",
                .kind = kind,
                .basis = QN_BASIS_MATERIAL,
                .kn = 30e9,
                .ks = 12.5e9,
                .friction = 0.6,
                .dilatancy = kind == QN_LAW_MOHR_COULOMB ? 0 : 0.6,
                .yield = 20e6,
                .compression = 30e6,
                .strength = 30e6,
                .ultimate_strain = 0.0035,
                .crushing_energy = 2e4,
                .tension = 2e6,
                .fracture_energy = 100,
                .point_count = 3,
                .points = { { -0.002, -30e6 }, { 0.0001, 3e6 }, { 0.001, 4e6 } } };
  return law;
}

static void
assert_refused (const QnLaw *law, QnProblem problem, const char *field)
{
  QnDiag diag = { 0 };
  g_assert_cmpint (qn_law_check (law, 4, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpstr (qn_problem_text (diag.problem), ==, qn_problem_text (problem));
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_LAW);
  g_assert_cmpint (diag.index, ==, 4);
  g_assert_cmpstr (diag.field, ==, field);
}

static void
test_names (void)
{
  static const char *const names[QN_LAW_KIND_COUNT] = {
    "elastic",         "no-tension", "coulomb", "mohr-coulomb", "bilinear",
    "elastic-plastic", "concrete",   "steel",   "curve"
  };
  for (int kind = 0; kind < QN_LAW_KIND_COUNT; kind++)
    g_assert_cmpstr (qn_law_kind_names[kind], ==, names[kind]);
  g_assert_cmpstr (qn_basis_names[QN_BASIS_CONTACT], ==, "contact");
  g_assert_cmpstr (qn_basis_names[QN_BASIS_SURFACE], ==, "surface");
  g_assert_cmpstr (qn_basis_names[QN_BASIS_MATERIAL], ==, "material");
}

static void
test_sound (void)
{
  for (int kind = 0; kind < QN_LAW_KIND_COUNT; kind++) {
    QnLaw law = sound_law ((QnLawKind) kind);
    g_assert_cmpint (qn_law_check (&law, 0, NULL), ==, QN_OK);
  }
}

/* Every number of every kind: not finite, negative, and zero where it must be positive. */
static void
test_numbers (void)
{
  for (int kind = 0; kind < QN_LAW_KIND_COUNT; kind++) {
    size_t count;
    const QnLawParameter *parameters = qn_law_parameters ((QnLawKind) kind, &count);
    for (size_t i = 0; i < count; i++) {
      const char *key = parameters[i].key;
      QnLaw law = sound_law ((QnLawKind) kind);
      *qn_law_at (&law, &parameters[i]) = NAN;
      assert_refused (&law, QN_PROBLEM_NOT_FINITE, key);
      *qn_law_at (&law, &parameters[i]) = -1;
      assert_refused (
        &law, parameters[i].positive ? QN_PROBLEM_NOT_POSITIVE : QN_PROBLEM_NEGATIVE,
        key);
      *qn_law_at (&law, &parameters[i]) = 0;
      if (parameters[i].required && parameters[i].positive)
        assert_refused (&law, QN_PROBLEM_NOT_POSITIVE, key);
    }
    QnLaw law = sound_law ((QnLawKind) kind);
    law.kn = 0;
    assert_refused (&law, QN_PROBLEM_NOT_POSITIVE, "kn");
    law = sound_law ((QnLawKind) kind);
    law.ks = INFINITY;
    assert_refused (&law, QN_PROBLEM_NOT_FINITE, "ks");
    law = sound_law ((QnLawKind) kind);
    law.shear_factor = -0.1;
    assert_refused (&law, QN_PROBLEM_NEGATIVE, "shear_factor");
  }
}

static void
test_rules (void)
{
  QnLaw law = sound_law (QN_LAW_COULOMB);
  law.dilatancy = 0.7;
  assert_refused (&law, QN_PROBLEM_DILATANCY_ABOVE_FRICTION, "dilatancy");
  law = sound_law (QN_LAW_BILINEAR);
  law.hardening = 1;
  assert_refused (&law, QN_PROBLEM_HARDENING_TOO_LARGE, "hardening");
  law = sound_law (QN_LAW_STEEL);
  law.strength = 19e6;
  assert_refused (&law, QN_PROBLEM_STRENGTH_BELOW_YIELD, "strength");
  law = sound_law (QN_LAW_STEEL);
  law.ultimate_strain = 0.001;
  assert_refused (&law, QN_PROBLEM_ULTIMATE_STRAIN_TOO_SMALL, "ultimate_strain");
  law = sound_law (QN_LAW_CONCRETE);
  law.fracture_energy = 0;
  assert_refused (&law, QN_PROBLEM_FRACTURE_ENERGY_MISSING, "fracture_energy");
  law = sound_law (QN_LAW_CONCRETE);
  law.crushing_energy = 0;
  assert_refused (&law, QN_PROBLEM_FRACTURE_ENERGY_MISSING, "crushing_energy");
  law = sound_law (QN_LAW_CONCRETE);
  law.ultimate_strain = 0.0019;
  assert_refused (&law, QN_PROBLEM_ULTIMATE_STRAIN_TOO_SMALL, "ultimate_strain");
  law.ultimate_strain = 0;
  assert_refused (&law, QN_PROBLEM_NOT_POSITIVE, "ultimate_strain");
  law.name = (char *) "";
  assert_refused (&law, QN_PROBLEM_NAME_MISSING, "name");
}

static void
test_curves (void)
{
  const struct {
    int count;
    QnVec2 points[3];
    QnProblem problem;
    QnId sub;
  } curves[] = {
    { 0, { { 0 } }, QN_PROBLEM_CURVE_COUNT, QN_NONE },
    { 1, { { 0, 0 } }, QN_PROBLEM_CURVE_COUNT, QN_NONE },
    { 2, { { 0.001, 1e6 }, { NAN, 1e6 } }, QN_PROBLEM_NOT_FINITE, 1 },
    { 2, { { 0.001, 1e6 }, { 0.001, 2e6 } }, QN_PROBLEM_CURVE_ORDER, 1 },
    { 1, { { 0.001, -1e6 } }, QN_PROBLEM_CURVE_SIGN, 0 },
    { 2, { { 0, 1e6 }, { 1, 1e6 } }, QN_PROBLEM_CURVE_SIGN, 0 },
    { 1, { { 0.001, 30.1e6 } }, QN_PROBLEM_CURVE_TOO_STEEP, 0 },
    { 2, { { 0.001, 1e6 }, { 0.0011, 5e6 } }, QN_PROBLEM_CURVE_TOO_STEEP, 1 },
    { 2, { { -0.0011, -5e6 }, { -0.001, -1e6 } }, QN_PROBLEM_CURVE_TOO_STEEP, 0 },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (curves); i++) {
    QnDiag diag = { 0 };
    QnLaw law = sound_law (QN_LAW_CURVE);
    law.point_count = curves[i].count;
    memcpy (law.points, curves[i].points, sizeof curves[i].points);
    assert_refused (&law, curves[i].problem, "points");
    qn_law_check (&law, 0, &diag);
    g_assert_cmpint (diag.sub, ==, curves[i].sub);
  }

  /* A descent over strain needs an energy, on either side; over elongations it does not. */
  QnLaw law = sound_law (QN_LAW_CURVE);
  law.fracture_energy = law.crushing_energy = 0;
  g_assert_cmpint (qn_law_check (&law, 0, NULL), ==, QN_OK);
  law.points[2].y = 1e6;
  assert_refused (&law, QN_PROBLEM_FRACTURE_ENERGY_MISSING, "fracture_energy");
  law.basis = QN_BASIS_SURFACE;
  g_assert_cmpint (qn_law_check (&law, 0, NULL), ==, QN_OK);
  law = sound_law (QN_LAW_CURVE);
  law.crushing_energy = 0;
  law.points[0] = (QnVec2){ -0.004, -1e6 };
  law.points[1] = (QnVec2){ -0.002, -30e6 };
  assert_refused (&law, QN_PROBLEM_FRACTURE_ENERGY_MISSING, "crushing_energy");
}

QN_TESTS
{
  g_test_add_func ("/law/names", test_names);
  g_test_add_func ("/law/sound", test_sound);
  g_test_add_func ("/law/numbers", test_numbers);
  g_test_add_func ("/law/rules", test_rules);
  g_test_add_func ("/law/curves", test_curves);
}
