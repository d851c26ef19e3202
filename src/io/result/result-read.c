#include "core/base/integer.h"
#include "core/base/memory.h"
#include "io/project/project-names.h"
#include "io/result/result-draft.h"
#include "io/text/file-read.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
  QnResultRows *rows = target;
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
  QnResultNames *names = target;
  char *name = NULL;
  if (!qn_json_stream_string (stream, &name))
    return FALSE;
  g_ptr_array_add (names->items, name);
  return TRUE;
}

static gboolean
read_names (QnJsonStream *stream, gpointer target)
{
  QnResultNames *names = target;
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
  QnResult *result = &((QnResultDraft *) target)->file->result;
  Optional optional = { false, 0 };
  gboolean done = read_optional (stream, &optional);
  result->has_collapse_multiplier = optional.given;
  result->collapse_multiplier = optional.number;
  return done;
}

static gboolean
read_first_limit (QnJsonStream *stream, gpointer target)
{
  QnResult *result = &((QnResultDraft *) target)->file->result;
  Optional optional = { false, 0 };
  gboolean done = read_optional (stream, &optional);
  result->has_first_limit_multiplier = optional.given;
  result->first_limit_multiplier = optional.number;
  return done;
}

/* Only written where it is true. */
static gboolean
read_true (QnJsonStream *stream, gpointer target)
{
  *(bool *) target = stream->scanner.token == QN_JSON_TRUE;
  return *(bool *) target || stream->scanner.token == QN_JSON_FALSE
         || qn_json_stream_fail (stream, _ ("expected true or false"));
}

static gboolean
read_uncertain (QnJsonStream *stream, gpointer target)
{
  QnResult *result = &((QnResultDraft *) target)->file->result;
  return read_true (stream, &result->mechanism_uncertain);
}

static QnLimitFigures *
limit_figures (gpointer target)
{
  return &((QnResultDraft *) target)->file->result.limit;
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
        && qn_json_string_is (&stream->scanner, qn_flow_names[flow])) {
      limit_figures (target)->flow = (QnFlow) flow;
      return TRUE;
    }
  return qn_json_stream_fail (stream, _ ("this is no flow rule of limit analysis"));
}

static gboolean
read_associative_bound (QnJsonStream *stream, gpointer target)
{
  QnResult *result = &((QnResultDraft *) target)->file->result;
  Optional optional = { false, 0 };
  gboolean done = read_optional (stream, &optional);
  result->has_associative_bound = optional.given;
  result->associative_bound = optional.number;
  return done;
}

static gboolean
read_procedure (QnJsonStream *stream, gpointer target)
{
  for (int i = 0; i < QN_PROCEDURE_COUNT; i++)
    if (stream->scanner.token == QN_JSON_STRING
        && qn_json_string_is (&stream->scanner, qn_procedure_names[i])) {
      *(QnProcedure *) target = (QnProcedure) i;
      return TRUE;
    }
  return qn_json_stream_fail (stream, _ ("this is no procedure of an analysis"));
}

/* More than a result keeps is read and left out. */
static gboolean
read_solution (QnJsonStream *stream, gpointer target)
{
  typedef struct SolutionDraft {
    QnSolution solution;
    Optional displacement;
  } SolutionDraft;
  static const QnJsonMember members[] = {
    { "multiplier", qn_json_stream_number, offsetof (SolutionDraft, solution.multiplier),
      TRUE },
    { "found_by", read_procedure, offsetof (SolutionDraft, solution.found_by), TRUE },
    { "displacement", read_optional, offsetof (SolutionDraft, displacement), FALSE },
  };
  SolutionDraft draft = { 0 };
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &draft))
    return FALSE;
  draft.solution.displacement =
    draft.displacement.given ? draft.displacement.number : (double) NAN;
  qn_result_add_solution (&((QnResultDraft *) target)->file->result, draft.solution);
  return TRUE;
}

static gboolean
read_solutions (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_solution, target);
}

static gboolean
read_fixed_point (QnJsonStream *stream, gpointer target)
{
  QnResultDraft *draft = target;
  double number;
  if (!qn_json_stream_number (stream, &number))
    return FALSE;
  if (draft->fixed_point_count < QN_RESULT_SOLUTIONS)
    draft->fixed_points[draft->fixed_point_count++] = number;
  return TRUE;
}

static gboolean
read_fixed_points (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_fixed_point, target);
}

static gboolean
read_interval_end (QnJsonStream *stream, gpointer target)
{
  QnResultDraft *draft = target;
  Optional optional = { false, (double) NAN };
  if (draft->interval_ends == 2)
    return qn_json_stream_fail (stream, _ ("expected two numbers or null"));
  if (!read_optional (stream, &optional))
    return FALSE;
  draft->interval[draft->interval_ends++] = optional.number;
  return TRUE;
}

