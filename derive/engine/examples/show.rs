fn main() {
    let file = std::env::args().nth(1).unwrap();
    let only = std::env::args().nth(2);
    for item in syn::parse_file(&std::fs::read_to_string(&file).unwrap()).unwrap().items {
        let syn::Item::Struct(item) = item else { continue };
        if only.as_ref().is_some_and(|o| item.ident != o) {
            continue;
        }
        let clock = std::time::Instant::now();
        let r = holonomy_engine::analyse(quote::quote!(#item));
        println!("=== {} {:.3} s", item.ident, clock.elapsed().as_secs_f64());
        holonomy_engine::expand(quote::quote!(#item));
        match r {
            Err(d) => {
                for e in d.iter() {
                    println!("  {:?}: {}", e.place.start.start(), e.message)
                }
            }
            Ok(a) => {
                let e = &a.equations;
                let g = &e.graph;
                let show = |n: &str, v: &[holonomy_engine::symbolic::Expr]| {
                    println!(" {n} [{:?}]", holonomy_engine::simplify::cost(g, v));
                    for t in g.display_all(v) {
                        println!("    {t}")
                    }
                };
                show("M_d", e.mass_matrix.entries());
                show("h_u", &e.forcing);
                show("udot", &e.accelerations);
                show("qdot", &e.coordinate_rates);
                show("lambda", &e.multipliers);
                for gd in e.guards.iter().chain(&e.parameter_guards) {
                    println!(" guard {} {:?} {}", gd.name, gd.kind, gd.origin)
                }
                for n in &e.notes {
                    println!(" note {n}")
                }
                let mut all = e.accelerations.clone();
                all.extend(&e.coordinate_rates);
                println!(" derivative {:?}", holonomy_engine::simplify::cost(g, &all));
            }
        }
    }
}
