#include "stress/process.h"

#include "stress/run.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static void
run_and_send (const StressCase *c, int seconds, int pipe_end)
{
  const struct rlimit limit = { (rlim_t) seconds, (rlim_t) seconds + 5 };
  StressRow row;

  setrlimit (RLIMIT_CPU, &limit);
  stress_run (c, &row);
  exit (write (pipe_end, &row, sizeof row) == (ssize_t) sizeof row ? 0 : 1);
}

/* The whole row or nothing. */
static bool
receive (int pipe_end, StressRow *row)
{
  char *to = (char *) row;
  size_t got = 0;

  while (got < sizeof *row) {
    ssize_t count = read (pipe_end, to + got, sizeof *row - got);
    if (count < 0 && errno == EINTR)
      continue;
    if (count <= 0)
      return false;
    got += (size_t) count;
  }
  return true;
}

StressProcess
stress_process_start (const StressCase *c, int seconds)
{
  int ends[2];

  fflush (NULL);
  if (pipe (ends) != 0)
    g_error ("no pipe: %s", g_strerror (errno));
  pid_t child = fork ();
  if (child < 0)
    g_error ("no process: %s", g_strerror (errno));
  if (child == 0) {
    close (ends[0]);
    run_and_send (c, seconds, ends[1]);
  }
  close (ends[1]);
  return (StressProcess){ .pid = child, .pipe_end = ends[0] };
}

void
stress_process_finish (StressProcess *process, StressRow *row)
{
  int status = 0;
  bool received = receive (process->pipe_end, row);

  close (process->pipe_end);
  while (waitpid (process->pid, &status, 0) < 0 && errno == EINTR)
    continue;
  if (!received)
    *row = (StressRow){ .mirrored = NAN, .repeated = NAN, .lower = NAN, .upper = NAN };
  if (WIFSIGNALED (status)
      && (WTERMSIG (status) == SIGXCPU || WTERMSIG (status) == SIGKILL))
    row->faults |= STRESS_HANG;
  else if (!received || !WIFEXITED (status) || WEXITSTATUS (status) != 0)
    row->faults |= STRESS_CRASH;
}

void
stress_process_run (const StressCase *c, int seconds, StressRow *row)
{
  StressProcess process = stress_process_start (c, seconds);
  stress_process_finish (&process, row);
}
