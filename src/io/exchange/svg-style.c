#include "io/exchange/svg-style.h"

#include <string.h>

typedef struct Rule {
  char *element, *name, *declarations; /* of an element; id or class, nullable */
  int weight;                          /* 2: an id, 1: a class, 0: neither */
} Rule;

static void
free_rule (gpointer data)
{
  Rule *rule = data;
  g_free (rule->element);
  g_free (rule->name);
  g_free (rule->declarations);
  g_free (rule);
}

void
qn_svg_style_init (QnSvgStyle *style)
{
  *style = (QnSvgStyle){ .rules = g_ptr_array_new_with_free_func (free_rule) };
}

void
qn_svg_style_clear (QnSvgStyle *style)
{
  g_clear_pointer (&style->rules, g_ptr_array_unref);
}

static gboolean
is_name (const char *text)
{
  if (*text == '\0')
    return FALSE;
  for (; *text != '\0'; text++)
    if (!g_ascii_isalnum (*text) && *text != '-' && *text != '_' && !(*text & 0x80))
      return FALSE;
  return TRUE;
}

static void
add_rule (QnSvgStyle *style, char *selector, const char *declarations)
{
  g_strstrip (selector);
  char *mark = strpbrk (selector, ".#");
  int weight = mark == NULL ? 0 : *mark == '.' ? 1 : 2;
  if (mark != NULL)
    *mark = '\0';
  gboolean any = strcmp (selector, "*") == 0 || (*selector == '\0' && mark != NULL);
  if ((!any && !is_name (selector)) || (mark != NULL && !is_name (mark + 1))) {
    style->odd++;
    return;
  }
  Rule *rule = g_new (Rule, 1);
  *rule =
    (Rule){ any ? NULL : g_strdup (selector), mark != NULL ? g_strdup (mark + 1) : NULL,
            g_strdup (declarations), weight };
  g_ptr_array_add (style->rules, rule);
}

void
qn_svg_style_add (QnSvgStyle *style, const xmlNode *node)
{
  xmlChar *content = xmlNodeGetContent (node);
  g_autoptr (GString) text = g_string_new ((const char *) content);
  xmlFree (content);
  for (char *open; (open = strstr (text->str, "/*")) != NULL;) {
    char *close = strstr (open + 2, "*/");
    g_string_erase (text, open - text->str, close != NULL ? close + 2 - open : -1);
  }
  g_auto (GStrv) rules = g_strsplit (text->str, "}", -1);
  for (char **rule = rules; *rule != NULL; rule++) {
    char *open = strchr (*rule, '{');
    if (open == NULL)
      continue;
    *open = '\0';
    if (strstr (*rule, "@font-face") != NULL)
      continue;
    if (strchr (*rule, '@') != NULL) { /* of a medium */
      style->odd++;
      continue;
    }
    g_auto (GStrv) selectors = g_strsplit (*rule, ",", -1);
    for (char **selector = selectors; *selector != NULL; selector++)
      add_rule (style, *selector, open + 1);
  }
}

const char *
qn_svg_name (const xmlNode *node)
{
  const char *name = (const char *) node->name, *colon = strchr (name, ':');
  return colon != NULL ? colon + 1 : name;
}

char *
qn_svg_dup_attribute (const xmlNode *node, const char *key)
{
  const char *colon = strchr (key, ':');
  const char *local = colon != NULL ? colon + 1 : key;
  for (const xmlAttr *a = node->properties; a != NULL; a = a->next) {
    const char *name = (const char *) a->name;
    gboolean spaced = a->ns != NULL && a->ns->prefix != NULL;
    if (colon == NULL ? spaced || strcmp (name, key) != 0
                      : strcmp (name, local) != 0 && strcmp (name, key) != 0)
      continue;
    xmlChar *content = xmlNodeGetContent ((const xmlNode *) a);
    char *value = g_strdup ((const char *) content);
    xmlFree (content);
    return value;
  }
  return NULL;
}

/* Whether one of the words of a list is this. */
static gboolean
list_has_word (const char *list, const char *word)
{
  g_auto (GStrv) words = g_strsplit_set (list, " \t\r\n", -1);
  return g_strv_contains ((const char *const *) words, word);
}

static gboolean
matches (const Rule *rule, const xmlNode *node, const char *id, const char *classes)
{
  return (rule->element == NULL || strcmp (qn_svg_name (node), rule->element) == 0)
         && (rule->weight != 1
             || (classes != NULL && list_has_word (classes, rule->name)))
         && (rule->weight != 2 || g_strcmp0 (id, rule->name) == 0);
}

/* Takes up what declarations say of the properties of these names; the last one counts. */
static void
take_declarations (const char *text, const char *const *names, guint count, char **values)
{
  g_auto (GStrv) all = g_strsplit (text, ";", -1);
  for (char **one = all; *one != NULL; one++) {
    char *colon = strchr (*one, ':');
    if (colon == NULL)
      continue;
    *colon = '\0';
    char *important = strchr (colon + 1, '!');
    if (important != NULL)
      *important = '\0';
    const char *name = g_strstrip (*one);
    for (guint i = 0; i < count; i++)
      if (g_ascii_strcasecmp (name, names[i]) == 0) {
        g_free (values[i]);
        values[i] = g_strdup (g_strstrip (colon + 1));
      }
  }
}

static void
take_properties (const QnSvgStyle *style, const xmlNode *node, const char *const *names,
                 guint count, char **values)
{
  g_autofree char *id = qn_svg_dup_attribute (node, "id");
  g_autofree char *classes = qn_svg_dup_attribute (node, "class");
  g_autofree char *declared = qn_svg_dup_attribute (node, "style");
  for (guint i = 0; i < count; i++)
    values[i] = qn_svg_dup_attribute (node, names[i]);
  for (int weight = 0; weight <= 2; weight++)
    for (guint i = 0; i < style->rules->len; i++) {
      const Rule *rule = style->rules->pdata[i];
      if (rule->weight == weight && matches (rule, node, id, classes))
        take_declarations (rule->declarations, names, count, values);
    }
  if (declared != NULL)
    take_declarations (declared, names, count, values);
}

QnSvgProperties
qn_svg_properties_of (const QnSvgStyle *style, const xmlNode *node)
{
  static const char *const names[QN_SVG_PROPERTY_COUNT] = {
    "display",   "visibility", "opacity",          "fill",          "fill-opacity",
    "fill-rule", "stroke",     "stroke-opacity",   "translate",     "rotate",
    "scale",     "transform",  "transform-origin", "transform-box", "clip-path",
  };
  QnSvgProperties own;
  take_properties (style, node, names, QN_SVG_PROPERTY_COUNT, own.of);
  if (style->odd > 0
      && own.of[QN_SVG_STROKE] == NULL) /* a rule that is not followed may draw it */
    own.of[QN_SVG_STROKE] = g_strdup ("unknown");
  return own;
}

void
qn_svg_properties_clear (QnSvgProperties *properties)
{
  for (int i = 0; i < QN_SVG_PROPERTY_COUNT; i++)
    g_free (properties->of[i]);
}

char *
qn_svg_dup_property (const QnSvgStyle *style, const xmlNode *node, const char *name)
{
  char *value;
  take_properties (style, node, &name, 1, &value);
  return value;
}
