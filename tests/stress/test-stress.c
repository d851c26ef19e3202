/* The load path where it is likely to break: extreme stiffness, friction, strength, size, place and
 * step. Every case is solved with dilatancy = friction and with none. Whatever happens, the
 * equilibria that are reported must be equilibria (verify_solve() looks) and the iterations
 * must end; where a collapse multiplier is claimed, associative joints must have that of limit
 * analysis to 0.1 %, others must not exceed it. */
#include "verify/solve.h"

#include "core/limit.h"
#include "support/models.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* Iterations that no case may exceed. */
#define MOST_ITERATIONS 30000

/* What is 0 stays as the wall has it. */
typedef struct {
  const char *name;
  int wall;
  double kn, ratio; /* N/m; ks / kn */
  double friction;
  bool frictionless;
  double cohesion, tension; /* N */
  double scale, shift;      /* of lengths; m */
  double increments;
} Case;

static const Case cases[] = {
  { "kn 1e3", .wall = 3, .kn = 1e3 },
  { "kn 1e5", .wall = 1, .kn = 1e5 },
  { "kn 1e9", .wall = 3, .kn = 1e9 },
  { "kn 1e12", .wall = 4, .kn = 1e12 },
  { "kn 1e15", .wall = 3, .kn = 1e15 },
  { "ks/kn 1e-4", .wall = 1, .kn = 1e9, .ratio = 1e-4 },
  { "ks/kn 1e-2", .wall = 4, .kn = 1e9, .ratio = 1e-2 },
  { "ks/kn 1e2", .wall = 3, .kn = 1e7, .ratio = 1e2 },
  { "ks/kn 1e4", .wall = 1, .kn = 1e7, .ratio = 1e4 },
  { "friction 0", .wall = 1, .frictionless = true },
  { "friction 0.01", .wall = 1, .friction = 0.01 },
  { "friction 0.2", .wall = 2, .friction = 0.2 },
  { "friction 1.5", .wall = 3, .friction = 1.5 },
  { "friction 5", .wall = 1, .friction = 5 },
  { "cohesion 1 kN", .wall = 1, .cohesion = 1e3 },
  { "cohesion and tension", .wall = 3, .cohesion = 1e3, .tension = 500 },
  { "tension to the apex", .wall = 4, .cohesion = 1e3, .tension = 1e9 },
  { "millimetres", .wall = 3, .scale = 1e-3 },
  { "kilometres", .wall = 3, .scale = 1e3 },
  { "100 km away", .wall = 1, .shift = 1e5 },
  { "1 increment", .wall = 3, .increments = 1 },
  { "3 increments", .wall = 5, .increments = 3 },
  { "1000 increments", .wall = 4, .increments = 1000 },
};

static void
make (const Case *c, bool associative, QnModel *model)
{
  test_model_init_wall (model, c->wall, 0);
  QnLaw *law = &model->laws[0];

  if (c->kn > 0)
    law->kn = law->ks = c->kn;
  if (c->ratio > 0)
    law->ks = c->ratio * law->kn;
  if (c->friction > 0 || c->frictionless)
    law->friction = c->friction;
  law->cohesion = c->cohesion;
  law->tension = c->tension;
  law->dilatancy = associative ? law->friction : 0;
  if (c->increments > 0)
    model->analysis.increments = c->increments;
  if (c->scale > 0)
    test_model_scale (model, c->scale);
  if (c->shift != 0)
    test_model_translate (model, c->shift, c->shift);
}

/* The multiplier of limit analysis; 0 where the structure carries no live load at all. */
static double
find_bound (const Case *c)
{
  QnModel model;
  QnContacts contacts;
  QnLimitSolution solution;

  make (c, true, &model);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_limit_associative (&model, &contacts, NULL, NULL, &solution, NULL),
                   ==, QN_OK);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  double bound = solution.upper_bound;
  qn_limit_solution_clear (&solution);
  qn_contacts_clear (&contacts);
  qn_model_clear (&model);
  return bound;
}

static void
test_case (gconstpointer data)
{
  const Case *c = data;
  double bound = find_bound (c);

  for (int associative = 1; associative >= 0; associative--) {
    QnModel model;
    Solved solved;
    make (c, associative, &model);
    verify_solve (&solved, &model);
    const QnResult *result = &solved.result;
    double floor = 1e-3 * solved.model.analysis.multiplier_tolerance;

    g_test_message ("%s, dilatancy %s: outcome %d, multiplier %.7f, limit %.7f, %d "
                    "factorisations",
                    c->name, associative ? "= friction" : "0", (int) result->outcome,
                    result->collapse_multiplier, bound,
                    result->statistics.factorizations);
    g_assert_cmpint (result->statistics.iterations, <, MOST_ITERATIONS);
    g_assert_cmpint (result->outcome, ==, QN_OUTCOME_COLLAPSE);
    if (associative)
      g_assert_cmpfloat (fabs (result->collapse_multiplier - bound), <=,
                         1e-3 * bound + floor);
    else
      g_assert_cmpfloat (result->collapse_multiplier, <=,
                         bound * (1 + solved.model.analysis.multiplier_tolerance)
                           + floor);
    verify_clear (&solved);
  }
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *name = g_strdup_printf ("/stress/%s", cases[i].name);
    for (char *p = strchr (name + 1, '/') + 1; *p != '\0'; p++)
      if (*p == ' ' || *p == '/')
        *p = '-';
    g_test_add_data_func (name, &cases[i], test_case);
  }
  return g_test_run ();
}
