/* What the user has chosen once for all windows. */
#pragma once

#include "doc/text/units.h"
#include <gio/gio.h>

/* The settings; borrowed, live as long as the program. Found in the system's schemas or, in a
 * build tree, beside the program. */
GSettings *qn_settings_get (void);

/* The units of the setting. */
QnUnits qn_settings_get_units (void);

/* Applies the light or dark style to GTK and keeps it so. */
void qn_settings_apply_style (void);

/* Whether movement should be kept to a minimum. */
gboolean qn_settings_reduced_motion (void);
