/* The vocabulary of the stress tests: a case, what is asked of it, and what came out.
 *
 * A case is one model. It is solved by limit analysis and twice along its load path: with
 * dilatancy = friction, where limit analysis knows the answer, and with none, where it bounds
 * it. What is asked of every case, whatever its numbers, stands in StressFault.
 */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"

#include <glib.h>

typedef enum {
  STRESS_ASSOCIATIVE, /* dilatancy = friction */
  STRESS_SLIDING,     /* dilatancy 0 */
  STRESS_FLOW_COUNT
} StressFlow;

/* What a case is built to find out. */
typedef enum {
  STRESS_EXPECT_ANSWER, /* limit analysis says what is right */
  STRESS_EXPECT_VERGE, /* exactly between standing and falling: either is right, at multiplier 0 */
  STRESS_EXPECT_REFUSED, /* the model is none, and the core says why */
} StressExpectation;

typedef struct StressCase StressCase;

struct StressCase {
  const char *subject; /* heading in the table */
  char name[64];       /* unique, no spaces; what --only takes */
  void (*build) (const StressCase *c,
                 QnModel *model); /* dilatancies are set afterwards */
  int number;                     /* of the wall, or how many of something */
  double value;                   /* of what is varied */
  StressExpectation expectation;
  QnProblem problem;               /* REFUSED: why */
  double exact[STRESS_FLOW_COUNT]; /* multiplier from statics, by flow; NAN: not known */
  bool symmetric; /* loaded the other way the structure must carry as much */
  int
    repeat; /* increments with which the path without dilatancy is followed once more, for the
                 table; 0: not */
  bool brief; /* belongs to the quick set */
};

/* What may be wrong. The text of each is what the table says. */
#define STRESS_FAULTS(X)                                                                 \
  X (CRASH, "crashed")                                                                   \
  X (HANG, "did not end")                                                                \
  X (BUDGET, "iteration budget not kept")                                                \
  X (NO_ANSWER, "no answer")                                                             \
  X (REFUSED, "refused")                                                                 \
  X (NOT_REFUSED, "not refused for the right reason")                                    \
  X (LIMIT, "limit analysis has no proved answer")                                       \
  X (OUTCOME, "outcome contradicts limit analysis")                                      \
  X (DIFFERS, "differs from limit analysis by more than 0.1 %")                          \
  X (ABOVE, "above limit analysis")                                                      \
  X (STATICS, "differs from statics by more than 0.1 %")                                 \
  X (BALANCE, "equilibrium not kept")                                                    \
  X (STRENGTH, "strength exceeded")                                                      \
  X (PATH, "steps contradict the outcome")                                               \
  X (MECHANISM, "mechanism closes joints, or works against the loads")                   \
  X (UNCERTAIN, "how it moves on is not settled, though nothing can jump")               \
  X (MIRROR, "loaded the other way it carries another load")                             \
  X (FILE, "written and read back it is another model")

typedef enum {
#define STRESS_FAULT_BIT(name, text) STRESS_FAULT_BIT_##name,
  STRESS_FAULTS (STRESS_FAULT_BIT)
#undef STRESS_FAULT_BIT
    STRESS_FAULT_COUNT
} StressFaultBit;

typedef enum {
#define STRESS_FAULT_VALUE(name, text) STRESS_##name = 1 << STRESS_FAULT_BIT_##name,
  STRESS_FAULTS (STRESS_FAULT_VALUE)
#undef STRESS_FAULT_VALUE
} StressFault;

/* What independent sums say about a result, relative to the forces or velocities at hand. */
typedef struct StressCheck {
  double
    out_of_balance; /* worst of all steps: on free blocks, over the largest load on one, */
  double balanced;  /* and how much of it counts as none */
  double excess;    /* worst of all steps: of a pair's strength, over the largest force */
  bool moves;       /* there is a mechanism: */
  bool uncertain; /* by its own account the last motion only, of which nothing is asked */
  bool by_work;   /* or a motion in which elastic joints give, too */
  double penetration; /* how fast joints close on it, over the fastest block */
  double
    power; /* of the loads at collapse, over what it would be if every load went along
                   with its block: what friction takes, so not negative */
  double
    misfit; /* rates that the flow rule forbids where the forces at collapse are, over
                    the fastest block: small where forces and mechanism prove each other, not
                    where collapse sets in with a jump; NAN without an equilibrium */
} StressCheck;

/* One path, or limit analysis. */
typedef struct StressSolve {
  bool solved; /* there is a result, whatever it says */
  QnOutcome outcome;
  double multiplier; /* at collapse, or the last one reached */
  double first_limit;
  int32_t steps, iterations, factorizations;
  double seconds; /* processor time */
  StressCheck check;
  guint faults; /* StressFault */
} StressSolve;

/* What came out of a case. Plain data: it comes through a pipe from the process that ran it. */
typedef struct StressRow {
  char description[160];
  size_t blocks, pairs;
  QnProblem problem;   /* why the model was refused, or NONE */
  double lower, upper; /* limit analysis */
  StressSolve limit, paths[STRESS_FLOW_COUNT];
  double mirrored; /* multiplier loaded the other way, dilatancy 0; NAN: not asked for */
  double repeated; /* collapse with other increments, dilatancy 0; NAN: likewise */
  guint faults;    /* of the case as a whole */
} StressRow;

/* All faults of a case. */
static inline guint
stress_row_faults (const StressRow *row)
{
  return row->faults | row->limit.faults | row->paths[STRESS_ASSOCIATIVE].faults
         | row->paths[STRESS_SLIDING].faults;
}

/* The texts of the faults, joined by semicolons; free with g_free(). */
char *stress_dup_faults (guint faults);
