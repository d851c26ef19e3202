#include "io/result/result-derived.h"

#include "io/json/json-tokens.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* Rounding of numbers that are worked out once more, relative to 1 + their size. */
#define SAME 1e-9

typedef struct Walk {
  QnJson stated, found;
  GPtrArray *unproved;
  GError **error;
} Walk;

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

/* The text of a token that is no more than a word or a number; 0: none. */
static char *
dup_token (const QnJson *json, gsize at)
{
  const char *text = json->text + json->tokens[at].start;
  if (json->tokens[at].type == QN_JSON_STRING)
    return g_strndup (text, qn_json_string_length (text));
  gsize length = strspn (text, "+-.0123456789abcdefghijklmnopqrstuvwxyzE");
  return at > 0 && length > 0 ? g_strndup (text, length) : g_strdup ("…");
}

/* Keeps the first place where the texts differ, inside `outer` of the stated one. */
static gboolean
differ (Walk *walk, gsize outer, gsize stated, gsize found)
{
  g_autofree char *path = qn_json_dup_path (&walk->stated, MAX (outer, stated));
  g_autofree char *states = dup_token (&walk->stated, stated);
  g_autofree char *instead = dup_token (&walk->found, found);
  return qn_io_fail (
    walk->error, QN_IO_ERROR_INVALID,
    _ ("%s: %s: this contradicts the rest of the result: %s instead of %s"),
    walk->stated.name, path, states, instead);
}

/* "contacts[3].hinge" without the numbers. */
static void
add_unknown (Walk *walk, gsize at)
{
  g_autofree char *path = qn_json_dup_path (&walk->stated, at);
  g_autoptr (GString) member = g_string_new (NULL);
  gboolean skips = FALSE;
  for (const char *c = path; *c != '\0'; c++) {
    skips = skips && *c != ']';
    if (!skips)
      g_string_append_c (member, *c);
    skips = skips || *c == '[';
  }
  add_unproved (walk->unproved, member->str);
}

static gboolean compare_values (Walk *walk, gsize stated, gsize found);

static gboolean
compare_objects (Walk *walk, gsize stated, gsize found)
{
  /* Members that depend on place, time, language and program of writing. */
  static const char *const outside[] = { "generator", "model", "overrides", "reason",
                                         NULL };
  const QnJsonToken *s = walk->stated.tokens, *f = walk->found.tokens;
  gsize next = found + 1; /* mostly members have the same order */
  for (gsize i = stated + 1; i < s[stated].next; i = s[i].next) {
    g_autofree char *key = qn_json_dup_string (&walk->stated, i);
    gsize value = next < f[found].next && qn_json_string_is (&walk->found, next, key)
                    ? next + 1
                    : qn_json_member (&walk->found, found, key);
    if (value == 0) {
      add_unknown (walk, i);
      continue;
    }
    next = f[value].next;
    if (stated == 0 && g_strv_contains (outside, key))
      continue;
    if (!compare_values (walk, i + 1, value))
      return FALSE;
  }
  return TRUE;
}

static gboolean
compare_arrays (Walk *walk, gsize stated, gsize found)
{
  const QnJsonToken *s = walk->stated.tokens, *f = walk->found.tokens;
  gsize i = stated + 1, k = found + 1;
  for (; i < s[stated].next && k < f[found].next; i = s[i].next, k = f[k].next)
    if (!compare_values (walk, i, k))
      return FALSE;
  return (i == s[stated].next && k == f[found].next)
         || differ (walk, stated, i < s[stated].next ? i : 0, k < f[found].next ? k : 0);
}

static gboolean
compare_values (Walk *walk, gsize stated, gsize found)
{
  const QnJsonType type = walk->stated.tokens[stated].type;
  gboolean same = type == walk->found.tokens[found].type;
  if (same && type == QN_JSON_OBJECT)
    return compare_objects (walk, stated, found);
  if (same && type == QN_JSON_ARRAY)
    return compare_arrays (walk, stated, found);
  if (same && type == QN_JSON_NUMBER) {
    double number = qn_json_number (&walk->found, found);
    same = fabs (qn_json_number (&walk->stated, stated) - number)
           <= SAME * (1 + fabs (number));
  } else if (same && type == QN_JSON_STRING) {
    g_autofree char *text = qn_json_dup_string (&walk->stated, stated);
    same = qn_json_string_is (&walk->found, found, text);
  }
  return same || differ (walk, stated, stated, found);
}

gboolean
qn_result_text_agrees (const char *text, gsize length, const char *name,
                       const QnResultFile *file, const QnProject *project,
                       const QnContacts *contacts, GPtrArray *unproved, GError **error)
{
  gsize written_length;
  g_autofree char *written = qn_result_dup_text (project, contacts, &file->result,
                                                 QN_DETAIL_FORCES, &written_length);
  Walk walk = { .unproved = unproved, .error = error };
  list_unproved (&project->model, file, unproved);
  gboolean scanned = qn_json_scan (&walk.stated, text, length, name)
                     && qn_json_scan (&walk.found, written, written_length, name);
  gboolean agrees = scanned && compare_values (&walk, 0, 0);
  if (!scanned) {
    GError **trouble = walk.stated.error != NULL ? &walk.stated.error : &walk.found.error;
    g_propagate_error (error, g_steal_pointer (trouble));
  }
  qn_json_clear (&walk.stated);
  qn_json_clear (&walk.found);
  return agrees;
}
