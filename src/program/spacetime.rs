//! A line element as WGSL: the metric and its deflection of light.

use std::fmt::Write as _;

use super::formula::body;
use super::generated::unit;
use super::unit::Unit;
use crate::scene::{Id, LineElement};

/// Generates `metric_at(q, t)` and `metric_bend(q, v, t)`, `metric_scale(q, t)` and, if the element ends rays or has a lapse, `metric_gap(q)`
/// and `metric_lapse(q)`.
pub(super) fn line_element(element: &LineElement) -> Unit {
    const NAMES: [&str; 9] = ["q.x", "q.y", "q.z", "v.x", "v.y", "v.z", "dt", "t", "metric_side"];
    let (graph, metric, force, scale, gap) = element.graph();
    let join =
        |values: &[String], order: &[usize]| order.iter().map(|k| values[*k].clone()).collect::<Vec<_>>().join(", ");
    let whole = |values: &[String]| {
        let [own, mixed, shift] = [[0, 3, 5], [4, 2, 1], [6, 7, 8]].map(|order| join(values, &order));
        format!("Metric(Real3({own}), Real3({mixed}), Real3({shift}), {})", values[9])
    };
    let (lines, at) = body(graph, &metric, &NAMES);
    let mut text = format!(
        "// {}\nfn metric_at(q: Real3, t: Real) -> Metric {{\n{lines}    return {};\n}}\n\n",
        element.written().line_element,
        whole(&at)
    );
    let all: Vec<Id> = metric.into_iter().chain(force).collect();
    let (lines, bend) = body(graph, &all, &NAMES);
    let _ = writeln!(
        text,
        "fn metric_bend(q: Real3, v: Real3, t: Real) -> MetricBend {{\n    let dt: Real = -1.0;\n{lines}    \
         return MetricBend({}, Real3({}), {});\n}}\n",
        whole(&bend),
        join(&bend, &[10, 11, 12]),
        bend[13]
    );
    let (lines, scale) = body(graph, &[scale], &NAMES);
    let _ = writeln!(text, "fn metric_scale(q: Real3, t: Real) -> Real {{\n{lines}    return {};\n}}", scale.join(""));
    for (name, value) in [("gap", gap), ("lapse", element.lapse())] {
        if let Some(value) = value {
            let (lines, value) = body(graph, &value, &NAMES);
            let value = value.join(", ");
            let _ = writeln!(text, "\nfn metric_{name}(q: Real3) -> Real4 {{\n{lines}    return Real4({value});\n}}");
        }
    }
    unit("generated/line_element.wgsl", text)
}
