/* Every number and every word of results is changed, one at a time, and the check must refuse what comes
 * out: numbers by a factor of 1.05 and by their sign, words into other words, every member left out.
 *
 * What survives must be in `allowed`: statements that neither the file nor the project proves, which the
 * check lists, and changes of less than its tolerance. Quick runs change some of each list of numbers;
 * `-m slow` changes all. */
#include "core/path/analysis.h"
#include "io/result/result-check.h"
#include "io/result/result-claims.h"
#include "io/result/result-derived.h"
#include "support/auto-clear.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of every list of numbers quick runs change so many. */
#define SOME 1

/* A number that is smaller than this part of the largest of its list is nothing: what it says is within
 * the tolerance of forces, 1e-5. */
#define NOTHING 3e-4

/* In members that follow from others. */
#define ROUNDING 1e-8

typedef struct Source {
  const char *name, *example;
  const char *overrides[4];
} Source;

static const Source sources[] = {
  { "block", "01-sliding-block.quoin", { NULL } },
  { "block in large displacements",
    "01-sliding-block.quoin",
    { "analysis.geometry=nonlinear", NULL } },
  { "arch", "06-arch.quoin", { NULL } },
  { "arch in large displacements",
    "06-arch.quoin",
    { "analysis.geometry=nonlinear", NULL } },
  { "arch by work", "06-arch.quoin", { "analysis.procedure=work", NULL } },
  { "limit",
    "06-arch.quoin",
    { "analysis.procedure=limit", "analysis.flow=associative", NULL } },
  { "fixed points",
    "06-arch.quoin",
    { "analysis.procedure=limit", "analysis.flow=non-associative", NULL } },
  { "stages", "16-load-stages.quoin", { NULL } },
  { "settlement", "18-spreading-arch.quoin", { NULL } },
  { "beams", "32-frame-beams.quoin", { NULL } },
  { "rubble", "15-rubble-pier.quoin", { NULL } },
  { "in time", "40-rocking-in-time.quoin", { "analysis.dynamic.duration=0.3", NULL } },
};

/* --- One result ---------------------------------------------------------------------------- */

typedef struct Case {
  const char *name;
  QnProject project;
  QnContacts contacts;
  char *text;
  int changed, survived;
} Case;

/* Whether the check lets a text pass. */
static gboolean
passes (const Case *c, const char *text, char **message)
{
  QnResultFile file;
  QnResultFaults faults;
  QnResultCheck check;
  g_autoptr (GError) error = NULL;
  g_autoptr (GPtrArray) unproved = g_ptr_array_new_with_free_func (g_free);
  gsize length = strlen (text);
  gboolean done = FALSE;
  if (qn_result_file_parse (text, length, "result.json", &file, &error)) {
    gboolean rests = file.result.step_count > 0 && file.result.history.width == 0;
    done = qn_result_file_find_faults (&file, "result.json", &c->project, &c->contacts,
                                       &faults, &error)
           && faults.count == 0
           && (!rests || qn_result_check (&file, &c->project, &check, &error))
           && qn_result_passes (&c->project, rests ? &check : NULL, &faults)
           && qn_result_text_agrees (text, length, "result.json", &file, &c->project,
                                     &c->contacts, unproved, &error);
    qn_result_file_clear (&file);
  }
  if (message != NULL)
    *message = g_strdup (error != NULL ? error->message : "");
  return done;
}

static void
case_init (Case *c, const Source *source)
{
  g_auto (QnResult) result;
  gsize length;
  g_autoptr (GError) error = NULL;
  g_autofree char *path =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), source->example, NULL);
  *c = (Case){ .name = source->name };
  if (!qn_project_load (path, source->overrides, &c->project, &error))
    g_error ("%s", error->message);
  g_assert_cmpint (qn_contacts_detect (&c->project.model, &c->contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_analysis_run (&c->project.model, &c->contacts, NULL, NULL, &result, NULL), ==,
    QN_OK);
  c->text = qn_result_dup_text (&c->project, &c->contacts, &result, &length);
}

