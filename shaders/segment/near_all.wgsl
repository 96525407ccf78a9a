// Nothing is ruled out: every segment is held against everything (the crossbar of W04 §5.4).

fn items_near(s: Segment) -> u32 {
    return 0xffffffffu;
}
