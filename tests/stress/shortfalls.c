#include "stress/shortfalls.h"

#define LAST_MOTION                                                                      \
  "Without dilatancy: viscous relaxation does not decide in time how the structure "     \
  "moves, and the last motion between equilibria is reported."
#define MILLIONTH                                                                        \
  "Limit analysis, a millionth beside the verge, proves neither standing nor falling."
#define STIFFNESSES                                                                      \
  "Springs whose stiffness differs by a thousand and more: the last part of the way to " \
  "collapse is longer than the digits reach."
#define STALLS                                                                           \
  "The program stalls at 1e-8 of the loads, and the bounds stay apart by more than "     \
  "1e-6."
#define BREAKS_OFF "The central path breaks off where blocks have gone far."
#define TOWER                                                                            \
  "A tower of 2,000 joints moves as a beam does: its stiffness spreads over thirteen "   \
  "orders of magnitude."
#define WEDGES "High friction without dilatancy: blocks wedge and let go by turns."

static const StressShortfall shortfalls[] = {
  { "contrast=10000-*", STRESS_NO_ANSWER, STIFFNESSES },
  { "contrast=1e+0?-*",
    STRESS_BUDGET | STRESS_NO_ANSWER | STRESS_OUTCOME | STRESS_MECHANISM,
    "Elastic motion of joints a million times softer than others counts as falling." },
  { "ks/kn=0.00*-wall6", STRESS_NO_ANSWER, STIFFNESSES },
  { "ks/kn=1000-*", STRESS_BUDGET | STRESS_NO_ANSWER, STIFFNESSES },
  { "ks/kn=10000-*", STRESS_BUDGET | STRESS_NO_ANSWER, STIFFNESSES },
  { "friction=1e-06-*", STRESS_LIMIT,
    "Shear forces of a millionth of the loads, the program being solved to 1e-8 of "
    "them." },
  { "friction=1.5-wall2", STRESS_MECHANISM, LAST_MOTION },
  { "friction=2-wall6", STRESS_MECHANISM | STRESS_NO_ANSWER, WEDGES },
  { "friction=4-*", STRESS_MECHANISM, WEDGES },
  { "friction=5-*", STRESS_NO_ANSWER | STRESS_MECHANISM, WEDGES },
  { "apex=1-wall6", STRESS_MECHANISM, LAST_MOTION },
  { "weight=0.001-wall2", STRESS_MECHANISM, LAST_MOTION },
  { "hanging-1e-06", STRESS_NO_ANSWER, MILLIONTH },
  { "loaded-1e-0?-*", STRESS_NO_ANSWER, MILLIONTH },
  { "aspect=1e-?", STRESS_MECHANISM | STRESS_DIFFERS | STRESS_BUDGET,
    "Upright slabs wedge and let go by turns." },
  { "*thin-course=*", STRESS_MECHANISM, LAST_MOTION },
  { "stack-of-2000", STRESS_BUDGET | STRESS_STATICS, TOWER },
  { "stack-of-2000-slabs", STRESS_NO_ANSWER | STRESS_BUDGET, TOWER },
  { "bonded-tower-of-2000", STRESS_BUDGET | STRESS_NO_ANSWER, TOWER },
  { "random-27", STRESS_MECHANISM, LAST_MOTION },
  { "random-246", STRESS_DIFFERS, BREAKS_OFF },
  { "random-813", STRESS_DIFFERS, BREAKS_OFF },
  { "random-77", STRESS_MECHANISM, LAST_MOTION },
  { "random-106", STRESS_MECHANISM, LAST_MOTION },
  { "random-137", STRESS_MECHANISM, LAST_MOTION },
  { "random-157", STRESS_MECHANISM | STRESS_NO_ANSWER, LAST_MOTION },
  { "random-168", STRESS_MECHANISM, LAST_MOTION },
  { "random-227", STRESS_MECHANISM, LAST_MOTION },
  { "random-235", STRESS_MECHANISM, LAST_MOTION },
  { "random-242", STRESS_MECHANISM, LAST_MOTION },
  { "random-267", STRESS_MECHANISM, LAST_MOTION },
  { "random-287", STRESS_MECHANISM, LAST_MOTION },
  { "random-340", STRESS_MECHANISM, LAST_MOTION },
  { "random-370", STRESS_MECHANISM, LAST_MOTION },
  { "random-418", STRESS_MECHANISM, LAST_MOTION },
  { "random-480", STRESS_MECHANISM, LAST_MOTION },
  { "random-517", STRESS_MECHANISM, LAST_MOTION },
  { "random-620", STRESS_MECHANISM, LAST_MOTION },
  { "random-678", STRESS_MECHANISM, LAST_MOTION },
  { "random-696", STRESS_MECHANISM, LAST_MOTION },
  { "random-698", STRESS_MECHANISM, LAST_MOTION },
  { "random-750", STRESS_MECHANISM, LAST_MOTION },
  { "random-754", STRESS_MECHANISM, LAST_MOTION },
  { "random-785", STRESS_MECHANISM, LAST_MOTION },
  { "random-793", STRESS_MECHANISM, LAST_MOTION },
  { "random-834", STRESS_MECHANISM, LAST_MOTION },
  { "random-893", STRESS_MECHANISM, LAST_MOTION },
  { "random-989", STRESS_MECHANISM, LAST_MOTION },
  { "random-581", STRESS_LIMIT, STALLS },
  { "random-920", STRESS_LIMIT, STALLS },
  { "residual=1e-10-wall6", STRESS_NO_ANSWER,
    "Forces cannot be summed up that exactly." },
  { "idle-*", STRESS_BUDGET,
    "Free to move, under a live load that does not make it: increments stay small all "
    "the way to the largest multiplier there is." },
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
