#include "io/project/project-masonry.h"

#include "core/base/memory.h"
#include "core/base/word.h"
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/text/json-text.h"

#include <cjson/cJSON.h>
#include <glib/gi18n-lib.h>

void
qn_project_detach_masonry (QnProject *project)
{
  for (size_t i = 0; i < project->model.block_count; i++)
    project->model.blocks[i].masonry = QN_NONE;
}

gboolean
qn_project_has_masonry (const QnProject *project, QnId index)
{
  const QnModel *model = &project->model;
  for (size_t i = 0; i < model->block_count; i++)
    if (model->blocks[i].masonry == index)
      return TRUE;
  return FALSE;
}

void
qn_project_drop_detached (QnProject *project)
{
  QnModel *model = &project->model;
  cJSON *list = cJSON_GetObjectItemCaseSensitive (project->extras, QN_MASONRY_MEMBER);
  gsize count = (gsize) cJSON_GetArraySize (list), kept = 0, index = 0;
  g_autofree QnId *numbers = g_new (QnId, count + 1);
  for (gsize i = 0; i < count; i++)
    numbers[i] = QN_NONE;
  for (size_t i = 0; i < model->block_count; i++)
    if (model->blocks[i].masonry != QN_NONE)
      numbers[model->blocks[i].masonry] = 0;

  for (cJSON *item = list != NULL ? list->child : NULL, *next; item != NULL;
       item = next) {
    next = item->next;
    if (numbers[index] == QN_NONE)
      cJSON_Delete (cJSON_DetachItemViaPointer (list, item));
    else
      numbers[index] = (QnId) kept++;
    index++;
  }
  for (size_t i = 0; i < model->block_count; i++)
    if (model->blocks[i].masonry != QN_NONE)
      model->blocks[i].masonry = numbers[model->blocks[i].masonry];
  if (kept == 0)
    cJSON_DeleteItemFromObjectCaseSensitive (project->extras, QN_MASONRY_MEMBER);
}

#define MAX_COUNT         200000
#define QN_MOST_SPRINGING 1.5709 /* rad: pi/2 as it may be rounded */

static const char *const side_names[] = { "left", "right" };

/* ---- members ---- */

/* Of every kind; what is known only here is written between the others. */
static const QnMember common_members[] = {
  QN_KNOWN ("kind"),
  QN_KNOWN ("name"),
  QN_TWO ("origin", WRITTEN, QnMasonry, origin),
  QN_NUMBER ("rotation", OPTIONAL, FINITE, QnMasonry, rotation),
  QN_NUMBER ("thickness", REQUIRED, POSITIVE, QnMasonry, thickness),
  QN_ENTITY ("ring_law", OPTIONAL, LAW, QnMasonry, ring_law),
  QN_WEIGHT (REQUIRED, QnMasonry),
  QN_LAW (QnMasonry),
  QN_NUMBER ("foundation", OPTIONAL, NOT_NEGATIVE, QnMasonry, foundation),
  QN_NUMBER ("perturbation", OPTIONAL, NOT_NEGATIVE, QnMasonry, perturbation),
  QN_SEED ("perturbation_seed", READ, QnMasonry, perturbation_seed),
  { 0 },
};

static const QnMember leaf_members[] = {
  QN_NUMBER ("length", READ, POSITIVE, QnLeaf, length),
  QN_TWO ("unit", WRITTEN, QnLeaf, unit),
  QN_CHOICE ("bond", WRITTEN, qn_bond_names, QnLeaf, bond),
  QN_CHOICE ("closers", OPTIONAL, qn_closer_names, QnLeaf, closer),
  QN_NUMBER ("header", OPTIONAL, NOT_NEGATIVE, QnLeaf, header),
  QN_NUMBER ("lap", OPTIONAL, NOT_NEGATIVE, QnLeaf, lap),
  { 0 },
};

