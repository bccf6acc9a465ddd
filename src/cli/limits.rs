//! The kernel's limits as options of the commands that verify.

use super::integer::integer_in;
use acutile_kernel::Limits;
use clap::Args;

/// Limits of the kernel, beyond which a certificate is declined.
#[derive(Clone, Debug, Args)]
pub struct LimitArguments {
    /// The largest size of a certificate in bytes
    #[arg(help_heading = "Limits of the kernel", long, value_name = "N", default_value_t = Limits::DEFAULT.bytes)]
    pub max_bytes: u64,
    /// The largest number of simplices of a certificate
    #[arg(help_heading = "Limits of the kernel", long, value_name = "N", default_value_t = Limits::DEFAULT.simplices)]
    pub max_simplices: u64,
    /// The largest number of bits of an integer
    #[arg(help_heading = "Limits of the kernel", long, value_name = "N", default_value_t = Limits::DEFAULT.bits)]
    pub max_bits: u64,
    /// The largest degree of the field
    #[arg(help_heading = "Limits of the kernel", long, value_name = "N", default_value_t = Limits::DEFAULT.degree, value_parser = integer_in::<usize>(0..=Limits::DEFAULT.degree as u64))]
    pub max_degree: usize,
    /// The largest work of the kernel, in units of about a nanosecond: N for a certificate, and N more for
    /// each MiB of it
    #[arg(help_heading = "Limits of the kernel", long, value_name = "N", default_value_t = Limits::DEFAULT.work)]
    pub max_work: u64,
}

impl LimitArguments {
    /// The options that allow more than `acutile-verify` does without options; none if all limits are the
    /// usual ones. A reader of the certificate may have to give them.
    pub fn raised(&self) -> Option<String> {
        let usual = Limits::DEFAULT;
        let limits = [
            ("--max-bytes", self.max_bytes, usual.bytes),
            ("--max-simplices", self.max_simplices, usual.simplices),
            ("--max-bits", self.max_bits, usual.bits),
            ("--max-work", self.max_work, usual.work),
        ];
        let raised = limits.iter().filter(|(_, given, usual)| given > usual);
        let raised: Vec<String> = raised.map(|(name, n, _)| format!("{name} {n}")).collect();
        (!raised.is_empty()).then(|| raised.join(" "))
    }

    /// As the kernel takes them.
    pub fn limits(&self) -> Limits {
        Limits {
            bytes: self.max_bytes,
            simplices: self.max_simplices,
            bits: self.max_bits,
            degree: self.max_degree,
            work: self.max_work,
        }
    }
}
