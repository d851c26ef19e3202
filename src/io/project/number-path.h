/* Which number of a project's file an edit changes.
 *
 * A form shows numbers of the model; a study varies numbers of the file. Where the one stands in the
 * other is known to the writer and the readers of projects alone: so it is found by writing the
 * project twice, before the edit and after it, and looking for what differs. */
#pragma once

#include <glib.h>

/* Path ("laws[0].friction") of the only number that differs between two texts of a project, for which
 * `value` was entered; numbers that come with it, as a seed does with a perturbation, do not count.
 * *number is the one in `before`, NaN where it is not written there. NULL where nothing differs, or
 * anything else, or the number concerns the drawing alone. The caller frees it. */
char *qn_number_path_find (const char *before, const char *after, double value,
                           double *number);
