/* One test program per room: every test file of the room adds its cases with
 *
 *   QN_TESTS
 *   {
 *     g_test_add_func ("/newton/converges", test_converges);
 *   }
 *
 * and room-main.c, linked whole, runs them all. Cases are run alone by their path: -p /newton, or -r
 * with suites of suites. */
#pragma once

/* Remembers a function that adds cases; called before main(). */
void test_room_note (void (*add_cases) (void));

#define QN_TESTS                                                                         \
  static void add_cases (void);                                                          \
  __attribute__ ((constructor)) static void note_cases (void)                            \
  {                                                                                      \
    test_room_note (add_cases);                                                          \
  }                                                                                      \
  static void add_cases (void)
