/* Widths of joints of mortar in words. */
#pragma once

/* "8 to 20 mm (mean 12 mm)", or "12 mm" where the extremes are the same when they are written;
 * widths in m. The caller frees it. */
char *qn_widths_dup_text (double narrowest, double mean, double widest);
