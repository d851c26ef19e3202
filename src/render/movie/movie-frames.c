/* Numbered PNG pictures in a folder, all of them or none. */
#include "disk/file-group.h"
#include "disk/whole-file.h"
#include "render/backend/output.h"
#include "render/movie/movie.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <glib/gstdio.h>

typedef struct FrameFolder {
  const char *folder, *generator;
  bool made; /* the folder did not exist before */
  QnFileGroup pictures;
} FrameFolder;

static void
frames_abandon (void *state)
{
  FrameFolder *movie = state;
  qn_file_group_discard (&movie->pictures);
  if (movie->made)
    g_rmdir (movie->folder);
  g_free (movie);
}

static void *
frames_open (const char *path, const QnPage *page, double rate,
             const QnMetadata *metadata, GError **error)
{
  (void) page;
  (void) rate;
  bool exists = g_file_test (path, G_FILE_TEST_IS_DIR);
  if (!exists && g_mkdir (path, 0777) != 0) {
    g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
                 _ ("%s: cannot be made: %s"), path, g_strerror (errno));
    return NULL;
  }
  FrameFolder *movie = g_new0 (FrameFolder, 1);
  movie->folder = path;
  movie->generator = metadata->generator;
  movie->made = !exists;
  int trouble = qn_file_group_open (&movie->pictures, path);
  if (trouble == 0)
    return movie;
  qn_render_error_set_unwritten (error, path, trouble);
  frames_abandon (movie);
  return NULL;
}

static bool
frames_add (void *state, cairo_surface_t *frame, GError **error)
{
  FrameFolder *movie = state;
  g_autofree char *name =
    g_strdup_printf ("frame-%04u.png", movie->pictures.names->len + 1);
  QnPngText text = { "Software", movie->generator };
  g_autoptr (GBytes) bytes =
    qn_png_encode (frame, 0, &text, movie->generator != NULL ? 1 : 0, error);
  if (bytes == NULL)
    return false;
  gsize length;
  const void *data = g_bytes_get_data (bytes, &length);
  char *path;
  int trouble = qn_file_group_add (&movie->pictures, name, &path);
  if (trouble == 0)
    trouble = qn_whole_file_replace (path, data, length);
  g_free (path);
  if (trouble != 0) {
    g_autofree char *meant = g_build_filename (movie->folder, name, NULL);
    qn_render_error_set_unwritten (error, meant, trouble);
  }
  return trouble == 0;
}

static bool
frames_finish (void *state, GError **error)
{
  FrameFolder *movie = state;
  int trouble = qn_file_group_commit (&movie->pictures);
  if (trouble != 0) {
    qn_render_error_set_unwritten (error, movie->folder, trouble);
    frames_abandon (movie);
    return false;
  }
  g_free (movie);
  return true;
}

const QnMovieFormat qn_movie_frames = {
  .open = frames_open,
  .add = frames_add,
  .finish = frames_finish,
  .abandon = frames_abandon,
};
