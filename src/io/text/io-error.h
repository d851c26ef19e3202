/* The error domain of everything that reads and writes files.
 *
 * The message of such a GError is one finished line, translated, in the form
 *
 *   wall.quoin:12:7: blocks[3].vertices: polygon crosses itself
 *
 * so that a caller only puts its own name in front.
 */
#pragma once

#include <glib.h>

#define QN_IO_ERROR (qn_io_error_quark ())

typedef enum {
  QN_IO_ERROR_INVALID,   /* the content breaks a rule of its format */
  QN_IO_ERROR_FILE,      /* the file cannot be opened, read or written */
  QN_IO_ERROR_OVERRIDE,  /* an override leads nowhere or to no known key: wrong usage */
  QN_IO_ERROR_NO_MEMORY, /* an allocation failed */
  QN_IO_ERROR_OUTSIDE    /* a project names a file outside its folder */
} QnIoError;

GQuark qn_io_error_quark (void);

/* Sets *error (nullable) of the domain QN_IO_ERROR; returns FALSE. */
gboolean qn_io_fail (GError **error, QnIoError code, const char *format, ...)
  G_GNUC_PRINTF (3, 4);

/* The same with "<file>: <what>: <reason of error_number>" and the code FILE, or NO_MEMORY for ENOMEM.
 * `what` is a translated phrase such as "cannot be read". */
gboolean qn_io_error_set_errno (GError **error, const char *file, const char *what,
                                int error_number);
