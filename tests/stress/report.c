#include "stress/report.h"

#include "stress/checks.h"
#include "stress/shortfalls.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

char *
stress_dup_faults (guint faults)
{
  static const char *const texts[] = {
#define STRESS_FAULT_TEXT(name, text) text,
    STRESS_FAULTS (STRESS_FAULT_TEXT)
#undef STRESS_FAULT_TEXT
  };
  GString *joined = g_string_new (NULL);

  for (int i = 0; i < STRESS_FAULT_COUNT; i++)
    if ((faults >> i & 1) != 0)
      g_string_append_printf (joined, "%s%s", joined->len > 0 ? "; " : "", texts[i]);
  return g_string_free (joined, FALSE);
}

/* --- The protocol ----------------------------------------------------------------------- */

static void
print_solve (const char *name, const StressSolve *solve)
{
  if (!solve->solved)
    return;
  g_autofree char *faults = stress_dup_faults (solve->faults);
  printf ("#   %s: %s, %.8g, %d steps, %d iterations, %d factorisations, %.2f s; off by "
          "%.1e, %.1e, %s %.1e, %.1e, %.1e%s%s\n",
          name, qn_outcome_names[solve->outcome], solve->multiplier, solve->steps,
          solve->iterations, solve->factorizations, solve->seconds,
          solve->check.out_of_balance, solve->check.excess,
          solve->check.uncertain ? "last motion" : "mechanism", solve->check.misfit,
          solve->check.penetration, solve->check.power, faults[0] != '\0' ? ": " : "",
          faults);
}

static void
print_figures (const StressEntry *entry)
{
  const StressRow *row = &entry->row;

  printf ("# %s: %zu blocks, %zu pairs%s%s\n", entry->c->name, row->blocks, row->pairs,
          row->description[0] != '\0' ? ", " : "", row->description);
  if (row->problem != QN_PROBLEM_NONE)
    printf ("#   refused: %s\n", qn_problem_text (row->problem));
  if (row->limit.solved)
    printf ("#   limit analysis: %s, %.10g to %.10g, %d iterations, %.2f s\n",
            qn_outcome_names[row->limit.outcome], row->lower, row->upper,
            row->limit.iterations, row->limit.seconds);
  print_solve ("dilatancy = friction", &row->paths[STRESS_ASSOCIATIVE]);
  print_solve ("dilatancy 0", &row->paths[STRESS_SLIDING]);
  if (!isnan (row->mirrored))
    printf ("#   loaded the other way: %.8g\n", row->mirrored);
  if (!isnan (row->repeated))
    printf ("#   dilatancy 0 with other increments: %.8g\n", row->repeated);
}

bool
stress_report_tap (const StressEntry *entry, guint number)
{
  guint faults = stress_row_faults (&entry->row);
  const StressShortfall *known = stress_shortfall (entry->c->name);
  guint unknown = faults & ~(known != NULL ? known->faults : 0);
  g_autofree char *text = stress_dup_faults (unknown != 0 ? unknown : faults);

  print_figures (entry);
  if (unknown != 0)
    printf ("# %s\n", text);
  if (faults == 0 || unknown != 0)
    printf ("%s %u %s\n", faults == 0 ? "ok" : "not ok", number, entry->c->name);
  else /* the protocol's mark for a failure that is expected */
    printf ("not ok %u %s # %s %s\n", number, entry->c->name,
            "TO"
            "DO",
            text);
  fflush (stdout);
  return unknown != 0;
}

/* --- The tables ------------------------------------------------------------------------- */

/* What the rows of a group have in common: the worst of each figure. */
typedef struct Group {
  char *name;
  int cases, faulty;
  int outcomes[QN_OUTCOME_COUNT], refused;
  int iterations;
  double difference, lowest, out_of_balance, excess;
  int collapses, proved; /* of those, by forces and mechanism together */
  int uncertain;         /* of those, how the structure moves on */
  int repeated, apart;   /* of those, by more than 1 % */
} Group;

