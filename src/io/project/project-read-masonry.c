#include "core/base/integer.h"
#include "core/base/memory.h"
#include "io/project/project-masonry.h"
#include "io/project/project-read-parts.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>

#define MAX_COUNT 200000

static const char *const side_names[] = { "left", "right" };

static gboolean
read_length (const QnJsonValue *place, const char *key, QnNeed need, double *length)
{
  return qn_member_number (place, key, need, QN_RANGE_POSITIVE, length);
}

static gboolean
read_size (const QnJsonValue *place, const char *key, double *size)
{
  return qn_member_number (place, key, QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE, size);
}

/* [a, b] into two numbers. */
static gboolean
read_two (const QnJsonValue *place, const char *key, QnNeed need, double *a, double *b)
{
  QnVec2 both = { *a, *b };
  if (!qn_member_vec2 (place, key, need, &both))
    return FALSE;
  *a = both.x;
  *b = both.y;
  return TRUE;
}

static gboolean
read_leaf (const QnJsonValue *place, QnLeaf *leaf, gboolean listed)
{
  if (!qn_member_choice (place, "bond", QN_OPTIONAL, qn_bond_names, QN_BOND_COUNT,
                         &leaf->bond))
    return FALSE;
  QnNeed need = listed || leaf->length > 0 ? QN_OPTIONAL : QN_REQUIRED;
  QnNeed unit = leaf->unit.x > 0 ? QN_OPTIONAL : QN_REQUIRED;
  return read_length (place, "length", need, &leaf->length)
         && qn_member_vec2 (place, "unit", unit, &leaf->unit)
         && qn_member_choice (place, "closers", QN_OPTIONAL, qn_closer_names,
                              QN_CLOSER_COUNT, &leaf->closer)
         && read_size (place, "header", &leaf->header)
         && read_size (place, "lap", &leaf->lap);
}

/* Several leaves: each takes what it does not say from the wall. */
static gboolean
read_leaves (const QnJsonValue *place, QnMasonry *masonry)
{
  static const char *const keys[] = {
    "length", "unit", "bond", "closers", "header", "lap"
  };
  QnJsonValue list, element = { 0 };
  QnLeaf common = masonry->wall.leaves[0];
  if (!qn_member_array (place, "leaves", QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &element)) {
    QnLeaf *leaf =
      element.index == 0 ? &masonry->wall.leaves[0] : qn_masonry_add_leaf (masonry);
    if (leaf == NULL)
      return qn_json_value_no_memory (&element);
    *leaf = common;
    if (!qn_json_value_object (&element) || !read_leaf (&element, leaf, FALSE))
      return FALSE;
    qn_json_value_warn_unknown (&element, keys, G_N_ELEMENTS (keys));
  }
  return list.json == NULL || list.json->child != NULL
         || qn_json_value_fail (&list, _ ("there must be at least one leaf"));
}

static gboolean
read_opening (const QnJsonValue *place, QnOpening *opening)
{
  static const char *const keys[] = { "name", "at",    "width", "height",  "head",
                                      "rise", "span",  "depth", "bearing", "voussoirs",
                                      "skew", "sides", "sill" };
  const char *name = NULL;
  if (!qn_json_value_object (place)
      || !qn_member_string (place, "name", QN_OPTIONAL, &name))
    return FALSE;
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  opening->name = qn_strdup (name);
  if (name != NULL && opening->name == NULL)
    return qn_json_value_no_memory (place);
  if (!qn_member_vec2 (place, "at", QN_REQUIRED, &opening->at)
      || !read_length (place, "width", QN_REQUIRED, &opening->width)
      || !read_length (place, "height", QN_REQUIRED, &opening->height)
      || !qn_member_choice (place, "head", QN_OPTIONAL, qn_head_names, QN_HEAD_COUNT,
                            &opening->head)
      || !qn_member_choice (place, "span", QN_OPTIONAL, qn_span_names, QN_SPAN_COUNT,
                            &opening->span)
      || !qn_member_choice (place, "sides", QN_OPTIONAL, qn_sides_names, QN_SIDES_COUNT,
                            &opening->sides))
    return FALSE;
  gboolean pieces =
    opening->span == QN_SPAN_FLAT_ARCH || opening->span == QN_SPAN_VOUSSOIRS;
  return read_length (place, "rise",
                      opening->head == QN_HEAD_SEGMENTAL ? QN_REQUIRED : QN_OPTIONAL,
                      &opening->rise)
         && read_length (place, "depth",
                         opening->span != QN_SPAN_NONE ? QN_REQUIRED : QN_OPTIONAL,
                         &opening->depth)
         && read_size (place, "bearing", &opening->bearing)
         && qn_member_count (place, "voussoirs", pieces ? QN_REQUIRED : QN_OPTIONAL,
                             MAX_COUNT, &opening->voussoirs)
         && read_size (place, "skew", &opening->skew)
         && read_two (place, "sill", QN_OPTIONAL, &opening->sill_height,
                      &opening->sill_bearing);
}

