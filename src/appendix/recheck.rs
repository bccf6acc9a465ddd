//! How a reader checks the certificate again.

use super::subject::Subject;
use super::tex::escape;

/// The paragraph on the certificate of a subject.
pub fn recheck(subject: &Subject) -> String {
    let path = subject.certificate_path();
    let digest = subject.verified.sha256();
    let (first, second) = digest.split_at(digest.len() / 2);
    format!(
        "\\paragraph{{The certificate}} is the file \\texttt{{{path}}} with the SHA-256\n% acutile:sha256 {slug} {digest}\n\
         \\begin{{center}}\\ttfamily\\small {first}\\\\ {second}\\end{{center}}\n\
         It holds all of the above for all tiles. \\texttt{{acutile-verify {path}}}, version {version}, checks it without any of the code that found it and says what it \
         has verified~\\cite{{acutile}}.\n\n",
        path = escape(&path),
        slug = subject.slug(),
        version = env!("CARGO_PKG_VERSION"),
    )
}
