/* Redundant members of a result file: words, names, counts, the facts of the mechanism, ends of the
 * interval.
 *
 * A result that was read is written again, and both texts are compared member by member. A member that
 * the program would write differently contradicts the rest of the file.
 */
#pragma once

#include "io/result/result-file.h"

/* Compares the text that `file` was read from with what the program writes for the same numbers;
 * `name` is the name of the file in messages. False with an error that names the place
 * (QN_IO_ERROR) where they differ. Adds to `unproved` (of char *, which it owns) the members that
 * nothing in the file or the project proves, each once: "generator", "steps[].iterations". A member
 * that is left out states nothing. */
gboolean qn_result_text_agrees (const char *text, gsize length, const char *name,
                                const QnResultFile *file, const QnProject *project,
                                const QnContacts *contacts, GPtrArray *unproved,
                                GError **error);
