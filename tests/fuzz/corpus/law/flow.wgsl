fn flow_field(x: Real3) -> Real3 {
    var sum = Real3(x.y, -x.x, 0.5);
    for (var i = 0u; i < 8u; i++) {
        sum += sin(0.1 * Real(i)) * x;
    }
    return sum;
}
