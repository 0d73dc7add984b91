// The proof of this session: what our page knows beside the cookie, which browsers send to every
// port of a host. The server hands it over behind the # of the address, once.
const PROOF_KEY = "housefly proof";

const handed = /^#proof=([0-9a-f]+)$/.exec(location.hash);
if (handed) {
  localStorage.setItem(PROOF_KEY, handed[1]!);
  history.replaceState(null, "", location.pathname);
}

/** The proof, or "" in a browser that has none. */
export function proof(): string {
  return localStorage.getItem(PROOF_KEY) ?? "";
}

/** Fetch from this server as this session. */
export function fetchAsSession(path: string, init: RequestInit = {}): Promise<Response> {
  return fetch(path, { ...init, headers: { "x-housefly-proof": proof() } });
}
