//! The lists of a frame, or something for each of them, by name.

use std::convert::Infallible;

/// One `T` for each list; pairs of them are by kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lists<T> {
    /// Candidates.
    pub candidates: [T; 2],
    /// Pairs that the filters leave.
    pub survivors: [T; 2],
    /// Pairs that integers leave to `f32`.
    pub left: [T; 2],
    /// Pairs that the device leaves open.
    pub undecided: [T; 2],
    /// Contacts.
    pub contacts: T,
    /// Those of the source of pairs.
    pub source: Vec<T>,
}

impl<T> Lists<T> {
    /// Something else for each list, or the first error.
    pub fn try_map<U, E>(self, mut f: impl FnMut(T) -> Result<U, E>) -> Result<Lists<U>, E> {
        let mut two = |[a, b]: [T; 2]| Ok([f(a)?, f(b)?]);
        let (candidates, survivors) = (two(self.candidates)?, two(self.survivors)?);
        let (left, undecided) = (two(self.left)?, two(self.undecided)?);
        let contacts = f(self.contacts)?;
        let source = self.source.into_iter().map(&mut f).collect::<Result<Vec<U>, E>>()?;
        Ok(Lists { candidates, survivors, left, undecided, contacts, source })
    }

    /// Something else for each list.
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Lists<U> {
        let Ok(lists) = self.try_map(|list| Ok::<U, Infallible>(f(list)));
        lists
    }

    /// Both for each list. Both have as many of the source.
    pub fn zip<U>(self, other: Lists<U>) -> Lists<(T, U)> {
        let two = |[a, b]: [T; 2], [c, d]: [U; 2]| [(a, c), (b, d)];
        Lists {
            candidates: two(self.candidates, other.candidates),
            survivors: two(self.survivors, other.survivors),
            left: two(self.left, other.left),
            undecided: two(self.undecided, other.undecided),
            contacts: (self.contacts, other.contacts),
            source: self.source.into_iter().zip(other.source).collect(),
        }
    }

    /// All of them, without their names.
    pub fn into_vec(self) -> Vec<T> {
        let mut out = Vec::new();
        self.map(|list| out.push(list));
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lists() -> Lists<u32> {
        let (candidates, survivors, left, undecided) = ([1, 2], [3, 4], [5, 6], [7, 8]);
        Lists { candidates, survivors, left, undecided, contacts: 9, source: vec![10, 11, 12] }
    }

    #[test]
    fn each_list_keeps_its_name() {
        assert_eq!(lists().map(|i| i), lists());
        assert_eq!(lists().into_vec(), (1..=12).collect::<Vec<_>>());
        let both = lists().zip(lists().map(|i| 10 * i)).into_vec();
        assert!(both.iter().all(|(a, b)| 10 * a == *b) && both.len() == 12);
        assert_eq!(lists().try_map(|i| if i < 7 { Ok(i) } else { Err(i) }), Err(7));
    }
}
