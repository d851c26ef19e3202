#include "core/base/integer.h"
#include "core/base/memory.h"
#include "io/project/project-names.h"
#include "io/result/result-draft.h"
#include "io/text/fault-text.h"
#include "io/text/file-read.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define FORMAT_VERSION 1

/* Room for one more item; FALSE with an error where memory runs out. */
static gboolean
grow (QnJsonStream *stream, gpointer array, size_t count, size_t *capacity, size_t size)
{
  return qn_array_reserve (array, capacity, count + 1, size)
         || qn_json_stream_no_memory (stream);
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

/* A number or null. */
static gboolean
read_optional (QnJsonStream *stream, gpointer target)
{
  QnOptionalNumber *optional = target;
  if (stream->scanner.token == QN_JSON_NULL)
    return TRUE;
  optional->given = true;
  return qn_json_stream_number (stream, &optional->number);
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
read_lower_bound (QnJsonStream *stream, gpointer target)
{
  QnLimitFigures *limit = target;
  limit->given = true;
  return qn_json_stream_number (stream, &limit->lower_bound);
}

/* The string at the scanner is one of `names`, whose place among them an enumeration's value is. */
static gboolean
read_word (QnJsonStream *stream, const char *const *names, int count, const char *refusal,
           gpointer target)
{
  if (stream->scanner.token == QN_JSON_STRING)
    for (int i = 0; i < count; i++)
      if (qn_json_string_is (&stream->scanner, names[i])) {
        *(int *) target = i;
        return TRUE;
      }
  return qn_json_stream_fail (stream, refusal);
}

static gboolean
read_outcome (QnJsonStream *stream, gpointer target)
{
  return read_word (stream, qn_outcome_names, QN_OUTCOME_COUNT,
                    _ ("this is not an outcome of an analysis"), target);
}

static gboolean
read_flow (QnJsonStream *stream, gpointer target)
{
  return read_word (stream, qn_flow_names, QN_FLOW_COUNT,
                    _ ("this is not a flow rule of limit analysis"), target);
}

static gboolean
read_procedure (QnJsonStream *stream, gpointer target)
{
  return read_word (stream, qn_procedure_names, QN_PROCEDURE_COUNT,
                    _ ("this is not a procedure of an analysis"), target);
}

/* More than a result keeps is read and left out. */
static gboolean
read_solution (QnJsonStream *stream, gpointer target)
{
  typedef struct SolutionDraft {
    QnSolution solution;
    QnOptionalNumber displacement;
  } SolutionDraft;
  static const QnJsonMember members[] = {
    { "multiplier", qn_json_stream_number, offsetof (SolutionDraft, solution.multiplier),
      QN_JSON_REQUIRED },
    { "found_by", read_procedure, offsetof (SolutionDraft, solution.found_by),
      QN_JSON_REQUIRED },
    { "displacement", read_optional, offsetof (SolutionDraft, displacement),
      QN_JSON_OPTIONAL },
  };
  SolutionDraft draft = { 0 };
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &draft))
    return FALSE;
  draft.solution.displacement =
    draft.displacement.given ? draft.displacement.number : (double) NAN;
  qn_result_add_solution (target, draft.solution);
  return TRUE;
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
read_interval_end (QnJsonStream *stream, gpointer target)
{
  QnResultDraft *draft = target;
  QnOptionalNumber optional = { false, (double) NAN };
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
  *(QnLinearity *) target = beyond ? QN_LINEARITY_BEYOND : QN_LINEARITY_HOLDS;
  return TRUE;
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
read_tie_state (QnJsonStream *stream, gpointer target)
{
  return read_word (stream, qn_tie_state_names, QN_TIE_STATE_COUNT,
                    _ ("this is not a state of a tie"), target);
}

static gboolean
read_tie (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "force", qn_json_stream_number, offsetof (QnTieResult, force), QN_JSON_REQUIRED },
    { "elongation", qn_json_stream_number, offsetof (QnTieResult, elongation),
      QN_JSON_REQUIRED },
    { "state", read_tie_state, offsetof (QnTieResult, state), QN_JSON_REQUIRED },
  };
  QnResultDraft *draft = target;
  QnTieResult tie = { 0 };
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &tie)
      || !grow (stream, &draft->ties, draft->tie_count, &draft->tie_capacity,
                sizeof *draft->ties))
    return FALSE;
  draft->ties[draft->tie_count++] = tie;
  return TRUE;
}

