/* Private to reading and writing project files: members inside laws, blocks, walls, contact,
 * loads and analysis that no layer knows. They are kept by what they stand in, and by its
 * name where it has one, so that they survive edits of everything else.
 */
#ifndef QN_IO_PROJECT_INNER_H
#define QN_IO_PROJECT_INNER_H

#include "io/json-value.h"
#include "io/project.h"

/* Where the project's extras keep them; no member of a document may be called that. */
#define QN_INNER_MEMBER "\x01inner"

/* Takes over what the reader found unknown: an object of objects by their paths, or NULL. FALSE
 * where memory runs out. */
gboolean qn_project_keep_inner (QnProject *project, cJSON *unknown);

/* Of a project, by owner; NULL where there are none. Free with g_hash_table_unref(). */
GHashTable *qn_project_index_inner (const QnProject *project);

/* Adds the unknown members of an owner to its object, the end of which was just written.
 * `inner` may be NULL, and `name` for what has none. */
void qn_json_append_inner (GString *json, GHashTable *inner, const char *owner,
                           const char *name);

/* Whether there are such members in any block. */
gboolean qn_project_has_inner_blocks (const QnProject *project);

#endif
