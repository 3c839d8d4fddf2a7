//! Groups of bodies, two words a body: whom it belongs to, and whom it looks at.

/// Groups of a body: those that it is a member of, and those whose members it is looked at against;
/// a bit a group, as rapier's interaction groups.
///
/// ```
/// use ccd::Groups;
///
/// // Bit 0: walls, bit 1: ghosts. A ghost goes through walls.
/// let wall = Groups { memberships: 0b01, ..Groups::ALL };
/// let ghost = Groups { memberships: 0b10, filter: !0b01 };
/// assert!(!ghost.meet(wall) && ghost.meet(ghost) && wall.meet(wall));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Groups {
    /// Groups that the body is a member of.
    pub memberships: u32,
    /// Groups with whose members it may touch.
    pub filter: u32,
}

impl Groups {
    /// A member of all, looked at against all: the default.
    pub const ALL: Self = Self { memberships: u32::MAX, filter: u32::MAX };
    /// A member of none, looked at against none.
    pub const NONE: Self = Self { memberships: 0, filter: 0 };

    /// Whether two bodies are looked at: either must have a group that the other filters for.
    pub const fn meet(self, other: Self) -> bool {
        self.memberships & other.filter != 0 && other.memberships & self.filter != 0
    }
}

impl Default for Groups {
    fn default() -> Self {
        Self::ALL
    }
}
