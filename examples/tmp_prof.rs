use ccd::*; use std::path::Path;
fn main(){
  let a:Vec<String>=std::env::args().collect();
  let (n0,n1,sc)=if a[1]=="ball" {("cloth_ball92.ply","cloth_ball93.ply","cloth-ball")} else {("3036.ply","3037.ply","rod-twist")};
  let d=format!("../shared/data/scenes/{sc}/frames/");
  let f0=io::read_frame(Path::new(&format!("{d}{n0}"))).unwrap(); let f1=io::read_frame(Path::new(&format!("{d}{n1}"))).unwrap();
  let mut s=Session::new(f0.mesh().unwrap(),Options{threads:1,..Default::default()}).unwrap();
  for _ in 0..10 { if a[2]=="early" { s.earliest_toi(&f0.positions,&f1.positions).unwrap(); } else { s.step(&f0.positions,&f1.positions).unwrap(); } println!("{:?}",s.report().times); }
}
