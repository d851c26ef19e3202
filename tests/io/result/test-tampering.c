/* Every member of results of all kinds is changed, one at a time, and the check must refuse what comes out:
 * numbers by a factor of 1.05, by their sign, to 0, and where they are nothing beside those of their list
 * to a hundredth of the largest; words into other words, letters of states into others; every member left
 * out, elements of lists doubled and exchanged with the next one.
 *
 * What survives must be a member that the check itself lists as not proved, or in `allowed`, which says
 * why. Of results that are small all changes are tried of the first, the middle, the last and the largest
 * element of every list, of others one of ten changes of the last; with `-m slow` all changes of all
 * results. */
#include "core/path/analysis.h"
#include "io/result/result-file.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A number that is smaller than this part of the largest of its list is nothing: what it says is within
 * the tolerance of forces, 1e-5. */
#define NOTHING 3e-4

/* In members that follow from others. */
#define ROUNDING 1e-8

/* Rates of a mechanism are compared to this part of the largest. */
#define RATE 0.02

/* To what part of the largest of its list a number is changed that is nothing. */
#define LITTLE 0.01

typedef struct Source {
  const char *name, *example;
  enum { SOME, ALL, SLOW } tries; /* which changes; SLOW: none in quick runs */
  const char *overrides[8];
} Source;

#define LARGE  "analysis.geometry=nonlinear"
#define FOLLOW "analysis.contacts=follow"
#define WALL   "ferris-tin-loi/wall3.quoin"
#define PUSH                                                                             \
  "analysis.control={\"block\":\"w.11.4\",\"component\":\"ux\",\"target\":0.05}"

static const Source sources[] = {
  { "block", "01-sliding-block.quoin", ALL, { NULL } },
  { "block in large displacements", "01-sliding-block.quoin", SOME, { LARGE, NULL } },
  { "arch", "06-arch.quoin", SOME, { NULL } },
  { "arch in large displacements", "06-arch.quoin", SOME, { LARGE, NULL } },
  { "arch by work", "06-arch.quoin", SOME, { "analysis.procedure=work", NULL } },
  { "arch by arc length",
    "06-arch.quoin",
    SLOW,
    { "analysis.procedure=arc-length", LARGE, NULL } },
  { "limit",
    "06-arch.quoin",
    ALL,
    { "analysis.procedure=limit", "analysis.flow=associative", NULL } },
  { "fixed points",
    "06-arch.quoin",
    SOME,
    { "analysis.procedure=limit", "analysis.flow=non-associative", NULL } },
  { "stages", "16-load-stages.quoin", SOME, { NULL } },
  { "unloading", "17-unloading.quoin", SLOW, { NULL } },
  { "settlement", "18-spreading-arch.quoin", SOME, { NULL } },
  { "crushing", "26-crushing-tower.quoin", SLOW, { NULL } },
  { "beams", "32-frame-beams.quoin", SOME, { NULL } },
  { "mast", "36-mast-on-block.quoin", SOME, { NULL } },
  { "tie", "38-tied-walls.quoin", SOME, { NULL } },
  { "block that stops at its limit point",
    "04-block-on-slope.quoin",
    ALL,
    { LARGE, "analysis.snap=stop", NULL } },
  { "no tension", "05-stack.quoin", SOME, { "laws[0].kind=no-tension", NULL } },
  { "cohesion",
    "05-stack.quoin",
    SLOW,
    { "laws[0].cohesion=500", "laws[0].tension=300", NULL } },
  { "rubble", "15-rubble-pier.quoin", SOME, { NULL } },
  { "stop at a jump", "15-rubble-pier.quoin", SLOW, { "analysis.snap=stop", NULL } },
  { "contacts that follow", "29-block-over-an-edge.quoin", SOME, { NULL } },
  { "wall that is followed",
    WALL,
    SLOW,
    { LARGE, FOLLOW, "analysis.procedure=displacement", PUSH, "analysis.increments=20",
      "laws[0].kn=1e8", "laws[0].ks=1e8", NULL } },
  { "in time",
    "40-rocking-in-time.quoin",
    SOME,
    { "analysis.dynamic.duration=0.3", NULL } },
  { "in time, followed",
    "40-rocking-in-time.quoin",
    SOME,
    { "analysis.dynamic.duration=0.5", "analysis.dynamic.contacts=follow",
      "analysis.dynamic.initial=[{\"block\":\"block\",\"displacement\":[0,0.1,0.5]}]",
      NULL } },
};

/* --- One result ---------------------------------------------------------------------------- */

