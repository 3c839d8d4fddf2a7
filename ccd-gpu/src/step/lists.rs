//! The lists of a frame, or something for each of them, by name.

use std::convert::Infallible;

/// One `T` for each list; those of candidates are by kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lists<T> {
    /// Candidates.
    pub candidates: [T; 2],
    /// Pairs that the filters leave.
    pub survivors: T,
    /// Pairs that the first of two decisions leaves to the second.
    pub left: T,
    /// Contacts.
    pub contacts: T,
    /// Those of the source of pairs.
    pub source: Vec<T>,
}

impl<T> Lists<T> {
    /// Something else for each list, or the first error.
    pub fn try_map<U, E>(self, mut f: impl FnMut(T) -> Result<U, E>) -> Result<Lists<U>, E> {
        let [vf, ee] = self.candidates;
        let (candidates, survivors) = ([f(vf)?, f(ee)?], f(self.survivors)?);
        let (left, contacts) = (f(self.left)?, f(self.contacts)?);
        let source = self.source.into_iter().map(&mut f).collect::<Result<Vec<U>, E>>()?;
        Ok(Lists { candidates, survivors, left, contacts, source })
    }

    /// Something else for each list.
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Lists<U> {
        let Ok(lists) = self.try_map(|list| Ok::<U, Infallible>(f(list)));
        lists
    }

    /// Both for each list. Both have as many of the source.
    pub fn zip<U>(self, other: Lists<U>) -> Lists<(T, U)> {
        let ([a, b], [c, d]) = (self.candidates, other.candidates);
        Lists {
            candidates: [(a, c), (b, d)],
            survivors: (self.survivors, other.survivors),
            left: (self.left, other.left),
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
        let (candidates, source) = ([1, 2], vec![6, 7, 8]);
        Lists { candidates, survivors: 3, left: 4, contacts: 5, source }
    }

    #[test]
    fn each_list_keeps_its_name() {
        assert_eq!(lists().map(|i| i), lists());
        assert_eq!(lists().into_vec(), (1..=8).collect::<Vec<_>>());
        let both = lists().zip(lists().map(|i| 10 * i)).into_vec();
        assert!(both.iter().all(|(a, b)| 10 * a == *b) && both.len() == 8);
        assert_eq!(lists().try_map(|i| if i < 5 { Ok(i) } else { Err(i) }), Err(5));
    }
}
