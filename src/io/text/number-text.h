/* Numbers as text, the same in every locale. */
#pragma once

#include <glib.h>

/* Room for any number with its NUL. */
#define QN_NUMBER_TEXT_SIZE 40

/* The shortest text with 17 or fewer significant digits that reads back as the same double:
 * "0.1", "10000000", "1e-6". Not for infinities and NaN, which JSON cannot hold: they give
 * "null". Minus zero gives "0". Returns `text`. */
const char *qn_number_text (double number, char text[QN_NUMBER_TEXT_SIZE]);
