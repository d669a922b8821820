//! Bracketing of a function's change of sign.

/// Returns the root x of a function between two points `(x, f(x))` with values of different signs, to this `accuracy`:
/// by the "Illinois" variant of regula falsi (Dowell and Jarratt, 1971), and by bisection where that does not converge.
/// At a jump of the function, the result is just after the jump.
pub fn root_between(
    function: &dyn Fn(f64) -> f64,
    (mut a, mut fa): (f64, f64),
    (mut b, mut fb): (f64, f64),
    accuracy: f64,
) -> f64 {
    let before = fa < 0.0;
    let mut last = a;
    for step in 0..80 {
        let mut s = b - fb * (b - a) / (fb - fa);
        if step > 20 || !(s > a.min(b) && s < a.max(b)) {
            s = 0.5 * (a + b);
        }
        let fs = function(s);
        if (b - a).abs() <= accuracy {
            return a.max(b);
        }
        let is_behind = (fs < 0.0) != before;
        if fs == 0.0 || ((s - last).abs() <= accuracy && (is_behind || (s - a.max(b)).abs() > accuracy)) {
            return s;
        }
        if (fs < 0.0) == (fb < 0.0) {
            fa *= 0.5;
        } else {
            (a, fa) = (b, fb);
        }
        (b, fb) = (s, fs);
        last = s;
    }
    b
}
