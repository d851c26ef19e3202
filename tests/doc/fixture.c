#include "fixture.h"

#include <string.h>

#define LONGEST_WAIT_US (60 * G_USEC_PER_SEC)

QnDocument *
open_example (const char *name)
{
  g_autofree char *path = g_build_filename (g_getenv ("QUOIN_EXAMPLES"), name, NULL);
  QnDocument *document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  qn_document_load (document, path, &error);
  g_assert_no_error (error);
  return document;
}

QnDocument *
open_text (const char *text)
{
  QnDocument *document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  qn_document_load_text (document, text, "test", &error);
  g_assert_no_error (error);
  return document;
}

const QnModel *
edit (QnDocument *document, QnEditFunc func, gconstpointer data)
{
  g_autofree char *before = g_strdup (qn_document_get_text (document));
  g_autoptr (GError) error = NULL;
  qn_document_edit (document, "edit", NULL, func, (gpointer) data, &error);
  g_assert_no_error (error);
  g_autofree char *after = g_strdup (qn_document_get_text (document));
  if (strcmp (before, after) != 0) {
    g_assert_true (qn_document_undo (document));
    g_assert_cmpstr (qn_document_get_text (document), ==, before);
    g_assert_true (qn_document_redo (document));
    g_assert_cmpstr (qn_document_get_text (document), ==, after);
  }
  return qn_document_get_model (document);
}

void
refuse (QnDocument *document, QnEditFunc func, gconstpointer data)
{
  g_autofree char *before = g_strdup (qn_document_get_text (document));
  g_autoptr (GError) error = NULL;
  g_assert_false (
    qn_document_edit (document, "edit", NULL, func, (gpointer) data, &error));
  g_assert_nonnull (error);
  g_assert_cmpstr (qn_document_get_text (document), ==, before);
}

void
wait_for_job (QnDocument *document)
{
  gint64 end = g_get_monotonic_time () + LONGEST_WAIT_US;
  while (qn_document_get_job (document) != NULL) {
    g_assert_cmpint (g_get_monotonic_time (), <, end);
    g_main_context_iteration (NULL, TRUE);
  }
}

QnRun *
solve_example (QnDocument *document)
{
  g_autoptr (GError) error = NULL;
  qn_document_analyse (document, &error);
  g_assert_no_error (error);
  wait_for_job (document);
  g_assert_no_error (qn_document_get_job_error (document));
  return qn_document_get_run (document);
}
