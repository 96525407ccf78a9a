// Rays that move further in where the line element says that they end are captured.

fn law_captured(x: Real3, v: Real3) -> bool {
    let gap = metric_gap(metric_place(x));
    return gap.w < 0.0 && dot(gap.xyz, v) < 0.0;
}

fn inside_capture(x: Real3) -> bool {
    return metric_gap(metric_place(x)).w < 0.0;
}

fn captured_within() -> Real {
    return 0.0;
}

fn capture_gap(x: Real3) -> Real4 {
    let gap = metric_gap(metric_place(x));
    let steep = length(gap.xyz);
    return Real4(gap.xyz / steep, gap.w / steep);
}
