#include "stress/cases.h"

#include "support/models.h"
#include "support/walls.h"

#include <math.h>

StressCase *
stress_cases_add (GArray *cases, const char *subject, StressBuild build, int number,
                  double value, const char *format, ...)
{
  StressCase c = { .subject = subject,
                   .build = build,
                   .number = number,
                   .value = value,
                   .exact = { NAN, NAN } };
  va_list arguments;

  va_start (arguments, format);
  g_vsnprintf (c.name, sizeof c.name, format, arguments);
  va_end (arguments);
  g_array_append_val (cases, c);
  return &g_array_index (cases, StressCase, cases->len - 1);
}

void
stress_cases_add_on_walls (GArray *cases, const char *subject, StressBuild build,
                           double value, const char *what)
{
  int brief = 1 + (int) (cases->len / TEST_WALL_COUNT % 5);

  for (int wall = 1; wall <= TEST_WALL_COUNT; wall++)
    stress_cases_add (cases, subject, build, wall, value, "%s=%g-wall%d", what, value,
                      wall)
      ->brief = wall == brief;
}

void
stress_case_build_random (const StressCase *c, QnModel *model)
{
  char description[160];
  test_wall_draw_any (model, (guint32) c->number, description, sizeof description);
}

void
stress_cases_add_random (GArray *cases, guint32 first, guint count)
{
  for (guint32 seed = first; seed < first + count; seed++)
    stress_cases_add (cases, "random walls", stress_case_build_random, (int) seed, 0,
                      "random-%u", seed)
      ->repeat = 37;
}

GArray *
stress_cases_new (void)
{
  GArray *cases = g_array_new (FALSE, FALSE, sizeof (StressCase));

  stress_cases_add_joints (cases);
  stress_cases_add_shapes (cases);
  stress_cases_add_starts (cases);
  stress_cases_add_steps (cases);
  return cases;
}
