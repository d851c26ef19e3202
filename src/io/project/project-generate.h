/* Parametric masonry as a project: what `quoin-cli generate` writes. */
#pragma once

#include "io/project/project.h"

/* Makes the project of a new drawing (qn_project_begin()) with one object of this kind: "wall", "arch",
 * "column", "buttress", "portal", "rubble", "grid" or "voronoi". `keys` (NULL-terminated) are
 * "key=value": members of the object in the project file, - for _, a list of numbers as 0.4x0.2. Other
 * members have defaults. Or plain blocks: "facade-strip", keys of docs/method/capacity.md. friction: of the dry
 * joints. An unknown kind or key is QN_IO_ERROR_OVERRIDE; `project` is overwritten without being cleared
 * and holds nothing then. */
gboolean qn_project_generate (const char *kind, const char *const *keys, double friction,
                              QnProject *project, GError **error);
