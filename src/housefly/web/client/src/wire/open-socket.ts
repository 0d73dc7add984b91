import { proof } from "./session";

/** Open a WebSocket at a path of this server; the proof travels as a subprotocol. */
export function openSocket(path: string): WebSocket {
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  return new WebSocket(`${scheme}://${location.host}${path}`, ["housefly", `proof.${proof()}`]);
}
