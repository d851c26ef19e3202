#include "io/text/width-text.h"
#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <string.h>

char *
qn_widths_dup_text (double narrowest, double mean, double widest)
{
  g_autofree char *from = qn_text_printf ("%.3g", 1e3 * narrowest);
  g_autofree char *to = qn_text_printf ("%.3g mm", 1e3 * widest);
  return g_str_has_prefix (to, from) && to[strlen (from)] == ' '
           ? g_steal_pointer (&to)
           : qn_text_printf (_ ("%s to %s (mean %.3g mm)"), from, to, 1e3 * mean);
}
