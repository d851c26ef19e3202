/* The program: windows, menus, shortcuts, command line of `quoin`. */
#pragma once

#include <gtk/gtk.h>

/* The application, one per process: opens files, one window each. Owned by the caller. */
GtkApplication *qn_application_new (void);
