//! The project's documents as HTML: headings get names, links and images lead inside the site or are
//! left out.

use super::html::escape;
use pulldown_cmark::{Alignment, CowStr, Event, Options, Parser, Tag, TagEnd, html};
use std::collections::BTreeMap;

/// A document of the project.
#[derive(Clone, Copy, Debug)]
pub struct Document {
    /// Where it stands in the repository.
    pub path: &'static str,
    /// Where it stands in the site.
    pub page: &'static str,
    pub title: &'static str,
    pub text: &'static str,
}

/// A document's text as HTML. `target` gives for a path of the repository the link from this
/// document's page to it, or `None` where the site does not have it; then the words stay and the
/// link goes.
pub fn to_html(document: &Document, target: impl Fn(&str) -> Option<String>) -> String {
    let options = Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES;
    let mut events: Vec<Event> = Parser::new_ext(document.text, options).collect();
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
        // Our own documents have no markup in them; what looks like it is text.
        Event::Html(text) | Event::InlineHtml(text) => {
            *event = Event::Html(CowStr::from(escape(text)));
            true
        }
        _ => true,
    });
    render(events)
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
    page
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

/// Gives every heading the name that its readers on other sites know: lower case, blanks as
/// hyphens, other signs left out; a second one of the same words gets a number.
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
