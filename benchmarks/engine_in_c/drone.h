/* The drone and the tracking system: the C twin of housefly/control/model.py, experiments/airframe.py and tracking_noise.py. */
#pragma once
#include "filter.h"

typedef struct { double x, y, z, psi, vx, vy, vz, yaw_rate, theta, phi; } Body;
typedef struct { double dt, attitude, climb, turn; } Beat;
typedef struct { int flying; double theta, phi, vz, yaw_rate; } Order;
typedef struct { int64_t exposed, sent, delivered; double next_at, arrived_at; } Stream;
typedef struct { int lag_ticks, early_steps, late_steps; Beat early, late; double gust_kept; } Airframe;
typedef struct { uint64_t random; Order orders[ORDERS]; Frame frames[FRAMES]; double phase; } World;

static inline void acceleration(double theta, double phi, double psi, double *ax, double *ay)
{
    double c = cos(psi), s = sin(psi), lean = tan(theta);
    double forward = GRAVITY * lean, left = -GRAVITY * tan(phi) * sqrt(1.0 + lean * lean);
    *ax = c * forward - s * left, *ay = s * forward + c * left;
}

static inline void tilt(double ax, double ay, double psi, double gain, double *theta, double *phi)
{
    double c = cos(psi), s = sin(psi), forward = (c * ax + s * ay) / GRAVITY, left = (c * ay - s * ax) / GRAVITY;
    *theta = atan(forward) / gain, *phi = -atan(left / sqrt(1.0 + forward * forward)) / gain;
}

static inline void saturated_jointly(double *theta, double *phi, double bound)
{
    double length = sqrt(*theta * *theta + *phi * *phi);
    if (length > bound)
        *theta = *theta * bound / length, *phi = *phi * bound / length;
}

static inline Beat beat_of(const Case *c, double dt)
{
    return (Beat){dt, exp(-c->lag * dt), exp(-c->climb_lag * dt), exp(-c->yaw_lag * dt)};
}

static inline Airframe airframe_of(const Case *c)
{
    double tick = 1.0 / c->rate_hz;
    int lag_ticks = (int)floor(c->delay / tick + NO_TIME);
    double early = most(c->delay - lag_ticks * tick, 0.0);
    early = early < NO_TIME ? 0.0 : early;
    double late = tick - early;
    int early_steps = (int)ceil(early / LONGEST_STEP), late_steps = (int)ceil(late / LONGEST_STEP);
    return (Airframe){lag_ticks, early_steps, late_steps, beat_of(c, early / (early_steps > 1 ? early_steps : 1)),
                      beat_of(c, late / late_steps), exp(-tick / GUST_TIME)};
}

static inline Body moved(const Body *b, const Order *asked, double wind_x, double wind_y, const Case *c, const Beat *beat)
{
    double dt = beat->dt, theta_end = c->gain * asked->theta, phi_end = c->gain * asked->phi, ax, ay;
    double theta = theta_end + (b->theta - theta_end) * beat->attitude, phi = phi_end + (b->phi - phi_end) * beat->attitude;
    double vz = asked->vz + (b->vz - asked->vz) * beat->climb;
    double rate = asked->yaw_rate + (b->yaw_rate - asked->yaw_rate) * beat->turn, turn = 0.5 * dt * (b->yaw_rate + rate);
    acceleration(0.5 * (b->theta + theta), 0.5 * (b->phi + phi), b->psi + 0.5 * turn, &ax, &ay);
    double half = 0.5 * c->drag * dt, keep = (1.0 - half) / (1.0 + half), share = dt / (1.0 + half);
    double vx = b->vx * keep + share * (ax + wind_x), vy = b->vy * keep + share * (ay + wind_y);
    return (Body){b->x + 0.5 * dt * (b->vx + vx), b->y + 0.5 * dt * (b->vy + vy), b->z + 0.5 * dt * (b->vz + vz),
                  wrapped(b->psi + turn), vx, vy, vz, rate, theta, phi};
}

static inline Body pushed(const Body *b, int sent, World *world, double wind_x, double wind_y, const Case *c, const Beat *beat)
{
    const Order *order = &world->orders[sent & (ORDERS - 1)];
    if (sent >= 0 && order->flying)
        return moved(b, order, wind_x, wind_y, c, beat);
    Order own = {0};
    tilt(-HOVER_BRAKE * b->vx - wind_x, -HOVER_BRAKE * b->vy - wind_y, b->psi, 1.0, &own.theta, &own.phi);
    saturated_jointly(&own.theta, &own.phi, c->tilt_max);
    return moved(b, &own, wind_x, wind_y, c, beat);
}

static inline void expose(Stream *stream, World *world, const Case *c, const Body *b, const Body *a, double start, double dt)
{
    while (stream->next_at < start + dt) {
        double at = stream->next_at;
        stream->exposed++;
        stream->next_at = (stream->exposed + world->phase) / c->mocap_rate_hz;
        if ((c->mocap_dropout > 0.0 && uniform(&world->random) < c->mocap_dropout) || stream->sent - stream->delivered >= FRAMES)
            continue;
        double late = c->mocap_jitter > 0.0 ? exponential(&world->random, c->mocap_jitter) : 0.0, noise = c->mocap_noise;
        double part = at - start, share = 0.5 * part * part / dt;
        stream->arrived_at = most(stream->arrived_at, at + c->mocap_latency + late);
        Frame *frame = &world->frames[stream->sent++ & (FRAMES - 1)];
        *frame = (Frame){at, stream->arrived_at, b->x + part * b->vx + share * (a->vx - b->vx),
                         b->y + part * b->vy + share * (a->vy - b->vy), b->z + part * b->vz + share * (a->vz - b->vz),
                         wrapped(b->psi + part * b->yaw_rate + share * (a->yaw_rate - b->yaw_rate))};
        if (noise > 0.0) {
            frame->x += noise * normal(&world->random);
            frame->y += noise * normal(&world->random);
            frame->z += noise * normal(&world->random);
            frame->yaw = wrapped(frame->yaw + YAW_PER_METRE * noise * normal(&world->random));
        }
    }
}

static inline void carry_on(Body *body, Stream *stream, int tick, double now, const Airframe *air, const double *gust,
                            World *world, const Case *c)
{
    double wind_x = c->wind_x + gust[0], wind_y = c->wind_y + gust[1];
    for (int step = 0; step < air->early_steps + air->late_steps; step++) {
        int is_early = step < air->early_steps;
        const Beat *beat = is_early ? &air->early : &air->late;
        Body before = *body;
        *body = pushed(&before, tick - air->lag_ticks - is_early, world, wind_x, wind_y, c, beat);
        expose(stream, world, c, &before, body, now, beat->dt);
        now += beat->dt;
    }
}