/* Only how many there are is of interest: which they are is the model's knowledge. */
static gboolean
read_element (QnJsonStream *stream, gpointer target)
{
  double numbers[3];
  ((QnResultDraft *) target)->element_count++;
  return qn_json_stream_numbers (stream, numbers, G_N_ELEMENTS (numbers));
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
read_step (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "multiplier", qn_json_stream_number, offsetof (QnResultDraft, step.multiplier),
      QN_JSON_REQUIRED },
    { "displacements", read_row, offsetof (QnResultDraft, displacements),
      QN_JSON_REQUIRED | QN_JSON_EACH },
    { "iterations", qn_json_stream_int32, offsetof (QnResultDraft, step.iterations),
      QN_JSON_OPTIONAL },
    { "residual", qn_json_stream_number, offsetof (QnResultDraft, step.residual),
      QN_JSON_OPTIONAL },
    { "event", read_event, offsetof (QnResultDraft, step.event), QN_JSON_OPTIONAL },
    { "stage", read_stage, offsetof (QnResultDraft, step.stage), QN_JSON_OPTIONAL },
    { "relaxed", read_true, offsetof (QnResultDraft, step.relaxed), QN_JSON_OPTIONAL },
    { "time", qn_json_stream_number, offsetof (QnResultDraft, step.time),
      QN_JSON_OPTIONAL },
    { "velocities", read_row, offsetof (QnResultDraft, velocities), QN_JSON_EACH },
    { "reactions", read_row, offsetof (QnResultDraft, reactions), QN_JSON_EACH },
    { "forces", qn_result_force_read, offsetof (QnResultDraft, forces), QN_JSON_EACH },
    { "states", qn_result_states_read, offsetof (QnResultDraft, forces),
      QN_JSON_OPTIONAL },
    { "damage", qn_result_damage_read, offsetof (QnResultDraft, forces), QN_JSON_EACH },
    { "node_displacements", read_row, offsetof (QnResultDraft, node_displacements),
      QN_JSON_EACH },
    { "beam_forces", read_element_forces, 0, QN_JSON_EACH },
    { "ties", read_tie, 0, QN_JSON_EACH },
  };
  QnResultDraft *draft = target;
  QnResult *result = &draft->file.result;
  size_t before = draft->displacements.count, ties = draft->tie_count;
  draft->step = (QnStep){ 0 };
  draft->forces.step = result->step_count;
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), draft)
      || !grow (stream, &result->steps, result->step_count, &draft->step_capacity,
                sizeof *result->steps))
    return FALSE;

  /* A step may leave them out. */
  gsize names = draft->tie_names.items != NULL ? draft->tie_names.items->len : 0;
  for (gsize i = 0; draft->tie_count == ties + i && i < names; i++) {
    if (!grow (stream, &draft->ties, draft->tie_count, &draft->tie_capacity,
               sizeof *draft->ties))
      return FALSE;
    draft->ties[draft->tie_count++] =
      (QnTieResult){ .force = (double) NAN, .elongation = (double) NAN };
  }
  size_t rows = draft->displacements.count - before;
  if (result->step_count == 0)
    draft->rows_per_step = rows;
  result->steps[result->step_count++] = draft->step;
  return rows == draft->rows_per_step
         || qn_json_stream_fail (stream,
                                 _ ("step has displacements of another number of blocks "
                                    "than the first"));
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
  return read_word (stream, qn_pair_state_names, QN_PAIR_STATE_COUNT,
                    _ ("this is not a state of a contact pair"), target);
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
    { "face", qn_json_stream_int32, offsetof (ContactDraft, contact.face),
      QN_JSON_REQUIRED },
    { "blocks", read_contact_blocks, offsetof (ContactDraft, blocks), QN_JSON_REQUIRED },
    { "point", read_vec2, offsetof (ContactDraft, contact.point), QN_JSON_REQUIRED },
    { "normal", read_normal, offsetof (ContactDraft, contact.normal), QN_JSON_REQUIRED },
    { "area", qn_json_stream_number, offsetof (ContactDraft, contact.area),
      QN_JSON_OPTIONAL },
    { "bar", qn_json_stream_int32, offsetof (ContactDraft, contact.bar),
      QN_JSON_OPTIONAL },
    { "state", read_state, offsetof (ContactDraft, pair.state), QN_JSON_REQUIRED },
    { "normal_force", qn_json_stream_number, offsetof (ContactDraft, pair.normal_force),
      QN_JSON_REQUIRED },
    { "shear_force", qn_json_stream_number, offsetof (ContactDraft, pair.shear_force),
      QN_JSON_REQUIRED },
    { "damage", qn_json_stream_number, offsetof (ContactDraft, pair.damage),
      QN_JSON_OPTIONAL },
  };
  QnResultDraft *draft = target;
  QnResultFile *file = &draft->file;
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
read_mechanism (QnJsonStream *stream, gpointer target)
{
  QnResultDraft *draft = target;
  if (stream->scanner.token == QN_JSON_NULL)
    return TRUE;
  draft->has_mechanism = TRUE;
  return qn_json_stream_array (stream, read_row, &draft->mechanism);
}

