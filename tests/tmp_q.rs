use ccd::*; use ccd::io::*;
use std::path::*;
#[test] fn q(){
  let root=Path::new("../shared/data/queries/sample-queries");
  let (mut hit,mut und_t,mut und_f,mut miss,mut fneg,mut fpos,mut late,mut early,mut n)=(0,0,0,0,0,0,0,0,0);
  let mut t=0u128;
  for d in std::fs::read_dir(root).unwrap() { let d=d.unwrap().path(); if !d.is_dir(){continue}
   for k in ["vertex-face","edge-edge"] { for f in ["data_0_0.csv","data_0_1.csv"] { let p=d.join(k).join(f); if !p.exists(){continue}
    let q=read_queries(&p).unwrap();
    let toi=std::fs::read_to_string(format!("../shared/data/toi/{}_{}_{}",d.file_name().unwrap().to_str().unwrap(),k,f)).unwrap();
    for ((q,&a),row) in q.queries.iter().zip(&q.answers).zip(toi.lines().skip(1)) {
      let r:Vec<&str>=row.split(',').collect(); n+=1;
      let s=std::time::Instant::now();
      let v=match q {Query::VertexFace(q)=>vertex_face(q,0.0),Query::EdgeEdge(q)=>edge_edge(q,0.0)};
      t+=s.elapsed().as_nanos();
      match v { Verdict::Miss=> if a {fneg+=1; println!("MISS {p:?} {row}")} else {miss+=1},
       Verdict::Hit{..}=> if a {hit+=1} else {fpos+=1; println!("FPOS {p:?} {row} {v:?}")},
       Verdict::Undecided{..}=> if a {und_t+=1} else {und_f+=1}}
      if a { let lo:f64=r[3].parse().unwrap(); if let Some(x)=v.toi(){ if x>lo {late+=1; println!("LATE {p:?} {row} {v:?}")} if matches!(v,Verdict::Hit{..}) && x<lo-1e-6 {early+=1; println!("EARLY {p:?} {row} {v:?}")} } }
    }}}}
  println!("n {n} hit {hit} und_true {und_t} und_false {und_f} miss {miss} fneg {fneg} fpos {fpos} late {late} early {early} ns {}",t/n);
}
