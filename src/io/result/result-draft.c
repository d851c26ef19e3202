#include "io/result/result-draft.h"

#include "core/base/memory.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static gboolean
same_number (double a, double b)
{
  return a == b || (isnan (a) && isnan (b));
}

/* Solutions and bound stand in a file twice, or in older ones once, as fixed points. */
static gboolean
take_solutions (QnJsonStream *stream, QnResultDraft *draft)
{
  QnResult *result = &draft->file.result;
  QnProcedure found_by;
  double least, bound;
  gboolean same = TRUE, older = result->solution_count == 0;
  for (gint32 i = 0; older && i < draft->fixed_point_count; i++)
    qn_result_add_solution (
      result, (QnSolution){ draft->fixed_points[i], QN_PROCEDURE_LIMIT, (double) NAN });
  for (gint32 i = 0; i < draft->fixed_point_count; i++)
    same = same && i < result->solution_count
           && draft->fixed_points[i] == result->solutions[i].multiplier;
  if (!same)
    return qn_json_stream_fail_at (stream, "fixed_points",
                                   _ ("these are not the multipliers of the solutions"));
  if (draft->interval_ends == 0)
    return TRUE;
  if (!result->has_associative_bound && !isnan (draft->interval[1])) {
    result->has_associative_bound = true;
    result->associative_bound = draft->interval[1];
  }
  qn_result_collapse_interval (result, &least, &found_by, &bound);
  if (same_number (draft->interval[0], least) && same_number (draft->interval[1], bound))
    return TRUE;
  return qn_json_stream_fail_at (stream, "collapse_interval",
                                 _ ("this is not the interval from the least solution to "
                                    "the associative bound"));
}

/* The same for nodes and elements. */
static gboolean
check_beam_counts (QnJsonStream *stream, const QnResultDraft *draft)
{
  const QnResult *result = &draft->file.result;
  size_t nodes = draft->nodes.items != NULL ? draft->nodes.items->len : 0;
  if (draft->node_displacements.count != result->step_count * nodes * QN_DOF_COUNT)
    return qn_json_stream_fail_at (
      stream, "steps", _ ("there are not as many displacements as nodes in every step"));
  if (draft->beam_force_count > 0
      && draft->beam_force_count != result->step_count * draft->element_count)
    return qn_json_stream_fail_at (
      stream, "steps", _ ("there are not as many beam forces as elements in every step"));
  gsize ties = draft->tie_names.items != NULL ? draft->tie_names.items->len : 0;
  if (draft->tie_count != result->step_count * ties)
    return qn_json_stream_fail_at (
      stream, "steps", _ ("there are not as many ties in every step as names"));
  if (draft->has_mechanism && draft->node_mechanism.count != nodes * QN_DOF_COUNT)
    return qn_json_stream_fail_at (stream, "node_mechanism",
                                   _ ("there are not as many velocities as nodes"));
  return TRUE;
}

