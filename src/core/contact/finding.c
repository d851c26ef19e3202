#include "core/contact/finding.h"

#include "core/base/memory.h"

#include <stdlib.h>

bool
qn_findings_add (QnFindings *findings, QnFinding finding)
{
  QnFinding *items = qn_array_grow (findings->items, &findings->capacity,
                                    findings->count + 1, sizeof *items);
  if (items == NULL)
    return false;

  findings->items = items;
  items[findings->count++] = finding;
  return true;
}

void
qn_findings_clear (QnFindings *findings)
{
  free (findings->items);
  *findings = (QnFindings){ 0 };
}
