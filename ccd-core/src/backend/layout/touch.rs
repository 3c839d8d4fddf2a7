//! Contacts as a device writes them, and what it says of their geometry.

use bytemuck::{Pod, Zeroable};

/// A contact as a device writes it.
///
/// | field | bytes |
/// |---|---|
/// | `kind` | 0..4 |
/// | `state` | 4..8 |
/// | `a` | 8..12 |
/// | `b` | 12..16 |
/// | `toi` | 16..24 |
/// | `approach` | 24..28 |
///
/// ```
/// use ccd::{Contact, Kind};
/// use ccd_core::records::{Touch, split};
///
/// let touch = Touch { a: 3, b: 7, toi: split(0.25), ..Touch::default() };
/// let contact = Contact::from(&touch);
/// assert_eq!((contact.kind, contact.toi), (Kind::VertexFace, 0.25));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Touch {
    /// 0: vertex-face, 1: edge-edge.
    pub kind: u32,
    /// 0: certain, 1: undecided.
    pub state: u32,
    /// The vertex, or the lesser edge.
    pub a: u32,
    /// The face, or the greater edge.
    pub b: u32,
    /// Time of impact: the bits of an `f64`, low word first.
    pub toi: [u32; 2],
    /// The word of [`Approach`](crate::narrow_phase::approach::Approach).
    pub approach: u32,
}

/// A [`Touch`] in sixteen bytes, as a device hands it back in order: ids are below 2^31, and a time
/// from 0 to 1 leaves the two highest bits of its `f64` free.
///
/// | field | bytes | highest bits |
/// |---|---|---|
/// | `a` | 0..4 | kind |
/// | `b` | 4..8 | state |
/// | `toi` | 8..16 | approach, two |
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct PackedTouch {
    /// The words.
    pub words: [u32; 4],
}

/// What a time from 0 to 1 has of the upper word of its `f64`.
const TIME: u32 = u32::MAX >> 2;

impl PackedTouch {
    /// What an id has of a word.
    pub const ID: u32 = u32::MAX >> 1;

    /// Of the contact of these words.
    #[inline(always)]
    pub fn new([kind, state, a, b, low, high, approach]: [u32; TOUCH_WORDS]) -> Self {
        // Of a time of -0 it takes the sign.
        let high = high & TIME | approach << 30;
        Self { words: [a | kind << 31, b | state << 31, low, high] }
    }

    /// The contact.
    #[inline(always)]
    pub fn touch(&self) -> Touch {
        let [a, b, low, high] = self.words;
        Touch {
            kind: a >> 31,
            state: b >> 31,
            a: a & Self::ID,
            b: b & Self::ID,
            toi: [low, high & TIME],
            approach: high >> 30,
        }
    }
}

/// How a contact of a device's list meets at its time of impact, as
/// [`ContactGeometry`](crate::narrow_phase::contact_geometry::ContactGeometry) says; all in `f32`.
///
/// | field | bytes |
/// |---|---|
/// | `point` | 0..12 |
/// | `distance` | 12..16 |
/// | `normal` | 16..28 |
/// | `state` | 28..32 |
/// | `weights` | 32..48 |
/// | `vertices` | 48..64 |
///
/// ```
/// use ccd_core::records::TouchGeometry;
///
/// /// How fast `a`, a vertex, moves against `b`, a face, along the normal.
/// fn along(at: &TouchGeometry, velocity: impl Fn(u32) -> [f32; 3]) -> f32 {
///     let part = |i: usize| if i == 0 { at.weights[i] } else { -at.weights[i] };
///     let dot = |u: [f32; 3]| (0..3).map(|k| at.normal[k] * u[k]).sum::<f32>();
///     (0..4).map(|i| part(i) * dot(velocity(at.vertices[i]))).sum()
/// }
/// let (normal, weights, vertices) = ([0.0, 1.0, 0.0], [1.0, 0.5, 0.25, 0.25], [3, 0, 1, 2]);
/// let at = TouchGeometry { normal, weights, vertices, ..TouchGeometry::default() };
/// assert_eq!(along(&at, |v| [0.0, if v == 3 { -2.0 } else { 0.0 }, 0.0]), -2.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct TouchGeometry {
    /// Halfway between the two nearest points, which are half of the distance along the normal from
    /// it: that of `a` forward, that of `b` backward.
    pub point: [f32; 3],
    /// Between those points.
    pub distance: f32,
    /// Unit vector from `b` towards `a`.
    pub normal: [f32; 3],
    /// Of the contact, 0: certain, 1: undecided.
    pub state: u32,
    /// Of the vertices.
    pub weights: [f32; 4],
    /// `v f0 f1 f2` or `ea0 ea1 eb0 eb1`.
    pub vertices: [u32; 4],
}

/// Words of a [`Touch`].
pub const TOUCH_WORDS: usize = size_of::<Touch>() / 4;

const _: () = assert!(size_of::<Touch>() == 28 && size_of::<PackedTouch>() == 16);
const _: () = assert!(size_of::<TouchGeometry>() == 64);
