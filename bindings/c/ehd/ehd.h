/* SPDX-License-Identifier: GPL-3.0-or-later */
/* libehd: elastohydrodynamic line contacts and the roller bearings that run on them, from C (C99) and from whatever can
 * call C.
 *
 *   Case text     The text of a case file (TOML): what `ehd solve FILE` reads. docs/library.md has examples.
 *   Return value  EHD_OK: converged. EHD_NOT_MET: it did not converge; the result is there and says how it ended.
 *                 EHD_BAD_INPUT: there is no result, and ehd_last_error() says in one line what is wrong and what is
 *                 allowed. These are the exit codes of the program `ehd`. A null pointer is bad input where nothing
 *                 else is said. If memory ends, EHD_NOT_MET comes without a result.
 *   Ownership     A result belongs to the caller, who frees it with ehd_free(). Strings and numbers that a function
 *                 takes are copied. Strings that it returns belong to the library.
 *   Threads       Every function may be called from several threads at once. A result may be read by several threads
 *                 at once. Progress callback and last error belong to the thread that calls. Each thread that solves
 *                 keeps up to 13 MB for its next solves.
 *   The process   No function prints, ends the process, or lets a C++ exception out. FFTW's planner is made
 *                 thread-safe for the whole process when the library is loaded: load it before another thread plans.
 *   Units         SI where a name ends with a unit. Hertz units: X = x/b, P = p/p_H, H = h R/b^2, with the half width b
 *                 and the pressure p_H of the dry contact, and the reduced radius R.
 */
#ifndef EHD_EHD_H
#define EHD_EHD_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define EHD_API __attribute__((visibility("default")))
#else
#define EHD_API
#endif

/* Return values. */
enum { EHD_OK = 0, EHD_NOT_MET = 1, EHD_BAD_INPUT = 2 };

/* How one of several contacts ended (ehd_films); the words are those of "status" in the JSON. */
enum {
  EHD_CONVERGED = 0,
  EHD_TOLERANCE_NOT_MET = 1, /* the best solution; its stated errors are honest, and larger than the tolerance */
  EHD_UNDER_RESOLVED = 2,
  EHD_LIMIT_REACHED = 3, /* iterations, time, or the callback cancelled */
  EHD_DIVERGED = 4
};

/* The result of one contact or one bearing; never changes once it is made. */
typedef struct ehd_result ehd_result;

/* "0.2.0 (1a2b3c4d, FFTW 3.3.10, Eigen 3.4.0)" */
EHD_API const char *ehd_version(void);

/* Why the last call of this thread that did not return EHD_OK ended so: one line, as the program prints it. Where the
 * program prints several, the first, and how many more there are. Empty where every call returned EHD_OK. The pointer
 * stays valid while the thread lives. */
EHD_API const char *ehd_last_error(void);

/* Solves one contact.
 *   case_toml  the text of a contact case; messages call it by its id, "ID.toml:LINE: ..."
 *   solver     "fast", or another name that `ehd solve --help` lists
 *   tolerance  relative error allowed in the minimum and central film, above 0, at most 1
 *   result     becomes the result; NULL where there is none */
EHD_API int ehd_solve(const char *case_toml, const char *solver, double tolerance, ehd_result **result);

/* The same for a fully flooded contact that Moes' groups state: M 1e-3 to 1e6, L 0 to 100.
 *   lubricant_toml  the body of the table [lubricant]; in messages it is called "lubricant", and its line 1 is the
 *                   heading [lubricant] itself. NULL: viscosity = "barus", density = "incompressible". */
EHD_API int ehd_solve_moes(double M, double L, const char *lubricant_toml, const char *solver, double tolerance,
                           ehd_result **result);

/* Balances one bearing with one contact force law.
 *   case_toml  the text of a bearing case
 *   law        "hertz", "iso", "ehd-linear", "ehd", or another name that `ehd bearing --help` lists
 * The JSON is that of `ehd bearing` without "error_budget", which needs further balances. */
EHD_API int ehd_bearing(const char *case_toml, const char *law, ehd_result **result);

/* *value becomes a number of the result, by its path in the JSON: "film.minimum.hertz", "rollers.0.inner.force_N". True
 * is 1, false 0. EHD_BAD_INPUT where there is no such number (what is unknown is absent); *value is then left alone. */
EHD_API int ehd_get(const ehd_result *result, const char *path, double *value);

/* A field of a contact over its nodes, from inlet to exit; the columns of `ehd solve --profile`: "X", "P", "H" in Hertz
 * units; "rho" = rho/rho_0 and "eta" = eta/eta_0 where there is a lubricant; "x_m", "p_Pa", "h_m" where SI is known;
 * "H_error", "P_unresolved", "P_error" where the profile has them. NaN where the profile is empty.
 *   buffer  gets the first numbers, at most length of them; may be NULL with length 0
 * Returns how many numbers there are; 0 where there is no such field. */
EHD_API size_t ehd_field(const ehd_result *result, const char *name, double *buffer, size_t length);

/* The JSON that the program writes for this result; that of a bearing without "error_budget". Lives as long as the
 * result. NULL for NULL, and without memory. */
EHD_API const char *ehd_json(const ehd_result *result);

/* NULL is allowed. */
EHD_API void ehd_free(ehd_result *result);

/* The films of n >= 1 fully flooded contacts with one lubricant, solved by the default solver, one solve a thread.
 *   M, L            n groups each
 *   lubricant_toml  as for ehd_solve_moes
 *   threads         0: one a core
 *   minimum, central              n films H in Hertz units; NaN where there is none
 *   minimum_error, central_error  their estimated relative errors; NaN where there is none
 *   status                        n words: EHD_CONVERGED ...
 * The numbers do not depend on `threads`. Returns EHD_NOT_MET where not all converged; EHD_BAD_INPUT before anything is
 * solved, and then no array is changed. */
EHD_API int ehd_films(size_t n, const double *M, const double *L, const char *lubricant_toml, double tolerance,
                      int threads, double *minimum, double *minimum_error, double *central, double *central_error,
                      int *status);

/* The contact force law that a bearing was balanced with, at n >= 1 approaches.
 *   bearing   from ehd_bearing
 *   raceway   "inner" or "outer"
 *   approach_m           n approaches [m]
 *   force_N              n forces [N]; 0 where the contact is unloaded
 *   stiffness_N_per_m    n slopes df/d(approach) [N/m]
 * EHD_NOT_MET where some forces lie above the range that the law is meant for (they are given, continued beyond it),
 * and where there is no law because the bearing has no balance (nothing is changed). */
EHD_API int ehd_law(const ehd_result *bearing, const char *raceway, size_t n, const double *approach_m, double *force_N,
                    double *stiffness_N_per_m);

/* From now on, ehd_solve, ehd_solve_moes, ehd_bearing and ehd_films of THIS thread call callback(done, user): at their
 * begin, then at most 50 times a second, always in this thread. A return value other than 0 cancels the call, which
 * ends within one iteration of each solve that is running, as EHD_NOT_MET with the status limit-reached.
 *   done  share of the contacts that ehd_films has solved; 0 in the other functions, which cannot know
 * NULL: no callback, as at the beginning. The callback must not leave by longjmp and must not start another solve. */
EHD_API void ehd_set_progress(int (*callback)(double done, void *user), void *user);

#ifdef __cplusplus
}
#endif

#endif
