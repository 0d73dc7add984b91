/* What the pilot knows: the C twin of housefly/estimation (mode default) and housefly/experiments/belief.py. */
#pragma once
#include "numbers.h"

typedef struct { double x, v, a, d; } Axis;
typedef struct { double xx, xv, xa, xd, vv, va, vd, aa, ad, dd; } Spread;
typedef struct { double lag, gain, drag, hover_drag, noise, wander; } AxisModel;
typedef struct { double xv, xa, xd, vv, va, vd, aa, xu, vu, au, noise_aa, noise_dd; } Transition;
typedef struct { double sent, seconds; int pieces, flown; double ux, uy; Transition step; Axis x, y; } Span;
typedef struct { double at; int64_t span, newest; Spread spread; } Horizon;
typedef struct { int64_t span; Axis x, y; Spread spread; } Reached;
typedef struct { double x, v, xx, xv, vv; } Drift;
typedef struct { Drift z, yaw; double at, z_doubt, yaw_doubt; } Upright;
typedef struct { AxisModel model; double delay, position_noise; Spread first; Span *spans; int64_t ring; } Knowledge;
typedef struct { int begun, refusing; double last_capture, doubt; Upright upright; Horizon horizon; } Belief;
typedef struct { double captured_at, received_at, x, y, z, yaw; } Frame;
typedef struct { double x, y, z, vx, vy, vz, yaw; } Estimated;

static inline Transition transition(const AxisModel *model, int flown, double dt)
{
    double drag = flown ? model->drag : model->hover_drag, heeded = flown ? 1.0 : 0.0, half = 0.5 * dt;
    double decay = exp(-model->lag * dt), reach = dt * (1.0 - half * drag);
    double vv = 1.0 - drag * reach, va = 0.5 * (1.0 + decay) * reach, vd = heeded * reach;
    double au = heeded * model->gain * (1.0 - decay), vu = half * (1.0 - half * drag) * au;
    double variance = model->noise * model->noise * (flown ? 1.0 : HOVER_DOUBT);
    return (Transition){half * (1.0 + vv), half * va, half * vd, vv, va, vd, decay, half * vu, vu, au,
                        variance * (1.0 - decay * decay), heeded * model->wander * model->wander * dt};
}

static inline Axis predicted(Axis axis, double u, const Transition *step)
{
    return (Axis){axis.x + step->xv * axis.v + step->xa * axis.a + step->xd * axis.d + step->xu * u,
                  step->vv * axis.v + step->va * axis.a + step->vd * axis.d + step->vu * u, step->aa * axis.a + step->au * u,
                  axis.d};
}

static inline Spread spread_out(Spread p, const Transition *f)
{
    double fxx = p.xx + f->xv * p.xv + f->xa * p.xa + f->xd * p.xd, fxv = p.xv + f->xv * p.vv + f->xa * p.va + f->xd * p.vd;
    double fxa = p.xa + f->xv * p.va + f->xa * p.aa + f->xd * p.ad, fxd = p.xd + f->xv * p.vd + f->xa * p.ad + f->xd * p.dd;
    double fvv = f->vv * p.vv + f->va * p.va + f->vd * p.vd, fva = f->vv * p.va + f->va * p.aa + f->vd * p.ad;
    double fvd = f->vv * p.vd + f->va * p.ad + f->vd * p.dd;
    return (Spread){fxx + f->xv * fxv + f->xa * fxa + f->xd * fxd, f->vv * fxv + f->va * fxa + f->vd * fxd, f->aa * fxa, fxd,
                    f->vv * fvv + f->va * fva + f->vd * fvd, f->aa * fva, fvd, f->aa * f->aa * p.aa + f->noise_aa,
                    f->aa * p.ad, p.dd + f->noise_dd};
}

static inline Axis corrected(Axis axis, Spread p, double seen, double r)
{
    double innovation = (seen - axis.x) / (p.xx + r);
    return (Axis){axis.x + p.xx * innovation, axis.v + p.xv * innovation, axis.a + p.xa * innovation,
                  clipped(axis.d + p.xd * innovation, DISTURBANCE_MAX)};
}

static inline Spread narrowed(Spread p, double r)
{
    double shrink = 1.0 / (p.xx + r), kx = p.xx * shrink, kv = p.xv * shrink, ka = p.xa * shrink, kd = p.xd * shrink;
    return (Spread){r * kx, r * kv, r * ka, r * kd, p.vv - kv * p.xv, p.va - kv * p.xa, p.vd - kv * p.xd, p.aa - ka * p.xa,
                    p.ad - ka * p.xd, p.dd - kd * p.xd};
}

static inline Span *span_of(const Knowledge *know, int64_t number) { return &know->spans[number & (know->ring - 1)]; }
static inline int pieces_of(double seconds) { return (int)ceil(seconds / LONGEST_PREDICTION - NO_TIME); }

