#include "io/io-error.h"

G_DEFINE_QUARK (qn - io - error - quark, qn_io_error)

void
qn_io_error_set_errno (GError **error, const char *file, const char *what,
                       int error_number)
{
  g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE, "%s: %s: %s", file, what,
               g_strerror (error_number));
}
