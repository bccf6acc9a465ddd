//! The cost of exactness, as ratios to a naive double-precision pass over the same data in the
//! same run: `cargo bench --bench ratios`.
//!
//! | file | holds |
//! |---|---|
//! | `main.rs` | which parts are asked for |
//! | `row` | a line of the table: measured, target, met or not |
//! | `clock` | the fastest of rounds, processor time, memory |
//! | `child` | this program started again, for one piece of work alone |
//! | `data` | the tilings that are measured |
//! | `naive` | the pass in doubles that proves nothing |
//! | `predicates`, `statements`, `quality`, `matching`, `whole`, `delaunay`, `classify`, `reading`, `verifier` | rows of the table |
//! | `parts` | the work of "whole" |
//! | `growth` | time and memory over four sizes |
//! | `instructions` | callgrind's counts of three fixed cases |
//! | `inputs` | files for the programs of others in `benches/peers` |
//!
//! `cargo bench --bench ratios -- NAME …` runs the parts of these names. `--lines` prints lines for
//! programs beside the table; `--inputs DIRECTORY` writes the files for the peers and
//! measures nothing. Work of one thread is run on one thread; "whole" and "classify" use all cores.

mod child;
mod classify;
mod clock;
mod data;
mod delaunay;
mod growth;
mod inputs;
mod instructions;
mod matching;
mod naive;
mod parts;
mod predicates;
mod quality;
mod reading;
mod row;
mod statements;
mod verifier;
mod whole;

use row::Table;

type Part = (&'static str, fn(&Table));

const PARTS: [Part; 11] = [
    ("predicates", predicates::measure),
    ("statements", statements::measure),
    ("quality", quality::measure),
    ("matching", matching::measure),
    ("whole", whole::measure),
    ("delaunay", delaunay::measure),
    ("classify", classify::measure),
    ("reading", reading::measure),
    ("verifier", verifier::measure),
    ("growth", growth::measure),
    ("instructions", instructions::measure),
];

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let Some(work) = child::asked_for() {
        return child::run(&work);
    }
    if let Some(at) = arguments.iter().position(|word| word == "--inputs") {
        let folder = arguments.get(at + 1).expect("--inputs DIRECTORY");
        return inputs::write(folder.as_ref()).expect("the directory can be written");
    }
    let is_name = |word: &&String| !word.starts_with('-');
    let named: Vec<&String> = arguments.iter().filter(is_name).collect();
    let known = |name: &&&String| PARTS.iter().all(|(part, _)| *part != name.as_str());
    if let Some(name) = named.iter().find(known) {
        let names = PARTS.map(|(part, _)| part).join(", ");
        eprintln!("there is no part {name}, expected some of {names}");
        std::process::exit(2);
    }
    let table = Table {
        for_programs: arguments.iter().any(|word| word == "--lines"),
    };
    for (name, measure) in PARTS {
        if named.is_empty() || named.iter().any(|word| *word == name) {
            one_thread(|| measure(&table));
        }
    }
}

/// Runs the work on one thread; children that use all cores decide for themselves.
fn one_thread(work: impl FnOnce() + Send) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.expect("a thread").install(work);
}