static const QnMember opening_members[] = {
  QN_STRING ("name", OPTIONAL, QnOpening, name),
  QN_TWO ("at", REQUIRED, QnOpening, at),
  QN_NUMBER ("width", REQUIRED, POSITIVE, QnOpening, width),
  QN_NUMBER ("height", REQUIRED, POSITIVE, QnOpening, height),
  QN_CHOICE ("head", WRITTEN, qn_head_names, QnOpening, head),
  QN_NUMBER ("rise", OPTIONAL, POSITIVE, QnOpening, rise),
  QN_CHOICE ("span", WRITTEN, qn_span_names, QnOpening, span),
  QN_NUMBER ("depth", OPTIONAL, POSITIVE, QnOpening, depth),
  QN_NUMBER ("bearing", OPTIONAL, NOT_NEGATIVE, QnOpening, bearing),
  QN_COUNT ("voussoirs", OPTIONAL, MAX_COUNT, QnOpening, voussoirs),
  QN_NUMBER ("skew", OPTIONAL, NOT_NEGATIVE, QnOpening, skew),
  QN_CHOICE ("sides", OPTIONAL, qn_sides_names, QnOpening, sides),
  QN_TWO ("sill", OPTIONAL, QnOpening, sill_height),
  { 0 },
};

/* Those of its leaf besides. */
static const QnMember wall_members[] = {
  QN_NUMBER ("height", READ, POSITIVE, QnMasonry, wall.height),
  QN_KNOWN ("course_heights"),
  QN_KNOWN ("courses"),
  QN_KNOWN ("edges"),
  QN_NUMBER ("minimum_piece", READ, NOT_NEGATIVE, QnMasonry, wall.minimum_piece),
  QN_KNOWN ("leaves"),
  QN_KNOWN ("openings"),
  { 0 },
};

static const QnMember arch_members[] = {
  QN_CHOICE ("shape", WRITTEN, qn_arch_shape_names, QnMasonry, arch.shape),
  QN_NUMBER ("span", REQUIRED, POSITIVE, QnMasonry, arch.span),
  QN_NUMBER ("rise", OPTIONAL, POSITIVE, QnMasonry, arch.rise),
  QN_KNOWN ("springing"),
  QN_NUMBER ("ring", REQUIRED, POSITIVE, QnMasonry, arch.ring),
  QN_COUNT ("voussoirs", REQUIRED, MAX_COUNT, QnMasonry, arch.voussoirs),
  QN_CHOICE ("sides", WRITTEN, qn_sides_names, QnMasonry, arch.sides),
  QN_COUNT ("rings", OPTIONAL, MAX_COUNT, QnMasonry, arch.rings),
  QN_NUMBER ("haunch", OPTIONAL, NOT_NEGATIVE, QnMasonry, arch.haunch),
  QN_NUMBER ("springer", OPTIONAL, NOT_NEGATIVE, QnMasonry, arch.springer),
  { 0 },
};

/* Of a portal. */
static const QnMember inner_arch_members[] = {
  QN_CHOICE ("shape", WRITTEN, qn_arch_shape_names, QnArch, shape),
  QN_NUMBER ("rise", OPTIONAL, POSITIVE, QnArch, rise),
  QN_KNOWN ("springing"),
  QN_NUMBER ("ring", REQUIRED, POSITIVE, QnArch, ring),
  QN_COUNT ("voussoirs", REQUIRED, MAX_COUNT, QnArch, voussoirs),
  QN_CHOICE ("sides", WRITTEN, qn_sides_names, QnArch, sides),
  QN_COUNT ("rings", OPTIONAL, MAX_COUNT, QnArch, rings),
  QN_NUMBER ("haunch", OPTIONAL, NOT_NEGATIVE, QnArch, haunch),
  { 0 },
};

static const QnMember column_members[] = {
  QN_NUMBER ("height", REQUIRED, POSITIVE, QnMasonry, column.height),
  QN_TWO ("width", REQUIRED, QnMasonry, column.bottom),
  QN_COUNT ("drums", REQUIRED, MAX_COUNT, QnMasonry, column.drums),
  QN_TWO ("plinth", READ, QnMasonry, column.plinth_width),
  QN_TWO ("capital", READ, QnMasonry, column.capital_width),
  { 0 },
};

static const QnMember buttress_members[] = {
  QN_NUMBER ("height", REQUIRED, POSITIVE, QnMasonry, buttress.height),
  QN_TWO ("width", REQUIRED, QnMasonry, buttress.bottom),
  QN_COUNT ("courses", REQUIRED, MAX_COUNT, QnMasonry, buttress.courses),
  QN_SWITCH ("side", REQUIRED, side_names, QnMasonry, buttress.leans_right),
  { 0 },
};

