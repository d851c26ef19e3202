/* Path of the number in a project's file that an edit changes.
 *
 * A form shows numbers of the model; a study varies numbers of the file. Only reading and writing relate
 * them: so the project is written before and after the edit, and the texts are compared. */
#pragma once

#include <glib.h>

/* Path ("laws[0].friction") of the only number that differs between two texts of a project, for which
 * `value` was entered; numbers that come with it, as a seed does with a perturbation, do not count.
 * *number is the one in `before`, NaN where it is not written there. NULL where nothing differs, or
 * anything else, or the number concerns the drawing alone. The caller frees it. */
char *qn_number_path_find (const char *before, const char *after, double value,
                           double *number);
