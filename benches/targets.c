// Points of curves by emitted C beside hand-written C of the same form, in ns each; see targets.sh.
#define _POSIX_C_SOURCE 199309L
#include "quartic.h"
#include "conic.h"
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { COUNT = 1024, ROUNDS = 4000, REPEATS = 15, DIMENSION = 3 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

// As somebody writes them who knows the dimension.
static void quartic_by_hand(const double (*restrict b)[3], const double *restrict at, double (*restrict points)[3])
{
    for (int row = 0; row < COUNT; row++) {
        const double t = at[row], s = 1.0 - t, y = t - s, st = s * t;
        for (int k = 0; k < 3; k++) {
            points[row][k] = b[0][k] * s + b[1][k] * t + (b[2][k] + (b[3][k] + b[4][k] * y) * y) * st;
        }
    }
}

static void conic_by_hand(
    double omega, const double (*restrict b)[3], const double *restrict at, double (*restrict points)[3])
{
    for (int row = 0; row < COUNT; row++) {
        const double t = at[row], s = 1.0 - t, x1 = t * 2.0, x2 = t * t;
        const double w = (-s - omega * x1) * s - x2;
        for (int k = 0; k < 3; k++) {
            points[row][k] = ((b[0][k] * s + b[1][k] * x1) * s + b[2][k] * x2) / w;
        }
    }
}

static double at[COUNT], points[COUNT * DIMENSION];

// The shortest of some repeats.
#define MEASURE(time, work)                                                                                            \
    do {                                                                                                               \
        time = 1e30;                                                                                                   \
        for (int repeat = 0; repeat < REPEATS; repeat++) {                                                             \
            const double start = now();                                                                                \
            for (int round = 0; round < ROUNDS; round++) {                                                             \
                work;                                                                                                  \
                __asm__ volatile("" : : "r"(points) : "memory");                                                       \
            }                                                                                                          \
            const double each = (now() - start) / ROUNDS / COUNT;                                                      \
            if (each < time) time = each;                                                                              \
        }                                                                                                              \
    } while (0)

int main(void)
{
    for (int k = 0; k < COUNT; k++) at[k] = (double)k / (COUNT - 1);
    double given[15], bound[15], ours, hand;
    for (int k = 0; k < 15; k++) given[k] = (double)(k * 7 % 11);
    QuarticBernstein quartic;
    if (QuarticBernstein_init(&quartic, 0.5) != 0) return 1;
    QuarticBernstein_bind(quartic, DIMENSION, given, bound);
    MEASURE(ours, QuarticBernstein_eval_n(DIMENSION, bound, COUNT, at, points));
    MEASURE(hand, quartic_by_hand((const double (*)[3])bound, at, (double (*)[3])points));
    printf("| C, a point of a quartic curve | %.2f ns | %.2f ns | %.2f |\n", ours, hand, ours / hand);
    Conic conic;
    if (Conic_init(&conic, 0.5) != 0) return 1;
    Conic_bind(conic, DIMENSION, given, bound);
    MEASURE(ours, Conic_eval_n(conic, DIMENSION, bound, COUNT, at, points));
    MEASURE(hand, conic_by_hand(0.5, (const double (*)[3])bound, at, (double (*)[3])points));
    printf("| C, a point of a conic | %.2f ns | %.2f ns | %.2f |\n", ours, hand, ours / hand);
    return 0;
}
