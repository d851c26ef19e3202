#include "core/memory.h"
#include "io/file-read.h"
#include "io/io-error.h"
#include "io/json-stream.h"
#include "io/project-names.h"
#include "io/result-file.h"
#include "io/result-forces.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>
#include <string.h>

#define FORMAT_VERSION 1

/* Rows of three numbers, one for each block. */
typedef struct Rows {
  double *items;
  size_t count, capacity; /* numbers, not rows */
} Rows;

typedef struct Names {
  GPtrArray *items;
} Names;

/* What is read before it is known to fit together. */
typedef struct Draft {
  QnResultFile *file;
  char *format;
  gint32 version;
  char *outcome;
  Names blocks, overrides, nodes;
  Rows displacements, mechanism, reactions;
  QnStepForces forces;
  Rows node_displacements, node_mechanism;
  QnBeamForces *beam_forces;
  size_t beam_force_count, beam_force_capacity, element_count;
  gboolean has_mechanism;
  size_t rows_per_step; /* numbers; of the first step */
  size_t step_capacity, contact_capacity, pair_capacity, unstable_capacity;
  size_t support_capacity;
} Draft;

/* Room for one more item; FALSE with an error where memory runs out. */
static gboolean
grow (QnJsonStream *stream, gpointer array, size_t count, size_t *capacity, size_t size)
{
  void **items = array;
  void *grown = qn_array_grow (*items, capacity, count + 1, size);
  if (grown == NULL)
    return qn_json_stream_no_memory (stream);
  *items = grown;
  return TRUE;
}

static gboolean
read_row (QnJsonStream *stream, gpointer target)
{
  Rows *rows = target;
  double row[QN_DOF_COUNT];
  if (!qn_json_stream_numbers (stream, row, QN_DOF_COUNT)
      || !grow (stream, &rows->items, rows->count + QN_DOF_COUNT, &rows->capacity,
                sizeof *rows->items))
    return FALSE;
  memcpy (rows->items + rows->count, row, sizeof row);
  rows->count += QN_DOF_COUNT;
  return TRUE;
}

static gboolean
read_name (QnJsonStream *stream, gpointer target)
{
  Names *names = target;
  char *name = NULL;
  if (!qn_json_stream_string (stream, &name))
    return FALSE;
  g_ptr_array_add (names->items, name);
  return TRUE;
}

static gboolean
read_names (QnJsonStream *stream, gpointer target)
{
  Names *names = target;
  names->items = g_ptr_array_new_with_free_func (g_free);
  return qn_json_stream_array (stream, read_name, names);
}

/* A multiplier or null. */
typedef struct Optional {
  bool given;
  double number;
} Optional;

static gboolean
read_optional (QnJsonStream *stream, gpointer target)
{
  Optional *optional = target;
  if (stream->scanner.token == QN_JSON_NULL)
    return TRUE;
  optional->given = true;
  return qn_json_stream_number (stream, &optional->number);
}

static gboolean
read_collapse (QnJsonStream *stream, gpointer target)
{
  QnResult *result = &((Draft *) target)->file->result;
  Optional optional = { false, 0 };
  gboolean done = read_optional (stream, &optional);
  result->has_collapse_multiplier = optional.given;
  result->collapse_multiplier = optional.number;
  return done;
}

static gboolean
read_first_limit (QnJsonStream *stream, gpointer target)
{
  QnResult *result = &((Draft *) target)->file->result;
  Optional optional = { false, 0 };
  gboolean done = read_optional (stream, &optional);
  result->has_first_limit_multiplier = optional.given;
  result->first_limit_multiplier = optional.number;
  return done;
}

static QnLimitFigures *
limit_figures (gpointer target)
{
  return &((Draft *) target)->file->result.limit;
}

static gboolean
read_lower_bound (QnJsonStream *stream, gpointer target)
{
  limit_figures (target)->given = true;
  return qn_json_stream_number (stream, &limit_figures (target)->lower_bound);
}

static gboolean
read_upper_bound (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_number (stream, &limit_figures (target)->upper_bound);
}

static gboolean
read_flow (QnJsonStream *stream, gpointer target)
{
  for (int flow = 0; flow < QN_FLOW_COUNT; flow++)
    if (stream->scanner.token == QN_JSON_STRING
        && qn_json_string_is (&stream->scanner, qn_name_of_flow (flow))) {
      limit_figures (target)->flow = (QnFlow) flow;
      return TRUE;
    }
  return qn_json_stream_fail (stream, _ ("this is no flow rule of limit analysis"));
}

