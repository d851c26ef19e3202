#include "study/cases/store.h"

#include "io/text/io-error.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <sqlite3.h>
#include <string.h>
#include <unistd.h>

#define STORE_VERSION 1

/* "QnSt": tells such databases from others. */
#define APPLICATION_ID 0x516e5374

/* How long another process may hold the database while it commits, ms. */
#define PATIENCE 30000

struct QnStore {
  char *path;
  const QnStudy *study;
  sqlite3 *db;
  sqlite3_stmt *add;
  gboolean open; /* a transaction is */
};

/* Columns beside those of parameters and outputs. */
#define OWN_COLUMNS 7

static gboolean
fail (const QnStore *store, GError **error)
{
  int code = sqlite3_errcode (store->db);
  return qn_io_fail (error,
                     code == SQLITE_NOMEM    ? QN_IO_ERROR_NO_MEMORY
                     : code == SQLITE_NOTADB ? QN_IO_ERROR_INVALID
                                             : QN_IO_ERROR_FILE,
                     "%s: %s", store->path, sqlite3_errmsg (store->db));
}

static gboolean
run (QnStore *store, const char *sql, GError **error)
{
  return sqlite3_exec (store->db, sql, NULL, NULL, NULL) == SQLITE_OK
         || fail (store, error);
}

/* One number or text of the database; FALSE on an error. */
static gboolean
ask (QnStore *store, const char *sql, char **answer, GError **error)
{
  sqlite3_stmt *statement = NULL;
  *answer = NULL;
  if (sqlite3_prepare_v2 (store->db, sql, -1, &statement, NULL) != SQLITE_OK)
    return fail (store, error);
  int step = sqlite3_step (statement);
  if (step == SQLITE_ROW)
    *answer = g_strdup ((const char *) sqlite3_column_text (statement, 0));
  gboolean ok = step == SQLITE_ROW || step == SQLITE_DONE || fail (store, error);
  sqlite3_finalize (statement);
  return ok;
}

static gboolean
is_empty (QnStore *store, gboolean *empty, GError **error)
{
  g_autofree char *tables = NULL;
  if (!ask (store, "SELECT count(*) FROM sqlite_master", &tables, error))
    return FALSE;
  *empty = g_strcmp0 (tables, "0") == 0;
  return TRUE;
}

static gboolean
refuse (const QnStore *store, const char *why, GError **error)
{
  return qn_io_fail (error, QN_IO_ERROR_INVALID, "%s: %s", store->path, why);
}

/* Whether the database is of this study; makes the tables of an empty one. */
static gboolean
check_study (QnStore *store, gboolean create, GError **error)
{
  g_autofree char *id = NULL, *sum = NULL;
  gboolean empty;
  if (!ask (store, "PRAGMA application_id", &id, error)
      || !is_empty (store, &empty, error))
    return FALSE;
  if (empty && create) {
    g_autoptr (GString) sql = g_string_new (NULL);
    char *values = sqlite3_mprintf (
      "INSERT INTO study VALUES ('format', '%d'), ('sha256', %Q), ('title', %Q), "
      "('run', %Q), ('plan', %Q), ('cases', '%lld');",
      STORE_VERSION, store->study->sha256, store->study->title,
      qn_study_run_names[store->study->run], qn_plan_kind_names[store->study->plan],
      (long long) qn_study_case_count (store->study));
    g_string_printf (sql,
                     "BEGIN IMMEDIATE; PRAGMA application_id = %d; "
                     "CREATE TABLE study (key TEXT PRIMARY KEY, value TEXT); %s "
                     "CREATE TABLE cases (",
                     APPLICATION_ID, values);
    /* In the order in which rows are written. */
    g_string_append (sql, "\"case\" INTEGER PRIMARY KEY, status TEXT NOT NULL");
    for (guint i = 0; i < store->study->parameters->len; i++)
      g_string_append_printf (sql, ", \"%s\" REAL",
                              qn_study_parameter (store->study, i)->name);
    for (guint i = 0; i < store->study->outputs->len; i++) {
      QnStudyOutput output = qn_study_output (store->study, i);
      g_string_append_printf (sql, ", %s %s", qn_study_output_names[output],
                              qn_study_output_is_number (output) ? "REAL" : "TEXT");
    }
    g_string_append (sql, ", outcome TEXT, reason TEXT, seconds REAL, version TEXT, "
                          "model_sha256 TEXT");
    g_string_append (sql, "); COMMIT;");
    sqlite3_free (values);
    return run (store, sql->str, error);
  }
  if (empty)
    return refuse (store, _ ("the database is empty"), error);
  if (g_ascii_strtoll (id, NULL, 10) != APPLICATION_ID)
    return refuse (store, _ ("this is not the database of a study"), error);
  if (!ask (store, "SELECT value FROM study WHERE key = 'sha256'", &sum, error))
    return FALSE;
  return g_strcmp0 (sum, store->study->sha256) == 0
         || refuse (store, _ ("the database belongs to another study"), error);
}

