#include "doc/view/capacity-settings.h"

#include "core/base/numbers.h"
#include "io/project/project-members.h"
#include "io/project/project.h"
#include "io/text/file-read.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#define MOST_STOREYS 200

static const QnMember members[] = {
  QN_STRING ("control", OPTIONAL, QnCapacitySettings, control),
  QN_STRING ("spectrum", OPTIONAL, QnCapacitySettings, spectrum),
  QN_NUMBER ("ag", OPTIONAL, POSITIVE, QnCapacitySettings, ag),
  QN_STRING ("soil", OPTIONAL, QnCapacitySettings, soil),
  QN_NUMBER ("damping", OPTIONAL, POSITIVE, QnCapacitySettings, damping),
  QN_STRING ("unit", OPTIONAL, QnCapacitySettings, unit),
  QN_NUMBER ("confidence", OPTIONAL, POSITIVE, QnCapacitySettings, confidence),
  QN_BOOL ("mechanism", OPTIONAL, QnCapacitySettings, mechanism),
  QN_NUMBER ("tie_strain", OPTIONAL, POSITIVE, QnCapacitySettings, tie_strain),
  QN_NUMBER ("part_period", OPTIONAL, POSITIVE, QnCapacitySettings, part_period),
  QN_NUMBER ("height", OPTIONAL, POSITIVE, QnCapacitySettings, floor.height),
  QN_NUMBER ("building_height", OPTIONAL, POSITIVE, QnCapacitySettings, floor.building),
  QN_COUNT ("storeys", OPTIONAL, MOST_STOREYS, QnCapacitySettings, floor.storeys),
  QN_NUMBER ("building_period", OPTIONAL, POSITIVE, QnCapacitySettings, floor.period),
  QN_NUMBER ("building_damping", OPTIONAL, POSITIVE, QnCapacitySettings, floor.damping),
  { 0 },
};

gboolean
qn_capacity_settings_read (const QnProject *project, QnCapacitySettings *settings,
                           GError **error)
{
  QnReader reader = qn_project_reader (project);
  *settings = (QnCapacitySettings){ 0 };
  QnJsonValue root = qn_json_value_root (&reader, project->extras);
  QnJsonValue place = qn_json_value_member (&root, QN_CAPACITY_MEMBER);
  if (place.json == NULL || qn_members_read (&place, members, NULL, settings))
    return TRUE;
  qn_capacity_settings_clear (settings);
  g_propagate_error (error, reader.error);
  return FALSE;
}

static gboolean
refuse (const char *problem, GError **error)
{
  return qn_io_fail (error, QN_IO_ERROR_OVERRIDE, "%s", problem);
}

static gboolean
parse_number (const char *text, double *number, double unit)
{
  char *end;
  *number = g_ascii_strtod (text, &end);
  if (end != text && unit != 0 && strcmp (end, "g") == 0)
    *number *= unit;
  else if (end == text || *end != '\0')
    return FALSE;
  return qn_number_problem (*number, QN_RANGE_POSITIVE, QN_LARGEST_NUMBER)
         == QN_PROBLEM_NONE;
}

static gboolean
is_of_code (const char *spectrum)
{
  return strcmp (spectrum, "type1") == 0 || strcmp (spectrum, "type2") == 0;
}

gboolean
qn_capacity_settings_set (QnCapacitySettings *s, const char *option, const char *value,
                          GError **error)
{
  g_autofree char *key = g_strdelimit (g_strdup (option), "-", '_');
  g_autofree char *positive = g_strdup_printf (_ ("%s is a number above 0"), option);
  const QnMember *member = members;
  while (member->key != NULL && strcmp (member->key, key) != 0)
    member++;
  gpointer target = (char *) s + member->offset;
  if (target == &s->spectrum) { /* what belongs to another one goes */
    s->direct = TRUE;
    g_clear_pointer (&s->unit, g_free);
    if (!is_of_code (value)) {
      s->ag = 0;
      g_clear_pointer (&s->soil, g_free);
    }
  }
  if (member->kind == QN_MEMBER_STRING) {
    char **text = target;
    g_free (*text);
    *text = g_strdup (value);
    return TRUE;
  }
  if (member->kind == QN_MEMBER_BOOL) {
    s->mechanism = strcmp (value, "true") == 0;
    return s->mechanism || strcmp (value, "false") == 0
           || refuse (_ ("mechanism is true or false"), error);
  }
  if (member->kind == QN_MEMBER_COUNT) {
    double storeys;
    if (!parse_number (value, &storeys, 0) || storeys > MOST_STOREYS
        || storeys != floor (storeys))
      return refuse (_ ("storeys is a count from 1 to 200"), error);
    s->floor.storeys = (int) storeys;
    return TRUE;
  }
  if (member->kind == QN_MEMBER_NUMBER)
    return parse_number (value, target, target == &s->ag ? QN_STANDARD_GRAVITY : 0)
           || refuse (positive, error);
  g_autofree char *problem = g_strdup_printf (_ ("%s: no such option"), option);
  return refuse (problem, error);
}

