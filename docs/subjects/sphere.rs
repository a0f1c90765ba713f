// A program on trial: rustc -O docs/subjects/sphere.rs -o out/sphere
//                     ./rayproof check --subject-command out/sphere --shape sphere
use std::io::{stdin, BufRead};

/// Every t at which the line meets the sphere, ascending. Put your own code here.
fn sphere(origin: &[f64], direction: &[f64], center: &[f64], radius: f64) -> Vec<f64> {
    let dot = |p: &[f64], q: &[f64]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let l: Vec<f64> = (0..3).map(|i| origin[i] - center[i]).collect();
    let (a, b) = (dot(direction, direction), dot(&l, direction));
    let d = b * b - a * (dot(&l, &l) - radius * radius);
    if d < 0.0 { vec![] } else if d == 0.0 { vec![-b / a] } else { vec![(-b - d.sqrt()) / a, (-b + d.sqrt()) / a] }
}

/// What stands behind a name in a line of JSON: a list without its end, or a value.
fn text<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    let rest = line.split_once(&format!("\"{name}\":"))?.1.trim_start();
    rest.split(|c| if rest.starts_with('[') { c == ']' } else { c == ',' || c == '}' }).next()
}

fn answer(line: &str) -> Option<String> {
    let round = |x: f64| if line.contains("\"float32\"") { x as f32 as f64 } else { x };
    let number = |x: &str| x.trim_matches(&[' ', '[', '"'][..]).parse().ok().map(round);
    let of = |name| text(line, name)?.split(',').map(number).collect::<Option<Vec<f64>>>();
    let (o, d, from, to) = (of("origin")?, of("direction")?, of("t_min")?[0], of("t_max")?[0]);
    let hits = match text(line, "type")? {
        "\"sphere\"" if !line.contains("\"transform\"") => sphere(&o, &d, &of("center")?, of("radius")?[0]),
        _ => return None, // more shapes: their names in docs/case-format.md
    };
    let counted = hits.iter().filter(|t| from <= **t && **t <= to);
    let list: Vec<String> = counted.map(|t| format!("{{\"t\": {t:e}}}")).collect();
    Some(format!("\"verdict\": \"{}\", \"hits\": [{}]", if list.is_empty() { "miss" } else { "hit" }, list.join(", ")))
}

fn main() {
    for line in stdin().lock().lines().map(Result::unwrap) {
        let said = answer(&line).unwrap_or("\"unsupported\": true".into());
        println!("{{\"id\": {}, {said}}}", text(&line, "id").unwrap_or("null"));
    }
}
