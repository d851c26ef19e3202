#include "numbers.h"

#include <stdbool.h>
#include <string.h>

static const char *const extremes[] = {
  "0",           "-0",
  "1",           "-1",
  "0.5",         "1e-9",
  "1e9",         "1e15",
  "1e16",        "1e155",
  "-1e155",      "1e-160",
  "1e308",       "-1.7e308",
  "1e309",       "5e-324",
  "2147483647",  "2147483648",
  "-2147483648", "4294967295",
  "4294967296",  "9007199254740993",
  "1e19",        "1e-300",
  "0.1",         "0.99999999999999989",
  "1e6",         "100000",
  "65536",       "255",
};

typedef struct {
  size_t start, length;
} Token;

static bool
is_digit (uint8_t c)
{
  return c >= '0' && c <= '9';
}

/* The number that begins at or after `at`; length 0 where there is none. A digit within a name, as in
 * "b2", is none. */
static Token
find_number (const uint8_t *data, size_t size, size_t at)
{
  for (size_t i = at; i < size; i++) {
    uint8_t before = i > 0 ? data[i - 1] : ' ';
    if (!is_digit (data[i]) || is_digit (before) || before == '.'
        || ((before | 32) >= 'a' && (before | 32) <= 'z'))
      continue;
    Token token = { i, 0 };
    if (before == '-')
      token.start--;
    size_t end = i;
    while (
      end < size
      && (is_digit (data[end]) || data[end] == '.'
          || ((data[end] | 32) == 'e' && end + 1 < size
              && (is_digit (data[end + 1]) || data[end + 1] == '-'
                  || data[end + 1] == '+'))
          || ((data[end] == '-' || data[end] == '+') && (data[end - 1] | 32) == 'e')))
      end++;
    token.length = end - token.start;
    return token;
  }
  return (Token){ size, 0 };
}

size_t
fuzz_mutate_number (uint8_t *data, size_t size, size_t most, unsigned seed)
{
  char text[40];
  Token old = find_number (data, size, size > 0 ? seed % size : 0);
  if (old.length == 0)
    old = find_number (data, size, 0);
  if (old.length == 0)
    return 0;

  unsigned choice = seed / 31;
  const size_t count = sizeof extremes / sizeof *extremes;
  size_t length = 0;
  if (choice % 4 == 0) {
    Token other = find_number (data, size, choice / 4 % size);
    length = other.length < sizeof text ? other.length : 0;
    memcpy (text, data + other.start, length);
  }
  if (length == 0) {
    const char *extreme = extremes[choice / 4 % count];
    length = strlen (extreme);
    memcpy (text, extreme, length);
  }
  size_t changed = size - old.length + length;
  if (changed > most)
    return 0;
  memmove (data + old.start + length, data + old.start + old.length,
           size - old.start - old.length);
  memcpy (data + old.start, text, length);
  return changed;
}
