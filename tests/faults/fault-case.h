/* Analyses into which faults are injected: examples of the project, each taking another way
 * through the solver. */
#pragma once

#include "core/modal/modal.h"
#include "io/project/project.h"

typedef enum { FAULT_SOLVE, FAULT_STABILITY, FAULT_MODAL, FAULT_MODAL_LOADED } FaultKind;

typedef struct FaultCase {
  const char *name;
  const char *example; /* file in examples/ */
  FaultKind kind;
  const char *overrides[4]; /* as of --set, NULL-terminated */
} FaultCase;

extern const FaultCase fault_cases[];
extern const size_t fault_case_count;

/* What an analysis came to; of all but vibrations `modes` is empty. */
typedef struct FaultAnswer {
  QnResult result;
  QnModes modes;
} FaultAnswer;

/* Project and contacts of a case; any error aborts. */
void fault_case_load (const FaultCase *self, QnProject *project, QnContacts *contacts);

/* Runs the case. `answer` is overwritten, and empty where the status is not QN_OK. */
QnStatus fault_case_run (const FaultCase *self, const QnProject *project,
                         const QnContacts *contacts, QnProgressFunc progress,
                         void *user_data, FaultAnswer *answer, QnDiag *diag);

void fault_answer_clear (FaultAnswer *answer);

/* A digest of every number of the answer but the times it took; free with g_free(). */
char *fault_answer_dup_digest (const FaultAnswer *answer);
