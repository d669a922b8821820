use super::record::{MAX_PART, SUM};
use super::*;
use crate::scene::LightKind;
use crate::source::{ContentHash, FileKind, Lookup, ReadFiles};

fn work(options: &str) -> Work {
    Work {
        options: options.into(),
        files: ReadFiles::from([("a.pov".into(), ContentHash::of(b"7"))]),
        lookups: [("a.inc".into(), vec![Lookup::Kind(None)])].into(),
        now: None,
    }
}

/// Returns a tile at column `x`, of the first pass for an even column, else of the second.
fn tile(x: usize) -> Tile {
    Tile { pass: (x % 2) as u8, area: Region { x, y: 3, width: 2, height: 1 } }
}

fn pixels(x: usize) -> Vec<[f32; 4]> {
    vec![[x as f32, f32::NAN, -0.0, 1.5], [f32::INFINITY; 4]]
}

fn at(path: &Path) -> Journal {
    Journal::new(Exclusive::open(path).unwrap())
}

/// Returns the reason why a journal cannot be continued.
fn reason(path: &Path, work: &Work) -> String {
    at(path).resume(work).err().unwrap_or_default()
}

fn written(path: &Path, work: Work) -> Vec<u8> {
    let journal = at(path);
    journal.begin(work, Duration::ZERO);
    (0..9).for_each(|x| journal.store_tile(tile(x), &pixels(x)));
    assert_eq!(journal.write_pending_returning_path(), Some(path));
    std::fs::read(path).unwrap()
}

fn header_length(journal: &[u8]) -> usize {
    journal.iter().position(|&b| b == b'\n').unwrap() + 1
}

#[test]
fn records_before_a_cut_are_known() {
    let folder = tempfile::tempdir().unwrap();
    let path = journal_path(&folder.path().join("a.png"));
    let whole = written(&path, work("a"));
    let header = header_length(&whole);
    let size = (whole.len() - header) / 9;
    for end in (header..=whole.len()).filter(|end| end % 11 == 0 || (end - header).is_multiple_of(size)) {
        // A power loss may leave zeros in place of the rest.
        let lost = Some(whole.len() - end).filter(|lost| *lost >= SUM && lost % 2 == 0).unwrap_or(0);
        std::fs::write(&path, [&whole[..end], &vec![0; lost]].concat()).unwrap();
        let journal = at(&path);
        journal.resume(&work("a")).unwrap();
        for x in 0..9 {
            let known = journal.load_tile(tile(x)).map(|p| format!("{p:?}"));
            assert_eq!(known, (x < (end - header) / size).then(|| format!("{:?}", pixels(x))));
        }
        let missing = (0..9).filter(|x| journal.load_tile(tile(*x)).is_none());
        missing.for_each(|x| journal.store_tile(tile(x), &pixels(x)));
        journal.write_pending_returning_path();
        assert!(std::fs::read(&path).unwrap() == whole);
    }
}

#[test]
fn damage_and_other_work_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    let whole = written(&path, work("a"));
    assert_eq!(reason(&path, &work("b")), "it was rendered with other options");
    let changed = Work { files: ReadFiles::from([("a.pov".into(), ContentHash::of(b"8"))]), ..work("a") };
    assert_eq!(reason(&path, &changed), "`a.pov` has changed");
    let lookup = Lookup::Kind(Some(FileKind::File));
    let changed = Work { lookups: [("a.inc".into(), vec![lookup])].into(), ..work("a") };
    assert_eq!(reason(&path, &changed), "the scene has changed: `a.inc` exists now");
    let changed = Work { now: Some(Duration::ZERO), ..work("a") };
    assert_eq!(reason(&path, &changed), "the scene uses `now`, which has changed");
    for at in (whole.len() - 48..whole.len()).step_by(5) {
        let mut bytes = whole.clone();
        bytes[at] ^= 4;
        std::fs::write(&path, bytes).unwrap();
        assert_eq!(reason(&path, &work("a")), "it is damaged", "{at}");
    }
    std::fs::write(&path, "{}\n").unwrap();
    assert_eq!(reason(&path, &work("a")), "it is damaged");
    std::fs::write(&path, "{\"program\": \"durer 0\"}\n").unwrap();
    assert_eq!(reason(&path, &work("a")), "it is from another version of durer");
}

#[test]
fn records_are_valid_in_their_own_place_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    let (mine, other) = (written(&path, work("a")), written(&path, work("b")));
    let (header, size) = (header_length(&mine), (mine.len() - header_length(&mine)) / 9);
    let is_damaged = |bytes: Vec<u8>| {
        std::fs::write(&path, bytes).unwrap();
        reason(&path, &work("a")) == "it is damaged"
    };
    assert!(!is_damaged(mine.clone()));
    assert!(is_damaged([&mine[..header], &other[header..]].concat()));
    // The last record is that of the other journal.
    assert!(is_damaged([&mine[..mine.len() - size], &other[other.len() - size..]].concat()));
    // Two records have changed places; the first one is there twice.
    let (first, second) = (&mine[header..header + size], &mine[header + size..header + 2 * size]);
    assert!(is_damaged([&mine[..header], second, first].concat()));
    assert!(is_damaged([&mine[..header], first, first].concat()));
    // A changed header belongs to no record.
    let text = String::from_utf8_lossy(&mine[..header]).replace("\"now\":null", "\"now\": null");
    assert!(is_damaged([text.as_bytes(), &mine[header..]].concat()));
}

