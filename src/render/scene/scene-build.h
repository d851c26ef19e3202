/* From a model and its result to a scene. */
#pragma once

#include "render/drawing/scene.h"
#include "render/scene/motion.h"
#include "render/scene/view-options.h"

/* The scene of a view. `contacts` and `result` may be NULL if the view does not need them; `result` must
 * belong to the model. NULL with a one-line error if the view needs something that is missing (a
 * mechanism, a step). */
QnScene *qn_scene_build (const QnModel *model, const QnContacts *contacts,
                         const QnResult *result, const QnViewOptions *options,
                         GError **error);

/* How the blocks are displaced in a scene that was built of these, its factor included. */
QnMotion qn_scene_motion (const QnScene *scene, const QnModel *model,
                          const QnResult *result, const QnViewOptions *options);
