#include "cli/base/progress.h"

#include <glib/gi18n.h>
#include <malloc.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

gboolean qn_cli_quiet;

static volatile sig_atomic_t interrupted;

static gboolean shown;   /* whether updates are */
static gint64 last_time; /* of the last update shown, us */
static gsize idle_heap, peak_memory;

static void
on_interrupt (int signal_number)
{
  (void) signal_number;
  interrupted = 1;
}

void
qn_interrupt_install (void)
{
  struct sigaction action;
  memset (&action, 0, sizeof action);
  action.sa_handler = on_interrupt;
  action.sa_flags = (int) SA_RESETHAND; /* the second one takes its usual course */
  sigaction (SIGINT, &action, NULL);
}

gboolean
qn_interrupt_seen (void)
{
  return interrupted != 0;
}

static gsize
heap_in_use (void)
{
  struct mallinfo2 info = mallinfo2 ();
  return info.uordblks + info.hblkhd;
}

gboolean
qn_progress_is_shown (void)
{
  return !qn_cli_quiet && isatty (STDERR_FILENO);
}

void
qn_terminal_progress_begin (void)
{
  qn_interrupt_install ();
  shown = qn_progress_is_shown ();
  last_time = 0;
  idle_heap = heap_in_use ();
  peak_memory = 0;
}

bool
qn_terminal_progress_update (const QnProgress *progress, void *user_data)
{
  enum { INTERVAL = 100000 }; /* us; faster than the eye needs is only noise */
  enum { STEP = 1 << 20 };
  (void) user_data;
  gsize heap = heap_in_use ();
  gsize grown = heap > idle_heap ? heap - idle_heap : 0;
  peak_memory = MAX (peak_memory, (grown + STEP - 1) / STEP * STEP);
  gint64 now = shown ? g_get_monotonic_time () : 0;

  if (shown && now - last_time >= INTERVAL) {
    last_time = now;
    fprintf (stderr, "\r\033[K");
    if (progress->end > 0)
      fprintf (stderr, _ ("%.3f of %.4g s, %d iterations"), progress->time, progress->end,
               progress->iterations);
    else
      fprintf (stderr, _ ("multiplier %.5f, %d steps, %d iterations"),
               progress->multiplier, progress->steps, progress->iterations);
    fflush (stderr);
  }
  return !qn_interrupt_seen ();
}

gsize
qn_terminal_progress_done (void)
{
  if (last_time > 0)
    fprintf (stderr, "\r\033[K");
  return peak_memory;
}
