#include "doc/document/document.h"

#include "io/project/project.h"
#include "render/drawing/text.h"
#include <glib/gi18n-lib.h>
#include <string.h>

/* A label says at most so much of what differs. */
#define MOST_CHANGES 2

/* ---- what differs ---- */

/* Members of the model; blocks follow from masonry, and are looked at where that is the same. */
static const char *const members[] = { "laws",     "masonry", "walls",   "blocks",
                                       "sections", "beams",   "bars",    "ties",
                                       "contact",  "loads",   "gravity", "analysis" };

/* Those that only say which blocks there are. */
static const char *const masonry[] = { "masonry", "walls", "blocks", NULL };

/* Keys that read better otherwise than with a space for "_", and their units; values that are choices. */
static const struct {
  const char *key, *words, *unit;
} words[] = {
  { "friction", N_ ("friction"), "" },
  { "cohesion", N_ ("cohesion"), "" },
  { "tension", N_ ("tensile strength"), "" },
  { "dilatancy", N_ ("dilatancy"), "" },
  { "unit", N_ ("brick"), " m" },
  { "thickness", N_ ("thickness"), " m" },
  { "unit_weight", N_ ("unit weight"), " N/m³" },
  { "size", N_ ("size"), " m" },
  { "value", N_ ("force"), " N" },
  { "laws", N_ ("laws of joints"), "" },
  { "masonry", N_ ("masonry"), "" },
  { "walls", N_ ("walls"), "" },
  { "blocks", N_ ("blocks"), "" },
  { "sections", N_ ("sections"), "" },
  { "beams", N_ ("beams"), "" },
  { "bars", N_ ("bars"), "" },
  { "ties", N_ ("ties"), "" },
  { "contact", N_ ("contacts"), "" },
  { "loads", N_ ("loads"), "" },
  { "live", N_ ("growing loads"), "" },
  { "dead", N_ ("constant loads"), "" },
  { "gravity", N_ ("gravity"), " m/s²" },
  { "analysis", N_ ("analysis"), "" },
  { "procedure", N_ ("method"), "" },
  { "geometry", N_ ("geometry"), "" },
  { "increments", N_ ("increments"), "" },
  { "flow", N_ ("flow"), "" },
  { "linear", N_ ("linear"), NULL },
  { "nonlinear", N_ ("nonlinear"), NULL },
  { "load", N_ ("load control"), NULL },
  { "displacement", N_ ("displacement control"), NULL },
  { "work", N_ ("work control"), NULL },
  { "arc-length", N_ ("arc length"), NULL },
  { "limit", N_ ("limit analysis"), NULL },
  { "dynamic", N_ ("analysis in time"), NULL },
  { "associative", N_ ("associative"), NULL },
  { "non-associative", N_ ("non-associative"), NULL },
};

typedef struct Changes {
  GPtrArray *found; /* of char * */
  const char *key;  /* of the member that is compared */
  const char *of;   /* name of its element, where there are several, or NULL */
} Changes;

/* What is said for a key, or for a value of these choices; NULL where that is itself. */
static const char *
find_words (const char *key, gboolean value, const char **unit)
{
  for (gsize i = 0; i < G_N_ELEMENTS (words); i++)
    if ((words[i].unit == NULL) == value && g_str_equal (words[i].key, key)) {
      *unit = words[i].unit;
      return _ (words[i].words);
    }
  return NULL;
}

static char *
dup_value (const cJSON *item)
{
  g_autoptr (GStrvBuilder) parts = g_strv_builder_new ();
  const cJSON *each;
  if (cJSON_IsNumber (item))
    return qn_label_number ("%.6g", item->valuedouble);
  if (cJSON_IsString (item)) {
    const char *unit, *said = NULL;
    if (item->string != NULL && !g_str_equal (item->string, "name"))
      said = find_words (item->valuestring, TRUE, &unit);
    return g_strdup (said != NULL ? said : item->valuestring);
  }
  if (cJSON_IsBool (item))
    return g_strdup (cJSON_IsTrue (item) ? _ ("yes") : _ ("no"));
  cJSON_ArrayForEach (each, item)
  {
    if (!cJSON_IsNumber (each))
      return NULL;
    g_autofree char *number = dup_value (each);
    g_strv_builder_add (parts, number);
  }
  g_auto (GStrv) numbers = g_strv_builder_end (parts);
  return numbers[0] != NULL ? g_strjoinv (" × ", numbers) : NULL;
}

