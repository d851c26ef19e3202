#include "stress/shortfalls.h"

#define MILLIONTH                                                                        \
  "No live load holds it, so that only a certificate shows that it falls, to 1e-8 of a " \
  "millionth: digits that forces and rates do not have."
#define STIFFNESSES                                                                      \
  "Springs whose stiffness differs by ten thousand and more: on the last part of the "   \
  "way to collapse the digits of stiff joints' forces are lost."
#define STALLS                                                                           \
  "The program stalls at 1e-8 of the loads, and the bounds stay apart by more than "     \
  "1e-6."
#define ROUNDING                                                                         \
  "Rounding ends the approach before what is left to gain is within the tolerance."
#define WEDGES                                                                           \
  "Joints wedge and let go by turns: the path is given up while it still climbs."
#define BONDS                                                                            \
  "Bonds break one after the other: the path leads to collapse in more iterations than " \
  "these cases have."

static const StressShortfall shortfalls[] = {
  { "cohesion=10-wall5", STRESS_NO_ANSWER | STRESS_BUDGET, BONDS },
  { "contrast=10000-wall5", STRESS_NO_ANSWER, STIFFNESSES },
  { "contrast=1e+06-wall6", STRESS_NO_ANSWER | STRESS_UNCERTAIN, STIFFNESSES },
  { "contrast=1e+0?-*", STRESS_NO_ANSWER, STIFFNESSES },
  { "ks/kn=10000-*", STRESS_NO_ANSWER, STIFFNESSES },
  { "aspect=1e-?", STRESS_NO_ANSWER, WEDGES },
  { "friction=3-wall6", STRESS_NO_ANSWER, WEDGES },
  { "friction=4-wall2", STRESS_NO_ANSWER | STRESS_BUDGET, WEDGES },
  { "friction=4-wall6", STRESS_NO_ANSWER, WEDGES },
  { "friction=5-wall2", STRESS_NO_ANSWER, WEDGES },
  { "friction=5-wall6", STRESS_NO_ANSWER, WEDGES },
  { "hanging-1e-06", STRESS_NO_ANSWER, MILLIONTH },
  { "hanging-1e-09", STRESS_MECHANISM,
    "A thousand-millionth beside the verge the force that drives the motion is no more "
    "than what equilibrium may lack." },
  { "random-246", STRESS_NO_ANSWER, ROUNDING },
  { "random-403", STRESS_NO_ANSWER, ROUNDING },
  { "random-581", STRESS_LIMIT, STALLS },
  { "residual=1e-12-*", STRESS_NO_ANSWER, "Forces cannot be summed up to 1e-12." },
};

const StressShortfall *
stress_shortfall (const char *name)
{
  for (size_t i = 0; i < G_N_ELEMENTS (shortfalls); i++)
    if (g_pattern_match_simple (shortfalls[i].pattern, name))
      return &shortfalls[i];
  return NULL;
}