static inline void pass_on(const Span *row, Span *following)
{
    Axis x = row->x, y = row->y;
    for (int piece = 0; piece < row->pieces; piece++)
        x = predicted(x, row->ux, &row->step), y = predicted(y, row->uy, &row->step);
    following->x = x, following->y = y;
}

static inline void end_span(const Knowledge *know, Span *row, const Span *like, double now)
{
    double seconds = now - row->sent;
    if (fabs(seconds - like->seconds) <= ALIKE && like->flown == row->flown && like->pieces > 0) {
        row->pieces = like->pieces;
        row->step = like->step;
    } else {
        int pieces = pieces_of(seconds);
        row->pieces = pieces > 1 ? pieces : 1;
        row->step = transition(&know->model, row->flown, seconds / row->pieces);
    }
    row->seconds = seconds;
}

static inline int64_t span_at(const Knowledge *know, const Horizon *h, double at)
{
    int64_t span = h->newest;
    while (span > h->span && span_of(know, span)->sent + know->delay > at + NO_TIME)
        span--;
    return span;
}

static inline Horizon cut(const Knowledge *know, const Horizon *h, double at, const Reached *there)
{
    Span *row = span_of(know, there->span);
    row->sent = at - know->delay;
    row->x = there->x, row->y = there->y;
    if (there->span < h->newest)
        end_span(know, row, row, span_of(know, there->span + 1)->sent);
    return (Horizon){at, there->span, h->newest, there->spread};
}

static inline void lay(const Knowledge *know, const Horizon *h)
{
    for (int64_t span = h->span; span < h->newest; span++)
        pass_on(span_of(know, span), span_of(know, span + 1));
}

static inline void looked(const Knowledge *know, const Horizon *h, double at, Axis *x_out, Axis *y_out)
{
    const Span *row = span_of(know, span_at(know, h, at));
    Axis x = row->x, y = row->y;
    double seconds = at - row->sent - know->delay;
    if (seconds > NO_TIME) {
        int pieces = pieces_of(seconds);
        Transition step = transition(&know->model, row->flown, seconds / pieces);
        for (int piece = 0; piece < pieces; piece++)
            x = predicted(x, row->ux, &step), y = predicted(y, row->uy, &step);
    }
    *x_out = x, *y_out = y;
}

static inline Reached reached(const Knowledge *know, const Horizon *h, double at)
{
    Spread p = h->spread;
    int64_t span = h->span;
    while (span < h->newest && span_of(know, span + 1)->sent + know->delay <= at + NO_TIME) {
        const Span *row = span_of(know, span++);
        for (int piece = 0; piece < row->pieces; piece++)
            p = spread_out(p, &row->step);
    }
    const Span *row = span_of(know, span);
    Axis x = row->x, y = row->y;
    double seconds = at - row->sent - know->delay;
    if (seconds > NO_TIME) {
        int pieces = pieces_of(seconds);
        Transition step = transition(&know->model, row->flown, seconds / pieces);
        for (int piece = 0; piece < pieces; piece++)
            x = predicted(x, row->ux, &step), y = predicted(y, row->uy, &step), p = spread_out(p, &step);
    }
    return (Reached){span, x, y, p};
}

static inline Horizon settled(const Knowledge *know, Horizon h, double at)
{
    if (at <= h.at)
        return h;
    Reached there = reached(know, &h, at);
    return cut(know, &h, at, &there);
}

static inline Horizon advanced(const Knowledge *know, Horizon h, double now)
{
    Span *row = span_of(know, h.newest), *following = span_of(know, h.newest + 1);
    if (now - row->sent <= NO_TIME)
        return h;
    if (h.newest - h.span >= know->ring - 2)
        h = settled(know, h, span_of(know, h.span + 1)->sent + know->delay);
    end_span(know, row, span_of(know, h.newest - 1), now);
    following->sent = now, following->flown = row->flown, following->ux = row->ux, following->uy = row->uy;
    pass_on(row, following);
    h.newest++;
    return h;
}

static inline void commanded(const Knowledge *know, const Horizon *h, double ux, double uy, int flown)
{
    Span *row = span_of(know, h->newest);
    row->flown = flown, row->ux = flown ? ux : 0.0, row->uy = flown ? uy : 0.0;
}

static inline Drift drifted(Drift s, double noise, double dt)
{
    double q = noise * noise;
    return (Drift){s.x + dt * s.v, s.v, s.xx + 2.0 * dt * s.xv + dt * dt * s.vv + q * dt * dt * dt / 3.0,
                   s.xv + dt * s.vv + 0.5 * q * dt * dt, s.vv + q * dt};
}

static inline Drift drift_seen(Drift s, double innovation, double r)
{
    double total = s.xx + r, kx = s.xx / total, kv = s.xv / total;
    return (Drift){s.x + kx * innovation, s.v + kv * innovation, r * kx, r * kv, s.vv - kv * s.xv};
}

static inline int plausible(double squared, double variance, double floor_of)
{
    return squared <= most(GATE_SIGMAS * GATE_SIGMAS * variance, floor_of * floor_of);
}

