#include "core/contact/finding.h"
#include "support/room.h"

#include <glib.h>

static void
test_add_keeps_order (void)
{
  QnFindings findings = { 0 };
  for (int i = 0; i < 1000; i++)
    g_assert_true (qn_findings_add (
      &findings,
      (QnFinding){
        QN_PROBLEM_NEAR_MISS_GAP, i, i + 1, { i, -i }, 0.001 * i, QN_NONE, NULL }));
  g_assert_cmpuint (findings.count, ==, 1000);
  for (int i = 0; i < 1000; i++) {
    g_assert_cmpint (findings.items[i].block_a, ==, i);
    g_assert_cmpint (findings.items[i].block_b, ==, i + 1);
    g_assert_cmpfloat (findings.items[i].at.y, ==, -i);
  }
  qn_findings_clear (&findings);
  g_assert_cmpuint (findings.count, ==, 0);
  g_assert_null (findings.items);
  qn_findings_clear (&findings);
}

QN_TESTS
{
  g_test_add_func ("/finding/add-keeps-order", test_add_keeps_order);
}