static const QnMember portal_members[] = {
  QN_COUNT ("bays", WRITTEN, MAX_COUNT, QnMasonry, portal.bays),
  QN_NUMBER ("span", REQUIRED, POSITIVE, QnMasonry, portal.span),
  QN_TWO ("pier", REQUIRED, QnMasonry, portal.pier_width),
  QN_COUNT ("courses", REQUIRED, MAX_COUNT, QnMasonry, portal.courses),
  QN_NUMBER ("lintel", OPTIONAL, POSITIVE, QnMasonry, portal.lintel_height),
  QN_NUMBER ("backing", OPTIONAL, NOT_NEGATIVE, QnMasonry, portal.backing),
  QN_KNOWN ("arch"),
  QN_KNOWN ("spans"),
  QN_KNOWN ("rises"),
  QN_KNOWN ("ring_thicknesses"),
  QN_KNOWN ("piers"),
  { 0 },
};

/* Lists of a portal: numbers of single bays, or of piers, from the left. */
static const struct {
  const char *key;
  gsize offset;
  int more; /* than there are bays */
} portal_lists[] = {
  { "spans", offsetof (QnPortal, spans), 0 },
  { "rises", offsetof (QnPortal, rises), 0 },
  { "ring_thicknesses", offsetof (QnPortal, rings), 0 },
  { "piers", offsetof (QnPortal, piers), 1 },
};

static const QnMember rubble_members[] = {
  QN_TWO ("width", REQUIRED, QnMasonry, rubble.width),
  QN_NUMBER ("height", REQUIRED, POSITIVE, QnMasonry, rubble.height),
  QN_NUMBER ("stone", REQUIRED, POSITIVE, QnMasonry, rubble.stone),
  QN_NUMBER ("irregularity", WRITTEN, NOT_NEGATIVE, QnMasonry, rubble.irregularity),
  QN_SEED ("seed", WRITTEN, QnMasonry, rubble.seed),
  { 0 },
};

static const QnMember grid_members[] = {
  QN_KNOWN ("size"),
  QN_KNOWN ("cells"),
  QN_KNOWN ("openings"),
  { 0 },
};

static const QnMember voronoi_members[] = {
  QN_KNOWN ("size"),
  QN_NUMBER ("cell", REQUIRED, POSITIVE, QnMasonry, rubble.stone),
  QN_SEED ("seed", WRITTEN, QnMasonry, rubble.seed),
  { 0 },
};

static const QnMember *const kind_members[QN_MASONRY_NAME_COUNT] = {
  [QN_MASONRY_WALL] = wall_members,     [QN_MASONRY_ARCH] = arch_members,
  [QN_MASONRY_COLUMN] = column_members, [QN_MASONRY_BUTTRESS] = buttress_members,
  [QN_MASONRY_PORTAL] = portal_members, [QN_MASONRY_RUBBLE] = rubble_members,
  [QN_MASONRY_GRID] = grid_members,     [QN_MASONRY_VORONOI] = voronoi_members,
};

/* ---- reading ---- */

/* Whether a member that may be needed is there. */
static gboolean
require (const QnJsonValue *place, const char *key, gboolean needed)
{
  double number;
  return !needed || qn_member_number (place, key, QN_REQUIRED, QN_RANGE_FINITE, &number);
}

/* Length and height of a unit, which may come from the wall. */
static gboolean
read_leaf (const QnJsonValue *place, QnLeaf *leaf, gboolean listed)
{
  return qn_members_take (place, leaf_members, NULL, leaf)
         && require (place, "length", !listed && !(leaf->length > 0))
         && (leaf->unit.x > 0
             || qn_member_vec2 (place, "unit", QN_REQUIRED, &leaf->unit));
}

/* Several leaves: each takes what it does not say from the wall. */
static gboolean
read_leaves (const QnJsonValue *place, QnMasonry *masonry)
{
  QnJsonValue list, element = { 0 };
  QnLeaf common = masonry->wall.leaves[0];
  if (!qn_member_array (place, "leaves", QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &element)) {
    QnLeaf *leaf =
      element.index == 0 ? &masonry->wall.leaves[0] : qn_masonry_add_leaf (masonry);
    *leaf = common;
    if (!qn_members_check (&element, leaf_members, NULL, NULL)
        || !read_leaf (&element, leaf, FALSE))
      return FALSE;
  }
  return list.json == NULL || list.json->child != NULL
         || qn_json_value_fail (&list, _ ("there must be at least one leaf"));
}