static void
case_clear (Case *c)
{
  g_free (c->text);
  qn_contacts_clear (&c->contacts);
  qn_project_clear (&c->project);
}

/* --- What may survive ---------------------------------------------------------------------- */

/* Patterns of paths, without the numbers of elements, and of changes. docs/method/checking.md says why. */
static const struct {
  const char *pattern;
  const char *source; /* of this one alone; NULL: of all */
} allowed[] = {
  /* A member that is left out states nothing. */
  { "* left out", NULL },
  /* Written by whom, from where, in what time, in which language. */
  { "generator word *", NULL },
  { "model word *", NULL },
  { "timings.* times", NULL },
  { "statistics.* times", NULL },
  { "reason word *", NULL },
  /* How the solver came there. */
  { "steps[].iterations *", NULL },
  { "steps[].residual times", NULL },
  { "steps[].relaxed flag", NULL },
  { "outcome word not-converged", NULL },
  { "solutions[].found_by word *", NULL },
  /* What lies between the steps. */
  { "events[].displacement_after times", NULL },
  { "events[].energy times", NULL },
  { "history.energy_error times", NULL },
  { "history.largest_residual times", NULL },
  { "history.largest_slip times", NULL },
  { "history.shortest_step times", NULL },
  { "history.steps times", NULL },
  { "history.rejected times", NULL },
  { "history.time_of_collapse times", NULL },
  { "history.peak[] times", NULL },
  { "history.tracks[].values[] *", NULL },
  /* Joints slide on a way that no step tells, where a motion comes to rest and in time. */
  { "steps[].displacements[][] *", "stages" },
  { "steps[].displacements[][] *", "rubble" },
  { "steps[].displacements[][] *", "in time" },
  /* Of a path that is not in the file. */
  { "solutions[].displacement times", "fixed points" },
  /* Beams bend and yield as they move. */
  { "node_mechanism[][] *", "beams" },
  /* Within the error of the balance of energy. */
  { "history.energy.numerical[] times", "in time" },
  /* A velocity has the same energy the other way. */
  { "steps[].velocities[][] sign", NULL },
  /* A joint that carries nothing is open or slips. */
  { "contacts[].state word slip", NULL },
  { "contacts[].state word open", NULL },
};

static gboolean
is_allowed (const char *source, const char *path)
{
  g_autoptr (GString) member = g_string_new (NULL);
  for (const char *at = path; *at != '\0'; at++)
    if (!(g_ascii_isdigit (*at) && member->len > 0
          && member->str[member->len - 1] == '['))
      g_string_append_c (member, *at);
  for (gsize i = 0; i < G_N_ELEMENTS (allowed); i++)
    if ((allowed[i].source == NULL || strcmp (allowed[i].source, source) == 0)
        && g_pattern_match_simple (allowed[i].pattern, member->str))
      return TRUE;
  return FALSE;
}

/* --- Changes ------------------------------------------------------------------------------- */

static void
try_change (Case *c, const cJSON *root, const char *path, const char *how)
{
  char *text = cJSON_PrintUnformatted (root);
  c->changed++;
  if (passes (c, text, NULL)) {
    c->survived++;
    g_autofree char *member = g_strconcat (path, " ", how, NULL);
    if (!is_allowed (c->name, member)) {
      g_test_message ("survives: %s", member);
      g_test_fail ();
    }
  }
  free (text);
}

/* Largest of the numbers beside one, itself included: in lists of lists those of the outer one. */
static double
largest_of (const cJSON *list)
{
  double largest = 0;
  const cJSON *item;
  cJSON_ArrayForEach (item, list)
  {
    if (cJSON_IsNumber (item))
      largest = MAX (largest, fabs (item->valuedouble));
    else if (cJSON_IsArray (item))
      largest = MAX (largest, largest_of (item));
  }
  return largest;
}