/* A table of periods and accelerations, all of them positive. */
static gboolean
read_spectrum (const QnCapacitySettings *s, const QnProject *project,
               gboolean allow_outside, QnRecord *points, GError **error)
{
  g_autofree char *folder =
    g_path_get_dirname (project->path != NULL ? project->path : "");
  g_autofree char *path = s->direct
                            ? g_strdup (s->spectrum)
                            : qn_file_inside (folder, s->spectrum, allow_outside, error);
  if (path == NULL || !qn_record_read (path, s->unit, 0, TRUE, points, error))
    return FALSE;
  for (gsize i = 0; i < points->count; i++)
    if (!(points->points[i].y > 0)) {
      qn_record_clear (points);
      return qn_io_fail (error, QN_IO_ERROR_INVALID,
                         _ ("%s: accelerations of a spectrum must be positive"), path);
    }
  return TRUE;
}

/* The floor that the part stands on, where its height is said. */
static gboolean
apply_floor (const QnCapacitySettings *s, QnFloor *floor, GError **error)
{
  *floor = s->floor;
  if (floor->damping == 0)
    floor->damping = 0.05;
  if (floor->height == 0) {
    *floor = (QnFloor){ 0 };
    return (s->floor.building == 0 && s->floor.storeys == 0 && s->floor.period == 0
            && s->floor.damping == 0)
           || refuse (_ ("height is missing: of the part above the foundation"), error);
  }
  if (floor->storeys < 1 || floor->period == 0)
    return refuse (_ ("storeys and building-period are needed above ground"), error);
  if (!(floor->damping < 1))
    return refuse (_ ("building-damping is a ratio between 0 and 1"), error);
  return floor->height <= floor->building
         || refuse (_ ("building-height is at least height"), error);
}

gboolean
qn_capacity_settings_apply (const QnCapacitySettings *s, const QnProject *project,
                            gboolean allow_outside, QnCapacityAnswer *answer,
                            QnRecord *points, GError **error)
{
  QnSpectrum *spectrum = &answer->spectrum;
  const char *soil = s->soil != NULL ? s->soil : "";
  answer->confidence = s->confidence > 0 ? s->confidence : 1;
  answer->kinematic = s->mechanism;
  answer->tie_strain = s->tie_strain;
  answer->part_period = s->part_period;
  answer->control =
    s->control != NULL ? qn_model_find_block (&project->model, s->control) : QN_NONE;
  answer->has_spectrum = s->spectrum != NULL;
  *spectrum = (QnSpectrum){ .damping = s->damping > 0 ? s->damping : 0.05 };
  if (s->control != NULL && answer->control == QN_NONE)
    return qn_io_fail (error, QN_IO_ERROR_INVALID,
                       _ ("%s: --control: no block has the name %s"), project->name,
                       s->control);
  if (!(answer->confidence >= 1))
    return refuse (_ ("confidence is a factor of 1 or more"), error);
  if (!(spectrum->damping < 1))
    return refuse (_ ("damping is a ratio between 0 and 1"), error);
  if (!apply_floor (s, &spectrum->floor, error))
    return FALSE;
  if (s->spectrum == NULL)
    return (s->ag == 0 && s->floor.height == 0 && s->soil == NULL && s->unit == NULL)
           || refuse (_ ("spectrum is missing"), error);
  if (!is_of_code (s->spectrum)) {
    if (s->ag != 0 || s->soil != NULL)
      return refuse (_ ("ag and soil belong to the spectra type1 and type2"), error);
    if (points->count == 0 && !read_spectrum (s, project, allow_outside, points, error))
      return FALSE;
    spectrum->kind = QN_SPECTRUM_POINTS;
    spectrum->points = points->points;
    spectrum->point_count = points->count;
    return TRUE;
  }
  if (s->ag == 0 || s->soil == NULL)
    return refuse (_ ("ag and soil are needed by a spectrum of EN 1998-1"), error);
  if (strlen (soil) != 1 || *soil < 'A' || *soil > 'E')
    return refuse (_ ("soil is A, B, C, D or E"), error);
  spectrum->kind =
    strcmp (s->spectrum, "type1") == 0 ? QN_SPECTRUM_EN_1 : QN_SPECTRUM_EN_2;
  spectrum->ground_acceleration = s->ag;
  spectrum->soil = (QnSoil) (*soil - 'A');
  return TRUE;
}

char *
qn_capacity_settings_to_json (const QnCapacitySettings *s)
{
  const QnCapacitySettings usual = { 0 };
  GString *json = g_string_new ("{");
  qn_members_write (json, members, NULL, s, &usual);
  g_string_append (json, " }");
  return g_string_free (json, FALSE);
}

void
qn_capacity_settings_clear (QnCapacitySettings *s)
{
  g_free (s->control);
  g_free (s->spectrum);
  g_free (s->soil);
  g_free (s->unit);
  *s = (QnCapacitySettings){ 0 };
}
