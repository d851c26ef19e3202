/* How core functions report trouble that the caller can act on.
 *
 * Four kinds of trouble have four channels:
 *   programmer error     QN_ASSERT
 *   bad input, no memory QnStatus, with the place and the reason in an optional QnDiag
 *   numerical outcome    QnOutcome inside QnResult, never an error (see result.h)
 *   warnings             QnFindings (see finding.h)
 */
#pragma once

#include "core/base/base.h"
#include "core/base/problem.h"
#include "core/base/vec2.h"

typedef enum {
  QN_OK,
  QN_ERROR_NO_MEMORY, /* an allocation failed; every output is cleared */
  QN_ERROR_INVALID,   /* the input breaks a rule: see QnDiag */
  QN_ERROR_CANCELLED, /* the progress callback asked to stop before there was any result */
  QN_ERROR_INTERNAL   /* a library refused what it should accept */
} QnStatus;

/* Kind of entity of a diagnostic or finding. */
typedef enum {
  QN_ENTITY_MODEL,
  QN_ENTITY_LAW,
  QN_ENTITY_BLOCK,
  QN_ENTITY_WALL,
  QN_ENTITY_CONTACT,
  QN_ENTITY_FACE_OVERRIDE,
  QN_ENTITY_BAR,
  QN_ENTITY_TIE,
  QN_ENTITY_VEHICLE,
  QN_ENTITY_NODE,
  QN_ENTITY_SECTION,
  QN_ENTITY_BEAM,
  QN_ENTITY_DEAD_LOAD,
  QN_ENTITY_LIVE_LOAD,
  QN_ENTITY_LOAD_CASE,
  QN_ENTITY_ANALYSIS,
  QN_ENTITY_STAGE,
  QN_ENTITY_GROUND_MOTION, /* of analysis.dynamic; sub: a point */
  QN_ENTITY_INITIAL_MOTION,
  QN_ENTITY_TRACK,
  QN_ENTITY_MASONRY /* parametric masonry, see stereotomy/masonry.h */
} QnEntity;

/* Where and why an input was refused. The sentence for `problem` comes from
 * qn_problem_text(); names and file positions are added by the layers that know them. */
typedef struct QnDiag {
  QnStatus status;
  QnProblem problem;
  QnEntity entity;
  QnId index; /* index of the entity in its array, or QN_NONE */
  QnId sub;   /* vertex, course, edge … of that entity, or QN_NONE */
  QnId other; /* a second entity of the same kind (the other of two blocks), or QN_NONE */
  const char
    *field;     /* member concerned, spelt as in project files ("thickness"); a static
                        string, NULL where the entity as a whole is meant */
  QnVec2 at;    /* place in the model, m; meaningful where the problem has one */
  double value; /* the offending number, in its own unit; 0 where there is none */
} QnDiag;

/* Whether a problem is one of the state that an analysis has reached, not of the input: the analysis has no
 * answer, and the problem no place in a file. */
bool qn_problem_is_of_state (QnProblem problem);

/* Fills *diag (nullable) with a problem of the model as a whole, and returns `status`. */
QnStatus qn_diag_set (QnDiag *diag, QnStatus status, QnProblem problem);

/* The same of an entity, and of one number of it: `field` is kept by reference. QN_ERROR_INVALID. */
QnStatus qn_refuse (QnDiag *diag, QnProblem problem, QnEntity entity, QnId index);
QnStatus qn_diag_set_field (QnDiag *diag, QnProblem problem, QnEntity entity, QnId index,
                            const char *field, double value);

/* Shorthand for an allocation that failed. */
QnStatus qn_diag_no_memory (QnDiag *diag);
