/* Movie files, one encoder per format; private to animations. Frames are ARGB32 image surfaces
 * of one size, opaque. Nothing is left behind by a movie that is not finished. */
#pragma once

#include "render/backend/output.h"

typedef struct QnMovieFormat {
  /* Returns the state that the others take, or NULL; path and metadata are borrowed as long as it lasts. */
  void *(*open) (const char *path, const QnPage *page, double rate,
                 const QnMetadata *metadata, GError **error);
  /* Is shown a few frames typical of the whole, before the first; or NULL. */
  void (*look) (void *state, cairo_surface_t *frame);
  bool (*add) (void *state, cairo_surface_t *frame, GError **error);
  bool (*finish) (void *state, GError **error); /* writes; closes in any case */
  void (*abandon) (void *state);
} QnMovieFormat;

extern const QnMovieFormat qn_movie_gif;
extern const QnMovieFormat qn_movie_frames; /* numbered PNG files in a folder */

/* WebM; NULL with an error (UNAVAILABLE) where this build or machine cannot write it. */
const QnMovieFormat *qn_movie_webm (GError **error);