static gboolean
read_id (QnJsonStream *stream, gpointer target)
{
  QnResultIds *ids = target;
  if (!grow (stream, &ids->items, ids->count, &ids->capacity, sizeof *ids->items)
      || !qn_json_stream_int32 (stream, &ids->items[ids->count]))
    return FALSE;
  ids->count++;
  return TRUE;
}

static gboolean
read_event_kind (QnJsonStream *stream, gpointer target)
{
  return read_word (stream, qn_event_kind_names, QN_EVENT_KIND_COUNT,
                    _ ("expected \"local\", \"snap\" or \"collapse\""), target);
}

static gboolean
read_path_event (QnJsonStream *stream, gpointer target)
{
  typedef struct EventDraft {
    QnPathEvent event;
    QnResultIds blocks;
  } EventDraft;
  static const QnJsonMember members[] = {
    { "multiplier", qn_json_stream_number, offsetof (EventDraft, event.multiplier),
      QN_JSON_REQUIRED },
    { "kind", read_event_kind, offsetof (EventDraft, event.kind), QN_JSON_REQUIRED },
    { "stage", read_stage, offsetof (EventDraft, event.stage), QN_JSON_OPTIONAL },
    { "displacement_before", qn_json_stream_number,
      offsetof (EventDraft, event.displacement_before), QN_JSON_REQUIRED },
    { "displacement_after", qn_json_stream_number,
      offsetof (EventDraft, event.displacement_after), QN_JSON_REQUIRED },
    { "energy", qn_json_stream_number, offsetof (EventDraft, event.energy),
      QN_JSON_REQUIRED },
    { "blocks", read_id, offsetof (EventDraft, blocks), QN_JSON_REQUIRED | QN_JSON_EACH },
  };
  EventDraft draft = { 0 };
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &draft)) {
    free (draft.blocks.items);
    return FALSE;
  }
  draft.event.blocks = draft.blocks.items;
  draft.event.block_count = draft.blocks.count;
  return qn_result_add_event (target, draft.event) || qn_json_stream_no_memory (stream);
}

static gboolean
read_events (QnJsonStream *stream, gpointer target)
{
  QnResult *result = target;
  result->events_unknown = false;
  return qn_json_stream_array (stream, read_path_event, result);
}

static gboolean
read_claim (QnJsonStream *stream, gpointer target)
{
  g_autofree char *name = NULL;
  if (!qn_json_stream_string (stream, &name))
    return FALSE;
  *(QnClaim *) target = qn_claim_from_name (name);
  return *(QnClaim *) target < QN_CLAIM_COUNT
         || qn_json_stream_fail (stream, _ ("unknown kind of claim"));
}

static gboolean
read_step_or_none (QnJsonStream *stream, gpointer target)
{
  double number;
  if (!qn_json_stream_number (stream, &number))
    return FALSE;
  *(QnId *) target = number < 0 ? QN_NONE : (QnId) qn_to_integer (number, 0, INT32_MAX);
  return TRUE;
}

