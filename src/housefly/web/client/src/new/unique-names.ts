// Names that nothing else has.

/** A name that no other item has: "table", "table 2". */
export function unused(name: string, taken: string[]): string {
  let found = name;
  for (let k = 2; taken.includes(found); k++) found = `${name} ${k}`;
  return found;
}

/** What commands call a place by, of what people call it. */
export function slug(title: string, taken: string[]): string {
  const plain = title
    .normalize("NFKD")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-+|-+$/g, "")
    .slice(0, 36);
  let name = plain || "place";
  for (let k = 2; taken.includes(name) || name === "home"; k++) name = `${plain || "place"}-${k}`;
  return name;
}
