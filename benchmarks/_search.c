/* A* over a padded grid with open cells in buckets: the algorithm of planning/space/astar.py, for
   search_in_c.py. Build: cc -O3 -march=native -ffp-contract=off -shared -fPIC. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#define BUCKET 0.5
#define SAME 1e-10

typedef struct {
    double length;
    int32_t mark, after, before, move;
} Cell;

typedef struct {
    const int64_t *steps, *offsets, *needs;
    const double *lengths;
    int count;
} Moves;

static double octile(int64_t dx, int64_t dy, int64_t dz) {
    int64_t most = dx > dy ? dx : dy, least = dx < dy ? dx : dy;
    most = most > dz ? most : dz;
    least = least < dz ? least : dz;
    int64_t middle = dx + dy + dz - most - least;
    return sqrt(3.0) * (double)least + sqrt(2.0) * (double)(middle - least) +
           (double)(most - middle);
}

/* Unlink an open cell from the list of its bucket. */
static void unlink_cell(Cell *marks, int32_t *heads, const Cell *cell) {
    if (cell->after >= 0)
        marks[cell->after].before = cell->before;
    if (cell->before >= 0)
        marks[cell->before].after = cell->after;
    else
        heads[-2 - cell->before] = cell->after;
}

/* Put a cell at the head of a bucket's list. */
static void push_cell(Cell *marks, int32_t *heads, int32_t number, int32_t slot) {
    int32_t first = heads[slot];
    marks[number].after = first;
    marks[number].before = -2 - slot;
    if (first >= 0)
        marks[first].before = number;
    heads[slot] = number;
}

double shortest_length(const uint8_t *free_cells, const double *weights, int32_t start,
                       int32_t goal, const int64_t *shape, const Moves *moves, int32_t stamp,
                       int32_t *heads, int32_t buckets, Cell *marks) {
    int64_t row = shape[2], plane = shape[1] * shape[2], mask = buckets - 1;
    int64_t gi = goal / plane, gj = goal % plane / row, gk = goal % row;
    for (int32_t b = 0; b < buckets; b++)
        heads[b] = -1;
    int64_t i = start / plane, j = start % plane / row, k = start % row;
    int64_t bucket = (int64_t)(octile(llabs(i - gi), llabs(j - gj), llabs(k - gk)) / BUCKET);
    marks[start] = (Cell){.mark = stamp, .move = -1};
    push_cell(marks, heads, start, (int32_t)(bucket & mask));
    int64_t waiting = 1;
    double best = INFINITY;
    while (waiting > 0 && (double)bucket * BUCKET < best) {
        int32_t number = heads[bucket & mask];
        if (number < 0) {
            bucket++;
            continue;
        }
        Cell *cell = &marks[number];
        unlink_cell(marks, heads, cell);
        cell->mark = stamp + 1;
        waiting--;
        i = number / plane, j = number % plane / row, k = number % row;
        double here = cell->length;
        if (here + octile(llabs(i - gi), llabs(j - gj), llabs(k - gk)) >= best - SAME)
            continue;
        int64_t around = 0;
        for (int m = 0; m < moves->count; m++)
            around |= (int64_t)(free_cells[number + moves->offsets[m]] != 0) << m;
        for (int m = 0; m < moves->count; m++) {
            if ((around & moves->needs[m]) != moves->needs[m])
                continue;
            int32_t to = number + (int32_t)moves->offsets[m];
            double step = moves->lengths[m];
            if (weights)
                step *= 1.0 + 0.5 * (weights[number] + weights[to]);
            double length = here + step;
            Cell *there = &marks[to];
            if (there->mark >= stamp && length >= there->length - SAME)
                continue;
            if (there->mark == stamp) {
                unlink_cell(marks, heads, there);
                waiting--;
            }
            there->length = length;
            there->move = m;
            there->mark = stamp;
            const int64_t *by = moves->steps + 3 * m;
            double ahead = octile(llabs(i + by[0] - gi), llabs(j + by[1] - gj),
                                  llabs(k + by[2] - gk));
            if (to == goal)
                best = length;
            int64_t slot = (int64_t)((length + ahead) / BUCKET);
            push_cell(marks, heads, to, (int32_t)((slot > bucket ? slot : bucket) & mask));
            waiting++;
        }
    }
    return best;
}