/* Cases of one subject make a group, random walls of a kind another. */
static char *
dup_group_name (const StressEntry *entry)
{
  const char *kind = entry->row.description;

  if (kind[0] != '\0')
    return g_strndup (kind, strcspn (kind, ","));
  return g_strdup_printf ("%c%s", g_ascii_toupper (entry->c->subject[0]),
                          entry->c->subject + 1);
}

static void
add_path (Group *group, const StressRow *row, StressFlow flow)
{
  const StressSolve *path = &row->paths[flow];
  bool collapses = path->solved && path->outcome == QN_OUTCOME_COLLAPSE
                   && row->limit.outcome == QN_OUTCOME_COLLAPSE && row->upper > 0;

  if (!path->solved)
    return;
  group->outcomes[path->outcome]++;
  group->iterations = MAX (group->iterations, path->iterations);
  group->out_of_balance = fmax (group->out_of_balance, path->check.out_of_balance);
  group->excess = fmax (group->excess, path->check.excess);
  if (path->outcome == QN_OUTCOME_COLLAPSE) {
    group->collapses++;
    group->uncertain += path->check.uncertain;
    group->proved += path->check.misfit <= STRESS_MOTION_TOLERANCE;
  }
  if (collapses && flow == STRESS_ASSOCIATIVE && row->upper > 1e-6)
    group->difference =
      fmax (group->difference, fabs (path->multiplier / row->upper - 1));
  if (collapses && flow == STRESS_SLIDING && row->upper > 1e-6)
    group->lowest = fmin (group->lowest, path->multiplier / row->upper);
}

static void
add_repeated (Group *group, const StressRow *row)
{
  const StressSolve *path = &row->paths[STRESS_SLIDING];
  double larger = fmax (row->repeated, path->multiplier);

  if (isnan (row->repeated) || path->outcome != QN_OUTCOME_COLLAPSE)
    return;
  group->repeated++;
  group->apart += fabs (row->repeated - path->multiplier) > 0.01 * larger;
}

static GArray *
collect_groups (const GArray *entries)
{
  GArray *groups = g_array_new (FALSE, TRUE, sizeof (Group));

  for (guint i = 0; i < entries->len; i++) {
    const StressEntry *entry = &g_array_index (entries, StressEntry, i);
    g_autofree char *name = dup_group_name (entry);
    Group *group = NULL;
    for (guint k = 0; k < groups->len && group == NULL; k++) {
      Group *g = &g_array_index (groups, Group, k);
      if (g_str_equal (g->name, name))
        group = g;
    }
    if (group == NULL) {
      const Group fresh = { .name = g_steal_pointer (&name), .lowest = INFINITY };
      g_array_append_val (groups, fresh);
      group = &g_array_index (groups, Group, groups->len - 1);
    }
    group->cases++;
    group->faulty += stress_row_faults (&entry->row) != 0;
    group->refused += entry->row.problem != QN_PROBLEM_NONE;
    for (int flow = 0; flow < STRESS_FLOW_COUNT; flow++)
      add_path (group, &entry->row, (StressFlow) flow);
    add_repeated (group, &entry->row);
  }
  return groups;
}

static void
append_number (GString *text, bool known, const char *format, double value)
{
  char number[G_ASCII_DTOSTR_BUF_SIZE];

  g_string_append (text, " | ");
  if (known)
    g_string_append (text, g_ascii_formatd (number, sizeof number, format, value));
}

static void
append_share (GString *text, int part, int whole)
{
  g_string_append (text, " | ");
  if (whole > 0)
    g_string_append_printf (text, "%.0f %%", 100.0 * part / whole);
}

