#include "io/text/io-error.h"

#include <errno.h>

/* The formatter would set spaces around dashes that are part of the name. */
/* clang-format off */
G_DEFINE_QUARK (qn-io-error-quark, qn_io_error)
/* clang-format on */

gboolean
qn_io_error_set_errno (GError **error, const char *file, const char *what,
                       int error_number)
{
  QnIoError code = error_number == ENOMEM ? QN_IO_ERROR_NO_MEMORY : QN_IO_ERROR_FILE;
  g_set_error (error, QN_IO_ERROR, code, "%s: %s: %s", file, what,
               g_strerror (error_number));
  return FALSE;
}

gboolean
qn_io_fail (GError **error, QnIoError code, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_propagate_error (error, g_error_new_valist (QN_IO_ERROR, code, format, arguments));
  va_end (arguments);
  return FALSE;
}
