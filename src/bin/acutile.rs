//! The program `acutile`; everything it does is in [`acutile::cli`].

fn main() -> std::process::ExitCode {
    std::process::ExitCode::SUCCESS
}