static gboolean
read_openings (const QnJsonValue *place, QnMasonry *masonry)
{
  QnJsonValue list, element = { 0 };
  if (!qn_member_array (place, "openings", QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &element)) {
    QnOpening *opening = qn_masonry_add_opening (masonry);
    if (!qn_members_read (&element, opening_members, NULL, opening))
      return FALSE;
    const gboolean stones =
      opening->span == QN_SPAN_FLAT_ARCH || opening->span == QN_SPAN_VOUSSOIRS;
    if (!require (&element, "rise", opening->head == QN_HEAD_SEGMENTAL)
        || !require (&element, "depth", opening->span != QN_SPAN_NONE)
        || !require (&element, "voussoirs", stones))
      return FALSE;
  }
  return TRUE;
}

static gboolean
read_course_heights (const QnJsonValue *place, QnMasonryWall *wall)
{
  QnJsonValue list;
  if (!qn_member_array (place, "course_heights", QN_OPTIONAL, &list) || list.json == NULL)
    return list.json == NULL;
  gsize count = (gsize) cJSON_GetArraySize (list.json);
  wall->course_heights = qn_alloc (count, sizeof *wall->course_heights);
  if (wall->course_heights == NULL)
    return qn_json_value_no_memory (&list);
  wall->course_height_count = count;
  return qn_json_value_numbers (&list, QN_RANGE_POSITIVE, 1, wall->course_heights);
}

static gboolean
read_edges (const QnJsonValue *place, QnMasonryWall *wall)
{
  QnJsonValue list, element = { 0 };
  QnEdge *edges[] = { &wall->left, &wall->right };
  if (!qn_member_array (place, "edges", QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &element)) {
    if (element.index >= G_N_ELEMENTS (edges)
        || !qn_find_word (cJSON_GetStringValue (element.json), qn_edge_names,
                          QN_EDGE_COUNT, edges[element.index]))
      return qn_json_value_fail (
        &element, _ ("expected \"straight\" or \"toothed\" for left and right"));
  }
  return TRUE;
}

static gboolean
read_masonry_wall (const QnJsonValue *place, QnMasonry *masonry)
{
  QnMasonryWall *wall = &masonry->wall;
  QnLeaf *leaf = &wall->leaves[0];
  gboolean listed = cJSON_GetObjectItemCaseSensitive (place->json, "courses") != NULL;
  if (listed) {
    leaf->bond = QN_BOND_CUSTOM;
    if (!qn_read_courses (place, &wall->courses))
      return FALSE;
  }
  /* With leaves, these are only what the leaves have in common. */
  if (cJSON_GetObjectItemCaseSensitive (place->json, "leaves") == NULL
        ? !read_leaf (place, leaf, listed)
        : !qn_member_number (place, "length", QN_OPTIONAL, QN_RANGE_POSITIVE,
                             &leaf->length)
            || !qn_member_vec2 (place, "unit", QN_OPTIONAL, &leaf->unit))
    return FALSE;
  if ((leaf->bond == QN_BOND_CUSTOM) != listed) {
    QnJsonValue bond = qn_json_value_member (place, "bond");
    return qn_json_value_fail (&bond, _ ("\"custom\" and courses go together"));
  }
  return require (place, "height", !listed) && read_course_heights (place, wall)
         && read_edges (place, wall) && read_leaves (place, masonry)
         && read_openings (place, masonry);
}

/* A circular arch by its rise, or by the angle between the plumb line and its joints at the springing:
 * rise = span/2 tan (angle/2). */
static gboolean
read_springing (const QnJsonValue *place, double span, QnArch *arch)
{
  const QnJsonValue member = qn_json_value_member (place, "springing");
  double angle = 0;
  if (member.json == NULL)
    return require (place, "rise", TRUE);
  if (!qn_json_value_number (&member, QN_RANGE_POSITIVE, &angle))
    return FALSE;
  if (arch->rise > 0)
    return qn_json_value_fail (&member, _ ("rise and springing exclude each other"));
  if (arch->shape != QN_ARCH_CIRCULAR || angle > QN_MOST_SPRINGING)
    return qn_json_value_fail (&member, _ ("only circular arches have it, up to π/2"));
  arch->rise = fmin (0.5 * span * tan (0.5 * angle), 0.5 * span);
  return TRUE;
}

