/* The false claims of a result as translated text. */
#pragma once

#include "core/check/result-check.h"

/* A sentence with the claim, its place and both numbers; without `contacts` a pair is told by its number alone.
 * Free with g_free(). */
char *qn_fault_dup_text (const QnModel *model, const QnContacts *contacts,
                         const QnFault *fault);

/* "forces", "balance", … as programs read it. */
const char *qn_claim_name (QnClaim claim);

/* The claim of this name, or QN_CLAIM_COUNT. */
QnClaim qn_claim_from_name (const char *name);
