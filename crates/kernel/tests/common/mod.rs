//! JSON to CBOR without a schema, and the files of `tests/certificates`.
#![allow(dead_code)]

use std::fs;
use std::path::PathBuf;

/// A certificate in JSON as CBOR: objects become arrays of their values, strings of digits become
/// integers. Nothing if the text is no JSON of the kinds that certificates use.
pub fn transcribe(json: &[u8]) -> Option<Vec<u8>> {
    let mut reader = Reader { json, next: 0 };
    let mut out = Vec::new();
    reader.value(&mut out, 0)?;
    reader.space();
    (reader.next == json.len()).then_some(out)
}

struct Reader<'j> {
    json: &'j [u8],
    next: usize,
}

impl Reader<'_> {
    fn space(&mut self) {
        while matches!(self.json.get(self.next), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.next += 1;
        }
    }

    fn peek(&mut self) -> Option<u8> {
        self.space();
        self.json.get(self.next).copied()
    }

    fn take(&mut self, byte: u8) -> Option<()> {
        (self.peek()? == byte).then(|| self.next += 1)
    }

    fn value(&mut self, out: &mut Vec<u8>, depth: usize) -> Option<()> {
        match self.peek()? {
            _ if depth > 100 => None,
            open @ (b'{' | b'[') => {
                self.next += 1;
                let close = open + 2;
                let (mut items, mut count) = (Vec::new(), 0);
                while self.peek()? != close {
                    if count > 0 {
                        self.take(b',')?;
                    }
                    if open == b'{' {
                        self.string()?;
                        self.take(b':')?;
                    }
                    self.value(&mut items, depth + 1)?;
                    count += 1;
                }
                self.next += 1;
                head(out, 4, count);
                out.extend(items);
                Some(())
            }
            b'"' => {
                let text = self.string()?;
                let digits = text.strip_prefix('-').unwrap_or(&text);
                if !digits.is_empty() && digits.bytes().all(|c| c.is_ascii_digit()) {
                    return integer(out, &text);
                }
                head(out, 3, text.len() as u64);
                out.extend(text.bytes());
                Some(())
            }
            _ => {
                let start = self.next;
                while matches!(self.json.get(self.next), Some(b'-' | b'0'..=b'9')) {
                    self.next += 1;
                }
                integer(out, std::str::from_utf8(&self.json[start..self.next]).ok()?)
            }
        }
    }

    fn string(&mut self) -> Option<String> {
        self.take(b'"')?;
        let length = self.json[self.next..].iter().position(|&c| c == b'"')?;
        let bytes = &self.json[self.next..self.next + length];
        self.next += length + 1;
        let is_plain = bytes.iter().all(|&c| c != b'\\');
        is_plain.then(|| String::from_utf8(bytes.to_vec()).ok()).flatten()
    }
}

pub fn head(out: &mut Vec<u8>, kind: u8, value: u64) {
    let bytes = value.to_be_bytes();
    let (info, length) = match value {
        0..24 => (value as u8, 0),
        24..0x100 => (24, 1),
        0x100..0x1_0000 => (25, 2),
        0x1_0000..0x1_0000_0000 => (26, 4),
        _ => (27, 8),
    };
    out.push(kind << 5 | info);
    out.extend(&bytes[8 - length..]);
}

fn integer(out: &mut Vec<u8>, text: &str) -> Option<()> {
    use num_bigint::BigInt;
    let value: BigInt = text.parse().ok()?;
    let (negative, natural) = if value < BigInt::ZERO { (1, !value) } else { (0, value) };
    match u64::try_from(&natural) {
        Ok(value) => head(out, negative, value),
        Err(_) => {
            let (_, bytes) = natural.to_bytes_be();
            head(out, 6, 2 + u64::from(negative));
            head(out, 2, bytes.len() as u64);
            out.extend(bytes);
        }
    }
    Some(())
}

/// A file of the corpus, as CBOR.
pub struct File {
    pub folder: &'static str,
    pub name: String,
    pub json: Option<String>,
    pub cbor: Vec<u8>,
}

impl File {
    /// The code that the name demands, or `verified`.
    pub fn code(&self) -> &str {
        let code = self.name.split("--").next().unwrap();
        match code {
            _ if self.folder == "valid" => "verified",
            "valid" => "verified",
            "json" => "cbor",
            code => code,
        }
    }

    /// The limit in the name, as `--limit-work-100`.
    pub fn limit(&self) -> Option<(&str, u64)> {
        let (_, limit) = self.name.split_once("--limit-")?;
        let (name, value) = limit.split_once('-')?;
        Some((name, value.parse().unwrap()))
    }

    /// The fault is one of the text, which the transcription hides.
    pub fn is_about_json(&self) -> bool {
        self.json.is_some() && self.folder == "malformed" && matches!(self.code(), "cbor" | "canonical")
    }
}

pub fn folder() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/certificates"))
}

pub fn files() -> Vec<File> {
    let mut files = Vec::new();
    for folder in ["valid", "false", "malformed", "declined", "cbor"] {
        let mut paths: Vec<PathBuf> =
            fs::read_dir(self::folder().join(folder)).unwrap().map(|entry| entry.unwrap().path()).collect();
        paths.sort();
        for path in paths {
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            let bytes = fs::read(&path).unwrap();
            if path.extension().is_some_and(|extension| extension == "json") {
                if let Some(cbor) = transcribe(&bytes) {
                    let json = String::from_utf8(bytes).ok();
                    files.push(File { folder, name, json, cbor });
                }
            } else {
                files.push(File { folder, name, json: None, cbor: bytes });
            }
        }
    }
    files
}
