/* Edits of analyses in time: initial settings and ground motions. */
#pragma once

#include "doc/edit/edit.h"

/* Makes the analysis one in time. What the model does not say gets something to start from: 10 s in
 * steps of 5 ms, large displacements, and a half-sine pulse where nothing moves the structure. */
gboolean qn_edit_choose_dynamic (QnModel *model, GError **error);

/* A further half-sine pulse along x: 2 m/s2 for half a second. */
gboolean qn_edit_add_pulse (QnModel *model, GError **error);

/* The model's initial motion of the block; default: at rest. */
QnInitialMotion qn_initial_motion_of (const QnModel *model, QnId block);

/* Sets it with other numbers, counted from the equilibrium under dead load: m, m, rad and m/s, m/s, rad/s. Makes
 * the analysis one in time. Refuses fixed blocks. */
gboolean qn_edit_set_initial (QnModel *model, const QnInitialMotion *motion,
                              GError **error);

/* Where a block starts, drawn from where it stands in the model. */
QnTransform qn_initial_transform (const QnModel *model, const QnInitialMotion *motion);

/* The record in a file, of any kind that record.h tells, as points of the project: the project needs
 * the file no more. Along x. */
gboolean qn_edit_add_record (QnModel *model, const char *path, GError **error);

gboolean qn_edit_remove_ground_motion (QnModel *model, gsize index, GError **error);

/* One line about a ground motion, for lists. Free with g_free(). */
char *qn_ground_motion_dup_text (const QnGroundMotion *motion);

/* "half-sine" …, translated. */
const char *qn_pulse_kind_text (QnPulseKind kind);
