#include "io/result/result-file.h"

#include "core/result/result-contact.h"
#include "io/json/json-value.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void
qn_result_file_clear (QnResultFile *file)
{
  g_free (file->generator);
  g_free (file->model);
  g_free (file->model_sha256);
  g_strfreev (file->overrides);
  g_strfreev (file->block_names);
  g_strfreev (file->node_names);
  free (file->contacts);
  qn_result_clear (&file->result);
  *file = (QnResultFile){ 0 };
}

static gboolean
fail (GError **error, const char *name, const char *message)
{
  return qn_io_fail (error, QN_IO_ERROR_INVALID, "%s: %s", name, message);
}

static gboolean
match_beams (const QnResultFile *file, const char *name, const QnModel *model,
             GError **error)
{
  gboolean same = file->result.node_count == model->node_count
                  && file->result.element_count == model->element_count;
  for (size_t i = 0; same && i < model->node_count; i++)
    same = strcmp (file->node_names[i], model->nodes[i].name) == 0;
  return same
         || fail (error, name, _ ("the result is of another model: it has other beams"));
}

static gboolean
match_blocks (const QnResultFile *file, const char *name, const QnModel *model,
              GError **error)
{
  if (file->result.block_count != model->block_count)
    return fail (error, name, _ ("the result is of another model: it has other blocks"));
  for (size_t i = 0; i < model->block_count; i++) {
    if (strcmp (file->block_names[i], model->blocks[i].name) != 0)
      return fail (error, name,
                   _ ("the result is of another model: its blocks have other names"));
  }
  return match_beams (file, name, model, error)
         && (qn_result_found_exist (&file->result, model)
             || fail (error, name,
                      _ ("the result is of another model: it has found other contacts")));
}

static gboolean
match_contacts (const QnResultFile *file, const char *name, const QnContacts *contacts,
                GError **error)
{
  /* Without any equilibrium there are no contacts to compare. */
  if (file->result.pair_count == 0)
    return TRUE;
  gboolean same = file->result.pair_count == contacts->pair_count;
  for (size_t i = 0; same && i < contacts->pair_count; i++) {
    const QnResultContact *contact = &file->contacts[i];
    const QnContactFace *face = &contacts->faces[contacts->pairs[i].face];
    same = contact->face == contacts->pairs[i].face && contact->blocks[0] == face->a
           && contact->blocks[1] == face->b && contact->bar == contacts->pairs[i].bar;
  }
  return same
         || fail (error, name,
                  _ ("the result is of another model: it has other contacts"));
}

gboolean
qn_result_file_match (const QnResultFile *file, const char *name,
                      const QnProject *project, const QnContacts *contacts,
                      gboolean *same_bytes, GError **error)
{
  if (same_bytes != NULL)
    *same_bytes = g_strcmp0 (file->model_sha256, project->sha256) == 0;
  return match_blocks (file, name, &project->model, error)
         && (contacts == NULL || match_contacts (file, name, contacts, error));
}

static gboolean
check_hash (const QnResultFile *file, const char *name, const QnProject *project,
            GError **error)
{
  if (g_strcmp0 (file->model_sha256, project->sha256) == 0)
    return TRUE;
  g_autofree char *message = g_strdup_printf (
    _ ("this was computed from another project than %s, which has the SHA-256 %s instead "
       "of %s"),
    project->name, project->sha256 != NULL ? project->sha256 : "–",
    file->model_sha256 != NULL ? file->model_sha256 : "–");
  return fail (error, name, message);
}

gboolean
qn_result_file_find_faults (const QnResultFile *file, const char *name,
                            const QnProject *project, const QnContacts *contacts,
                            QnResultFaults *faults, GError **error)
{
  *faults = (QnResultFaults){ 0 };
  if (!qn_result_file_match (file, name, project, contacts, NULL, error)
      || !check_hash (file, name, project, error))
    return FALSE;
  if (file->result.step_count > 0 && file->result.pair_count != contacts->pair_count)
    return fail (error, name, _ ("the result holds no forces of the contacts"));
  if (qn_result_find_faults (&project->model, contacts, &file->result,
                             QN_CHECK_RECOMPUTED, faults, NULL)
      == QN_OK)
    return TRUE;
  return qn_io_fail (error, QN_IO_ERROR_NO_MEMORY, "%s: %s", name,
                     _ ("not enough memory"));
}

