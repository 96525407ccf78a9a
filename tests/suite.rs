//! All integration tests, as one program: wgpu is linked once.

mod support;

mod accelerate;
mod accuracy;
mod cameras;
mod cli;
mod constants;
mod dispersion;
mod exactness;
mod fans;
mod filters;
mod furnaces;
mod gallery;
mod gloss;
mod groeller;
mod imports;
mod interiors;
mod lenses;
mod light_grids;
mod light_paths;
mod meshes;
mod methods;
mod occlusion;
mod oracle;
mod orders;
mod own_laws;
mod parametric;
mod paths;
mod pictures;
mod sampling;
mod schedules;
mod shaders;
mod sky_light;
mod structure;
mod tree;
mod written_media;
