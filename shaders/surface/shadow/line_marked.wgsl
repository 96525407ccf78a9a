// Paths are in pieces that go on beyond their ends; a line to a light does not.

// True while one is followed.
var<private> along_light: bool;

fn mark_line(begins: bool) {
    along_light = begins;
}