static inline Upright stood(const Knowledge *know, const Frame *frame)
{
    double z = SQUARE(know->position_noise), yaw = SQUARE(YAW_PER_METRE * know->position_noise);
    return (Upright){{frame->z, 0.0, z, 0.0, FIRST_RATE_VARIANCE}, {frame->yaw, 0.0, yaw, 0.0, FIRST_RATE_VARIANCE},
                     frame->captured_at, z, yaw};
}

static inline int upright_seen(const Upright *u, const Frame *frame, int refusing, double noise, Upright *without, Upright *taken)
{
    double z_variance = SQUARE(noise), yaw_variance = SQUARE(YAW_PER_METRE * noise), dt = frame->captured_at - u->at;
    Drift z = drifted(u->z, CLIMB_NOISE, dt), yaw = drifted(u->yaw, TURN_NOISE, dt);
    double z_doubt = refusing ? u->z_doubt : z.xx + z_variance, yaw_doubt = refusing ? u->yaw_doubt : yaw.xx + yaw_variance;
    double rise = frame->z - z.x, turn = wrapped(frame->yaw - yaw.x);
    *without = (Upright){u->z, u->yaw, u->at, z_doubt, yaw_doubt};
    *taken = (Upright){drift_seen(z, rise, z_variance), drift_seen(yaw, turn, yaw_variance), frame->captured_at, z_doubt,
                       yaw_doubt};
    return plausible(rise * rise, z_doubt, GATE_FLOOR) && plausible(turn * turn, yaw_doubt, GATE_FLOOR_YAW);
}

static inline Belief blank(const Knowledge *know)
{
    Span *row = know->spans;
    Axis nowhere = {0.0, 0.0, 0.0, 0.0};
    row->sent = 0.0, row->flown = 0, row->ux = row->uy = 0.0, row->x = row->y = nowhere;
    return (Belief){.last_capture = -INFINITY, .doubt = SQUARE(know->position_noise), .horizon = {0.0, 0, 0, know->first}};
}

static inline void informed(Belief *b, const Knowledge *know, const Frame *frame, double now)
{
    double at = frame->captured_at, variance = SQUARE(know->position_noise);
    if (at > now + FUTURE_TOLERANCE || at <= b->last_capture || now - at > OLDEST)
        return;
    if (!b->begun) {
        Reached there = {span_at(know, &b->horizon, at), {frame->x, 0.0, 0.0, 0.0}, {frame->y, 0.0, 0.0, 0.0}, know->first};
        b->upright = stood(know, frame);
        b->horizon = cut(know, &b->horizon, at, &there);
        lay(know, &b->horizon);
        b->begun = 1, b->refusing = 0, b->last_capture = at;
        return;
    }
    Upright without, taken;
    int upright_ok = upright_seen(&b->upright, frame, b->refusing, know->position_noise, &without, &taken);
    Reached there = reached(know, &b->horizon, at);
    if (!b->refusing)
        b->doubt = there.spread.xx + variance;
    double squared = SQUARE(frame->x - there.x.x) + SQUARE(frame->y - there.y.x);
    b->refusing = !(plausible(squared, b->doubt, GATE_FLOOR) && upright_ok);
    b->upright = b->refusing ? without : taken;
    if (b->refusing)
        return;
    b->last_capture = at;
    there.x = corrected(there.x, there.spread, frame->x, variance);
    there.y = corrected(there.y, there.spread, frame->y, variance);
    there.spread = narrowed(there.spread, variance);
    b->horizon = cut(know, &b->horizon, at, &there);
    lay(know, &b->horizon);
}

static inline void up_to_date(Belief *b, const Knowledge *know, double now)
{
    b->horizon = advanced(know, b->horizon, now);
    if (b->begun)
        b->horizon = settled(know, b->horizon, now - OLDEST);
}

static inline Estimated estimated(const Belief *b, const Knowledge *know, double now)
{
    Axis x, y;
    double ahead = least(most(now - b->upright.at, 0.0), BLIND_REACH);
    looked(know, &b->horizon, now, &x, &y);
    return (Estimated){x.x, y.x, b->upright.z.x + ahead * b->upright.z.v, x.v, y.v, b->upright.z.v,
                       wrapped(b->upright.yaw.x + ahead * b->upright.yaw.v)};
}

static inline Knowledge knowledge_of(const Case *c, Span *spans, int64_t ring)
{
    AxisModel model = {c->model_lag, c->model_gain, c->model_drag, c->model_drag + HOVER_BRAKE_BELIEVED, c->acceleration_noise,
                       WANDER};
    Spread first = {.xx = SQUARE(c->position_noise), .vv = FIRST_VELOCITY_VARIANCE, .aa = SQUARE(c->acceleration_noise),
                    .dd = SQUARE(FIRST_DISTURBANCE)};
    return (Knowledge){model, c->model_delay, c->position_noise, first, spans, ring};
}