static gboolean
read_associative_bound (QnJsonStream *stream, gpointer target)
{
  limit_figures (target)->has_associative_bound = true;
  return qn_json_stream_number (stream, &limit_figures (target)->associative_bound);
}

/* More than a result keeps is read and left out. */
static gboolean
read_fixed_point (QnJsonStream *stream, gpointer target)
{
  QnLimitFigures *figures = limit_figures (target);
  double number;
  if (!qn_json_stream_number (stream, &number))
    return FALSE;
  if (figures->fixed_point_count < QN_RESULT_FIXED_POINTS)
    figures->fixed_points[figures->fixed_point_count++] = number;
  return TRUE;
}

static gboolean
read_fixed_points (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_fixed_point, target);
}

static gboolean
read_event (QnJsonStream *stream, gpointer target)
{
  QnEvent *event = target;
  if (stream->scanner.token == QN_JSON_NULL)
    return TRUE;
  if (stream->scanner.token == QN_JSON_STRING) {
    *event = qn_json_string_is (&stream->scanner, "snap")       ? QN_EVENT_SNAP
             : qn_json_string_is (&stream->scanner, "collapse") ? QN_EVENT_COLLAPSE
                                                                : QN_EVENT_NONE;
    if (*event != QN_EVENT_NONE)
      return TRUE;
  }
  return qn_json_stream_fail (stream, _ ("expected null, \"snap\" or \"collapse\""));
}

/* A step with the list that its displacements go to. */
typedef struct StepDraft {
  QnStep step;
  Rows *displacements, *reactions, *node_displacements;
  QnStepForces *forces;
  Draft *draft;
} StepDraft;

/* N, V, M at the first and the second end of an element. */
static gboolean
read_element_forces (QnJsonStream *stream, gpointer target)
{
  Draft *draft = target;
  double n[6];
  if (!qn_json_stream_numbers (stream, n, G_N_ELEMENTS (n))
      || !grow (stream, &draft->beam_forces, draft->beam_force_count,
                &draft->beam_force_capacity, sizeof *draft->beam_forces))
    return FALSE;
  draft->beam_forces[draft->beam_force_count++] =
    (QnBeamForces){ { n[0], n[3] }, { n[1], n[4] }, { n[2], n[5] } };
  return TRUE;
}

static gboolean
read_step_beam_forces (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_element_forces, *(Draft **) target);
}

/* Only how many there are is of interest: which they are is the model's knowledge. */
static gboolean
read_element (QnJsonStream *stream, gpointer target)
{
  double numbers[3];
  ((Draft *) target)->element_count++;
  return qn_json_stream_numbers (stream, numbers, G_N_ELEMENTS (numbers));
}

static gboolean
read_elements (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_element, target);
}

static gboolean
read_node_mechanism (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_row, &((Draft *) target)->node_mechanism);
}

/* Number of a stage, which the file counts from 0. */
static gboolean
read_stage (QnJsonStream *stream, gpointer target)
{
  int32_t *stage = target;
  if (!qn_json_stream_int32 (stream, stage))
    return FALSE;
  if (*stage > QN_MAX_STAGES)
    return qn_json_stream_fail (stream, _ ("there is no such stage"));
  ++*stage;
  return TRUE;
}

static gboolean
read_step_displacements (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_row, *(Rows **) target);
}

