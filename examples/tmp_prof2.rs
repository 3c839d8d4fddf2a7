use ccd::*; use std::path::Path;
fn main(){
  let d="../shared/data/scenes/cloth-ball/frames/";
  let f0=io::read_frame(Path::new(&format!("{d}cloth_ball92.ply"))).unwrap(); let f1=io::read_frame(Path::new(&format!("{d}cloth_ball93.ply"))).unwrap();
  let m=f0.mesh().unwrap();
  let vb:Vec<Aabb<f32>>=f0.positions.iter().zip(&f1.positions).map(|(p,q)|Aabb::of_point(*p).union(&Aabb::of_point(*q)).round_out()).collect();
  let eb:Vec<_>=m.edges().iter().map(|e|vb[e[0] as usize].union(&vb[e[1] as usize])).collect();
  let mut bp=BroadPhase::new(1,Method::Blocks).unwrap();
  for _ in 0..60 { bp.self_pairs(&eb).unwrap(); }
}
