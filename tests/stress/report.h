/* What has come out of the cases: as lines of a test protocol, and as a table in Markdown. */
#pragma once

#include "stress/stress.h"

/* A case with its row. */
typedef struct StressEntry {
  const StressCase *c;
  StressRow row;
} StressEntry;

/* One case as a line of the Test Anything Protocol, with its figures as comments. Faults that are
 * expected (shortfalls.h) are reported as such. Returns whether it is a failure. */
bool stress_report_tap (const StressEntry *entry, guint number);

/* Subjects, tables, and every fault. entries: of StressEntry. */
void stress_report_markdown (GString *text, const GArray *entries, const char *command);
