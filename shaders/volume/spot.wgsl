// A point of a path where matter may be.

struct Spot {
    // The position in the scene.
    x: Real3,
    // The radius and the polar angle in the coordinates of the law.
    r: Real,
    sine: Real,
    cosine: Real,
    // The coordinate time, and τ.
    time: Real,
    tau: Real,
    // dλ, or the length, per unit of the step.
    pace: Real,
    // The length per unit of the step, if there are media that absorb.
    length: Real,
    // The squared refractive index.
    index: Real,
    // The momentum K of light of frequency 1 at the camera, into the past, and its conserved parts K_t and K_φ.
    momentum: Real3,
    energy: Real,
    turning: Real,
    // 1, or the factor of frequencies to matter that does not fall, for an estimate higher above a horizon.
    higher: Real,
}