static void
change_number (Case *c, const cJSON *root, cJSON *item, const char *path, double largest)
{
  double number = item->valuedouble;
  if (fabs (number) < MAX (NOTHING * largest, ROUNDING))
    return;
  cJSON_SetNumberValue (item, 1.05 * number);
  try_change (c, root, path, "times");
  cJSON_SetNumberValue (item, -number);
  try_change (c, root, path, "sign");
  cJSON_SetNumberValue (item, number);
}

static void
change_word (Case *c, const cJSON *root, cJSON *item, const char *path)
{
  static const char *const words[] = {
    "other",          "load",          "work",    "limit",   "collapse",
    "target-reached", "not-converged", "snap",    "local",   "stick",
    "slip",           "open",          "sliding", "opening", "hinge-start",
  };
  char *word = item->valuestring;
  for (gsize i = 0; i < G_N_ELEMENTS (words); i++)
    if (strcmp (words[i], word) != 0) {
      g_autofree char *how = g_strconcat ("word ", words[i], NULL);
      item->valuestring = (char *) words[i];
      try_change (c, root, path, how);
    }
  item->valuestring = word;
}

static void
change_flag (Case *c, const cJSON *root, cJSON *item, const char *path)
{
  int type = item->type;
  item->type = cJSON_IsTrue (item) ? cJSON_False : cJSON_True;
  try_change (c, root, path, "flag");
  item->type = type;
}

static void walk (Case *c, cJSON *root, cJSON *parent, const char *path, double largest);

static void
change_item (Case *c, cJSON *root, cJSON *item, const char *path, double largest)
{
  if (cJSON_IsNumber (item))
    change_number (c, root, item, path, largest);
  else if (cJSON_IsString (item))
    change_word (c, root, item, path);
  else if (cJSON_IsBool (item))
    change_flag (c, root, item, path);
  else if (cJSON_IsArray (item) || cJSON_IsObject (item))
    walk (c, root, item, path, largest);
}

static gboolean
is_picked (int index, int count)
{
  return g_test_slow () || count <= SOME
         || index % (count / SOME) == (count - 1) % (count / SOME);
}

static void
walk (Case *c, cJSON *root, cJSON *parent, const char *path, double largest)
{
  int count = cJSON_GetArraySize (parent);
  gboolean is_list = cJSON_IsArray (parent);
  if (is_list)
    largest = MAX (largest, largest_of (parent));
  cJSON *before = NULL;
  for (int i = 0; i < count; i++) {
    cJSON *item = before != NULL ? before->next : parent->child;
    if (is_list && !is_picked (i, count)) {
      before = item;
      continue;
    }
    g_autofree char *place =
      is_list ? g_strdup_printf ("%s[%d]", path, i)
              : g_strconcat (path, *path != '\0' ? "." : "", item->string, NULL);
    change_item (c, root, item, place, is_list ? largest : 0);
    cJSON **link = before != NULL ? &before->next : &parent->child;
    *link = item->next;
    try_change (c, root, place, "left out");
    *link = item;
    before = item;
  }
}

static void
test_source (gconstpointer data)
{
  const Source *source = data;
  Case c;
  g_autofree char *message = NULL;
  case_init (&c, source);
  gboolean whole = passes (&c, c.text, &message);
  g_test_message ("%s", message);
  g_assert_true (whole);
  cJSON *root = cJSON_Parse (c.text);
  /* Who reads a result applies them to the project. */
  cJSON_DeleteItemFromObject (root, "overrides");
  walk (&c, root, root, "", 0);
  g_test_message ("%d changes, %d survive", c.changed, c.survived);
  g_assert_cmpint (c.changed, >, 100);
  cJSON_Delete (root);
  case_clear (&c);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_set_nonfatal_assertions ();
  for (gsize i = 0; i < G_N_ELEMENTS (sources); i++) {
    g_autofree char *path = g_strdup_printf ("/io/tampering/%s", sources[i].name);
    g_test_add_data_func (path, &sources[i], test_source);
  }
  return g_test_run ();
}
