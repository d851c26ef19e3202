/* Numbered PNG pictures in a folder. */
#include "render/movie.h"
#include "render/png-encode.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <glib/gstdio.h>

struct QnMovie {
  char *folder;
  char *generator;
  bool made; /* the folder did not exist before */
  GPtrArray *written;
};

static void
movie_free (QnMovie *movie)
{
  g_ptr_array_unref (movie->written);
  g_free (movie->folder);
  g_free (movie->generator);
  g_free (movie);
}

static QnMovie *
frames_open (const char *path, const QnPage *page, double rate,
             const QnMetadata *metadata, cairo_surface_t *const *samples,
             int sample_count, GError **error)
{
  (void) page;
  (void) rate;
  (void) samples;
  (void) sample_count;
  bool exists = g_file_test (path, G_FILE_TEST_IS_DIR);
  if (!exists && g_mkdir (path, 0777) != 0) {
    g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
                 _ ("%s: cannot be made: %s"), path, g_strerror (errno));
    return NULL;
  }
  QnMovie *movie = g_new0 (QnMovie, 1);
  movie->folder = g_strdup (path);
  movie->generator = g_strdup (metadata->generator);
  movie->made = !exists;
  movie->written = g_ptr_array_new_with_free_func (g_free);
  return movie;
}

static bool
frames_add (QnMovie *movie, cairo_surface_t *frame, GError **error)
{
  g_autofree char *name = g_strdup_printf ("frame-%04u.png", movie->written->len + 1);
  g_autofree char *path = g_build_filename (movie->folder, name, NULL);
  QnPngText text = { "Software", movie->generator };
  g_autoptr (GBytes) bytes =
    qn_png_encode (frame, 0, &text, movie->generator != NULL ? 1 : 0, error);
  if (bytes == NULL)
    return false;
  gsize length;
  const void *data = g_bytes_get_data (bytes, &length);
  if (!qn_file_replace (path, data, length, error))
    return false;
  g_ptr_array_add (movie->written, g_steal_pointer (&path));
  return true;
}

static bool
frames_finish (QnMovie *movie, GError **error)
{
  (void) error;
  movie_free (movie);
  return true;
}

static void
frames_abandon (QnMovie *movie)
{
  for (guint i = 0; i < movie->written->len; i++)
    g_unlink (g_ptr_array_index (movie->written, i));
  if (movie->made)
    g_rmdir (movie->folder);
  movie_free (movie);
}

const QnMovieFormat qn_movie_frames = {
  .open = frames_open,
  .add = frames_add,
  .finish = frames_finish,
  .abandon = frames_abandon,
};
