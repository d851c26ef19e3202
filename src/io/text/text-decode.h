/* Text of other people's files as UTF-8. */
#pragma once

#include <glib.h>

/* The text in UTF-8 with ends of lines "\n", whatever they were, and a NUL byte that `length` does
 * not count. Its encoding is that of its byte order mark (UTF-8, UTF-16); without one UTF-8 where
 * the bytes are that, else `charset` (NULL: Windows' for western Europe). Bytes that mean nothing
 * in it become replacement characters. */
char *qn_text_decode (const char *bytes, gsize size, const char *charset, gsize *length);
