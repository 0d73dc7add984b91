import { computed, signal } from "@preact/signals";
import { panel, role, usedInvitations } from "../store";
import type { Key } from "../messages/en";
import { now } from "../wire/clock";
import type { InviteReply, InviteRequest } from "../wire/messages";
import { ask } from "../wire/socket";
import { t, translated } from "../messages/language";

type GuestRole = NonNullable<InviteRequest["role"]>;

const ROLES: { role: GuestRole; title: Key; may: Key }[] = [
  { role: "watch", title: "Watch", may: "may see everything, and STOP or land the drone" },
  { role: "ask", title: "Ask", may: "may watch and ask; a flight waits for your yes" },
  { role: "fly", title: "Fly", may: "may take control and fly" },
];

const made = signal<{ reply: InviteReply; role: GuestRole } | null>(null);
const trouble = signal("");
const copied = signal<"" | "done" | "failed">("");

const left = computed(() => (made.value ? made.value.reply.until - now.value : 0));
const isOpen = computed(
  () => left.value > 0 && !usedInvitations.value.has(made.value?.reply.name ?? ""),
);

async function make(guest: GuestRole): Promise<void> {
  made.value = null;
  copied.value = "";
  trouble.value = "";
  const reply = await ask({ type: "invite", role: guest });
  if (reply.type === "invite") made.value = { reply, role: guest };
  else trouble.value = 
    reply.type === "refused" ? translated(reply.reason) : t("No link could be made.");
}

function close(): void {
  made.value = null;
  panel.value = "";
}

/** A one-time link for another browser, as a QR code where a phone can reach this console. */
export function Invite() {
  return (
    <section class="sheet invite" role="dialog" aria-label={t("Invite")}>
      <h2>{t("Invite")}</h2>
      {role.value === "admin" ? (
        <Roles />
      ) : (
        <p class="quiet">
          {t("Your role is “{role}”: ask who runs Housefly for a link.", { role: role.value })}
        </p>
      )}
      <Offer />
      <Code />
      <div class="row">
        <Hand />
        <button type="button" class="quiet-button" onClick={close}>
          {t("Close")}
        </button>
      </div>
    </section>
  );
}

function Roles() {
  return (
    <div class="roles" role="group" aria-label={t("What the guest may do")}>
      {ROLES.map((one) => (
        <button
          type="button"
          key={one.role}
          aria-pressed={made.value?.role === one.role}
          onClick={() => void make(one.role)}
        >
          {t(one.title)}
        </button>
      ))}
    </div>
  );
}

/** What the link is good for, until when; or what became of it. */
function Offer() {
  if (trouble.value) return <p role="alert">△ {trouble.value}</p>;
  if (!made.value)
    return <p class="quiet">{t("What may the other one do? STOP is for everybody.")}</p>;
  const { reply, role: guest } = made.value;
  const may = t(ROLES.find((one) => one.role === guest)!.may);
  if (usedInvitations.value.has(reply.name))
    return <p role="status">✓ {t("The link was used: the guest {may}.", { may })}</p>;
  if (left.value <= 0)
    return <p role="status">△ {t("The link expired: make a new one.")}</p>;
  return (
    <div class="offer">
      <p>
        {t("The first to open it {may}. It works once, for:", { may })}{" "}
        <strong class="number">{clock(left.value)}</strong>
      </p>
      {!reply.qr && (
        <p class="quiet">
          {t("Only this machine reaches the console.")}{" "}
          {t("For a phone, restart with:")} <kbd>--lan</kbd>
        </p>
      )}
      {(!reply.qr || copied.value === "failed") && <p class="link">{link(reply)}</p>}
    </div>
  );
}

function Code() {
  const qr = isOpen.value ? made.value?.reply.qr : null;
  if (!qr) return null;
  return (
    <svg
      class="qr"
      viewBox={`0 0 ${qr.size} ${qr.size}`}
      role="img"
      aria-label={t("QR code of the link")}
    >
      <rect width={qr.size} height={qr.size} fill="#fff" />
      <path d={qr.path} fill="#000" shape-rendering="crispEdges" />
    </svg>
  );
}

/** The ways to hand the link over without a camera. */
function Hand() {
  if (!made.value || !isOpen.value) return null;
  const { reply } = made.value;
  return (
    <>
      <button type="button" class="quiet-button" onClick={() => void copy(link(reply))}>
        {copied.value === "done" ? t("Copied") : t("Copy link")}
      </button>
      {"share" in navigator && (
        <button type="button" class="quiet-button" onClick={() => void share(link(reply))}>
          {t("Share")}
        </button>
      )}
    </>
  );
}

function link(reply: InviteReply): string {
  return (reply.origin || location.origin) + reply.path;
}

async function copy(text: string): Promise<void> {
  copied.value = await (navigator.clipboard?.writeText(text) ?? Promise.reject()).then(
    () => "done" as const,
    () => "failed" as const,
  );
}

async function share(url: string): Promise<void> {
  await navigator.share({ title: "Housefly", url }).catch(() => undefined);
}

function clock(seconds: number): string {
  const whole = Math.max(0, Math.ceil(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}
