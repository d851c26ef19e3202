/* Animated GIF through giflib: one palette for all frames, and of every frame only the
 * rectangle that changed. */
#include "core/base/integer.h"
#include "render/drawing/paint.h"
#include "render/drawing/palette.h"
#include "render/movie/movie.h"

#include <gif_lib.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

typedef struct GifMovie {
  char *path;
  GString *comment; /* who made it */
  GByteArray *bytes;
  GifFileType *gif;
  QnPalette *palette;
  int width, height, delay; /* delay in hundredths of a second */
  uint8_t *previous, *current;
  bool first;
} GifMovie;

static int
append_bytes (GifFileType *gif, const GifByteType *data, int length)
{
  g_byte_array_append (gif->UserData, data, (guint) length);
  return length;
}

static void
gif_free (void *state)
{
  GifMovie *movie = state;
  int code;
  if (movie->gif != NULL)
    EGifCloseFile (movie->gif, &code);
  qn_palette_free (movie->palette);
  g_byte_array_unref (movie->bytes);
  g_string_free (movie->comment, TRUE);
  g_free (movie->path);
  g_free (movie->previous);
  g_free (movie->current);
  g_free (movie);
}

static void
set_failed (GError **error)
{
  g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FAILED,
                       _ ("the animation could not be encoded as GIF"));
}

/* The palette padded to a power of two, as the format requires. */
static ColorMapObject *
make_color_map (const QnPalette *palette)
{
  GifColorType colors[QN_PALETTE_MAX] = { { 0, 0, 0 } };
  int size = 2;
  while (size < palette->count)
    size *= 2;
  for (int i = 0; i < palette->count; i++)
    colors[i] = (GifColorType){ palette->colors[i][0], palette->colors[i][1],
                                palette->colors[i][2] };
  return GifMakeMapObject (size, colors);
}

