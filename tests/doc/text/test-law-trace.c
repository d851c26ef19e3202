#include "doc/text/law-text.h"
#include "support/room.h"

#include <math.h>

/* The typical history shows, for a law of any numbers, what is particular about its kind. */
static void
test_scaled (void)
{
  for (int kind = 0; kind < QN_LAW_KIND_COUNT; kind++) {
    /* Concrete, steel and points have strains that go with their stiffness. */
    int most_soft = kind < QN_LAW_CONCRETE ? 2 : 1;
    for (int softer = 0; softer < most_soft; softer++) {
      QnLaw law = qn_law_preset ((QnLawKind) kind)->law;
      law.kn *= softer ? 0.1 : 1.0;
      law.ks *= softer ? 0.1 : 1.0;
      QnLawPreset what = qn_law_preset_for (&law);
      g_autoptr (GArray) samples = g_array_new (FALSE, FALSE, sizeof (QnLawSample));
      double length = law.basis == QN_BASIS_MATERIAL ? 0.1 : 1.0;
      g_assert_true (qn_law_trace (&what, length, samples));
      g_assert_cmpuint (samples->len, ==, what.turn_count * 400 + 1);
      double most = 0.0;
      gboolean yields = FALSE;
      for (guint i = 0; i < samples->len; i++) {
        const QnLawSample *s = &g_array_index (samples, QnLawSample, i);
        int axis = what.shear ? 1 : 0;
        most = fmax (most, fabs (s->force[axis]));
        yields = yields || fabs (s->tangent[axis]) < 0.5 * (axis ? law.ks : law.kn);
      }
      g_assert_cmpfloat (most, >, 0.0);
      g_assert_true (yields || kind == QN_LAW_ELASTIC);
    }
  }
}

/* Whatever a law was, as another kind it is valid. */
static void
test_change_kind (void)
{
  for (int from = 0; from < QN_LAW_KIND_COUNT; from++) {
    for (int to = 0; to < QN_LAW_KIND_COUNT; to++) {
      QnLaw law = qn_law_preset ((QnLawKind) from)->law;
      law.name = (char *) "law";
      qn_law_change_kind (&law, (QnLawKind) to);
      g_assert_cmpint (law.kind, ==, to);
      g_assert_cmpstr (law.name, ==, "law");
      QnDiag diag = { 0 };
      g_assert_cmpint (qn_law_check (&law, 0, &diag), ==, QN_OK);
    }
  }
}

QN_TESTS
{
  g_test_add_func ("/doc/law-trace/scaled", test_scaled);
  g_test_add_func ("/doc/law-trace/change-kind", test_change_kind);
}
