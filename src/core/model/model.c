#include "core/model/model.h"

#include "core/base/memory.h"
#include "core/base/polygon.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

const char *const qn_dof_names[QN_DOF_COUNT] = {
  [QN_DOF_UX] = "ux",
  [QN_DOF_UY] = "uy",
  [QN_DOF_RZ] = "rz",
};

void
qn_model_init (QnModel *model)
{
  *model = (QnModel){
    .gravity = 9.81,
    .contact = { .law = QN_NONE, .tolerance = 1e-6 },
    .combinations = { "", 1, 1, 1, 1 },
    .analysis = { .procedure = QN_PROCEDURE_LOAD,
                  .geometry = QN_GEOMETRY_LINEAR,
                  .snap = QN_SNAP_THROUGH_JUMP,
                  .flow = QN_FLOW_ASSOCIATIVE,
                  .increments = 100,
                  .max_multiplier = INFINITY,
                  .multiplier_tolerance = 1e-4,
                  .residual_tolerance = 1e-8,
                  .max_factorizations = QN_MAX_FACTORIZATIONS,
                  .max_seconds = INFINITY,
                  .control = { QN_NONE, QN_NONE, QN_DOF_UX, 0 },
                  .dynamic = { .rho = 0.8,
                               .of = QN_DAMPING_CURRENT,
                               .tolerance = 1e-5,
                               .adaptive = true } },
  };
}

/* A list of the model, by its places in QnModel. Items of `named` ones begin with their name, which is
 * owned and which an index holds unless its place is 0. New ones are as `blank` has them, NULL: zeroed. */
typedef struct List {
  size_t items, count, capacity, size, index;
  bool named;
  const void *blank;
} List;