static gboolean
read_openings (const QnJsonValue *place, QnMasonry *masonry)
{
  QnJsonValue list, element = { 0 };
  if (!qn_member_array (place, "openings", QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &element)) {
    QnOpening *opening = qn_masonry_add_opening (masonry);
    if (opening == NULL)
      return qn_json_value_no_memory (&element);
    if (!read_opening (&element, opening))
      return FALSE;
  }
  return TRUE;
}

static gboolean
read_course_heights (const QnJsonValue *place, QnMasonryWall *wall)
{
  QnJsonValue list, element = { 0 };
  if (!qn_member_array (place, "course_heights", QN_OPTIONAL, &list) || list.json == NULL)
    return list.json == NULL;
  gsize count = (gsize) cJSON_GetArraySize (list.json);
  wall->course_heights = qn_alloc (count, sizeof *wall->course_heights);
  if (wall->course_heights == NULL)
    return qn_json_value_no_memory (&list);
  while (qn_json_value_next (&list, &element)) {
    if (!qn_json_value_number (&element, QN_RANGE_POSITIVE,
                               &wall->course_heights[element.index]))
      return FALSE;
  }
  wall->course_height_count = count;
  return TRUE;
}

static gboolean
read_edges (const QnJsonValue *place, QnMasonryWall *wall)
{
  QnJsonValue list, element = { 0 };
  QnEdge *edges[] = { &wall->left, &wall->right };
  if (!qn_member_array (place, "edges", QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &element)) {
    int edge = 0;
    while (edge < QN_EDGE_COUNT
           && (!cJSON_IsString (element.json)
               || g_strcmp0 (element.json->valuestring, qn_edge_names[edge]) != 0))
      edge++;
    if (element.index >= G_N_ELEMENTS (edges) || edge == QN_EDGE_COUNT)
      return qn_json_value_fail (
        &element, _ ("expected \"straight\" or \"toothed\" for left and right"));
    *edges[element.index] = (QnEdge) edge;
  }
  return TRUE;
}

static gboolean
read_wall (const QnJsonValue *place, QnMasonry *masonry)
{
  QnMasonryWall *wall = &masonry->wall;
  QnJsonValue courses = qn_json_value_member (place, "courses");
  QnJsonValue leaves = qn_json_value_member (place, "leaves");
  gboolean listed = courses.json != NULL;
  if (listed) {
    wall->leaves[0].bond = QN_BOND_CUSTOM;
    if (!qn_read_courses (place, &wall->courses))
      return FALSE;
  }
  /* With leaves, these are only what the leaves have in common. */
  if (leaves.json == NULL
        ? !read_leaf (place, &wall->leaves[0], listed)
        : !read_length (place, "length", QN_OPTIONAL, &wall->leaves[0].length)
            || !qn_member_vec2 (place, "unit", QN_OPTIONAL, &wall->leaves[0].unit))
    return FALSE;
  if ((wall->leaves[0].bond == QN_BOND_CUSTOM) != listed) {
    QnJsonValue bond = qn_json_value_member (place, "bond");
    return qn_json_value_fail (&bond, _ ("\"custom\" and courses go together"));
  }
  return read_length (place, "height", listed ? QN_OPTIONAL : QN_REQUIRED, &wall->height)
         && read_course_heights (place, wall) && read_edges (place, wall)
         && read_size (place, "minimum_piece", &wall->minimum_piece)
         && read_leaves (place, masonry) && read_openings (place, masonry);
}

