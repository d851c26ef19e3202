#include "core/base/word.h"
#include "io/exchange/import-work.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* Words of English, German, French and Italian, in lower case and without accents. */
static const struct {
  QnRole role;
  const char *words;
} role_words[] = {
  { QN_ROLE_SUPPORT,
    " support supports fixed base bases ground foundation foundations found footing "
    "footings terrain rock soil"
    " auflager fundament fundamente sockel baugrund gelande"
    " appui appuis fixe fixes fondation fondations socle"
    " appoggio appoggi fisso fissi fondazione fondazioni vincolo vincoli basamento "
    "terreno " },
  { QN_ROLE_OPENING,
    " opening openings void voids hole holes window windows door doors"
    " offnung offnungen oeffnung oeffnungen aussparung aussparungen fenster tur turen "
    "tuer tueren"
    " ouverture ouvertures fenetre fenetres porte portes vide vides baie baies trou trous"
    " apertura aperture finestra finestre porta vuoto vuoti foro fori " },
  { QN_ROLE_IGNORED,
    " dim dims dimension dimensions text texts axis axes hatch hatches hatching defpoint"
    " defpoints contact contacts deformed grid grids anno annotation annotations"
    " title titleblock border legend viewport viewports vport crack cracks"
    " bemassung vermassung hilfslinien plankopf legende riss risse texte achse achsen "
    "schraffur schraffuren raster beschriftung"
    " cote cotes cotation cotations textes axe hachure hachures cartouche fissure "
    "fissures"
    " quota quote quotatura testo testi asse assi retino retini tratteggio griglia "
    "cartiglio"
    " legenda lesione lesioni " },
  /* What is built, whatever else the name says. */
  { QN_ROLE_BLOCK,
    " block blocks stone stones brick bricks masonry wall walls arch arches vault "
    "voussoir"
    " voussoirs pier piers column columns lintel lintels sill sills jamb jambs frame "
    "frames"
    " surround beam beams slab course courses floor floors storey storeys story stories"
    " stein steine ziegel wand wande waende mauer mauern mauerwerk bogen pfeiler saule "
    "saulen"
    " sturz geschoss"
    " pierre pierres brique briques maconnerie mur murs arc arcs voute voutes pilier "
    "piliers"
    " linteau linteaux etage"
    " pietra pietre mattone mattoni muratura muro muri arco archi concio conci pilastro"
    " pilastri piano " },
};

/* Of these one is enough, wherever it stands: "fixed blocks". */
static const char sure_supports[] = " support supports fixed auflager appui appuis fixe "
                                    "fixes appoggio appoggi fisso fissi ";

/* Words that say nothing. */
static const char neutral[] = " layer ebene calque livello quoin left right north south "
                              "east west top bottom new line lines"
                              " of the de du des la le les di del della von der die das ";

static const char *const role_names[] = { "block", "support", "opening", "ignored" };

gboolean
qn_import_check_layers (const QnImportSettings *settings, GError **error)
{
  for (char **layer = settings->layers; layer != NULL && *layer != NULL; layer++) {
    const char *equals = strrchr (*layer, '=');
    QnRole role;
    if (equals == NULL || !qn_find_word (equals + 1, role_names, QN_ROLE_COUNT, &role))
      return qn_io_fail (error, QN_IO_ERROR_OVERRIDE,
                         _ ("%s: expected NAME=block, support, opening or ignored"),
                         *layer);
  }
  return TRUE;
}

/* Whether an entry of the table of layers means this one: by its whole name, or by a pattern with *
 * and ?; case does not matter. */
static gboolean
means_layer (const char *entry, const char *layer, gboolean pattern)
{
  g_autofree char *name = g_strndup (entry, (gsize) (strrchr (entry, '=') - entry));
  g_autofree char *wanted = g_utf8_casefold (name, -1);
  g_autofree char *folded = g_utf8_casefold (layer, -1);
  return pattern ? g_pattern_match_simple (wanted, folded) : strcmp (wanted, folded) == 0;
}

/* The entry for a layer; NULL where there is none. */
static const char *
entry_of (const QnImportSettings *settings, const char *layer)
{
  for (int pattern = 0; pattern < 2; pattern++)
    for (char **entry = settings->layers; entry != NULL && *entry != NULL; entry++)
      if (means_layer (*entry, layer, pattern == 1))
        return *entry;
  return NULL;
}

static gboolean
is_among (const char *word, const char *words)
{
  g_autofree char *between = g_strdup_printf (" %s ", word);
  return strstr (words, between) != NULL;
}

/* Which list of known words has this one; G_N_ELEMENTS (role_words) where none has. */
static gsize
find_word (const char *word)
{
  gsize i = 0;
  while (i < G_N_ELEMENTS (role_words) && !is_among (word, role_words[i].words))
    i++;
  return i;
}

/* German puts words together: "Fensteröffnungen". Short ends say nothing: BACKGROUND, DATABASE. */
#define SHORTEST_END 7

/* The role that a name proposes: that of its last word that is known, the one which the others
 * describe (GROUND FLOOR is a floor). *doubtful where other words speak against it or are unknown. */
