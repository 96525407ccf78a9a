// Stores the state of every pixel's ray between passes in textures, as Weiskopf et al. (2004) do (W04 §3.1): X = (x, τ), V = (v, h) and, if
// any of it is needed, W = (ṫ, the last step's error, the rounding error of τ, ln k). Each has slots that ping-pong. Passes address a slot
// by its role, as the start or end of a segment (without W), or by its number. W always has 32 bits; X and V may have 16, as in W04: eleven
// significant bits, rounded at the end of every pass. Only the `paper` schedule rounds after every step, as W04 does.

var x_in: texture_2d<f32>;
var v_in: texture_2d<f32>;
var x_start: texture_2d<f32>;
var v_start: texture_2d<f32>;
var x_end: texture_2d<f32>;
var v_end: texture_2d<f32>;
var x_0: texture_2d<f32>;
var v_0: texture_2d<f32>;
var x_1: texture_2d<f32>;
var v_1: texture_2d<f32>;
var x_2: texture_2d<f32>;
var v_2: texture_2d<f32>;
var x_out: StateTexture;
var v_out: StateTexture;
var w_in: texture_2d<f32>;
var w_0: texture_2d<f32>;
var w_1: texture_2d<f32>;
var w_2: texture_2d<f32>;
var w_out: texture_storage_2d<rgba32float, write>;

fn load_state(pixel: vec2u) -> State {
    if KEEPS_W {
        return State(textureLoad(x_in, pixel, 0), textureLoad(v_in, pixel, 0), textureLoad(w_in, pixel, 0));
    }
    return State(textureLoad(x_in, pixel, 0), textureLoad(v_in, pixel, 0), vec4<Real>(0.0));
}

fn start_state(pixel: vec2u) -> State {
    return State(textureLoad(x_start, pixel, 0), textureLoad(v_start, pixel, 0), vec4<Real>(0.0));
}

fn end_state(pixel: vec2u) -> State {
    return State(textureLoad(x_end, pixel, 0), textureLoad(v_end, pixel, 0), vec4<Real>(0.0));
}

fn state_at_0(pixel: vec2u) -> State {
    if KEEPS_W {
        return State(textureLoad(x_0, pixel, 0), textureLoad(v_0, pixel, 0), textureLoad(w_0, pixel, 0));
    }
    return State(textureLoad(x_0, pixel, 0), textureLoad(v_0, pixel, 0), vec4<Real>(0.0));
}

fn state_at_1(pixel: vec2u) -> State {
    if KEEPS_W {
        return State(textureLoad(x_1, pixel, 0), textureLoad(v_1, pixel, 0), textureLoad(w_1, pixel, 0));
    }
    return State(textureLoad(x_1, pixel, 0), textureLoad(v_1, pixel, 0), vec4<Real>(0.0));
}

fn state_at_2(pixel: vec2u) -> State {
    if KEEPS_W {
        return State(textureLoad(x_2, pixel, 0), textureLoad(v_2, pixel, 0), textureLoad(w_2, pixel, 0));
    }
    return State(textureLoad(x_2, pixel, 0), textureLoad(v_2, pixel, 0), vec4<Real>(0.0));
}

fn put_state(pixel: vec2u, state: State) {
    textureStore(x_out, pixel, state[0]);
    textureStore(v_out, pixel, state[1]);
    if KEEPS_W {
        textureStore(w_out, pixel, state[2]);
    }
}
