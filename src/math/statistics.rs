//! Quantiles of probability distributions, by short approximations.

use super::fp;

/// Returns the quantile of the standard normal distribution: the number below which its values are with this probability.
/// The error is below 5e-4 (M. Abramowitz and I. Stegun, Handbook of Mathematical Functions, 1964, 26.2.23).
/// Probabilities closer to 0 or 1 than 1e-9 count as that.
pub fn normal_quantile(probability: f64) -> f64 {
    let tail = probability.min(1.0 - probability).max(1e-9);
    let t = (-2.0 * fp::ln(tail)).sqrt();
    let distance =
        t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    if probability < 0.5 { -distance } else { distance }
}

/// Returns the quantile of the chi-square distribution with these degrees of freedom, for the probability whose normal
/// quantile is `z_score`; 0 where the approximation is negative (E. Wilson and M. Hilferty, "The Distribution of
/// Chi-square", 1931).
pub fn chi_square_quantile(degrees_of_freedom: f64, z_score: f64) -> f64 {
    let variance = 2.0 / (9.0 * degrees_of_freedom);
    let root = (1.0 - variance + z_score * variance.sqrt()).max(0.0);
    degrees_of_freedom * root * root * root
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With the tables of Abramowitz and Stegun, 26.1 and 26.8.
    #[test]
    fn quantiles_are_those_of_tables() {
        for (probability, quantile) in [(0.5, 0.0), (0.1, -1.28155), (0.99, 2.32635), (0.001, -3.09023)] {
            assert!((normal_quantile(probability) - quantile).abs() < 5e-4, "{probability}");
        }
        for (degrees, probability, quantile) in
            [(10.0, 0.1, 4.86518), (10.0, 0.5, 9.34182), (30.0, 0.01, 14.9535), (100.0, 0.9, 118.498)]
        {
            let found = chi_square_quantile(degrees, normal_quantile(probability));
            assert!((found / quantile - 1.0).abs() < 4e-3, "{degrees} {probability}: {found}");
        }
    }

    #[test]
    fn certain_probabilities_have_finite_quantiles() {
        for probability in [0.0, 1.0, -1.0, 2.0] {
            assert!(normal_quantile(probability).is_finite(), "{probability}");
        }
        assert_eq!(chi_square_quantile(1.0, normal_quantile(0.0)), 0.0);
    }
}
