//! The command `durer`; see [`durer::cli`].

/// Memory of the program, counted for `--max-memory`.
#[global_allocator]
static MEMORY: durer::cli::Metered = durer::cli::Metered;

fn main() -> std::process::ExitCode {
    durer::cli::main(std::env::args_os().collect())
}
