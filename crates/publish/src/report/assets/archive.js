// An archive in the format ZIP (APPNOTE 6.3), files stored as they are.

const CRC_TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

const crc32 = (bytes) => ~bytes.reduce((c, byte) => CRC_TABLE[(c ^ byte) & 255] ^ (c >>> 8), -1) >>> 0;

// A record of 16-bit and 32-bit numbers, [size in bytes, value].
function record(numbers, ...tail) {
  const head = new DataView(new ArrayBuffer(numbers.reduce((sum, [size]) => sum + size, 0)));
  numbers.reduce((at, [size, value]) => { head[size === 2 ? "setUint16" : "setUint32"](at, value, true); return at + size; }, 0);
  return [new Uint8Array(head.buffer), ...tail];
}

// The bytes of an archive of files [name, text]. Its times are those that no file has, so that the same files give the same bytes.
function archive(files) {
  const encode = (text) => new TextEncoder().encode(text), parts = [], directory = [];
  let offset = 0;
  for (const [name, text] of files) {
    const path = encode(name), bytes = encode(text);
    const common = [[2, 20], [2, 0], [2, 0], [2, 0], [2, 33], [4, crc32(bytes)], [4, bytes.length], [4, bytes.length], [2, path.length], [2, 0]];
    parts.push(...record([[4, 0x04034b50], ...common], path, bytes));
    directory.push(...record([[4, 0x02014b50], [2, 20], ...common, [2, 0], [2, 0], [2, 0], [4, 0], [4, offset]], path));
    offset += 30 + path.length + bytes.length;
  }
  const size = directory.reduce((sum, bytes) => sum + bytes.length, 0);
  const end = record([[4, 0x06054b50], [2, 0], [2, 0], [2, files.length], [2, files.length], [4, size], [4, offset], [2, 0]]);
  return new Blob([...parts, ...directory, ...end]);
}
