#include "stress/shortfalls.h"

typedef struct Shortfall {
  const char *pattern; /* of the cases' names */
  guint faults;
} Shortfall;

static const Shortfall shortfalls[] = {
  /* Every other block on joints a million times softer. */
  { "contrast=1e+0?-*",
    STRESS_BUDGET | STRESS_NO_ANSWER | STRESS_OUTCOME | STRESS_MECHANISM },
  { "ks/kn=10000-*", STRESS_BUDGET | STRESS_NO_ANSWER },
  /* Forces a millionth of the loads: beyond the accuracy of the program, 1e-8 of the loads. */
  { "friction=1e-06-*", STRESS_LIMIT },
  { "hanging-1e-06", STRESS_NO_ANSWER },
  { "loaded-1e-0?-*", STRESS_NO_ANSWER },
  /* The mechanism that ends the path without dilatancy closes joints that it should not. */
  { "aspect=1e-?", STRESS_MECHANISM | STRESS_DIFFERS | STRESS_BUDGET },
  { "wedged-30", STRESS_MECHANISM },
  { "ks/kn=0.1-wall2", STRESS_MECHANISM },
  /* Structures that are free to move, with a live load that does not make them: increments
   * stay small all the way to the largest multiplier there is. */
  { "idle-*", STRESS_BUDGET },
  /* Out of reach of rounding. */
  { "residual=1e-12-*", STRESS_NO_ANSWER | STRESS_BUDGET },
  /* Collapse is claimed before the multiplier has settled. */
  { "random-5", STRESS_DIFFERS },
};

guint
stress_shortfalls (const char *name)
{
  for (size_t i = 0; i < G_N_ELEMENTS (shortfalls); i++)
    if (g_pattern_match_simple (shortfalls[i].pattern, name))
      return shortfalls[i].faults;
  return 0;
}
