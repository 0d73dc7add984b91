/* Reference, acceptor, control and gate of mode default: the C twin of housefly/experiments/chain.py and what it calls. */
#pragma once
#include "drone.h"

typedef struct {
    const double *points, *marks, *speeds, *along, *headings, *cells, *line;
    int64_t corners, waypoints, ends;
    double last_x, last_y, height, yaw, arrival_yaw, settle, duration;
} Route;
typedef struct { double s, v, a; int leg; double yaw; } Ride;
typedef struct { double x, y, vx, vy, ax, ay, yaw; int finished; } Target;
typedef struct { double theta, phi, vz, yaw_rate, wish; } Asked;
typedef struct {
    int begun, found, state, safety;
    double hold_x, hold_y, hold_yaw, nose_target, nose, since;
    Ride ride;
} Course;
enum { HOVER, ALTITUDE_CONTROL, YAW_CONTROL, PATH_TRACKING };
enum { NOMINAL, LEVEL, LAND };

static inline int leg_from(const Route *way, int leg, double s)
{
    while (leg < way->corners - 2 && way->marks[leg + 1] <= s)
        leg++;
    return leg;
}

static inline void place_on(const Route *way, int leg, double s, double *x, double *y)
{
    *x = way->points[2 * leg], *y = way->points[2 * leg + 1];
    if (way->corners == 1)
        return;
    double done = least(most(s - way->marks[leg], 0.0), way->marks[leg + 1] - way->marks[leg]);
    *x += done * way->along[2 * leg], *y += done * way->along[2 * leg + 1];
}

static inline double speed_allowed(const Route *way, const Ride *ride, double wanted)
{
    double squared = wanted * wanted;
    for (int64_t mark = ride->leg + 1; mark < way->corners; mark++) {
        double braking = 2.0 * ACCELERATION * (way->marks[mark] - ride->s);
        if (braking >= squared)
            break;
        squared = least(squared, SQUARE(way->speeds[mark]) + braking);
    }
    return sqrt(squared);
}

static inline void ride_on(Ride *ride, const Route *way, double speed, const Estimated *here, int moving, double dt)
{
    double end = way->marks[way->corners - 1], x, y;
    if (dt <= 0.0 || ride->s >= end)
        return;
    place_on(way, ride->leg, ride->s, &x, &y);
    int lagging = sqrt(SQUARE(here->x - x) + SQUARE(here->y - y)) > PATIENCE;
    double target = speed_allowed(way, ride, moving && !lagging ? speed : 0.0);
    double v = most(0.0, least(ride->v + ACCELERATION * dt, most(ride->v - 1.5 * ACCELERATION * dt, target)));
    double s = ride->s + 0.5 * (ride->v + v) * dt;
    if (s >= end - 1e-4)
        s = end, v = 0.0;
    *ride = (Ride){s, v, (v - ride->v) / dt, leg_from(way, ride->leg, s), ride->yaw};
}

static inline void head(Ride *ride, const Route *way)
{
    double s = ride->s + LOOK_AHEAD, here_x, here_y, x, y;
    int leg = leg_from(way, ride->leg, s);
    if (leg == ride->leg && ride->s + KEEP_HEADING < way->marks[way->corners - 1]) {
        ride->yaw = way->headings[leg];
        return;
    }
    place_on(way, ride->leg, ride->s, &here_x, &here_y);
    place_on(way, leg, s, &x, &y);
    double dx = x - here_x, dy = y - here_y;
    if (dx * dx + dy * dy > KEEP_HEADING * KEEP_HEADING)
        ride->yaw = atan2(dy, dx);
}

static inline Target target_of(const Ride *ride, const Route *way)
{
    double x, y, along_x = 0.0, along_y = 0.0;
    place_on(way, ride->leg, ride->s, &x, &y);
    int finished = ride->s >= way->marks[way->corners - 1];
    if (way->corners > 1)
        along_x = way->along[2 * ride->leg], along_y = way->along[2 * ride->leg + 1];
    double a = finished ? 0.0 : ride->a;
    return (Target){x, y, along_x * ride->v, along_y * ride->v, along_x * a, along_y * a, ride->yaw, finished};
}

