/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solves one contact, or with films 16 of them, N times through ehd/ehd.h, for in_process.py, which counts the
 * instructions.
 *
 *   in_process WAY N CASE.toml     WAY: solve (nothing is asked of the result), number (one film), json, fields,
 *                                  moes (M = 20, L = 10 instead of the case; one film), films (ehd_films of M = 5 to
 *                                  500, L = 10 in one thread, and all its arrays)
 */
#include <ehd/ehd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double ask(const char *way, const ehd_result *result) {
  double film = 0, X[4096];
  if (strcmp(way, "json") == 0) return (double)strlen(ehd_json(result));
  if (strcmp(way, "fields") == 0)
    return (double)(ehd_field(result, "X", X, 4096) + ehd_field(result, "P", X, 4096) +
                    ehd_field(result, "H", X, 4096));
  if (strcmp(way, "solve") != 0 && ehd_get(result, "film.minimum.hertz", &film) != EHD_OK) exit(1);
  return film;
}

enum { contacts = 16 };

static int films(void) {
  double M[contacts], L[contacts];
  double minimum[contacts], minimum_error[contacts], central[contacts], central_error[contacts];
  int status[contacts], i;
  for (i = 0; i < contacts; ++i) {
    M[i] = i == 0 ? 5 : M[i - 1] * 1.359356; /* 100^(1/15) */
    L[i] = 10;
  }
  return ehd_films(contacts, M, L, NULL, 1e-3, 1, minimum, minimum_error, central, central_error, status);
}

static int solve(const char *way, const char *text) {
  ehd_result *result = NULL;
  const int code = strcmp(way, "moes") == 0 ? ehd_solve_moes(20, 10, NULL, "fast", 1e-3, &result)
                                            : ehd_solve(text, "fast", 1e-3, &result);
  if (code == EHD_OK) (void)ask(way, result);
  ehd_free(result);
  return code;
}

int main(int count, char **arguments) {
  static char text[1 << 16];
  FILE *file = count == 4 ? fopen(arguments[3], "r") : NULL;
  int call;
  if (!file) return fprintf(stderr, "usage: in_process WAY N CASE.toml\n"), 2;
  text[fread(text, 1, sizeof text - 1, file)] = '\0';
  fclose(file);
  for (call = 0; call < atoi(arguments[2]); ++call) {
    const int code = strcmp(arguments[1], "films") == 0 ? films() : solve(arguments[1], text);
    if (code != EHD_OK) return fprintf(stderr, "%s\n", ehd_last_error()), 1;
  }
  return 0;
}
