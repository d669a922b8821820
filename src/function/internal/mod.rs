//! The functions behind `functions.inc`: `function { internal(N) }` (manual, "functions.inc").

use std::fmt;

/// One of them.
pub struct Internal {
    /// What `internal( )` takes.
    pub number: u32,
    /// As `functions.inc` calls it.
    pub name: &'static str,
    /// How many numbers it takes beside x, y and z.
    pub parameters: usize,
    /// x, y, z and the parameters.
    pub compute: fn(&[f64]) -> f64,
}

impl fmt::Debug for Internal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// The function of this number.
pub fn find(number: u32) -> Option<&'static Internal> {
    TABLE.iter().find(|row| row.number == number)
}

const TABLE: &[Internal] = &[
    Internal { number: 57, name: "f_r", parameters: 0, compute: |a| (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt() },
    Internal {
        number: 61,
        name: "f_sphere",
        parameters: 1,
        compute: |a| (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt() - a[3],
    },
];
