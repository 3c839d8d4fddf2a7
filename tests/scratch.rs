use ccd::Options;
use std::time::Instant;
#[test]
fn scratch() {
    let dir = ccd_testkit::data::data_dir().unwrap();
    for path in [Some(ccd::gpu::Path::Wgsl)] { for narrow in [false, true] {
    let device = ccd::gpu::Device::open(&ccd::gpu::DeviceOptions { path, narrow, ..Default::default() }).unwrap();
    println!("{}", device.info());
    for (name, t0, t1) in [("cloth-funnel", "227", "228"), ] {
        let a = ccd::io::read_frame(&dir.join(format!("scenes/{name}/frames/{t0}.ply"))).unwrap();
        let b = ccd::io::read_frame(&dir.join(format!("scenes/{name}/frames/{t1}.ply"))).unwrap();
        let mesh = a.mesh().unwrap();
        let mut cpu = ccd::Session::new(mesh.clone(), Options::default()).unwrap();
        let mut gpu = ccd::gpu::Session::new(&device, mesh, Options::default()).unwrap();
        gpu.time_stages(true).unwrap();
        let want = cpu.step(&a.positions, &b.positions).unwrap().clone();
        for _ in 0..2 {
        let s = Instant::now();
        let got = gpu.step(&a.positions, &b.positions).unwrap();
        println!("{name} {:?} cand {:?} {:?} filt {:?} {:?} contacts {:?} {:?} undecided {} {} toi {:?} {:?}", s.elapsed(), want.candidates, got.candidates, want.filtered, got.filtered, want.n_contacts(), got.n_contacts(), want.undecided, got.undecided, want.toi, got.toi);
        let same = want.contacts.iter().zip(&got.contacts).filter(|(a, b)| a == b).count();
        println!("same {} of {}", same, want.contacts.len());
        println!("grown {} {:?}", gpu.grown(), gpu.stages());
        }
        let t = gpu.earliest_toi(&a.positions, &b.positions).unwrap();
        println!("earliest {:?} {:?} cand {:?}", t, cpu.earliest_toi(&a.positions, &b.positions).unwrap(), gpu.report().candidates);
        println!("{:?}", gpu.stages());
        let c = gpu.candidates(&a.positions, &b.positions).unwrap();
        println!("candidates {} {}", c.vf.len(), c.ee.len());
        println!("{:?}", gpu.stages());
    }}}
}
