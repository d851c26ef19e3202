/* Project texts to start from, and the messages of those that are refused. */
#pragma once

#include "io/project/project.h"

/* A small sound project: "base" (fixed) under "top", one law "joint". Its lines are numbered in
 * the tests that expect errors at a place:
 *
 *   1 {
 *   2   "format": "quoin", "version": 1,
 *   3   "laws": [
 *   4     { "name": "joint", … } ],
 *   5   "blocks": [
 *   6     { "name": "base", … },
 *   7     { "name": "top", … } ],
 *   8   "contact": { "law": "joint" },
 *   9   "loads": { "dead": [ … ], "live": [ … ] }
 *  10 }
 */
extern const char test_project_text[];

/* The text with the first occurrence of `what`, which must be there, replaced by `by`. Free with
 * g_free(). */
char *test_replace (const char *text, const char *what, const char *by);

/* Parses a text that must be sound, under the name "wall.quoin". */
void test_parse (const char *text, QnProject *project);

/* Parses a text that must be refused; its message without "wall.quoin:". Free with g_free(). */
char *test_parse_error (const char *text, const char *const *overrides);
