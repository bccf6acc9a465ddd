//! How a reader checks the certificate again.

use super::subject::Subject;
use super::tex::escape;

/// The paragraph on the certificate of a subject.
pub fn recheck(subject: &Subject) -> String {
    let path = subject.certificate_path();
    let digest = &subject.sha256;
    let (first, second) = digest.split_at(digest.len() / 2);
    format!(
        "\\acutileparagraph{{The certificate}} with the SHA-256\n% acutile:sha256 {slug} {digest}\n\
         \\begin{{center}}\\ttfamily\\small {first}\\\\ {second}\\end{{center}}\n\
         lists all tiles; {json} is the same for people. The command\n\
         \\begin{{center}}\\ttfamily\\small acutile-verify {path}\\end{{center}}\n\
         of version {version} checks it without any of the code that found it, and says what it has verified~\\cite{{acutile}}.\n\n",
        path = escape(&path),
        json = format_args!("\\texttt{{{}}}", escape(&subject.json_path())),
        slug = subject.slug(),
        version = env!("CARGO_PKG_VERSION"),
    )
}