static gboolean
read_refused (QnJsonStream *stream, gpointer target)
{
  typedef struct RefusedDraft {
    QnFault fault;
    QnOptionalNumber stated, found;
    QnId pair, block, node, beam, tie, event;
  } RefusedDraft;
  static const QnJsonMember members[] = {
    { "claim", read_claim, offsetof (RefusedDraft, fault.claim), QN_JSON_REQUIRED },
    { "step", read_step_or_none, offsetof (RefusedDraft, fault.step), QN_JSON_REQUIRED },
    { "pair", qn_json_stream_int32, offsetof (RefusedDraft, pair), QN_JSON_OPTIONAL },
    { "block", qn_json_stream_int32, offsetof (RefusedDraft, block), QN_JSON_OPTIONAL },
    { "node", qn_json_stream_int32, offsetof (RefusedDraft, node), QN_JSON_OPTIONAL },
    { "beam", qn_json_stream_int32, offsetof (RefusedDraft, beam), QN_JSON_OPTIONAL },
    { "tie", qn_json_stream_int32, offsetof (RefusedDraft, tie), QN_JSON_OPTIONAL },
    { "event", qn_json_stream_int32, offsetof (RefusedDraft, event), QN_JSON_OPTIONAL },
    { "stated", read_optional, offsetof (RefusedDraft, stated), QN_JSON_OPTIONAL },
    { "found", read_optional, offsetof (RefusedDraft, found), QN_JSON_OPTIONAL },
  };
  QnResult *result = target;
  RefusedDraft read = { .pair = QN_NONE,
                        .block = QN_NONE,
                        .node = QN_NONE,
                        .beam = QN_NONE,
                        .tie = QN_NONE,
                        .event = QN_NONE };
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &read))
    return FALSE;
  const struct {
    QnEntity entity;
    QnId index;
  } places[] = { { QN_ENTITY_CONTACT, read.pair }, { QN_ENTITY_BLOCK, read.block },
                 { QN_ENTITY_NODE, read.node },    { QN_ENTITY_BEAM, read.beam },
                 { QN_ENTITY_TIE, read.tie },      { QN_ENTITY_ANALYSIS, read.event } };
  read.fault.entity = QN_ENTITY_MODEL;
  read.fault.index = QN_NONE;
  for (gsize i = 0; i < G_N_ELEMENTS (places); i++)
    if (places[i].index != QN_NONE) {
      read.fault.entity = places[i].entity;
      read.fault.index = places[i].index;
    }
  read.fault.stated = read.stated.given ? read.stated.number : (double) NAN;
  read.fault.found = read.found.given ? read.found.number : (double) NAN;
  if (result->refused_count < QN_CLAIM_COUNT)
    result->refused[result->refused_count++] = read.fault;
  return TRUE;
}

static gboolean
read_vibration (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "dead_load", read_true, offsetof (QnVibration, dead_load), QN_JSON_REQUIRED },
    { "mode", qn_json_stream_int32, offsetof (QnVibration, mode), QN_JSON_REQUIRED },
    { "omega", qn_json_stream_number, offsetof (QnVibration, omega), QN_JSON_REQUIRED },
    { "sliding", read_true, offsetof (QnVibration, sliding), QN_JSON_OPTIONAL },
  };
  QnVibration *vibration = target;
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), target))
    return FALSE;
  /* Counted from 1, and 0 where none is told: what says 0 is compared with the first. */
  vibration->mode = MAX (vibration->mode, 1);
  return TRUE;
}

static gboolean
read_stability (QnJsonStream *stream, gpointer target)
{
  return read_word (stream, qn_stability_names, QN_STABILITY_COUNT,
                    _ ("expected \"kept\" or \"lost\""), target);
}

static gboolean
read_statistics (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = {
    { "seconds", qn_json_stream_number, offsetof (QnStatistics, seconds),
      QN_JSON_OPTIONAL },
    { "factor_seconds", qn_json_stream_number, offsetof (QnStatistics, factor_seconds),
      QN_JSON_OPTIONAL },
    { "assembly_seconds", qn_json_stream_number,
      offsetof (QnStatistics, assembly_seconds), QN_JSON_OPTIONAL },
    { "law_seconds", qn_json_stream_number, offsetof (QnStatistics, law_seconds),
      QN_JSON_OPTIONAL },
    { "iterations", qn_json_stream_int32, offsetof (QnStatistics, iterations),
      QN_JSON_OPTIONAL },
    { "factorizations", qn_json_stream_int32, offsetof (QnStatistics, factorizations),
      QN_JSON_OPTIONAL },
    { "peak_memory_bytes", qn_json_stream_int64,
      offsetof (QnStatistics, peak_memory_bytes), QN_JSON_OPTIONAL },
  };
  return qn_json_stream_object (stream, members, G_N_ELEMENTS (members), target);
}

/* What is not a result is told so at its first line, before its members are. */
static gboolean
read_format (QnJsonStream *stream, gpointer target)
{
  (void) target;
  return (stream->scanner.token == QN_JSON_STRING
          && qn_json_string_is (&stream->scanner, "quoin-result"))
         || qn_json_stream_fail (stream,
                                 _ ("this is not a result: expected \"quoin-result\""));
}

static gboolean
read_version (QnJsonStream *stream, gpointer target)
{
  gint32 version;
  (void) target;
  if (!qn_json_stream_int32 (stream, &version))
    return FALSE;
  if (version == FORMAT_VERSION)
    return TRUE;
  g_autofree char *reason = g_strdup_printf (
    _ ("this program reads version %d of the format only"), FORMAT_VERSION);
  return qn_json_stream_fail (stream, reason);
}