#define LIST(items, one)                                                                 \
  offsetof (QnModel, items), offsetof (QnModel, one##_count),                            \
    offsetof (QnModel, one##_capacity), sizeof *((QnModel *) NULL)->items

static const QnLoad blank_load = { .block = QN_NONE,
                                   .node = QN_NONE,
                                   .beam = QN_NONE,
                                   .edge_count = 1,
                                   .part = { 0, 1 },
                                   .span = { -INFINITY, INFINITY },
                                   .stiffness = QN_USUAL_SOIL_STIFFNESS,
                                   .vehicle = QN_NONE,
                                   .convoy = 1 };

static const List lists[] = {
  { LIST (laws, law), offsetof (QnModel, law_names), true, NULL },
  { LIST (blocks, block), offsetof (QnModel, block_names), true,
    &(const QnBlock){ .density = -1,
                      .law = QN_NONE,
                      .ring_law = QN_NONE,
                      .wall = QN_NONE,
                      .masonry = QN_NONE } },
  { LIST (nodes, node), offsetof (QnModel, node_names), true,
    &(const QnNode){ .block = QN_NONE, .beam = QN_NONE } },
  { LIST (sections, section), offsetof (QnModel, section_names), true,
    &(const QnSection){ .density = -1, .shear_factor = 5.0 / 6 } },
  { LIST (beams, beam), offsetof (QnModel, beam_names), true,
    &(const QnBeam){ .nodes = { QN_NONE, QN_NONE },
                     .section = QN_NONE,
                     .first_element = QN_NONE,
                     .element_count = 1 } },
  { LIST (ties, tie), offsetof (QnModel, tie_names), true,
    &(const QnTie){ .ends = { { .block = QN_NONE }, { .block = QN_NONE } } } },
  { LIST (soil_ties, soil_tie), 0, true, NULL },
  { LIST (vehicles, vehicle), 0, true, NULL },
  { LIST (walls, wall), 0, true, &(const QnWall){ .density = -1, .law = QN_NONE } },
  { LIST (load_sets, load_set), 0, true, NULL },
  { LIST (load_cases, load_case), 0, true, &(const QnLoadCase){ .factor = 1 } },
  { LIST (stages, stage), 0, true,
    &(const QnStage){ .control = { .block = QN_NONE, .node = QN_NONE } } },
  { LIST (vertices, vertex), 0, false, NULL },
  { LIST (overrides, override), 0, false,
    &(const QnFaceOverride){ .block_a = QN_NONE, .block_b = QN_NONE, .law = QN_NONE } },
  { LIST (bars, bar), 0, false, &(const QnBar){ .law = QN_NONE } },
  { LIST (dead_loads, dead_load), 0, false, &blank_load },
  { LIST (live_loads, live_load), 0, false, &blank_load },
  { LIST (elements, element), 0, false, NULL },
  { LIST (edge_forces, edge_force), 0, false, NULL },
  { LIST (ground, ground), 0, false,
    &(const QnGroundMotion){ .kind = QN_SIGNAL_POINTS, .scale = 1 } },
  { LIST (initial, initial), 0, false, NULL },
  { LIST (tracks, track), 0, false, NULL },
};

#undef LIST

/* The list whose items stand at this place. */
static const List *
list_at (size_t items)
{
  const List *list = lists;

  while (list->items != items)
    list++;
  return list;
}

static char *
items_of (const QnModel *model, const List *list)
{
  char *items;

  memcpy (&items, (const char *) model + list->items, sizeof items);
  return items;
}

static size_t
count_of (const QnModel *model, const List *list)
{
  size_t count;

  memcpy (&count, (const char *) model + list->count, sizeof count);
  return count;
}

static QnNameIndex *
index_of (const QnModel *model, const List *list)
{
  return (QnNameIndex *) (void *) ((char *) model + list->index);
}

void *
qn_model_add_item (QnModel *model, size_t items, const char *name)
{
  const List *list = list_at (items);
  size_t *count = (size_t *) (void *) ((char *) model + list->count);
  size_t *capacity = (size_t *) (void *) ((char *) model + list->capacity);
  char *copy = qn_strdup (name);

  if ((copy != NULL || name == NULL) && *count < INT32_MAX
      && qn_array_reserve ((char *) model + list->items, capacity, *count + 1,
                           list->size)) {
    char *all = items_of (model, list), *item = all + *count * list->size;
    memset (item, 0, list->size);
    if (list->blank != NULL)
      memcpy (item, list->blank, list->size);
    if (list->named)
      memcpy (item, &copy, sizeof copy);
    if (list->index == 0
        || qn_name_index_add (index_of (model, list), all, list->size, (QnId) *count)) {
      ++*count;
      return item;
    }
  }
  free (copy);
  return NULL;
}

QnId
qn_model_find_item (const QnModel *model, size_t items, const char *name)
{
  const List *list = list_at (items);
  const char *all = items_of (model, list), *own;

  if (list->index > 0)
    return qn_name_index_find (index_of (model, list), all, list->size, name);
  for (size_t i = 0; i < count_of (model, list); i++) {
    memcpy (&own, all + i * list->size, sizeof own);
    if (strcmp (own, name) == 0)
      return (QnId) i;
  }
  return QN_NONE;
}

const char *
qn_model_item_name (const QnModel *model, size_t items, QnId index)
{
  const List *list = list_at (items);
  const char *name;

  if (index < 0 || (size_t) index >= count_of (model, list))
    return NULL;
  memcpy (&name, items_of (model, list) + (size_t) index * list->size, sizeof name);
  return name;
}

void
qn_model_clear (QnModel *model)
{
  for (size_t i = 0; i < model->law_count; i++)
    free (model->laws[i].source);
  for (size_t i = 0; i < model->vehicle_count; i++)
    free (model->vehicles[i].source);
  for (size_t i = 0; i < model->wall_count; i++) {
    free (model->walls[i].lengths);
    free (model->walls[i].course_ends);
  }
  for (size_t i = 0; i < model->ground_count; i++) {
    free (model->ground[i].record);
    free (model->ground[i].unit);
    free (model->ground[i].points);
  }
  for (const List *list = lists; list < lists + QN_N_ELEMENTS (lists); list++) {
    char *items = items_of (model, list), *name;
    for (size_t i = 0; list->named && i < count_of (model, list); i++) {
      memcpy (&name, items + i * list->size, sizeof name);
      free (name);
    }
    free (items);
    if (list->index > 0)
      qn_name_index_clear (index_of (model, list));
  }
  free (model->title);
  *model = (QnModel){ 0 };
}

/* Copies `count` items; *failed is set where memory ran out. NULL for no items. */
static void *
duplicate (const void *items, size_t count, size_t size, bool *failed)
{
  if (count == 0)
    return NULL;
  void *copy = qn_alloc (count, size);
  if (copy == NULL)
    *failed = true;
  else
    memcpy (copy, items, count * size);
  return copy;
}

static char *
duplicate_name (const char *name, bool *failed)
{
  char *copy = qn_strdup (name);
  if (copy == NULL && name != NULL)
    *failed = true;
  return copy;
}

QnStatus
qn_model_copy (const QnModel *source, QnModel *copy, QnDiag *diag)
{
  bool failed = false;
  *copy = *source;
  copy->title = duplicate_name (source->title, &failed);
  for (size_t i = 0; i < QN_N_ELEMENTS (lists); i++) {
    /* Makes a list, which is the source's, one of its own. One that could not be copied
     * is empty, so that the copy may be cleared. */
    const List *list = &lists[i];
    size_t count = count_of (copy, list);
    char *items = duplicate (items_of (copy, list), count, list->size, &failed), *name;
    count = items != NULL ? count : 0;
    for (size_t k = 0; list->named && k < count; k++) {
      memcpy (&name, items + k * list->size, sizeof name);
      name = duplicate_name (name, &failed);
      memcpy (items + k * list->size, &name, sizeof name);
    }
    memcpy ((char *) copy + list->items, &items, sizeof items);
    memcpy ((char *) copy + list->count, &count, sizeof count);
    memcpy ((char *) copy + list->capacity, &count, sizeof count);
    if (list->index != 0) {
      QnNameIndex *index = index_of (copy, list);
      index->slots =
        duplicate (index->slots, index->slot_count, sizeof *index->slots, &failed);
      if (index->slots == NULL)
        *index = (QnNameIndex){ 0 };
    }
  }
  for (size_t i = 0; i < copy->law_count; i++)
    copy->laws[i].source = duplicate_name (copy->laws[i].source, &failed);
  for (size_t i = 0; i < copy->vehicle_count; i++)
    copy->vehicles[i].source = duplicate_name (copy->vehicles[i].source, &failed);
  for (size_t i = 0; i < copy->ground_count; i++) {
    QnGroundMotion *motion = &copy->ground[i];
    motion->record = duplicate_name (motion->record, &failed);
    motion->unit = duplicate_name (motion->unit, &failed);
    motion->points =
      duplicate (motion->points, motion->point_count, sizeof *motion->points, &failed);
    motion->point_capacity = motion->point_count;
  }
  for (size_t i = 0; i < copy->wall_count; i++) {
    QnWall *wall = &copy->walls[i];
    size_t courses = (size_t) wall->course_count;
    size_t lengths = courses > 0 ? (size_t) wall->course_ends[courses - 1] : 0;
    wall->lengths = duplicate (wall->lengths, lengths, sizeof *wall->lengths, &failed);
    wall->course_ends =
      duplicate (wall->course_ends, courses, sizeof *wall->course_ends, &failed);
    wall->length_capacity = lengths;
    wall->course_capacity = courses;
  }
  if (failed) {
    qn_model_clear (copy);
    return qn_diag_no_memory (diag);
  }
  return QN_OK;
}

/* Appends vertices without counting them yet. */
static bool
append_vertices (QnModel *model, const QnVec2 *vertices, size_t count)
{
  size_t need = model->vertex_count + count;
  if (need > INT32_MAX)
    return false;
  if (!qn_array_reserve (&model->vertices, &model->vertex_capacity, need,
                         sizeof *model->vertices))
    return false;
  if (count > 0)
    memcpy (model->vertices + model->vertex_count, vertices,
            count * sizeof *model->vertices);
  return true;
}

QnBlock *
qn_model_add_block (QnModel *model, const char *name, const QnVec2 *vertices,
                    size_t vertex_count)
{
  if (!append_vertices (model, vertices, vertex_count))
    return NULL;
  QnBlock *block = qn_model_add_item (model, offsetof (QnModel, blocks), name);
  if (block == NULL)
    return NULL;
  block->first_vertex = (QnId) model->vertex_count;
  block->vertex_count = (QnId) vertex_count;
  model->vertex_count += vertex_count;
  return block;
}

bool
qn_ground_motion_add_point (QnGroundMotion *motion, double time, double acceleration)
{
  return QN_ARRAY_PUSH (motion->points, motion->point_count, motion->point_capacity,
                        qn_vec2 (time, acceleration));
}

QnId
qn_model_deepest_block (const QnModel *model, QnId first, bool masonry, QnVec2 at,
                        double *depth)
{
  QnId deepest = QN_NONE;

  *depth = -INFINITY;
  for (QnId i = first; i < (QnId) model->block_count; i++) {
    /* So far away it lies outside at least. */
    const QnBox box = qn_model_block_box (model, i);
    double outside = fmax (fmax (box.min.x - at.x, at.x - box.max.x),
                           fmax (box.min.y - at.y, at.y - box.max.y));
    if ((masonry && model->blocks[i].masonry == QN_NONE)
        || (outside > 0 && -outside <= *depth))
      continue;
    double here = qn_polygon_depth (qn_model_block_vertices (model, i),
                                    (size_t) model->blocks[i].vertex_count, at);
    if (here > *depth) {
      *depth = here;
      deepest = i;
    }
  }
  return deepest;
}

bool
qn_model_has_density (const QnModel *model)
{
  for (size_t i = 0; i < model->block_count; i++)
    if (model->blocks[i].density >= 0)
      return true;
  for (size_t i = 0; i < model->wall_count; i++)
    if (model->walls[i].density >= 0)
      return true;
  for (size_t i = 0; i < model->section_count; i++)
    if (model->sections[i].density >= 0)
      return true;
  return false;
}

/* Number of a set or case, from 1. */
static int32_t
find_number (const QnModel *model, size_t items, const char *name)
{
  QnId found = qn_model_find_item (model, items, name);
  return found == QN_NONE ? QN_NONE : found + 1;
}

static int32_t
add_number (QnModel *model, size_t items, const char *name, size_t count, size_t most)
{
  return count < most && qn_model_add_item (model, items, name) != NULL
           ? (int32_t) count + 1
           : QN_NONE;
}

int32_t
qn_model_find_load_set (const QnModel *model, const char *name)
{
  return strcmp (name, "live") == 0
           ? 0
           : find_number (model, offsetof (QnModel, load_sets), name);
}

int32_t
qn_model_add_load_set (QnModel *model, const char *name)
{
  int32_t set = qn_model_find_load_set (model, name);
  return set != QN_NONE ? set
                        : add_number (model, offsetof (QnModel, load_sets), name,
                                      model->load_set_count, QN_MAX_LOAD_SETS - 1);
}

const char *
qn_model_load_set_name (const QnModel *model, int32_t set)
{
  return set == 0 ? "live" : model->load_sets[set - 1];
}

int32_t
qn_model_find_load_case (const QnModel *model, const char *name)
{
  return find_number (model, offsetof (QnModel, load_cases), name);
}

int32_t
qn_model_add_load_case (QnModel *model, const char *name)
{
  int32_t found = qn_model_find_load_case (model, name);
  return found != QN_NONE ? found
                          : add_number (model, offsetof (QnModel, load_cases), name,
                                        model->load_case_count, QN_MAX_LOAD_CASES);
}

void
qn_model_followed (const QnModel *model, size_t *body, QnDof *dof)
{
  const QnAnalysisSettings *settings = &model->analysis;

  *dof = settings->control.dof;
  *body = qn_model_controlled_body (model, &settings->control);
  if (model->track_count > 0) {
    *dof = model->tracks[0].dof;
    *body = (size_t) model->tracks[0].block;
  }
  if (*body != SIZE_MAX)
    return;
  *dof = QN_DOF_UX;
  for (size_t b = 0; b < model->block_count; b++)
    if (!qn_model_body_is_fixed (model, b, QN_DOF_UX)
        && (*body == SIZE_MAX
            || model->blocks[b].centroid.y > model->blocks[*body].centroid.y))
      *body = b;
}

int64_t
qn_model_most_factorizations (const QnModel *model)
{
  int64_t stages = model->stage_count > 0 ? (int64_t) model->stage_count : 1;

  return stages * model->analysis.max_factorizations;
}
