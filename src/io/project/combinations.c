#include "io/project/combinations.h"

#include "core/model/model.h"
#include "io/json/json-path.h"
#include "io/text/io-error.h"
#include "io/text/text-format.h"

#include <cjson/cJSON.h>
#include <gio/gio.h>
#include <glib/gi18n-lib.h>
#include <string.h>

/* data/codes, made by the build. */
GResource *qn_io_get_resource (void);

/* Choices that are tried in one situation. */
#define MOST_CHOICES 1000000

/* Of a case in a situation. */
typedef enum { ABSENT, PRESENT, LEADING, CHOICE_COUNT } Choice;

typedef struct Case {
  const char *name, *action;
  double base;                  /* its own factor */
  double factors[CHOICE_COUNT]; /* those of the situation */
  int first, last;              /* choices that it has; that now: */
  int choice;
  gboolean exclusive, variable, seismic;
} Case;

static const cJSON *
get (const cJSON *object, const char *key)
{
  return cJSON_GetObjectItemCaseSensitive (object, key);
}

static double
number_at (const cJSON *list, int index)
{
  return cJSON_GetNumberValue (cJSON_GetArrayItem (list, index));
}

/* The file of the codes, which is read once. */
static const cJSON *
codes (void)
{
  static gsize file;
  if (g_once_init_enter (&file)) {
    g_autoptr (GBytes) bytes = g_resource_lookup_data (
      qn_io_get_resource (), "/io/github/quoin/codes/combinations.json", 0, NULL);
    gsize length;
    const char *text = g_bytes_get_data (bytes, &length);
    g_once_init_leave (&file, (gsize) cJSON_ParseWithLength (text, length));
  }
  return (const cJSON *) file;
}

static void
add_keys (GStrvBuilder *names, const cJSON *object)
{
  for (const cJSON *item = object->child; item != NULL; item = item->next)
    g_strv_builder_add (names, item->string);
}

char **
qn_combinations_dup_codes (void)
{
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  add_keys (names, get (codes (), "codes"));
  return g_strv_builder_end (names);
}

char **
qn_combinations_dup_actions (void)
{
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  g_strv_builder_add_many (names, "permanent", "non-structural", NULL);
  add_keys (names, get (codes (), "psi"));
  g_strv_builder_add (names, "seismic");
  return g_strv_builder_end (names);
}

/* A factor of a code, times the psi whose index stands behind it. */
static double
reduced (const cJSON *factor, const cJSON *psi)
{
  return number_at (factor, 0)
         * (cJSON_GetArraySize (factor) > 1 ? number_at (psi, (int) number_at (factor, 1))
                                            : 1);
}

/* Sets the role of a case in a situation. */
static void
place_case (Case *c, const cJSON *situation)
{
  const cJSON *psi = get (get (codes (), "psi"), c->action), *alone;
  const cJSON *permanent = get (situation, c->action), *leading;
  c->seismic = strcmp (c->action, "seismic") == 0;
  c->variable = psi != NULL;
  c->exclusive = FALSE;
  cJSON_ArrayForEach (alone, get (codes (), "exclusive")) c->exclusive |=
    strcmp (alone->valuestring, c->action) == 0;
  c->first = ABSENT;
  c->last = PRESENT;
  c->factors[ABSENT] = 0;
  if (psi != NULL) {
    leading = get (situation, "leading");
    c->factors[PRESENT] = reduced (get (situation, "others"), psi);
    c->factors[LEADING] = leading != NULL ? reduced (leading, psi) : 0;
    c->last = leading != NULL ? LEADING : PRESENT;
    if (cJSON_IsTrue (get (situation, "always")) && !c->exclusive)
      c->first = PRESENT;
  } else if (c->seismic) {
    c->last = cJSON_IsTrue (get (situation, "seismic")) ? PRESENT : ABSENT;
    c->factors[PRESENT] = 1;
  } else if (*c->action != '\0') {
    c->factors[ABSENT] = number_at (permanent, 0);
    c->factors[PRESENT] = number_at (permanent, 1);
  } else {
    c->last = ABSENT;
    c->factors[ABSENT] = 1;
  }
  c->choice = c->first;
}

/* Whether the choices make a combination of the situation. */
static gboolean
is_possible (const Case *cases, gsize count, const cJSON *situation)
{
  guint leading = 0, present = 0, seismic = 0;
  for (gsize i = 0; i < count; i++) {
    const Case *c = &cases[i];
    leading += c->choice == LEADING;
    present += c->variable && c->choice != ABSENT;
    seismic += c->seismic && c->choice != ABSENT;
    for (gsize k = 0; k < i && c->exclusive && c->choice != ABSENT; k++)
      if (cases[k].choice != ABSENT && strcmp (cases[k].action, c->action) == 0)
        return FALSE;
  }
  return leading == (present > 0 && get (situation, "leading") != NULL)
         && seismic == (guint) cJSON_IsTrue (get (situation, "seismic"));
}

/* The next choices; FALSE after the last ones. */
static gboolean
next_case (Case *cases, gsize count)
{
  for (gsize i = count; i-- > 0;) {
    if (cases[i].choice++ < cases[i].last)
      return TRUE;
    cases[i].choice = cases[i].first;
  }
  return FALSE;
}

static void
free_combination (gpointer data)
{
  QnCombination *combination = data;
  g_free (combination->name);
  g_free (combination->label);
  g_free (combination->factors);
  g_free (combination);
}

/* Adds the combination of the choices, unless the list has its factors. Those of seismic situations,
 * with other factors of resistance, differ by the factor of an earthquake. */
