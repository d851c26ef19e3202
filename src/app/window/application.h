/* The program: windows, menus, shortcuts, command line of `quoin`. */
#pragma once

#include <gtk/gtk.h>

#define QN_TYPE_APPLICATION (qn_application_get_type ())
G_DECLARE_FINAL_TYPE (QnApplication, qn_application, QN, APPLICATION, GtkApplication)

/* The application, one per process: opens files, one window each. Owned by the caller. */
QnApplication *qn_application_new (void);
