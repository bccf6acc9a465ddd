#!/usr/bin/env python3
"""Packs the crates that the kernel needs, so that an archive can build it without network.

    verifiers/rust/vendor.py FILE.tar.gz             writes the package
    verifiers/rust/vendor.py FILE.tar.gz --check     exit code 1 unless FILE has the same content

The crates are those of Cargo.lock, as crates.io has them, with two changes. Tests, benchmarks and documentation are left
out. sha2 is built without the detection of processors (cpufeatures, libc), which is two megabytes and saves a
millisecond: its manifest has no such dependency, and .cargo/config.toml asks for the code that any processor runs.
"""
import gzip, io, json, re, shutil, subprocess, sys, tarfile, tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KEPT = re.compile(r"(README\.md|Cargo\.toml|LICENSE.*|LICENCE.*|COPYRIGHT|build\.rs|src/.*\.rs)$")
UNUSED = ["cpufeatures", "libc"]
CONFIG = """[build]
rustflags = ["--cfg", "sha2_backend=\\"soft\\""]

[source.crates-io]
replace-with = "vendored"

[source.vendored]
directory = "vendor"
"""


def vendored(work):
    """cargo vendor for the kernel alone, with the versions of Cargo.lock."""
    shutil.copytree(ROOT / "crates/kernel", work / "kernel", ignore=shutil.ignore_patterns("tests"))
    shutil.copy(ROOT / "Cargo.lock", work / "kernel/Cargo.lock")
    subprocess.run(["cargo", "vendor", "--quiet", "--versioned-dirs", "../vendor"], cwd=work / "kernel", check=True,
                   stdout=subprocess.DEVNULL)
    return work / "vendor", (work / "kernel/Cargo.lock").read_text()


def without_detection(manifest):
    """sha2's manifest without the sections of cpufeatures."""
    sections = re.split(r"(?m)^(?=\[)", manifest)
    kept = [s for s in sections if not re.match(r"\[target\..*dependencies\.cpufeatures\]", s)]
    assert len(kept) < len(sections), "sha2 has no dependency cpufeatures"
    return "".join(kept)


def lock_without(lock):
    packages = re.split(r"(?m)^(?=\[\[package\]\])", lock)
    kept = [p for p in packages if not any(f'name = "{name}"\n' in p for name in UNUSED)]
    return re.sub(r'(?m)^ "(cpufeatures|libc)",\n', "", "".join(kept))


def files():
    with tempfile.TemporaryDirectory() as folder:
        vendor, lock = vendored(Path(folder))
        found = {".cargo/config.toml": CONFIG.encode(), "Cargo.lock": lock_without(lock).encode()}
        for crate in sorted(vendor.iterdir()):
            if re.sub(r"-[0-9.]+$", "", crate.name) in UNUSED:
                continue
            package = json.loads((crate / ".cargo-checksum.json").read_text())["package"]
            checksum = json.dumps({"files": {}, "package": package}, sort_keys=True)
            found[f"vendor/{crate.name}/.cargo-checksum.json"] = checksum.encode()
            for path in sorted(crate.rglob("*")):
                name = path.relative_to(crate).as_posix()
                if path.is_file() and KEPT.fullmatch(name) and not re.search(r"(^|/)(tests?|benches)(/|\.rs$)", name):
                    content = path.read_bytes()
                    if crate.name.startswith("sha2-") and name == "Cargo.toml":
                        content = without_detection(content.decode()).encode()
                    found[f"vendor/{crate.name}/{name}"] = content
        return found


def main():
    target, found = Path(sys.argv[1]), files()
    if "--check" in sys.argv:
        with tarfile.open(target) as package:
            there = {m.name: package.extractfile(m).read() for m in package}
        different = sorted(n for n in there.keys() | found.keys() if there.get(n) != found.get(n))
        print(f"{len(there)} files, {len(different)} different", *different[:10])
        sys.exit(1 if different or not there else 0)
    plain = io.BytesIO()
    with tarfile.open(fileobj=plain, mode="w", format=tarfile.USTAR_FORMAT) as package:
        for name, content in sorted(found.items()):
            member = tarfile.TarInfo(name)
            member.size = len(content)
            package.addfile(member, io.BytesIO(content))
    target.write_bytes(gzip.compress(plain.getvalue(), 9, mtime=0))
    print(f"{target}: {len(found)} files, {target.stat().st_size} bytes")


if __name__ == "__main__":
    main()