typedef struct Case {
  const char *name;
  QnProject project;
  QnContacts contacts;
  char *text;
  const cJSON *list; /* the one that is being walked */
  gboolean thorough; /* tries all changes */
  int changed, survived;
} Case;

/* Whether the check lets a text pass; it lists in `unproved` what is not proved. */
static gboolean
passes (const Case *c, const char *text, GPtrArray *unproved, char **message)
{
  QnResultFile file;
  QnResultFaults faults;
  g_autoptr (GError) error = NULL;
  gsize length = strlen (text);
  gboolean done = FALSE;
  if (qn_result_file_parse (text, length, "result.json", &file, &error)) {
    done = qn_result_file_find_faults (&file, "result.json", &c->project, &c->contacts,
                                       &faults, &error)
           && faults.count == 0
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
  *c = (Case){ .name = source->name, .thorough = source->tries == ALL || g_test_slow () };
  if (!qn_project_load (path, source->overrides, &c->project, &error))
    g_error ("%s", error->message);
  g_assert_cmpint (qn_contacts_detect (&c->project.model, &c->contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_analysis_run (&c->project.model, &c->contacts, NULL, NULL, &result, NULL), ==,
    QN_OK);
  c->text =
    qn_result_dup_text (&c->project, &c->contacts, &result, QN_DETAIL_FORCES, &length);
}

static void
case_clear (Case *c)
{
  g_free (c->text);
  qn_contacts_clear (&c->contacts);
  qn_project_clear (&c->project);
}

/* --- What may survive ---------------------------------------------------------------------- */

/* Patterns of paths, without the numbers of elements, and of changes, beyond what the check lists. */
static const struct {
  const char *pattern;
  const char *source; /* of this one alone; NULL: of all */
} allowed[] = {
  /* A member that is left out states nothing, and a path with fewer steps is one. */
  { "* left out", NULL },
  /* A step that is told twice is one. */
  { "steps[] doubled", NULL },
  /* Of jumps under load control kind and place are proved, not what lies between. */
  { "steps[].event null", NULL },
  /* Where nothing slides between two steps their order is free. */
  { "steps[] exchanged", "arch by arc length" },
  { "steps[] exchanged", "wall that is followed" },
  /* Joints slide on a way that no step tells, where a motion comes to rest and in time. */
  { "steps[].displacements[][] *", "stages" },
  { "steps[].displacements[][] *", "stop at a jump" },
  { "steps[].displacements[][] *", "rubble" },
  { "steps[].displacements[][] *", "contacts that follow" },
  { "steps[].displacements[][] *", "in time" },
  { "steps[].displacements[][] *", "in time, followed" },
  /* Within the error of the balance of energy. */
  { "history.energy.numerical[] *", NULL },
  /* A velocity has the same energy the other way, and turned by a right angle. */
  { "steps[].velocities[][] sign", NULL },
  { "steps[].velocities[][] exchanged", NULL },
  /* A joint that carries nothing is open or slips. */
  { "contacts[].state word slip", NULL },
  { "contacts[].state word open", NULL },
  { "steps[].states letter s", NULL },
  { "steps[].states letter o", NULL },
  /* A joint at its limit that has not moved since the step before sticks as well, and what carries
   * nothing at the first step is told by nothing to be short of its yield. */
  { "steps[].states letter k", "arch by arc length" },
  { "found[].forces[][] zero", "contacts that follow" },
  { "steps[].states letter y", "unloading" },
  /* The order of what is found or left at the same time. */
  { "found[] exchanged", NULL },
  { "left[] exchanged", NULL },
  { "history.found[] exchanged", NULL },
  /* Rates of beams are compared to 2 % of the largest. */
  { "node_mechanism[][] times", NULL },
};

/* The path without the numbers of elements. */
static char *
dup_member (const char *path)
{
  g_autoptr (GString) member = g_string_new (NULL);
  for (const char *at = path; *at != '\0'; at++)
    if (!(g_ascii_isdigit (*at) && member->len > 0
          && member->str[member->len - 1] == '['))
      g_string_append_c (member, *at);
  return g_string_free (g_steal_pointer (&member), FALSE);
}

/* Whether the check lists the member, or one that it is in, as not proved. */
static gboolean
is_listed (const GPtrArray *unproved, const char *member)
{
  for (guint i = 0; i < unproved->len; i++) {
    const char *listed = unproved->pdata[i];
    gsize length = strlen (listed);
    if (strncmp (listed, member, length) == 0
        && (member[length] == '\0' || member[length] == '.' || member[length] == '['))
      return TRUE;
  }
  return FALSE;
}

static gboolean
is_allowed (const char *source, const char *member, const char *how)
{
  g_autofree char *change = g_strconcat (member, " ", how, NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (allowed); i++)
    if ((allowed[i].source == NULL || strcmp (allowed[i].source, source) == 0)
        && g_pattern_match_simple (allowed[i].pattern, change))
      return TRUE;
  return FALSE;
}

/* --- Changes ------------------------------------------------------------------------------- */

static void
try_change (Case *c, const cJSON *root, const char *path, const char *how)
{
  g_autoptr (GPtrArray) unproved = g_ptr_array_new_with_free_func (g_free);
  if (c->changed++ % 10 != 0 && !c->thorough)
    return;
  char *text = cJSON_PrintUnformatted (root);
  if (passes (c, text, unproved, NULL)) {
    g_autofree char *member = dup_member (path);
    c->survived++;
    if (!is_listed (unproved, member) && !is_allowed (c->name, member, how)) {
      g_test_message ("survives: %s %s", path, how);
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

/* A change is tried where it is one by more than the check compares. */
static void
try_number (Case *c, const cJSON *root, cJSON *item, const char *path, const char *how,
            double changed, double largest)
{
  const double number = item->valuedouble;
  gboolean rate = strstr (path, "mechanism[") != NULL;
  cJSON_SetNumberValue (item, changed);
  if (fabs (changed - number) > (rate ? RATE * largest : 0))
    try_change (c, root, path, how);
  cJSON_SetNumberValue (item, number);
}

static void
change_number (Case *c, const cJSON *root, cJSON *item, const char *path, double largest)
{
  double number = item->valuedouble;
  if (fabs (number) >= MAX (NOTHING * largest, ROUNDING)) {
    try_number (c, root, item, path, "times", 1.05 * number, largest);
    try_number (c, root, item, path, "sign", -number, largest);
    try_number (c, root, item, path, "zero", 0, largest);
  } else if (LITTLE * largest > ROUNDING)
    try_number (c, root, item, path, "little", number + LITTLE * largest, largest);
}

/* The first, the middle and the last letter of the states. */
static void
change_states (Case *c, const cJSON *root, cJSON *item, const char *path)
{
  char *states = item->valuestring;
  gsize length = strlen (states), places[] = { 0, length / 2, length - 1 };
  for (gsize i = 0; length > 0 && i < G_N_ELEMENTS (places); i++)
    for (const char *letter = "ksoy"; *letter != '\0'; letter++) {
      const char how[] = { 'l', 'e', 't', 't', 'e', 'r', ' ', *letter, '\0' };
      char before = states[places[i]];
      states[places[i]] = *letter;
      if (before != *letter)
        try_change (c, root, path, how);
      states[places[i]] = before;
    }
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
  if (g_str_has_suffix (path, ".states")) {
    change_states (c, root, item, path);
    return;
  }
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

static void
change_null (Case *c, const cJSON *root, cJSON *item, const char *path)
{
  item->type = cJSON_Number;
  cJSON_SetNumberValue (item, 0.5);
  try_change (c, root, path, "null");
  item->type = cJSON_String;
  item->valuestring = (char *) "snap";
  try_change (c, root, path, "null");
  item->type = cJSON_NULL;
  item->valuestring = NULL;
}

/* By more than rounding of the largest number in them; numbers by more than nothing beside those of
 * their list, rates by more than is compared. */
static gboolean
differs (const cJSON *a, const cJSON *b, const char *path, double of_list)
{
  double largest = MAX (largest_of (a), largest_of (b));
  double part = strstr (path, "mechanism[") != NULL ? RATE : NOTHING;
  if (cJSON_IsNumber (a) && cJSON_IsNumber (b))
    return fabs (a->valuedouble - b->valuedouble) > MAX (part * of_list, ROUNDING);
  if (!cJSON_IsArray (a) || cJSON_GetArraySize (a) != cJSON_GetArraySize (b))
    return !cJSON_Compare (a, b, TRUE);
  for (const cJSON *x = a->child, *y = b->child; x != NULL; x = x->next, y = y->next)
    if (cJSON_IsNumber (x) && cJSON_IsNumber (y)
          ? fabs (x->valuedouble - y->valuedouble) > MAX (LITTLE * largest, ROUNDING)
          : differs (x, y, path, of_list))
      return TRUE;
  return FALSE;
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
  else if (cJSON_IsNull (item))
    change_null (c, root, item, path);
  else if (cJSON_IsArray (item) || cJSON_IsObject (item))
    walk (c, root, item, path, largest);
}

static gboolean
is_picked (const Case *c, const cJSON *list, const cJSON *item, int index, int count)
{
  if (!c->thorough)
    return index + 1 == count;
  gboolean largest = cJSON_IsNumber (item) || cJSON_IsArray (item);
  double size = cJSON_IsNumber (item) ? fabs (item->valuedouble) : largest_of (item);
  return index == 0 || index == count / 2 || index + 1 == count
         || (largest && size > 0 && size == largest_of (list));
}

static void
set_children (cJSON *parent, const GPtrArray *items)
{
  parent->child = items->len > 0 ? items->pdata[0] : NULL;
  for (guint i = 0; i < items->len; i++) {
    cJSON *item = items->pdata[i];
    item->prev = items->pdata[i > 0 ? i - 1 : items->len - 1];
    item->next = i + 1 < items->len ? items->pdata[i + 1] : NULL;
  }
}

static void
try_children (Case *c, const cJSON *root, cJSON *parent, const GPtrArray *items,
              const char *path, const char *how)
{
  g_autoptr (GPtrArray) before = g_ptr_array_new ();
  for (cJSON *item = parent->child; item != NULL; item = item->next)
    g_ptr_array_add (before, item);
  set_children (parent, items);
  try_change (c, root, path, how);
  set_children (parent, before);
}

/* A member is left out; an element of a list also doubled, and exchanged with the one before. */
static void
change_place (Case *c, const cJSON *root, cJSON *parent, guint index, const char *path,
              double largest)
{
  g_autoptr (GPtrArray) items = g_ptr_array_new ();
  for (cJSON *item = parent->child; item != NULL; item = item->next)
    g_ptr_array_add (items, item);
  cJSON *item = items->pdata[index];
  if (cJSON_IsArray (parent)) {
    cJSON *copy = cJSON_Duplicate (item, TRUE);
    g_ptr_array_insert (items, (int) index, copy);
    try_children (c, root, parent, items, path, "doubled");
    g_ptr_array_remove_index (items, index);
    copy->next = NULL; /* it would be freed as well */
    cJSON_Delete (copy);
    if (index > 0 && differs (items->pdata[index - 1], item, path, largest)) {
      items->pdata[index] = items->pdata[index - 1];
      items->pdata[index - 1] = item;
      try_children (c, root, parent, items, path, "exchanged");
      items->pdata[index - 1] = items->pdata[index];
      items->pdata[index] = item;
    }
  }
  g_ptr_array_remove_index (items, index);
  try_children (c, root, parent, items, path, "left out");
}

/* Largest of the numbers of this name in a list of objects. */
static double
largest_member (const cJSON *list, const char *name)
{
  double largest = 0;
  const cJSON *object;
  cJSON_ArrayForEach (object, list)
  {
    const cJSON *item = cJSON_GetObjectItemCaseSensitive (object, name);
    if (cJSON_IsNumber (item))
      largest = MAX (largest, fabs (item->valuedouble));
  }
  return largest;
}

static void
walk (Case *c, cJSON *root, cJSON *parent, const char *path, double largest)
{
  int count = cJSON_GetArraySize (parent);
  gboolean is_list = cJSON_IsArray (parent);
  const cJSON *outer = c->list;
  if (is_list) {
    c->list = parent;
    largest = MAX (largest, largest_of (parent));
  }
  for (int i = 0; i < count; i++) {
    cJSON *item = cJSON_GetArrayItem (parent, i);
    if (is_list && !is_picked (c, parent, item, i, count))
      continue;
    g_autofree char *place =
      is_list ? g_strdup_printf ("%s[%d]", path, i)
              : g_strconcat (path, *path != '\0' ? "." : "", item->string, NULL);
    double size = is_list ? largest : 0;
    if (!is_list && g_str_has_suffix (item->string, "_force"))
      size = largest_member (c->list, item->string);
    change_item (c, root, item, place, size);
    change_place (c, root, parent, (guint) i, place, largest);
  }
  c->list = outer;
}

static void
test_source (gconstpointer data)
{
  const Source *source = data;
  Case c;
  g_autofree char *message = NULL;
  case_init (&c, source);
  g_autoptr (GPtrArray) unproved = g_ptr_array_new_with_free_func (g_free);
  gboolean whole = passes (&c, c.text, unproved, &message);
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

QN_TESTS
{
  g_test_set_nonfatal_assertions ();
  for (gsize i = 0; i < G_N_ELEMENTS (sources); i++) {
    g_autofree char *path = g_strdup_printf ("/io/tampering/%s", sources[i].name);
    if (g_test_slow () || sources[i].tries != SLOW)
      g_test_add_data_func (path, &sources[i], test_source);
  }
}