/* ---- what follows from the rest ---- */

/* Rounding of numbers that are worked out once more, relative to 1 + their size. */
#define SAME 1e-9

/* --- What nothing proves ------------------------------------------------------------------ */

static void
add_unproved (GPtrArray *unproved, const char *member)
{
  if (!g_ptr_array_find_with_equal_func (unproved, member, g_str_equal, NULL))
    g_ptr_array_add (unproved, g_strdup (member));
}

static void
list_unproved (const QnModel *model, const QnResultFile *file, GPtrArray *unproved)
{
  const QnResult *result = &file->result;
  gboolean in_time = result->history.width > 0, relaxed = FALSE, jumps = FALSE;
  for (size_t i = 0; i < result->step_count; i++) {
    relaxed |= result->steps[i].relaxed;
    jumps |= result->steps[i].event == QN_EVENT_SNAP;
  }
  gboolean no_answer = result->outcome == QN_OUTCOME_NOT_CONVERGED
                       || result->outcome == QN_OUTCOME_CANCELLED;
  /* Limit analysis is repeated where it found no equilibrium. */
  gboolean is_rigid = model->analysis.procedure == QN_PROCEDURE_LIMIT
                      && model->analysis.flow == QN_FLOW_ASSOCIATIVE;
  const struct {
    const char *member;
    gboolean stated;
  } members[] = {
    { "generator", file->generator != NULL },
    { "model", file->model != NULL },
    { "overrides", file->overrides != NULL },
    { "reason", TRUE },
    { "timings", result->statistics.seconds > 0 },
    { "statistics", TRUE },
    { "steps[].iterations", result->step_count > 0 },
    { "steps[].residual", result->step_count > 0 },
    { "steps[].relaxed", relaxed },
    { "steps[].event", jumps },
    { "refused", result->refused_count > 0 },
    { "unproved_multiplier", result->has_unproved_multiplier },
    { "outcome", (result->step_count == 0 && !is_rigid) || no_answer },
    { "events", result->event_count > 0 },
    { "broken_bond_bound", result->has_broken_bound },
    { "solutions[].found_by", result->solution_count > 0 && !result->limit.given },
    { "mechanism_by_work", result->mechanism_by_work },
    { "node_mechanism", result->node_count > 0 && result->mechanism != NULL
                          && (result->mechanism_uncertain
                              || model->analysis.geometry == QN_GEOMETRY_NONLINEAR) },
    { "history.energy_error", in_time },
    { "history.largest_residual", in_time },
    { "history.largest_slip", in_time },
    { "history.shortest_step", in_time },
    { "history.steps", in_time },
    { "history.rejected", in_time },
    { "history.time_of_collapse", in_time && result->outcome == QN_OUTCOME_COLLAPSE },
    { "history.peak", in_time },
    { "history.time_of_peak", in_time && !isnan (result->history.peak_time) },
    { "history.tracks[].values", in_time && model->track_count > 0 },
    { "history.ground", in_time },
    { "history.found", in_time && result->found_count > 0 },
    { "history.left", in_time && result->left_count > 0 },
    { "found[].foot", !in_time && result->found_count > 0 },
    { "found[].step", !in_time && result->found_count > 0 },
    { "left", !in_time && result->left_count > 0 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (members); i++)
    if (members[i].stated)
      add_unproved (unproved, members[i].member);
}

/* --- Comparing ---------------------------------------------------------------------------- */

/* A word or a number; "…" where it is more, or nothing. */
static char *
dup_scalar (const cJSON *value)
{
  if (value == NULL || cJSON_IsArray (value) || cJSON_IsObject (value))
    return g_strdup ("…");
  GString *text = g_string_new (NULL);
  qn_json_append_value (text, value, 0);
  return g_string_free (text, FALSE);
}

/* An error at the first place where the texts differ. */
static gboolean
differ (const QnJsonValue *stated, const cJSON *found)
{
  g_autofree char *states = dup_scalar (stated->json), *instead = dup_scalar (found);
  return qn_json_value_failf (
    stated, _ ("this contradicts the rest of the result: %s instead of %s"), states,
    instead);
}

static gboolean compare_values (const QnJsonValue *stated, const cJSON *found,
                                GPtrArray *unproved);

static gboolean
compare_objects (const QnJsonValue *stated, const cJSON *found, GPtrArray *unproved)
{
  /* Members that depend on place, time, language and program of writing. */
  static const char *const outside[] = { "generator", "model", "overrides", "reason",
                                         NULL };
  const cJSON *next = found->child; /* mostly members have the same order */
  for (const cJSON *child = stated->json->child; child != NULL; child = child->next) {
    const QnJsonValue member = qn_json_value_child (stated, child);
    const cJSON *value = next != NULL && strcmp (next->string, child->string) == 0
                           ? next
                           : cJSON_GetObjectItemCaseSensitive (found, child->string);
    if (value == NULL) {
      /* Without the numbers of elements: "contacts[].hinge". */
      g_autofree char *path = qn_json_value_dup_path (&member);
      char *end = path;
      for (const char *c = path; *c != '\0'; c++) {
        *end++ = *c;
        if (*c == '[')
          c += strspn (c + 1, "0123456789");
      }
      *end = '\0';
      add_unproved (unproved, path);
      continue;
    }
    next = value->next;
    if (stated->parent == NULL && g_strv_contains (outside, child->string))
      continue;
    if (!compare_values (&member, value, unproved))
      return FALSE;
  }
  return TRUE;
}

static gboolean
compare_values (const QnJsonValue *stated, const cJSON *found, GPtrArray *unproved)
{
  const cJSON *json = stated->json;
  if (json->type != found->type)
    return differ (stated, found);
  if (cJSON_IsObject (json))
    return compare_objects (stated, found, unproved);
  if (cJSON_IsArray (json)) {
    const cJSON *other = found->child;
    QnJsonValue item = { 0 };
    while (qn_json_value_next (stated, &item)) {
      if (other == NULL)
        return differ (&item, NULL);
      if (!compare_values (&item, other, unproved))
        return FALSE;
      other = other->next;
    }
    return other == NULL || differ (stated, other);
  }
  gboolean same = !cJSON_IsNumber (json)
                  || fabs (json->valuedouble - found->valuedouble)
                       <= SAME * (1 + fabs (found->valuedouble));
  if (cJSON_IsString (json))
    same = strcmp (json->valuestring, found->valuestring) == 0;
  return same || differ (stated, found);
}

gboolean
qn_result_text_agrees (const char *text, gsize length, const char *name,
                       const QnResultFile *file, const QnProject *project,
                       const QnContacts *contacts, GPtrArray *unproved, GError **error)
{
  gsize written_length;
  g_autofree char *written = qn_result_dup_text (project, contacts, &file->result,
                                                 QN_DETAIL_FORCES, &written_length);
  QnReader reader = { .name = name, .text = text, .length = length };
  list_unproved (&project->model, file, unproved);
  cJSON *stated = qn_json_parse (text, length, name, &reader.error);
  cJSON *found =
    qn_json_parse (written, written_length, name, stated != NULL ? &reader.error : NULL);
  const QnJsonValue root = qn_json_value_root (&reader, stated);
  gboolean agrees =
    stated != NULL && found != NULL && compare_values (&root, found, unproved);
  if (!agrees)
    g_propagate_error (error, reader.error);
  cJSON_Delete (stated);
  cJSON_Delete (found);
  return agrees;
}
