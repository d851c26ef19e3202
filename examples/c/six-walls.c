/* The six walls' load multipliers with libquoin:
 *
 *   cc six-walls.c -o six-walls $(pkg-config --cflags --libs quoin)
 *   ./six-walls ../ferris-tin-loi/wall?.quoin
 */
#include <quoin.h>
#include <stdio.h>

static int
complain (QuoinError *error)
{
  fprintf (stderr, "%s\n", quoin_error_get_message (error));
  quoin_error_free (error);
  return 1;
}

int
main (int argc, char **argv)
{
  printf ("%-12s %8s %12s %12s\n", "wall", "blocks", "collapse", "bound");
  for (int i = 1; i < argc; i++) {
    QuoinError *error = NULL;
    QuoinModel *model = quoin_model_open (argv[i], NULL, &error);
    if (model == NULL)
      return complain (error);
    QuoinResult *result = quoin_solve (model, NULL, NULL, &error);
    QuoinResult *bound =
      result != NULL ? quoin_limit (model, true, NULL, NULL, &error) : NULL;
    if (bound == NULL)
      return complain (error);
    printf ("%-12s %8zu %12.5f %12.5f\n", quoin_model_get_title (model),
            quoin_model_get_block_count (model),
            quoin_result_get_collapse_multiplier (result),
            quoin_result_get_upper_bound (bound));
    quoin_result_free (bound);
    quoin_result_free (result);
    quoin_model_unref (model);
  }
  return 0;
}
