/* Shared by the builders of a scene; private to the scene-*.c files. */
#pragma once

#include "core/assembly/assembly.h"
#include "render/scene/motion.h"
#include "render/scene/reading.h"
#include "render/scene/scene-build.h"

/* Line widths and sizes of figures, pt. */
#define QN_WIDTH_OUTLINE 0.55F
#define QN_WIDTH_GHOST   0.4F
#define QN_WIDTH_FACE    1.8F
#define QN_WIDTH_ARROW   0.9F
#define QN_SIZE_LABEL    7.0

typedef struct QnSceneBuilder {
  QnScene *scene;
  const QnModel *model;
  const QnContacts *contacts; /* or NULL */
  const QnResult *result;     /* or NULL */
  const QnViewOptions *options;
  size_t step;       /* meaningful with a result */
  QnMotion motion;   /* of the blocks as drawn; scale includes the animation's phase */
  QnBox box;         /* of the undeformed blocks and nodes */
  double block_size; /* m, characteristic length of the blocks */
  QnPairResult
    *pairs; /* at the step, where contact forces are known and wanted; or NULL */
  QnJointMotion
    *joints;        /* of all faces in DEFORMED and MECHANISM with contacts, or NULL */
  QnTouch *touches; /* contacts found on the way that carry something at the step */
  size_t touch_count;
  QnVec2
    weight_arrow; /* drawn in the middle of blocks: the largest load in weights, or 0 */
  bool *left;     /* which faces their blocks have left by the step; NULL: none */
} QnSceneBuilder;

static inline QnColor
qn_builder_ink (const QnSceneBuilder *builder, QnInk ink)
{
  return qn_ink (ink, builder->options->monochrome);
}

/* Whether the view is of a result that has a step. */
static inline bool
qn_builder_shows_step (const QnSceneBuilder *builder)
{
  return builder->result != NULL && builder->result->step_count > 0
         && qn_view_needs_result (builder->options->view);
}

/* The point of a block as drawn. */
static inline QnVec2
qn_builder_place (const QnSceneBuilder *builder, QnId block, QnVec2 p)
{
  return qn_motion_place (&builder->motion, block, p, builder->motion.scale);
}

/* A point of a joint as drawn, half-way between its two sides. */
static inline QnVec2
qn_builder_place_joint (const QnSceneBuilder *builder, const QnContactFace *face,
                        QnVec2 p)
{
  return qn_vec2_lerp (qn_builder_place (builder, face->a, p),
                       qn_builder_place (builder, face->b, p), 0.5);
}

/* scene-blocks.c; and the vertices of a block as displaced by `motion`, in an array that is used
 * again. */
const QnVec2 *qn_builder_place_vertices (const QnSceneBuilder *builder,
                                         const QnMotion *motion, QnId block, GArray *out);
void qn_build_underlay (QnSceneBuilder *builder);
void qn_build_ghost (QnSceneBuilder *builder);

/* The axes of beams that are not bent; false where there are none. Part of the above. */
bool qn_build_beam_ghosts (QnSceneBuilder *builder);
/* `fills`, nullable, has one colour per block. */
void qn_build_blocks (QnSceneBuilder *builder, const QnColor *fills);
void qn_build_onion (QnSceneBuilder *builder);
void qn_build_names (QnSceneBuilder *builder);
void qn_build_numbers (QnSceneBuilder *builder);

/* scene-supports.c */
void qn_build_supports (QnSceneBuilder *builder);

/* scene-loads.c */
void qn_build_loads (QnSceneBuilder *builder);
void qn_build_dimensions (QnSceneBuilder *builder);

/* scene-contacts.c */
void qn_build_contacts (QnSceneBuilder *builder);
void qn_build_findings (QnSceneBuilder *builder);

/* scene-joints.c */
void qn_build_joints (QnSceneBuilder *builder);

/* scene-forces.c; and contacts that blocks found on their way, where they carry something at the step. */
void qn_build_forces (QnSceneBuilder *builder);
void qn_build_found (QnSceneBuilder *builder);

/* scene-beams.c */
void qn_build_beams (QnSceneBuilder *builder);

/* scene-bars.c */
void qn_build_bars (QnSceneBuilder *builder);

/* scene-ties.c; and fills of soil */
void qn_build_soil (QnSceneBuilder *builder);
void qn_build_ties (QnSceneBuilder *builder);

/* scene-diagrams.c */
void qn_build_diagrams (QnSceneBuilder *builder);

/* scene-field.c: one colour per block, newly allocated, or NULL where the field is not one of
 * blocks; fields of joints are added as lines. */
QnColor *qn_build_field (QnSceneBuilder *builder);

/* ---- beams (scene-beams.c) ---- */

typedef struct QnBeamDrawing {
  const QnSceneBuilder *builder;
  const QnBeamForces
    *forces;     /* of the step, by element; NULL: not known, or not wanted */
  QnVec2 *loads; /* on elements at the step, N/m; with forces */
  bool bent;     /* drawn with the deflection by these forces; a mechanism is not */
} QnBeamDrawing;

void qn_beam_drawing_init (QnBeamDrawing *drawing, const QnSceneBuilder *builder);
void qn_beam_drawing_clear (QnBeamDrawing *drawing);

/* The point at x = s L of an element as drawn, bent by its forces; and the direction of y. */
QnVec2 qn_beam_drawing_place (const QnBeamDrawing *drawing, QnId element, double s,
                              QnVec2 *across);

/* A node as drawn. */
QnVec2 qn_builder_place_node (const QnSceneBuilder *builder, QnId node);
