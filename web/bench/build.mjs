// Builds the page into web/bench/dist, or into the folder named on the command line.
// The same sources and lock file give the same bytes: a test builds again and compares.

import { copyFile, mkdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const target = process.argv[2] ?? join(here, "dist");

await mkdir(target, { recursive: true });
await build({
  absWorkingDir: here,
  entryPoints: { bench: "src/main.js" },
  outdir: target,
  bundle: true,
  format: "esm",
  target: "es2022",
  minify: true,
  // Licences of the libraries go along with them.
  legalComments: "eof",
  charset: "utf8",
});
for (const name of ["index.html", "icon.svg"]) {
  await copyFile(join(here, "src", name), join(target, name));
}
