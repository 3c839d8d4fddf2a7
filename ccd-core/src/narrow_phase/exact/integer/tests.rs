//! Integers beside those of `num-bigint`.

use super::*;
use crate::random::Random;
use alloc::vec::Vec;
use num_bigint::{BigInt, Sign};
use num_traits::{One, Signed};

type Fixed<const N: usize> = Integer<[u64; N]>;

fn value<W: Words>(x: &Integer<W>) -> BigInt {
    assert!(x.words().last() != Some(&0) && x.is_exact());
    let bytes: Vec<u8> = x.words().iter().flat_map(|word| word.to_le_bytes()).collect();
    let sign = if x.negative { Sign::Minus } else { Sign::Plus };
    BigInt::from_bytes_le(sign, &bytes)
}

/// Sums of products of up to 4 words with random ones, and the same as `num-bigint` has them.
fn check_operations<W: Words>(mut random: Random) {
    for _ in 0..2000 {
        let mut one = || {
            let parts = [(); 2].map(|()| (random.bits() as i64) >> random.below(64));
            let shifts = [(); 2].map(|()| random.below(70));
            let x = Integer::<W>::new(parts[0], shifts[0]) + Integer::new(parts[1], shifts[1]);
            let [p, q] = [0, 1].map(|i| BigInt::from(parts[i]) << shifts[i]);
            assert_eq!(value(&x), &p + &q);
            (x, p + q)
        };
        let [(a, p), (b, q), (c, r)] = [one(), one(), one()];
        assert_eq!(value(&(&a * &b)), &p * &q);
        assert_eq!(value(&(&a * &b + &c)), &p * &q + &r);
        assert_eq!(value(&(&a * &b - &c)), &p * &q - &r);
        assert_eq!(value(&(&a - &b * &c)), &p - &q * &r);
        for (negated, want) in [(false, &r + &p * &q), (true, &r - &p * &q)] {
            let mut sum = c.clone();
            sum.add_product(&a, &b, negated);
            assert_eq!(value(&sum), want);
            sum.add_product(&a, &b, !negated);
            assert_eq!(value(&sum), r);
            sum.add_product(&-c.clone(), &Integer::new(1, 0), false);
            assert_eq!(value(&sum), BigInt::ZERO);
        }
        let square = &a * &a - &b * &b;
        assert_eq!(value(&square), (&p + &q) * (&p - &q));
        assert_eq!(value(&(square - (&a + &b) * (&a - &b))), BigInt::ZERO);
        let product = &a * &b;
        assert_eq!(BigInt::from(product.sign()), (&p * &q).signum());
        assert_eq!(product.bits() as u64, (&p * &q).bits());
        if b.sign() != 0 {
            let (of, by) = (&product + &c, b);
            let [quotient, rest] = of.divided(&by);
            let (of, by) = (value(&of).abs(), value(&by).abs());
            assert_eq!((value(&quotient), value(&rest)), (&of / &by, &of % &by));
        }
    }
}

#[test]
fn it_computes_as_others_do() {
    check_operations::<[u64; 8]>(Random::new(5));
    #[cfg(feature = "alloc")]
    check_operations::<Vec<u64>>(Random::new(7));
}

/// Thousands of bits.
#[cfg(feature = "alloc")]
#[test]
fn long_ones_are_as_others_are() {
    let (mut x, mut y) = (Integer::<Vec<u64>>::new(-3, 0), BigInt::from(-3));
    for k in 0..10 {
        x = &x * &x - x.shifted(1000 * k) + Integer::new(1, k);
        y = &y * &y - (&y << (1000 * k)) + (BigInt::one() << k);
        assert_eq!(value(&x), y);
    }
    assert!(x.bits() > 100_000);
}

#[test]
fn what_does_not_fit_is_marked() {
    let most = || Fixed::<1>::new(i64::MIN, 0);
    let power = |k: u32| Fixed::<1>::new(1, k);
    assert!((most() + -power(0)).is_exact() && !(most() + most()).is_exact());
    assert!(!(most() * most()).is_exact() && !most().shifted(1).is_exact());
    assert!((most() * power(0)).is_exact());
    let sum = |mut x: Fixed<1>, a: &Fixed<1>, b: &Fixed<1>, negated: bool| {
        x.add_product(a, b, negated);
        x.is_exact()
    };
    assert!(sum(most(), &most(), &power(0), true) && !sum(most(), &most(), &power(0), false));
    assert!(sum(Fixed::ZERO, &power(31), &power(32), false));
    assert!(!sum(Fixed::ZERO, &power(32), &power(32), true));
    assert!(!sum(most() + most(), &Fixed::ZERO, &Fixed::ZERO, false));
    assert!(!sum(Fixed::ZERO, &(most() + most()), &Fixed::ZERO, false));
    assert!(!((most() + most()) - (most() + most())).is_exact());
    assert!(!(power(32) * power(32)).is_exact());
    assert!((power(32) * power(31)).is_exact());
}

#[test]
fn numbers_lose_their_common_divisor() {
    let mut random = Random::new(6);
    for _ in 0..2000 {
        let mut one = || (random.bits() as i64 | 1) >> random.below(63);
        let [a, b, c, d] = [one(), one(), one(), one()].map(|x| Fixed::<6>::new(x, 0));
        let (of, more) = (&a * &b * &c, &b * &d);
        if more.sign() == 0 || of.sign() == 0 {
            continue;
        }
        let [p, q] = Integer::coprime([of.clone(), more.clone()]);
        assert_eq!((&p * &more - &q * &of).sign(), 0);
        assert!(p.bits() + b.bits() <= of.bits() + 2 && p.sign() == of.sign());
        let [r, s] = Integer::coprime([p.clone(), q.clone()]);
        assert!((r - p).sign() == 0 && (s - q).sign() == 0);
    }
}

#[test]
fn leading_bits_are_those_of_the_number() {
    let x = Fixed::<4>::new((1 << 53) - 1, 100);
    assert_eq!(x.leading(), ((1 << 53) - 1, false, 100));
    assert_eq!((x + Fixed::new(1, 0)).leading(), ((1 << 53) - 1, true, 100));
    assert_eq!(Fixed::<4>::new(5, 0).leading(), (5, false, 0));
    assert_eq!(Fixed::<4>::ZERO.leading(), (0, false, 0));
}
