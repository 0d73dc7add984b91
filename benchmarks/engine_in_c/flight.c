/* One flight from the first tick to the last: the C twin of housefly/experiments/loop.py and measure.py, mode default. */
#include <string.h>
#include "chain.h"

static inline double off_line(const Route *route, double x, double y)
{
    const double *line = route->line;
    double nearest = SQUARE(x - line[0]) + SQUARE(y - line[1]);
    for (int64_t leg = 0; leg < route->ends - 1; leg++) {
        double ax = line[2 * leg], ay = line[2 * leg + 1], along_x = line[2 * leg + 2] - ax, along_y = line[2 * leg + 3] - ay;
        double share = ((x - ax) * along_x + (y - ay) * along_y) / (along_x * along_x + along_y * along_y);
        share = least(most(share, 0.0), 1.0);
        nearest = least(nearest, SQUARE(x - ax - share * along_x) + SQUARE(y - ay - share * along_y));
    }
    return sqrt(nearest);
}

static inline void near_goal(Score *score, const Route *route, const Body *body, double eps3, double now)
{
    int64_t goal = 2 * (route->ends - 1);
    double dx = body->x - route->line[goal], dy = body->y - route->line[goal + 1];
    score->goal_off = sqrt(dx * dx + dy * dy);
    if (score->goal_off >= eps3)
        score->entered = NAN;
    else if (isnan(score->entered)) {
        score->entered = now, score->looks_then = score->looks;
        score->path_sum_then = score->path_sum, score->path_max_then = score->path_max;
    }
    if (score->looks_then > 0.0)
        score->overshoot = most(score->overshoot, dx * route->last_x + dy * route->last_y);
}

static inline int look(Score *score, const Route *route, const Body *b, const Estimated *here, const Target *target, double eps3,
                       double now)
{
    double off = off_line(route, b->x, b->y);
    if (!(off < LOST) || !(fabs(b->z) < LOST))
        return 0;
    score->looks += 1.0;
    score->path_sum += off * off;
    score->path_max = most(score->path_max, off);
    score->reference_sum += SQUARE(b->x - target->x) + SQUARE(b->y - target->y);
    score->height_error = most(score->height_error, fabs(b->z - route->height));
    score->estimate_sum += SQUARE(here->x - b->x) + SQUARE(here->y - b->y) + SQUARE(here->z - b->z);
    near_goal(score, route, b, eps3, now);
    if (now >= route->duration - LAST - 1e-9) {
        score->last_looks += 1.0, score->goal_sum += score->goal_off, score->x_sum += b->x, score->y_sum += b->y;
        score->x_min = least(score->x_min, b->x), score->x_max = most(score->x_max, b->x);
        score->y_min = least(score->y_min, b->y), score->y_max = most(score->y_max, b->y);
    }
    return 1;
}

static void sum_up(const Score *s, const Route *route, double ended_at, Outcome *out)
{
    int arrived = !isnan(s->entered);
    double looks = arrived ? s->looks_then : s->looks, path_sum = arrived ? s->path_sum_then : s->path_sum;
    double everything = most(s->looks, 1.0), ticks = most(s->ticks, 1.0), last = s->last_looks;
    double x = s->x_sum / last, y = s->y_sum / last;
    double swing = most(most(s->x_max - x, x - s->x_min), most(s->y_max - y, y - s->y_min));
    out->rms_error = sqrt(path_sum / most(looks, 1.0));
    out->max_error = arrived ? s->path_max_then : s->path_max;
    out->reference_rms = sqrt(s->reference_sum / everything);
    out->arrival_time = s->entered - route->settle;
    out->arrival_error = last > 0.0 ? s->goal_sum / last : s->goal_off;
    out->overshoot = s->overshoot;
    out->residual = last > 0.0 ? swing : s->path_max;
    out->switches_per_s = s->switches / most(ended_at - route->settle, 1e-9);
    out->height_error = s->height_error;
    out->estimate_rms = sqrt(s->estimate_sum / everything);
    out->saturated = s->saturated / ticks;
    out->levelled = s->levelled / ticks;
    out->ended_at = ended_at;
    out->stable = ended_at >= route->duration - 1e-9 && s->path_max <= FAR && out->residual < QUIET ? 1.0 : 0.0;
}

