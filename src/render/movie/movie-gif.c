/* Animated GIF through giflib: one palette for all frames, and of every frame only the
 * rectangle that changed. */
#include "core/base/integer.h"
#include "render/drawing/paint.h"
#include "render/movie/movie.h"

#include <gif_lib.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* ---- a palette of at most 256 colours, by median cut (Heckbert 1982) ---- */

#define MOST_COLORS 256

typedef struct Cell {
  uint64_t count, sums[3];
} Cell;

/* Colours are counted in cells of five bits a channel; each cell keeps the sum of its colours,
 * so that a flat area is met exactly. */
enum { CELLS = 1 << 15 };

typedef struct Palette {
  int count;
  uint8_t colors[MOST_COLORS][3];
  Cell cells[CELLS];      /* of every colour of five bits a channel: what was looked at */
  int16_t nearest[CELLS]; /* index for the same, -1: not yet asked */
} Palette;

typedef struct Box {
  int first, last; /* of the list of used cells */
  int axis;        /* longest side */
  double weight;   /* population times length of that side */
} Box;

static int
cell_of (uint32_t pixel)
{
  return (int) ((pixel >> 19 & 31) << 10 | (pixel >> 11 & 31) << 5 | (pixel >> 3 & 31));
}

static int
cell_level (int cell, int axis)
{
  return cell >> (10 - 5 * axis) & 31;
}

static void
measure_box (Box *box, const int *used, const Cell *cells)
{
  int low[3] = { 31, 31, 31 }, high[3] = { 0, 0, 0 };
  uint64_t population = 0;
  for (int i = box->first; i < box->last; i++) {
    population += cells[used[i]].count;
    for (int axis = 0; axis < 3; axis++) {
      low[axis] = MIN (low[axis], cell_level (used[i], axis));
      high[axis] = MAX (high[axis], cell_level (used[i], axis));
    }
  }
  box->axis = 0;
  for (int axis = 1; axis < 3; axis++)
    if (high[axis] - low[axis] > high[box->axis] - low[box->axis])
      box->axis = axis;
  /* The cube root keeps thin lines of another colour in the choice beside large areas. */
  int side = high[box->axis] - low[box->axis];
  box->weight = side * cbrt ((double) population);
}

static int
compare_levels (gconstpointer a, gconstpointer b, gpointer data)
{
  int axis = *(const int *) data;
  int x = *(const int *) a, y = *(const int *) b;
  int difference = cell_level (x, axis) - cell_level (y, axis);
  return difference != 0 ? difference : x - y;
}

/* Cuts a box where half of its population lies on either side. */
static Box
cut_box (Box *box, int *used, const Cell *cells)
{
  uint64_t population = 0, half = 0;
  qsort_r (used + box->first, (size_t) (box->last - box->first), sizeof *used,
           compare_levels, &box->axis);
  for (int i = box->first; i < box->last; i++)
    population += cells[used[i]].count;
  int cut = box->first;
  do
    half += cells[used[cut++]].count;
  while (cut < box->last - 1 && 2 * half < population);
  Box upper = { .first = cut, .last = box->last };
  box->last = cut;
  measure_box (box, used, cells);
  measure_box (&upper, used, cells);
  return upper;
}

/* Looks at an ARGB32 image, before colours are chosen. Large areas keep their exact colours. */
static void
palette_look (Palette *palette, cairo_surface_t *image)
{
  int width = cairo_image_surface_get_width (image);
  int height = cairo_image_surface_get_height (image);
  for (int y = 0; y < height; y++) {
    const uint32_t *row = qn_image_row (image, y);
    for (int x = 0; x < width; x++) {
      Cell *cell = &palette->cells[cell_of (row[x])];
      cell->count++;
      cell->sums[0] += row[x] >> 16 & 255;
      cell->sums[1] += row[x] >> 8 & 255;
      cell->sums[2] += row[x] & 255;
    }
  }
}

