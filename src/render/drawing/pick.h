/* Picking: finds the object under the pointer in the drawn scene. */
#pragma once

#include "render/drawing/scene.h"

typedef struct QnPick {
  QnPickKind kind; /* QN_PICK_NOTHING: nothing there */
  QnId id;
} QnPick;

/* The topmost visible command within `reach` px of the screen point. `kinds` is a set of
 * bits 1 << QnPickKind, or 0 for every kind. */
QnPick qn_pick_at (const QnScene *scene, const QnCamera *camera, QnVec2 screen,
                   double reach, unsigned kinds);

/* Appends to `ids` (of QnId) every entity of one kind whose commands lie wholly inside the
 * rectangle between two screen points; each once. */
void qn_pick_inside (const QnScene *scene, const QnCamera *camera, QnVec2 corner_a,
                     QnVec2 corner_b, QnPickKind kind, GArray *ids);
