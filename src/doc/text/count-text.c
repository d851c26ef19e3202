#include "doc/text/count-text.h"

#include <glib/gi18n-lib.h>

static char *
dup_phrase (QnCount count)
{
  gsize n = count.number;
  switch (count.what) {
  case QN_COUNTED_BLOCKS:
    return g_strdup_printf (ngettext ("%zu block", "%zu blocks", n), n);
  case QN_COUNTED_BEAMS:
    return g_strdup_printf (ngettext ("%zu beam", "%zu beams", n), n);
  case QN_COUNTED_FACES:
    return g_strdup_printf (ngettext ("%zu contact face", "%zu contact faces", n), n);
  case QN_COUNTED_PAIRS:
    return g_strdup_printf (ngettext ("%zu contact pair", "%zu contact pairs", n), n);
  case QN_COUNTED_FINDINGS:
    return g_strdup_printf (ngettext ("%zu finding", "%zu findings", n), n);
  case QN_COUNTED_STEPS:
    return g_strdup_printf (ngettext ("%zu step", "%zu steps", n), n);
  case QN_COUNTED_ITERATIONS:
    return g_strdup_printf (ngettext ("%zu iteration", "%zu iterations", n), n);
  case QN_COUNTED_FACTORISATIONS:
    return g_strdup_printf (ngettext ("%zu factorisation", "%zu factorisations", n), n);
  }
  return g_strdup ("");
}

char *
qn_counts_dup_text (const QnCount *counts, gsize n_counts, const char *separator)
{
  g_autoptr (GStrvBuilder) phrases = g_strv_builder_new ();
  for (gsize i = 0; i < n_counts; i++) {
    g_autofree char *phrase = dup_phrase (counts[i]);
    g_strv_builder_add (phrases, phrase);
  }
  g_auto (GStrv) strings = g_strv_builder_end (phrases);
  return g_strjoinv (separator, strings);
}
