/* Private to reading and writing project files: two functions per part of the document. One adds
 * what it finds below `root`, the document, to the model and returns FALSE with the reader's error
 * set; the other appends the part in the canonical layout, with the members that no layer knows
 * (project-inner.h; `inner` may be NULL).
 */
#pragma once

#include "core/model/model.h"
#include "io/json/json-value.h"

/* In project-law.c. */
gboolean qn_read_laws (const QnJsonValue *root, QnNeed need, QnModel *model);
void qn_project_append_laws (GString *json, const QnModel *model, GHashTable *inner);

/* In project-structure.c. */
gboolean qn_read_blocks (const QnJsonValue *root, QnNeed need, QnModel *model);
gboolean qn_read_walls (const QnJsonValue *root, QnModel *model);
int32_t qn_project_append_block (GString *json, const QnModel *model, size_t index);
void qn_project_append_walls (GString *json, const QnModel *model, GHashTable *inner);

/* In project-beams.c: sections, nodes and beams; the walls must be expanded. */
gboolean qn_read_beams (const QnJsonValue *root, QnModel *model);
void qn_project_append_beams (GString *json, const QnModel *model, GHashTable *inner);

/* In project-tie.c; likewise. */
gboolean qn_read_ties (const QnJsonValue *root, QnModel *model);
void qn_project_append_ties (GString *json, const QnModel *model, GHashTable *inner);

/* In project-vehicle.c: without those that are built in. */
gboolean qn_read_vehicles (const QnJsonValue *root, QnModel *model);
void qn_project_append_vehicles (GString *json, const QnModel *model, GHashTable *inner);

/* In project-contact.c; the walls must be expanded, so that their blocks have names. */
gboolean qn_read_contact (const QnJsonValue *root, QnModel *model);
void qn_project_append_contact (GString *json, const QnModel *model, GHashTable *inner);
gboolean qn_read_bars (const QnJsonValue *root, QnModel *model);
void qn_project_append_bars (GString *json, const QnModel *model, GHashTable *inner);

/* In project-loads.c; likewise. */
gboolean qn_read_loads (const QnJsonValue *root, QnModel *model);
void qn_project_append_loads (GString *json, const QnModel *model, GHashTable *inner);

/* In project-analysis.c; after the loads. */
gboolean qn_read_analysis (const QnJsonValue *root, QnModel *model);
void qn_project_append_analysis (GString *json, const QnModel *model, GHashTable *inner);

/* Place in the file's list of a stage, of which a cyclic protocol has one. */
gsize qn_project_stage_entry (const QnModel *model, gsize index);

/* In project-dynamic.c: the member of `analysis`, written where it is set; `usual` are its
 * defaults. */
gboolean qn_read_dynamic (const QnJsonValue *analysis, QnModel *model);
void qn_project_append_dynamic (GString *json, const QnModel *model,
                                const QnDynamicSettings *usual, GHashTable *inner);

/* ---- reading ---- */

/* `support` of a block or node; left as it is where there is none. */
gboolean qn_read_support (const QnJsonValue *place, bool support[QN_DOF_COUNT]);

/* Parts that walls and parametric masonry have in common. Weight of the material as N/m3 or, times
 * gravity, as kg/m3: exactly one of them. */
gboolean qn_read_weight (const QnJsonValue *place, const QnModel *model,
                         double *unit_weight, double *density);

/* `law`, or its synonym `material`. */
gboolean qn_read_own_law (const QnJsonValue *place, const QnModel *model, QnId *law);

/* `courses`: lists of lengths. */
gboolean qn_read_courses (const QnJsonValue *place, QnWall *wall);

/* Calls `read` for every element of a member that is an array. */
gboolean qn_read_each (const QnJsonValue *root, const char *key, QnNeed need,
                       gboolean (*read) (const QnJsonValue *place, QnModel *model),
                       QnModel *model);

/* The name of an object that may have none: then `prefix` with its number from 1, written into
 * `text`. */
#define QN_NAME_TEXT_SIZE 24
gboolean qn_read_own_name (const QnJsonValue *place, const char *prefix,
                           char text[QN_NAME_TEXT_SIZE], const char **name);

/* ---- writing ---- */

/* Weight of the material the way it was given, and the name of a law, left out for QN_NONE. */
void qn_json_put_weight (GString *json, double unit_weight, double density);
void qn_json_put_law (GString *json, const QnModel *model, QnId law);

/* `support`; left out if no degree of freedom is fixed. */
void qn_json_put_support (GString *json, const bool support[QN_DOF_COUNT]);

/* Appends the members of one entity, and returns its note. */
typedef int32_t (*QnMembersFunc) (GString *json, const QnModel *model, size_t index);

/* A list of entities, one in a line, with the members that no layer knows: `head`, which ends in "[",
 * the objects behind so many spaces, and `tail`, which begins with "]". Nothing for an empty one. */
void qn_json_append_list (GString *json, const QnModel *model, GHashTable *inner,
                          const char *head, int indent, size_t count,
                          QnMembersFunc append_members, const char *tail);
