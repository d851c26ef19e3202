#include "core/contact/finding.h"

#include "core/base/memory.h"

#include <stdlib.h>

bool
qn_findings_add (QnFindings *findings, QnFinding finding)
{
  return QN_ARRAY_PUSH (findings->items, findings->count, findings->capacity, finding);
}

void
qn_findings_clear (QnFindings *findings)
{
  free (findings->items);
  *findings = (QnFindings){ 0 };
}
