// The certificates of the repository for the tests of the verifiers, and the other programs to compare with.

import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = fileURLToPath(new URL("../..", import.meta.url));

/** Name, bytes, and the limits that the name's end `--limit-NAME-N` or `--max-NAME-N` demands, of each file of a folder. */
export function certificatesIn(folder) {
  const path = join(ROOT, folder);
  return readdirSync(path)
    .filter((name) => name.endsWith(".json"))
    .sort()
    .map((name) => {
      const stem = basename(name, ".json");
      const [, limit, value] = /--(?:limit|max)-([a-z]+)-([0-9]+)$/.exec(stem) ?? [];
      return { name, stem, path: join(path, name), bytes: new Uint8Array(readFileSync(join(path, name))), limits: limit ? { [limit]: Number(value) } : {} };
    });
}

/** `acutile-verify`, from the environment or the newest that cargo has built. */
function rustVerifier() {
  const given = process.env.ACUTILE_VERIFY;
  if (given) return given;
  const built = ["release", "debug"].map((profile) => join(ROOT, "target", profile, "acutile-verify")).filter(existsSync);
  if (built.length === 0) throw new Error("acutile-verify is not built: cargo build --package acutile-kernel, or name it in ACUTILE_VERIFY");
  return built.sort((p, q) => statSync(q).mtimeMs - statSync(p).mtimeMs)[0];
}

const python = ["python3", join(ROOT, "verifiers/python/verify.py")];

/** The other verifiers: the command, and the encoding that it reads. */
export const OTHERS = [
  { name: "acutile-verify", command: [rustVerifier()], reads: "cbor" },
  { name: "verify.py", command: python, reads: "json" },
  { name: "verify.py on CBOR", command: python, reads: "cbor" },
];

/** The answers of a program about some files: the lines of all verifiers begin alike. */
export function ask({ command: [program, ...options] }, files) {
  const lines = outputOf(program, [...options, ...files]).trimEnd().split("\n");
  if (lines.length !== files.length) throw new Error(`${program}: ${lines.length} lines for ${files.length} files`);
  return lines.map((line) => {
    const [, verdict, code = null] = /: (verified|rejected|malformed|declined)(?: \[([a-z-]+)\])?/.exec(line) ?? [];
    return { verdict, code, sha256: /sha256 ([0-9a-f]{64})/.exec(line)?.[1] ?? null, line };
  });
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
