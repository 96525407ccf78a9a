// State in 32 bits.

alias StateTexture = texture_storage_2d<rgba32float, write>;
