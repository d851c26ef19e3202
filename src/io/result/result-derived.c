#include "io/result/result-derived.h"

#include "io/json/json-path.h"
#include "io/json/json-scan.h"
#include "io/text/io-error.h"
#include "io/text/outcome-text.h"

#include <glib/gi18n-lib.h>
#include <locale.h>
#include <math.h>
#include <string.h>

/* Rounding of numbers that are worked out once more, relative to 1 + their size. */
#define SAME 1e-9

typedef struct Walk {
  QnJsonScanner stated, found; /* both at the same place */
  GString *path;               /* of this place */
  const QnProject *project;
  const QnResult *result;
  GPtrArray *unproved;
} Walk;

/* --- What nothing proves ------------------------------------------------------------------ */

static void
add_unproved (GPtrArray *unproved, const char *member)
{
  if (!g_ptr_array_find_with_equal_func (unproved, member, g_str_equal, NULL))
    g_ptr_array_add (unproved, g_strdup (member));
}

static gboolean
has_events (const QnResult *result)
{
  return result->event_count > 0;
}

static gboolean
is_by_load (const QnModel *model, const QnResult *result)
{
  gboolean staged = result->stage > 0 && (size_t) result->stage <= model->stage_count;
  QnProcedure procedure =
    staged ? model->stages[result->stage - 1].procedure : model->analysis.procedure;
  return procedure == QN_PROCEDURE_LOAD && !result->limit.given
         && result->history.width == 0;
}

static gboolean
has_relaxed (const QnResult *result)
{
  gboolean any = FALSE;
  for (size_t i = 0; i < result->step_count; i++)
    any = any || result->steps[i].relaxed;
  return any;
}

/* Whether a found contact carries at no step that is kept. */
static gboolean
has_idle_contacts (const QnResult *result)
{
  g_autofree gboolean *carries = g_new0 (gboolean, result->found_count);
  gboolean any = FALSE;
  for (size_t i = 0; i < result->found_force_count; i++)
    carries[result->found_forces[i].found] = TRUE;
  for (size_t i = 0; i < result->found_count; i++)
    any = any || !carries[i];
  return any;
}

/* Whether steps are jumps that no event tells: of stages before the last, and where motion is prescribed. */
static gboolean
has_other_jumps (const QnModel *model, const QnResult *result)
{
  gboolean any = FALSE;
  for (size_t i = 0; i < result->step_count; i++)
    any = any
          || (result->steps[i].event == QN_EVENT_SNAP
              && (result->steps[i].stage < result->stage || !is_by_load (model, result)));
  return any;
}

static void
list_unproved (const QnModel *model, const QnResultFile *file, GPtrArray *unproved)
{
  const QnResult *result = &file->result;
  gboolean in_time = result->history.width > 0;
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
    { "timings", result->statistics.seconds > 0 },
    { "statistics", TRUE },
    { "steps[].iterations", result->step_count > 0 },
    { "steps[].residual", result->step_count > 0 },
    { "steps[].relaxed", has_relaxed (result) },
    { "steps[].event", has_other_jumps (model, result) },
    { "refused", result->refused_count > 0 },
    { "unproved_multiplier", result->has_unproved_multiplier },
    { "outcome", (result->step_count == 0 && !is_rigid) || no_answer },
    { "events[].displacement_after", has_events (result) && is_by_load (model, result) },
    { "events[].energy", has_events (result) && is_by_load (model, result) },
    { "solutions[].found_by", result->solution_count > 0 && is_by_load (model, result) },
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
    { "history.found", in_time && has_idle_contacts (result) },
    { "history.found[].foot", in_time && result->found_count > 0 },
    { "history.found[].time", in_time && result->found_count > 0 },
    { "history.left[].time", in_time && result->left_count > 0 },
    { "found[].foot", !in_time && result->found_count > 0 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (members); i++)
    if (members[i].stated)
      add_unproved (unproved, members[i].member);
}

/* --- The sentence ------------------------------------------------------------------------- */

static int
compare_texts (gconstpointer a, gconstpointer b)
{
  return strcmp (*(char *const *) a, *(char *const *) b);
}

