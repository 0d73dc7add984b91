// The proof of this session: what our page knows beside the cookie, which browsers send to every
// port of a host. The server hands it over in the address, once; it does not stay there.
const PROOF_KEY = "housefly proof";

const handed = new URLSearchParams(location.search).get("proof");
if (handed) {
  localStorage.setItem(PROOF_KEY, handed);
  history.replaceState(history.state, "", location.pathname + location.hash);
}

/** The proof, or "" in a browser that has none. */
export function proof(): string {
  return localStorage.getItem(PROOF_KEY) ?? "";
}

/** Fetch from this server as this session. */
export function fetchAsSession(path: string, init: RequestInit = {}): Promise<Response> {
  return fetch(path, { ...init, headers: { "x-housefly-proof": proof() } });
}