static gboolean
read_interval (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_interval_end, target)
         && (((QnResultDraft *) target)->interval_ends == 2
             || qn_json_stream_fail (stream, _ ("expected two numbers or null")));
}

static gboolean
read_beyond_linear (QnJsonStream *stream, gpointer target)
{
  bool beyond;
  if (!read_true (stream, &beyond))
    return FALSE;
  ((QnResultDraft *) target)->file->result.linearity =
    beyond ? QN_LINEARITY_BEYOND : QN_LINEARITY_HOLDS;
  return TRUE;
}

static gboolean
read_beyond_multiplier (QnJsonStream *stream, gpointer target)
{
  Optional optional = { false, 0 };
  gboolean done = read_optional (stream, &optional);
  ((QnResultDraft *) target)->file->result.beyond_linear_multiplier = optional.number;
  return done;
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
  QnResultRows *displacements, *reactions, *node_displacements;
  QnStepForces *forces;
  QnResultDraft *draft;
} StepDraft;

/* N, V, M at the first and the second end of an element. */
static gboolean
read_element_forces (QnJsonStream *stream, gpointer target)
{
  QnResultDraft *draft = target;
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
  return qn_json_stream_array (stream, read_element_forces, *(QnResultDraft **) target);
}

/* Only how many there are is of interest: which they are is the model's knowledge. */
static gboolean
read_element (QnJsonStream *stream, gpointer target)
{
  double numbers[3];
  ((QnResultDraft *) target)->element_count++;
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
  return qn_json_stream_array (stream, read_row,
                               &((QnResultDraft *) target)->node_mechanism);
}

/* Number of a stage, which the file counts from 0. */
static gboolean
read_stage (QnJsonStream *stream, gpointer target)
{
  int32_t *stage = target;
  if (!qn_json_stream_int32 (stream, stage))
    return FALSE;
  if (*stage >= QN_MAX_STAGES)
    return qn_json_stream_fail (stream, _ ("there is no such stage"));
  ++*stage;
  return TRUE;
}

static gboolean
read_step_displacements (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_row, *(QnResultRows **) target);
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
    { "relaxed", read_true, offsetof (StepDraft, step.relaxed), FALSE },
    { "time", qn_json_stream_number, offsetof (StepDraft, step.time), FALSE },
    { "reactions", read_step_displacements, offsetof (StepDraft, reactions), FALSE },
    { "forces", qn_result_forces_read, offsetof (StepDraft, forces), FALSE },
    { "states", qn_result_states_read, offsetof (StepDraft, forces), FALSE },
    { "node_displacements", read_step_displacements,
      offsetof (StepDraft, node_displacements), FALSE },
    { "beam_forces", read_step_beam_forces, offsetof (StepDraft, draft), FALSE },
  };
  QnResultDraft *draft = target;
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
      if (qn_json_string_is (&stream->scanner, qn_pair_state_names[state])) {
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
    blocks[i] = (QnId) qn_to_integer (numbers[i], 0, QN_MAX_BLOCKS - 1);
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
  QnResultDraft *draft = target;
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
  QnResultDraft *draft = target;
  if (stream->scanner.token == QN_JSON_NULL)
    return TRUE;
  draft->has_mechanism = TRUE;
  return qn_json_stream_array (stream, read_row, &draft->mechanism);
}

static gboolean
read_unstable_block (QnJsonStream *stream, gpointer target)
{
  QnResultDraft *draft = target;
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
  QnResultDraft *draft = target;
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
read_event_kind (QnJsonStream *stream, gpointer target)
{
  QnEventKind *kind = target;
  if (stream->scanner.token == QN_JSON_STRING)
    for (int i = 0; i < QN_EVENT_KIND_COUNT; i++)
      if (qn_json_string_is (&stream->scanner, qn_event_kind_name ((QnEventKind) i))) {
        *kind = (QnEventKind) i;
        return TRUE;
      }
  return qn_json_stream_fail (stream, _ ("expected \"local\", \"snap\" or \"collapse\""));
}

/* An event with room for its blocks. */
typedef struct EventDraft {
  QnPathEvent event;
  size_t capacity;
} EventDraft;

static gboolean
read_event_block (QnJsonStream *stream, gpointer target)
{
  EventDraft *draft = target;
  QnPathEvent *event = &draft->event;
  if (!grow (stream, &event->blocks, event->block_count, &draft->capacity,
             sizeof *event->blocks)
      || !qn_json_stream_int32 (stream, &event->blocks[event->block_count]))
    return FALSE;
  event->block_count++;
  return TRUE;
}

static gboolean
read_event_blocks (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_event_block, target);
}

