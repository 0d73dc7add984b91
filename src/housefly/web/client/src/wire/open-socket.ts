import { proof } from "./session";

/**
 * The address of a WebSocket at a path of this server; the proof travels as a subprotocol, and the
 * drone that this page shows as in its own address.
 */
export function socketAddress(path: string): [address: string, protocols: string[]] {
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  const address = `${scheme}://${location.host}${path}${location.search}`;
  return [address, ["housefly", `proof.${proof()}`]];
}

/** Open a WebSocket at a path of this server. */
export function openSocket(path: string): WebSocket {
  return new WebSocket(...socketAddress(path));
}