static gboolean
read_portal_lists (const QnJsonValue *place, QnPortal *portal)
{
  for (gsize i = 0; i < G_N_ELEMENTS (portal_lists); i++) {
    QnJsonValue list;
    double *numbers = (double *) (void *) ((char *) portal + portal_lists[i].offset);
    int most = MIN (portal->bays + portal_lists[i].more, QN_MOST_UNEQUAL);
    if (!qn_member_array (place, portal_lists[i].key, QN_OPTIONAL, &list))
      return FALSE;
    if (list.json != NULL && cJSON_GetArraySize (list.json) > most)
      return qn_json_value_failf (&list, _ ("expected up to %d numbers"), most);
    if (!qn_json_value_numbers (&list, QN_RANGE_POSITIVE, 1, numbers))
      return FALSE;
  }
  return TRUE;
}

static gboolean
read_portal (const QnJsonValue *place, QnPortal *portal)
{
  QnJsonValue arch = qn_json_value_member (place, "arch");
  if (!read_portal_lists (place, portal))
    return FALSE;
  if (arch.json == NULL)
    return require (place, "lintel", TRUE);
  return qn_members_exclude (place, "arch", "lintel")
         && qn_members_read (&arch, inner_arch_members, NULL, &portal->arch)
         && read_springing (&arch, portal->span, &portal->arch);
}

static gboolean
read_grid (const QnJsonValue *place, QnMasonry *masonry)
{
  QnVec2 size, cells;
  if (!qn_member_vec2 (place, "size", QN_REQUIRED, &size)
      || !qn_member_vec2 (place, "cells", QN_REQUIRED, &cells))
    return FALSE;
  if (!(cells.x >= 1 && cells.y >= 1) || cells.x != floor (cells.x)
      || cells.y != floor (cells.y) || cells.x * cells.y > MAX_COUNT) {
    QnJsonValue member = qn_json_value_member (place, "cells");
    return qn_json_value_failf (
      &member, _ ("expected two whole numbers from 1 on, not more than %d cells in all"),
      MAX_COUNT);
  }
  qn_masonry_set_grid (&masonry->wall, size, cells);
  return read_openings (place, masonry);
}

static gboolean
read_voronoi (const QnJsonValue *place, QnRubble *rubble)
{
  QnVec2 size;
  const uint32_t seed = rubble->seed;
  if (!qn_member_vec2 (place, "size", QN_REQUIRED, &size))
    return FALSE;
  qn_masonry_set_voronoi (rubble, size, rubble->stone);
  rubble->seed = seed;
  return TRUE;
}

static gboolean
read_object (const QnJsonValue *place, const QnModel *model, int kind, QnMasonry *masonry)
{
  const QnJsonValue turn = qn_json_value_member (place, "rotation");
  masonry->portal.bays = 1;
  masonry->rubble.irregularity = 0.7;
  masonry->rubble.seed = masonry->perturbation_seed = 1;
  if (!qn_members_check (place, common_members, kind_members[kind],
                         kind == QN_MASONRY_WALL ? leaf_members : NULL)
      || !qn_members_take (place, common_members, model, masonry))
    return FALSE;
  if (fabs (masonry->rotation) > 2 * QN_PI)
    qn_json_value_warn (&turn, _ (qn_problem_text (QN_PROBLEM_DOUBT_ANGLE)));
  return qn_members_take (place, kind_members[kind], model, masonry)
         && (kind != QN_MASONRY_WALL || read_masonry_wall (place, masonry))
         && (kind != QN_MASONRY_ARCH
             || read_springing (place, masonry->arch.span, &masonry->arch))
         && (kind != QN_MASONRY_PORTAL || read_portal (place, &masonry->portal))
         && (kind != QN_MASONRY_GRID || read_grid (place, masonry))
         && (kind != QN_MASONRY_VORONOI || read_voronoi (place, &masonry->rubble));
}

/* `masonry` is overwritten without being cleared and holds nothing on failure. */
static gboolean
read_masonry (const QnJsonValue *place, const QnModel *model, QnMasonry *masonry)
{
  g_autofree char *numbered = g_strdup_printf ("m%zu", place->index + 1);
  const char *name = numbered;
  int kind;
  *masonry = (QnMasonry){ 0 };
  if (!qn_json_value_object (place)
      || !qn_member_choice (place, "kind", QN_REQUIRED, qn_masonry_kind_names,
                            QN_MASONRY_NAME_COUNT, &kind)
      || !qn_member_string (place, "name", QN_OPTIONAL, &name))
    return FALSE;
  qn_masonry_init (masonry, qn_masonry_kind_of (kind), name);
  if (read_object (place, model, kind, masonry))
    return TRUE;
  qn_masonry_clear (masonry);
  return FALSE;
}

