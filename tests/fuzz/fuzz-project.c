/* Any bytes as a project file. Behind a NUL byte, which no project holds, an override. What is
 * refused must be refused in one line; what is accepted must survive writing and reading. */
#include "fuzz.h"
#include "io/project/project.h"
#include "io/text/io-error.h"

#include <stdlib.h>
#include <string.h>

/* Contact detection of more blocks costs more than it teaches. */
#define MAX_BLOCKS 60

static void
check_round_trip (const QnProject *project)
{
  gsize length;
  char *text = qn_project_to_text (project, &length);
  QnProject again;
  GError *error = NULL;
  if (!qn_project_parse (text, length, "again", NULL, &again, &error)) {
    g_printerr ("written, but not read: %s\n%s\n", error->message, text);
    abort (); /* as libFuzzer notices */
  }
  char *second = qn_project_to_text (&again, NULL);
  g_assert_cmpstr (text, ==, second);
  qn_project_clear (&again);
  g_free (second);
  g_free (text);
}

static void
check_contacts (const QnProject *project)
{
  QnContacts contacts = { 0 };
  QnDiag diag;
  QnStatus status = qn_contacts_detect (&project->model, &contacts, &diag);
  if (status == QN_OK)
    g_ptr_array_unref (qn_project_dup_finding_texts (project, &contacts.findings));
  if (status == QN_OK)
    status = qn_contacts_require_sound (&project->model, &contacts, &diag);
  if (status != QN_OK) {
    GError *error = NULL;
    qn_project_set_error (project, &diag, &error);
    fuzz_check_error (error);
  }
  qn_contacts_clear (&contacts);
}

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  const uint8_t *nul = size > 0 ? memchr (data, 0, size) : NULL;
  size_t length = nul != NULL ? (size_t) (nul - data) : size;
  char *override =
    nul != NULL ? g_strndup ((const char *) nul + 1, size - length - 1) : NULL;
  const char *const overrides[] = { override, NULL };

  QnProject project;
  GError *error = NULL;
  if (qn_project_parse ((const char *) data, length, "fuzz", overrides, &project,
                        &error)) {
    if (project.model.block_count <= MAX_BLOCKS) {
      check_round_trip (&project);
      check_contacts (&project);
    }
    qn_project_clear (&project);
  } else {
    fuzz_check_error (error);
  }
  g_free (override);
  return 0;
}