static QnRole
guess_role (const char *layer, gboolean *doubtful)
{
  g_autofree char *ascii = g_str_to_ascii (layer, "C");
  g_autofree char *lower = g_ascii_strdown (ascii, -1);
  QnRole role = QN_ROLE_BLOCK;
  gboolean any = FALSE, support = FALSE, unknown = FALSE;
  *doubtful = FALSE;
  for (char *word = lower; *word != '\0';) {
    gsize length = 0;
    while (g_ascii_isalpha (word[length]))
      length++;
    char *next = word + length + (word[length] != '\0');
    word[length] = '\0';
    gsize i = find_word (word);
    for (gsize k = 1; i == G_N_ELEMENTS (role_words) && k + SHORTEST_END <= length; k++) {
      i = find_word (word + k);
      unknown = TRUE;
    }
    if (i < G_N_ELEMENTS (role_words)) {
      *doubtful = *doubtful || (any && role_words[i].role != role);
      any = TRUE;
      role = role_words[i].role;
      support = support || is_among (word, sure_supports);
    } else if (length > 1 && !is_among (word, neutral)) {
      unknown = TRUE;
    }
    word = next;
  }
  *doubtful = *doubtful || (any && unknown && role != QN_ROLE_BLOCK);
  return support ? QN_ROLE_SUPPORT : role;
}

QnRole
qn_import_propose_role (const QnImportSettings *settings, const char *layer,
                        gboolean *doubtful)
{
  QnRole role = QN_ROLE_BLOCK;
  const char *entry = entry_of (settings, layer);
  *doubtful = FALSE;
  if (entry == NULL)
    return guess_role (layer, doubtful);
  qn_find_word (strrchr (entry, '=') + 1, role_names, QN_ROLE_COUNT, &role);
  return role;
}

static void
tell_layer (QnImportWork *work, const QnImportLayer *layer)
{
  static const char *const guessed[] = { N_ ("blocks"), N_ ("supports by its name"),
                                         N_ ("openings by its name"),
                                         N_ ("left out by its name") };
  static const char *const asked[] = { N_ ("blocks as asked"), N_ ("supports as asked"),
                                       N_ ("openings as asked"),
                                       N_ ("left out as asked") };
  const char *role = _ (layer->asked ? asked[layer->role] : guessed[layer->role]);
  if (layer->hidden > 0 && !layer->asked)
    qn_import_tell (work, TRUE,
                    _ ("layer \"%s\": hidden shapes left out: %u (--layer takes them)"),
                    layer->name, layer->hidden);
  if (layer->hidden == layer->count && !layer->asked)
    return;
  if (layer->doubtful)
    qn_import_tell (
      work, TRUE, _ ("layer \"%s\": shapes: %u; %s, which is a guess (--layer decides)"),
      layer->name, layer->count, role);
  else
    qn_import_tell (work, FALSE, _ ("layer \"%s\": shapes: %u; %s"), layer->name,
                    layer->count, role);
}

gboolean
qn_import_find_layers (QnImportWork *work, GError **error)
{
  const QnImportSettings *settings = work->settings;
  GArray *layers = work->report->layers;
  for (guint i = 0; i < work->drawing->paths->len; i++) {
    const QnDrawingPath *path = &g_array_index (work->drawing->paths, QnDrawingPath, i);
    /* Equal names are one string. */
    guint number = GPOINTER_TO_UINT (g_hash_table_lookup (work->layers, path->layer));
    if (number == 0) {
      QnImportLayer layer = { .name = g_strdup (path->layer),
                              .asked = entry_of (settings, path->layer) != NULL };
      layer.role = qn_import_propose_role (settings, path->layer, &layer.doubtful);
      g_array_append_val (layers, layer);
      number = layers->len;
      g_hash_table_insert (work->layers, (char *) path->layer, GUINT_TO_POINTER (number));
    }
    g_array_index (layers, QnImportLayer, number - 1).count++;
    g_array_index (layers, QnImportLayer, number - 1).hidden += path->hidden != FALSE;
  }
  for (guint i = 0; i < layers->len; i++) {
    QnImportLayer *layer = &g_array_index (layers, QnImportLayer, i);
    if (layer->hidden == layer->count && !layer->asked)
      layer->role = QN_ROLE_IGNORED;
    tell_layer (work, layer);
  }
  for (char **entry = settings->layers; entry != NULL && *entry != NULL; entry++) {
    gboolean found = FALSE;
    for (guint i = 0; i < layers->len && !found; i++)
      found = means_layer (*entry, g_array_index (layers, QnImportLayer, i).name, TRUE);
    if (found)
      continue;
    g_autoptr (GString) names = g_string_new (NULL);
    for (guint i = 0; i < layers->len; i++)
      g_string_append_printf (names, "%s%s", i > 0 ? ", " : "",
                              g_array_index (layers, QnImportLayer, i).name);
    return qn_io_fail (error, QN_IO_ERROR_OVERRIDE,
                       _ ("%s: there is no such layer; those of the drawing: %s"), *entry,
                       names->str);
  }
  return TRUE;
}
