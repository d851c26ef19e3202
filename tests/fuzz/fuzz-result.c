/* Any bytes as a result file, checked against a project where its blocks are the same. */
#include "fuzz.h"
#include "io/result/result-file.h"
#include "io/text/io-error.h"

#include <string.h>

static const char project_text[] =
  "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"j\", \"kind\": "
  "\"coulomb\", \"kn\": 1e7, \"ks\": 1e7, \"friction\": 0.65 } ], \"blocks\": [ { "
  "\"name\": "
  "\"base\", \"vertices\": [[0, -1], [2, -1], [2, 0], [0, 0]], \"thickness\": 1, "
  "\"unit_weight\": 1, \"support\": [true, true, true] }, { \"name\": \"top\", "
  "\"vertices\": "
  "[[0, 0], [1, 0], [1, 1], [0, 1]], \"thickness\": 1, \"unit_weight\": 1 } ], "
  "\"contact\": { \"law\": \"j\" }, \"loads\": { \"dead\": [ { \"kind\": \"weight\", "
  "\"direction\": [0, -1] } ] } }";

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  QnResultFile file;
  GError *error = NULL;
  if (!qn_result_file_parse ((const char *) data, size, "fuzz", &file, &error)) {
    fuzz_check_error (error);
    return 0;
  }

  QnProject project;
  QnContacts contacts;
  QnResultFaults faults;
  g_assert_true (qn_project_parse (project_text, strlen (project_text), "project", NULL,
                                   &project, NULL));
  g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, NULL), ==, QN_OK);
  if (!qn_result_file_match (&file, "fuzz", &project, &contacts, NULL, &error))
    fuzz_check_error (error);
  else if (file.result.step_count == 0 || file.result.pair_count == contacts.pair_count)
    qn_result_find_faults (&project.model, &contacts, &file.result, QN_CHECK_STATED,
                           &faults, NULL);
  qn_contacts_clear (&contacts);
  qn_project_clear (&project);
  qn_result_file_clear (&file);
  return 0;
}
