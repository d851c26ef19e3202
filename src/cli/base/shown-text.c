#include "cli/base/shown-text.h"

#include "cli/base/message.h"
#include "io/text/text-format.h"

#include <errno.h>
#include <glib/gi18n.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

gsize
qn_shown_text_append (GString *shown, const char *text, gsize length)
{
  gsize at = 0;
  while (at < length) {
    gunichar c = text[at] != '\0'
                   ? g_utf8_get_char_validated (text + at, (gssize) (length - at))
                   : 0;
    if (c == (gunichar) -2) /* the rest is to come */
      return at;
    if (c == (gunichar) -1) {
      g_string_append_printf (shown, "\\x%02x", (guint) (guchar) text[at++]);
      continue;
    }
    gsize bytes = (gsize) (g_utf8_next_char (text + at) - (text + at));
    if (qn_is_plain_character (c))
      g_string_append_len (shown, text + at, (gssize) bytes);
    else
      g_string_append_printf (shown, "\\u%04x", c);
    at += bytes;
  }
  return at;
}

static gboolean all_finite = TRUE;

void
qn_print (const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_autofree char *text = qn_text_vprintf (&all_finite, format, arguments);
  va_end (arguments);
  fputs (text, stdout);
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

/* Bytes of a character whose rest has not been printed yet. */
typedef struct Rest {
  char bytes[8];
  gsize length;
} Rest;

static gboolean
write_all (const char *text, gsize length)
{
  while (length > 0) {
    ssize_t count = write (STDOUT_FILENO, text, length);
    if (count < 0 && errno != EINTR)
      return FALSE;
    text += MAX (count, 0);
    length -= (gsize) MAX (count, 0);
  }
  return TRUE;
}

static ssize_t
print (void *cookie, const char *text, size_t length)
{
  Rest *rest = cookie;
  g_autoptr (GString) all = g_string_new_len (rest->bytes, (gssize) rest->length);
  g_autoptr (GString) shown = g_string_new (NULL);
  g_string_append_len (all, text, (gssize) length);
  gsize taken = qn_shown_text_append (shown, all->str, all->len);
  rest->length = all->len - taken;
  memcpy (rest->bytes, all->str + taken, rest->length);
  return write_all (shown->str, shown->len) ? (ssize_t) length : 0;
}

void
qn_shown_text_on_standard_output (void)
{
  static Rest rest;
  const cookie_io_functions_t functions = { .write = print };
  FILE *shown = fopencookie (&rest, "w", functions);
  if (shown == NULL)
    return;
  setvbuf (shown, NULL, isatty (STDOUT_FILENO) ? _IOLBF : _IOFBF, BUFSIZ);
  stdout = shown;
}