/* Opens a database that may be of any study, or empty. */
static QnStore *
open_any (const char *path, const QnStudy *study, gboolean create, GError **error)
{
  QnStore *store = g_new0 (QnStore, 1);
  store->path = g_strdup (path);
  store->study = study;
  if (!create && !g_file_test (path, G_FILE_TEST_EXISTS)) {
    qn_io_error_set_errno (error, path, _ ("cannot be read"), ENOENT);
    g_clear_pointer (&store, qn_store_close);
    return NULL;
  }
  int flags = SQLITE_OPEN_READWRITE | (create ? SQLITE_OPEN_CREATE : 0);
  if (sqlite3_open_v2 (path, &store->db, flags, NULL) != SQLITE_OK) {
    fail (store, error);
    g_clear_pointer (&store, qn_store_close);
    return NULL;
  }
  sqlite3_busy_timeout (store->db, PATIENCE);
  return store;
}

QnStore *
qn_store_open (const char *path, const QnStudy *study, gboolean create, GError **error)
{
  QnStore *store = open_any (path, study, create, error);
  if (store != NULL && !check_study (store, create, error))
    g_clear_pointer (&store, qn_store_close);
  return store;
}

gboolean
qn_store_mark_present (QnStore *store, guint8 *marks, gsize count, GError **error)
{
  sqlite3_stmt *statement = NULL;
  int step;
  if (sqlite3_prepare_v2 (store->db, "SELECT \"case\" FROM cases", -1, &statement, NULL)
      != SQLITE_OK)
    return fail (store, error);
  while ((step = sqlite3_step (statement)) == SQLITE_ROW) {
    gint64 number = sqlite3_column_int64 (statement, 0);
    if (number >= 1 && (gsize) number <= count)
      marks[number - 1] = 1;
  }
  gboolean ok = step == SQLITE_DONE || fail (store, error);
  sqlite3_finalize (statement);
  return ok;
}

gboolean
qn_store_forget_failed (QnStore *store, GError **error)
{
  return run (store, "DELETE FROM cases WHERE status = 'failed'", error);
}

/* NULL binds NULL, and so does not-a-number. */
static void
bind_text (sqlite3_stmt *statement, int *column, const char *text)
{
  sqlite3_bind_text (statement, (*column)++, text, -1, SQLITE_TRANSIENT);
}

