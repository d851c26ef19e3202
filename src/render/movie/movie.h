/* Movie files, one encoder per format; private to animations. Frames are ARGB32 image surfaces
 * of one size, opaque. Nothing is left behind by a movie that is not finished. */
#ifndef QN_RENDER_MOVIE_H
#define QN_RENDER_MOVIE_H

#include "render/backend/output.h"

typedef struct QnMovie QnMovie;

typedef struct QnMovieFormat {
  /* `samples` are a few frames typical of the whole, for choosing colours. */
  QnMovie *(*open) (const char *path, const QnPage *page, double rate,
                    const QnMetadata *metadata, cairo_surface_t *const *samples,
                    int sample_count, GError **error);
  bool (*add) (QnMovie *movie, cairo_surface_t *frame, GError **error);
  bool (*finish) (QnMovie *movie, GError **error); /* writes; closes in any case */
  void (*abandon) (QnMovie *movie);
} QnMovieFormat;

extern const QnMovieFormat qn_movie_gif;
extern const QnMovieFormat qn_movie_frames; /* numbered PNG files in a folder */
extern const QnMovieFormat qn_movie_webm;

/* Whether this build and machine can write WebM. */
bool qn_movie_webm_available (GError **error);

#endif
