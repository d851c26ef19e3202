#include "core/model/model.h"

#include "core/base/memory.h"
#include "core/model/model-list.h"

#include <stdlib.h>
#include <string.h>

void
qn_model_init (QnModel *model)
{
  *model = (QnModel){
    .gravity = 9.81,
    .contact = { .law = QN_NONE, .tolerance = 1e-6 },
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
                  .control_block = QN_NONE,
                  .control_node = QN_NONE,
                  .dynamic = { .rho = 0.8,
                               .of = QN_DAMPING_CURRENT,
                               .tolerance = 1e-5,
                               .adaptive = true } },
  };
}

static void
wall_clear (QnWall *wall)
{
  free (wall->name);
  free (wall->lengths);
  free (wall->course_ends);
  *wall = (QnWall){ 0 };
}

void
qn_model_clear (QnModel *model)
{
  for (size_t i = 0; i < model->law_count; i++)
    qn_law_clear (&model->laws[i]);
  for (size_t i = 0; i < model->block_count; i++)
    free (model->blocks[i].name);
  for (size_t i = 0; i < model->wall_count; i++)
    wall_clear (&model->walls[i]);
  for (size_t i = 0; i < model->load_set_count; i++)
    free (model->load_sets[i]);
  for (size_t i = 0; i < model->load_case_count; i++)
    free (model->load_cases[i].name);
  for (size_t i = 0; i < model->stage_count; i++)
    free (model->stages[i].name);
  for (size_t i = 0; i < model->ground_count; i++) {
    free (model->ground[i].record);
    free (model->ground[i].unit);
    free (model->ground[i].points);
  }

  for (size_t i = 0; i < model->node_count; i++)
    free (model->nodes[i].name);
  for (size_t i = 0; i < model->section_count; i++)
    free (model->sections[i].name);
  for (size_t i = 0; i < model->beam_count; i++)
    free (model->beams[i].name);
  for (size_t i = 0; i < model->tie_count; i++)
    free (model->ties[i].name);

  free (model->title);
  free (model->vertices);
  free (model->laws);
  free (model->blocks);
  free (model->walls);
  free (model->overrides);
  free (model->bars);
  free (model->ties);
  free (model->dead_loads);
  free (model->live_loads);
  free (model->load_sets);
  free (model->load_cases);
  free (model->edge_forces);
  free (model->stages);
  free (model->ground);
  free (model->initial);
  free (model->tracks);
  free (model->nodes);
  free (model->sections);
  free (model->beams);
  free (model->elements);
  qn_name_index_clear (&model->law_names);
  qn_name_index_clear (&model->block_names);
  qn_name_index_clear (&model->node_names);
  qn_name_index_clear (&model->section_names);
  qn_name_index_clear (&model->beam_names);
  qn_name_index_clear (&model->tie_names);
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

static QnNameIndex
duplicate_index (QnNameIndex index, bool *failed)
{
  index.slots = duplicate (index.slots, index.slot_count, sizeof *index.slots, failed);
  return index.slots != NULL ? index : (QnNameIndex){ 0 };
}

static void
copy_signal (const QnGroundMotion *from, QnGroundMotion *to, bool *failed)
{
  to->record = duplicate_name (from->record, failed);
  to->unit = duplicate_name (from->unit, failed);
  to->points = duplicate (from->points, from->point_count, sizeof *to->points, failed);
  to->point_count = to->point_capacity = to->points != NULL ? from->point_count : 0;
}

/* Everything but names and what walls own. Counts of arrays that could not be copied are 0, so
 * that the copy may be cleared. */
static void
copy_arrays (const QnModel *source, QnModel *copy, bool *failed)
{
#define COPY_ARRAY(array, counter, room)                                                 \
  do {                                                                                   \
    copy->array =                                                                        \
      duplicate (source->array, source->counter, sizeof *copy->array, failed);           \
    copy->counter = copy->room = copy->array != NULL ? source->counter : 0;              \
  } while (0)

  COPY_ARRAY (vertices, vertex_count, vertex_capacity);
  COPY_ARRAY (laws, law_count, law_capacity);
  COPY_ARRAY (blocks, block_count, block_capacity);
  COPY_ARRAY (walls, wall_count, wall_capacity);
  COPY_ARRAY (overrides, override_count, override_capacity);
  COPY_ARRAY (bars, bar_count, bar_capacity);
  COPY_ARRAY (ties, tie_count, tie_capacity);
  COPY_ARRAY (dead_loads, dead_load_count, dead_load_capacity);
  COPY_ARRAY (live_loads, live_load_count, live_load_capacity);
  COPY_ARRAY (nodes, node_count, node_capacity);
  COPY_ARRAY (sections, section_count, section_capacity);
  COPY_ARRAY (beams, beam_count, beam_capacity);
  COPY_ARRAY (elements, element_count, element_capacity);
  COPY_ARRAY (load_sets, load_set_count, load_set_capacity);
  COPY_ARRAY (load_cases, load_case_count, load_case_capacity);
  COPY_ARRAY (edge_forces, edge_force_count, edge_force_capacity);
  COPY_ARRAY (stages, stage_count, stage_capacity);
  COPY_ARRAY (ground, ground_count, ground_capacity);
  COPY_ARRAY (initial, initial_count, initial_capacity);
  COPY_ARRAY (tracks, track_count, track_capacity);
#undef COPY_ARRAY
}

QnStatus
qn_model_copy (const QnModel *source, QnModel *copy, QnDiag *diag)
{
  bool failed = false;
  *copy = *source;
  copy->title = duplicate_name (source->title, &failed);
  copy->law_names = duplicate_index (source->law_names, &failed);
  copy->block_names = duplicate_index (source->block_names, &failed);
  copy->node_names = duplicate_index (source->node_names, &failed);
  copy->section_names = duplicate_index (source->section_names, &failed);
  copy->beam_names = duplicate_index (source->beam_names, &failed);
  copy->tie_names = duplicate_index (source->tie_names, &failed);
  copy_arrays (source, copy, &failed);

  for (size_t i = 0; i < copy->law_count; i++) {
    copy->laws[i].name = duplicate_name (source->laws[i].name, &failed);
    copy->laws[i].source = duplicate_name (source->laws[i].source, &failed);
  }
  for (size_t i = 0; i < copy->block_count; i++)
    copy->blocks[i].name = duplicate_name (source->blocks[i].name, &failed);
  for (size_t i = 0; i < copy->node_count; i++)
    copy->nodes[i].name = duplicate_name (source->nodes[i].name, &failed);
  for (size_t i = 0; i < copy->section_count; i++)
    copy->sections[i].name = duplicate_name (source->sections[i].name, &failed);
  for (size_t i = 0; i < copy->beam_count; i++)
    copy->beams[i].name = duplicate_name (source->beams[i].name, &failed);
  for (size_t i = 0; i < copy->tie_count; i++)
    copy->ties[i].name = duplicate_name (source->ties[i].name, &failed);
  for (size_t i = 0; i < copy->load_set_count; i++)
    copy->load_sets[i] = duplicate_name (source->load_sets[i], &failed);
  for (size_t i = 0; i < copy->load_case_count; i++)
    copy->load_cases[i].name = duplicate_name (source->load_cases[i].name, &failed);
  for (size_t i = 0; i < copy->stage_count; i++)
    copy->stages[i].name = duplicate_name (source->stages[i].name, &failed);
  for (size_t i = 0; i < copy->ground_count; i++)
    copy_signal (&source->ground[i], &copy->ground[i], &failed);
  for (size_t i = 0; i < copy->wall_count; i++) {
    const QnWall *from = &source->walls[i];
    QnWall *to = &copy->walls[i];
    size_t courses = (size_t) from->course_count;
    size_t lengths = courses > 0 ? (size_t) from->course_ends[courses - 1] : 0;
    to->name = duplicate_name (from->name, &failed);
    to->lengths = duplicate (from->lengths, lengths, sizeof *to->lengths, &failed);
    to->course_ends =
      duplicate (from->course_ends, courses, sizeof *to->course_ends, &failed);
    to->length_capacity = lengths;
    to->course_capacity = courses;
  }

  if (failed) {
    qn_model_clear (copy);
    return qn_diag_no_memory (diag);
  }
  return QN_OK;
}

QnLaw *
qn_model_add_law (QnModel *model, const char *name)
{
  return QN_MODEL_ADD_NAMED (model, laws, law, &model->law_names, name);
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
  QnBlock *block = QN_MODEL_ADD_NAMED (model, blocks, block, &model->block_names, name);
  if (block == NULL)
    return NULL;
  block->density = -1;
  block->law = block->wall = block->masonry = QN_NONE;
  block->first_vertex = (QnId) model->vertex_count;
  block->vertex_count = (QnId) vertex_count;
  model->vertex_count += vertex_count;
  return block;
}

QnWall *
qn_model_add_wall (QnModel *model, const char *name)
{
  QnWall *wall = QN_MODEL_ADD_NAMED (model, walls, wall, NULL, name);

  if (wall != NULL) {
    wall->density = -1;
    wall->law = QN_NONE;
  }
  return wall;
}

QnFaceOverride *
qn_model_add_override (QnModel *model)
{
  QnFaceOverride *override = QN_MODEL_ADD (model, overrides, override);

  if (override != NULL)
    override->block_a = override->block_b = override->law = QN_NONE;
  return override;
}

QnBar *
qn_model_add_bar (QnModel *model)
{
  QnBar *bar = QN_MODEL_ADD (model, bars, bar);

  if (bar != NULL)
    bar->law = QN_NONE;
  return bar;
}

QnTie *
qn_model_add_tie (QnModel *model, const char *name)
{
  QnTie *tie = QN_MODEL_ADD_NAMED (model, ties, tie, &model->tie_names, name);

  if (tie != NULL)
    tie->ends[0].block = tie->ends[1].block = QN_NONE;
  return tie;
}

static QnLoad *
of_nothing (QnLoad *load)
{
  if (load == NULL)
    return NULL;
  load->block = load->node = load->beam = QN_NONE;
  load->edge_count = 1;
  load->part[1] = 1;
  load->span[0] = -INFINITY;
  load->span[1] = INFINITY;
  return load;
}

QnLoad *
qn_model_add_dead_load (QnModel *model)
{
  return of_nothing (QN_MODEL_ADD (model, dead_loads, dead_load));
}

QnLoad *
qn_model_add_live_load (QnModel *model)
{
  return of_nothing (QN_MODEL_ADD (model, live_loads, live_load));
}

QnStage *
qn_model_add_stage (QnModel *model, const char *name)
{
  QnStage *stage = QN_MODEL_ADD_NAMED (model, stages, stage, NULL, name);

  if (stage != NULL)
    stage->control_block = stage->control_node = QN_NONE;
  return stage;
}

QnGroundMotion *
qn_model_add_ground_motion (QnModel *model, const char *record)
{
  QnGroundMotion *motion = QN_MODEL_ADD (model, ground, ground);

  if (motion == NULL)
    return NULL;
  motion->record = qn_strdup (record);
  if (motion->record == NULL && record != NULL) {
    model->ground_count--;
    return NULL;
  }
  motion->kind = record != NULL ? QN_SIGNAL_RECORD : QN_SIGNAL_POINTS;
  motion->scale = 1;
  return motion;
}

bool
qn_ground_motion_add_point (QnGroundMotion *motion, double time, double acceleration)
{
  return QN_ARRAY_PUSH (motion->points, motion->point_count, motion->point_capacity,
                        qn_vec2 (time, acceleration));
}

QnInitialMotion *
qn_model_add_initial_motion (QnModel *model)
{
  return QN_MODEL_ADD (model, initial, initial);
}

QnTrack *
qn_model_add_track (QnModel *model)
{
  return QN_MODEL_ADD (model, tracks, track);
}

int32_t
qn_model_find_load_set (const QnModel *model, const char *name)
{
  for (int32_t set = 0; set <= (int32_t) model->load_set_count; set++)
    if (strcmp (qn_model_load_set_name (model, set), name) == 0)
      return set;
  return QN_NONE;
}

int32_t
qn_model_add_load_set (QnModel *model, const char *name)
{
  int32_t set = qn_model_find_load_set (model, name);
  if (set != QN_NONE || model->load_set_count + 1 >= QN_MAX_LOAD_SETS)
    return set;
  if (QN_MODEL_ADD_NAMED (model, load_sets, load_set, NULL, name) == NULL)
    return QN_NONE;
  return (int32_t) model->load_set_count;
}

const char *
qn_model_load_set_name (const QnModel *model, int32_t set)
{
  return set == 0 ? "live" : model->load_sets[set - 1];
}

int32_t
qn_model_find_load_case (const QnModel *model, const char *name)
{
  for (size_t i = 0; i < model->load_case_count; i++)
    if (strcmp (model->load_cases[i].name, name) == 0)
      return (int32_t) i + 1;
  return QN_NONE;
}

int32_t
qn_model_add_load_case (QnModel *model, const char *name)
{
  int32_t found = qn_model_find_load_case (model, name);
  if (found != QN_NONE || model->load_case_count >= QN_MAX_LOAD_CASES)
    return found;
  QnLoadCase *added = QN_MODEL_ADD_NAMED (model, load_cases, load_case, NULL, name);
  if (added == NULL)
    return QN_NONE;
  added->factor = 1;
  return (int32_t) model->load_case_count;
}

QnId
qn_model_find_law (const QnModel *model, const char *name)
{
  return qn_name_index_find (&model->law_names, model->laws, sizeof *model->laws, name);
}

QnId
qn_model_find_block (const QnModel *model, const char *name)
{
  return qn_name_index_find (&model->block_names, model->blocks, sizeof *model->blocks,
                             name);
}

void
qn_model_followed (const QnModel *model, size_t *body, QnDof *dof)
{
  const QnAnalysisSettings *settings = &model->analysis;

  *dof = settings->control_dof;
  *body =
    qn_model_controlled_body (model, settings->control_block, settings->control_node);
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
