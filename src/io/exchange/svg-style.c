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
    style->odd = TRUE;
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
    if (strchr (*rule, '@') != NULL) { /* of a medium, or a font */
      style->odd = TRUE;
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

/* Takes up what declarations say; the last one counts. */
static void
take_declarations (QnSvgProperties *own, const char *text)
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
    char **place = strcmp (name, "display") == 0      ? &own->display
                   : strcmp (name, "visibility") == 0 ? &own->visibility
                   : strcmp (name, "fill") == 0       ? &own->fill
                   : strcmp (name, "stroke") == 0     ? &own->stroke
                   : strcmp (name, "fill-rule") == 0  ? &own->fill_rule
                   : strcmp (name, "transform") == 0  ? &own->transform
                   : strcmp (name, "clip-path") == 0  ? &own->clip_path
                                                      : NULL;
    if (place == NULL)
      continue;
    g_free (*place);
    *place = g_strdup (g_strstrip (colon + 1));
  }
}

QnSvgProperties
qn_svg_properties_of (const QnSvgStyle *style, const xmlNode *node)
{
  QnSvgProperties own = { .display = qn_svg_dup_attribute (node, "display"),
                          .visibility = qn_svg_dup_attribute (node, "visibility"),
                          .fill = qn_svg_dup_attribute (node, "fill"),
                          .stroke = qn_svg_dup_attribute (node, "stroke"),
                          .fill_rule = qn_svg_dup_attribute (node, "fill-rule"),
                          .transform = qn_svg_dup_attribute (node, "transform"),
                          .clip_path = qn_svg_dup_attribute (node, "clip-path") };
  g_autofree char *id = qn_svg_dup_attribute (node, "id");
  g_autofree char *classes = qn_svg_dup_attribute (node, "class");
  g_autofree char *declared = qn_svg_dup_attribute (node, "style");
  for (int weight = 0; weight <= 2; weight++)
    for (guint i = 0; i < style->rules->len; i++) {
      const Rule *rule = style->rules->pdata[i];
      if (rule->weight == weight && matches (rule, node, id, classes))
        take_declarations (&own, rule->declarations);
    }
  if (declared != NULL)
    take_declarations (&own, declared);
  if (style->odd && own.stroke == NULL) /* a rule that is not followed may draw it */
    own.stroke = g_strdup ("unknown");
  return own;
}

void
qn_svg_properties_clear (QnSvgProperties *properties)
{
  g_free (properties->display);
  g_free (properties->visibility);
  g_free (properties->fill);
  g_free (properties->stroke);
  g_free (properties->fill_rule);
  g_free (properties->transform);
  g_free (properties->clip_path);
}