static gboolean
read_step (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "multiplier", qn_json_stream_number, offsetof (StepDraft, step.multiplier), TRUE },
    { "displacements", read_step_displacements, offsetof (StepDraft, displacements),
      TRUE },
    { "iterations", qn_json_stream_int32, offsetof (StepDraft, step.iterations), FALSE },
    { "residual", qn_json_stream_number, offsetof (StepDraft, step.residual), FALSE },
    { "event", read_event, offsetof (StepDraft, step.event), FALSE },
    { "stage", read_stage, offsetof (StepDraft, step.stage), FALSE },
    { "reactions", read_step_displacements, offsetof (StepDraft, reactions), FALSE },
    { "forces", qn_result_forces_read, offsetof (StepDraft, forces), FALSE },
    { "states", qn_result_states_read, offsetof (StepDraft, forces), FALSE },
    { "node_displacements", read_step_displacements,
      offsetof (StepDraft, node_displacements), FALSE },
    { "beam_forces", read_step_beam_forces, offsetof (StepDraft, draft), FALSE },
  };
  Draft *draft = target;
  QnResult *result = &draft->file->result;
  StepDraft read = { .displacements = &draft->displacements,
                     .reactions = &draft->reactions,
                     .node_displacements = &draft->node_displacements,
                     .forces = &draft->forces,
                     .draft = draft };
  size_t before = draft->displacements.count;
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &read)
      || !grow (stream, &result->steps, result->step_count, &draft->step_capacity,
                sizeof *result->steps))
    return FALSE;

  size_t rows = draft->displacements.count - before;
  if (result->step_count == 0)
    draft->rows_per_step = rows;
  result->steps[result->step_count++] = read.step;
  return rows == draft->rows_per_step
         || qn_json_stream_fail (stream,
                                 _ ("step has displacements of another number of blocks "
                                    "than the first"));
}

static gboolean
read_steps (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_step, target);
}

static gboolean
read_vec2 (QnJsonStream *stream, gpointer target)
{
  QnVec2 *vector = target;
  double numbers[2];
  if (!qn_json_stream_numbers (stream, numbers, 2))
    return FALSE;
  *vector = qn_vec2 (numbers[0], numbers[1]);
  return TRUE;
}

static gboolean
read_state (QnJsonStream *stream, gpointer target)
{
  if (stream->scanner.token == QN_JSON_STRING) {
    for (int state = 0; state < QN_PAIR_STATE_COUNT; state++) {
      if (qn_json_string_is (&stream->scanner,
                             qn_pair_state_name ((QnPairState) state))) {
        *(QnPairState *) target = (QnPairState) state;
        return TRUE;
      }
    }
  }
  return qn_json_stream_fail (stream, _ ("this is no state of a contact pair"));
}

static gboolean
read_normal (QnJsonStream *stream, gpointer target)
{
  return read_vec2 (stream, target)
         && (fabs (qn_vec2_length (*(QnVec2 *) target) - 1) <= 1e-6
             || qn_json_stream_fail (stream, _ ("normal is not of length 1")));
}

typedef struct ContactDraft {
  QnResultContact contact;
  QnPairResult pair;
  QnId blocks[2];
} ContactDraft;

static gboolean
read_contact_blocks (QnJsonStream *stream, gpointer target)
{
  QnId *blocks = target;
  double numbers[2];
  if (!qn_json_stream_numbers (stream, numbers, 2))
    return FALSE;
  for (int i = 0; i < 2; i++) {
    if (!(numbers[i] >= 0 && numbers[i] < QN_MAX_BLOCKS
          && numbers[i] == floor (numbers[i])))
      return qn_json_stream_fail (stream, _ ("blocks are given by their numbers from 0"));
    blocks[i] = (QnId) numbers[i];
  }
  return TRUE;
}

static gboolean
read_contact (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "face", qn_json_stream_int32, offsetof (ContactDraft, contact.face), TRUE },
    { "blocks", read_contact_blocks, offsetof (ContactDraft, blocks), TRUE },
    { "point", read_vec2, offsetof (ContactDraft, contact.point), TRUE },
    { "normal", read_normal, offsetof (ContactDraft, contact.normal), TRUE },
    { "area", qn_json_stream_number, offsetof (ContactDraft, contact.area), FALSE },
    { "bar", qn_json_stream_int32, offsetof (ContactDraft, contact.bar), FALSE },
    { "state", read_state, offsetof (ContactDraft, pair.state), TRUE },
    { "normal_force", qn_json_stream_number, offsetof (ContactDraft, pair.normal_force),
      TRUE },
    { "shear_force", qn_json_stream_number, offsetof (ContactDraft, pair.shear_force),
      TRUE },
  };
  Draft *draft = target;
  QnResultFile *file = draft->file;
  QnResult *result = &file->result;
  ContactDraft read = { .contact = { .area = -1, .bar = QN_NONE } };
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &read)
      || !grow (stream, &file->contacts, result->pair_count, &draft->contact_capacity,
                sizeof *file->contacts)
      || !grow (stream, &result->pairs, result->pair_count, &draft->pair_capacity,
                sizeof *result->pairs))
    return FALSE;

  read.contact.block_a = read.blocks[0];
  read.contact.block_b = read.blocks[1];
  file->contacts[result->pair_count] = read.contact;
  result->pairs[result->pair_count++] = read.pair;
  return TRUE;
}

