#include "support/failing-memory.h"

#include <SuiteSparse_config.h>
#include <stdlib.h>

static long next_failure = -1;
static bool all_after, has_failed;

void *__real_malloc (size_t size);
void *__real_calloc (size_t count, size_t size);
void *__real_aligned_alloc (size_t alignment, size_t size);
void *__real_realloc (void *block, size_t size);
void *__real_g_try_malloc (size_t size);
void *__wrap_g_try_malloc (size_t size);
void *__wrap_malloc (size_t size);
void *__wrap_calloc (size_t count, size_t size);
void *__wrap_aligned_alloc (size_t alignment, size_t size);
void *__wrap_realloc (void *block, size_t size);

/* For a debugger to stop at. */
static void __attribute__ ((noinline)) strike (void)
{
  has_failed = true;
}

static bool
fails (void)
{
  if (next_failure < 0)
    return false;
  if (next_failure > 0) {
    next_failure--;
    return false;
  }
  if (!all_after)
    next_failure = -1;
  strike ();
  return true;
}

void *
__wrap_malloc (size_t size)
{
  return fails () ? NULL : __real_malloc (size);
}

void *
__wrap_calloc (size_t count, size_t size)
{
  return fails () ? NULL : __real_calloc (count, size);
}

void *
__wrap_aligned_alloc (size_t alignment, size_t size)
{
  return fails () ? NULL : __real_aligned_alloc (alignment, size);
}

void *
__wrap_realloc (void *block, size_t size)
{
  return fails () ? NULL : __real_realloc (block, size);
}

/* GLib's functions that may fail; the others do not return. */
void *
__wrap_g_try_malloc (size_t size)
{
  return fails () ? NULL : __real_g_try_malloc (size);
}

/* From version 6 on the functions are set by functions. */
static void
take_over_suitesparse (void)
{
#if SUITESPARSE_MAIN_VERSION >= 6
  SuiteSparse_config_malloc_func_set (__wrap_malloc);
  SuiteSparse_config_calloc_func_set (__wrap_calloc);
  SuiteSparse_config_realloc_func_set (__wrap_realloc);
#else
  SuiteSparse_config.malloc_func = __wrap_malloc;
  SuiteSparse_config.calloc_func = __wrap_calloc;
  SuiteSparse_config.realloc_func = __wrap_realloc;
#endif
}

void
failing_memory_arm (long number, bool onwards)
{
  take_over_suitesparse ();
  next_failure = number;
  all_after = onwards;
  has_failed = false;
}

long
failing_memory_left (void)
{
  return next_failure;
}

bool
failing_memory_disarm (void)
{
  next_failure = -1;
  return has_failed;
}
