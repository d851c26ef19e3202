#include "support/room.h"

#include <glib.h>

enum { FILE_COUNT_MAX = 64 };

static void (*files[FILE_COUNT_MAX]) (void);
static int file_count;

void
test_room_note (void (*add_cases) (void))
{
  g_assert (file_count < FILE_COUNT_MAX);
  files[file_count++] = add_cases;
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  for (int i = 0; i < file_count; i++)
    files[i]();
  return g_test_run ();
}
