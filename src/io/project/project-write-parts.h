/* Private to the writing of project files: one function per part of the document. */
#ifndef QN_IO_PROJECT_WRITE_PARTS_H
#define QN_IO_PROJECT_WRITE_PARTS_H

#include "core/model/model.h"

#include <glib.h>

/* [x, y] as a member. */
void qn_json_put_vec2 (GString *json, const char *key, QnVec2 vector);

/* [[x, y], …] as a member. */
void qn_json_put_points (GString *json, const char *key, const QnVec2 *points,
                         gsize count);

/* A number, left out where it is the usual one. */
void qn_json_put_unusual (GString *json, const char *key, double number, double usual);

/* true or false as a member. */
void qn_json_put_bool (GString *json, const char *key, bool value);

/* [a, b, …], as a value or as a member. */
void qn_json_append_numbers (GString *json, const double *numbers, gsize count);
void qn_json_put_numbers (GString *json, const char *key, const double *numbers,
                          gsize count);

/* Weight of the material the way it was given, and the name of a law, left out for QN_NONE. */
void qn_json_put_weight (GString *json, double unit_weight, double density);
void qn_json_put_law (GString *json, const QnModel *model, QnId law);

/* `support`, left out where nothing is fixed. */
void qn_json_put_support (GString *json, const bool support[QN_DOF_COUNT]);

/* Appends the members of one entity, and returns its note. */
typedef int32_t (*QnMembersFunc) (GString *json, const QnModel *model, size_t index);

/* A list of entities, one in a line, with the members that no layer knows: `head`, which ends in "[",
 * the objects behind so many spaces, and `tail`, which begins with "]". Nothing for an empty one. */
void qn_json_append_list (GString *json, const QnModel *model, GHashTable *inner,
                          const char *head, int indent, size_t count,
                          QnMembersFunc append_members, const char *tail);

/* Parts of the document; inner: members that no layer knows (project-inner.h), or NULL.
 *
 * In project-write-beams.c. */
void qn_project_append_beams (GString *json, const QnModel *model, GHashTable *inner);

/* In project-write-loading.c. */
void qn_project_append_loads (GString *json, const QnModel *model, GHashTable *inner);
void qn_project_append_analysis (GString *json, const QnModel *model, GHashTable *inner);

/* In project-write-dynamic.c: analysis.dynamic where it is set; `usual` are its defaults. */
void qn_project_append_dynamic (GString *json, const QnModel *model,
                                const QnDynamicSettings *usual, GHashTable *inner);

#endif
