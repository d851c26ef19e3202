/* Result files (*.json): the path of an analysis, its last equilibrium and its mechanism.
 *
 * The format is described key by key in data/result-format.md.
 */
#pragma once

#include "core/check/result-check.h"
#include "core/result/result.h"
#include "io/project/project.h"

/* Which contact pair it is. */
typedef struct QnResultContact {
  QnId face;      /* number of the detected face */
  QnId blocks[2]; /* into block_names */
  QnId bar;       /* reinforcing bar that the pair belongs to, or QN_NONE */
} QnResultContact;

/* A result file in memory: enough to draw it and to check it without solving again. */
typedef struct QnResultFile {
  char *generator;    /* "quoin 0.1.0" */
  char *model;        /* name of the project file, without folders */
  char *model_sha256; /* of the project file's bytes */
  char **overrides;   /* those the project was read with; NULL where there were none */
  char **block_names; /* NULL-terminated, result.block_count names */
  char **node_names;  /* NULL-terminated, result.node_count names; NULL without beams */
  QnResultContact *contacts; /* result.pair_count of them, same order as result.pairs */
  QnResult result;
} QnResultFile;

/* Contents of a result file about contact pairs. */
typedef enum {
  QN_DETAIL_FORCES, /* its force */
  QN_DETAIL_PAIRS,  /* the hinge and its two springs as well */
  QN_DETAIL_STEPS,  /* forces of every step, whatever the size */
  QN_DETAIL_COUNT
} QnResultDetail;

/* Writes a result, whole or not at all; `contacts` are the ones the analysis ran with.
 * Errors: QN_IO_ERROR. */
gboolean qn_result_file_write (const char *path, const QnProject *project,
                               const QnContacts *contacts, const QnResult *result,
                               QnResultDetail detail, GError **error);
/* The text of such a file; free with g_free(). */
char *qn_result_dup_text (const QnProject *project, const QnContacts *contacts,
                          const QnResult *result, QnResultDetail detail, gsize *length);
/* Reads a result file. `file` is overwritten without being cleared and holds nothing on
 * failure. Unknown keys are ignored: later versions of the program add some. Errors: QN_IO_ERROR. */
gboolean qn_result_file_read (const char *path, QnResultFile *file, GError **error);

/* The same from memory; `name` stands for the file in messages. */
gboolean qn_result_file_parse (const char *text, gsize length, const char *name,
                               QnResultFile *file, GError **error);

void qn_result_file_clear (QnResultFile *file);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnResultFile, qn_result_file_clear)

/* Refuses a result whose blocks are not those of the project, or whose contact pairs are not
 * those of `contacts` (nullable). Sets *same_bytes (nullable) to whether the project file is
 * unchanged since the analysis: a difference there is no error. `name` is the result file's. */
gboolean qn_result_file_match (const QnResultFile *file, const char *name,
                               const QnProject *project, const QnContacts *contacts,
                               gboolean *same_bytes, GError **error);

/* Refuses a file that was computed from another project; else finds its faults. The project must be loaded with
 * the overrides of the file; `name` is that of the result file. */
gboolean qn_result_file_find_faults (const QnResultFile *file, const char *name,
                                     const QnProject *project, const QnContacts *contacts,
                                     QnResultFaults *faults, GError **error);

/* ---- what follows from the rest: words, names, counts, the facts of the mechanism, ends of the interval ----
 *
 * A result that was read is written again, and both texts are compared member by member. A member that
 * the program would write differently contradicts the rest of the file. */

/* Compares the text that `file` was read from with what the program writes for the same numbers;
 * `name` is the name of the file in messages. False with an error that names the place
 * (QN_IO_ERROR) where they differ. Adds to `unproved` (of char *, which it owns) the members that
 * nothing in the file or the project proves, each once: "generator", "steps[].iterations". A member
 * that is left out states nothing. */
gboolean qn_result_text_agrees (const char *text, gsize length, const char *name,
                                const QnResultFile *file, const QnProject *project,
                                const QnContacts *contacts, GPtrArray *unproved,
                                GError **error);
