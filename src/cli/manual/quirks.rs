//! Manual page about POV-Ray's quirks.

use crate::quirks::{Quirk, Status, TOPICS, Topic};

const INTRODUCTION: &str = "POV-Ray's manual does not describe everything that scenes rely on. This page lists behaviour of POV-Ray 3.7 that \
     was found by running it. durer does the same, except where an entry says that it differs on purpose.";

pub(super) fn quirks_page() -> String {
    INTRODUCTION.to_string() + "\n\n" + TOPICS.iter().map(topic).collect::<String>().trim_end() + "\n"
}

fn topic(topic: &Topic) -> String {
    let rows: String = topic.quirks.iter().map(row).collect();
    format!("## {}\n\n{rows}\n", topic.title)
}

fn row(quirk: &Quirk) -> String {
    match quirk.status {
        Status::Emulated => format!("- **`{}`**: {}\n", quirk.id, quirk.summary),
        Status::Differs(instead) => {
            format!("- **`{}`**: {} *durer differs on purpose:* {instead}\n", quirk.id, quirk.summary)
        }
    }
}
