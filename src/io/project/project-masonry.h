/* Parametric masonry in project files: the top-level member `masonry`, a list of objects.
 *
 * The model holds only the blocks that such objects expand to; QnBlock.masonry says which object a
 * block came from. The text of the objects stays in QnProject.extras, and is written again while
 * blocks of the object remain. Keys, defaults and names of blocks are described in
 * data/project-format.md; the rules behind them in stereotomy/masonry.h.
 */
#pragma once

#include "io/json/json-value.h"
#include "io/project/project.h"
#include "stereotomy/masonry.h"

#define QN_MASONRY_MEMBER "masonry"

/* Reads the list from `root`, the document, and adds the blocks of every object to the model
 * behind those that it has. FALSE with the reader's error set. */
gboolean qn_read_masonry (const QnJsonValue *root, QnProject *project);

/* Appends one object as JSON, defaults left out. */
void qn_masonry_append_json (GString *json, const QnMasonry *masonry,
                             const QnModel *model);

/* The objects of a project that were read from or will be written to its file, as structs;
 * clear with qn_masonries_clear(). FALSE with an error where the list is not valid. */
gboolean qn_project_get_masonry (const QnProject *project, QnMasonries *list,
                                 GError **error);

/* Makes the blocks of all objects plain blocks: their parameters are no longer written. */
void qn_project_detach_masonry (QnProject *project);

/* Leaves out the objects that no block comes from any more; the others get new numbers. */
void qn_project_drop_detached (QnProject *project);

/* Whether blocks of object `index` remain, so that the file must have it. */
gboolean qn_project_has_masonry (const QnProject *project, QnId index);
