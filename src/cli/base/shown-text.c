#include "cli/base/shown-text.h"

#include "cli/base/message.h"
#include "io/text/text-format.h"

#include <glib/gi18n.h>
#include <stdio.h>
#include <stdlib.h>

char *
qn_shown_text_dup (const char *text)
{
  GString *shown = g_string_new (NULL);
  while (*text != '\0') {
    const gunichar c = g_utf8_get_char_validated (text, -1);
    const char *next = g_utf8_next_char (text);
    if (c >= (gunichar) -2) {
      g_string_append_printf (shown, "\\x%02x", (guint) (guchar) *text);
      next = text + 1;
    } else if (qn_is_plain_character (c)) {
      g_string_append_len (shown, text, next - text);
    } else {
      g_string_append_printf (shown, "\\u%04x", c);
    }
    text = next;
  }
  return g_string_free (shown, FALSE);
}

void
qn_print_text (const char *text)
{
  g_autofree char *shown = qn_shown_text_dup (text);
  fputs (shown, stdout);
}

static gboolean all_finite = TRUE;

void
qn_print (const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_autofree char *text = qn_text_vprintf (&all_finite, format, arguments);
  va_end (arguments);
  qn_print_text (text);
}

QnExit
qn_shown_text_end (QnExit code)
{
  if (!all_finite && code == QN_EXIT_DONE) {
    qn_cli_error (_ ("this answer has numbers that are not finite"));
    code = QN_EXIT_NO_ANSWER;
  }
  /* Output that is still in the buffer would be lost without an error. */
  if ((fflush (stdout) != 0 || ferror (stdout)) && code == QN_EXIT_DONE) {
    qn_cli_error (_ ("standard output cannot be written"));
    code = QN_EXIT_FILE;
  }
  return code;
}

void
qn_cli_stop (QnExit code)
{
  exit ((int) qn_shown_text_end (code));
}
