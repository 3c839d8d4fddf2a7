//! Sequences of frames by schedulers with fronts: on every frame the candidates of a session that
//! begins where the step before ended are those of one that begins at the roots.

use crate::rows::schedulings;
use crate::scenes::Source;
use ccd::method::{Front, FrontOptions};
use ccd::scenes::{Sequence, cloth_on_ball, funnel, interpenetrating, n_body};
use ccd::{Digest, Mesh, Options, Session};
use ccd_testkit::data;
use ccd_testkit::is_whole;

/// Frames of a mesh.
pub struct Frames {
    mesh: Mesh,
    x: Vec<Vec<[f64; 3]>>,
}

fn generated(scene: &Sequence, n: usize) -> Frames {
    Frames { mesh: scene.mesh.clone(), x: (0..n).map(|i| scene.frame(i)).collect() }
}

/// Debris that falls against a wall, every second frame, but for the later half by default.
fn debris() -> Frames {
    let dir = data::data_dir().expect("the row is ignored without the data");
    let frame = |i: usize| {
        let path = dir.join(format!("scenes/debris-wall/frames/{i:03}.ply"));
        ccd::io::read_frame(&path).expect("a frame")
    };
    let mesh = frame(40).mesh().expect("a mesh");
    let end = if is_whole() { 100 } else { 70 };
    Frames { mesh, x: (40..end).step_by(2).map(|i| frame(i).positions).collect() }
}

/// A name, whether it needs the data, and frames.
type Named = (&'static str, bool, fn() -> Frames);

/// The sequences.
pub const SEQUENCES: [Named; 6] = [
    ("interpenetrating 64", false, || generated(&interpenetrating(64), 12)),
    ("interpenetrating 1024", false, || generated(&interpenetrating(1024), 12)),
    ("funnel", false, || generated(&funnel(32), 20)),
    ("cloth on a ball", false, || generated(&cloth_on_ball(30), 20)),
    ("bodies that bounce", false, || generated(&n_body(40, 9), 20)),
    ("debris-wall", true, debris),
];

/// Candidates of a step, of both kinds.
fn candidates(session: &mut Session, x: &[Vec<[f64; 3]>]) -> [Digest; 2] {
    let found = session.candidates(&x[0], &x[1]).expect("candidates");
    [Digest::of(0, found.vf.iter()), Digest::of(1, found.ee.iter())]
}

/// Every frame by a scheduler on blocks, and by others on binary trees of either volume; most of
/// the steps begin at a front.
pub fn check(frames: &Frames) -> Result<(), String> {
    let Frames { mesh, x } = frames;
    let options = Options::default().with_threads(2);
    let mut fresh = Session::new(mesh, options.clone()).expect("a session");
    let want: Vec<[Digest; 2]> = x.windows(2).map(|x| candidates(&mut fresh, x)).collect();
    let n_changed = want.windows(2).filter(|two| two[0] != two[1]).count();
    if n_changed < 3 {
        return Err(format!("{n_changed} frames differ from the one before: that shows little"));
    }
    let with_front = schedulings("crowded", Source::Boxes(Vec::new), "cpu", "cpu", false)
        .filter(|(_, scheduling)| scheduling.front != Front::Off);
    // Of three methods by all schedulers: every scheduler once, every method about as often.
    let with_front: Vec<_> = with_front.collect();
    let n = with_front.len() / 3;
    assert!(n > 5 && with_front.len() == 3 * n, "methods and schedulers with fronts");
    for k in (0..n).map(|s| n * (s % 3) + s) {
        let (method, scheduling) = with_front[k];
        // Given up now and then; in every other session never for having grown.
        let front = FrontOptions::default().rebuild(4, 101);
        let front = if k % 2 == 0 { front } else { front.growth(u32::MAX) };
        let scheduling = scheduling.front(Front::On(front));
        let options = options.clone().with_broad_phase(method).with_scheduling(scheduling);
        let mut session = Session::new(mesh, options).expect("a session");
        let mut n_begun = 0;
        for (i, (x, want)) in x.windows(2).zip(&want).enumerate() {
            if candidates(&mut session, x) != *want {
                return Err(format!("frame {i} by {method}, {scheduling}: other pairs"));
            }
            let front = session.step(&x[0], &x[1]).expect("a step").front.expect("fronts count");
            n_begun += (front.begun > 0) as usize;
            assert!(front.bytes <= 512 << 20, "{front:?}");
        }
        if 3 * n_begun < want.len() {
            return Err(format!("{n_begun} of {} steps began at a front: {method}", want.len()));
        }
    }
    Ok(())
}
