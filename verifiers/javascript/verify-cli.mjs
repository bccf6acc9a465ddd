// `node verify-cli.mjs FILE…`: the verifier of the report page at a terminal. It reads certificates in JSON.
// It reads files and prints lines; verifier.js alone decides what is verified.

import { closeSync, openSync, readSync } from "node:fs";
import { parseArgs } from "node:util";
import { DEFAULT_LIMITS, oneLine, verify } from "./verifier.js";

const HELP = `\
Re-checks certificates of tilings in exact arithmetic, from their bytes alone.

Usage: node verify-cli.mjs [OPTIONS] FILE...

  FILE                  a certificate; - is standard input

  --json                one JSON object for each file
${Object.entries(DEFAULT_LIMITS).map(([name, value]) => `  ${`--max-${name} N`.padEnd(21)} [${value}]`).join("\n")}
  -h, --help            print this and stop

Exit code: 0 if every file is verified; else 1 if one is rejected; else 2 if one
is malformed or unreadable, or if the command line is wrong; else 3.
`;

const EXIT_CODES = new Map([["verified", 0], ["rejected", 1], ["malformed", 2], ["unreadable", 2], ["declined", 3]]);

function main() {
  const { values, positionals, limits } = commandLine();
  if (values.help) return process.stdout.write(HELP);
  let exitCode = 0;
  for (const file of positionals) {
    const { answer, bytes } = answerFor(file, limits);
    const line = values.json ? asJson(file, answer, bytes) : asText(file, answer);
    process.stdout.write(line + "\n");
    const own = EXIT_CODES.get(answer.verdict);
    if (exitCode === 0 || (own !== 0 && own < exitCode)) exitCode = own;
  }
  process.exitCode = exitCode;
}

function commandLine() {
  try {
    const names = Object.keys(DEFAULT_LIMITS).map((name) => [`max-${name}`, { type: "string" }]);
    const options = { json: { type: "boolean" }, help: { type: "boolean", short: "h" }, ...Object.fromEntries(names) };
    const { values, positionals } = parseArgs({ options, allowPositionals: true });
    if (positionals.length === 0 && !values.help) throw new Error("no file is given");
    return { values, positionals, limits: limitsFrom(values) };
  } catch (error) {
    process.stderr.write(`verify-cli: ${oneLine(error.message)}; try --help\n`);
    process.exit(2);
  }
}

function limitsFrom(values) {
  const given = Object.entries(values).filter(([name]) => name.startsWith("max-"));
  return Object.fromEntries(
    given.map(([name, text]) => {
      const fits = /^[0-9]+$/.test(text) && Number.isSafeInteger(Number(text));
      if (!fits) throw new Error(`--${name}: not an integer from 0 to 2^53 - 1`);
      return [name.slice("max-".length), Number(text)];
    }),
  );
}

function answerFor(file, limits) {
  try {
    const bytes = read(file, (limits.bytes ?? DEFAULT_LIMITS.bytes) + 1);
    return { answer: verify(bytes, limits), bytes };
  } catch (error) {
    if (!error.syscall) throw error;
    return { answer: { verdict: "unreadable", code: "unreadable", message: error.message } };
  }
}

/** The first bytes of a file, at most `most`: one more than the limit is refused. */
function read(file, most) {
  const handle = file === "-" ? 0 : openSync(file);
  const parts = [];
  let total = 0;
  for (let count = -1; count !== 0 && total < most; total += count) {
    const part = Buffer.alloc(Math.min(1 << 20, most - total));
    count = readSync(handle, part);
    parts.push(part.subarray(0, count));
  }
  if (handle !== 0) closeSync(handle);
  return new Uint8Array(Buffer.concat(parts));
}

function asText(file, answer) {
  return `${nameOf(file)}: ${oneLine(verdictOf(answer))}`;
}

function verdictOf({ verdict, code, message, claim, vertices, simplices, sha256 }) {
  if (verdict === "unreadable") return `unreadable: ${message}`;
  if (verdict !== "verified") return `${verdict} [${code}] ${message}`;
  const count = `${vertices} ${vertices === 1 ? "vertex" : "vertices"}, ${simplices} simplices`;
  return `verified: ${claim.join("; ")}. (${count}, sha256 ${sha256})`;
}

/** The name itself if it has only ASCII letters, digits and `._/-+=@%~`; otherwise a JSON string in ASCII. So no name forges a line. */
function nameOf(file) {
  if (/^[A-Za-z0-9._/+=@%~-]+$/.test(file)) return file;
  const escaped = (unit) => `\\u${unit.charCodeAt(0).toString(16).padStart(4, "0")}`;
  return `"${file.replace(/["\\]/g, "\\$&").replace(/[^ -~]/g, escaped)}"`;
}

function asJson(file, answer, bytes) {
  const { verdict, code, message, claim, vertices, simplices, sha256 } = answer;
  if (verdict !== "verified") return JSON.stringify({ code, file, message, verdict });
  // A verified certificate is canonical JSON, whose larger integers are texts: nothing is lost in objects.
  const data = JSON.parse(new TextDecoder().decode(bytes)).claim;
  return JSON.stringify({ claim: data, file, sha256, simplices, verdict, vertices, words: claim.join("; ") });
}

main();
