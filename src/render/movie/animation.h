/* Animations: a mechanism that moves, or the path of an analysis with a dot on its curve. */
#pragma once

#include "render/figure/figure.h"

/* After every frame; false cancels. */
typedef bool (*QnAnimationProgress) (int done, int total, void *user_data);

typedef struct QnAnimation {
  QnFigure
    figure;    /* MECHANISM: from rest to the full motion; any other view: the deformed
                      structure along the steps of the result */
  int frames;  /* 2 .. QN_MAX_FRAMES */
  double rate; /* frames per second, 1 .. 60 */
  bool once;   /* MECHANISM: once forth instead of forth and back */
  bool curve;  /* along the steps: with the load-displacement curve */
  QnAnimationProgress progress; /* or NULL */
  void *user_data;
} QnAnimation;

#define QN_MAX_FRAMES 2000

/* 48 frames at 24 per second, with the curve. */
void qn_animation_init (QnAnimation *animation, const QnModel *model,
                        const QnContacts *contacts, const QnResult *result, QnView view);

/* How many pictures show so many seconds of an analysis in time in one second, at least 2; 0 where the
 * result is not one in time. May exceed QN_MAX_FRAMES. And the speed of so many pictures. */
double qn_animation_frames_at (const QnResult *result, double rate, double speed);
double qn_animation_speed_of (const QnResult *result, double rate, int frames);

/* Takes as many pictures as show so many seconds of an analysis in time in one second. False with an error,
 * USAGE, where the result is not one in time or there were too many. */
bool qn_animation_set_speed (QnAnimation *animation, double speed, GError **error);

/* Writes OUT.gif, OUT.webm, or numbered pictures frame-0001.png … into FOLDER/ (a path that
 * ends in a slash or is a folder already; made where missing). On failure or cancelling
 * nothing of this export is left. */
bool qn_animation_export (const QnAnimation *animation, const char *path,
                          const QnOutput *output, const QnMetadata *metadata,
                          GError **error);

/* Whether the path's form is one that can be written by this build; for checking before any
 * work. */
bool qn_animation_check_path (const char *path, GError **error);
