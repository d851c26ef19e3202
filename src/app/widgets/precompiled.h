/* What every source of the window includes, compiled once where Meson is told so (-Db_pch=true). */
#include <gtk/gtk.h>
