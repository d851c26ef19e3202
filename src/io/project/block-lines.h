/* The lines of a project's text that hold its blocks, one each in the canonical layout. They let a
 * text that is nearly the same be written and read in proportion to what differs. */
#ifndef QN_IO_BLOCK_LINES_H
#define QN_IO_BLOCK_LINES_H

#include "io/project/project.h"

typedef struct QnBlockLines {
  const QnProject *project; /* borrowed, as the text */
  gsize length;             /* of the text */
  gsize count;
  const char *
    *starts;    /* owned: of each line, behind its indentation; then of what follows */
  QnId *blocks; /* owned: the block of each line */
  QnId *lines;  /* owned: the line of each block, or QN_NONE */
} QnBlockLines;

/* Finds the lines of a project's canonical text. FALSE, with nothing to clear, where the text has
 * another layout: where a block keeps members that the model does not hold. */
gboolean qn_block_lines_find (QnBlockLines *lines, const QnProject *project,
                              const char *text);
void qn_block_lines_clear (QnBlockLines *lines);

/* The object of one line, without what parts it from the next. */
const char *qn_block_lines_get (const QnBlockLines *lines, gsize line, gsize *length);

/* Appends the line of an equal block of the same name. FALSE where there is none. */
gboolean qn_block_lines_append_same (GString *json, const QnBlockLines *lines,
                                     const QnModel *model, QnId block);

#endif