static void
add_combination (GPtrArray *list, const Case *cases, gsize count,
                 const QnCombinationRules *rules, const cJSON *situation)
{
  char number[QN_NUMBER_TEXT_SIZE];
  gboolean seismic = cJSON_IsTrue (get (situation, "seismic"));
  g_autofree double *factors = g_new (double, count);
  const char *title = get (situation, "name")->valuestring;
  g_autoptr (GString) name = g_string_new (title), label = g_string_new (title);
  const char *between = ": ";
  for (gsize i = 0; i < count; i++)
    factors[i] = cases[i].factors[cases[i].choice];
  for (guint i = 0; i < list->len; i++)
    if (memcmp (((QnCombination *) list->pdata[i])->factors, factors,
                count * sizeof *factors)
        == 0)
      return;
  for (gsize i = 0; i < count; i++) {
    if (factors[i] == 0 || *cases[i].action == '\0')
      continue;
    g_ascii_formatd (number, sizeof number, "%.5g", factors[i]);
    const char *sign = strchr (number, '.');
    g_string_append_printf (name, "%s%s %s", between, number, cases[i].name);
    g_string_append_printf (label, "%s%.*s%s%s %s", between, (int) strcspn (number, "."),
                            number, sign != NULL ? C_ ("decimal sign", ".") : "",
                            sign != NULL ? sign + 1 : "", cases[i].name);
    between = " + ";
  }
  QnCombination *added = g_new (QnCombination, 1);
  *added = (QnCombination){
    .name = g_string_free (g_steal_pointer (&name), FALSE),
    .label = g_string_free (g_steal_pointer (&label), FALSE),
    .factors = g_steal_pointer (&factors),
    .friction = seismic ? rules->seismic_friction : rules->friction,
    .strength = seismic ? rules->seismic_strength : rules->strength,
  };
  g_ptr_array_add (list, added);
}

static gboolean
add_situation (GPtrArray *list, Case *cases, gsize count, const QnModel *model,
               const cJSON *situation)
{
  double choices = 1;
  for (gsize i = 0; i < count; i++) {
    place_case (&cases[i], situation);
    choices *= cases[i].last - cases[i].first + 1;
  }
  if (choices > MOST_CHOICES)
    return FALSE;
  do
    if (is_possible (cases, count, situation))
      add_combination (list, cases, count, &model->combinations, situation);
  while (list->len <= QN_MAX_COMBINATIONS && next_case (cases, count));
  return list->len <= QN_MAX_COMBINATIONS;
}

GPtrArray *
qn_combinations_make (const QnProject *project, GError **error)
{
  const QnModel *model = &project->model;
  g_autoptr (GPtrArray) list = g_ptr_array_new_with_free_func (free_combination);
  g_autofree Case *cases = g_new0 (Case, model->load_case_count + 1);
  gboolean any = FALSE, few = TRUE;
  for (gsize i = 0; i < model->load_case_count; i++) {
    cases[i].name = model->load_cases[i].name;
    cases[i].action = model->load_cases[i].action;
    any |= *cases[i].action != '\0';
  }
  if (any && *model->combinations.code != '\0') {
    const cJSON *code = get (get (codes (), "codes"), model->combinations.code),
                *situation;
    cJSON_ArrayForEach (situation, get (code, "situations")) few =
      few && add_situation (list, cases, model->load_case_count, model, situation);
  }
  if (list->len > 0 && few)
    return g_steal_pointer (&list);
  g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
               few ? _ ("%s: nothing to combine: \"loads.combinations\" names the code, "
                        "and \"action\" of a load case what it is")
                   : _ ("%s: more than 1,000 combinations of load cases"),
               project->name);
  return NULL;
}

/* ---- a combination of the project ---- */

static void
add_override (GPtrArray *overrides, GString *path, double value)
{
  char number[QN_NUMBER_TEXT_SIZE];
  g_ptr_array_add (overrides,
                   g_strconcat (path->str, "=", qn_number_text (value, number), NULL));
  g_string_free (path, TRUE);
}

static gboolean
has_live_load (const QnCombination *combination, const QnModel *model)
{
  for (gsize i = 0; i < model->live_load_count; i++) {
    int32_t number = model->live_loads[i].load_case;
    if (number == 0
        || combination->factors[number - 1] * model->load_cases[number - 1].factor != 0)
      return TRUE;
  }
  return FALSE;
}

void
qn_combination_add_overrides (const QnCombination *combination, const QnModel *model,
                              GPtrArray *overrides)
{
  static const char *const slips[] = { "friction", "residual_friction", "dilatancy",
                                       NULL };
  static const char *const bonds[] = { "cohesion", "tension", "compression", NULL };
  for (gsize i = 0; i < model->load_case_count; i++) {
    GString *path = g_string_new ("loads.cases");
    qn_json_path_append (path, model->load_cases[i].name, 0);
    add_override (overrides, path, combination->factors[i] * model->load_cases[i].factor);
  }
  for (gsize i = 0; i < model->law_count; i++) {
    gsize count;
    const QnLaw *law = &model->laws[i];
    const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
    for (gsize k = 0; k < count && qn_law_may_bond (law->kind); k++) {
      const char *key = parameters[k].key;
      double value = qn_law_get (law, &parameters[k]);
      double factor = g_strv_contains (slips, key)   ? combination->friction
                      : g_strv_contains (bonds, key) ? combination->strength
                                                     : 1;
      if (factor == 1 || value == 0)
        continue;
      GString *path = g_string_new ("laws");
      qn_json_path_append (path, NULL, i);
      qn_json_path_append (path, key, 0);
      add_override (overrides, path, value / factor);
    }
  }
  if (has_live_load (combination, model))
    return;
  g_ptr_array_add (overrides, g_strdup ("analysis.procedure=load"));
  g_ptr_array_add (overrides, g_strdup ("analysis.max_multiplier=0"));
}
