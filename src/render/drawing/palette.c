#include "render/drawing/palette.h"

#include "render/drawing/paint.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* Colours are counted in cells of five bits a channel; each cell keeps the sum of its colours,
 * so that a flat area is met exactly. */
enum { CELLS = 1 << 15 };

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
measure_box (Box *box, const int *used, const QnPaletteCell *cells)
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
cut_box (Box *box, int *used, const QnPaletteCell *cells)
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

QnPalette *
qn_palette_new (void)
{
  QnPalette *palette = g_new0 (QnPalette, 1);
  palette->cells = g_new0 (QnPaletteCell, CELLS);
  palette->nearest = g_new (int16_t, CELLS);
  memset (palette->nearest, -1, CELLS * sizeof *palette->nearest);
  return palette;
}

void
qn_palette_look (QnPalette *palette, cairo_surface_t *image)
{
  int width = cairo_image_surface_get_width (image);
  int height = cairo_image_surface_get_height (image);
  for (int y = 0; y < height; y++) {
    const uint32_t *row = qn_image_row (image, y);
    for (int x = 0; x < width; x++) {
      QnPaletteCell *cell = &palette->cells[cell_of (row[x])];
      cell->count++;
      cell->sums[0] += row[x] >> 16 & 255;
      cell->sums[1] += row[x] >> 8 & 255;
      cell->sums[2] += row[x] & 255;
    }
  }
}

void
qn_palette_choose (QnPalette *palette)
{
  const QnPaletteCell *cells = palette->cells;
  g_autofree int *used = g_new (int, CELLS);
  Box boxes[QN_PALETTE_MAX] = { { 0 } };
  int box_count = 1;
  for (int i = 0; i < CELLS; i++)
    if (cells[i].count > 0)
      used[boxes[0].last++] = i;
  measure_box (&boxes[0], used, cells);
  while (box_count < QN_PALETTE_MAX) {
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

void
qn_palette_free (QnPalette *palette)
{
  g_free (palette->cells);
  g_free (palette->nearest);
  g_free (palette);
}

uint8_t
qn_palette_find (QnPalette *palette, uint32_t pixel)
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