gboolean
qn_read_masonry (const QnJsonValue *root, QnProject *project)
{
  /* Its members have been moved into the extras. */
  QnJsonValue document = { .reader = root->reader, .json = project->extras };
  QnJsonValue list, place = { 0 };
  if (!qn_member_array (&document, QN_MASONRY_MEMBER, QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &place)) {
    QnMasonry masonry;
    if (!read_masonry (&place, &project->model, &masonry))
      return FALSE;
    QnModel *model = &project->model;
    size_t first = model->block_count;
    QnDiag diag;
    QnStatus status = qn_masonry_expand (&masonry, (QnId) place.index, model, &diag);
    for (size_t i = first; i < model->block_count; i++)
      model->blocks[i].masonry = (QnId) place.index;
    qn_masonry_clear (&masonry);
    if (status != QN_OK) {
      qn_project_set_error (project, &diag, &root->reader->error);
      return FALSE;
    }
  }
  return TRUE;
}

gboolean
qn_project_get_masonry (const QnProject *project, QnMasonries *list, GError **error)
{
  *list = (QnMasonries){ 0 };
  QnReader reader = { .name = project->name };
  QnJsonValue root = qn_json_value_root (&reader, project->extras);
  QnJsonValue place = qn_json_value_member (&root, QN_MASONRY_MEMBER), element = { 0 };
  while (qn_json_value_next (&place, &element)) {
    QnMasonry masonry;
    if (!read_masonry (&element, &project->model, &masonry)) {
      g_propagate_error (error, reader.error);
      qn_masonries_clear (list);
      return FALSE;
    }
    qn_masonries_take (list, &masonry);
  }
  return TRUE;
}

/* ---- writing ---- */

static void
put_leaf (GString *json, const QnLeaf *leaf)
{
  const QnLeaf usual = { .lap = 0.5 };
  if (leaf->bond != QN_BOND_CUSTOM)
    qn_json_put_number (json, "length", leaf->length);
  qn_members_write (json, leaf_members, NULL, leaf, &usual);
}

static void
put_openings (GString *json, const QnMasonryWall *wall)
{
  if (wall->opening_count == 0)
    return;
  qn_json_begin_member (json, "openings");
  for (gsize i = 0; i < wall->opening_count; i++) {
    g_string_append (json, i > 0 ? ", " : "[");
    QnOpening o = wall->openings[i]; /* what has no effect is left out */
    const gboolean ring = o.span == QN_SPAN_VOUSSOIRS;
    const QnOpening usual = { .sides = ring ? QN_SIDES_COUNT : o.sides };
    if (o.head != QN_HEAD_SEGMENTAL)
      o.rise = 0;
    if (o.span == QN_SPAN_NONE)
      o.depth = 0;
    if (o.span != QN_SPAN_LINTEL)
      o.bearing = 0;
    if (o.span != QN_SPAN_FLAT_ARCH)
      o.skew = 0;
    if (o.span != QN_SPAN_FLAT_ARCH && !ring)
      o.voussoirs = 0;
    if (!(o.sill_height > 0))
      o.sill_height = o.sill_bearing = 0;
    g_string_append_c (json, '{');
    qn_members_write (json, opening_members, NULL, &o, &usual);
    g_string_append (json, " }");
  }
  g_string_append_c (json, ']');
}

