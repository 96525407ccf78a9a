// The camera's directions are those of an observer in curved spacetime: light K that it sees from a direction is linear in that. Four
// components, the place's and then the time's; v = dx/dτ for light that goes into the past.

struct Observer {
    // Of the scene's three directions.
    x: Real4,
    y: Real4,
    z: Real4,
    // −u.
    rest: Real4,
}

var<uniform> observer: Observer;

fn frame_velocity(x: Real3, d: Real3) -> Real3 {
    let k = observer.rest + d.x * observer.x + d.y * observer.y + d.z * observer.z;
    return k.xyz / -k.w;
}
