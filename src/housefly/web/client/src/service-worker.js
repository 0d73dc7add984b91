// Keeps the shell of the page, so that the app opens where there is no network and says so. What
// is of the room is never kept, and no address that carries a link or a proof. What the server
// has goes first, always: the kept shell shows only where it does not answer.
/* global VERSION, FILES */
const KEPT = `housefly shell ${VERSION}`;
const PATIENCE = 4000;
const SHELL = new Set(["/", ...FILES]);

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(KEPT).then((cache) => cache.addAll([...SHELL])));
  self.skipWaiting();
});

self.addEventListener("activate", (event) => event.waitUntil(begin()));

async function begin() {
  for (const name of await caches.keys())
    if (name.startsWith("housefly shell ") && name !== KEPT) await caches.delete(name);
  await self.clients.claim();
}

self.addEventListener("fetch", (event) => {
  const { method, mode, url } = event.request;
  const { origin, pathname, search } = new URL(url);
  const isShell = origin === self.location.origin && search === "" && SHELL.has(pathname);
  if (isShell && method === "GET" && (pathname !== "/" || mode === "navigate"))
    event.respondWith(answer(event.request, pathname));
});

async function answer(request, pathname) {
  const late = new Promise((_, refuse) => setTimeout(refuse, PATIENCE));
  try {
    return await Promise.race([fetch(request), late]);
  } catch {
    return (await caches.match(pathname, { cacheName: KEPT })) ?? Response.error();
  }
}

self.addEventListener("notificationclick", (event) => {
  event.notification.close();
  event.waitUntil(show());
});

async function show() {
  const [open] = await self.clients.matchAll({ type: "window" });
  await (open ? open.focus() : self.clients.openWindow("/"));
}
