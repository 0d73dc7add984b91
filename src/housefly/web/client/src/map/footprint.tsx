import { turn, type Projection } from "./projection";

interface Props {
  to: Projection;
  length: number;
  width: number;
  yaw: number;
}

/** A thing from above, turned about its middle [px, rad]. */
export function Footprint({ to, length, width, yaw }: Props) {
  return (
    <rect
      x={-length / 2}
      y={-width / 2}
      width={length}
      height={width}
      transform={`rotate(${turn(yaw, to)})`}
    />
  );
}
