use ccd::*; use std::time::Instant; use std::path::Path;
fn main(){
 for (name,a,b) in [("cloth-ball","cloth_ball92.ply","cloth_ball93.ply"),("rod-twist","3036.ply","3037.ply"),("cloth-funnel","227.ply","228.ply")] {
  let d=format!("../shared/data/scenes/{name}/frames/");
  let f0=io::read_frame(Path::new(&format!("{d}{a}"))).unwrap(); let f1=io::read_frame(Path::new(&format!("{d}{b}"))).unwrap();
  let m=f0.mesh().unwrap();
  let vb:Vec<Aabb<f32>>=f0.positions.iter().zip(&f1.positions).map(|(p,q)|Aabb::of_point(*p).union(&Aabb::of_point(*q)).round_out()).collect();
  let eb:Vec<_>=m.edges().iter().map(|e|vb[e[0] as usize].union(&vb[e[1] as usize])).collect();
  let fb:Vec<_>=m.faces().iter().map(|e|vb[e[0] as usize].union(&vb[e[1] as usize]).union(&vb[e[2] as usize])).collect();
  for th in [1,2] { for me in [Method::Blocks,Method::Tree] { let mut bp=BroadPhase::new(th,me).unwrap();
   let mut best=[1e9;3]; let mut n=[0;3];
   for _ in 0..7 { let t=Instant::now(); n[0]=bp.self_pairs(&eb).unwrap().len(); best[0]=t.elapsed().as_secs_f64().min(best[0]*1e-3)*1e3;
     let t=Instant::now(); n[1]=bp.self_pairs(&fb).unwrap().len(); best[1]=t.elapsed().as_secs_f64().min(best[1]*1e-3)*1e3;
     let t=Instant::now(); n[2]=bp.pairs(&vb,&fb).unwrap().len(); best[2]=t.elapsed().as_secs_f64().min(best[2]*1e-3)*1e3; }
   println!("{name} {th} {me:?} edges {} {:.2} ms faces {} {:.2} vf {} {:.2}",n[0],best[0],n[1],best[1],n[2],best[2]); }}
 }
}
