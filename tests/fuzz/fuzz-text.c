/* Any bytes as what is typed or kept beside a project: numbers with units, sizes of pictures,
 * weights and places of contact pairs, names of views, a stored history. The first byte says
 * which. */
#include "doc/document/history.h"
#include "doc/text/units.h"
#include "doc/view/pair-text.h"
#include "fuzz.h"
#include "render/backend/output.h"
#include "render/scene/view-options.h"

#include <math.h>
#include <string.h>

/* What is accepted is a number, and so is what is shown of it. */
static void
check_quantity (const char *text)
{
  const QnUnits units = { QN_LENGTH_CM, QN_FORCE_KN, QN_STRESS_MPA };
  for (int quantity = 0; quantity < QN_QUANTITY_COUNT; quantity++) {
    double value = 0, again = 0;
    if (!qn_units_parse (units, (QnQuantity) quantity, text, &value, NULL))
      continue;
    g_assert_false (isnan (value));
    if (isfinite (value) && fabs (value) > 1e290) /* shown in a smaller unit: infinite */
      continue;
    g_autofree char *shown =
      qn_units_format_full (units, (QnQuantity) quantity, value, 17);
    g_assert_true (qn_units_parse (units, (QnQuantity) quantity, shown, &again, NULL));
    if (isfinite (value))
      /* Numbers near the smallest have few digits. */
      g_assert_true (fabs (again - value) <= 1e-12 * fabs (value) + 1e-300);
  }
}

static void
check_size (const char *text)
{
  QnOutput output;
  QnPage page;
  qn_output_init (&output);
  if (qn_output_parse_size (&output, text, NULL) && qn_output_page (&output, &page, NULL))
    g_assert_true (page.width > 0 && page.height > 0 && page.width <= 32000
                   && page.height <= 32000);
}

static void
check_pairs (const char *text)
{
  QnPairRule rule;
  GError *error = NULL;
  const char *half = strchr (text, ';');
  g_autofree char *positions =
    g_strndup (text, half != NULL ? (gsize) (half - text) : 99);
  memset (&rule, 0, sizeof rule);
  if (!qn_pair_rule_parse (&rule, positions, half != NULL ? half + 1 : "", &error))
    g_assert_nonnull (error);
  g_clear_error (&error);
}

static void
check_history (const char *text)
{
  QnEditHistory *history = qn_history_from_json (text, "{\n}\n");
  if (history == NULL)
    return;
  g_free (qn_history_go_to (history, "{\n}\n", 0));
  g_free (qn_history_to_json (history, "{\n}\n"));
  qn_history_free (history);
}

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  if (size == 0)
    return 0;
  g_autofree char *bytes = g_strndup ((const char *) data + 1, size - 1);
  g_autofree char *text = g_utf8_make_valid (bytes, -1);
  QnViewOptions options;
  switch (data[0] % 5) {
  case 0:
    check_quantity (text);
    break;
  case 1:
    check_size (text);
    break;
  case 2:
    check_pairs (text);
    break;
  case 3:
    check_history (text);
    break;
  default:
    qn_view_options_init (&options, QN_VIEW_MODEL);
    qn_view_options_set (&options, "field", text);
    qn_view_options_set (&options, "scale", text);
    qn_view_options_set (&options, text, "on");
    break;
  }
  return 0;
}