gboolean
qn_store_add (QnStore *store, gsize index, const double *values,
              const QnCaseResult *result, GError **error)
{
  const QnStudy *study = store->study;
  int column = 1;
  store->open = store->open || run (store, "BEGIN IMMEDIATE", error);
  if (!store->open)
    return FALSE;
  if (store->add == NULL) {
    g_autoptr (GString) sql = g_string_new ("INSERT OR REPLACE INTO cases VALUES (?");
    for (guint i = 1; i < OWN_COLUMNS + study->parameters->len + study->outputs->len; i++)
      g_string_append (sql, ", ?");
    g_string_append (sql, ")");
    if (sqlite3_prepare_v2 (store->db, sql->str, -1, &store->add, NULL) != SQLITE_OK)
      return fail (store, error);
  }
  sqlite3_bind_int64 (store->add, column++, (gint64) index + 1);
  bind_text (store->add, &column, result->failed ? "failed" : "done");
  for (guint i = 0; i < study->parameters->len; i++)
    sqlite3_bind_double (store->add, column++, values[i]);
  for (guint i = 0; i < study->outputs->len; i++) {
    QnStudyOutput output = qn_study_output (study, i);
    if (output == QN_STUDY_MECHANISM_KIND)
      bind_text (store->add, &column, result->mechanism);
    else if (output == QN_STUDY_MECHANISM_SHAPE)
      bind_text (store->add, &column, result->shape);
    else
      sqlite3_bind_double (store->add, column++, result->numbers[output]);
  }
  bind_text (store->add, &column, result->outcome);
  bind_text (store->add, &column, result->reason);
  sqlite3_bind_double (store->add, column++, result->seconds);
  bind_text (store->add, &column, "quoin " QN_VERSION);
  bind_text (store->add, &column, study->project.sha256);
  gboolean ok = sqlite3_step (store->add) == SQLITE_DONE || fail (store, error);
  sqlite3_reset (store->add);
  return ok;
}

gboolean
qn_store_commit (QnStore *store, GError **error)
{
  if (!store->open)
    return TRUE;
  if (!run (store, "COMMIT", error))
    return FALSE;
  store->open = FALSE;
  return TRUE;
}

gboolean
qn_store_merge (QnStore *store, const char *path, gsize *added, GError **error)
{
  QnStore *other = open_any (path, store->study, FALSE, error);
  gboolean empty;
  if (other == NULL)
    return FALSE;
  gboolean ok =
    is_empty (other, &empty, error) && (empty || check_study (other, FALSE, error));
  qn_store_close (other);
  *added = 0;
  if (!ok || empty)
    return ok;

  ok = qn_store_commit (store, error);
  char *attach = sqlite3_mprintf ("ATTACH %Q AS other", path);
  int before = sqlite3_total_changes (store->db);
  ok = ok && run (store, attach, error);
  sqlite3_free (attach);
  if (!ok)
    return FALSE;
  ok = run (store,
            "INSERT OR REPLACE INTO main.cases SELECT * FROM other.cases AS theirs "
            "WHERE NOT EXISTS (SELECT 1 FROM main.cases AS ours "
            "WHERE ours.\"case\" = theirs.\"case\" "
            "AND (ours.status = 'done' OR theirs.status = 'failed'))",
            error);
  *added = (gsize) (sqlite3_total_changes (store->db) - before);
  return run (store, "DETACH other", ok ? error : NULL) && ok;
}

/* Reads the row that the statement stands at; texts are borrowed from it. */
static void
take_row (const QnStudy *study, sqlite3_stmt *statement, double *values,
          QnCaseResult *result)
{
  int column = 1;
  *result = (QnCaseResult){ 0 };
  for (int i = 0; i < QN_STUDY_OUTPUT_COUNT; i++)
    result->numbers[i] = NAN;
  result->failed =
    g_strcmp0 ((const char *) sqlite3_column_text (statement, column++), "failed") == 0;
  for (guint i = 0; i < study->parameters->len; i++)
    values[i] = sqlite3_column_double (statement, column++);
  for (guint i = 0; i < study->outputs->len; i++, column++) {
    QnStudyOutput output = qn_study_output (study, i);
    if (output == QN_STUDY_MECHANISM_KIND)
      result->mechanism = (char *) sqlite3_column_text (statement, column);
    else if (output == QN_STUDY_MECHANISM_SHAPE)
      result->shape = (char *) sqlite3_column_text (statement, column);
    else if (sqlite3_column_type (statement, column) != SQLITE_NULL)
      result->numbers[output] = sqlite3_column_double (statement, column);
  }
  result->outcome = (char *) sqlite3_column_text (statement, column++);
  result->reason = (char *) sqlite3_column_text (statement, column++);
  result->seconds = sqlite3_column_double (statement, column);
}

