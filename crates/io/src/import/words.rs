//! Messages of the JSON reader and of the operating system, in the words of people who write such files.

use std::io;

/// The message of the operating system about a file, without its number.
pub fn of_io(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_owned(),
        io::ErrorKind::IsADirectory => "is a directory, expected a file".to_owned(),
        io::ErrorKind::NotADirectory => "a part of its path is not a directory".to_owned(),
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        _ => {
            let text = error.to_string();
            let end = text.find(" (os error").unwrap_or(text.len());
            text[..end].to_owned()
        }
    }
}

/// A text of the file, quoted for a message, cut where it is long.
pub fn short(text: &str) -> String {
    match text.char_indices().nth(40) {
        None => format!("{text:?}"),
        Some((end, _)) => format!("{:?}…", &text[..end]),
    }
}

/// The use of a file in another format of the project.
pub fn use_of(format: &str) -> &'static str {
    match format {
        "acutile-plane-tiling" => {
            "; a plane tiling by squares and triangles is taken as square-triangle:FILE or z-c15:FILE"
        }
        "acutile-tiling" | "acutile-points" => "; acutile takes this file by its name alone",
        "acutile-certificate" => "; this is no certificate in its canonical form",
        "acutile-answer" => "; this is an answer that --json printed",
        _ => "",
    }
}

/// The message of an error of serde_json without its place.
pub fn of_json(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let end = text.rfind(" at line ").unwrap_or(text.len());
    of_message(&text[..end])
}

fn of_message(message: &str) -> String {
    if let Some(words) = of_syntax(message) {
        return words.to_owned();
    }
    if let Some(rest) = message.strip_prefix("invalid type: ") {
        return found_expected(rest);
    }
    if let Some(rest) = message.strip_prefix("invalid value: ") {
        return found_expected(rest);
    }
    if let Some(rest) = message.strip_prefix("invalid length ") {
        let (count, expected) = rest.split_once(", expected ").unwrap_or((rest, "others"));
        let entries = if count == "1" { "entry" } else { "entries" };
        let expected = thing(expected).replace("an array of length ", "");
        return format!("found {count} {entries}, expected {expected}");
    }
    if let Some(name) = quoted(message, "missing field ") {
        return format!("the member {name:?} is missing{}", example(name));
    }
    if let Some(name) = quoted(message, "duplicate field ") {
        return format!("the member {name:?} is repeated; keep one of them");
    }
    if let Some(name) = quoted(message, "unknown field ") {
        return format!("the member {name:?} is not known here{}", choices(message));
    }
    if let Some(name) = quoted(message, "unknown variant ") {
        return format!("found {name:?}{}", choices(message));
    }
    message.to_owned()
}

/// Errors of the grammar of JSON.
fn of_syntax(message: &str) -> Option<&'static str> {
    Some(match message {
        "expected value" => {
            "expected a value: a number, an array, an object or a text in double quotes"
        }
        "expected ident" => "expected true, false or null; a text needs double quotes",
        "key must be a string" => "expected the name of a member in double quotes",
        "trailing comma" => "a comma before a closing bracket; remove the comma",
        "trailing characters" => "text after the end of the object; a file holds one object",
        "expected `:`" => "expected a colon after the name of a member",
        "expected `,` or `}`" => "expected a comma or a closing }",
        "expected `,` or `]`" => "expected a comma or a closing ]",
        "EOF while parsing an object" => "the file ends within an object; a closing } is missing",
        "EOF while parsing a list" => "the file ends within an array; a closing ] is missing",
        "EOF while parsing a string" => "the file ends within a text; a closing \" is missing",
        "EOF while parsing a value" => "the file ends where a value is expected",
        "control character (\\u0000-\\u001F) found while parsing a string" => {
            "a line break or a control character within a text; a closing \" may be missing"
        }
        "invalid escape" => "an unknown escape in a text; a backslash is written \\\\",
        "recursion limit exceeded" => "brackets are nested more than 127 deep",
        "number out of range" => "the number is too large",
        "invalid number" => "this is no number of JSON; write fractions as texts, like \"1/2\"",
        _ => return None,
    })
}

fn found_expected(rest: &str) -> String {
    match rest.split_once(", expected ") {
        Some((found, expected)) => format!("found {}, expected {}", thing(found), thing(expected)),
        None => format!("found {}", thing(rest)),
    }
}

/// A type of serde in terms of JSON.
fn thing(name: &str) -> String {
    let name = name.replace('`', "");
    match name.as_str() {
        "sequence" | "a sequence" => "an array".to_owned(),
        "map" | "a map" => "an object".to_owned(),
        "a string" => "a text in double quotes".to_owned(),
        "u64" | "usize" => "an integer of at least 0".to_owned(),
        "i64" => "an integer".to_owned(),
        "struct Header" | "struct Document" | "struct PlaneDocument" => {
            "an object with format, version and dimension".to_owned()
        }
        "struct Generator" => "an object with polynomial and root".to_owned(),
        "struct PolytopeEntry" => "an object with vertices, and faces in a solid".to_owned(),
        "enum Lattice" => "an object with gram or vectors".to_owned(),
        "enum Coordinates" => "\"fractional\" or \"cartesian\"".to_owned(),
        "a tuple of size 2" => "an array of two ends".to_owned(),
        "unit variant" => "a word".to_owned(),
        "newtype variant" => "an object with one member".to_owned(),
        _ => match name.split_once(' ') {
            Some(("string", text)) => format!("the text {text}"),
            Some(("integer", number)) => format!("the number {number}"),
            Some(("boolean", value)) => value.to_owned(),
            Some(("floating", rest)) => rest.replacen("point", "the number", 1),
            _ => name,
        },
    }
}

/// The name between backquotes after `start`.
fn quoted<'m>(message: &'m str, start: &str) -> Option<&'m str> {
    let rest = message.strip_prefix(start)?.strip_prefix('`')?;
    rest.split_once('`').map(|(name, _)| name)
}

/// The possible values of a missing member.
fn example(name: &str) -> &'static str {
    match name {
        "format" => {
            "; expected \"format\": \"acutile-tiling\" or \"acutile-points\", or a Structure of pymatgen with \
             \"lattice\" and \"sites\""
        }
        "version" => "; expected \"version\": 1",
        "dimension" => "; expected \"dimension\": 2 or 3",
        _ => "",
    }
}

/// The names that serde lists, without its backquotes.
fn choices(message: &str) -> String {
    match message.split_once(", expected ") {
        Some((_, choices)) => format!(", expected {}", choices.replace('`', "")),
        None => String::new(),
    }
}
