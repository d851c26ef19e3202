/* From a model and its result to a scene. */
#pragma once

#include "render/drawing/scene.h"
#include "render/scene/motion.h"
#include "render/scene/view-options.h"

/* Everything that a view shows of a model. `contacts` and `result` may be NULL where the view
 * does without; `result` must belong to the model. Returns NULL with a one-line error when
 * the view needs what is not there (a mechanism, a step). */
QnScene *qn_scene_build (const QnModel *model, const QnContacts *contacts,
                         const QnResult *result, const QnViewOptions *options,
                         GError **error);

/* How the blocks are displaced in a scene that was built of these, its factor included. */
QnMotion qn_scene_motion (const QnScene *scene, const QnModel *model,
                          const QnResult *result, const QnViewOptions *options);
