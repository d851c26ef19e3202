#include "io/exchange/svg-style.h"

#include <string.h>

/* By QnSvgProperty, and the lengths that place shapes. Nothing else is kept of a style. */
static const char *const property_names[] = { "display",
                                              "visibility",
                                              "opacity",
                                              "fill",
                                              "fill-opacity",
                                              "fill-rule",
                                              "stroke",
                                              "stroke-opacity",
                                              "translate",
                                              "rotate",
                                              "scale",
                                              "transform",
                                              "transform-origin",
                                              "transform-box",
                                              "clip-path",
                                              "x",
                                              "y",
                                              "width",
                                              "height",
                                              "rx",
                                              "ry",
                                              "r",
                                              "cx",
                                              "cy",
                                              "x1",
                                              "y1",
                                              "x2",
                                              "y2" };

#define PROPERTY_NAME_COUNT G_N_ELEMENTS (property_names)

/* What styles say of each property: the value of the greatest rank. */
typedef struct Declared {
  struct {
    guint64 rank; /* an id before a class before neither, then the later rule; 0: none */
    const char *value;           /* borrowed */
  } of[PROPERTY_NAME_COUNT + 1]; /* the last one stands for all other names */
} Declared;

static guint
index_of (const char *name)
{
  guint i = 0;
  while (i < PROPERTY_NAME_COUNT && g_ascii_strcasecmp (name, property_names[i]) != 0)
    i++;
  return i;
}

/* Takes up "name: value; …", which it cuts apart: the last value of a name counts. */
static void
read_declarations (char *text, guint64 rank, Declared *declared)
{
  for (char *next; text != NULL; text = next) {
    if ((next = strchr (text, ';')) != NULL)
      *next++ = '\0';
    char *value = strchr (text, ':');
    if (value == NULL)
      continue;
    *value++ = '\0';
    value[strcspn (value, "!")] = '\0'; /* "!important" */
    guint i = index_of (g_strstrip (text));
    declared->of[i].rank = rank;
    declared->of[i].value = g_strstrip (value);
  }
}

void
qn_svg_style_init (QnSvgStyle *style)
{
  *style =
    (QnSvgStyle){ .selectors =
                    g_hash_table_new_full (g_str_hash, g_str_equal, g_free, g_free),
                  .texts = g_ptr_array_new_with_free_func ((GDestroyNotify) xmlFree) };
}

void
qn_svg_style_clear (QnSvgStyle *style)
{
  g_clear_pointer (&style->selectors, g_hash_table_unref);
  g_clear_pointer (&style->texts, g_ptr_array_unref);
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
add_rule (QnSvgStyle *style, char *selector, const Declared *rule)
{
  g_strstrip (selector);
  char *mark = selector + strcspn (selector, ".#");
  guint64 weight = *mark == '\0' ? 0 : *mark == '.' ? 1 : 2;
  g_autofree char *element = g_strndup (selector, (gsize) (mark - selector));
  gboolean any = strcmp (element, "*") == 0 || (*element == '\0' && weight > 0);
  if ((!any && !is_name (element)) || (weight > 0 && !is_name (mark + 1))) {
    style->odd++;
    return;
  }
  char *key = any ? mark : selector;
  Declared *all = g_hash_table_lookup (style->selectors, key);
  if (all == NULL) {
    all = g_new0 (Declared, 1);
    g_hash_table_insert (style->selectors, g_strdup (key), all);
  }
  for (guint i = 0; i < PROPERTY_NAME_COUNT; i++)
    if (rule->of[i].rank > 0) {
      all->of[i] = rule->of[i];
      all->of[i].rank += weight << 32;
    }
}

void
qn_svg_style_add (QnSvgStyle *style, const xmlNode *node)
{
  char *next = (char *) xmlNodeGetContent (node);
  g_ptr_array_add (style->texts, next);
  for (char *open = next; (open = strstr (open, "/*")) != NULL;) {
    const char *close = strstr (open + 2, "*/");
    memset (open, ' ', close != NULL ? (gsize) (close + 2 - open) : strlen (open));
  }
  for (char *rule = next; rule != NULL; rule = next) {
    if ((next = strchr (rule, '}')) != NULL)
      *next++ = '\0';
    char *open = strchr (rule, '{');
    if (open != NULL)
      *open = '\0';
    if (open == NULL || strstr (rule, "@font-face") != NULL)
      continue;
    if (strchr (rule, '@') != NULL) { /* of a medium */
      style->odd++;
      continue;
    }
    Declared declared = { 0 };
    read_declarations (open + 1, ++style->rule_count, &declared);
    g_auto (GStrv) selectors = g_strsplit (rule, ",", -1);
    for (char **selector = selectors; *selector != NULL; selector++)
      add_rule (style, *selector, &declared);
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

/* Takes up the rules for a mark and name, of this element or any. */
static void
take_rules (const QnSvgStyle *style, const xmlNode *node, const char *mark,
            const char *name, Declared *declared)
{
  for (int own = 0; own < 2; own++) {
    g_autofree char *key = g_strconcat (own ? qn_svg_name (node) : "", mark, name, NULL);
    const Declared *rules = g_hash_table_lookup (style->selectors, key);
    for (guint i = 0; rules != NULL && i < PROPERTY_NAME_COUNT; i++)
      if (rules->of[i].rank > declared->of[i].rank)
        declared->of[i] = rules->of[i];
  }
}

static void
take_properties (const QnSvgStyle *style, const xmlNode *node, guint first, guint count,
                 char **values)
{
  g_autofree char *id = qn_svg_dup_attribute (node, "id");
  g_autofree char *classes = qn_svg_dup_attribute (node, "class");
  g_autofree char *own = qn_svg_dup_attribute (node, "style");
  Declared declared = { 0 };
  if (g_hash_table_size (style->selectors) > 0) {
    g_auto (GStrv) words = g_strsplit_set (classes != NULL ? classes : "", " \t\r\n", -1);
    take_rules (style, node, "", "", &declared);
    for (char **word = words; *word != NULL; word++)
      take_rules (style, node, ".", *word, &declared);
    take_rules (style, node, "#", id != NULL ? id : "", &declared);
  }
  read_declarations (own, G_MAXUINT64, &declared);
  for (guint i = 0; i < count; i++)
    values[i] = declared.of[first + i].rank > 0
                  ? g_strdup (declared.of[first + i].value)
                  : qn_svg_dup_attribute (node, property_names[first + i]);
}

QnSvgProperties
qn_svg_properties_of (const QnSvgStyle *style, const xmlNode *node)
{
  QnSvgProperties own;
  take_properties (style, node, 0, QN_SVG_PROPERTY_COUNT, own.of);
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
  take_properties (style, node, index_of (name), 1, &value);
  return value;
}