static gboolean
read_path_event (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "multiplier", qn_json_stream_number, offsetof (EventDraft, event.multiplier),
      TRUE },
    { "kind", read_event_kind, offsetof (EventDraft, event.kind), TRUE },
    { "stage", read_stage, offsetof (EventDraft, event.stage), FALSE },
    { "displacement_before", qn_json_stream_number,
      offsetof (EventDraft, event.displacement_before), TRUE },
    { "displacement_after", qn_json_stream_number,
      offsetof (EventDraft, event.displacement_after), TRUE },
    { "energy", qn_json_stream_number, offsetof (EventDraft, event.energy), TRUE },
    { "blocks", read_event_blocks, 0, TRUE },
  };
  QnResult *result = &((QnResultDraft *) target)->file->result;
  EventDraft draft = { 0 };
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &draft)) {
    free (draft.event.blocks);
    return FALSE;
  }
  /* What the file says of the first limit point stands. */
  bool given = result->has_first_limit_multiplier;
  double first_limit = result->first_limit_multiplier;
  bool added = qn_result_add_event (result, draft.event);
  result->has_first_limit_multiplier = given;
  result->first_limit_multiplier = first_limit;
  return added || qn_json_stream_no_memory (stream);
}

static gboolean
read_events (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_array (stream, read_path_event, target);
}

static gboolean
read_end_stage (QnJsonStream *stream, gpointer target)
{
  return read_stage (stream, &((QnResultDraft *) target)->file->result.stage);
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
  QnResultDraft *draft = target;
  return qn_json_stream_object (stream, members, G_N_ELEMENTS (members),
                                &draft->file->result.statistics);
}

static gboolean
read_generator (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_string (stream, &((QnResultDraft *) target)->file->generator);
}

static gboolean
read_model (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_string (stream, &((QnResultDraft *) target)->file->model);
}

static gboolean
read_sha256 (QnJsonStream *stream, gpointer target)
{
  return qn_json_stream_string (stream, &((QnResultDraft *) target)->file->model_sha256);
}

static gboolean
read_document (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "format", qn_json_stream_string, offsetof (QnResultDraft, format), TRUE },
    { "version", qn_json_stream_int32, offsetof (QnResultDraft, version), TRUE },
    { "generator", read_generator, 0, FALSE },
    { "model", read_model, 0, FALSE },
    { "model_sha256", read_sha256, 0, FALSE },
    { "overrides", read_names, offsetof (QnResultDraft, overrides), FALSE },
    { "outcome", qn_json_stream_string, offsetof (QnResultDraft, outcome), TRUE },
    { "collapse_multiplier", read_collapse, 0, FALSE },
    { "first_limit_multiplier", read_first_limit, 0, FALSE },
    { "events", read_events, 0, FALSE },
    { "lower_bound", read_lower_bound, 0, FALSE },
    { "upper_bound", read_upper_bound, 0, FALSE },
    { "flow", read_flow, 0, FALSE },
    { "associative_bound", read_associative_bound, 0, FALSE },
    { "fixed_points", read_fixed_points, 0, FALSE },
    { "solutions", read_solutions, 0, FALSE },
    { "collapse_interval", read_interval, 0, FALSE },
    { "beyond_linear", read_beyond_linear, 0, FALSE },
    { "beyond_linear_multiplier", read_beyond_multiplier, 0, FALSE },
    { "unstable_blocks", read_unstable, 0, FALSE },
    { "supports", read_supports, 0, FALSE },
    { "stage", read_end_stage, 0, FALSE },
    { "blocks", read_names, offsetof (QnResultDraft, blocks), TRUE },
    { "nodes", read_names, offsetof (QnResultDraft, nodes), FALSE },
    { "elements", read_elements, 0, FALSE },
    { "steps", read_steps, 0, TRUE },
    { "contacts", read_contacts, 0, TRUE },
    { "mechanism", read_mechanism, 0, FALSE },
    { "mechanism_uncertain", read_uncertain, 0, FALSE },
    { "node_mechanism", read_node_mechanism, 0, FALSE },
    { "history", qn_result_history_read, offsetof (QnResultDraft, history), FALSE },
    { "timings", read_statistics, 0, FALSE },
    { "statistics", read_statistics, 0, FALSE },
  };
  return qn_json_stream_object (stream, members, G_N_ELEMENTS (members), target);
}

/* `text` is NUL-terminated. */
static gboolean
parse (const char *text, gsize length, const char *name, QnResultFile *file,
       GError **error)
{
  *file = (QnResultFile){ 0 };
  QnResultDraft draft = { .file = file };
  QnJsonStream stream;
  qn_json_stream_init (&stream, text, length, name);
  gboolean done = qn_json_stream_document (&stream, read_document, &draft)
                  && qn_result_draft_take (&draft, &stream);
  if (!done) {
    qn_result_file_clear (file);
    g_propagate_error (error, stream.error);
  }
  qn_result_draft_clear (&draft);
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
