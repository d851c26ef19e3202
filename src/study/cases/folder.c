#include "study/cases/folder.h"

#include "io/text/file-read.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gi18n-lib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

#define STUDY_NAME "study.quoin-study"
#define MODEL_NAME "model.quoin"

/* Of a study file; of the folder of all its states, in place of that. */
#define STUDY_ENDING  ".quoin-study"
#define STATES_ENDING "-study"

char *
qn_folder_dup_database (const char *folder, QnShard shard)
{
  g_autofree char *name =
    shard.count == 1
      ? g_strdup ("study.db")
      : g_strdup_printf ("shard-%u-of-%u.db", shard.index + 1, shard.count);
  return g_build_filename (folder, name, NULL);
}

char *
qn_folder_dup_result (const char *folder, gsize number)
{
  g_autofree char *name = g_strdup_printf ("case-%07" G_GSIZE_FORMAT ".json", number);
  return g_build_filename (folder, "results", name, NULL);
}

/* Writes a copy, or compares with the one that is there. */
static gboolean
put_copy (const char *folder, const char *name, const char *bytes, gsize length,
          GError **error)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);
  if (!g_file_test (path, G_FILE_TEST_EXISTS))
    return qn_file_write (path, bytes, length, error);
  gsize present_length;
  g_autofree char *present = qn_file_read (path, &present_length, error);
  if (present == NULL)
    return FALSE;
  if (present_length == length && memcmp (present, bytes, length) == 0)
    return TRUE;
  return qn_io_fail (
    error, QN_IO_ERROR_INVALID, "%s: %s", path,
    _ ("the folder belongs to another study, or to another state of this one: "
       "choose another folder"));
}

/* Copies of the records that the project names, under the same names. */
static gboolean
put_records (const char *folder, const QnStudy *study, GError **error)
{
  for (gsize i = 0; i < qn_study_record_count (study); i++) {
    const QnGroundMotion *motion = &study->project.model.ground[i];
    gsize length;
    if (motion->kind != QN_SIGNAL_RECORD || g_path_is_absolute (motion->record))
      continue;
    g_autofree char *from = g_build_filename (study->folder, motion->record, NULL);
    g_autofree char *to = g_build_filename (folder, motion->record, NULL);
    g_autofree char *parent = g_path_get_dirname (to);
    g_autofree char *bytes = qn_file_read (from, &length, error);
    if (bytes == NULL)
      return FALSE;
    if (g_mkdir_with_parents (parent, 0777) != 0)
      return qn_io_error_set_errno (error, parent, _ ("cannot be written"), errno);
    if (!put_copy (folder, motion->record, bytes, length, error))
      return FALSE;
  }
  return TRUE;
}

gboolean
qn_folder_prepare (const char *folder, const QnStudy *study, GError **error)
{
  if (g_mkdir_with_parents (folder, 0777) != 0)
    return qn_io_error_set_errno (error, folder, _ ("cannot be written"), errno);
  return put_copy (folder, MODEL_NAME, study->project.text, study->project.text_length,
                   error)
         && put_copy (folder, STUDY_NAME, study->text, study->length, error)
         && put_records (folder, study, error);
}

static char *
dup_stem (const char *path, const char *ending)
{
  return g_strndup (path, strlen (path)
                            - (g_str_has_suffix (path, ending) ? strlen (ending) : 0));
}

char *
qn_folder_dup_of_state (const QnStudy *study, const char *path)
{
  g_autofree char *stem = dup_stem (path, STUDY_ENDING);
  return g_strdup_printf ("%s" STATES_ENDING "/%.8s", stem, study->sha256);
}

char *
qn_folder_dup_named (const char *folder)
{
  QnStudy study;
  g_autofree char *own = g_build_filename (folder, STUDY_NAME, NULL);
  g_autofree char *whole = g_canonicalize_filename (folder, NULL);
  g_autofree char *stem = dup_stem (whole, STATES_ENDING);
  g_autofree char *path = g_strconcat (stem, STUDY_ENDING, NULL);
  if (g_file_test (own, G_FILE_TEST_EXISTS) || !g_str_has_suffix (whole, STATES_ENDING)
      || !qn_study_read (path, NULL, &study, NULL))
    return g_strdup (folder);
  char *state = qn_folder_dup_of_state (&study, path);
  qn_study_clear (&study);
  return state;
}

gboolean
qn_folder_read_study (const char *folder, QnStudy *study, GError **error)
{
  g_autofree char *path = g_build_filename (folder, STUDY_NAME, NULL);
  g_autofree char *model = g_build_filename (folder, MODEL_NAME, NULL);
  return qn_study_read (path, model, study, error);
}

int
qn_folder_lock (const char *database, GError **error)
{
  g_autofree char *path = g_strconcat (database, ".lock", NULL);
  int fd = open (path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (fd < 0) {
    qn_io_error_set_errno (error, path, _ ("cannot be written"), errno);
    return -1;
  }
  if (flock (fd, LOCK_EX | LOCK_NB) == 0)
    return fd;
  int trouble = errno;
  close (fd);
  if (trouble == EWOULDBLOCK)
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE, "%s: %s", database,
                 _ ("another process computes cases of this study here"));
  else
    qn_io_error_set_errno (error, path, _ ("cannot be locked"), trouble);
  return -1;
}