static void
tell (Changes *changes, const char *value)
{
  g_autofree char *key = g_strdelimit (g_strdup (changes->key), "_", ' ');
  const char *unit = "", *name = find_words (changes->key, FALSE, &unit);
  name = name != NULL ? name : key;
  g_autofree char *said = value != NULL ? g_strdup_printf ("%s %s%s", name, value, unit)
                                        : g_strdup_printf (_ ("other %s"), name);
  g_ptr_array_add (changes->found, changes->of != NULL
                                     ? g_strdup_printf ("%s: %s", changes->of, said)
                                     : g_steal_pointer (&said));
}

static void
compare_values (Changes *changes, const cJSON *from, const cJSON *to)
{
  g_autofree char *value = dup_value (to);
  if (cJSON_Compare (from, to, TRUE))
    return;
  if (value != NULL)
    tell (changes, value);
  else if (cJSON_IsObject (from) && cJSON_IsObject (to)) {
    const cJSON *item;
    cJSON_ArrayForEach (item, to)
    {
      changes->key = item->string;
      compare_values (changes, cJSON_GetObjectItemCaseSensitive (from, item->string),
                      item);
    }
    cJSON_ArrayForEach (item, from)
    {
      if (cJSON_HasObjectItem (to, item->string))
        continue;
      changes->key = item->string;
      tell (changes, _ ("none"));
    }
  } else if (cJSON_IsArray (from) && cJSON_IsArray (to)
             && cJSON_GetArraySize (from) == cJSON_GetArraySize (to)) {
    const char *key = changes->key, *of = changes->of;
    const cJSON *old = from->child;
    gboolean several = cJSON_GetArraySize (to) > 1;
    for (const cJSON *each = to->child; each != NULL;
         each = each->next, old = old->next) {
      changes->key = key;
      changes->of =
        several ? cJSON_GetStringValue (cJSON_GetObjectItemCaseSensitive (each, "name"))
                : of;
      compare_values (changes, old, each);
    }
    changes->of = of;
  } else
    tell (changes, cJSON_GetArraySize (to) > 0 ? NULL : _ ("none"));
}

/* How many blocks have gone where all others are as they were; 0: something else is different too. */
static gulong
count_removed (const QnModel *from, const QnModel *to)
{
  size_t left = 0;
  for (size_t i = 0; i < from->block_count && left < to->block_count; i++) {
    const QnBlock *old = &from->blocks[i], *new = &to->blocks[left];
    left += g_str_equal (old->name, new->name) && old->area == new->area
            && old->centroid.x == new->centroid.x && old->centroid.y == new->centroid.y;
  }
  return left == to->block_count ? (gulong) (from->block_count - left) : 0;
}

GPtrArray *
qn_run_list_changes (const QnRun *from, const QnRun *to)
{
  if (from->text == NULL || to->text == NULL)
    return NULL;
  cJSON *old = cJSON_Parse (from->text), *new = cJSON_Parse (to->text);
  Changes changes = { .found = g_ptr_array_new_with_free_func (g_free) };
  const gulong removed = count_removed (&from->model, &to->model);
  if (removed > 0)
    g_ptr_array_add (
      changes.found,
      g_strdup_printf (ngettext ("%lu block removed", "%lu blocks removed", removed),
                       removed));
  for (gsize i = 0; i < G_N_ELEMENTS (members); i++) {
    if (removed > 0 && g_strv_contains (masonry, members[i]))
      continue;
    const cJSON *a = cJSON_GetObjectItemCaseSensitive (old, members[i]);
    const cJSON *b = cJSON_GetObjectItemCaseSensitive (new, members[i]);
    changes.key = members[i];
    if ((a != NULL || b != NULL) && !cJSON_Compare (a, b, TRUE))
      compare_values (&changes, a, b);
  }
  cJSON_Delete (old);
  cJSON_Delete (new);
  return changes.found;
}

/* ---- labels ---- */

static gboolean
is_of_same_model (const QnRun *a, const QnRun *b)
{
  return g_strcmp0 (a->fingerprint, b->fingerprint) == 0;
}

