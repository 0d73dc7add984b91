import { proof } from "./session";

/** The address of a WebSocket at a path of this server; the proof travels as a subprotocol. */
export function socketAddress(path: string): [address: string, protocols: string[]] {
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  return [`${scheme}://${location.host}${path}`, ["housefly", `proof.${proof()}`]];
}

/** Open a WebSocket at a path of this server. */
export function openSocket(path: string): WebSocket {
  return new WebSocket(...socketAddress(path));
}
