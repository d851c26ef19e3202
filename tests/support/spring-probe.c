#include "support/spring-probe.h"

#include <glib.h>
#include <math.h>

Probe
probe_of_law (const QnLaw *law)
{
  QnDiag diag = { 0 };
  qn_law_check (law, 0, &diag);
  g_assert_cmpstr (qn_problem_text (diag.problem), ==, "no problem");
  return (Probe){ .spring = qn_spring_from_law (law, 1, 1) };
}

QnSpringResponse
probe_look (const Probe *probe, double normal, double tangential)
{
  QnSpringResponse response;
  qn_spring_evaluate (&probe->spring, &probe->memory,
                      (const double[]){ normal, tangential }, &response);
  return response;
}

QnSpringResponse
probe_go (Probe *probe, double normal, double tangential)
{
  QnSpringResponse response = probe_look (probe, normal, tangential);
  probe->memory = response.memory;
  return response;
}

void
probe_assert_force (const QnSpringResponse *response, double normal, double tangential)
{
  double scale = fmax (1, fmax (fabs (normal), fabs (tangential)));
  g_assert_cmpfloat_with_epsilon (response->force[0], normal, 1e-12 * scale);
  g_assert_cmpfloat_with_epsilon (response->force[1], tangential, 1e-12 * scale);
}

void
probe_assert_tangent (const Probe *probe, double normal, double tangential)
{
  const QnSpring *spring = &probe->spring;
  QnSpringResponse at = probe_look (probe, normal, tangential);
  double largest = fmax (spring->kn, spring->ks);
  double step = 1e-6 * fmax (fabs (normal), fabs (tangential));

  for (int j = 0; j < 2; j++) {
    double dn = j == 0 ? step : 0, dt = j == 1 ? step : 0;
    QnSpringResponse up = probe_look (probe, normal + dn, tangential + dt);
    QnSpringResponse down = probe_look (probe, normal - dn, tangential - dt);
    g_assert_cmpint (up.state, ==, at.state);
    g_assert_cmpint (down.state, ==, at.state);
    for (int i = 0; i < 2; i++) {
      double slope = (up.force[i] - down.force[i]) / (2 * step);
      g_assert_cmpfloat_with_epsilon (at.tangent[i][j], slope, 1e-6 * largest);
    }
  }
  /* Slip that opens less than friction asks for is the one flow that is not associated. */
  if (!qn_law_is_plastic (spring->kind) || spring->dilatancy == spring->friction)
    g_assert_cmpfloat_with_epsilon (at.tangent[0][1], at.tangent[1][0], 1e-12 * largest);
}

void
probe_assert_history (Probe *probe, const double (*rows)[2], size_t count)
{
  double before = 0;
  for (size_t i = 0; i < count; i++) {
    /* Off the middle, where a history is likelier to have its corners. */
    if (rows[i][0] != before)
      probe_assert_tangent (probe, before + 0.5437 * (rows[i][0] - before), 0);
    QnSpringResponse response = probe_go (probe, rows[i][0], 0);
    g_test_message ("row %zu: elongation %g, force %.12g", i, rows[i][0],
                    response.force[0]);
    probe_assert_force (&response, rows[i][1], 0);
    before = rows[i][0];
  }
}
