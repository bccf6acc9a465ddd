// The certificates of the repository for the tests of the JavaScript verifier, and the Rust program to compare with.

import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = fileURLToPath(new URL("../..", import.meta.url));

/** Name, bytes, and the limits that the name's end `--limit-NAME-N` demands, of each file of a folder. */
export function certificatesIn(folder) {
  const path = join(ROOT, folder);
  return readdirSync(path)
    .filter((name) => name.endsWith(".json"))
    .sort()
    .map((name) => {
      const stem = basename(name, ".json");
      const [, limit, value] = /--limit-([a-z]+)-([0-9]+)$/.exec(stem) ?? [];
      return { name, stem, path: join(path, name), bytes: new Uint8Array(readFileSync(join(path, name))), limits: limit ? { [limit]: Number(value) } : {} };
    });
}

/** `acutile-verify`, from the environment or the newest that cargo has built; undefined where there is none. */
export function rustVerifier() {
  const given = process.env.ACUTILE_VERIFY;
  if (given) return given;
  const built = ["release", "debug"].map((profile) => join(ROOT, "target", profile, "acutile-verify")).filter(existsSync);
  return built.sort((p, q) => statSync(q).mtimeMs - statSync(p).mtimeMs)[0];
}

/** The answers of the Rust program for some files under the same limits, by file. */
export function askRust(program, files, limits) {
  const options = Object.entries(limits).flatMap(([name, value]) => [`--limit-${name}`, String(value)]);
  const lines = outputOf(program, ["--json", ...options, ...files]).trimEnd().split("\n");
  return new Map(lines.map((line) => JSON.parse(line)).map((answer) => [answer.file, answer]));
}

/** Standard output, whatever the exit code says of the files. */
export function outputOf(program, options) {
  const setting = { encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "inherit"] };
  try {
    return execFileSync(program, options, setting);
  } catch (error) {
    if (![1, 2, 3].includes(error.status)) throw error;
    return error.stdout;
  }
}
