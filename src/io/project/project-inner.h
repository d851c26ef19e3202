/* Private to reading and writing project files: members inside entities (laws, blocks, loads,
 * stages, …), contact, loads and analysis that no layer uses. They belong to their owner; the
 * note of an entity is the number of its members, so that they follow the entity.
 */
#pragma once

#include "io/json/json-value.h"
#include "io/project/project.h"

/* Where the project's extras keep them; no member of a document may be called that. */
#define QN_INNER_MEMBER "\x01inner"

/* The note of an entity that has just been read; 0: it has no unknown members. */
int32_t qn_read_note (const QnJsonValue *place);

/* Takes over the unknown members of the reader, of entities that were given a note and of objects that there
 * is one of. */
void qn_project_keep_inner (QnProject *project, QnReader *reader);

/* Of a project, by owner; NULL where there are none. Free with g_hash_table_unref(). */
GHashTable *qn_project_index_inner (const QnProject *project);

/* Adds the unknown members of an owner ("contact", "analysis", …), or of the entity with this note,
 * to its object, the end of which was just written. `inner` may be NULL. */
void qn_json_append_inner (GString *json, GHashTable *inner, const char *owner);
void qn_json_append_note (GString *json, GHashTable *inner, int32_t note);