/// Stores photons or radiosity samples in the journal, and writes their bytes in pieces of different lengths.
fn store(journal: &Journal, kind: LightKind, bytes: &[u8]) {
    journal.store_light(kind, &|out| {
        let (first, rest) = bytes.split_at(bytes.len() / 3);
        out.write_all(first)?;
        rest.chunks(MAX_PART / 2 + 7).try_for_each(|piece| out.write_all(piece))
    });
}

#[test]
fn light_is_read_as_it_was_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    for length in [1, 100, MAX_PART - 1, MAX_PART, 2 * MAX_PART + 1] {
        let light = |factor: usize| (0..length).map(|i| (i * factor % 251) as u8).collect::<Vec<_>>();
        let _ = std::fs::remove_file(&path);
        let journal = at(&path);
        journal.begin(work("a"), Duration::ZERO);
        store(&journal, LightKind::Radiosity, &light(3));
        journal.store_tile(tile(0), &pixels(0));
        store(&journal, LightKind::Photons, &light(7));
        assert!(journal.write_pending_returning_path().is_some() && journal.finished_tiles_and_offsets() == Ok(vec![]));
        drop(journal);
        let journal = at(&path);
        journal.resume(&work("a")).unwrap();
        assert!(journal.has_light() && journal.load_tile(tile(0)).is_some());
        assert!(journal.load_light(LightKind::Photons) == Some(light(7)), "{length}");
        assert!(journal.load_light(LightKind::Radiosity) == Some(light(3)), "{length}");
        // Light that is stored again replaces the light of before.
        store(&journal, LightKind::Photons, &light(11));
        drop(journal);
        let journal = at(&path);
        journal.resume(&work("a")).unwrap();
        assert!(journal.load_light(LightKind::Photons) == Some(light(11)), "{length}");
    }
}

#[test]
fn light_that_is_cut_off_is_shorter() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    let journal = at(&path);
    journal.begin(work("a"), Duration::ZERO);
    let light = vec![5; MAX_PART + 100];
    store(&journal, LightKind::Photons, &light);
    drop(journal);
    let whole = std::fs::read(&path).unwrap();
    for (missing, length) in [(1, Some(MAX_PART)), (HEAD + 100 + SUM, Some(MAX_PART)), (200, None)] {
        std::fs::write(&path, &whole[..whole.len() - missing]).unwrap();
        let journal = at(&path);
        journal.resume(&work("a")).unwrap();
        assert_eq!(journal.load_light(LightKind::Photons).map(|light| light.len()), length, "{missing}");
    }
    for at in (whole.len() - 140..whole.len()).step_by(9) {
        let mut bytes = whole.clone();
        bytes[at] ^= 4;
        std::fs::write(&path, bytes).unwrap();
        assert_eq!(reason(&path, &work("a")), "it is damaged", "{at}");
    }
}

#[test]
fn light_that_cannot_be_written_leaves_room_for_tiles() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    let journal = at(&path);
    journal.begin(work("a"), Duration::ZERO);
    journal.store_light(LightKind::Photons, &|out| {
        out.write_all(&vec![5; 2 * MAX_PART])?;
        Err(io::Error::other("the disk is full"))
    });
    (0..9).for_each(|x| journal.store_tile(tile(x), &pixels(x)));
    assert_eq!(journal.write_pending_returning_path(), Some(&*path));
    assert_eq!((journal.failure(), journal.light_failure().as_deref()), (None, Some("the disk is full")));
    let note = "cannot write photons or radiosity samples to the resume journal: the disk is full\n";
    assert_eq!(failure_note(&journal).as_deref(), Some(note));
    drop(journal);
    let other = folder.path().join("b");
    assert!(written(&other, work("a")) == std::fs::read(&path).unwrap());
}

#[test]
fn journals_without_tiles_leave_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    let journal = at(&path);
    journal.begin(work("a"), Duration::from_secs(9));
    journal.store_tile(tile(0), &pixels(0));
    assert!(path.exists() && journal.write_pending_returning_path().is_none());
    drop(journal);
    assert!(!path.exists());
}

/// Each thread deletes the file that it has locked. No other thread may lock the deleted file.
#[test]
fn deleted_files_are_not_locked() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    let users = std::sync::atomic::AtomicI32::new(0);
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                for _ in 0..2000 {
                    if let Ok(file) = Exclusive::open(&path) {
                        let others = users.fetch_add(1, std::sync::atomic::Ordering::SeqCst);
                        assert_eq!(others, 0);
                        users.fetch_sub(1, std::sync::atomic::Ordering::SeqCst);
                        drop(file);
                    }
                }
            });
        }
    });
}
