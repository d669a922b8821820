//! The functions of functions.inc, compared with POV-Ray 3.7: `regenerate.py` beside `tests/internals/values.txt`
//! writes the values.

use durer::function::Interval;
use durer::function::internal::{self, Internal, TABLE};
use proptest::prelude::*;

/// Name, arguments and POV-Ray's value.
fn rows() -> impl Iterator<Item = (&'static str, Vec<f64>, f64)> {
    include_str!("../internals/values.txt").lines().map(|line| {
        let mut words = line.split(' ');
        let name = words.next().unwrap();
        let mut numbers: Vec<f64> = words.map(|w| w.parse().unwrap()).collect();
        let value = numbers.pop().unwrap();
        (name, numbers, value)
    })
}

fn named(name: &str) -> &'static Internal {
    TABLE.iter().find(|row| row.name == name).unwrap_or_else(|| panic!("{name} is missing"))
}

#[test]
fn values_match_povray() {
    let mut wrong = Vec::new();
    let mut worst: f64 = 0.0;
    for (name, arguments, value) in rows() {
        let ours = (named(name).compute)(&arguments);
        let error = (ours - value).abs() / value.abs().max(1.0);
        if ours.to_bits() == value.to_bits() || ours.is_nan() && value.is_nan() || error <= 1e-9 {
            worst = if error.is_finite() { worst.max(error) } else { worst };
        } else {
            wrong.push(format!("{name} {arguments:?}: {ours} instead of {value}"));
        }
    }
    assert!(rows().count() > 900);
    println!("largest error {worst:.1e}");
    assert!(wrong.is_empty(), "{} differ:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn every_row_is_tested_and_takes_its_parameters() {
    for (i, row) in TABLE.iter().enumerate() {
        assert!(i == 0 || TABLE[i - 1].number < row.number, "{} is out of order", row.name);
        assert!(std::ptr::eq(internal::find_internal(row.number).unwrap(), row));
        let count = rows().find(|(name, ..)| *name == row.name).map(|(_, arguments, _)| arguments.len());
        assert_eq!(count, Some(3 + row.parameters.len()), "{}", row.name);
        assert!((row.compute)(&[]).is_nan());
    }
}

#[test]
fn extreme_arguments_do_not_panic() {
    let strange = [f64::NAN, f64::INFINITY, -f64::INFINITY, f64::MAX, 0.0, -0.0, -1e300, 1e-300];
    for row in TABLE {
        for (i, first) in strange.iter().enumerate() {
            let arguments: Vec<f64> = (0..3 + row.parameters.len()).map(|k| strange[(i + k) % strange.len()]).collect();
            (row.compute)(&arguments);
            (row.compute)(&vec![*first; arguments.len()]);
        }
    }
}

proptest! {
    #[test]
    fn values_are_in_bounds(
        corner in prop::collection::vec(-2.0..2.0f64, 13),
        size in prop::collection::vec(0.0..1.0f64, 13),
        inside in prop::collection::vec(prop::collection::vec(0.0..=1.0f64, 13), 4),
        fixed in any::<bool>(),
    ) {
        for row in TABLE {
            let Some(bounds) = row.bounds else { continue };
            let count = 3 + row.parameters.len();
            let width = |k: usize| if k >= 3 && fixed { 0.0 } else { size[k] };
            let low = |k: usize| if k >= 3 && fixed { corner[k].abs() } else { corner[k] };
            let intervals: Vec<Interval> = (0..count).map(|k| Interval::new(low(k), low(k) + width(k))).collect();
            let range = bounds(&intervals);
            for t in &inside {
                let point: Vec<f64> = (0..count).map(|k| low(k) + t[k] * width(k)).collect();
                let value = (row.compute)(&point);
                prop_assert!(value.is_nan() || range.contains(value), "{} {point:?}: {value} outside {range:?}", row.name);
            }
        }
    }
}