static inline Target track(Course *c, const Route *route, const Case *k, const Estimated *here, double now, double dt)
{
    if (!c->found)
        c->found = 1, c->hold_x = here->x, c->hold_y = here->y, c->hold_yaw = here->yaw;
    if (!c->begun && now >= route->settle - NO_TIME)
        c->begun = 1;
    if (!c->begun)
        return (Target){c->hold_x, c->hold_y, 0.0, 0.0, 0.0, 0.0, c->hold_yaw, 1};
    int moving = (c->state == PATH_TRACKING || c->state == HOVER) && c->safety == NOMINAL;
    ride_on(&c->ride, route, k->speed, here, moving, dt);
    head(&c->ride, route);
    return target_of(&c->ride, route);
}

static inline void turn_nose(Course *c, double wish, double yaw, double turn_max)
{
    int is_first = isnan(c->nose);
    double target = isnan(wish) ? (is_first ? yaw : c->nose_target) : wish, last = is_first ? yaw : c->nose;
    c->nose_target = target, c->nose = wrapped(last + clipped(wrapped(target - last), turn_max));
}

static inline void accept(Course *c, const Route *route, const Case *k, const Estimated *here, const Target *target, double now,
                          double dt)
{
    int64_t goal = 2 * (route->waypoints - 1);
    double wish = c->begun && target->finished && isfinite(route->arrival_yaw) ? route->arrival_yaw : target->yaw;
    turn_nose(c, wish, here->yaw, YAW_SLEW * dt);
    double x = c->begun ? route->cells[goal] : target->x, y = c->begun ? route->cells[goal + 1] : target->y;
    double off = sqrt(SQUARE(here->x - x) + SQUARE(here->y - y)), turn = here->yaw - c->nose_target;
    turn = k->wrap_yaw > 0.5 ? wrapped(turn) : turn;
    int state = HOVER;
    if (fabs(here->z - route->height) > (c->state == ALTITUDE_CONTROL ? 0.5 : 1.0) * k->epsilon_height)
        state = ALTITUDE_CONTROL;
    else if (fabs(turn) > (c->state == YAW_CONTROL ? 0.5 : 1.0) * k->epsilon_yaw)
        state = YAW_CONTROL;
    else if (off > (c->state == PATH_TRACKING ? 0.5 : 1.0) * k->epsilon_position)
        state = PATH_TRACKING;
    if (state != c->state && !(now - c->since < k->dwell))
        c->state = state, c->since = now;
}

static inline Asked steer(const Course *c, const Route *route, const Case *k, const Target *target, const Estimated *here, Axis x,
                          Axis y)
{
    Asked asked;
    double drag = k->model_drag, delay = k->model_delay;
    double ax = k->beta * (target->x + delay * target->vx - x.x) + k->alpha * (target->vx - x.v) +
                (target->ax + drag * target->vx - x.d);
    double ay = k->beta * (target->y + delay * target->vy - y.x) + k->alpha * (target->vy - y.v) +
                (target->ay + drag * target->vy - y.d);
    tilt(ax, ay, here->yaw, k->model_gain, &asked.theta, &asked.phi);
    asked.wish = sqrt(asked.theta * asked.theta + asked.phi * asked.phi);
    saturated_jointly(&asked.theta, &asked.phi, k->tilt_max);
    double turn = c->nose - here->yaw;
    asked.vz = clipped(k->height_gain * (route->height - here->z), k->vertical_speed_max);
    asked.yaw_rate = clipped(k->yaw_gain * (k->wrap_yaw > 0.5 ? wrapped(turn) : turn), k->yaw_rate_max);
    return asked;
}

static inline int judge(const Asked *asked, int flying, double age, const Case *k, Order *order)
{
    int found = !(age <= k->pose_age_land) ? LAND : !(age <= k->pose_age_level) ? LEVEL : NOMINAL;
    int is_number = isfinite(asked->theta) && isfinite(asked->phi) && isfinite(asked->vz) && isfinite(asked->yaw_rate);
    found = found == NOMINAL && !is_number ? LEVEL : found;
    *order = (Order){0};
    if (flying && found == NOMINAL)
        *order = (Order){1, clipped(asked->theta, k->tilt_max), clipped(asked->phi, k->tilt_max),
                         clipped(asked->vz, k->vertical_speed_max), clipped(asked->yaw_rate, k->yaw_rate_max)};
    return found;
}
