// Converts directions in the frame of an observer in curved spacetime to velocities: the momentum K of the light that the observer sees is
// linear in the direction. Vectors have four components, space first and then time; v = dx/dτ for light that travels into the past.

struct Observer {
    // The images of the scene's three directions.
    x: Real4,
    y: Real4,
    z: Real4,
    // −u, where u is the observer's four-velocity.
    rest: Real4,
}

var<uniform> observer: Observer;

fn frame_velocity(x: Real3, d: Real3) -> Real3 {
    let k = observer.rest + d.x * observer.x + d.y * observer.y + d.z * observer.z;
    return k.xyz / -k.w;
}
