/* Makes allocations fail on purpose, to walk every path that has no memory.
 *
 * Link with failing_memory_link_args: they turn malloc, calloc, aligned_alloc and realloc
 * of everything that is linked statically (our own code) into the functions here. SuiteSparse and
 * cJSON, which are shared, are given them through their configuration. Of GLib only what may
 * fail (g_try_malloc) does; all else ends the program when memory runs out, and so it does here. */
#pragma once

#include <stdbool.h>

/* Which allocations fail: the one with this number, counted from 0 from now on, and with
 * `onwards` all after it. A negative number lets all succeed. */
void failing_memory_arm (long number, bool onwards);

/* How many will still succeed before one fails. */
long failing_memory_left (void);

/* Lets all succeed again; returns whether one has failed since the last arming. */
bool failing_memory_disarm (void);