/* Screen, endless loop, and who made it. */
static bool
put_header (GifMovie *movie)
{
  static const GifByteType loop[3] = { 1, 0, 0 };
  GifFileType *gif = movie->gif;
  qn_palette_choose (movie->palette);
  ColorMapObject *map = make_color_map (movie->palette);
  EGifSetGifVersion (gif, true);
  bool done = map != NULL
              && EGifPutScreenDesc (gif, movie->width, movie->height, 8, 0, map) == GIF_OK
              && EGifPutExtensionLeader (gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK
              && EGifPutExtensionBlock (gif, 11, "NETSCAPE2.0") == GIF_OK
              && EGifPutExtensionBlock (gif, sizeof loop, loop) == GIF_OK
              && EGifPutExtensionTrailer (gif) == GIF_OK;
  GifFreeMapObject (map);
  return done
         && (movie->comment->len == 0
             || EGifPutComment (gif, movie->comment->str) == GIF_OK);
}

static GString *
describe (const QnMetadata *metadata)
{
  GString *comment = g_string_new (metadata->generator);
  if (metadata->title != NULL)
    g_string_append_printf (comment, "; %s", metadata->title);
  if (!isnan (metadata->multiplier)) {
    char number[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd (number, sizeof number, "%.6g", metadata->multiplier);
    g_string_append_printf (comment, "; multiplier %s", number);
  }
  if (metadata->model != NULL)
    g_string_append_printf (comment, "; %s", metadata->model);
  if (metadata->model_sha256 != NULL)
    g_string_append_printf (comment, "; sha256 %s", metadata->model_sha256);
  return comment;
}

static void *
gif_open (const char *path, const QnPage *page, double rate, const QnMetadata *metadata,
          GError **error)
{
  int code;
  GifMovie *movie = g_new0 (GifMovie, 1);
  movie->path = g_strdup (path);
  movie->bytes = g_byte_array_new ();
  movie->width = (int) qn_to_integer (page->width, 1, G_MAXINT16);
  movie->height = (int) qn_to_integer (page->height, 1, G_MAXINT16);
  /* Viewers slow down what is faster than fifty frames a second. */
  movie->delay = (int) qn_to_integer (round (100 / rate), 2, G_MAXUINT16);
  movie->first = true;
  movie->palette = qn_palette_new ();
  movie->comment = describe (metadata);
  movie->previous = g_try_malloc ((gsize) movie->width * movie->height);
  movie->current = g_try_malloc ((gsize) movie->width * movie->height);
  movie->gif = EGifOpen (movie->bytes, append_bytes, &code);
  if (movie->previous == NULL || movie->current == NULL || movie->gif == NULL) {
    gif_free (movie);
    set_failed (error);
    return NULL;
  }
  return movie;
}

static void
gif_look (void *state, cairo_surface_t *frame)
{
  qn_palette_look (((GifMovie *) state)->palette, frame);
}

static void
index_frame (GifMovie *movie, cairo_surface_t *frame)
{
  uint8_t *out = movie->current;
  for (int y = 0; y < movie->height; y++) {
    const uint32_t *row = qn_image_row (frame, y);
    for (int x = 0; x < movie->width; x++)
      *out++ = qn_palette_find (movie->palette, row[x]);
  }
}

/* The smallest rectangle outside which nothing changed; one pixel where nothing did. */
static void
find_change (const GifMovie *movie, int *left, int *top, int *right, int *bottom)
{
  *left = movie->width;
  *top = movie->height;
  *right = *bottom = 0;
  for (int y = 0; y < movie->height; y++) {
    const uint8_t *a = movie->previous + (size_t) y * movie->width;
    const uint8_t *b = movie->current + (size_t) y * movie->width;
    if (memcmp (a, b, (size_t) movie->width) == 0)
      continue;
    int first = 0, last = movie->width - 1;
    while (a[first] == b[first])
      first++;
    while (a[last] == b[last])
      last--;
    *left = MIN (*left, first);
    *right = MAX (*right, last + 1);
    *top = MIN (*top, y);
    *bottom = y + 1;
  }
  if (*right == 0)
    *left = *top = 0, *right = *bottom = 1;
}

static bool
gif_add (void *state, cairo_surface_t *frame, GError **error)
{
  GifMovie *movie = state;
  int left = 0, top = 0, right = movie->width, bottom = movie->height;
  bool first = movie->first, done = !first || put_header (movie);
  movie->first = false;
  index_frame (movie, frame);
  if (!first)
    find_change (movie, &left, &top, &right, &bottom);

  GraphicsControlBlock control = { .DisposalMode = DISPOSE_DO_NOT,
                                   .DelayTime = movie->delay,
                                   .TransparentColor = NO_TRANSPARENT_COLOR };
  GifByteType block[4];
  EGifGCBToExtension (&control, block);
  done =
    done && EGifPutExtension (movie->gif, GRAPHICS_EXT_FUNC_CODE, 4, block) == GIF_OK
    && EGifPutImageDesc (movie->gif, left, top, right - left, bottom - top, false, NULL)
         == GIF_OK;
  for (int y = top; done && y < bottom; y++)
    done = EGifPutLine (movie->gif, movie->current + (size_t) y * movie->width + left,
                        right - left)
           == GIF_OK;
  uint8_t *swap = movie->previous;
  movie->previous = movie->current;
  movie->current = swap;
  if (!done)
    set_failed (error);
  return done;
}

static bool
gif_finish (void *state, GError **error)
{
  GifMovie *movie = state;
  int code;
  bool done = EGifCloseFile (movie->gif, &code) == GIF_OK;
  movie->gif = NULL;
  if (!done)
    set_failed (error);
  done =
    done && qn_file_replace (movie->path, movie->bytes->data, movie->bytes->len, error);
  gif_free (movie);
  return done;
}

const QnMovieFormat qn_movie_gif = {
  .open = gif_open,
  .look = gif_look,
  .add = gif_add,
  .finish = gif_finish,
  .abandon = gif_free,
};
