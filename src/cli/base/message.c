#include "cli/base/message.h"

#include "io/text/io-error.h"
#include "io/text/json-text.h"
#include "io/text/text-format.h"
#include "render/backend/output.h"

#include <gio/gio.h>
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

G_GNUC_PRINTF (2, 0)
static void
print_line (const char *kind, const char *format, va_list arguments)
{
  g_autofree char *text = g_strdup_vprintf (format, arguments);
  g_strdelimit (text, "\r\n", ' ');
  g_autofree char *shown = qn_shown_text_dup (text);
  fprintf (stderr, "quoin-cli: %s%s\n", kind, shown);
}

void
qn_cli_error (const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  print_line ("", format, arguments);
  va_end (arguments);
}

void
qn_cli_fail (QnExit code, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  print_line ("", format, arguments);
  va_end (arguments);
  qn_cli_stop (code);
}

void
qn_cli_warning (const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  print_line (_ ("warning: "), format, arguments);
  va_end (arguments);
}

static const char *own_override, *own_subcommand;
static gboolean outside_offered;

void
qn_cli_set_subcommand (const char *subcommand)
{
  own_subcommand = subcommand;
}

void *
qn_cli_keep (void *memory)
{
  static GSList *kept;
  kept = g_slist_prepend (kept, memory);
  return memory;
}

void
qn_cli_usage_error (const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_autofree char *message = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  if (own_subcommand != NULL)
    qn_cli_fail (QN_EXIT_USAGE, _ ("%s: %s (see quoin-cli %s --help)"), own_subcommand,
                 message, own_subcommand);
  else
    qn_cli_fail (QN_EXIT_USAGE, _ ("%s (see quoin-cli --help)"), message);
}

void
qn_cli_refuse_name (const char *value, const char *const *names, size_t count)
{
  g_autoptr (GString) known = g_string_new (NULL);
  for (size_t i = 0; i < count; i++)
    g_string_append_printf (known, "%s%s", i > 0 ? ", " : "", names[i]);
  g_autofree char *reason = g_strdup_printf (_ ("is not one of %s"), known->str);
  qn_cli_usage_error ("%s: %s", value, reason);
}

/* The exit code that belongs to an error of the layers below. */
static QnExit
exit_code_of (const GError *error)
{
  static const QnExit of_io[] = {
    [QN_IO_ERROR_INVALID] = QN_EXIT_INVALID,    [QN_IO_ERROR_FILE] = QN_EXIT_FILE,
    [QN_IO_ERROR_OUTSIDE] = QN_EXIT_FILE,       [QN_IO_ERROR_OVERRIDE] = QN_EXIT_USAGE,
    [QN_IO_ERROR_NO_MEMORY] = QN_EXIT_INTERNAL,
  };
  static const QnExit of_render[] = {
    [QN_RENDER_ERROR_USAGE] = QN_EXIT_USAGE,
    [QN_RENDER_ERROR_FILE] = QN_EXIT_FILE,
    [QN_RENDER_ERROR_CANCELLED] = QN_EXIT_CANCELLED,
    [QN_RENDER_ERROR_UNAVAILABLE] = QN_EXIT_INTERNAL,
    [QN_RENDER_ERROR_FAILED] = QN_EXIT_INTERNAL,
  };
  return error->domain == QN_IO_ERROR       ? of_io[error->code]
         : error->domain == QN_RENDER_ERROR ? of_render[error->code]
         : error->domain == G_FILE_ERROR || error->domain == G_IO_ERROR
           ? QN_EXIT_FILE
           : QN_EXIT_INTERNAL;
}

void
qn_cli_offer_outside (void)
{
  outside_offered = TRUE;
}

void
qn_cli_set_own_override (const char *override)
{
  own_override = override;
}

GError *qn_cli_trouble;

void
qn_cli_must (gboolean done)
{
  const GError *error = qn_cli_trouble;
  if (done)
    return;
  g_autoptr (GString) message = g_string_new (error->message);
  if (own_override != NULL) {
    g_autoptr (GString) quoted = g_string_new (NULL);
    g_autofree char *command = g_strconcat ("quoin-cli ", own_subcommand, NULL);
    qn_json_append_string (quoted, own_override);
    g_string_replace (message, quoted->str, command, 0);
  }
  if (outside_offered && g_error_matches (error, QN_IO_ERROR, QN_IO_ERROR_OUTSIDE))
    g_string_append (message, _ ("; --allow-outside permits it"));
  qn_cli_fail (exit_code_of (error), "%s", message->str);
}

void
qn_cli_cancelled (const char *project)
{
  qn_cli_fail (QN_EXIT_CANCELLED, _ ("%s: cancelled"), project);
}

/* --- Standard output --- */

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
qn_cli_complete (QnExit code)
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
  exit ((int) qn_cli_complete (code));
}
