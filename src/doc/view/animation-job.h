/* An animation that is drawn in a thread of its own, from a run that is held meanwhile. */
#pragma once

#include "doc/view/view-state.h"
#include "render/movie/animation.h"
#include <gio/gio.h>

typedef struct QnAnimationSettings {
  QnView view;       /* MECHANISM, or DEFORMED: along the path */
  int width, height; /* px */
  int frames;        /* 2 .. QN_MAX_FRAMES */
  double rate;       /* pictures per second, 1 .. 60 */
  double scale;      /* of displacements; QN_SCALE_AUTO: one that fits */
  gboolean once;     /* MECHANISM: forth, not back */
  gboolean curve;    /* along the path: with the curve */
  gboolean monochrome;
} QnAnimationSettings;

/* What the window shows, 800 x 600 px, 48 frames in 2 s; analyses in time second for second. */
void qn_animation_settings_init (QnAnimationSettings *settings, QnViewState *state);

/* Frames drawn, on the main context, at most twenty times a second. */
typedef void (*QnAnimationTick) (int done, int total, gpointer user_data);

/* Starts to write the current run, which must be there, to OUT.gif, OUT.webm or FOLDER/. `tick` may
 * be NULL. Cancelling leaves nothing of the export. A GTask of a gboolean. */
void qn_animation_write_async (QnViewState *state, const QnAnimationSettings *settings,
                               const char *path, GCancellable *cancellable,
                               QnAnimationTick tick, gpointer tick_data,
                               GAsyncReadyCallback callback, gpointer user_data);