gboolean
qn_store_read (QnStore *store, QnStoreRowFunc row, gpointer data, GError **error)
{
  sqlite3_stmt *statement = NULL;
  g_autofree double *values = g_new (double, store->study->parameters->len);
  gboolean wanted = TRUE;
  int step = SQLITE_DONE;
  if (sqlite3_prepare_v2 (store->db, "SELECT * FROM cases ORDER BY \"case\"", -1,
                          &statement, NULL)
      != SQLITE_OK)
    return fail (store, error);
  while (wanted && (step = sqlite3_step (statement)) == SQLITE_ROW) {
    QnCaseResult result;
    take_row (store->study, statement, values, &result);
    wanted = row ((gsize) sqlite3_column_int64 (statement, 0) - 1, values, &result, data);
  }
  gboolean ok = !wanted || step == SQLITE_DONE || fail (store, error);
  sqlite3_finalize (statement);
  return ok;
}

gboolean
qn_store_count (QnStore *store, gsize *rows, gsize *failed, GError **error)
{
  g_autofree char *all = NULL, *bad = NULL;
  if (!ask (store, "SELECT count(*) FROM cases", &all, error)
      || !ask (store, "SELECT count(*) FROM cases WHERE status = 'failed'", &bad, error))
    return FALSE;
  *rows = (gsize) g_ascii_strtoull (all, NULL, 10);
  *failed = (gsize) g_ascii_strtoull (bad, NULL, 10);
  return TRUE;
}

gboolean
qn_store_get_note (QnStore *store, const char *key, char **value, GError **error)
{
  char *sql = sqlite3_mprintf ("SELECT value FROM study WHERE key = %Q", key);
  gboolean ok = ask (store, sql, value, error);
  sqlite3_free (sql);
  return ok;
}

gboolean
qn_store_set_note (QnStore *store, const char *key, const char *value, GError **error)
{
  char *sql =
    sqlite3_mprintf ("INSERT OR REPLACE INTO study VALUES (%Q, %Q)", key, value);
  gboolean ok = run (store, sql, error);
  sqlite3_free (sql);
  return ok;
}

void
qn_store_close (QnStore *store)
{
  if (store == NULL)
    return;
  sqlite3_finalize (store->add);
  sqlite3_close (store->db);
  g_free (store->path);
  g_free (store);
}

/* ---- slices ---- */

static int
compare_names (gconstpointer a, gconstpointer b)
{
  return strcmp (*(const char *const *) a, *(const char *const *) b);
}

/* Paths of the slices' databases, in the order of their names; NULL where the folder cannot be
 * read. */
static GPtrArray *
find_slices (const char *folder, GError **error)
{
  const char *name;
  g_autoptr (GDir) dir = g_dir_open (folder, 0, NULL);
  if (dir == NULL) {
    qn_io_error_set_errno (error, folder, _ ("cannot be read"), errno);
    return NULL;
  }
  GPtrArray *paths = g_ptr_array_new_with_free_func (g_free);
  while ((name = g_dir_read_name (dir)) != NULL)
    if (g_str_has_prefix (name, "shard-") && g_str_has_suffix (name, ".db"))
      g_ptr_array_add (paths, g_build_filename (folder, name, NULL));
  g_ptr_array_sort (paths, compare_names);
  return paths;
}

gboolean
qn_study_gather (const QnStudy *study, const char *folder, QnGathered *gathered,
                 GError **error)
{
  g_autofree char *database = qn_folder_dup_database (folder, (QnShard){ 0, 1 });
  g_autoptr (GPtrArray) slices = find_slices (folder, error);
  *gathered = (QnGathered){ .count = qn_study_case_count (study) };
  int lock = slices != NULL ? qn_folder_lock (database, error) : -1;
  if (lock < 0)
    return FALSE;
  QnStore *store = qn_store_open (database, study, TRUE, error);
  gboolean ok = store != NULL;
  for (guint i = 0; ok && i < slices->len; i++) {
    gsize added = 0;
    ok = qn_store_merge (store, g_ptr_array_index (slices, i), &added, error);
    gathered->added += added;
  }
  ok = ok && qn_store_count (store, &gathered->present, &gathered->failed, error);
  qn_store_close (store);
  close (lock);
  return ok;
}
