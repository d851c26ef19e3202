/* Private to the reading of project files: one function per part of the document. Each adds
 * what it finds to the model and returns FALSE with the reader's error set. */
#ifndef QN_IO_PROJECT_READ_PARTS_H
#define QN_IO_PROJECT_READ_PARTS_H

#include "core/model/model.h"
#include "io/json/json-value.h"

/* In project-read-law.c; `root` is the document. */
gboolean qn_read_laws (const QnJsonValue *root, QnNeed need, QnModel *model);
gboolean qn_read_bars (const QnJsonValue *root, QnModel *model);

/* In project-read-structure.c. */
gboolean qn_read_blocks (const QnJsonValue *root, QnNeed need, QnModel *model);
gboolean qn_read_walls (const QnJsonValue *root, QnModel *model);

/* `support` of a block or node; left as it is where there is none. */
gboolean qn_read_support (const QnJsonValue *place, bool support[QN_DOF_COUNT]);

/* In project-read-beams.c: sections, nodes and beams; the walls must be expanded. */
gboolean qn_read_beams (const QnJsonValue *root, QnModel *model);

/* In project-read-loading.c; the walls must be expanded, so that their blocks have names. */
gboolean qn_read_contact (const QnJsonValue *root, QnModel *model);
gboolean qn_read_loads (const QnJsonValue *root, QnModel *model);

/* In project-read-analysis.c; after the loads. */
gboolean qn_read_analysis (const QnJsonValue *root, QnModel *model);

/* In project-read-dynamic.c: the member of `analysis`. */
/* The member `contacts`: fixed or follow. */
gboolean qn_member_follows (const QnJsonValue *object, bool *follows);

gboolean qn_read_dynamic (const QnJsonValue *analysis, QnModel *model);

/* Parts that walls and parametric masonry have in common. Weight of the material as N/m3 or, times
 * gravity, as kg/m3: exactly one of them. */
gboolean qn_read_weight (const QnJsonValue *place, const QnModel *model,
                         double *unit_weight, double *density);

/* `law` or, the same thing under the name that suits its basis, `material`. */
gboolean qn_read_own_law (const QnJsonValue *place, const QnModel *model, QnId *law);

/* `courses`: lists of lengths. */
gboolean qn_read_courses (const QnJsonValue *place, QnWall *wall);

/* Calls `read` for every element of a member that is an array. */
gboolean qn_read_each (const QnJsonValue *root, const char *key, QnNeed need,
                       gboolean (*read) (const QnJsonValue *place, QnModel *model),
                       QnModel *model);

/* Finds the entity that a value, a string, names. */
typedef enum {
  QN_NAMED_LAW,
  QN_NAMED_BLOCK,
  QN_NAMED_NODE,
  QN_NAMED_SECTION,
  QN_NAMED_BEAM
} QnNamed;
gboolean qn_read_name_of (const QnJsonValue *place, const QnModel *model, QnNamed named,
                          QnId *id);

/* The same for a member; an optional one that is not there leaves *id as it is. */
gboolean qn_read_name (const QnJsonValue *object, const char *key, QnNeed need,
                       const QnModel *model, QnNamed named, QnId *id);

/* The name of an object that may have none: then `prefix` with its number from 1, written into
 * `text`. */
#define QN_NAME_TEXT_SIZE 24
gboolean qn_read_own_name (const QnJsonValue *place, const char *prefix,
                           char text[QN_NAME_TEXT_SIZE], const char **name);

#endif
