use ccd::Options;
use ccd::gpu::{Device, DeviceOptions, Path, Session, BroadPhase, Sorter};
use std::time::Instant;
use std::collections::BTreeMap;
fn med(v: &mut Vec<f64>) -> f64 { v.sort_by(f64::total_cmp); v[v.len() / 2] }
fn add(m: &mut Vec<(String, Vec<f64>)>, s: &[(&'static str, f64)]) {
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    for (n, t) in s { let k = seen.entry(n).or_default(); *k += 1; let key = format!("{n}#{k}");
        match m.iter_mut().find(|x| x.0 == key) { Some(x) => x.1.push(*t), None => m.push((key, vec![*t])) } }
}
fn show(m: &mut Vec<(String, Vec<f64>)>) { let mut sum = 0.0; for (n, v) in m { let t = med(v); sum += t; print!(" {n} {t:.4}"); } println!(" | sum {sum:.4}"); }
#[test]
fn scratch() {
    let dir = ccd_testkit::data::data_dir().unwrap();
    let reps: usize = std::env::var("REPS").ok().and_then(|v| v.parse().ok()).unwrap_or(1);
    for path in [Some(Path::Passthrough)] { for narrow in [true, false] {
    let device = Device::open(&DeviceOptions { path, narrow, ..Default::default() }).unwrap();
    println!("{}", device.info());
    for (name, t0, t1) in [("cloth-funnel", "227", "228"), ] {
        let f = |t: &str| ccd::io::read_frame(&dir.join(format!("scenes/{name}/frames/{t}.ply")));
        let (Ok(a), Ok(b)) = (f(t0), f(t1)) else { println!("no {name}"); continue };
        let mesh = a.mesh().unwrap();
        let mut cpu = ccd::Session::new(mesh.clone(), Options::default()).unwrap();
        let mut gpu = Session::new(&device, mesh, Options::default()).unwrap();
        let want = cpu.step(&a.positions, &b.positions).unwrap().clone();
        for timed in [false, true] {
        gpu.time_stages(timed).unwrap();
        let s = Instant::now(); gpu.step(&a.positions, &b.positions).unwrap(); let first = s.elapsed();
        let mut wall = vec![]; let mut st = vec![];
        for _ in 0..reps { let s = Instant::now(); gpu.step(&a.positions, &b.positions).unwrap(); wall.push(s.elapsed().as_secs_f64()*1e3); add(&mut st, gpu.stages()); }
        let got = gpu.report();
        let same = want.contacts.iter().zip(&got.contacts).filter(|(a, b)| a == b).count();
        println!("{name} step first {first:?} wall {:.3} upload {:.3} cand {:?} filt {:?} contacts {:?} same {same} of {} grown {}", med(&mut wall), got.times.boxes, got.candidates == want.candidates, got.filtered, got.n_contacts(), want.contacts.len(), gpu.grown());
        show(&mut st);
        let mut wall = vec![]; let mut st = vec![]; let mut toi = None;
        for _ in 0..=reps { let s = Instant::now(); toi = gpu.earliest_toi(&a.positions, &b.positions).unwrap(); wall.push(s.elapsed().as_secs_f64()*1e3); add(&mut st, gpu.stages()); }
        println!("{name} earliest wall {:.3} {toi:?} want {:?} cand {:?}", med(&mut wall), want.toi, gpu.report().candidates);
        show(&mut st);
        let mut wall = vec![]; let mut st = vec![]; let mut n = (0,0);
        for _ in 0..=reps { let s = Instant::now(); let c = gpu.candidates(&a.positions, &b.positions).unwrap(); n = (c.vf.len(), c.ee.len()); wall.push(s.elapsed().as_secs_f64()*1e3); add(&mut st, gpu.stages()); }
        println!("{name} candidates wall {:.3} {n:?} grown {}", med(&mut wall), gpu.grown());
        show(&mut st);
        }
    }
    if narrow { continue }
    for n in [100_000, 1_000_000, 10_000_000usize] {
        if n > 100_000 && reps < 3 { continue }
        let boxes = ccd_testkit::generate::uniform_boxes(n);
        let mut bp = BroadPhase::new(&device).unwrap(); bp.time_stages(true).unwrap();
        let mut st = vec![]; let mut k = 0;
        for _ in 0..=reps { k = bp.self_pairs_on_device(&boxes).unwrap().0; add(&mut st, bp.stages()); }
        println!("uniform {n} pairs {k}"); show(&mut st);
        let mut x = 1u32; let keys: Vec<u32> = (0..n).map(|_| { x ^= x << 13; x ^= x >> 17; x ^= x << 5; x }).collect();
        let values: Vec<u32> = (0..n as u32).collect();
        let mut s = Sorter::new(&device, n as u32).unwrap(); let mut ms = vec![];
        let mut out = (vec![], vec![], 0.0);
        for _ in 0..=reps { out = s.sort(&keys, &values).unwrap(); ms.push(out.2); }
        let mut w: Vec<(u32, u32)> = keys.iter().copied().zip(values).collect(); w.sort();
        let ok = w.iter().zip(out.0.iter().zip(&out.1)).all(|(a, b)| a.0 == *b.0 && a.1 == *b.1);
        let t = med(&mut ms); println!("sort {n} {t:.4} ms {:.2} Gpairs/s ok {ok}", n as f64 / t / 1e6);
    }
    }}
}