/* Everything that counts blocks must count the same. */
static gboolean
check_counts (QnJsonStream *stream, QnResultDraft *draft)
{
  const QnResult *result = &draft->file.result;
  size_t blocks = draft->blocks.items->len;
  if (result->step_count > 0 && draft->rows_per_step != blocks * QN_DOF_COUNT)
    return qn_json_stream_fail_at (stream, "steps[0].displacements",
                                   _ ("there are not as many displacements as blocks"));
  if (!qn_result_forces_take (&draft->forces, &draft->file.result))
    return qn_json_stream_fail_at (stream, "steps",
                                   _ ("there are not as many forces as contacts"));
  if (draft->has_mechanism && draft->mechanism.count != blocks * QN_DOF_COUNT)
    return qn_json_stream_fail_at (stream, "mechanism",
                                   _ ("there are not as many velocities as blocks"));
  for (size_t i = 0; i < draft->supports.count; i++)
    if ((size_t) draft->supports.items[i] >= blocks)
      return qn_json_stream_fail_at (stream, "supports", _ ("there is no such block"));
  if (draft->reactions.count > 0
      && draft->reactions.count
           != result->step_count * draft->supports.count * QN_DOF_COUNT)
    return qn_json_stream_fail_at (
      stream, "steps", _ ("there are not as many reactions as supports in every step"));
  size_t bodies =
    blocks + (draft->nodes.items != NULL ? (size_t) draft->nodes.items->len : 0);
  if (draft->velocities.count > 0
      && draft->velocities.count != result->step_count * bodies * QN_DOF_COUNT)
    return qn_json_stream_fail_at (
      stream, "steps", _ ("there are not as many velocities as bodies in every step"));
  for (size_t i = 0; i < draft->unstable.count; i++)
    if ((size_t) draft->unstable.items[i] >= blocks)
      return qn_json_stream_fail_at (stream, "unstable_blocks",
                                     _ ("there is no such block"));
  for (size_t i = 0; i < result->event_count; i++)
    for (size_t k = 0; k < result->events[i].block_count; k++)
      if ((size_t) result->events[i].blocks[k] >= blocks)
        return qn_json_stream_fail_at (stream, "events", _ ("there is no such block"));
  for (size_t i = 0; i < result->pair_count; i++) {
    const QnResultContact *contact = &draft->file.contacts[i];
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
take_names (QnResultNames *names)
{
  if (names->items == NULL)
    return NULL;
  g_ptr_array_add (names->items, NULL);
  return (char **) g_ptr_array_free (g_steal_pointer (&names->items), FALSE);
}

/* QnResultRows of blocks and rows of nodes, step by step, one behind the other. */
static double *
join_rows (QnJsonStream *stream, QnResultRows *blocks, size_t block_count,
           const QnResultRows *nodes, size_t node_count)
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
take_arrays (QnJsonStream *stream, QnResultDraft *draft)
{
  QnResultFile *file = &draft->file;
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
  result->tie_count = draft->tie_names.items != NULL ? draft->tie_names.items->len : 0;
  result->ties = g_steal_pointer (&draft->ties);
  result->tie_capacity = draft->tie_capacity;
  result->step_capacity = draft->step_capacity;
  if (draft->has_mechanism)
    result->mechanism = join_rows (stream, &draft->mechanism, result->block_count,
                                   &draft->node_mechanism, result->node_count);
  result->supports = g_steal_pointer (&draft->supports.items);
  result->support_count = draft->supports.count;
  result->unstable_blocks = g_steal_pointer (&draft->unstable.items);
  result->unstable_count = draft->unstable.count;
  result->reactions = g_steal_pointer (&draft->reactions.items);
  result->reaction_capacity = draft->reactions.capacity;
  result->velocities = g_steal_pointer (&draft->velocities.items);
  result->velocity_capacity = draft->velocities.capacity;
  return stream->error == NULL;
}

gboolean
qn_result_draft_take (QnResultDraft *draft, QnJsonStream *stream)
{
  /* Numbers that may be null; what the file says of the first limit point stands,
   * whatever its events. */
  QnResult *result = &draft->file.result;
  result->has_collapse_multiplier = draft->collapse.given;
  result->collapse_multiplier = draft->collapse.number;
  result->has_first_limit_multiplier = draft->first_limit.given;
  result->first_limit_multiplier = draft->first_limit.number;
  result->has_associative_bound = draft->associative_bound.given;
  result->associative_bound = draft->associative_bound.number;
  result->has_broken_bound = draft->broken_bound.given;
  result->broken_bound = draft->broken_bound.number;
  result->beyond_linear_multiplier = draft->beyond_linear.number;
  result->has_unproved_multiplier = draft->unproved.given;
  result->unproved_multiplier = draft->unproved.number;
  return check_counts (stream, draft) && take_arrays (stream, draft)
         && take_solutions (stream, draft)
         && qn_result_history_take (&draft->history, stream, &draft->file.result);
}

void
qn_result_draft_clear (QnResultDraft *draft)
{
  g_clear_pointer (&draft->blocks.items, g_ptr_array_unref);
  g_clear_pointer (&draft->overrides.items, g_ptr_array_unref);
  free (draft->unstable.items);
  free (draft->supports.items);
  free (draft->displacements.items);
  free (draft->mechanism.items);
  free (draft->reactions.items);
  free (draft->velocities.items);
  qn_result_forces_clear (&draft->forces);
  qn_history_draft_clear (&draft->history);
  free (draft->node_displacements.items);
  free (draft->node_mechanism.items);
  free (draft->beam_forces);
  free (draft->ties);
  g_clear_pointer (&draft->tie_names.items, g_ptr_array_unref);
  g_clear_pointer (&draft->nodes.items, g_ptr_array_unref);
}
