// Builds ../static, or the folder given, from src: `npm run build`. The result is committed, so
// that Housefly needs no node to run.
import { build, transform } from "esbuild";
import { createHash } from "node:crypto";
import { copyFile, mkdir, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { relative } from "node:path";
import { brotliCompressSync } from "node:zlib";
import { minify } from "terser";

const target = process.argv[2] ?? "../static";
const bundled = ["preact", "@preact/signals", "@preact/signals-core", "three"];
/** The page's own letters: digits of one width, and the same on every machine. */
const letters = "@fontsource-variable/inter";

await mkdir(target, { recursive: true });
const options = {
  outdir: target,
  bundle: true,
  minify: true,
  charset: "utf8",
  format: "esm",
  target: ["es2022"],
  jsx: "automatic",
  jsxImportSource: "preact",
  legalComments: "none",
  logLevel: "warning",
  external: ["/static/*"],
};
/** Texts and templates of a language are known by short names there: `short`. */
const shortNames = {
  name: "short names",
  setup({ onLoad }) {
    onLoad({ filter: /[\\/]messages[\\/](de|ja)(-told)?\.ts$/ }, async ({ path }) => {
      const { DIGITS, short } = await imported("src/messages/short.ts");
      const [[name, templates]] = Object.entries(await imported(path));
      const named = Object.entries(templates).map(([english, own]) => [short(english), own]);
      named.sort(([one], [other]) => one - other);
      const steps = named.map(([at], k) => at - (named[k - 1]?.[0] ?? 0));
      if (steps.includes(0)) throw new Error("a short name stands twice");
      const own = named.map(([, text]) => text);
      if (own.some((text) => text.includes("\n"))) throw new Error("a template of several lines");
      // Smaller on their way: the steps from name to name, all first digits before all second ones,
      // and all templates in one text.
      const digits = steps.map((step) => step.toString(36).padStart(DIGITS, "0"));
      const columns = [...Array(DIGITS).keys()].map((j) => digits.map((one) => one[j]).join(""));
      return {
        contents:
          `const columns = ${JSON.stringify(columns)};let at = 0;` +
          `export const ${name} = Object.fromEntries(${JSON.stringify(own.join("\n"))}` +
          `.split("\\n").map((own, k) => ` +
          `[at += parseInt(columns.map((one) => one[k]).join(""), 36), own]));`,
      };
    });
  },
};
async function imported(path) {
  const { code } = await transform(await readFile(path, "utf8"), { loader: "ts" });
  return import(`data:text/javascript,${encodeURIComponent(code)}`);
}
/** What is fetched later begins with all of the first load: esbuild then keeps that in one file. */
const firstTogether = {
  name: "first together",
  setup({ onLoad, onResolve, resolve: find }) {
    onResolve({ filter: /^\./ }, async ({ kind, path, ...from }) => {
      if (kind !== "dynamic-import") return undefined;
      const found = await find(path, { ...from, kind: "import-statement" });
      // Names of files are made of it: the same wherever the source lies.
      return { path: relative("src", found.path), namespace: "later" };
    });
    onLoad({ filter: /./, namespace: "later" }, ({ path }) => ({
      contents: `import "./main"; export * from ${JSON.stringify(`./${path}`)};`,
      resolveDir: "src",
    }));
  },
};
// The screens beside the first are chunks of their own, fetched when there is time or need.
for (const old of await readdir(target))
  if (/^(chunk|new)-.*\.(js|css)$|\.br$/.test(old)) await rm(`${target}/${old}`);
/** A twentieth less on its way; the view in space is too large to be worth the time. */
async function smaller(file) {
  const { code } = await minify(await readFile(file, "utf8"), {
    module: true,
    ecma: 2020,
    compress: { passes: 3, unsafe_arrows: true },
  });
  await writeFile(file, code);
}
await build({
  ...options,
  entryPoints: { app: "src/main.tsx" },
  splitting: true,
  plugins: [firstTogether, shortNames],
  chunkNames: "chunk-[name]-[hash]",
});
await build({ ...options, entryPoints: { app: "src/styles.css" } });
await build({ ...options, entryPoints: { later: "src/later.css" } });
await build({ ...options, entryPoints: { drones: "src/drones/drones.ts" } });
await build({ ...options, entryPoints: { drones: "src/drones/drones.css" } });
await build({ ...options, entryPoints: { "video-worker": "src/wire/video-worker.ts" } });
await build({
  ...options,
  entryPoints: { new: "src/new/main.tsx" },
  splitting: true,
  plugins: [shortNames],
  chunkNames: "new-[name]-[hash]",
});
await copyFile("src/index.html", `${target}/index.html`);
await copyFile("src/new.html", `${target}/new.html`);
for (const name of ["favicon.svg", "icon-192.png", "icon-512.png", "manifest.json"])
  await copyFile(`src/${name}`, `${target}/${name}`);
await copyFile(
  `node_modules/${letters}/files/inter-latin-wght-normal.woff2`,
  `${target}/inter.woff2`,
);
for (const name of await readdir(target))
  if (name.endsWith(".js") && !name.startsWith("chunk-room-in-space"))
    await smaller(`${target}/${name}`);
// What the service worker keeps, and which build it is of.
const shell = (await readdir(target))
  .filter((name) => /^(app|later|chunk-.*)\.(js|css)$/.test(name))
  .filter((name) => !name.startsWith("chunk-room-in-space"));
shell.push("favicon.svg", "inter.woff2");
const hash = createHash("sha256");
for (const name of shell.sort()) hash.update(await readFile(`${target}/${name}`));
await build({
  ...options,
  entryPoints: { "service-worker": "src/service-worker.js" },
  define: {
    VERSION: JSON.stringify(hash.digest("hex").slice(0, 12)),
    FILES: JSON.stringify(shell.map((name) => `/static/${name}`)),
  },
});
// Packed once, here: the machine that serves them flies a drone.
for (const name of await readdir(target))
  if (/\.(js|css)$/.test(name))
    await writeFile(`${target}/${name}.br`, brotliCompressSync(await readFile(`${target}/${name}`)));
const licences = await Promise.all(
  [...bundled, letters].map(
    async (name) => `${name}\n\n${await readFile(`node_modules/${name}/LICENSE`, "utf8")}`,
  ),
);
await writeFile(
  `${target}/LICENSES.txt`,
  `app.js, its chunks and new.js contain these libraries; the last are the letters of inter.woff2.\n\n${licences.join("\n---\n\n")}`,
);