static void
palette_choose (Palette *palette)
{
  const Cell *cells = palette->cells;
  g_autofree int *used = g_new (int, CELLS);
  Box boxes[MOST_COLORS] = { { 0 } };
  int box_count = 1;
  for (int i = 0; i < CELLS; i++)
    if (cells[i].count > 0)
      used[boxes[0].last++] = i;
  measure_box (&boxes[0], used, cells);
  while (box_count < MOST_COLORS) {
    int widest = 0;
    for (int i = 1; i < box_count; i++)
      if (boxes[i].weight > boxes[widest].weight)
        widest = i;
    if (!(boxes[widest].weight > 0))
      break;
    boxes[box_count] = cut_box (&boxes[widest], used, cells);
    box_count++;
  }

  palette->count = box_count;
  for (int b = 0; b < box_count; b++) {
    uint64_t count = 0, sums[3] = { 0, 0, 0 };
    for (int i = boxes[b].first; i < boxes[b].last; i++) {
      count += cells[used[i]].count;
      for (int axis = 0; axis < 3; axis++)
        sums[axis] += cells[used[i]].sums[axis];
    }
    for (int axis = 0; axis < 3 && count > 0; axis++)
      palette->colors[b][axis] = (uint8_t) ((sums[axis] + count / 2) / count);
  }
}

/* Index of the nearest colour to an ARGB pixel. */
static uint8_t
palette_find (Palette *palette, uint32_t pixel)
{
  int cell = cell_of (pixel);
  if (palette->nearest[cell] < 0) {
    int channels[3] = { (int) (pixel >> 16 & 255), (int) (pixel >> 8 & 255),
                        (int) (pixel & 255) };
    int least = G_MAXINT;
    for (int i = 0; i < palette->count; i++) {
      int distance = 0;
      for (int axis = 0; axis < 3; axis++) {
        int d = channels[axis] - palette->colors[i][axis];
        distance += d * d;
      }
      if (distance < least) {
        least = distance;
        palette->nearest[cell] = (int16_t) i;
      }
    }
  }
  return (uint8_t) palette->nearest[cell];
}

/* ---- the movie ---- */

typedef struct GifMovie {
  const char *path;
  const QnMetadata *metadata;
  GByteArray *bytes;
  GifFileType *gif;
  Palette palette;
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
  g_byte_array_unref (movie->bytes);
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

/* Screen, endless loop, and who made it. */
static bool
put_header (GifMovie *movie)
{
  static const GifByteType loop[3] = { 1, 0, 0 };
  GifFileType *gif = movie->gif;
  g_autoptr (GString) comment = describe (movie->metadata);
  palette_choose (&movie->palette);
  /* The palette padded to a power of two, as the format requires. */
  GifColorType colors[MOST_COLORS] = { { 0, 0, 0 } };
  int size = 2;
  while (size < movie->palette.count)
    size *= 2;
  for (int i = 0; i < movie->palette.count; i++)
    colors[i] = (GifColorType){ movie->palette.colors[i][0], movie->palette.colors[i][1],
                                movie->palette.colors[i][2] };
  ColorMapObject *map = GifMakeMapObject (size, colors);
  EGifSetGifVersion (gif, true);
  bool done = map != NULL
              && EGifPutScreenDesc (gif, movie->width, movie->height, 8, 0, map) == GIF_OK
              && EGifPutExtensionLeader (gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK
              && EGifPutExtensionBlock (gif, 11, "NETSCAPE2.0") == GIF_OK
              && EGifPutExtensionBlock (gif, sizeof loop, loop) == GIF_OK
              && EGifPutExtensionTrailer (gif) == GIF_OK;
  GifFreeMapObject (map);
  return done && (comment->len == 0 || EGifPutComment (gif, comment->str) == GIF_OK);
}

static void *
gif_open (const char *path, const QnPage *page, double rate, const QnMetadata *metadata,
          GError **error)
{
  int code;
  GifMovie *movie = g_new0 (GifMovie, 1);
  movie->path = path;
  movie->metadata = metadata;
  movie->bytes = g_byte_array_new ();
  movie->width = (int) qn_to_integer (page->width, 1, G_MAXINT16);
  movie->height = (int) qn_to_integer (page->height, 1, G_MAXINT16);
  /* Viewers slow down what is faster than fifty frames a second. */
  movie->delay = (int) qn_to_integer (round (100 / rate), 2, G_MAXUINT16);
  movie->first = true;
  memset (movie->palette.nearest, -1, sizeof movie->palette.nearest);
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
  palette_look (&((GifMovie *) state)->palette, frame);
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
  uint8_t *out = movie->current;
  for (int y = 0; y < movie->height; y++) {
    const uint32_t *row = qn_image_row (frame, y);
    for (int x = 0; x < movie->width; x++)
      *out++ = palette_find (&movie->palette, row[x]);
  }
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
