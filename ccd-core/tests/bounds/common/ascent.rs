//! A directed search for the greatest ratio of error to bound: over inputs by hill climbing, over
//! the choices of an adversary by the sign of each operation's effect.

use super::adversary::under;
use super::random::Random;

/// What an ascent has reached.
#[derive(Clone, Debug)]
pub struct Peak {
    pub ratio: f64,
    pub inputs: Vec<f64>,
}

/// A function of inputs in `[-1, 1]`, in adversarial arithmetic: an error, with its sign, as a
/// multiple of its bound.
pub struct Ascent<F> {
    pub n_inputs: usize,
    pub flush: bool,
    pub ratio: F,
}

impl<F: Fn(&[f64]) -> f64> Ascent<F> {
    /// The ratio under the choices that raise it most: to first order an error is a sum of
    /// independent effects, so the sign of each alone is the best choice for all together.
    pub fn worst(&self, inputs: &[f64]) -> f64 {
        let run = |choices: &[i8]| {
            let (ratio, n) = under(choices, self.flush, || (self.ratio)(inputs));
            (if ratio.is_nan() { f64::NEG_INFINITY } else { ratio }, n)
        };
        let (base, n) = run(&[]);
        if !base.is_finite() {
            return base;
        }
        let mut choices = vec![0i8; n];
        let mut best = vec![0i8; n];
        for i in 0..n {
            choices[i] = 1;
            let effect = run(&choices).0 - base;
            choices[i] = 0;
            best[i] = (effect > 0.0) as i8 - (effect < 0.0) as i8;
        }
        let opposite: Vec<i8> = best.iter().map(|c| -c).collect();
        run(&best).0.max(run(&opposite).0).max(base)
    }

    /// Climbs from several random places.
    pub fn climb(&self, seed: u64, starts: usize, steps: usize) -> Peak {
        let mut random = Random::new(seed);
        let mut peak = Peak { ratio: f64::NEG_INFINITY, inputs: Vec::new() };
        for _ in 0..starts {
            let mut x: Vec<f64> = (0..self.n_inputs).map(|_| random.between(-1.0, 1.0)).collect();
            let mut at = self.worst(&x);
            for _ in 0..steps {
                let mut y = x.clone();
                for _ in 0..1 + random.below(3) {
                    let i = random.below(y.len());
                    y[i] = match random.below(6) {
                        0 => random.sign(),
                        1 => 0.0,
                        2 => random.between(-1.0, 1.0),
                        3 => y[random.below(y.len())],
                        _ => (y[i] + random.sign() * random.power(-12.0, 0.0)).clamp(-1.0, 1.0),
                    };
                }
                let ratio = self.worst(&y);
                if ratio >= at {
                    (x, at) = (y, ratio);
                }
            }
            if at > peak.ratio {
                peak = Peak { ratio: at, inputs: x };
            }
        }
        peak
    }

    /// Asserts that the bound holds, and that the search comes at least as near to it as the
    /// documents say.
    pub fn check(&self, name: &str, seed: u64, [starts, steps]: [usize; 2], documented: f64) {
        let Peak { ratio, inputs } = self.climb(seed, starts, steps);
        println!("{name}: {ratio:.4}");
        assert!(ratio <= 1.0, "{name}: the error is {ratio} of its bound at {inputs:?}");
        assert!(ratio >= documented, "{name}: {ratio}, but {documented} is documented");
    }
}