static void
append_group (GString *text, const Group *group)
{
  static const char *const outcomes[QN_OUTCOME_COUNT] = {
    "collapse", "no collapse", "snap", "unbounded", "fall", "stopped", "no answer"
  };
  const char *comma = "";
  bool solved = group->cases > group->refused;

  g_string_append_printf (text, "| %s | %d | ", group->name, group->cases);
  for (int i = 0; i < QN_OUTCOME_COUNT; i++)
    if (group->outcomes[i] > 0) {
      g_string_append_printf (text, "%s%d %s", comma, group->outcomes[i], outcomes[i]);
      comma = ", ";
    }
  if (group->refused > 0)
    g_string_append_printf (text, "%s%d refused", comma, group->refused);
  append_number (text,
                 group->outcomes[QN_OUTCOME_COLLAPSE] > 0 && isfinite (group->lowest),
                 "%.0e", group->difference);
  append_number (text, isfinite (group->lowest), "%.3f", group->lowest);
  append_number (text, solved, "%.0f", group->iterations);
  append_number (text, solved, "%.0e", group->out_of_balance);
  append_number (text, solved, "%.0e", group->excess);
  append_share (text, group->proved, group->collapses);
  append_number (text, group->uncertain > 0, "%.0f", group->uncertain);
  append_share (text, group->apart, group->repeated);
  append_number (text, group->faulty > 0, "%.0f", group->faulty);
  g_string_append (text, " |\n");
}

static void
append_groups (GString *text, const GArray *entries)
{
  g_autoptr (GArray) groups = collect_groups (entries);

  g_string_append (
    text, "\n| | cases | how paths end | off limit analysis | least | iterations | "
          "equilibrium | strength | proved | uncertain | apart | faults |\n"
          "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (guint i = 0; i < groups->len; i++) {
    Group *group = &g_array_index (groups, Group, i);
    append_group (text, group);
    g_free (group->name);
  }
}

/* `why`: the reason of the fault before, which is not told again. */
static void
append_fault (GString *text, const StressEntry *entry, const char **why)
{
  const StressRow *row = &entry->row;
  const StressShortfall *known = stress_shortfall (entry->c->name);
  g_autofree char *faults = stress_dup_faults (stress_row_faults (row));

  g_string_append_printf (text, "| %s%s%s | %zu", entry->c->name,
                          row->description[0] != '\0' ? ": " : "", row->description,
                          row->blocks);
  append_number (text, row->limit.solved, "%.7g", row->upper);
  for (int flow = 0; flow < STRESS_FLOW_COUNT; flow++)
    append_number (text, row->paths[flow].steps > 0, "%.7g", row->paths[flow].multiplier);
  const char *reason = known != NULL ? known->why : "";
  g_string_append_printf (text, " | %s%s%s |\n", faults, reason == *why ? "" : ". ",
                          reason == *why ? ", as above" : reason);
  *why = reason;
}

static void
append_faults (GString *text, const GArray *entries)
{
  const char *why = NULL;
  bool any = false;

  for (guint i = 0; i < entries->len; i++) {
    const StressEntry *entry = &g_array_index (entries, StressEntry, i);
    if (stress_row_faults (&entry->row) == 0)
      continue;
    if (!any)
      g_string_append (
        text, "| case | blocks | limit analysis | dilatancy = friction | dilatancy 0 | "
              "what is wrong |\n| --- | --- | --- | --- | --- | --- |\n");
    any = true;
    append_fault (text, entry, &why);
  }
  if (!any)
    g_string_append (text, "None.\n");
}

void
stress_report_markdown (GString *text, const GArray *entries, const char *command)
{
  guint faulty = 0, paths = 0;
  double seconds = 0;
  long iterations = 0;

  for (guint i = 0; i < entries->len; i++) {
    const StressRow *row = &g_array_index (entries, StressEntry, i).row;
    faulty += stress_row_faults (row) != 0;
    seconds += row->limit.seconds;
    for (int flow = 0; flow < STRESS_FLOW_COUNT; flow++) {
      paths += row->paths[flow].solved;
      iterations += row->paths[flow].iterations;
      seconds += row->paths[flow].seconds;
    }
  }
  g_string_append_printf (text,
                          "`build/tests/stress/%s`: %u cases, %u paths, %ld iterations,\n"
                          "%.0f s of processor time; %u cases with faults.\n",
                          command, entries->len, paths, iterations, seconds, faulty);
  append_groups (text, entries);
  g_string_append (text, "\n### Faults\n\n");
  append_faults (text, entries);
}
