/* From entities of the model back to keys of the file. */
#include "io/project/project.h"

#include "io/project-text.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

static const char walls[] =
  "{ \"format\": \"quoin\", \"version\": 1,\n"
  "  \"laws\": [ { \"name\": \"j\", \"kind\": \"elastic\", \"kn\": 1, \"ks\": 1 } ],\n"
  "  \"blocks\": [ { \"name\": \"base\", \"vertices\": [[0, -1], [2, -1], [2, 0], [0, "
  "0]],\n"
  "    \"thickness\": 1, \"unit_weight\": 1, \"support\": [true, true, true] } ],\n"
  "  \"walls\": [\n"
  "    { \"name\": \"v\", \"unit\": [1, 1], \"thickness\": 1, \"unit_weight\": 1,\n"
  "      \"courses\": [[1, 1]] },\n"
  "    { \"name\": \"w\", \"origin\": [0, 1], \"unit\": [1, 1], \"thickness\": 1,\n"
  "      \"unit_weight\": 1, \"courses\": [[-1, 1], [1, -0.5, 0.5]] } ],\n"
  "  \"contact\": { \"law\": \"j\" } }";

static void
expect_path (const QnProject *project, QnEntity entity, QnId index, const char *expected)
{
  g_autofree char *path = qn_project_dup_key_path (project, entity, index);
  g_assert_cmpstr (path, ==, expected);
}

static void
test_key_paths (void)
{
  g_auto (QnProject) project;
  test_parse (walls, &project);
  expect_path (&project, QN_ENTITY_MODEL, QN_NONE, "");
  expect_path (&project, QN_ENTITY_LAW, 0, "laws[0]");
  expect_path (&project, QN_ENTITY_WALL, 1, "walls[1]");
  expect_path (&project, QN_ENTITY_CONTACT, QN_NONE, "contact");
  expect_path (&project, QN_ENTITY_FACE_OVERRIDE, 2, "contact.faces[2]");
  expect_path (&project, QN_ENTITY_DEAD_LOAD, 0, "loads.dead[0]");
  expect_path (&project, QN_ENTITY_LIVE_LOAD, 3, "loads.live[3]");
  expect_path (&project, QN_ENTITY_ANALYSIS, QN_NONE, "analysis");

  expect_path (&project, QN_ENTITY_BLOCK, 0, "blocks[0]");
  expect_path (&project, QN_ENTITY_BLOCK, 1, "walls[0].courses[0][0]");
  expect_path (&project, QN_ENTITY_BLOCK, 2, "walls[0].courses[0][1]");
  expect_path (&project, QN_ENTITY_BLOCK, 3, "walls[1].courses[0][1]");
  expect_path (&project, QN_ENTITY_BLOCK, 4, "walls[1].courses[1][0]");
  expect_path (&project, QN_ENTITY_BLOCK, 5, "walls[1].courses[1][2]");
}

static void
expect_error (const QnProject *project, const QnDiag *diag, int code, const char *message)
{
  g_autoptr (GError) error = NULL;
  qn_project_set_error (project, diag, &error);
  g_assert_error (error, QN_IO_ERROR, code);
  g_assert_cmpstr (error->message, ==, message);
}

static void
test_errors (void)
{
  g_auto (QnProject) project;
  QnDiag diag;
  test_parse (walls, &project);

  qn_refuse (&diag, QN_PROBLEM_BLOCKS_OVERLAP, QN_ENTITY_BLOCK, 0);
  diag.other = 3;
  expect_error (
    &project, &diag, QN_IO_ERROR_INVALID,
    "wall.quoin:3:15: blocks[0]: blocks overlap (blocks \"base\" and \"w.1.1\")");

  qn_refuse (&diag, QN_PROBLEM_BLOCK_FLOATING, QN_ENTITY_BLOCK, 5);
  expect_error (&project, &diag, QN_IO_ERROR_INVALID,
                "wall.quoin:9:56: walls[1].courses[1][2]: block is not connected to any "
                "support (block \"w.2.2\")");

  qn_diag_set_field (&diag, QN_PROBLEM_LAW_MISSING, QN_ENTITY_CONTACT, QN_NONE, "law", 0);
  expect_error (&project, &diag, QN_IO_ERROR_INVALID,
                "wall.quoin:10:23: contact.law: contact law is missing");

  qn_diag_set_field (&diag, QN_PROBLEM_NO_SUPPORT, QN_ENTITY_MODEL, QN_NONE, "blocks", 0);
  expect_error (&project, &diag, QN_IO_ERROR_INVALID,
                "wall.quoin:3:13: blocks: no block is supported: fix the ground, or the "
                "lowest blocks");

  qn_diag_no_memory (&diag);
  expect_error (&project, &diag, QN_IO_ERROR_NO_MEMORY, "wall.quoin: not enough memory");
}

static void
test_findings (void)
{
  g_auto (QnProject) project;
  test_parse (walls, &project);
  QnFinding items[] = {
    { QN_PROBLEM_NEAR_MISS_GAP, 1, 2, { 1, 0.5 }, 2e-6, QN_NONE, NULL },
    { QN_PROBLEM_BLOCK_WITHOUT_CONTACT, 0, QN_NONE, { 0, 0 }, 0, QN_NONE, NULL },
  };
  const QnFindings findings = { items, G_N_ELEMENTS (items), G_N_ELEMENTS (items) };
  g_autoptr (GPtrArray) texts = qn_project_dup_finding_texts (&project, &findings);
  g_assert_cmpuint (texts->len, ==, G_N_ELEMENTS (items));
  g_assert_cmpstr (
    g_ptr_array_index (texts, 0), ==,
    "wall.quoin:7:20: walls[0].courses[0][0]: gap just wider than the contact "
    "tolerance (blocks \"v.1.1\" and \"v.1.2\") at (1, 0.5) m: 2e-06 m");
  g_assert_cmpstr (
    g_ptr_array_index (texts, 1), ==,
    "wall.quoin:3:15: blocks[0]: block touches no other block (block \"base\")");
}

/* A project that was never read from a text has no lines. */
static void
test_without_text (void)
{
  g_auto (QnProject) project;
  QnDiag diag;
  qn_project_init (&project);
  qn_diag_set_field (&diag, QN_PROBLEM_NO_BLOCKS, QN_ENTITY_MODEL, QN_NONE, "blocks", 0);
  expect_error (&project, &diag, QN_IO_ERROR_INVALID,
                "project: blocks: no blocks: draw or generate some first");
}

QN_TESTS
{
  g_test_add_func ("/project/key-paths", test_key_paths);
  g_test_add_func ("/project/errors", test_errors);
  g_test_add_func ("/project/findings", test_findings);
  g_test_add_func ("/project/without-text", test_without_text);
}
