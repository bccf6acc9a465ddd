//! The program `acutile`; everything it does is in [`acutile::cli`].

fn main() -> std::process::ExitCode {
    acutile::cli::main()
}
