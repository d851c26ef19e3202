/* Load cases combined by a code: which factors on loads and strengths belong together.
 *
 * Codes are data (data/codes/combinations.json): each has situations with factors of permanent actions,
 * favourable and unfavourable, of a leading and of accompanying variable actions. A situation has every
 * choice of them: each permanent case with either factor, each variable case absent, accompanying, or
 * one of them leading, cases of wind, snow or temperature one at a time, one seismic case in seismic
 * situations alone. Choices with the same factors, in whichever situations, are one combination.
 * docs/method/combinations.md has an example by hand. */
#pragma once

#include "io/project/project.h"

/* Most of one project. */
#define QN_MAX_COMBINATIONS 1000

typedef struct QnCombination {
  char *name;                /* "STR 6.10: 1.35 self + 1.5 wind"; owned */
  char *label;               /* the same with the decimal sign of the language; owned */
  double *factors;           /* of every load case, times its own; owned */
  double friction, strength; /* what laws are divided by */
} QnCombination;

/* Names of the codes, and of the actions that they combine; NULL-terminated, owned by the caller. */
char **qn_combinations_dup_codes (void);
char **qn_combinations_dup_actions (void);

/* Those of the project's code, as an array of QnCombination; NULL with QN_IO_ERROR_INVALID where it has
 * none, no case has an action, or there are too many. Free with g_ptr_array_unref(). */
GPtrArray *qn_combinations_make (const QnProject *project, GError **error);

/* Adds overrides "path=value" that make the project one combination: factors of its cases, friction,
 * dilatancy and strengths of the joints. Where no live load acts in it, its analysis is that of the
 * dead load. */
void qn_combination_add_overrides (const QnCombination *combination, const QnModel *model,
                                   GPtrArray *overrides);
