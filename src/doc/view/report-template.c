#include "doc/view/report-template.h"

#include "core/base/word.h"
#include "io/project/project-members.h"
#include "io/project/project.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

static const char *const papers[QN_PAPER_COUNT] = { "a4", "letter" };

static const QnMember members[] = {
  QN_KNOWN ("sections"),
  QN_CHOICE ("paper", OPTIONAL, papers, QnReportTemplate, paper),
  QN_BOOL ("every_joint", OPTIONAL, QnReportTemplate, every_joint),
  QN_NUMBER ("demand", OPTIONAL, POSITIVE, QnReportTemplate, demand),
  QN_STRING ("author", OPTIONAL, QnReportTemplate, author),
  QN_STRING ("text", OPTIONAL, QnReportTemplate, text),
  { 0 },
};

const char *const qn_report_section_names[] = {
  "title",    "model",       "materials",  "loads",     "assumptions",
  "findings", "contacts",    "results",    "mechanism", "combinations",
  "joints",   "certificate", "comparison", "files",     NULL,
};

/* Adds a section; FALSE with what is wrong where none has this name. */
static gboolean
add_section (QnReportTemplate *plan, const char *name, char **problem)
{
  int i;
  if (qn_find_word (name, qn_report_section_names, QN_REPORT_SECTION_COUNT, &i))
    return plan->sections[i] = true;
  g_autofree char *known = g_strjoinv (", ", (char **) qn_report_section_names);
  *problem = g_strdup_printf (_ ("is none of %s"), known);
  return FALSE;
}

static gboolean
read_sections (const QnJsonValue *object, QnReportTemplate *plan)
{
  QnJsonValue list, element = { 0 };
  if (!qn_member_array (object, "sections", QN_OPTIONAL, &list))
    return FALSE;
  if (list.json == NULL)
    return TRUE;
  memset (plan->sections, 0, sizeof plan->sections);
  while (qn_json_value_next (&list, &element)) {
    const char *name = cJSON_IsString (element.json) ? element.json->valuestring : "";
    g_autofree char *problem = NULL;
    if (!add_section (plan, name, &problem))
      return qn_json_value_fail (&element, problem);
  }
  return TRUE;
}

/* The sections that are named; tables of joints are whole where theirs is. */
static gboolean
set_sections (QnReportTemplate *plan, const char *list, GError **error)
{
  g_auto (GStrv) names = g_strsplit (list, ",", -1);
  memset (plan->sections, 0, sizeof plan->sections);
  for (char **name = names; *name != NULL; name++) {
    g_autofree char *problem = NULL;
    if (!add_section (plan, *name, &problem))
      return qn_io_fail (error, QN_IO_ERROR_OVERRIDE, "%s: %s", *name, problem);
  }
  plan->every_joint = plan->sections[QN_REPORT_JOINTS];
  return TRUE;
}

gboolean
qn_report_template_set (QnReportTemplate *plan, const char *option, const char *value,
                        GError **error)
{
  char *end = NULL;
  const char *problem = NULL;
  if (strcmp (option, "sections") == 0)
    return set_sections (plan, value, error);
  if (strcmp (option, "paper") == 0) {
    problem = qn_paper_parse (value, &plan->paper) ? NULL : _ ("a paper is a4 or letter");
  } else if (strcmp (option, "demand") == 0) {
    plan->demand = g_ascii_strtod (value, &end);
    if (end == value || *end != '\0' || !(plan->demand >= 0) || !isfinite (plan->demand))
      problem = _ ("demand is a positive number");
  } else
    problem = _ ("no such option");
  return problem == NULL
         || qn_io_fail (error, QN_IO_ERROR_OVERRIDE, "%s: %s", value, problem);
}

gboolean
qn_report_template_read (QnReportTemplate *plan, const QnProject *project, GError **error)
{
  QnReader reader = qn_project_reader (project);
  *plan = (QnReportTemplate){ .paper = QN_PAPER_A4 };
  for (int i = 0; i < QN_REPORT_SECTION_COUNT; i++)
    plan->sections[i] = true;
  QnJsonValue root = qn_json_value_root (&reader, project->extras);
  QnJsonValue place = qn_json_value_member (&root, QN_REPORT_MEMBER);
  if (place.json == NULL
      || (qn_members_read (&place, members, NULL, plan) && read_sections (&place, plan)))
    return TRUE;
  g_propagate_error (error, reader.error);
  return FALSE;
}

char *
qn_report_template_to_json (const QnReportTemplate *plan)
{
  const QnReportTemplate usual = { .paper = QN_PAPER_A4 };
  GString *json = g_string_new ("{ \"sections\": [");
  for (int i = 0, count = 0; i < QN_REPORT_SECTION_COUNT; i++)
    if (plan->sections[i]) {
      g_string_append (json, count++ > 0 ? ", " : "");
      qn_json_append_string (json, qn_report_section_names[i]);
    }
  g_string_append_c (json, ']');
  qn_members_write (json, members, NULL, plan, &usual);
  g_string_append (json, " }");
  return g_string_free (json, FALSE);
}

void
qn_report_template_clear (QnReportTemplate *plan)
{
  g_free (plan->author);
  g_free (plan->text);
  *plan = (QnReportTemplate){ 0 };
}
