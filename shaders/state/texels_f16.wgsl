// State in 16 bits, as the 2004 paper had it: eleven bits of every number of X and V, rounded whenever a pass ends. Only the `paper` schedule
// rounds after every step, as the paper did; the others round less often.

alias StateTexture = texture_storage_2d<rgba16float, write>;
