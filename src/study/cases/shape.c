#include "study/cases/shape.h"

#include "core/base/integer.h"

#include <math.h>
#include <string.h>

static const char digits[] =
  "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/* Digits for -LEVELS … LEVELS. */
#define LEVELS 31

static char
digit_of (double part)
{
  return digits[LEVELS + qn_to_integer (rint (LEVELS * part), -LEVELS, LEVELS)];
}

char *
qn_shape_dup (const QnModel *model, const double *velocities)
{
  QnVec2 low = { INFINITY, INFINITY }, high = { -INFINITY, -INFINITY };
  QnVec2 speeds[QN_SHAPE_POINTS * QN_SHAPE_POINTS];
  double largest = 0;
  if (model->block_count == 0)
    return NULL;
  for (size_t b = 0; b < model->block_count; b++)
    for (int32_t k = 0; k < model->blocks[b].vertex_count; k++) {
      QnVec2 p = qn_model_block_vertices (model, (QnId) b)[k];
      low = qn_vec2 (fmin (low.x, p.x), fmin (low.y, p.y));
      high = qn_vec2 (fmax (high.x, p.x), fmax (high.y, p.y));
    }
  for (int i = 0; i < QN_SHAPE_POINTS * QN_SHAPE_POINTS; i++) {
    double x = (i % QN_SHAPE_POINTS + 0.5) / QN_SHAPE_POINTS;
    double y = ((double) (i / QN_SHAPE_POINTS) + 0.5) / QN_SHAPE_POINTS;
    QnVec2 point = { low.x + x * (high.x - low.x), low.y + y * (high.y - low.y) };
    double depth;
    QnId index = qn_model_deepest_block (model, 0, false, point, &depth);
    const QnBlock *block = &model->blocks[index];
    const double *v = velocities + (size_t) index * QN_DOF_COUNT;
    /* Away from the block its motion is that of its centroid: a thin ring has few points. */
    QnVec2 arm = depth >= 0 ? qn_vec2_sub (point, block->centroid) : qn_vec2 (0, 0);
    speeds[i] = qn_vec2_add_scaled (qn_vec2 (v[QN_DOF_UX], v[QN_DOF_UY]), v[QN_DOF_RZ],
                                    qn_vec2_perp (arm));
    largest = fmax (largest, fmax (fabs (speeds[i].x), fabs (speeds[i].y)));
  }
  if (!(largest > 0) || !isfinite (largest))
    return NULL;
  char *shape = g_malloc (QN_SHAPE_LENGTH + 1);
  for (int i = 0; i < QN_SHAPE_POINTS * QN_SHAPE_POINTS; i++) {
    shape[2 * i] = digit_of (speeds[i].x / largest);
    shape[2 * i + 1] = digit_of (speeds[i].y / largest);
  }
  shape[QN_SHAPE_LENGTH] = '\0';
  return shape;
}

static double
level_of (char digit)
{
  const char *place = strchr (digits, digit);
  return place != NULL ? (double) (place - digits - LEVELS) : 0;
}

double
qn_shape_cosine (const char *a, const char *b)
{
  double product = 0, aa = 0, bb = 0;
  if (a == NULL || b == NULL || strlen (a) != QN_SHAPE_LENGTH
      || strlen (b) != QN_SHAPE_LENGTH)
    return 0;
  for (int i = 0; i < QN_SHAPE_LENGTH; i++) {
    double x = level_of (a[i]), y = level_of (b[i]);
    product += x * y;
    aa += x * x;
    bb += y * y;
  }
  return aa > 0 && bb > 0 ? product / sqrt (aa * bb) : 0;
}
