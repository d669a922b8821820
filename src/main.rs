//! The command `durer`; see [`durer::cli`].

fn main() -> std::process::ExitCode {
    durer::cli::main(std::env::args_os().collect())
}
