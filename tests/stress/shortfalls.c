#include "stress/shortfalls.h"

static const StressShortfall shortfalls[] = {
  { "contrast=1e+0?-*",
    STRESS_BUDGET | STRESS_NO_ANSWER | STRESS_OUTCOME | STRESS_MECHANISM,
    "Elastic motion of joints a million times softer than others counts as falling." },
  { "ks/kn=10000-*", STRESS_BUDGET | STRESS_NO_ANSWER,
    "Shear springs ten thousand times stiffer than those that open." },
  { "friction=1e-06-*", STRESS_LIMIT,
    "Shear forces of a millionth of the loads, the program being solved to 1e-8 of "
    "them." },
  { "hanging-1e-06", STRESS_NO_ANSWER,
    "Limit analysis, a millionth beside the verge, proves neither standing nor "
    "falling." },
  { "loaded-1e-0?-*", STRESS_NO_ANSWER,
    "Limit analysis, a millionth beside the verge, proves neither standing nor "
    "falling." },
  { "aspect=1e-?", STRESS_MECHANISM | STRESS_DIFFERS | STRESS_BUDGET,
    "Upright slabs wedge and let go by turns." },
  { "*thin-course=*", STRESS_MECHANISM,
    "Without dilatancy: viscous relaxation does not decide in time how the structure "
    "moves, and the last motion between equilibria is reported." },
  { "random-27", STRESS_MECHANISM,
    "Without dilatancy: the last motion between equilibria closes joints that were "
    "open." },
  { "random-246", STRESS_DIFFERS,
    "Associative multiplier 3 % low: the central path breaks off where blocks are far." },
  { "random-813", STRESS_DIFFERS,
    "Associative multiplier 0.15 % low: the central path breaks off where blocks are "
    "far." },
  { "idle-*", STRESS_BUDGET,
    "Free to move, under a live load that does not make it: increments stay small all "
    "the "
    "way to the largest multiplier there is." },
  { "residual=1e-12-*", STRESS_NO_ANSWER | STRESS_BUDGET,
    "Forces cannot be summed up to 1e-12." },
};

const StressShortfall *
stress_shortfall (const char *name)
{
  for (size_t i = 0; i < G_N_ELEMENTS (shortfalls); i++)
    if (g_pattern_match_simple (shortfalls[i].pattern, name))
      return &shortfalls[i];
  return NULL;
}
