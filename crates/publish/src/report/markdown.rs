//! The project's documents as HTML: headings get names, links and images lead inside the site or are
//! left out.

use super::formulas::marked;
use super::html::escape;
use pulldown_cmark::{
    Alignment, CowStr, Event, Options, Parser, Tag, TagEnd, TextMergeStream, html,
};
use std::collections::BTreeMap;

/// A document of the project.
#[derive(Clone, Copy, Debug)]
pub struct Document {
    /// Where it stands in the repository.
    pub path: &'static str,
    /// Where it stands in the site.
    pub page: &'static str,
    /// The title in lists and in the page's head.
    pub title: &'static str,
    /// The document in Markdown.
    pub text: &'static str,
    /// Whether it has formulas in its running text, as proofs have.
    pub has_formulas: bool,
}

impl Document {
    /// The same document, with formulas in its text.
    pub const fn with_formulas(self) -> Document {
        Document {
            has_formulas: true,
            ..self
        }
    }
}

/// A document's text as HTML. `target` gives for a path of the repository the link from this document's
/// page to it, or `None` if the site does not have it. Then the words stay without a link.
pub fn to_html(document: &Document, target: impl Fn(&str) -> Option<String>) -> String {
    let options = Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES;
    let parser = TextMergeStream::new(Parser::new_ext(document.text, options));
    let mut events: Vec<Event> = parser.collect();
    name_headings(&mut events);
    let mut open = Vec::new();
    events.retain_mut(|event| match event {
        Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
            let link = resolve(document.path, dest_url, &target);
            open.push(link.is_some());
            if let Some(link) = &link {
                *dest_url = CowStr::from(link.clone());
            }
            link.is_some()
        }
        Event::End(TagEnd::Link | TagEnd::Image) => open.pop().unwrap_or(false),
        // The project's documents contain no HTML; characters that look like it are text.
        Event::Html(text) | Event::InlineHtml(text) => {
            *event = Event::Html(CowStr::from(escape(text)));
            true
        }
        _ => true,
    });
    if document.has_formulas {
        mark_formulas(&mut events);
    }
    render(events)
}

/// Formulas outside of headings and blocks of code become MathML.
fn mark_formulas(events: &mut [Event]) {
    let mut is_plain = true;
    for event in events {
        match event {
            Event::Start(Tag::CodeBlock(_) | Tag::Heading { .. }) => is_plain = false,
            Event::End(TagEnd::CodeBlock | TagEnd::Heading(_)) => is_plain = true,
            Event::Text(text) if is_plain => *event = Event::InlineHtml(marked(text).into()),
            _ => {}
        }
    }
}

/// HTML without style attributes, which the site's content security policy forbids: columns are
/// aligned by the style sheet.
fn render(mut events: Vec<Event>) -> String {
    for event in &mut events {
        if let Event::Start(Tag::Table(alignments)) = event {
            alignments.fill(Alignment::None);
        }
    }
    let mut page = String::new();
    html::push_html(&mut page, events.into_iter());
    reachable(&page)
}

/// Code and tables scroll where they are too wide, so the keyboard has to reach them. A heading without words is none. In the text of
/// a page these marks are escaped.
fn reachable(page: &str) -> String {
    page.replace(
        "<pre>",
        "<pre tabindex=\"0\" role=\"group\" aria-label=\"Code\">",
    )
    .replace(
        "<table>",
        "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Table\"><table>",
    )
    .replace("</table>", "</table></div>")
    .replace("<th></th>", "<td></td>")
}

/// Links to the outside and within the page stay; others are looked up by their path.
fn resolve(from: &str, link: &str, target: impl Fn(&str) -> Option<String>) -> Option<String> {
    if link.starts_with('#') || link.starts_with("https://") || link.starts_with("http://") {
        return Some(link.to_owned());
    }
    let (path, fragment) = match link.split_once('#') {
        Some((path, fragment)) => (path, format!("#{fragment}")),
        None => (link, String::new()),
    };
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            ".." => drop(parts.pop()),
            "." | "" => {}
            part => parts.push(part),
        }
    }
    target(&parts.join("/")).map(|link| link + &fragment)
}

/// Gives every heading the anchor that other sites give it: lower case, blanks as hyphens, other signs left
/// out. A second heading with the same words gets a number.
fn name_headings(events: &mut [Event]) {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for start in 0..events.len() {
        if !matches!(events[start], Event::Start(Tag::Heading { .. })) {
            continue;
        }
        let words: String = events[start..]
            .iter()
            .take_while(|event| !matches!(event, Event::End(TagEnd::Heading(_))))
            .filter_map(|event| match event {
                Event::Text(text) | Event::Code(text) => Some(text.as_ref()),
                _ => None,
            })
            .collect();
        let plain = slug(&words);
        let count = seen.entry(plain.clone()).or_insert(0);
        let name = if *count == 0 {
            plain
        } else {
            format!("{plain}-{count}")
        };
        *count += 1;
        if let Event::Start(Tag::Heading { id, .. }) = &mut events[start] {
            *id = Some(CowStr::from(name));
        }
    }
}

fn slug(words: &str) -> String {
    let kept = words
        .chars()
        .filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase)
        .map(|c| if c == ' ' { '-' } else { c })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Document, to_html};

    #[test]
    fn what_scrolls_has_the_focus() {
        let document = Document {
            path: "a.md",
            page: "docs/a.html",
            title: "A",
            text: "| | b |\n|---|---|\n| c | `<table>` |\n\n```\n<pre>\n```\n",
            has_formulas: false,
        };
        assert_eq!(
            to_html(&document, |_| None),
            "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Table\"><table><thead><tr><td></td><th>b</th></tr></thead><tbody>\n\
             <tr><td>c</td><td><code>&lt;table&gt;</code></td></tr>\n</tbody></table></div>\n\
             <pre tabindex=\"0\" role=\"group\" aria-label=\"Code\"><code>&lt;pre&gt;\n</code></pre>\n"
        );
    }
}
