use ccd::*; use std::path::Path;
fn main(){
 for (name,a,b) in [("cloth-ball","cloth_ball92.ply","cloth_ball93.ply"),("rod-twist","3036.ply","3037.ply"),("cloth-funnel","227.ply","228.ply")] {
  let d=format!("../shared/data/scenes/{name}/frames/");
  let f0=io::read_frame(Path::new(&format!("{d}{a}"))).unwrap(); let f1=io::read_frame(Path::new(&format!("{d}{b}"))).unwrap();
  for th in [1,2] { for early in [false,true] {
   let mut s=Session::new(f0.mesh().unwrap(),Options{threads:th,..Default::default()}).unwrap();
   let mut best=Times{total:1e9,..Default::default()};
   for _ in 0..5 { if early { s.earliest_toi(&f0.positions,&f1.positions).unwrap(); } else { s.step(&f0.positions,&f1.positions).unwrap(); } if s.report().times.total<best.total {best=s.report().times} }
   let r=s.report();
   println!("{name} th {th} early {early} cand {:?} filt {:?} contacts {:?} und {} toi {:?} {:?}",r.candidates,r.filtered,r.n_contacts(),r.undecided,r.toi,best);
  }}
 }
}
