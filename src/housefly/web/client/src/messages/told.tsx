import { tongue } from "./speech";

/** Words of the server as `translated` gives them; marked as English where they are not. */
export const Told = ({ words }: { words: string }) => {
  const lang = tongue(words);
  return lang ? <span lang={lang}>{words}</span> : <>{words}</>;
};
