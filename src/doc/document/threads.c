#include "doc/document/threads.h"

#include <glib.h>
#include <pthread.h>

/* More than the parts that one structure is taken to gain nothing. */
#define MOST_THREADS 16

/* Work of one caller. */
typedef struct Batch {
  void (*part) (void *data, int32_t i);
  void *data;
  int count, next; /* parts, and how many have been begun */
  int helpers;     /* threads that work on it beside the caller's */
  struct Batch *other;
} Batch;

static pthread_mutex_t mutex =
  PTHREAD_MUTEX_INITIALIZER; /* guards what follows, and helpers */
static pthread_cond_t begun = PTHREAD_COND_INITIALIZER, ended = PTHREAD_COND_INITIALIZER;
static Batch *batches; /* whose callers are at work */

static void
work (Batch *batch)
{
  for (int i = g_atomic_int_add (&batch->next, 1); i < batch->count;
       i = g_atomic_int_add (&batch->next, 1))
    batch->part (batch->data, i);
}

static Batch *
find_work (void)
{
  Batch *batch = batches;
  while (batch != NULL && g_atomic_int_get (&batch->next) >= batch->count)
    batch = batch->other;
  return batch;
}

static gpointer
help (gpointer data)
{
  pthread_mutex_lock (&mutex);
  for (;;) {
    Batch *batch = find_work ();
    if (batch == NULL) {
      pthread_cond_wait (&begun, &mutex);
      continue;
    }
    batch->helpers++;
    pthread_mutex_unlock (&mutex);
    work (batch);
    pthread_mutex_lock (&mutex);
    if (--batch->helpers == 0)
      pthread_cond_broadcast (&ended);
  }
  return data;
}

/* As many as can be started. */
static gpointer
start (gpointer data)
{
  for (guint i = 1; i < MIN (g_get_num_processors (), MOST_THREADS); i++) {
    GThread *thread = g_thread_try_new ("helper", help, NULL, NULL);
    if (thread != NULL)
      g_thread_unref (thread);
  }
  return data;
}

static void
run (void *pool, int32_t count, void (*part) (void *data, int32_t i), void *data)
{
  static GOnce once = G_ONCE_INIT;
  Batch batch = { .part = part, .data = data, .count = count };
  g_once (&once, start, NULL);
  pthread_mutex_lock (&mutex);
  batch.other = batches;
  batches = &batch;
  pthread_cond_broadcast (&begun);
  pthread_mutex_unlock (&mutex);

  work (&batch);

  pthread_mutex_lock (&mutex);
  Batch **link = &batches;
  while (*link != &batch)
    link = &(*link)->other;
  *link = batch.other;
  while (batch.helpers > 0)
    pthread_cond_wait (&ended, &mutex);
  pthread_mutex_unlock (&mutex);
}

const QnWorkers *
qn_threads_get (void)
{
  static const QnWorkers workers = { .run = run };
  return &workers;
}
