#include "doc/text/path-text.h"

#include <glib/gi18n-lib.h>
#include <string.h>

typedef enum { NONE, LAW, BLOCK, SECTION, BEAM } Named;

static const struct {
  const char *key, *words;
  Named named;
} lists[] = {
  { "laws[", N_ ("Law %s"), LAW },
  { "blocks[", N_ ("Block %s"), BLOCK },
  { "sections[", N_ ("Section %s"), SECTION },
  { "beams[", N_ ("Beam %s"), BEAM },
  { "masonry[", N_ ("Masonry %s"), NONE },
  { "ties[", N_ ("Tie %s"), NONE },
  { "bars[", N_ ("Bar %s"), NONE },
  { "loads.live[", N_ ("Growing load %s"), NONE },
  { "loads.dead[", N_ ("Constant load %s"), NONE },
  { "analysis.stages[", N_ ("Stage %s"), NONE },
};

static const char *
find_name (const QnModel *model, Named named, guint64 index)
{
  switch (named) {
  case LAW:
    return index < model->law_count ? model->laws[index].name : NULL;
  case BLOCK:
    return index < model->block_count ? model->blocks[index].name : NULL;
  case SECTION:
    return index < model->section_count ? model->sections[index].name : NULL;
  case BEAM:
    return index < model->beam_count ? model->beams[index].name : NULL;
  case NONE:
  default:
    return NULL;
  }
}

char *
qn_path_dup_text (const QnModel *model, const char *path)
{
  for (gsize i = 0; i < G_N_ELEMENTS (lists); i++) {
    if (!g_str_has_prefix (path, lists[i].key))
      continue;
    char *end;
    guint64 index = g_ascii_strtoull (path + strlen (lists[i].key), &end, 10);
    const char *known = find_name (model, lists[i].named, index);
    g_autofree char *name = known != NULL
                              ? g_strdup_printf (_ ("“%s”"), known)
                              : g_strdup_printf ("%" G_GUINT64_FORMAT, index + 1);
    /* Words of the table, each with one "%s". */
    g_auto (GStrv) around = g_strsplit (_ (lists[i].words), "%s", 2);
    g_autofree char *whose = g_strjoinv (name, around);
    g_autofree char *rest =
      g_strdelimit (g_strdup (end[0] == ']' && end[1] == '.' ? end + 2 : ""), "_", ' ');
    return g_strconcat (whose, *rest != '\0' ? ": " : "", rest, NULL);
  }
  return g_strdelimit (g_strdup (path), "_", ' ');
}

char *
qn_path_dup_reason (const char *message, const char *path)
{
  g_autofree char *place = g_strconcat (path, ": ", NULL);
  g_autofree char *override = g_strconcat ("\"", path, "=", NULL);
  const char *begin = strstr (message, place);
  begin = begin != NULL ? begin + strlen (place) : message;
  const char *end = strstr (begin, override);
  while (end != NULL && end > begin && *end != '(')
    end--;
  char *reason =
    end != NULL ? g_strndup (begin, (gsize) (end - begin)) : g_strdup (begin);
  return g_strchomp (reason);
}
