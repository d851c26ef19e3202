/* Edits of analyses in time: what they need to begin with, and their ground motions. */
#ifndef QN_DOC_EDIT_DYNAMIC_H
#define QN_DOC_EDIT_DYNAMIC_H

#include "doc/edit/edit.h"

/* Makes the analysis one in time. What the model does not say gets something to start from: 10 s in
 * steps of 5 ms, large displacements, and a half-sine pulse where nothing moves the structure. */
gboolean qn_edit_choose_dynamic (QnModel *model, GError **error);

/* A further half-sine pulse along x: 2 m/s2 for half a second. */
gboolean qn_edit_add_pulse (QnModel *model, GError **error);

/* The record in a file, of any kind that record.h tells, as points of the project: the project needs
 * the file no more. Along x. */
gboolean qn_edit_add_record (QnModel *model, const char *path, GError **error);

gboolean qn_edit_remove_ground_motion (QnModel *model, gsize index, GError **error);

/* One line about a ground motion, for lists. Free with g_free(). */
char *qn_ground_motion_dup_text (const QnGroundMotion *motion);

/* "half-sine" …, translated. */
const char *qn_pulse_kind_text (QnPulseKind kind);

#endif