static gboolean
read_arch (const QnJsonValue *place, QnNeed span, QnArch *arch)
{
  return qn_member_choice (place, "shape", QN_OPTIONAL, qn_arch_shape_names,
                           QN_ARCH_SHAPE_COUNT, &arch->shape)
         && qn_member_choice (place, "sides", QN_OPTIONAL, qn_sides_names, QN_SIDES_COUNT,
                              &arch->sides)
         && read_length (place, "span", span, &arch->span)
         && read_length (place, "rise", QN_REQUIRED, &arch->rise)
         && read_length (place, "ring", QN_REQUIRED, &arch->ring)
         && qn_member_count (place, "voussoirs", QN_REQUIRED, MAX_COUNT, &arch->voussoirs)
         && read_size (place, "springer", &arch->springer);
}

static gboolean
read_column (const QnJsonValue *place, QnColumn *column)
{
  return read_length (place, "height", QN_REQUIRED, &column->height)
         && read_two (place, "width", QN_REQUIRED, &column->bottom, &column->top)
         && qn_member_count (place, "drums", QN_REQUIRED, MAX_COUNT, &column->drums)
         && read_two (place, "plinth", QN_OPTIONAL, &column->plinth_width,
                      &column->plinth_height)
         && read_two (place, "capital", QN_OPTIONAL, &column->capital_width,
                      &column->capital_height);
}

static gboolean
read_buttress (const QnJsonValue *place, QnButtress *buttress)
{
  int choice = 0;
  if (!qn_member_choice (place, "side", QN_REQUIRED, side_names, 2, &choice))
    return FALSE;
  buttress->leans_right = choice == 1;
  return read_length (place, "height", QN_REQUIRED, &buttress->height)
         && read_two (place, "width", QN_REQUIRED, &buttress->bottom, &buttress->top)
         && qn_member_count (place, "courses", QN_REQUIRED, MAX_COUNT,
                             &buttress->courses);
}

static gboolean
read_portal (const QnJsonValue *place, QnPortal *portal)
{
  static const char *const arch_keys[] = { "shape", "sides", "rise", "ring",
                                           "voussoirs" };
  QnJsonValue arch = qn_json_value_member (place, "arch");
  portal->bays = 1;
  if (!qn_member_count (place, "bays", QN_OPTIONAL, MAX_COUNT, &portal->bays)
      || !read_length (place, "span", QN_REQUIRED, &portal->span)
      || !read_two (place, "pier", QN_REQUIRED, &portal->pier_width, &portal->pier_height)
      || !qn_member_count (place, "courses", QN_REQUIRED, MAX_COUNT, &portal->courses)
      || !read_length (place, "lintel", arch.json != NULL ? QN_OPTIONAL : QN_REQUIRED,
                       &portal->lintel_height))
    return FALSE;
  if (arch.json == NULL)
    return TRUE;
  if (portal->lintel_height > 0)
    return qn_json_value_fail (&arch, _ ("arch and lintel exclude each other"));
  if (!qn_json_value_object (&arch))
    return FALSE;
  qn_json_value_warn_unknown (&arch, arch_keys, G_N_ELEMENTS (arch_keys));
  return read_arch (&arch, QN_OPTIONAL, &portal->arch);
}

static gboolean
read_seed (const QnJsonValue *place, const char *key, uint32_t *seed)
{
  double number = 1;
  if (!read_size (place, key, &number))
    return FALSE;
  if (number > G_MAXUINT32 || number != floor (number)) {
    QnJsonValue member = qn_json_value_member (place, key);
    return qn_json_value_fail (&member, _ ("expected a whole number below 4294967296"));
  }
  *seed = (uint32_t) qn_to_integer (number, 0, G_MAXUINT32);
  return TRUE;
}

