/* Any bytes as a study of a project with one block. Of an accepted study of few cases the values of
 * every case are finite. */
#include "fuzz.h"
#include "study/plan/sample.h"

#include <math.h>
#include <sys/mman.h>
#include <unistd.h>

/* Values of larger plans cost more than they teach. */
#define MAX_VALUES 2000

static const char project_text[] =
  "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"j\", \"kind\": "
  "\"coulomb\", \"kn\": 1e7, \"ks\": 1e7, \"friction\": 0.65 } ], \"blocks\": [ { "
  "\"name\": \"base\", \"vertices\": [[0, 0], [1, 0], [1, 1], [0, 1]], \"thickness\": 1, "
  "\"unit_weight\": 1, \"support\": [true, true, true] } ], \"contact\": { \"law\": "
  "\"j\" "
  "} }";

/* Studies are read from a path: that of bytes in memory. */
static char *
file_in_memory (const void *bytes, size_t size, int *descriptor)
{
  *descriptor = memfd_create ("fuzz", MFD_CLOEXEC);
  g_assert_cmpint (write (*descriptor, bytes, size), ==, (gssize) size);
  return g_strdup_printf ("/proc/self/fd/%d", *descriptor);
}

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  static char *project;
  int descriptor;
  if (project == NULL)
    project = file_in_memory (project_text, strlen (project_text), &descriptor);
  g_autofree char *path = file_in_memory (data, size, &descriptor);

  QnStudy study;
  GError *error = NULL;
  if (qn_study_read (path, project, &study, &error)) {
    const gsize count = qn_study_case_count (&study) * study.parameters->len;
    if (count <= MAX_VALUES) {
      g_autofree double *sample = qn_sample_dup (&study);
      for (gsize i = 0; i < count; i++)
        g_assert_true (isfinite (sample[i]));
    }
    qn_study_clear (&study);
  } else {
    fuzz_check_error (error);
  }
  close (descriptor);
  return 0;
}