static gboolean
read_contacts (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_contact, target);
}

static gboolean
read_mechanism (QnJsonStream *stream, gpointer target)
{
  Draft *draft = target;
  if (stream->scanner.token == QN_JSON_NULL)
    return TRUE;
  draft->has_mechanism = TRUE;
  return qn_json_stream_array (stream, read_row, &draft->mechanism);
}

static gboolean
read_unstable_block (QnJsonStream *stream, gpointer target)
{
  Draft *draft = target;
  QnResult *result = &draft->file->result;
  return grow (stream, &result->unstable_blocks, result->unstable_count,
               &draft->unstable_capacity, sizeof *result->unstable_blocks)
         && qn_json_stream_int32 (stream,
                                  &result->unstable_blocks[result->unstable_count++]);
}

static gboolean
read_unstable (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_unstable_block, target);
}

static gboolean
read_support (QnJsonStream *stream, gpointer target)
{
  Draft *draft = target;
  QnResult *result = &draft->file->result;
  return grow (stream, &result->supports, result->support_count, &draft->support_capacity,
               sizeof *result->supports)
         && qn_json_stream_int32 (stream, &result->supports[result->support_count++]);
}

static gboolean
read_supports (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_support, target);
}

static gboolean
read_end_stage (QnJsonStream *stream, gpointer target)
{
  return read_stage (stream, &((Draft *) target)->file->result.stage);
}

static gboolean
read_statistics (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "seconds", qn_json_stream_number, offsetof (QnStatistics, seconds), FALSE },
    { "factor_seconds", qn_json_stream_number, offsetof (QnStatistics, factor_seconds),
      FALSE },
    { "assembly_seconds", qn_json_stream_number,
      offsetof (QnStatistics, assembly_seconds), FALSE },
    { "law_seconds", qn_json_stream_number, offsetof (QnStatistics, law_seconds), FALSE },
    { "iterations", qn_json_stream_int32, offsetof (QnStatistics, iterations), FALSE },
    { "factorizations", qn_json_stream_int32, offsetof (QnStatistics, factorizations),
      FALSE },
    { "peak_memory_bytes", qn_json_stream_int64,
      offsetof (QnStatistics, peak_memory_bytes), FALSE },
  };
  Draft *draft = target;
  return qn_json_stream_object (stream, members, G_N_ELEMENTS (members),
                                &draft->file->result.statistics);
}

static gboolean
read_generator (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_string (stream, &((Draft *) target)->file->generator);
}

static gboolean
read_model (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_string (stream, &((Draft *) target)->file->model);
}

static gboolean
read_sha256 (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_string (stream, &((Draft *) target)->file->model_sha256);
}

static gboolean
read_document (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "format", qn_json_stream_string, offsetof (Draft, format), TRUE },
    { "version", qn_json_stream_int32, offsetof (Draft, version), TRUE },
    { "generator", read_generator, 0, FALSE },
    { "model", read_model, 0, FALSE },
    { "model_sha256", read_sha256, 0, FALSE },
    { "overrides", read_names, offsetof (Draft, overrides), FALSE },
    { "outcome", qn_json_stream_string, offsetof (Draft, outcome), TRUE },
    { "collapse_multiplier", read_collapse, 0, FALSE },
    { "first_limit_multiplier", read_first_limit, 0, FALSE },
    { "lower_bound", read_lower_bound, 0, FALSE },
    { "upper_bound", read_upper_bound, 0, FALSE },
    { "flow", read_flow, 0, FALSE },
    { "associative_bound", read_associative_bound, 0, FALSE },
    { "fixed_points", read_fixed_points, 0, FALSE },
    { "unstable_blocks", read_unstable, 0, FALSE },
    { "supports", read_supports, 0, FALSE },
    { "stage", read_end_stage, 0, FALSE },
    { "blocks", read_names, offsetof (Draft, blocks), TRUE },
    { "nodes", read_names, offsetof (Draft, nodes), FALSE },
    { "elements", read_elements, 0, FALSE },
    { "steps", read_steps, 0, TRUE },
    { "contacts", read_contacts, 0, TRUE },
    { "mechanism", read_mechanism, 0, FALSE },
    { "node_mechanism", read_node_mechanism, 0, FALSE },
    { "statistics", read_statistics, 0, FALSE },
  };
  return qn_json_stream_object (stream, members, G_N_ELEMENTS (members), target);
}

