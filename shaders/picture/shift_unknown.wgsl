// Nobody at the camera says what light's frequency is: its shift is 0.

var<private> seen_shift: Real;