/* The numbers in a sentence, in the order of their texts. */
static char *
dup_numbers (const char *sentence)
{
  g_autoptr (GPtrArray) numbers = g_ptr_array_new_with_free_func (g_free);
  for (const char *at = sentence; *at != '\0';) {
    gsize length = strspn (at, "0123456789.");
    if (g_ascii_isdigit (*at)) {
      while (at[length - 1] == '.') /* of the sentence */
        length--;
      g_ptr_array_add (numbers, g_strndup (at, length));
    }
    at += MAX (length, 1);
  }
  g_ptr_array_sort (numbers, compare_texts);
  g_ptr_array_add (numbers, NULL);
  return g_strjoinv (" ", (char **) numbers->pdata);
}

typedef enum { SAME_SENTENCE, SAME_NUMBERS, OTHER_SENTENCE } Likeness;

/* Only the sentence says what ended a path: any such end is possible. */
static Likeness
compare_reason (const QnModel *model, const QnResult *result, const char *stated)
{
  Likeness best = OTHER_SENTENCE;
  QnResult told = *result; /* whose arrays stay the result's */
  g_autofree char *numbers = dup_numbers (stated);
  for (int stop = 0; stop < QN_STOP_COUNT && best != SAME_SENTENCE; stop++) {
    told.stop = (QnStop) stop;
    g_autofree char *reason = qn_outcome_dup_reason (model, &told);
    g_autofree char *its = dup_numbers (reason);
    if (strcmp (reason, stated) == 0)
      best = SAME_SENTENCE;
    else if (strcmp (its, numbers) == 0)
      best = SAME_NUMBERS;
  }
  return best;
}

/* The same in English, whatever the language of the user. */
static Likeness
compare_reason_in_english (const QnModel *model, const QnResult *result,
                           const char *stated)
{
  locale_t english = newlocale (LC_ALL_MASK, "C", (locale_t) 0);
  if (english == (locale_t) 0)
    return OTHER_SENTENCE;
  locale_t before = uselocale (english);
  Likeness likeness = compare_reason (model, result, stated);
  uselocale (before);
  freelocale (english);
  return likeness;
}

/* In a language that is not at hand the words are not compared. */
static gboolean
suits_reason (Walk *walk, const char *stated)
{
  const QnModel *model = &walk->project->model;
  Likeness likeness = compare_reason (model, walk->result, stated);
  if (likeness != SAME_SENTENCE)
    likeness = MIN (likeness, compare_reason_in_english (model, walk->result, stated));
  if (likeness == SAME_NUMBERS)
    add_unproved (walk->unproved, "reason");
  return likeness != OTHER_SENTENCE;
}

/* --- Comparing ---------------------------------------------------------------------------- */

static gboolean compare_value (Walk *walk);

/* What depends on where, when and by which program the file was written. */
static gboolean
is_outside (const char *path)
{
  static const char *const members[] = { "generator", "model", "overrides" };
  for (gsize i = 0; i < G_N_ELEMENTS (members); i++)
    if (strcmp (path, members[i]) == 0)
      return TRUE;
  return FALSE;
}

/* "contacts[3].hinge" without the numbers. */
static void
add_unknown (Walk *walk)
{
  g_autoptr (GString) member = g_string_new (NULL);
  gboolean skips = FALSE;
  for (const char *at = walk->path->str; *at != '\0'; at++) {
    skips = skips && *at != ']';
    if (!skips)
      g_string_append_c (member, *at);
    skips = skips || *at == '[';
  }
  add_unproved (walk->unproved, member->str);
}

/* Goes to the value of a member of `object`, a scanner at its beginning. `found`, which stands somewhere
 * inside it, is often next to it already. */
static gboolean
find_member (const char *key, const QnJsonScanner *object, QnJsonScanner *found)
{
  if (qn_json_next (found) == QN_JSON_KEY && found->depth == object->depth
      && qn_json_string_is (found, key)) {
    qn_json_next (found);
    return TRUE;
  }
  *found = *object;
  while (qn_json_next (found) == QN_JSON_KEY) {
    gboolean same = qn_json_string_is (found, key);
    qn_json_next (found);
    if (same)
      return TRUE;
    qn_json_skip (found);
  }
  return FALSE;
}