static gboolean
read_document (QnJsonStream *stream, gpointer target)
{
#define OF(member)     offsetof (QnResultDraft, member)
#define RESULT(member) offsetof (QnResultDraft, file.result.member)
  static const QnJsonMember members[] = {
    { "format", read_format, 0, QN_JSON_REQUIRED },
    { "version", read_version, 0, QN_JSON_REQUIRED },
    { "generator", qn_json_stream_string, OF (file.generator), QN_JSON_OPTIONAL },
    { "model", qn_json_stream_string, OF (file.model), QN_JSON_OPTIONAL },
    { "model_sha256", qn_json_stream_string, OF (file.model_sha256), QN_JSON_OPTIONAL },
    { "overrides", read_names, OF (overrides), QN_JSON_OPTIONAL },
    { "outcome", read_outcome, RESULT (outcome), QN_JSON_REQUIRED },
    { "collapse_multiplier", read_optional, OF (collapse), QN_JSON_OPTIONAL },
    { "first_limit_multiplier", read_optional, OF (first_limit), QN_JSON_OPTIONAL },
    { "events", read_events, OF (file.result), QN_JSON_OPTIONAL },
    { "lower_bound", read_lower_bound, RESULT (limit), QN_JSON_OPTIONAL },
    { "upper_bound", qn_json_stream_number, RESULT (limit.upper_bound),
      QN_JSON_OPTIONAL },
    { "flow", read_flow, RESULT (limit.flow), QN_JSON_OPTIONAL },
    { "associative_bound", read_optional, OF (associative_bound), QN_JSON_OPTIONAL },
    { "broken_bond_bound", read_optional, OF (broken_bound), QN_JSON_OPTIONAL },
    { "fixed_points", read_fixed_point, 0, QN_JSON_EACH },
    { "solutions", read_solution, OF (file.result), QN_JSON_EACH },
    { "collapse_interval", read_interval, 0, QN_JSON_OPTIONAL },
    { "beyond_linear", read_beyond_linear, RESULT (linearity), QN_JSON_OPTIONAL },
    { "beyond_linear_multiplier", read_optional, OF (beyond_linear), QN_JSON_OPTIONAL },
    { "unstable_blocks", read_id, OF (unstable), QN_JSON_EACH },
    { "supports", read_id, OF (supports), QN_JSON_EACH },
    { "stage", read_stage, RESULT (stage), QN_JSON_OPTIONAL },
    { "unproved_multiplier", read_optional, OF (unproved), QN_JSON_OPTIONAL },
    { "refused", read_refused, OF (file.result), QN_JSON_EACH },
    { "blocks", read_names, OF (blocks), QN_JSON_REQUIRED },
    { "nodes", read_names, OF (nodes), QN_JSON_OPTIONAL },
    { "elements", read_element, 0, QN_JSON_EACH },
    { "ties", read_names, OF (tie_names), QN_JSON_OPTIONAL },
    { "steps", read_step, 0, QN_JSON_REQUIRED | QN_JSON_EACH },
    { "contacts", read_contact, 0, QN_JSON_REQUIRED | QN_JSON_EACH },
    { "vibration", read_vibration, RESULT (vibration), QN_JSON_OPTIONAL },
    { "stability", read_stability, RESULT (stability), QN_JSON_OPTIONAL },
    { "mechanism", read_mechanism, 0, QN_JSON_OPTIONAL },
    { "mechanism_uncertain", read_true, RESULT (mechanism_uncertain), QN_JSON_OPTIONAL },
    { "mechanism_by_work", read_true, RESULT (mechanism_by_work), QN_JSON_OPTIONAL },
    { "node_mechanism", read_row, OF (node_mechanism), QN_JSON_EACH },
    { "history", qn_result_history_read, OF (history), QN_JSON_OPTIONAL },
    { "found", qn_result_found_read, OF (history), QN_JSON_EACH },
    { "left", qn_result_left_read, OF (history), QN_JSON_EACH },
    { "timings", read_statistics, RESULT (statistics), QN_JSON_OPTIONAL },
    { "statistics", read_statistics, RESULT (statistics), QN_JSON_OPTIONAL },
  };
#undef OF
#undef RESULT
  return qn_json_stream_object (stream, members, G_N_ELEMENTS (members), target);
}

/* `text` is NUL-terminated. */
static gboolean
parse (const char *text, gsize length, const char *name, QnResultFile *file,
       GError **error)
{
  QnResultDraft draft = { .file.result.events_unknown = true };
  QnJsonStream stream;
  qn_json_stream_init (&stream, text, length, name);
  gboolean done = qn_json_stream_document (&stream, read_document, &draft)
                  && qn_result_draft_take (&draft, &stream);
  if (!done) {
    qn_result_file_clear (&draft.file);
    g_propagate_error (error, stream.error);
  }
  *file = draft.file;
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