static void
put_wall (GString *json, const QnMasonryWall *wall)
{
  gboolean listed = wall->leaves[0].bond == QN_BOND_CUSTOM;
  if (!listed)
    qn_json_put_number (json, "height", wall->height);
  if (wall->leaf_count == 1) {
    put_leaf (json, &wall->leaves[0]);
  } else {
    qn_json_begin_member (json, "leaves");
    for (gsize i = 0; i < wall->leaf_count; i++) {
      g_string_append (json, i > 0 ? ", {" : "[{");
      put_leaf (json, &wall->leaves[i]);
      g_string_append (json, " }");
    }
    g_string_append_c (json, ']');
  }
  if (wall->course_height_count > 0)
    qn_json_put_numbers (json, "course_heights", wall->course_heights,
                         wall->course_height_count);
  if (listed) {
    qn_json_begin_member (json, "courses");
    g_string_append_c (json, '[');
    int32_t entry = 0;
    for (int32_t course = 0; course < wall->courses.course_count; course++) {
      g_string_append (json, course > 0 ? ", " : "");
      qn_json_append_numbers (json, wall->courses.lengths + entry,
                              (gsize) (wall->courses.course_ends[course] - entry));
      entry = wall->courses.course_ends[course];
    }
    g_string_append_c (json, ']');
  }
  if (wall->left != QN_EDGE_STRAIGHT || wall->right != QN_EDGE_STRAIGHT) {
    qn_json_begin_member (json, "edges");
    g_string_append_printf (json, "[\"%s\", \"%s\"]", qn_edge_names[wall->left],
                            qn_edge_names[wall->right]);
  }
  qn_json_put_number (json, "minimum_piece", wall->minimum_piece);
  put_openings (json, wall);
}

/* The name of the kind, or of its variety. */
static int
name_index (const QnMasonry *masonry)
{
  const QnMasonryWall *wall = &masonry->wall;
  if (masonry->kind == QN_MASONRY_WALL && wall->grid && wall->leaf_count == 1
      && wall->leaves[0].bond == QN_BOND_STACK)
    return QN_MASONRY_GRID;
  return masonry->kind == QN_MASONRY_RUBBLE && masonry->rubble.relaxed
           ? QN_MASONRY_VORONOI
           : (int) masonry->kind;
}

static void
put_kind (GString *json, const QnMasonry *masonry)
{
  const QnMasonry usual = { 0 };
  const QnColumn *column = &masonry->column;
  const int name = name_index (masonry);
  if (name == QN_MASONRY_WALL) {
    put_wall (json, &masonry->wall);
    return;
  }
  if (name == QN_MASONRY_GRID) {
    const QnLeaf *leaf = &masonry->wall.leaves[0];
    const double cells[] = { fmax (round (leaf->length / leaf->unit.x), 1),
                             fmax (round (masonry->wall.height / leaf->unit.y), 1) };
    qn_json_put_vec2 (json, "size", qn_vec2 (leaf->length, masonry->wall.height));
    qn_json_put_numbers (json, "cells", cells, 2);
    put_openings (json, &masonry->wall);
  }
  if (name == QN_MASONRY_VORONOI)
    qn_json_put_vec2 (json, "size",
                      qn_vec2 (masonry->rubble.width, masonry->rubble.height));
  qn_members_write (json, kind_members[name], NULL, masonry, &usual);
  if (masonry->kind == QN_MASONRY_COLUMN && column->plinth_height > 0)
    qn_json_put_numbers (json, "plinth", &column->plinth_width, 2);
  if (masonry->kind == QN_MASONRY_COLUMN && column->capital_height > 0)
    qn_json_put_numbers (json, "capital", &column->capital_width, 2);
  for (gsize i = 0; masonry->kind == QN_MASONRY_PORTAL && i < G_N_ELEMENTS (portal_lists);
       i++) {
    const double *numbers =
      (const double *) (const void *) ((const char *) &masonry->portal
                                       + portal_lists[i].offset);
    gsize count = 0;
    while (count < QN_MOST_UNEQUAL && numbers[count] > 0)
      count++;
    if (count > 0)
      qn_json_put_numbers (json, portal_lists[i].key, numbers, count);
  }
  if (masonry->kind == QN_MASONRY_PORTAL && !(masonry->portal.lintel_height > 0))
    qn_members_put (json, "arch", inner_arch_members, NULL, &masonry->portal.arch,
                    &usual.portal.arch);
}

void
qn_masonry_append_json (GString *json, const QnMasonry *masonry, const QnModel *model)
{
  const QnMasonry usual = { .ring_law = QN_NONE };
  g_string_append_c (json, '{');
  qn_json_put_string (json, "kind", qn_masonry_kind_names[name_index (masonry)]);
  qn_json_put_string (json, "name", masonry->name);
  qn_members_write (json, common_members, model, masonry, &usual);
  if (masonry->perturbation > 0)
    qn_json_put_number (json, "perturbation_seed", masonry->perturbation_seed);
  put_kind (json, masonry);
  g_string_append (json, " }");
}