static gboolean
compare_object (Walk *walk)
{
  const QnJsonScanner object = walk->found;
  gsize length = walk->path->len;
  while (qn_json_next (&walk->stated) == QN_JSON_KEY) {
    g_autofree char *key = qn_json_dup_string (&walk->stated);
    qn_json_path_append_key (walk->path, key);
    gboolean known = find_member (key, &object, &walk->found);
    qn_json_next (&walk->stated);
    if (known && !is_outside (walk->path->str)) {
      if (!compare_value (walk))
        return FALSE;
    } else {
      if (known)
        qn_json_skip (&walk->found);
      else
        add_unknown (walk);
      qn_json_skip (&walk->stated);
    }
    g_string_truncate (walk->path, length);
  }
  walk->found = object; /* to its end */
  return qn_json_skip (&walk->found);
}

static gboolean
compare_array (Walk *walk)
{
  gsize length = walk->path->len;
  for (gsize i = 0;; i++) {
    QnJsonToken stated = qn_json_next (&walk->stated);
    QnJsonToken found = qn_json_next (&walk->found);
    if (stated == QN_JSON_END_ARRAY && found == QN_JSON_END_ARRAY)
      return TRUE;
    qn_json_path_append_index (walk->path, i);
    if (stated == QN_JSON_END_ARRAY || found == QN_JSON_END_ARRAY
        || !compare_value (walk))
      return FALSE;
    g_string_truncate (walk->path, length);
  }
}

static gboolean
compare_value (Walk *walk)
{
  if (walk->stated.token != walk->found.token)
    return FALSE;
  switch (walk->stated.token) {
  case QN_JSON_BEGIN_OBJECT:
    return compare_object (walk);
  case QN_JSON_BEGIN_ARRAY:
    return compare_array (walk);
  case QN_JSON_NUMBER: {
    double stated = qn_json_number (&walk->stated), found = qn_json_number (&walk->found);
    return fabs (stated - found) <= SAME * (1 + fabs (found));
  }
  case QN_JSON_STRING: {
    g_autofree char *stated = qn_json_dup_string (&walk->stated);
    return strcmp (walk->path->str, "reason") == 0
             ? suits_reason (walk, stated)
             : qn_json_string_is (&walk->found, stated);
  }
  case QN_JSON_TRUE:
  case QN_JSON_FALSE:
  case QN_JSON_NULL:
    return TRUE;
  case QN_JSON_END_OBJECT:
  case QN_JSON_END_ARRAY:
  case QN_JSON_KEY:
  case QN_JSON_END:
  case QN_JSON_ERROR:
    break;
  }
  return FALSE;
}

/* The token at a scanner, if it is no more than a word or a number. */
static char *
dup_token (const QnJsonScanner *scanner)
{
  gsize length = scanner->end - scanner->start;
  gboolean single = scanner->token >= QN_JSON_STRING && scanner->token <= QN_JSON_NULL;
  return single ? g_strndup (scanner->text + scanner->start, length) : g_strdup ("…");
}

gboolean
qn_result_text_agrees (const char *text, gsize length, const char *name,
                       const QnResultFile *file, const QnProject *project,
                       const QnContacts *contacts, GPtrArray *unproved, GError **error)
{
  gsize written_length;
  g_autofree char *written =
    qn_result_dup_text (project, contacts, &file->result, &written_length);
  g_autoptr (GString) path = g_string_new (NULL);
  Walk walk = {
    .path = path, .project = project, .result = &file->result, .unproved = unproved
  };

  list_unproved (&project->model, file, unproved);
  qn_json_scanner_init (&walk.stated, text, length);
  qn_json_scanner_init (&walk.found, written, written_length);
  qn_json_next (&walk.stated);
  qn_json_next (&walk.found);
  if (compare_value (&walk))
    return TRUE;
  g_autofree char *stated = dup_token (&walk.stated);
  g_autofree char *found = dup_token (&walk.found);
  g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
               _ ("%s: %s: this contradicts the rest of the result: %s instead of %s"),
               name, path->str, stated, found);
  return FALSE;
}
