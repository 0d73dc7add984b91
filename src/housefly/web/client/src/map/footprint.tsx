import { turn } from "./projection";

/** A thing from above, turned about its middle [px, rad]. */
export function Footprint(props: { length: number; width: number; yaw: number }) {
  const { length, width, yaw } = props;
  return (
    <rect
      x={-length / 2}
      y={-width / 2}
      width={length}
      height={width}
      transform={turn(yaw)}
    />
  );
}