static char *
propose (QnDocument *self, const QnRun *run)
{
  const QnRun *bases[2] = { NULL, NULL }; /* the first, and the last before this one */
  for (guint i = 0; i < self->runs->len; i++) {
    const QnRun *other = g_ptr_array_index (self->runs, i);
    if (other->live || other->text == NULL)
      continue;
    if (is_of_same_model (other, run))
      return g_strdup (other->proposed);
    bases[0] = bases[0] != NULL ? bases[0] : other;
    bases[1] = other;
  }
  self->run_number++;
  for (gsize i = 0; i < G_N_ELEMENTS (bases) && bases[i] != NULL; i++) {
    g_autoptr (GPtrArray) changes = qn_run_list_changes (bases[i], run);
    if (changes == NULL || changes->len == 0 || changes->len > MOST_CHANGES)
      continue;
    g_ptr_array_add (changes, NULL);
    return g_strjoinv (", ", (char **) changes->pdata);
  }
  return g_strdup_printf (_ ("Run %u"), self->run_number);
}

/* The digest of the whole model, without that of its structure. */
static char *
dup_digest (const QnRun *run)
{
  const char *fingerprint = run->fingerprint != NULL ? run->fingerprint : "";
  const char *end = strchr (fingerprint, ' ');
  return end != NULL ? g_strndup (fingerprint, (gsize) (end - fingerprint)) : NULL;
}

static cJSON *
read_names (QnDocument *self)
{
  g_autofree char *json = qn_project_dup_extra (&self->project, QN_RUN_NAMES_MEMBER);
  cJSON *names = json != NULL ? cJSON_Parse (json) : NULL;
  if (cJSON_IsObject (names))
    return names;
  cJSON_Delete (names);
  return cJSON_CreateObject ();
}

gboolean
qn_document_name_runs (QnDocument *self)
{
  gboolean changed = FALSE;
  cJSON *names = read_names (self);
  for (guint i = 0; i < self->runs->len; i++) {
    QnRun *run = g_ptr_array_index (self->runs, i);
    g_autofree char *digest = run->proposed != NULL ? dup_digest (run) : NULL;
    if (digest == NULL)
      continue;
    const char *given =
      cJSON_GetStringValue (cJSON_GetObjectItemCaseSensitive (names, digest));
    const char *label = given != NULL ? given : run->proposed;
    if (g_strcmp0 (label, run->label) == 0)
      continue;
    g_free (run->label);
    g_free (run->name);
    run->label = g_strdup (label);
    run->name = g_strdup_printf (_ ("%s, %s"), label, run->method);
    changed = TRUE;
  }
  cJSON_Delete (names);
  return changed;
}

void
qn_document_take_run (QnDocument *self, QnRun *run, const char *text)
{
  run->method = g_steal_pointer (&run->name);
  run->text = g_strdup (text);
  run->proposed = propose (self, run);
  /* The same again replaces what was there. */
  for (guint i = self->runs->len; i-- > 0;) {
    const QnRun *old = g_ptr_array_index (self->runs, i);
    if (old->kind == run->kind && old->loaded == run->loaded
        && is_of_same_model (old, run) && g_strcmp0 (old->method, run->method) == 0)
      g_ptr_array_remove_index (self->runs, i);
  }
}

gboolean
qn_document_rename_run (QnDocument *self, const QnRun *run, const char *label,
                        GError **error)
{
  g_autofree char *digest = dup_digest (run);
  g_autofree char *text = g_strstrip (g_strdup (label != NULL ? label : ""));
  if (digest == NULL || run->proposed == NULL || g_strcmp0 (text, run->label) == 0)
    return TRUE;
  cJSON *names = read_names (self);
  cJSON_DeleteItemFromObjectCaseSensitive (names, digest);
  if (*text != '\0' && !g_str_equal (text, run->proposed))
    cJSON_AddStringToObject (names, digest, text);
  char *json = names->child != NULL ? cJSON_PrintUnformatted (names) : NULL;
  gboolean done = qn_document_edit_extra (self, _ ("Rename Run"), NULL,
                                          QN_RUN_NAMES_MEMBER, json, error);
  cJSON_free (json);
  cJSON_Delete (names);
  return done;
}
