/* The inside of a history, shared by the files that make it up. */
#pragma once

#include "doc/document/history.h"

/* One run of bytes that differs. Offsets count in the text after the step. */
typedef struct QnHunk {
  gsize offset;
  char *removed;  /* owned */
  char *inserted; /* owned */
} QnHunk;

typedef struct QnEditStep {
  char *name;
  char *key;
  GArray *hunks; /* of QnHunk, by offset */
} QnEditStep;

struct QnEditHistory {
  GPtrArray *steps; /* of QnEditStep */
  guint position;
  gint64 clean; /* position of the clean state; -1: it cannot be reached any more */
  gboolean broken;
};

/* Appends a step without hunks behind all others; does not move the position. */
QnEditStep *qn_history_add_step (QnEditHistory *history, const char *name);
