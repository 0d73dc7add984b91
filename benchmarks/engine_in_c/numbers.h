/* Scalars, angles and random numbers: the C twin of housefly/numeric.py and housefly/experiments/random.py. */
#pragma once
#include <math.h>
#include <stdint.h>
#include "generated.h" /* constants, records and tables, written from the Python sources by campaign_engine.py */

#define SQUARE(value) ((value) * (value))

static inline double least(double a, double b) { return b < a ? b : a; }
static inline double most(double a, double b) { return b > a ? b : a; }
static inline double clipped(double value, double bound) { return least(most(value, -bound), bound); }

static inline double wrapped(double angle)
{
    if (-M_PI < angle && angle <= M_PI)
        return angle;
    return angle - 2.0 * M_PI * ceil((angle - M_PI) / (2.0 * M_PI));
}

static inline uint64_t mixed(uint64_t bits)
{
    bits = (bits ^ (bits >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    bits = (bits ^ (bits >> 27)) * UINT64_C(0x94D049BB133111EB);
    return bits ^ (bits >> 31);
}

static inline uint64_t sown(int64_t seed)
{
    return mixed((uint64_t)seed * UINT64_C(0x9E3779B97F4A7C15) + UINT64_C(0xBF58476D1CE4E5B9));
}

static inline uint64_t drawn(uint64_t *state) { return mixed(*state += UINT64_C(0x9E3779B97F4A7C15)); }
static inline double uniform(uint64_t *state) { return ((double)(drawn(state) >> 11) + 0.5) * 0x1p-53; }
static inline double exponential(uint64_t *state, double mean) { return -mean * log(uniform(state)); }

static double tail(uint64_t *state, int negative)
{
    for (;;) {
        double x = -log(uniform(state)) / TAIL, y = -log(uniform(state));
        if (2.0 * y > x * x)
            return negative ? -TAIL - x : TAIL + x;
    }
}

static inline double normal(uint64_t *state)
{
    for (;;) {
        uint64_t bits = drawn(state);
        int layer = (int)(bits & 127);
        double x = (2.0 * (double)(bits >> 11) * 0x1p-53 - 1.0) * EDGES[layer];
        if (fabs(x) < EDGES[layer + 1])
            return x;
        if (layer == 0)
            return tail(state, x < 0.0);
        double low = exp(-0.5 * SQUARE(EDGES[layer])), high = exp(-0.5 * SQUARE(EDGES[layer + 1]));
        if (low + uniform(state) * (high - low) < exp(-0.5 * x * x))
            return x;
    }
}
