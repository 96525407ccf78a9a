// Numbers that hold in every precision.

const PI = 3.14159265358979323846;