static gboolean
check_head (QnJsonStream *stream, Draft *draft)
{
  QnResult *result = &draft->file->result;
  if (strcmp (draft->format, "quoin-result") != 0)
    return qn_json_stream_fail_at (stream, "format",
                                   _ ("this is not a result: expected \"quoin-result\""));
  if (draft->version != FORMAT_VERSION)
    return qn_json_stream_fail_at (
      stream, "version", _ ("this program reads another version of the format"));
  for (int outcome = 0; outcome < QN_OUTCOME_COUNT; outcome++) {
    if (strcmp (draft->outcome, qn_outcome_name ((QnOutcome) outcome)) == 0) {
      result->outcome = (QnOutcome) outcome;
      return TRUE;
    }
  }
  return qn_json_stream_fail_at (stream, "outcome",
                                 _ ("this is no outcome of an analysis"));
}

/* The same for nodes and elements. */
static gboolean
check_beam_counts (QnJsonStream *stream, const Draft *draft)
{
  const QnResult *result = &draft->file->result;
  size_t nodes = draft->nodes.items != NULL ? draft->nodes.items->len : 0;
  if (draft->node_displacements.count != result->step_count * nodes * QN_DOF_COUNT)
    return qn_json_stream_fail_at (
      stream, "steps", _ ("there are not as many displacements as nodes in every step"));
  if (draft->beam_force_count > 0
      && draft->beam_force_count != result->step_count * draft->element_count)
    return qn_json_stream_fail_at (
      stream, "steps", _ ("there are not as many beam forces as elements in every step"));
  if (draft->has_mechanism && draft->node_mechanism.count != nodes * QN_DOF_COUNT)
    return qn_json_stream_fail_at (stream, "node_mechanism",
                                   _ ("there are not as many velocities as nodes"));
  return TRUE;
}

/* Everything that counts blocks must count the same. */
static gboolean
check_counts (QnJsonStream *stream, Draft *draft)
{
  const QnResult *result = &draft->file->result;
  size_t blocks = draft->blocks.items->len;
  if (result->step_count > 0 && draft->rows_per_step != blocks * QN_DOF_COUNT)
    return qn_json_stream_fail_at (stream, "steps[0].displacements",
                                   _ ("there are not as many displacements as blocks"));
  if (!qn_result_forces_take (&draft->forces, &draft->file->result))
    return qn_json_stream_fail_at (stream, "steps",
                                   _ ("there are not as many forces as contacts"));
  if (draft->has_mechanism && draft->mechanism.count != blocks * QN_DOF_COUNT)
    return qn_json_stream_fail_at (stream, "mechanism",
                                   _ ("there are not as many velocities as blocks"));
  for (size_t i = 0; i < result->support_count; i++)
    if ((size_t) result->supports[i] >= blocks)
      return qn_json_stream_fail_at (stream, "supports", _ ("there is no such block"));
  if (draft->reactions.count > 0
      && draft->reactions.count
           != result->step_count * result->support_count * QN_DOF_COUNT)
    return qn_json_stream_fail_at (
      stream, "steps", _ ("there are not as many reactions as supports in every step"));
  for (size_t i = 0; i < result->unstable_count; i++)
    if ((size_t) result->unstable_blocks[i] >= blocks)
      return qn_json_stream_fail_at (stream, "unstable_blocks",
                                     _ ("there is no such block"));
  for (size_t i = 0; i < result->pair_count; i++) {
    const QnResultContact *contact = &draft->file->contacts[i];
    if ((size_t) contact->block_a >= blocks || (size_t) contact->block_b >= blocks
        || contact->block_a == contact->block_b) {
      char *path = g_strdup_printf ("contacts[%" G_GSIZE_FORMAT "].blocks", i);
      qn_json_stream_fail_at (stream, path, _ ("there are no such two blocks"));
      g_free (path);
      return FALSE;
    }
  }
  return check_beam_counts (stream, draft);
}