static void fly(const Case *k, const Route *route, World *world, Span *spans, int64_t ring, Outcome *outcome)
{
    for (int64_t row = 0; row < ring; row++)
        spans[row].pieces = 0;
    world->random = sown(k->seed);
    world->phase = uniform(&world->random);
    Knowledge know = knowledge_of(k, spans, ring);
    Airframe air = airframe_of(k);
    Belief belief = blank(&know);
    Score score = {.entered = NAN, .x_min = INFINITY, .x_max = -INFINITY, .y_min = INFINITY, .y_max = -INFINITY};
    Stream stream = {.next_at = world->phase / k->mocap_rate_hz};
    Body body = {.x = route->cells[0], .y = route->cells[1], .z = route->height, .psi = route->yaw};
    Course course = {.nose = NAN, .ride = {.yaw = NAN}};
    double before = -INFINITY, ended_at = route->duration, gust[2] = {0.0, 0.0};
    int every = (int)floor(k->rate_hz * PERIOD + 0.5), ticks = (int)floor(route->duration * k->rate_hz + 0.5);
    every = every > 1 ? every : 1;
    for (int tick = 0; tick <= ticks; tick++) {
        double now = tick / k->rate_hz, dt = least(now - before, LONGEST_TICK);
        before = now;
        while (stream.delivered < stream.sent && world->frames[stream.delivered & (FRAMES - 1)].received_at <= now)
            informed(&belief, &know, &world->frames[stream.delivered++ & (FRAMES - 1)], now);
        up_to_date(&belief, &know, now);
        Estimated here = estimated(&belief, &know, now);
        Target target = {route->cells[0], route->cells[1], 0.0, 0.0, 0.0, 0.0, route->yaw, 1};
        Asked asked = {0};
        int state = course.state;
        if (belief.begun) {
            Axis x, y;
            target = track(&course, route, k, &here, now, dt);
            accept(&course, route, k, &here, &target, now, dt);
            looked(&know, &belief.horizon, now + know.delay, &x, &y);
            asked = steer(&course, route, k, &target, &here, x, y);
        }
        double ux, uy, age = now - most(belief.last_capture, 0.0);
        Order *order = &world->orders[tick & (ORDERS - 1)];
        course.safety = judge(&asked, belief.begun, age, k, order);
        acceleration(order->theta, order->phi, here.yaw, &ux, &uy);
        commanded(&know, &belief.horizon, ux, uy, order->flying);
        if (now >= route->settle - NO_TIME) {
            score.ticks += 1.0, score.switches += course.state != state, score.saturated += asked.wish > k->tilt_max;
            score.levelled += course.safety == LEVEL;
            int is_there = tick % every > 0 || look(&score, route, &body, &here, &target, k->epsilon_position, now);
            if (course.safety == LAND || !is_there) {
                ended_at = now;
                break;
            }
        }
        if (k->gust > 0.0) {
            double fresh = k->gust * sqrt(1.0 - air.gust_kept * air.gust_kept);
            gust[0] = air.gust_kept * gust[0] + fresh * normal(&world->random);
            gust[1] = air.gust_kept * gust[1] + fresh * normal(&world->random);
        }
        carry_on(&body, &stream, tick, now, &air, gust, world, k);
    }
    sum_up(&score, route, ended_at, outcome);
}

void fly_rows(const Case *cases, int64_t start, int64_t stop, const Route *route, int64_t ring, Outcome *outcomes)
{
    World world;
    Span spans[ring];
    memset(&world, 0, sizeof world);
    memset(spans, 0, sizeof spans);
    for (int64_t row = start; row < stop; row++)
        fly(&cases[row], route, &world, spans, ring, &outcomes[row]);
}