static gboolean
read_rubble (const QnJsonValue *place, QnRubble *rubble)
{
  rubble->irregularity = 0.7;
  return read_two (place, "width", QN_REQUIRED, &rubble->width, &rubble->top)
         && read_length (place, "height", QN_REQUIRED, &rubble->height)
         && read_length (place, "stone", QN_REQUIRED, &rubble->stone)
         && read_size (place, "irregularity", &rubble->irregularity)
         && read_seed (place, "seed", &rubble->seed);
}

/* Keys of every kind behind those that all have. */
static const char *const common_keys[] = {
  "kind",    "name",       "origin", "rotation", "thickness",    "unit_weight",
  "density", "foundation", "law",    "material", "perturbation", "perturbation_seed"
};
static const char *const kind_keys[QN_MASONRY_KIND_COUNT][16] = {
  [QN_MASONRY_WALL] = { "length", "height", "unit", "bond", "closers", "header", "lap",
                        "course_heights", "courses", "edges", "minimum_piece", "leaves",
                        "openings" },
  [QN_MASONRY_ARCH] = { "shape", "span", "rise", "ring", "voussoirs", "sides",
                        "springer" },
  [QN_MASONRY_COLUMN] = { "height", "width", "drums", "plinth", "capital" },
  [QN_MASONRY_BUTTRESS] = { "height", "width", "courses", "side" },
  [QN_MASONRY_PORTAL] = { "bays", "span", "pier", "courses", "lintel", "arch" },
  [QN_MASONRY_RUBBLE] = { "width", "height", "stone", "irregularity", "seed" },
};

static gboolean
read_kind (const QnJsonValue *place, QnMasonry *masonry)
{
  switch (masonry->kind) {
  case QN_MASONRY_WALL:
    return read_wall (place, masonry);
  case QN_MASONRY_ARCH:
    return read_arch (place, QN_REQUIRED, &masonry->arch);
  case QN_MASONRY_COLUMN:
    return read_column (place, &masonry->column);
  case QN_MASONRY_BUTTRESS:
    return read_buttress (place, &masonry->buttress);
  case QN_MASONRY_PORTAL:
    return read_portal (place, &masonry->portal);
  case QN_MASONRY_RUBBLE:
    return read_rubble (place, &masonry->rubble);
  case QN_MASONRY_KIND_COUNT:
    break;
  }
  g_return_val_if_reached (FALSE);
}

gboolean
qn_read_masonry_object (const QnJsonValue *place, const QnModel *model,
                        QnMasonry *masonry)
{
  char text[QN_NAME_TEXT_SIZE];
  const char *name;
  QnMasonryKind kind;
  *masonry = (QnMasonry){ 0 };
  if (!qn_json_value_object (place)
      || !qn_member_choice (place, "kind", QN_REQUIRED, qn_masonry_kind_names,
                            QN_MASONRY_KIND_COUNT, &kind)
      || !qn_read_own_name (place, "m", text, &name))
    return FALSE;
  if (qn_masonry_init (masonry, kind, name, NULL) != QN_OK)
    return qn_json_value_no_memory (place);
  const char *keys[G_N_ELEMENTS (common_keys) + 16];
  gsize count = 0;
  for (gsize i = 0; i < G_N_ELEMENTS (common_keys); i++)
    keys[count++] = common_keys[i];
  for (gsize i = 0; i < 16 && kind_keys[masonry->kind][i] != NULL; i++)
    keys[count++] = kind_keys[masonry->kind][i];
  qn_json_value_warn_unknown (place, keys, count);
  if (qn_member_vec2 (place, "origin", QN_OPTIONAL, &masonry->origin)
      && qn_member_number (place, "rotation", QN_OPTIONAL, QN_RANGE_FINITE,
                           &masonry->rotation)
      && read_length (place, "thickness", QN_REQUIRED, &masonry->thickness)
      && qn_read_weight (place, model, &masonry->unit_weight, &masonry->density)
      && qn_read_own_law (place, model, &masonry->law)
      && read_size (place, "foundation", &masonry->foundation)
      && read_size (place, "perturbation", &masonry->perturbation)
      && read_seed (place, "perturbation_seed", &masonry->perturbation_seed)
      && read_kind (place, masonry))
    return TRUE;
  qn_masonry_clear (masonry);
  return FALSE;
}