static char **
take_names (Names *names)
{
  if (names->items == NULL)
    return NULL;
  g_ptr_array_add (names->items, NULL);
  return (char **) g_ptr_array_free (g_steal_pointer (&names->items), FALSE);
}

/* Rows of blocks and rows of nodes, step by step, one behind the other. */
static double *
join_rows (QnJsonStream *stream, Rows *blocks, size_t block_count, const Rows *nodes,
           size_t node_count)
{
  if (node_count == 0)
    return g_steal_pointer (&blocks->items);
  const size_t b = block_count * QN_DOF_COUNT, n = node_count * QN_DOF_COUNT;
  const size_t steps = nodes->count / n;
  double *joined = qn_alloc (steps * (b + n), sizeof *joined);
  if (joined == NULL)
    qn_json_stream_no_memory (stream);
  for (size_t i = 0; joined != NULL && i < steps; i++) {
    if (b > 0)
      memcpy (joined + i * (b + n), blocks->items + i * b, b * sizeof *joined);
    memcpy (joined + i * (b + n) + b, nodes->items + i * n, n * sizeof *joined);
  }
  return joined;
}

/* Hands the arrays of a complete draft over to the file; FALSE where memory runs out. */
static gboolean
take_draft (QnJsonStream *stream, Draft *draft)
{
  QnResultFile *file = draft->file;
  QnResult *result = &file->result;
  result->block_count = draft->blocks.items->len;
  file->block_names = take_names (&draft->blocks);
  file->overrides = take_names (&draft->overrides);
  result->node_count = draft->nodes.items != NULL ? draft->nodes.items->len : 0;
  result->element_count = draft->element_count;
  file->node_names = take_names (&draft->nodes);
  result->displacements = join_rows (stream, &draft->displacements, result->block_count,
                                     &draft->node_displacements, result->node_count);
  result->displacement_capacity =
    draft->displacements.count + draft->node_displacements.count;
  result->beam_forces = g_steal_pointer (&draft->beam_forces);
  result->beam_force_capacity = draft->beam_force_capacity;
  result->step_capacity = draft->step_capacity;
  if (draft->has_mechanism)
    result->mechanism = join_rows (stream, &draft->mechanism, result->block_count,
                                   &draft->node_mechanism, result->node_count);
  result->reactions = g_steal_pointer (&draft->reactions.items);
  result->reaction_capacity = draft->reactions.capacity;
  return stream->error == NULL;
}

static void
draft_clear (Draft *draft)
{
  g_free (draft->format);
  g_free (draft->outcome);
  g_clear_pointer (&draft->blocks.items, g_ptr_array_unref);
  g_clear_pointer (&draft->overrides.items, g_ptr_array_unref);
  free (draft->displacements.items);
  free (draft->mechanism.items);
  free (draft->reactions.items);
  qn_result_forces_clear (&draft->forces);
  free (draft->node_displacements.items);
  free (draft->node_mechanism.items);
  free (draft->beam_forces);
  g_clear_pointer (&draft->nodes.items, g_ptr_array_unref);
}

/* `text` is NUL-terminated. */
static gboolean
parse (const char *text, gsize length, const char *name, QnResultFile *file,
       GError **error)
{
  *file = (QnResultFile){ 0 };
  Draft draft = { .file = file };
  QnJsonStream stream;
  qn_json_stream_init (&stream, text, length, name);
  gboolean done = qn_json_stream_document (&stream, read_document, &draft)
                  && check_head (&stream, &draft) && check_counts (&stream, &draft)
                  && take_draft (&stream, &draft);
  if (!done) {
    qn_result_file_clear (file);
    g_propagate_error (error, stream.error);
  }
  draft_clear (&draft);
  return done;
}

gboolean
qn_result_file_read (const char *path, QnResultFile *file, GError **error)
{
  *file = (QnResultFile){ 0 };
  gsize length;
  char *text = qn_file_read (path, &length, error);
  if (text == NULL)
    return FALSE;
  gboolean done = parse (text, length, path, file, error);
  g_free (text);
  return done;
}

gboolean
qn_result_file_parse (const char *text, gsize length, const char *name,
                      QnResultFile *file, GError **error)
{
  char *copy = g_malloc (length + 1);
  if (length > 0)
    memcpy (copy, text, length);
  copy[length] = '\0';
  gboolean done = parse (copy, length, name, file, error);
  g_free (copy);
  return done;
}
